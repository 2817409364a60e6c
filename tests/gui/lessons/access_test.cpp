// The window while an instructor has locked the library: what trainees try there, what a plugin gets through the door, and an examination
// worked through to its end.
#include <QAction>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QTimer>
#include <QUrl>
#include <nlohmann/json.hpp>

#include "ew/library/access.h"
#include "ew/library/sealed_answers.h"
#include "ew/library/step_answer.h"
#include "ew/sdk/case_parts.h"
#include "ew/ui_test_door/plugins.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/taught_case.h"

namespace ew::ui::testing {
namespace {

constexpr PassphraseCost kCheap{.passes = 1, .memory_bytes = 64 << 10};
const QString kWords = QStringLiteral("correct horse battery");

}  // namespace

class AccessTest final : public LearnerFixture {
  Q_OBJECT

 private:
  QString folder_;

  void lock() const {
    AccessPolicy policy = AccessPolicy::of(libraryFolder());
    QVERIFY(setLock(policy, Passphrase(kWords.toStdString()), {}, kCheap));
  }
  void showLocked() {
    lock();
    makeWindow();
  }
  [[nodiscard]] QAction* action(const char* name) const { return window_->findChild<QAction*>(QLatin1String(name)); }
  [[nodiscard]] QAction* withKeys(const QKeySequence& keys) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->shortcuts().contains(keys)) return each;
    return nullptr;
  }
  [[nodiscard]] bool isExploring() const { return !button("workspaceAuthor")->isVisible() && button("workspaceExplore")->isChecked(); }
  [[nodiscard]] QPushButton* button(const char* name) const { return window_->findChild<QPushButton*>(QLatin1String(name)); }
  [[nodiscard]] sdk::Host& host() const { return *window_->findChild<WorkstationHost*>(); }
  /// Types into the dialog that opens next and presses its button.
  void answerDialog(const QStringList& words) const {
    QTimer::singleShot(0, window_.get(), [words] {
      auto* dialog = QApplication::activeModalWidget();
      if (dialog == nullptr) return;
      const QStringList names = {QStringLiteral("passphrase"), QStringLiteral("passphraseAgain")};
      for (int n = 0; n < words.size(); ++n) dialog->findChild<QLineEdit*>(names[n])->setText(words[n]);
      keepScreenshot(*dialog, words.size() > 1 ? "access-lock" : "access-unlock");
      dialog->findChild<QPushButton*>(QStringLiteral("accept"))->click();
      if (dialog->isVisible()) static_cast<QDialog*>(dialog)->reject();
    });
  }
  /// Every text that a person can see in the window.
  /// Lines of it that hold an answer.
  [[nodiscard]] QString answersInSight() const {
    QStringList found;
    for (const QString& line : allTexts().split(QLatin1Char('\n')))
      if (line.contains(QLatin1String("SECRET"))) found << line;
    return found.join(QLatin1Char('\n'));
  }
  [[nodiscard]] QString allTexts() const {
    QString all = window_->windowTitle();
    for (const QWidget* each : window_->findChildren<QWidget*>()) {
      if (!each->isVisible()) continue;
      all += each->toolTip() + each->accessibleName() + each->accessibleDescription() + QLatin1Char('\n');
      if (const auto* label = qobject_cast<const QLabel*>(each)) all += label->text() + QLatin1Char('\n');
      if (const auto* text = qobject_cast<const QAbstractButton*>(each)) all += text->text() + QLatin1Char('\n');
    }
    return all;
  }

 private Q_SLOTS:
  void init() {
    QFile::remove(QString::fromStdString(accessFile(libraryFolder()).string()));
    folder_ = files_.writeCase(QStringLiteral("own cases/taught"));
    QVERIFY(teach(folder_, "taught", "SECRETTITLE of a ball", threeLessons()));
    auto opened = loadCaseAside(folder_.toStdString());
    QVERIFY(opened);
    opened->titleForTrainees = "A ball for you";
    opened->diagnosis = "SECRETDIAGNOSIS";
    opened->findings = {"SECRETFINDING"};
    CaseTarget target;
    target.kind = CaseTarget::Kind::point;
    target.name = "SECRETTARGET";
    target.at_mm = glm::dvec3(0.0);
    opened->targets = {target};
    QVERIFY(saveCase(*opened, folder_.toStdString()));
  }
  void cleanup() { window_.reset(); }

  void authorIsNotThereAndItsKeyDoesNothing() {
    showLocked();
    QVERIFY(openCase(folder_));
    QVERIFY(isExploring());
    QAction* author = withKeys(QKeySequence(QStringLiteral("Ctrl+2")));
    QVERIFY(author != nullptr);
    QVERIFY(!author->isEnabled() && !author->isVisible());
    QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
    author->trigger();
    window_->setWorkspace(Workspace::author);
    QVERIFY(isExploring());
    QVERIFY(window_->messages().isError());
  }

  void roomsOfPluginsAreNotThereAndTheirKeysDoNothing() {
    showLocked();
    for (const char* keys : {"Ctrl+3", "Ctrl+4", "Ctrl+5"})
      if (QAction* room = withKeys(QKeySequence(QLatin1String(keys)))) {
        QVERIFY2(!room->isEnabled() && !room->isVisible(), keys);
        room->trigger();
      }
    for (const char* id : {"review", "stitching", "author"}) window_->showWorkspace(id);
    QVERIFY(isExploring());
  }

  void theCaseIsNeitherChangedNorSaved() {
    showLocked();
    QVERIFY(openCase(folder_));
    QVERIFY(!host().cases().edit(*host().cases().current(), "an edit", ""));
    QVERIFY(!host().cases().save({}));
    QVERIFY(!host().cases().save(files_.path(QStringLiteral("copy")).toStdString()));
    QVERIFY(!host().cases().makeOwn());
    QVERIFY(!host().caseParts().edit(std::string(kLessonsPart), nlohmann::json(), "an edit", ""));
    QVERIFY(!QFile::exists(files_.path(QStringLiteral("copy"))));
    QAction* save = withKeys(QKeySequence(QStringLiteral("Ctrl+S")));
    QVERIFY(save != nullptr && !save->isVisible() && !save->isEnabled());
  }

  void aPluginGetsNoAnswerThroughTheDoor() {
    showLocked();
    QVERIFY(openCase(folder_));
    QVERIFY(host().cases().isLocked());
    const std::string manifest = manifestOf(*host().cases().current()).dump();
    QVERIFY2(manifest.find("SECRET") == std::string::npos, manifest.c_str());
    QVERIFY(manifest.find("why") == std::string::npos);
    QVERIFY(!host().caseParts().read(std::string(kLessonsPart)));
    QCOMPARE(host().cases().read(folder_.toStdString()).error().code, ErrorCode::badUsage);
    // What practice is judged by: for plugins that say so in their manifest (PluginHost).
    QCOMPARE(host().cases().forPractice()->diagnosis, std::string("SECRETDIAGNOSIS"));
  }

  void nothingInTheWindowNamesTheAnswer() {
    showLocked();
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled() && cardOf(QStringLiteral("A ball for you")).isValid(); }));
    QCOMPARE(answersInSight(), QString());
    QVERIFY(openCase(folder_));
    QCOMPARE(answersInSight(), QString());
    auto* details = find<QWidget>("caseInfoBody");
    QVERIFY(details != nullptr);
    for (auto* each : details->findChildren<QAbstractButton*>())
      if (each->isVisible()) each->click();
    keepScreenshot(*window_, "access-locked");
    QCOMPARE(answersInSight(), QString());
  }

  void aSearchForTheAnswerFindsNothing() {
    showLocked();
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled() && cardOf(QStringLiteral("A ball for you")).isValid(); }));
    auto* search = find<QLineEdit>("caseSearch");
    QVERIFY(search != nullptr);
    for (const char* word : {"SECRETDIAGNOSIS", "SECRETTITLE", "SECRETFINDING"}) {
      search->setText(QLatin1String(word));
      QVERIFY2(waitUntil([this] { return !cardOf(QStringLiteral("A ball for you")).isValid(); }), word);
    }
  }

  void aCaseThatIsDroppedShowsWhatTraineesMayRead() {
    showLocked();
    QMimeData dropped;
    dropped.setUrls({QUrl::fromLocalFile(folder_)});
    QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QVERIFY(waitUntil([this] { return window_->isSettled() && window_->document().current(); }));
    QVERIFY(isExploring());
    QCOMPARE(answersInSight(), QString());
  }

  void somebodyElsesAttemptIsNotOpened() {
    Attempt attempt;
    attempt.id = "20261126-093000-4f2a91c7";
    attempt.caseId = "taught";
    attempt.lessonId = "first";
    attempt.person = "Somebody else";
    const auto kept = AttemptFolder::begin(attemptsFolder(libraryFolder()), attempt);
    QVERIFY(kept);
    const QString recording = QString::fromStdString((kept->folder() / "step.seq.mha").string());
    QFile file(recording);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    showLocked();
    for (const QString& path : {recording, QString::fromStdString(kept->folder().string()),
                                QString::fromStdString((kept->folder() / "../20261126-093000-4f2a91c7/attempt.json").string())}) {
      while (window_->messages().count() > 0) window_->messages().dismiss();
      window_->open(path);
      QVERIFY2(window_->messages().text().contains(QLatin1String("other people's attempts")), qPrintable(window_->messages().text()));
    }
    QVERIFY(!allTexts().contains(QLatin1String("Somebody else")));
    std::filesystem::remove_all(kept->folder());
  }

  void undoBringsNothingBack() {
    makeWindow();
    QVERIFY(openCase(folder_));
    window_->setWorkspace(Workspace::author);
    Case changed = *host().cases().current();
    changed.diagnosis = "SECRETDRAFT";
    QVERIFY(host().cases().edit(changed, "an edit", ""));
    QVERIFY(host().cases().save({}));
    lock();
    window_.reset();
    makeWindow();
    QVERIFY(openCase(folder_));
    QVERIFY(!window_->document().history().canUndo());
    QVERIFY(isExploring());
  }

  void editsThatACrashLeftAreNotOffered() {
    showLocked();
    window_->offerKeptEdits();
    QVERIFY(window_->jobs().seen().empty());
    QVERIFY(QApplication::activeModalWidget() == nullptr);
  }

  void thePassphraseOpensAndAnotherDoesNot() {
    showLocked();
    QVERIFY(openCase(folder_));
    QAction* unlock = action("unlockForInstructors");
    QVERIFY(unlock->isVisible());
    answerDialog({QStringLiteral("correct horse batterz")});
    unlock->trigger();
    QVERIFY(isExploring());
    answerDialog({kWords});
    unlock->trigger();
    QVERIFY(button("workspaceAuthor")->isVisible());
    window_->setWorkspace(Workspace::author);
    QCOMPARE(host().cases().current()->diagnosis, std::string("SECRETDIAGNOSIS"));
    action("lockForTrainees")->trigger();
    QVERIFY(isExploring());
    QCOMPARE(host().cases().current()->diagnosis, std::string());
  }

  void aWindowIsLockedWhereTheTwoPassphrasesAgree() {
    makeWindow();
    QVERIFY(!action("unlockForInstructors")->isVisible());
    answerDialog({kWords, QStringLiteral("something else")});
    action("lockForTrainees")->trigger();
    QVERIFY(!hasLock(libraryFolder()));
    answerDialog({QStringLiteral("short"), QStringLiteral("short")});
    action("lockForTrainees")->trigger();
    QVERIFY(!hasLock(libraryFolder()));
    answerDialog({kWords, kWords});
    action("lockForTrainees")->trigger();
    QVERIFY(hasLock(libraryFolder()));
    QVERIFY(isExploring());
  }

  void practiceIsJudgedAtOnceAllTheSame() {
    showLocked();
    startFromCard(QStringLiteral("A ball for you"), 0);
    waitForStep("read");
    press("stepDone");
    waitForStep("answer");
    answer(0);
    waitForOutcome(QStringLiteral("Passed"));
  }

  void anExaminationIsWorkedThroughAndHandedIn() {
    const SecretKey key = *SecretKey::make();
    const QString place = files_.path(QStringLiteral("own cases/examination"));
    const auto made =
        aside([&] { return makeExamination(folder_.toStdString(), place.toStdString(), {.instructors = {key.publicKey()}}); });
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().c_str());
    QVERIFY(QDir().rename(folder_, files_.path(QStringLiteral("elsewhere"))));
    showLocked();
    QVERIFY(waitUntil([this] { return cardOf(QStringLiteral("A ball for you")).isValid(); }));
    QVERIFY(openCase(place));
    QVERIFY(host().caseParts().read(std::string(kLessonsPart)));
    window_->showStartPage();
    startFromCard(QStringLiteral("A ball for you"), 0);
    waitForStep("read");
    press("stepDone");
    waitForStep("answer");
    answer(1);
    waitForOutcome(QStringLiteral("Handed in"));
    keepScreenshot(*window_, "access-handed-in");
    QVERIFY(!allTexts().contains(QLatin1String("It is round")));
    QVERIFY(!allTexts().contains(QLatin1String("no corners")));
    press("nextStep");
    waitForOutcome(QStringLiteral("Examination handed in"));
    const AttemptList attempts = listAttempts(attemptsFolder(libraryFolder()));
    QVERIFY(!attempts.attempts.empty());
    const auto& [folder, attempt] = attempts.attempts.front();
    QCOMPARE(attempt.caseId, made->id);
    QCOMPARE(sealedAnswersOf(attempt), made->sealedSha256);
    QVERIFY(attempt.finishedAt);
    QCOMPARE(attempt.outcomes.back().verdict, StepVerdict::handedIn);
    QVERIFY(attempt.outcomes.back().answer == StepAnswer(OptionsAnswer{{1}}));
    const auto opened =
        aside([&] { return openExamination(place.toStdString(), key, files_.path(QStringLiteral("opened")).toStdString()); });
    QVERIFY(opened);
    const auto taken = takeExamined(folder, *opened, files_.path(QStringLiteral("scored")).toStdString());
    QVERIFY2(taken.has_value(), taken ? "" : taken.error().sentence().c_str());
    QCOMPARE(AttemptFolder::open(*taken)->attempt().lessonId, std::string("first"));
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::AccessTest;
EW_WINDOW_TEST_MAIN(AccessTest)
#include "access_test.moc"
