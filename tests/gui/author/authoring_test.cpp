// An author in the real window: makes cases from a sweep and from nothing, gives a volume, is warned of what looks real.
// EW_SCREENSHOTS=DIR keeps images of every step.
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
#include <QToolButton>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/case_start.h"
#include "ew/library/new_case.h"
#include "ew/library/placing.h"
#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/answers.h"
#include "gui/support/author_fixture.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

class AuthoringTest : public AuthorFixture {
  Q_OBJECT

  using json = nlohmann::json;
  int made_ = 0;

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
