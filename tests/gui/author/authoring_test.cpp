// An author in the real window: makes cases from a sweep and from nothing, gives a volume, is warned of what looks real, sees what is
// missing, publishes and exports; a trainee elsewhere imports it. EW_SCREENSHOTS=DIR keeps images of every step.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "ew/io/volume_file.h"
#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/case_start.h"
#include "ew/library/folder_lease.h"
#include "ew/library/new_case.h"
#include "ew/library/placing.h"
#include "ew/library/published.h"
#include "ew/library/publishing.h"
#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

class AuthoringTest : public WindowFixture {
  Q_OBJECT

  using json = nlohmann::json;
  int made_ = 0;

  [[nodiscard]] CaseDocument& document() const { return window_->document(); }
  [[nodiscard]] QWidget* panel() const { return window_->findChild<QWidget*>(QStringLiteral("casePanel")); }
  template <class Widget>
  [[nodiscard]] Widget* inPanel(const char* name) const {
    return panel() != nullptr ? panel()->findChild<Widget*>(QLatin1String(name)) : nullptr;
  }
  [[nodiscard]] QAction* action(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text().contains(text)) return each;
    return nullptr;
  }
  [[nodiscard]] bool waitForRest() const {
    return waitUntil([this] { return window_->isSettled(); });
  }
  void showWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openPlugins();
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
  }
  /// Opens a case in Author, with the Case panel in front.
  void author(const QString& folder) {
    QVERIFY(openCase(folder));
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    QVERIFY(panel() != nullptr);
  }
  [[nodiscard]] QWidget* newCaseDialog() {
    action(QStringLiteral("New case"))->trigger();
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = topLevel("newCaseDialog")) != nullptr && dialog->isVisible(); })) return nullptr;
    return dialog;
  }
  [[nodiscard]] static QWidget* topLevel(const char* name) {
    for (QWidget* each : QApplication::topLevelWidgets())
      if (each->objectName() == QLatin1String(name) && each->isVisible()) return each;
    return nullptr;
  }
  /// Answers from which side the chosen volume was scanned, once that is asked.
  static void chooseFront(const QWidget& dialog) {
    auto* side = dialog.findChild<QComboBox*>(QStringLiteral("sourceSide"));
    QVERIFY(waitUntil([&] { return side->isVisible(); }));
    side->setCurrentIndex(side->findData(static_cast<int>(VolumeSide::front)));
  }
  /// Everything a case needs before it is published, but for what its volume and its start decide.
  void fill() {
    Case filled = withRights(*document().current(), {"Made by a test.", "CC0 1.0"});
    filled.titleForTrainees = "Upper abdomen, routine";
    filled.region = "upper abdomen";
    filled.indication = "To be looked at.";
    filled.findings = {"Nothing remarkable."};
    filled.diagnosis = "Healthy.";
    filled.difficulty = 1;
    filled.startPose.emplace().probeToWorld = session().probeControl().pose().probeToWorld;
    const auto edited = document().edit(filled, "Fill in", {});
    QVERIFY2(edited, edited ? "" : edited.error().sentence().c_str());
  }
  [[nodiscard]] QWidget* publishDialog() {
    inPanel<QPushButton>("publishCase")->click();
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = topLevel("publishDialog")) != nullptr; })) return nullptr;
    if (!waitUntil([&] { return dialog->findChild<QToolButton*>(QStringLiteral("checkItem_0")) != nullptr; })) return nullptr;
    return dialog;
  }
  [[nodiscard]] static QToolButton* itemFor(const QWidget& dialog, const QString& field) {
    for (auto* each : dialog.findChildren<QToolButton*>())
      if (each->property("field").toString() == field) return each;
    return nullptr;
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void cleanup() { window_.reset(); }

  void theFormBecomesNarrowerThanItsFieldsWouldLike() {
    showWindow();
    author(files_.writeCase(QStringLiteral("narrow")));
    window_->resize(1366, 768);
    inPanel<QPushButton>("addMeasurement")->click();
    inPanel<QPushButton>("addExamination")->click();
    for (auto* head : panel()->findChildren<QToolButton*>())
      if (head->isCheckable() && !head->isChecked()) head->click();
    QTest::qWait(50);
    for (const auto* scroll : panel()->findChildren<QScrollArea*>())
      QVERIFY2(scroll->horizontalScrollBar()->maximum() == 0,
               qPrintable(QStringLiteral("%1 px beyond the right edge").arg(scroll->horizontalScrollBar()->maximum())));
    QCOMPARE(inPanel<QListWidget>("presets")->horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
  }

  void theFormAloneScrollsAndItsButtonsStayInSight() {
    showWindow();
    author(files_.writeCase(QStringLiteral("small")));
    window_->resize(1024, 640);
    QTest::qWait(50);
    const QScrollArea* around = nullptr;
    for (QWidget* each = panel()->parentWidget(); each != nullptr && around == nullptr; each = each->parentWidget())
      around = qobject_cast<QScrollArea*>(each);
    QVERIFY(around != nullptr);
    QCOMPARE(around->verticalScrollBar()->maximum(), 0);
    QVERIFY(inPanel<QScrollArea>("caseFormRows")->verticalScrollBar()->maximum() > 0);
    for (const char* name : {"save", "saveAs", "checkCase", "publishCase"}) {
      const auto* button = inPanel<QPushButton>(name);
      QCOMPARE(button->visibleRegion().boundingRect(), button->rect());
    }
  }

  void aNewCaseFromASweepOpensInAuthor() {
    const QString sweep = files_.writeSweep(QStringLiteral("liver.igs.mha"));
    showWindow();
    QWidget* dialog = newCaseDialog();
    QVERIFY(dialog != nullptr);
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    QVERIFY2(!next->isEnabled(), "no file is chosen yet");
    keepScreenshot(*dialog, "new-case-1-empty");
    dialog->findChild<QLineEdit*>(QStringLiteral("sourceFile"))->setText(sweep);
    QVERIFY2(dialog->findChild<QRadioButton*>(QStringLiteral("sourceSweep"))->isChecked(), "the file says that it is a sweep");
    QVERIFY(dialog->findChild<QWidget*>(QStringLiteral("sourceSpacing"))->isVisible());
    keepScreenshot(*dialog, "new-case-1-sweep");
    QVERIFY2(waitUntil([&] { return next->isEnabled(); }), "the sweep was looked at");
    next->click();
    QVERIFY2(!next->isEnabled(), "no title yet");
    auto* templates = dialog->findChild<QComboBox*>(QStringLiteral("newCaseTemplate"));
    templates->setCurrentIndex(templates->findData(QStringLiteral("right-upper-quadrant")));
    QVERIFY(!dialog->findChild<QComboBox*>(QStringLiteral("newCaseRegion"))->currentText().isEmpty());
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Liver, a sweep"));
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTraineeTitle"))->setText(QStringLiteral("Right upper abdomen"));
    dialog->findChild<QLineEdit*>(QStringLiteral("sourceAttribution"))->setText(QStringLiteral("Recorded by a test."));
    dialog->findChild<QLineEdit*>(QStringLiteral("sourceLicence"))->setText(QStringLiteral("CC0 1.0"));
    keepScreenshot(*dialog, "new-case-2");
    next->click();
    auto* plan = dialog->findChild<QLabel*>(QStringLiteral("newCasePlan"));
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    QVERIFY2(plan->text().contains(QStringLiteral("Memory")), qPrintable(plan->text()));
    QCOMPARE(dialog->findChild<QLineEdit*>(QStringLiteral("newCaseFolder"))->text(), QStringLiteral("liver-a-sweep"));
    keepScreenshot(*dialog, "new-case-3");
    next->click();
    QVERIFY(waitUntil([this] { return document().current() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    const Case& opened = *document().current();
    QCOMPARE(opened.title, std::string("Liver, a sweep"));
    QCOMPARE(opened.titleForTrainees, std::string("Right upper abdomen"));
    QCOMPARE(opened.folder, std::filesystem::path(files_.path(QStringLiteral("own cases")).toStdString()) / "liver-a-sweep");
    QVERIFY(validateCaseAside(opened.folder).empty());
    QVERIFY(session().subject().has_value());
    QVERIFY(waitUntil([this] { return panel() != nullptr && panel()->isVisible(); }));
    QVERIFY(!document().hasUnsavedChanges());
    const auto* mannequins = panel()->findChild<QComboBox*>(QStringLiteral("mannequin"));
    QVERIFY(mannequins->findText(QStringLiteral("Adult, neck stretched")) >= 0);
    for (int n = 0; n < mannequins->count(); ++n)
      QVERIFY2(!mannequins->itemText(n).contains(QStringLiteral(".json")), qPrintable(mannequins->itemText(n)));
    QVERIFY(waitUntil([] { return topLevel("newCaseDialog") == nullptr; }));
    keepScreenshot(*window_, "new-case-4-opened");
  }

  /// A file that knows neither spacing nor side: each question has its field in the dialog.
  void whatAFileLeavesOpenIsAskedWhereItIsChosen() {
    const QString file = files_.path(QStringLiteral("unspaced.mha"));
    Volume volume;
    volume.grid.dims = {12, 20, 8};
    for (int n = 0; n < 12 * 20 * 8; ++n) volume.echo.push_back(static_cast<std::uint8_t>(20 + 5 * ((n / 12) % 20)));
    QVERIFY(writeVolume(volume, file.toStdString()).has_value());
    showWindow();
    QWidget* dialog = newCaseDialog();
    QVERIFY(dialog != nullptr);
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    auto* side = dialog->findChild<QComboBox*>(QStringLiteral("sourceSide"));
    std::array<QDoubleSpinBox*, 3> voxel{};
    for (std::size_t n = 0; n < 3; ++n) voxel[n] = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("sourceVoxel%1").arg(n));
    dialog->findChild<QLineEdit*>(QStringLiteral("sourceFile"))->setText(file);
    QVERIFY(waitUntil([&] { return voxel[0]->isVisible(); }));
    keepScreenshot(*dialog, "new-case-1-asked");
    QVERIFY(!next->isEnabled() && !side->isVisible());
    for (QDoubleSpinBox* each : voxel) each->setValue(0.5);
    QVERIFY(waitUntil([&] { return side->isVisible(); }));
    QVERIFY2(waitUntil([&] { return next->isEnabled(); }), "it grows brighter to its back, which is proposed");
    QCOMPARE(side->currentData().toInt(), static_cast<int>(VolumeSide::back));
    QVERIFY(!dialog->findChild<QLabel*>(QStringLiteral("sourceSideImage"))->pixmap(Qt::ReturnByValue).isNull());
    keepScreenshot(*dialog, "new-case-1-side");
    next->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Without spacing"));
    next->click();
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    next->click();
    QVERIFY(waitUntil([this] { return document().current() && window_->isSettled(); }));
    const auto axes = sweepAxesOf(*document().current());
    QVERIFY(axes && axes->depth == glm::dvec3(0, -1, 0) && !assumesAxes(*document().current()));
  }

  void aVolumeOnScreenBecomesACaseWithoutAFile() {
    const QString volume = files_.writeCase(QStringLiteral("other")) + QStringLiteral("/volume.mha");
    showWindow();
    window_->open(volume);
    QVERIFY(waitUntil([this] { return session().subject() && window_->isSettled(); }));
    window_->setWorkspace(Workspace::author);
    QVERIFY(waitUntil([this] { return panel() != nullptr && panel()->isVisible(); }));
    inPanel<QPushButton>("newCaseHere")->click();
    QWidget* dialog = nullptr;
    QVERIFY(waitUntil([&] { return (dialog = topLevel("newCaseDialog")) != nullptr; }));
    QVERIFY(dialog->findChild<QRadioButton*>(QStringLiteral("sourceShown"))->isChecked());
    chooseFront(*dialog);
    keepScreenshot(*dialog, "new-case-1-shown");
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    next->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Of the screen"));
    next->click();
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    next->click();
    QVERIFY(waitUntil([this] { return document().current() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(!hasNoVolume(*document().current()));
  }

  void aNameThatIsTakenIsRefusedAndNothingIsLost() {
    QDir().mkpath(files_.path(QStringLiteral("own cases/taken")));
    QVERIFY(writeFileSafely(files_.path(QStringLiteral("own cases/taken/notes.txt")).toStdString(), "mine").has_value());
    showWindow();
    QWidget* dialog = newCaseDialog();
    QVERIFY(dialog != nullptr);
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    dialog->findChild<QRadioButton*>(QStringLiteral("sourceNothing"))->click();
    next->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Taken"));
    next->click();
    QTest::qWait(300);
    QVERIFY(!next->isEnabled());
    auto* problem = dialog->findChild<QLabel*>(QStringLiteral("newCaseProblem"));
    QVERIFY2(problem->isVisible() && problem->text().contains(QStringLiteral("taken")), qPrintable(problem->text()));
    keepScreenshot(*dialog, "new-case-3-taken");
  }

  void aCaseFromNothingSaysHowToGiveItAVolumeAndIsGivenOne() {
    const QString other = files_.writeCase(QStringLiteral("other"));
    showWindow();
    QWidget* dialog = newCaseDialog();
    QVERIFY(dialog != nullptr);
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    dialog->findChild<QRadioButton*>(QStringLiteral("sourceNothing"))->click();
    next->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Nothing yet"));
    next->click();
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    next->click();
    QVERIFY(waitUntil([this] { return document().current() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(hasNoVolume(*document().current()));
    QVERIFY(!session().subject());
    QVERIFY(waitUntil([this] { return inPanel<QPushButton>("giveVolume") != nullptr; }));
    QVERIFY(inPanel<QPushButton>("giveVolumeFirst")->isVisible());
    QCOMPARE(inPanel<QPushButton>("giveVolume")->text(), QStringLiteral("Give the case a volume…"));
    keepScreenshot(*window_, "no-volume");
    window_->setWorkspace(Workspace::explore);
    keepScreenshot(*window_, "no-volume-explore");
    window_->setWorkspace(Workspace::author);

    inPanel<QPushButton>("giveVolumeFirst")->click();
    QWidget* give = nullptr;
    QVERIFY(waitUntil([&] { return (give = topLevel("giveVolumeDialog")) != nullptr; }));
    auto* now = give->findChild<QPushButton*>(QStringLiteral("giveVolumeNow"));
    QVERIFY(!now->isEnabled());
    give->findChild<QLineEdit*>(QStringLiteral("sourceFile"))->setText(other + QStringLiteral("/volume.mha"));
    give->findChild<QLineEdit*>(QStringLiteral("sourceLicence"))->setText(QStringLiteral("CC0 1.0"));
    chooseFront(*give);
    keepScreenshot(*give, "give-volume");
    QVERIFY(waitUntil([&] { return now->isEnabled(); }));
    now->click();
    QVERIFY(waitUntil([this] { return session().subject() && window_->isSettled(); }));
    QVERIFY(!hasNoVolume(*document().current()));
    QCOMPARE(rightsOf(*document().current()).licence, std::string("CC0 1.0"));
    QVERIFY(document().save().has_value());
    QVERIFY(validateCaseAside(document().current()->folder).empty());
    document().undo();
    QVERIFY(waitUntil([this] { return !session().subject() && window_->isSettled(); }));
    document().redo();
    QVERIFY(waitUntil([this] { return session().subject() && window_->isSettled(); }));
    keepScreenshot(*window_, "volume-given");
  }

  void whatLooksRealIsWarnedOfBesideItsFieldAndANameIsInvented() {
    showWindow();
    author(files_.writeCase(QStringLiteral("real")));
    auto* history = inPanel<QPlainTextEdit>("history");
    auto* warning = inPanel<QLabel>("history_warning");
    QVERIFY(warning->isHidden());
    history->setPlainText(QStringLiteral("Seen on 12.03.2021, call 030 1234567."));
    QVERIFY(!warning->isHidden());
    QVERIFY(warning->text().contains(QStringLiteral("12.03.2021")));
    QCOMPARE(document().current()->history, std::string("Seen on 12.03.2021, call 030 1234567."));  // a warning, no refusal
    history->setPlainText(QStringLiteral("Seen two years ago."));
    QVERIFY(warning->isHidden());
    const std::string before = document().current()->patient.name;
    inPanel<QPushButton>("inventName")->click();
    const std::string invented = document().current()->patient.name;
    QVERIFY(!invented.empty() && invented != before);
    QCOMPARE(inPanel<QLineEdit>("patient_name")->text(), QString::fromStdString(invented));
    QVERIFY(inPanel<QLabel>("patient_name_warning")->isHidden());
  }

  void imagesOfEarlierExaminationsAreKeptWithoutWhatTheirFilesSay() {
    QImage drawn(120, 80, QImage::Format_RGB32);
    drawn.fill(QColor(40, 90, 160));
    drawn.setText(QStringLiteral("Patient"), QStringLiteral("Somebody Real"));
    const QString file = files_.path(QStringLiteral("old.png"));
    QVERIFY(drawn.save(file));
    QVERIFY(QImageReader(file).text(QStringLiteral("Patient")).contains(QStringLiteral("Real")));
    const QString wrong = files_.path(QStringLiteral("wrong.png"));
    QVERIFY(writeFileSafely(wrong.toStdString(), "no image").has_value());
    showWindow();
    author(files_.writeCase(QStringLiteral("pictured")));
    inPanel<QPushButton>("addExamination")->click();
    for (const QString& chosen : {file, wrong, file}) {
      Answers answers({{QStringLiteral("fileDialog"), type(chosen)}});
      inPanel<QPushButton>("examination_0_addPictures")->click();
      QVERIFY(!answers.asked.isEmpty());
      QCOMPARE(inPanel<QLabel>("previous_examinations_problem")->isHidden(), chosen != wrong);
    }
    const auto& images = document().current()->previousExaminations.at(0).images;
    QCOMPARE(images.size(), std::size_t(1));
    const QString kept = QString::fromStdString((document().current()->folder / images.front()).string());
    QVERIFY(images.front().starts_with("media/"));
    QVERIFY(QImageReader(kept).textKeys().isEmpty());
    const QImage read(kept);
    QCOMPARE(read.size(), drawn.size());
    QCOMPARE(read.pixel(60, 40), drawn.pixel(60, 40));
    QVERIFY(inPanel<QLabel>("examination_0_picture_0") != nullptr);
    keepScreenshot(*window_, "pictures");
    QVERIFY(document().save().has_value());
    QVERIFY(validateCaseAside(document().current()->folder).empty());
    inPanel<QToolButton>("examination_0_removePicture_0")->click();
    QVERIFY(document().current()->previousExaminations.at(0).images.empty());
  }

  void presetsAndBodyMarksOfACaseAreOfferedAndTheFirstIsTaken() {
    showWindow();
    author(files_.writeCase(QStringLiteral("console")));
    auto* presets = inPanel<QListWidget>("presets");
    QVERIFY(presets != nullptr && presets->count() > 10);
    for (int n = 0; n < presets->count(); ++n)
      if (presets->item(n)->data(Qt::UserRole).toString() == QLatin1String("bladder-convex-3.5"))
        presets->item(n)->setCheckState(Qt::Checked);
    QVERIFY(presetsOf(*document().current()) == std::vector<std::string>{"bladder-convex-3.5"});
    QVERIFY(inPanel<QLabel>("presets_hint")->text().startsWith(QStringLiteral("At the start")));
    auto* marks = inPanel<QListWidget>("body_marks");
    marks->item(marks->count() - 1)->setCheckState(Qt::Checked);
    QCOMPARE(bodyMarksOf(*document().current()).size(), std::size_t(1));
    QVERIFY(document().save().has_value());
    QVERIFY(validateCaseAside(document().current()->folder).empty());
    const Knobs before = session().console().knobs();
    QVERIFY(openCase(QString::fromStdString(document().current()->folder.string())));
    QVERIFY(waitForRest());
    QVERIFY(!(session().console().knobs() == before));
    QCOMPARE(window_->bodyMark().offered().front()->id, bodyMarksOf(*document().current()).front());
  }

  void theListBeforePublishingLeadsToItsFieldsAndTheCaseIsPublishedExportedAndImported() {
    showWindow();
    const QString folder = files_.writeCase(QStringLiteral("published"));
    author(folder);
    QWidget* dialog = publishDialog();
    QVERIFY(dialog != nullptr);
    auto* now = dialog->findChild<QPushButton*>(QStringLiteral("publishNow"));
    QVERIFY(!now->isEnabled());
    keepScreenshot(*dialog, "publish-1-missing");
    QVERIFY(itemFor(*dialog, QStringLiteral("findings")) != nullptr);
    auto* head = inPanel<QToolButton>("head_findings");
    if (head->isChecked()) head->click();
    QVERIFY(!inPanel<QPlainTextEdit>("findings")->isVisible());
    itemFor(*dialog, QStringLiteral("findings"))->click();
    QVERIFY(waitUntil([this] { return inPanel<QPlainTextEdit>("findings")->isVisible(); }));
    // What is typed next is for the field, and not for a button of the list, which stays in sight: a space pressed Export.
    auto* findings = inPanel<QPlainTextEdit>("findings");
    QVERIFY2(waitUntil([&] { return QApplication::focusWidget() == findings; }),
             QApplication::focusWidget() != nullptr ? qPrintable(QApplication::focusWidget()->objectName()) : "nothing has the keys");
    QVERIFY(QApplication::activeWindow() == window_.get() && dialog->isVisible());
    {
      const Answers nothing({});
      QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("No stone."));
      QVERIFY2(nothing.asked.isEmpty(), qPrintable(nothing.asked.join(QLatin1Char(' '))));
    }
    QCOMPARE(findings->toPlainText(), QStringLiteral("No stone."));
    QVERIFY2(waitUntil([this] { return inPanel<QLabel>("missing_case")->text().contains(QStringLiteral("missing")); }),
             qPrintable(inPanel<QLabel>("missing_case")->text()));
    keepScreenshot(*window_, "publish-2-led");
    fill();
    QVERIFY(waitUntil([&] { return now->isEnabled(); }));
    keepScreenshot(*dialog, "publish-3-ready");
    now->click();
    auto* result = dialog->findChild<QLabel*>(QStringLiteral("publishResult"));
    QVERIFY(waitUntil([&] { return !result->isHidden(); }));
    QVERIFY2(result->text().startsWith(QStringLiteral("Published as revision 1")), qPrintable(result->text()));
    QVERIFY(!document().hasUnsavedChanges());
    const auto latest = latestPublished(libraryFolder(), document().current()->id);
    QVERIFY(latest.has_value());
    keepScreenshot(*dialog, "publish-4-done");
    now->click();
    QVERIFY(waitUntil([&] { return result->text().startsWith(QStringLiteral("Nothing has changed")); }));

    const QString bundle = files_.path(QStringLiteral("out.ewcase"));
    auto answers = std::make_unique<Answers>(std::map<QString, Answers::Answer>{{QStringLiteral("fileDialog"), type(bundle)}});
    dialog->findChild<QPushButton*>(QStringLiteral("exportCase"))->click();
    answers.reset();  // it would turn down the questions that follow
    QVERIFY(waitUntil([&] { return result->text().startsWith(QStringLiteral("Revision 1 was exported")); }));
    QVERIFY(verifyBundle(bundle.toStdString()).has_value());
    // The name is completed before it is asked about: "final" is "final.ewcase", which somebody has already.
    const QString others = files_.path(QStringLiteral("final.ewcase"));
    QVERIFY(writeFileSafely(others.toStdString(), "precious"));
    {
      const Answers keep({{QStringLiteral("fileDialog"), type(files_.path(QStringLiteral("final")))},
                          {QStringLiteral("replaceQuestion"), press(QMessageBox::Cancel)}});
      dialog->findChild<QPushButton*>(QStringLiteral("exportCase"))->click();
      QCOMPARE(keep.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("replaceQuestion")}));
    }
    QFile still(others);
    QVERIFY(still.open(QIODevice::ReadOnly) && still.readAll() == "precious");
    dialog->close();
    window_.reset();

    // Elsewhere: another home, a trainee.
    qputenv("ECHOWEAVE_LIBRARY", files_.path(QStringLiteral("elsewhere")).toUtf8());
    qputenv("ECHOWEAVE_CASES", files_.path(QStringLiteral("elsewhere/cases")).toUtf8());
    showWindow();
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return latestPublished(libraryFolder(), "window-test").has_value() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY2(window_->messages().text().contains(QStringLiteral("revision 1")), qPrintable(window_->messages().text()));
    QVERIFY(!window_->messages().text().contains(QStringLiteral("Window test")));  // a trainee reads the title for trainees
    auto* cards = find<QWidget>("caseCards");
    QVERIFY(cards != nullptr && cards->isVisible());
    auto* list = qobject_cast<CardView*>(cards);
    QVERIFY(waitUntil([&] { return list->currentIndex().isValid(); }));
    QCOMPARE(list->currentIndex().data().toString(), QStringLiteral("Upper abdomen, routine"));
    keepScreenshot(*window_, "imported");
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return window_->messages().text().contains(QStringLiteral("already")); }));

    // Published cases are saved as one's own.
    QVERIFY(openCase(QString::fromStdString(latestPublished(libraryFolder(), "window-test")->folder.string())));
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    inPanel<QLineEdit>("title")->setText(QString());
    QTest::keyClicks(inPanel<QLineEdit>("title"), QStringLiteral("Mine"));
    const auto refused = document().save();
    QVERIFY(!refused && refused.error().sentence().find("Published cases") != std::string::npos);
    Answers asked({{QStringLiteral("caseFolderDialog"), [](QWidget& shown) {
                      keepScreenshot(shown, "published-copy");
                      shown.findChild<QLineEdit*>(QStringLiteral("caseFolderName"))->setText(QStringLiteral("mine"));
                      shown.findChild<QPushButton*>(QStringLiteral("saveCaseFolder"))->click();
                    }}});
    inPanel<QPushButton>("save")->click();
    QVERIFY(asked.asked.contains(QStringLiteral("caseFolderDialog")));
    QCOMPARE(loadCaseAside(ownCasesFolder() / "mine")->title, std::string("Mine"));
    QVERIFY(verifyBundle(bundle.toStdString()).has_value());
    qputenv("ECHOWEAVE_LIBRARY", files_.path(QStringLiteral("library")).toUtf8());
    qputenv("ECHOWEAVE_CASES", files_.path(QStringLiteral("own cases")).toUtf8());
  }

  void aDamagedBundleIsRefusedInASentenceAndTheLibraryStays() {
    const QString bundle = files_.path(QStringLiteral("broken.ewcase"));
    QVERIFY(writeFileSafely(bundle.toStdString(), "this is no bundle").has_value());
    showWindow();
    const auto before = listPublished(libraryFolder());
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }));
    QVERIFY(window_->messages().text().contains(QStringLiteral("broken.ewcase")));
    QVERIFY(listPublished(libraryFolder()) == before);
  }

  void whatSomebodyElseEditsIsNotEditedHereButACopyIs() {
    const QString folder = files_.writeCase(QStringLiteral("theirs"));
    showWindow();
    author(folder);
    auto theirs = FolderLease::take(folder.toStdString());
    QVERIFY(theirs.has_value());
    auto* title = inPanel<QLineEdit>("title");
    title->setFocus();
    title->end(false);
    QTest::keyClicks(title, QStringLiteral("!"));
    QCOMPARE(document().current()->title, std::string("Window test"));
    QCOMPARE(title->text(), QStringLiteral("Window test"));
    auto* row = inPanel<QWidget>("takenRow");
    QVERIFY(row->isVisible());
    QVERIFY(inPanel<QLabel>("takenWhy")->text().contains(QStringLiteral("being edited by")));
    keepScreenshot(*window_, "taken");
    Answers answers({{QStringLiteral("caseFolderDialog"), [](QWidget& shown) {
                        shown.findChild<QLineEdit*>(QStringLiteral("caseFolderName"))->setText(QStringLiteral("a copy"));
                        shown.findChild<QPushButton*>(QStringLiteral("saveCaseFolder"))->click();
                      }}});
    inPanel<QPushButton>("openCopy")->click();
    QVERIFY(answers.asked.contains(QStringLiteral("caseFolderDialog")));
    QVERIFY(!row->isVisible());
    title->end(false);
    QTest::keyClicks(title, QStringLiteral("!"));
    QCOMPARE(document().current()->title, std::string("Window test!"));
    QVERIFY(document().save().has_value());
    QCOMPARE(loadCaseAside(folder.toStdString())->title, std::string("Window test"));
  }

  void theStartPageOffersToBeginACase() {
    showWindow();
    window_->setWorkspace(Workspace::author);
    window_->showStartPage();
    QVERIFY(waitForRest());
    auto* page = find<StartPage>("startPage");
    const auto buttons = page->findChildren<QPushButton*>(QStringLiteral("startBeginning"));
    QVERIFY(!buttons.isEmpty());
    const auto shown = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* each) { return each->isVisible(); });
    QVERIFY(shown != buttons.end());
    keepScreenshot(*window_, "start-page-author");
    (*shown)->click();
    QVERIFY(waitUntil([] { return topLevel("newCaseDialog") != nullptr; }));
  }

  void probesHaveTheNamesThatTheScanHas() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QCoreApplication::installTranslator(&german);
    showWindow();
    author(files_.writeCase(QStringLiteral("sonden")));
    const QString name = inPanel<QCheckBox>("probe_convex-3.5")->text();
    QCoreApplication::removeTranslator(&german);
    QCOMPARE(name, QStringLiteral("Konvex 3,5 MHz Abdomen"));
  }

  void everythingIsLegibleInGermanInASmallWindowAndInTheLight() {
    if (screenshotFolder().isEmpty()) QSKIP("images for a person to look at; set EW_SCREENSHOTS");
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QCoreApplication::installTranslator(&german);
    const QLocale before;
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    const QString folder = files_.writeCase(QStringLiteral("deutsch"));
    showWindow();
    window_->setDarkTheme(false);
    window_->resize(1024, 640);
    author(folder);
    keepScreenshot(*window_, "german-form");
    inPanel<QPlainTextEdit>("history")->setPlainText(QStringLiteral("Am 12.03.2021 gesehen."));
    inPanel<QPushButton>("addExamination")->click();
    inPanel<QPushButton>("addMeasurement")->click();
    keepScreenshot(*panel(), "german-panel");
    for (const char* section : {"measurements", "scan", "volume"}) {
      for (const char* other : {"case", "patient", "before", "findings", "measurements", "scan", "scene", "volume"}) {
        auto* head = panel()->findChild<QToolButton*>(QStringLiteral("head_") + QLatin1String(other));
        if (head->isChecked() != (QLatin1String(other) == QLatin1String(section))) head->click();
      }
      keepScreenshot(*panel(), (std::string("german-section-") + section).c_str());
    }
    for (auto* head : panel()->findChildren<QToolButton*>())
      if (head->isCheckable() && !head->isChecked()) head->click();
    QWidget* publish = publishDialog();
    QVERIFY(publish != nullptr);
    keepScreenshot(*publish, "german-publish");
    publish->close();
    action(QStringLiteral("Neuer Fall"))->trigger();
    QVERIFY(waitUntil([] { return topLevel("newCaseDialog") != nullptr; }));
    QWidget* dialog = topLevel("newCaseDialog");
    keepScreenshot(*dialog, "german-new-1");
    auto* next = dialog->findChild<QPushButton*>(QStringLiteral("newCaseNext"));
    dialog->findChild<QLineEdit*>(QStringLiteral("sourceFile"))->setText(folder + QStringLiteral("/volume.mha"));
    chooseFront(*dialog);
    keepScreenshot(*dialog, "german-new-1-side");
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    next->click();
    dialog->findChild<QLineEdit*>(QStringLiteral("newCaseTitle"))->setText(QStringLiteral("Zweiter Fall"));
    keepScreenshot(*dialog, "german-new-2");
    next->click();
    QVERIFY(waitUntil([&] { return next->isEnabled(); }));
    keepScreenshot(*dialog, "german-new-3");
    window_.reset();
    QCoreApplication::removeTranslator(&german);
    QLocale::setDefault(before);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::AuthoringTest)
#include "authoring_test.moc"
