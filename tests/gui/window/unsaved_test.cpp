// What a person made is asked about when it would be lost, and not before: edits, volumes, files that are written over, work that is saved.
#include <QAbstractItemView>
#include <QAction>
#include <QDialog>
#include <QFileDialog>
#include <QFrame>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "ew/core/responsive_thread.h"
#include "ew/library/case.h"
#include "ew/library/edit_autosave.h"
#include "ew/ui_test_door/import.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/cases_fixture.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {
class UnsavedTest : public CasesFixture {
  Q_OBJECT

 private:
  using json = nlohmann::json;

  [[nodiscard]] QAction* action(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text().startsWith(text)) return each;
    return nullptr;
  }
  /// A job that saves until it is let go, and says how it ended.
  struct Save {
    std::atomic<bool> letGo{false}, done{false}, cancelled{false};
  };
  std::shared_ptr<Save> startSaving() const {
    auto save = std::make_shared<Save>();
    window_->jobs().start(
        QStringLiteral("Saving liver.mha"),
        [save](Progress& progress) -> Result<void> {
          while (!save->letGo) {
            if (progress.cancelRequested()) {
              save->cancelled = true;
              return failure(ErrorCode::cancelled, verbatim("Stopped."));
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          }
          save->done = true;
          return {};
        },
        {}, Jobs::Kind::saving);
    return save;
  }
  /// Drives the import dialog of a sweep up to the click that makes the volume.
  void beginVolume(const QString& sweep) const {
    window_->open(sweep);
    QDialog* dialog = nullptr;
    QVERIFY(waitUntil([&] { return (dialog = find<QDialog>("importDialog")) != nullptr && dialog->isVisible(); }, kOpening_ms));
    auto* make = dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"));
    QVERIFY(waitUntil([&] { return make->isEnabled(); }, kOpening_ms));
    make->click();
  }

 private Q_SLOTS:
  void init() { showFirstCase(); }
  void cleanup() { window_.reset(); }

  void editsMadeWhileAnotherCaseIsOpenedAreAskedAboutWhenItIsReady() {
    const QString second = writeCaseCalled(QStringLiteral("second"));
    for (const auto button : {QMessageBox::Cancel, QMessageBox::Save}) {
      Answers answers({{QStringLiteral("unsavedQuestion"), press(button)}});
      window_->open(second);
      QVERIFY2(answers.asked.isEmpty(), "nothing is lost yet");
      editTitle(button == QMessageBox::Cancel ? "edited" : "edited twice");
      QVERIFY(waitUntil([&] { return !answers.asked.isEmpty(); }, kOpening_ms));
      QVERIFY(waitForRest());
      QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedQuestion")});
      if (button == QMessageBox::Cancel) {
        QCOMPARE(openTitle(), QStringLiteral("edited"));
        QVERIFY(document().hasUnsavedChanges());
        QVERIFY(document().history().canUndo());
        QVERIFY(shows(QStringLiteral("edited")));
      }
    }
    QCOMPARE(openTitle(), QStringLiteral("second"));
    QVERIFY(shows(QStringLiteral("second")));
    QCOMPARE(loadCaseAside(folder_.toStdString())->title, std::string("edited twice"));
  }

  void discardedEditsGoAndAFileThatCannotBeOpenedAsksNothing() {
    editTitle("edited");
    Answers answers({{QStringLiteral("unsavedQuestion"), press(QMessageBox::Discard)}});
    const QString wrong = files_.path(QStringLiteral("wrong.mha"));
    QVERIFY(writeFileSafely(wrong.toStdString(), "this is not a MetaImage\n").has_value());
    window_->open(wrong);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }, kOpening_ms));
    QVERIFY(answers.asked.isEmpty());
    QVERIFY(document().hasUnsavedChanges());
    window_->open(writeCaseCalled(QStringLiteral("second")));
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("second"); }, kOpening_ms));
    QCOMPARE(answers.asked.size(), 1);
    QCOMPARE(loadCaseAside(folder_.toStdString())->title, std::string("first"));
  }

  void editsMadeWhileAVolumeIsMadeStayAndTheVolumeWaits() {
    const QString sweep = files_.writeSweep(QStringLiteral("waiting.igs.mha"));
    {
      const Answers stay({{QStringLiteral("unsavedQuestion"), press(QMessageBox::Cancel)}});
      beginVolume(sweep);
      editTitle("edited");
      QVERIFY(waitUntil([&] { return !stay.asked.isEmpty(); }, kOpening_ms));
      QVERIFY(waitForRest());
    }
    QCOMPARE(openTitle(), QStringLiteral("edited"));
    QVERIFY(document().hasUnsavedChanges());
    QAction* waiting = action(QStringLiteral("Show the volume made from waiting.igs.mha"));
    QVERIFY2(waiting != nullptr && waiting->isVisible(), "a volume that took minutes is not lost by staying with the case");
    const Answers discard({{QStringLiteral("unsavedQuestion"), press(QMessageBox::Discard)}});
    waiting->trigger();
    QVERIFY(waitUntil([this] { return shows(QStringLiteral("waiting.igs.mha")); }, kOpening_ms));
    QVERIFY(!document().current());
    QVERIFY(!waiting->isVisible());
  }

  void aVolumeThatWasNeverSavedIsAskedAbout() {
    beginVolume(files_.writeSweep(QStringLiteral("made.igs.mha")));
    QVERIFY(waitUntil([this] { return shows(QStringLiteral("made.igs.mha")); }, kOpening_ms));
    {
      const Answers stay({{QStringLiteral("unsavedVolumeQuestion"), press(QMessageBox::Cancel)}});
      QVERIFY(!window_->close());
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedVolumeQuestion")});
      window_->open(folder_);
      QVERIFY(waitUntil([&] { return stay.asked.size() == 2; }, kOpening_ms));
      QVERIFY(waitForRest());
      QVERIFY(shows(QStringLiteral("made.igs.mha")));
    }
    const QString file = files_.path(QStringLiteral("made volume"));
    const Answers save({{QStringLiteral("unsavedVolumeQuestion"), press(QMessageBox::Save)},
                        {QStringLiteral("volumePlace"), press("ownPlace")},
                        {QStringLiteral("fileDialog"), type(file)},
                        {QStringLiteral("savingDialog"), [](QWidget&) {}}});
    window_->open(folder_);
    QVERIFY(waitUntil([this] { return shows(QStringLiteral("first")); }, kOpening_ms));
    QVERIFY(QFile::exists(file + QStringLiteral(".mha")));
    QVERIFY(readVolume(file.toStdString() + ".mha").has_value());
    const qsizetype asked = save.asked.size();
    QVERIFY(window_->close());
    QCOMPARE(static_cast<qsizetype>(save.asked.size()), asked);  // nothing is left to be asked about
  }

  void whatTheShownVolumeWasMadeFromIsNeverWrittenOver() {
    const QString sweep = files_.writeSweep(QStringLiteral("precious.igs.mha"));
    const std::string before = textOf(sweep);
    beginVolume(sweep);
    QVERIFY(waitUntil([this] { return shows(QStringLiteral("precious.igs.mha")); }, kOpening_ms));
    QString proposed;
    const auto typeOver = [&proposed, sweep](QWidget& dialog) {
      proposed = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
      testing::type(sweep)(dialog);
    };
    // A volume, an image, and measurements of any kind go through the same question.
    for (const QString& what : {QStringLiteral("Save &volume as"), QStringLiteral("Save &image as")}) {
      const Answers answers({{QStringLiteral("volumePlace"), press("ownPlace")},
                             {QStringLiteral("fileDialog"), typeOver},
                             {QStringLiteral("keptFileMessage"), press(QMessageBox::Cancel)}});
      action(what)->trigger();
      QVERIFY(waitForRest());
      QVERIFY2(answers.asked.contains(QStringLiteral("keptFileMessage")), qPrintable(answers.asked.join(QLatin1Char(' '))));
      QVERIFY2(answers.texts.last().contains(QStringLiteral("precious.igs.mha")), qPrintable(answers.texts.last()));
      QVERIFY(textOf(sweep) == before);
      if (what.contains(QStringLiteral("volume"))) QCOMPARE(proposed, QStringLiteral("precious-volume.mha"));
    }
  }

  void theFilesOfTheOpenCaseAreNotWrittenOverEither() {
    const QString file = folder_ + QStringLiteral("/volume.mha");
    const std::string before = textOf(file);
    const Answers answers({{QStringLiteral("fileDialog"), type(file)}, {QStringLiteral("keptFileMessage"), press(QMessageBox::Cancel)}});
    action(QStringLiteral("Save &image as"))->trigger();
    QCOMPARE(answers.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("keptFileMessage")}));
    QVERIFY(textOf(file) == before);
  }

  void closingWhileSomethingIsSavedWaitsForIt() {
    const auto save = startSaving();
    {
      const Answers stay({{QStringLiteral("savingDialog"), press("stay")}});
      QVERIFY(!window_->close());
      QCOMPARE(stay.asked, QStringList{QStringLiteral("savingDialog")});
      QVERIFY(!save->cancelled && window_->isVisible());
    }
    const Answers finish({{QStringLiteral("savingDialog"), [save](QWidget&) { save->letGo = true; }}});
    QVERIFY2(window_->close(), "it closes by itself as soon as everything is saved");
    QVERIFY(save->done && !save->cancelled);
  }

  void closingAndLosingWhatIsSavedIsADecision() {
    const auto save = startSaving();
    const Answers lose({{QStringLiteral("savingDialog"), press("closeAndLose")}});
    QVERIFY(window_->close());
    QVERIFY(save->cancelled && !save->done);
  }

  void theWindowStaysOpenWhenSavingFailsMeanwhile() {
    auto fail = std::make_shared<std::atomic<bool>>(false);
    window_->jobs().start(
        QStringLiteral("Saving liver.mha"),
        [fail](Progress&) -> Result<void> {
          while (!*fail) std::this_thread::sleep_for(std::chrono::milliseconds(5));
          return failure(ErrorCode::notWritable, verbatim("The disk is full."));
        },
        [this](const Result<void>& outcome) { window_->messages().showError(outcome.error()); }, Jobs::Kind::saving);
    // The dialog's next look at the jobs is due by the time it hears of the failure; what it sees then must not count as saved.
    const auto late = connect(&window_->jobs(), &Jobs::notSaved, this, [] { std::this_thread::sleep_for(std::chrono::milliseconds(200)); });
    const Answers wait({{QStringLiteral("savingDialog"), [fail](QWidget&) { *fail = true; }}});
    const bool closed = window_->close();
    disconnect(late);
    QVERIFY(!closed);
    QCOMPARE(window_->messages().text(), QStringLiteral("The disk is full."));
  }

  void savingAVolumeIsWorkThatClosingWaitsFor() {
    const QString file = files_.path(QStringLiteral("closing.mha"));
    const Answers answers({{QStringLiteral("fileDialog"), type(file)}, {QStringLiteral("savingDialog"), [](QWidget&) {}}});
    action(QStringLiteral("Save &volume as"))->trigger();
    QVERIFY(window_->jobs().isSaving());
    QVERIFY(window_->close());
    QVERIFY(readVolume(file.toStdString()).has_value());
  }

  void aNameWithoutItsEndingIsAskedAboutAsItWillBeWritten() {
    const QString stem = files_.path(QStringLiteral("liver"));
    for (const QString& ending : {QStringLiteral(".mha"), QStringLiteral(".png")})
      QVERIFY(writeFileSafely((stem + ending).toStdString(), "somebody else's").has_value());
    for (const QString& what : {QStringLiteral("Save &volume as"), QStringLiteral("Save &image as")}) {
      const QString file = stem + (what.contains(QStringLiteral("volume")) ? QStringLiteral(".mha") : QStringLiteral(".png"));
      {
        const Answers keep({{QStringLiteral("fileDialog"), type(stem)}, {QStringLiteral("replaceQuestion"), press(QMessageBox::Cancel)}});
        action(what)->trigger();
        QVERIFY(waitForRest());
        QCOMPARE(keep.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("replaceQuestion")}));
        QVERIFY2(keep.texts.last().contains(QFileInfo(file).fileName()), qPrintable(keep.texts.last()));
        QCOMPARE(textOf(file), std::string("somebody else's"));
      }
      const Answers replace({{QStringLiteral("fileDialog"), type(stem)}, {QStringLiteral("replaceQuestion"), press("replace")}});
      action(what)->trigger();
      QVERIFY(waitForRest());
      QVERIFY(textOf(file) != "somebody else's");
    }
  }

  void theSamplesBesideAHeaderAreAskedAboutToo() {
    const QString stem = files_.path(QStringLiteral("pair"));
    QVERIFY(writeFileSafely(stem.toStdString() + ".raw", "my only copy").has_value());
    const Answers keep({{QStringLiteral("fileDialog"), type(stem + QStringLiteral(".mhd"))},
                        {QStringLiteral("replaceQuestion"), press(QMessageBox::Cancel)}});
    action(QStringLiteral("Save &volume as"))->trigger();
    QVERIFY(waitForRest());
    QVERIFY(keep.asked.contains(QStringLiteral("replaceQuestion")));
    QVERIFY(keep.texts.last().contains(QStringLiteral("pair.raw")));
    QCOMPARE(test::textOf(stem.toStdString() + ".raw"), std::string("my only copy"));
    QVERIFY(!QFile::exists(stem + QStringLiteral(".mhd")));
  }

  void aCaseSavedByAnotherProgramMeanwhileIsNotOverwrittenUnasked() {
    const auto saveInAnotherProgram = [this](const std::string& title) {
      auto other = loadCaseAside(folder_.toStdString());
      QVERIFY(other.has_value());
      other->title = title;
      QVERIFY(saveCase(*other, folder_.toStdString()).has_value());
    };
    const auto titleOnDisk = [this] { return loadCaseAside(folder_.toStdString())->title; };
    QAction* save = action(QStringLiteral("&Save case"));

    editTitle("ours");
    save->trigger();
    QCOMPARE(titleOnDisk(), std::string("ours"));  // nobody else: nothing is asked
    editTitle("ours again");
    saveInAnotherProgram("theirs");
    QVERIFY2(!document().save().has_value(), "a plugin's save decides nothing either");
    {
      const Answers answers({{QStringLiteral("changedOnDiskQuestion"), press(QMessageBox::Cancel)}});
      save->trigger();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("changedOnDiskQuestion")});
      QCOMPARE(titleOnDisk(), std::string("theirs"));
      QVERIFY(document().hasUnsavedChanges());
    }
    {
      const Answers answers({{QStringLiteral("changedOnDiskQuestion"), press("overwrite")}});
      save->trigger();
      QCOMPARE(titleOnDisk(), std::string("ours again"));
      QVERIFY(!document().hasUnsavedChanges());
    }
    editTitle("ours at last");
    saveInAnotherProgram("theirs again");
    {
      const Answers answers(
          {{QStringLiteral("changedOnDiskQuestion"), press("keepBoth")}, {QStringLiteral("caseFolderDialog"), press("saveCaseFolder")}});
      save->trigger();
      QCOMPARE(answers.asked, (QStringList{QStringLiteral("changedOnDiskQuestion"), QStringLiteral("caseFolderDialog")}));
      QCOMPARE(titleOnDisk(), std::string("theirs again"));
      QVERIFY(document().current()->folder != folder_.toStdString());
      QCOMPARE(loadCaseAside(document().current()->folder)->title, std::string("ours at last"));
    }
    window_->open(folder_);
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("theirs again"); }, kOpening_ms));
    editTitle("ours once more");
    saveInAnotherProgram("theirs for good");
    const Answers answers({{QStringLiteral("changedOnDiskQuestion"), press("reload")}});
    save->trigger();
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("theirs for good"); }, kOpening_ms));
    QVERIFY(waitForRest());
    QCOMPARE(answers.asked, QStringList{QStringLiteral("changedOnDiskQuestion")});
    QVERIFY(shows(QStringLiteral("theirs for good")));
  }

  void editsThatACrashInterruptedAreOfferedAndTakenOver() {
    // As a crash leaves them: what a program keeps, in a folder that no program holds.
    const QString root = files_.path(QStringLiteral("data/echoweave/unsaved-cases"));
    const auto leave = [&](const std::string& title) {
      EditAutosave program(root.toStdString());
      auto read = readCaseAside(folder_.toStdString());
      QVERIFY(read.has_value());
      read->opened.title = title;
      QVERIFY(program.keep(read->opened, read->manifest).has_value());
      for (const auto& kept : std::filesystem::directory_iterator(root.toStdString())) {
        if (!std::filesystem::exists(kept.path() / "lock")) continue;
        std::filesystem::create_directories(root.toStdString() + "/left");
        std::filesystem::copy(kept.path() / "case-edits.json", root.toStdString() + "/left/case-edits.json",
                              std::filesystem::copy_options::overwrite_existing);
      }
    };
    const auto isLeft = [&] { return QFile::exists(root + QStringLiteral("/left/case-edits.json")); };
    leave("typed before the crash");
    {
      const Answers later({{QStringLiteral("keptEditsQuestion"), [](QWidget& dialog) { qobject_cast<QDialog*>(&dialog)->reject(); }}});
      window_->offerKeptEdits();
      window_->offerKeptEdits();
      QVERIFY(waitUntil([&] { return !later.asked.isEmpty() && window_->jobs().seen().empty(); }));
      window_->offerKeptEdits();
      QVERIFY(waitUntil([&] { return window_->jobs().seen().empty(); }));
      QCOMPARE(later.asked, QStringList{QStringLiteral("keptEditsQuestion")});  // once is enough
      QVERIFY(isLeft());
    }
    window_.reset();
    showWindowWithCase(writeCaseCalled(QStringLiteral("second")));
    {
      // The case comes while the question is open, as one of the command line does: it asks no second time.
      const Answers open({{QStringLiteral("keptEditsQuestion"), [this](QWidget& dialog) {
                             window_->open(folder_);
                             auto* poll = new QTimer(&dialog);
                             connect(poll, &QTimer::timeout, &dialog, [this, &dialog] {
                               if (openTitle() == QLatin1String("first") && window_->isSettled())
                                 dialog.findChild<QPushButton*>(QStringLiteral("openKept"))->click();
                             });
                             poll->start(20);
                           }}});
      window_->offerKeptEdits();
      QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("typed before the crash"); }, kOpening_ms));
      QCOMPARE(open.asked.size(), 1);
      QVERIFY(waitForRest());
      QVERIFY(shows(QStringLiteral("typed before the crash")));
      QVERIFY(document().hasUnsavedChanges());
      QVERIFY(!isLeft());
      document().undo();
      QCOMPARE(openTitle(), QStringLiteral("first"));
      document().redo();
      QVERIFY(document().save().has_value());
    }
    leave("never meant");
    const Answers discard({{QStringLiteral("keptEditsQuestion"), press("discardKept")}});
    window_->offerKeptEdits();
    QVERIFY(waitUntil([&] { return !isLeft(); }));
    QCOMPARE(discard.asked.size(), 1);
    QCOMPARE(loadCaseAside(folder_.toStdString())->title, std::string("typed before the crash"));
  }

  void editsThatMakeNoCaseAnyMoreAreRefusedAndStay() {
    const QString root = files_.path(QStringLiteral("data/echoweave/unsaved-cases"));
    const QString left = root + QStringLiteral("/left/case-edits.json");
    json manifest = json::parse(textOf(folder_ + QStringLiteral("/case.json")));
    manifest["volume"]["file"] = "nowhere.mha";
    test::writeText(left.toStdString(), json{{"case_folder", folder_.toStdString()},
                                             {"manifest", manifest},
                                             {"read_bytes", std::uint64_t{1}},
                                             {"read_hash", std::uint64_t{2}}}
                                            .dump());
    const Answers open({{QStringLiteral("keptEditsQuestion"), press("openKept")}});
    window_->offerKeptEdits();
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }, kOpening_ms));
    QVERIFY2(window_->messages().text().contains(QStringLiteral("nowhere.mha")), qPrintable(window_->messages().text()));
    QCOMPARE(open.asked.size(), 1);
    QCOMPARE(openTitle(), QStringLiteral("first"));
    QVERIFY(!document().hasUnsavedChanges());
    QVERIFY(QFile::exists(left));
    QVERIFY(QDir(root + QStringLiteral("/left")).removeRecursively());
  }

  void editsAreKeptWhileTheyAreNotSavedAndForgottenAfterwards() {
    const QString root = files_.path(QStringLiteral("data/echoweave/unsaved-cases"));
    const auto kept = [&root]() -> std::string {
      for (const auto& each : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const std::string text = textOf(root + QLatin1Char('/') + each + QStringLiteral("/case-edits.json"));
        if (!text.empty()) return json::parse(text)["manifest"]["title"];
      }
      return {};
    };
    QVERIFY(kept().empty());
    editTitle("typed");
    QVERIFY(waitUntil([&] { return kept() == "typed"; }, kOpening_ms));
    editTitle("typed on");
    QVERIFY(waitUntil([&] { return kept() == "typed on"; }, kOpening_ms));
    QVERIFY(document().save().has_value());
    QVERIFY(waitUntil([&] { return kept().empty(); }, kOpening_ms));
    editTitle("given up");
    QVERIFY(waitUntil([&] { return kept() == "given up"; }, kOpening_ms));
    const Answers answers({{QStringLiteral("unsavedQuestion"), press(QMessageBox::Discard)}});
    QVERIFY(window_->close());
    QVERIFY(kept().empty());
  }

  void aCaseThatIsOpenHereIsNotTakenOutOfTheLibrary() {
    const QString own = files_.path(QStringLiteral("own cases/mine"));
    QVERIFY(QDir().mkpath(QFileInfo(own).path()) && QDir().rename(writeCaseCalled(QStringLiteral("mine")), own));
    auto* page = find<StartPage>("startPage");
    window_->open(own);
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("mine"); }, kOpening_ms));
    QVERIFY(waitForRest());
    {
      const Answers nobody({});
      Q_EMIT page->withdrawRequested(own, QStringLiteral("mine"));
      QVERIFY(nobody.asked.isEmpty());
      QVERIFY(QFile::exists(own + QStringLiteral("/case.json")));
      QVERIFY(window_->messages().isError());
      QVERIFY2(window_->messages().text().contains(QStringLiteral("in use in this window")), qPrintable(window_->messages().text()));
    }
    window_->open(folder_);
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("first"); }, kOpening_ms));
    QVERIFY(waitForRest());
    const Answers take({{QStringLiteral("withdrawQuestion"), press("withdrawNow")}});
    Q_EMIT page->withdrawRequested(own, QStringLiteral("mine"));
    QCOMPARE(take.asked, QStringList{QStringLiteral("withdrawQuestion")});
    QVERIFY2(!QFile::exists(own), qPrintable(window_->messages().text()));
    QVERIFY(waitForRest());
  }

  void aShippedCaseIsChangedInACopyOfTheUsersOwn() {
    // A program's folder of this test's own: the resources as they are, and one case.
    const QString program = files_.path(QStringLiteral("program"));
    QDir().mkpath(program + QStringLiteral("/cases"));
    QVERIFY(QFile::link(QString::fromStdString(resourceFolder()->string()), program + QStringLiteral("/resources")));
    const QString shipped = program + QStringLiteral("/cases/shipped case");
    QVERIFY(QDir().rename(folder_, shipped));
    const test::EnvironmentValue here("ECHOWEAVE_RESOURCES", (program + QStringLiteral("/resources")).toStdString());
    window_->open(shipped);
    QVERIFY(waitUntil([this] { return document().isShippedCase(); }, kOpening_ms));
    QVERIFY(waitForRest());
    const std::string before = textOf(shipped + QStringLiteral("/case.json"));
    editTitle("my own");
    QVERIFY2(!document().save().has_value(), "whoever does not ask cannot change it");
    QAction* save = action(QStringLiteral("&Save case"));
    {
      const Answers stay({{QStringLiteral("shippedQuestion"), press(QMessageBox::Cancel)}});
      save->trigger();
      QCOMPARE(stay.asked, QStringList{QStringLiteral("shippedQuestion")});
      QVERIFY(document().hasUnsavedChanges());
    }
    const Answers copy(
        {{QStringLiteral("shippedQuestion"), press("saveCopy")}, {QStringLiteral("caseFolderDialog"), press("saveCaseFolder")}});
    save->trigger();
    QCOMPARE(copy.asked, (QStringList{QStringLiteral("shippedQuestion"), QStringLiteral("caseFolderDialog")}));
    QCOMPARE(textOf(shipped + QStringLiteral("/case.json")), before);
    const auto& own = document().current();
    QCOMPARE(QString::fromStdString(own->folder.string()), files_.path(QStringLiteral("own cases/shipped case")));
    QVERIFY(!document().isShippedCase() && !document().hasUnsavedChanges());
    const auto saved = loadCaseAside(own->folder);
    QVERIFY(saved.has_value());
    QCOMPARE(saved->title, std::string("my own"));
    QCOMPARE(saved->id, std::string("shipped-case"));
    QVERIFY(saved->id != json::parse(before)["id"]);
    QCOMPARE(QSettings().value(QStringLiteral("recent")).toStringList().constFirst(), QString::fromStdString(own->folder.string()));
    QCOMPARE(QSettings().value(QStringLiteral("open/last")).toString(), QString::fromStdString(own->folder.string()));
    window_->showStartPage();
    // The program's, and the copy.
    QVERIFY(waitUntil([this] { return window_->isSettled() && find<QAbstractItemView>("caseCards")->model()->rowCount() == 2; }));
    QVERIFY(waitForRest());
    editTitle("my own, again");
    save->trigger();
    QCOMPARE(copy.asked.size(), 2);  // a case of one's own is saved without a question
    QCOMPARE(loadCaseAside(own->folder)->title, std::string("my own, again"));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::UnsavedTest)
#include "unsaved_test.moc"
