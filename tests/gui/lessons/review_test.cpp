// An instructor in the real window reviews two attempts beside the expert's scan: scrubs, aligns, jumps, comments with a drawing, rates,
// changes a pass level, has everything scored anew, and looks at the class.
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QTranslator>
#include <QTreeWidget>
#include <cmath>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_scoring.h"
#include "ew/assessment/pseudonym.h"
#include "ew/assessment/rating.h"
#include "ew/assessment/review_comment.h"
#include "ew/assessment/standings.h"
#include "ew/widgets/apply_theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/panel_hand.h"
#include "gui/support/reviewed_case.h"
#include "gui/support/screenshots.h"
#include "gui/support/usability_walk.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class ReviewTest final : public WindowFixture {
  Q_OBJECT

  std::unique_ptr<ReviewedCase> case_;
  std::filesystem::path ann_, ben_;

  [[nodiscard]] PanelHand column() const { return PanelHand(find<QWidget>("reviewColumn")); }
  [[nodiscard]] PanelHand stage() const { return PanelHand(find<QWidget>("reviewStage")); }
  /// What cannot be clicked is asked of the plugin by name.
  [[nodiscard]] QObject* door() const { return find<QObject>("reviewDoor"); }
  [[nodiscard]] bool isIdle(const char* image) const {
    bool idle = false;
    QMetaObject::invokeMethod(door(), "isIdle", Qt::DirectConnection, Q_RETURN_ARG(bool, idle), Q_ARG(QString, QLatin1String(image)));
    return idle;
  }
  [[nodiscard]] bool isSettled() const {
    if (!window_->isSettled()) return false;
    for (const char* name : {"reviewedPicture", "comparedPicture"})
      if (stage().seen<QWidget>(name) != nullptr && !isIdle(name)) return false;
    QCoreApplication::processEvents();
    return true;
  }
  void settle() {
    QVERIFY(waitUntil([this] { return isSettled(); }));
  }
  void showTab(int tab) {
    auto* tabs = find<QTabWidget>("reviewTabs");
    QVERIFY(tabs);
    tabs->setCurrentIndex(tab);
    QCoreApplication::processEvents();
  }
  void keep(const char* name) {
    if (screenshotFolder().isEmpty()) return;
    settle();
    keepScreenshot(*window_, name);
  }
  [[nodiscard]] QStringList settingsOf(const char* image) const {
    QStringList lines;
    QMetaObject::invokeMethod(door(), "shownSettings", Qt::DirectConnection, Q_RETURN_ARG(QStringList, lines),
                              Q_ARG(QString, QLatin1String(image)));
    return lines;
  }
  [[nodiscard]] QPoint onImage(double lateral_mm, double axial_mm) const {
    QPointF at;
    QMetaObject::invokeMethod(door(), "pixelOfPoint", Qt::DirectConnection, Q_RETURN_ARG(QPointF, at), Q_ARG(double, lateral_mm),
                              Q_ARG(double, axial_mm));
    return at.toPoint();
  }
  void clickTime(double clock_s) {
    auto* tracks = stage().seen<QWidget>("reviewTracks");
    QVERIFY(tracks);
    double x = 0.0;
    QMetaObject::invokeMethod(door(), "pixelOfTime", Qt::DirectConnection, Q_RETURN_ARG(double, x), Q_ARG(double, clock_s));
    QTest::mouseClick(tracks, Qt::LeftButton, Qt::NoModifier, QPoint(static_cast<int>(std::lround(x)), 24));
    settle();
  }
  [[nodiscard]] QString time() const { return stage().text("reviewTime").section(QLatin1Char(' '), 0, 0); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    auto* tracks = stage().seen<QWidget>("reviewTracks");
    tracks->setFocus();
    QTest::keyClick(tracks, key, modifiers);
    QCoreApplication::processEvents();
  }

  /// Nothing is left of the test before.
  void beginAnew() const {
    QDir(files_.path(QStringLiteral("library"))).removeRecursively();
    QSettings().remove(QStringLiteral("review"));
  }
  /// A library with two attempts, and the window in front of them.
  void openReview(const QSize& size = {1280, 720}) {
    beginAnew();
    case_ = std::make_unique<ReviewedCase>(files_, QStringLiteral("reviewed"));
    showWindowWithCase(case_->folder());
    QVERIFY(case_->make(*session().probeControl().skin(), session().console().probe()));
    QVERIFY(case_->writeExpert({.person = {}, .seconds = 9.0, .tremor_mm = 0.4}));
    ann_ = case_->writeAttempt({.person = "Ann",
                                .seconds = 14.0,
                                .detour_mm = 35.0,
                                .miss_mm = 14.0,
                                .depth_mm = 160.0,
                                .gain = 1.5,
                                .tremor_mm = 3.0,
                                .losesContact = true,
                                .losesPose = true,
                                .score = 0.4},
                               1);
    ben_ = case_->writeAttempt({.person = "Ben", .seconds = 11.0, .detour_mm = 8.0, .miss_mm = 1.0, .tremor_mm = 1.0, .score = 0.9}, 2);
    QVERIFY(!ann_.empty() && !ben_.empty());
    window_.reset();
    showWindowWithCase(case_->folder());
    window_->resize(size);
    window_->openPlugins();
    window_->showWorkspace("review");
    QVERIFY(waitUntil([this] { return column().seen<QListWidget>("reviewAttempts") != nullptr; }));
    showTab(0);
    QVERIFY(waitUntil([this] { return isSettled() && column().seen<QListWidget>("reviewAttempts")->count() == 2; }));
  }
  void chooseAnn() {
    column().seen<QListWidget>("reviewAttempts")->setCurrentRow(1);  // the latest is first
    settle();
  }

 private Q_SLOTS:
  void cleanup() {
    window_.reset();
    QSettings().remove(QStringLiteral("textSize"));
    setTextSize(100);
  }

  void twoScansGoOnOneClockAndAligned() {
    openReview();
    if (QTest::currentTestFailed()) return;
    keep("review-01-ben");
    chooseAnn();
    QCOMPARE(column().seen<QComboBox>("reviewStep")->currentText(), QStringLiteral("Find the cyst"));
    QVERIFY(column().seen<QComboBox>("reviewCompared")->currentText().contains(QStringLiteral("How an expert finds it")));
    clickTime(5.0);
    QCOMPARE(time(), QStringLiteral("0:05.0"));
    const QStringList settings = settingsOf("reviewedPicture");
    QVERIFY2(settings.contains(QStringLiteral("≠ depth 16.0 cm")), qPrintable(settings.join(QLatin1Char('\n'))));
    QVERIFY(settings.contains(QStringLiteral("≠ gain × 1.50")));
    QVERIFY(settingsOf("comparedPicture").contains(QStringLiteral("≠ depth 12.0 cm")));
    keep("review-02-ann-one-clock");
    press(Qt::Key_T);
    settle();
    QVERIFY(stage().seen<QAbstractButton>("reviewAligned")->isChecked());
    keep("review-03-aligned");
    // The trainee's clock rules: at its end the expert's scan has ended as well.
    press(Qt::Key_End);
    settle();
    QCOMPARE(time(), QStringLiteral("0:14.0"));
    press(Qt::Key_T);
    QVERIFY(stage().seen<QAbstractButton>("reviewOneClock")->isChecked());
  }

  void keysMoveTheClock() {
    openReview();
    if (QTest::currentTestFailed()) return;
    press(Qt::Key_Home);
    QCOMPARE(time(), QStringLiteral("0:00.0"));
    press(Qt::Key_Right);
    QCOMPARE(time(), QStringLiteral("0:00.5"));
    press(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(time(), QStringLiteral("0:00.6"));
    press(Qt::Key_N);
    QCOMPARE(time(), QStringLiteral("0:02.0"));  // both set their depth then
    press(Qt::Key_N);
    QCOMPARE(time(), QStringLiteral("0:04.0"));  // the expert's mark
    press(Qt::Key_P);
    QCOMPARE(time(), QStringLiteral("0:02.0"));
    press(Qt::Key_BracketLeft);
    for (int n = 0; n < 4; ++n) press(Qt::Key_Right);
    press(Qt::Key_BracketRight);
    press(Qt::Key_Plus);
    QCOMPARE(stage().seen<QComboBox>("reviewSpeed")->currentData().toDouble(), 2.0);
    press(Qt::Key_Space);
    QVERIFY(waitUntil([this] { return time() == QStringLiteral("0:02.0") || time() > QStringLiteral("0:02.3"); }));
    press(Qt::Key_Space);
    QVERIFY2(time() >= QStringLiteral("0:02.0") && time() <= QStringLiteral("0:04.0"), "it stays within the loop");
    press(Qt::Key_H);
    QVERIFY(stage().seen<QComboBox>("reviewHeat")->currentIndex() == 1);
  }

  void anyTwoScansAreCompared() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    auto* compared = column().seen<QComboBox>("reviewCompared");
    const int other = compared->findText(QStringLiteral("T-"), Qt::MatchStartsWith);  // Ben's attempt, by its code
    QVERIFY(other > 0);
    compared->setCurrentIndex(other);
    Q_EMIT compared->activated(other);
    settle();
    press(Qt::Key_End);
    QCOMPARE(time(), QStringLiteral("0:14.0"));
    showTab(2);
    auto* figures = column().seen<QTableWidget>("reviewMetrics");
    if (auto* all = column().seen<QCheckBox>("reviewAllFigures")) all->setChecked(true);
    QVERIFY2(figures->item(0, 1)->text().startsWith(QStringLiteral("14")) && figures->item(0, 2)->text().startsWith(QStringLiteral("11")),
             qPrintable(figures->item(0, 1)->text() + figures->item(0, 2)->text()));
    // Nothing at all, and then the trainee's scan alone.
    showTab(0);
    compared->setCurrentIndex(0);
    Q_EMIT compared->activated(0);
    settle();
    QVERIFY(stage().seen<QAbstractButton>("reviewAligned") == nullptr);
    press(Qt::Key_Home);
    press(Qt::Key_End);
    QCOMPARE(time(), QStringLiteral("0:14.0"));
    // Another step of the attempt is another recording.
    auto* steps = column().seen<QComboBox>("reviewStep");
    const int cover = steps->findText(QStringLiteral("Sweep through all of it"));
    steps->setCurrentIndex(cover);
    Q_EMIT steps->activated(cover);
    settle();
    QCOMPARE(time(), QStringLiteral("0:00.0"));
    const int question = steps->findText(QStringLiteral("What is it? (not recorded)"));
    QVERIFY(question >= 0);
    steps->setCurrentIndex(question);
    Q_EMIT steps->activated(question);
    settle();
    QVERIFY2(stage().seen<QWidget>("reviewCommentText") == nullptr, "nothing to comment on");
  }

  void whatCannotBeOpenedIsSaidAndTheRestIsShown() {
    openReview();
    if (QTest::currentTestFailed()) return;
    QFile::remove(case_->folder() + QStringLiteral("/parts/lessons/scans/expert.seq.mha"));
    QVERIFY(writeFileSafely(case_->folder().toStdString() + "/parts/lessons/scans/expert.seq.mha", "no recording").has_value());
    chooseAnn();
    QVERIFY2(!settingsOf("reviewedPicture").isEmpty(), "the trainee's scan is there");
    QVERIFY2(settingsOf("comparedPicture").isEmpty(), "and the expert's is not");
    press(Qt::Key_End);
    QCOMPARE(time(), QStringLiteral("0:14.0"));
    keep("review-18-no-expert");
  }

  void regionsSaySeenAndMissed() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    press(Qt::Key_End);
    auto* heat = stage().seen<QComboBox>("reviewHeat");
    std::array<int, 5> shown{};
    const char* names[] = {"review-04-body", "review-05-seen-by-trainee", "review-06-seen-by-expert", "review-07-missed",
                           "review-08-neither"};
    for (int n = 0; n < 5; ++n) {
      heat->setCurrentIndex(n);
      QCoreApplication::processEvents();
      QMetaObject::invokeMethod(door(), "shownRegions", Qt::DirectConnection, Q_RETURN_ARG(int, shown[static_cast<std::size_t>(n)]));
      keep(names[n]);
    }
    QCOMPARE(shown[0], 0);
    QVERIFY(shown[1] > 500 && shown[2] > 500);
    QVERIFY2(shown[3] > 0 && shown[3] < shown[2], "what the expert saw and she did not");
    QVERIFY(shown[4] > 0);
  }

  void theBodyIsSeenAndTurns() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    auto* canvas = stage().seen<QWidget>("reviewBodyCanvas");
    QVERIFY(canvas != nullptr);
    const auto skinIn = [](const QImage& image) {
      int warm = 0;  // ground, box and cube are bluish
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) warm += qRed(image.pixel(x, y)) > qBlue(image.pixel(x, y)) + 8 ? 1 : 0;
      return warm;
    };
    const QImage before = canvas->grab().toImage();
    QVERIFY2(skinIn(before) > before.width() * before.height() / 20, qPrintable(QString::number(skinIn(before))));
    QSignalSpy drawn(canvas, SIGNAL(drawn()));
    const QPoint from = canvas->rect().center(), to = from + QPoint(60, 10);
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, from);
    QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, to);
    QVERIFY2(!window_->isSettled(), "before it is drawn");
    settle();
    QVERIFY(drawn.count() >= 1);
    const QImage turned = canvas->grab().toImage();
    QVERIFY(turned != before);
    QVERIFY(skinIn(turned) > before.width() * before.height() / 20);
  }

  void aCommentIsDrawnKeptAndTakenBack() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    showTab(1);
    column().type("reviewReviewer", QStringLiteral("Dr. Weiss"));
    QTest::keyClick(column().seen<QLineEdit>("reviewReviewer"), Qt::Key_Return);
    clickTime(10.0);
    stage().press("reviewCircle");
    auto* image = stage().seen<QWidget>("reviewedPicture");
    QTest::mousePress(image, Qt::LeftButton, Qt::NoModifier, onImage(0.0, 55.0));
    QTest::mouseMove(image, onImage(10.0, 60.0));
    QTest::mouseRelease(image, Qt::LeftButton, Qt::NoModifier, onImage(20.0, 65.0));
    stage().press("reviewArrow");
    QTest::mousePress(image, Qt::LeftButton, Qt::NoModifier, onImage(-40.0, 100.0));
    QTest::mouseRelease(image, Qt::LeftButton, Qt::NoModifier, onImage(-12.0, 68.0));
    stage().type("reviewCommentText", QStringLiteral("Here the cyst is cut off its middle: tilt less."));
    keep("review-09-drawing");
    stage().press("reviewAddComment");
    auto* list = column().seen<QListWidget>("reviewCommentList");
    QCOMPARE(list->count(), 1);
    QVERIFY(!std::filesystem::exists(commentsFileOf(ann_, "Dr. Weiss")));
    column().seen<QPlainTextEdit>("reviewCommentEdit")->setFocus();
    column().type("reviewCommentEdit", QStringLiteral("Tilt less here."));
    keep("review-10-comment");
    column().press("reviewRemoveComment");
    QCOMPARE(list->count(), 0);
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY2(waitUntil([&] { return list->count() == 1; }), "undo brings it back");
    column().press("reviewSaveComments");
    const auto kept = readComments(ann_, "Dr. Weiss");
    QVERIFY(kept);
    QCOMPARE(kept->comments.size(), std::size_t(1));
    QCOMPARE(kept->comments[0].text, std::string("Tilt less here."));
    QCOMPARE(kept->comments[0].strokes.size(), std::size_t(2));
    const auto& circle = kept->comments[0].strokes[0].points_mm;
    QVERIFY2(glm::distance(circle[0], glm::dvec2(0.0, 55.0)) < 1.0 && glm::distance(circle[1], glm::dvec2(20.0, 65.0)) < 1.0,
             "in mm of the image plane");
    QVERIFY(kept->comments[0].probeToWorld);
    clickTime(1.0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(0)).center());
    QCOMPARE(time(), QStringLiteral("0:10.0"));
    // Another attempt has none; hers come back.
    showTab(0);
    column().seen<QListWidget>("reviewAttempts")->setCurrentRow(0);
    settle();
    showTab(1);
    QCOMPARE(list->count(), 0);
  }

  void whatWasWrittenIsKeptWhateverIsChosenNext() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    const auto commentsOnAnn = [this] { return readComments(ann_, "Dr. Weiss")->comments.size(); };
    auto* attempts = column().seen<QListWidget>("reviewAttempts");
    auto* compared = column().seen<QComboBox>("reviewCompared");
    stage().type("reviewCommentText", QStringLiteral("Slower here."));
    stage().press("reviewAddComment");
    QVERIFY2(window_->messages().text().contains(QStringLiteral("Say who you are")), "nobody signs it");
    column().type("reviewReviewer", QStringLiteral("Dr. Weiss"));  // and does not press Enter
    stage().press("reviewAddComment");
    QVERIFY(stage().seen<QLineEdit>("reviewCommentText")->text().isEmpty());
    compared->setCurrentIndex(0);
    Q_EMIT compared->activated(0);
    settle();
    QCOMPARE(commentsOnAnn(), std::size_t(1));
    // One that was begun, when another attempt is chosen, and one written while that is opened still.
    stage().type("reviewCommentText", QStringLiteral("Begun."));
    attempts->setCurrentRow(0);
    QCOMPARE(commentsOnAnn(), std::size_t(2));
    stage().seen<QLineEdit>("reviewCommentText")->setText(QStringLiteral("Late."));
    stage().seen<QAbstractButton>("reviewAddComment")->click();
    settle();
    QCOMPARE(commentsOnAnn(), std::size_t(3));
    QVERIFY(!readComments(ben_, "Dr. Weiss") || readComments(ben_, "Dr. Weiss")->comments.empty());

    chooseAnn();
    showTab(3);
    const auto fields = [this](const char* begin) {
      std::vector<QWidget*> found;
      for (QWidget* each : find<QWidget>("reviewRating")->findChildren<QWidget*>())
        if (each->objectName().startsWith(QLatin1String(begin))) found.push_back(each);
      return found;
    };
    qobject_cast<QComboBox*>(fields("rating_")[0])->setCurrentIndex(3);
    qobject_cast<QLineEdit*>(fields("remark_")[1])->setText(QStringLiteral("Nothing to score yet"));
    column().type("ratingRemark", QStringLiteral("On the whole calm"));
    showTab(0);
    attempts->setCurrentRow(0);
    settle();
    chooseAnn();
    showTab(3);
    QCOMPARE(qobject_cast<QComboBox*>(fields("rating_")[0])->currentIndex(), 3);
    QCOMPARE(qobject_cast<QLineEdit*>(fields("remark_")[1])->text(), QStringLiteral("Nothing to score yet"));
    QCOMPARE(column().seen<QPlainTextEdit>("ratingRemark")->toPlainText(), QStringLiteral("On the whole calm"));
    QVERIFY(column().text("ratingKept").contains(QStringLiteral("draft")));
    qobject_cast<QComboBox*>(fields("rating_")[1])->setCurrentIndex(2);
    window_->close();
    QCOMPARE(everyRating(ann_).ratings.front().rating.items.size(), std::size_t(2));
    QVERIFY2(!everyRating(ann_).ratings.front().rating.items[1].isOpen, "what was typed last is in the draft");
  }

  void anInstructorRatesChangesAPassLevelAndLooksAtTheClass() {
    openReview();
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    // Codes in place of names, until they are asked for.
    auto* attempts = column().seen<QListWidget>("reviewAttempts");
    QVERIFY2(!attempts->item(1)->text().contains(QStringLiteral("Ann")), qPrintable(attempts->item(1)->text()));
    QVERIFY(attempts->item(1)->text().startsWith(QStringLiteral("T-")));
    showTab(2);
    auto* figures = column().seen<QTableWidget>("reviewMetrics");
    auto* all = column().seen<QCheckBox>("reviewAllFigures");
    QVERIFY2(all, "some figures are off by default");
    const int on = figures->rowCount();
    all->setChecked(true);
    QVERIFY(figures->rowCount() > on && figures->rowCount() > 5);
    QVERIFY(column().text("reviewVerdict").contains(QStringLiteral("40")));
    QVERIFY(!figures->item(0, 0)->toolTip().isEmpty());
    keep("review-11-figures");
    column().press("reviewScore");
    QVERIFY(waitUntil([this] { return isSettled() && latestScore(ann_) && latestScore(ben_); }));
    const auto before = latestScore(ben_);
    QVERIFY(before->of("find")->passLevel == 0.7);
    keep("review-12-scored");
    // What an attempt is called and worth here is what reports and records say.
    const auto codes = Pseudonyms::ofLibrary(libraryFolder());
    QVERIFY(codes);
    AttemptResults results(libraryFolder());
    for (const auto& folder : {ann_, ben_}) {
      const auto kept = AttemptFolder::open(folder);
      const AttemptResult result = aside([&] { return results.of(folder, kept->attempt()); });
      const QString first = QStringLiteral("%1 · %2 % · %3\n")
                                .arg(QString::fromStdString(codes->ofPerson(kept->attempt().person)))
                                .arg(std::lround(100.0 * *result.score()))
                                .arg(QString::fromStdString(verdictWord(result).english()));
      const QString steps = QStringLiteral("%1 of %2 passed").arg(result.stepsPassed).arg(result.stepsJudged);
      QVERIFY2(result.stepsJudged == 3, "reading and watching do not count");
      bool isThere = false;
      for (int row = 0; row < attempts->count(); ++row)
        isThere = isThere || (attempts->item(row)->text().startsWith(first) && attempts->item(row)->text().endsWith(steps));
      QVERIFY2(isThere, qPrintable(first + steps));
    }
    column().set("reviewLevel", 95.0);
    QVERIFY(waitUntil([this] { return isSettled() && latestScore(ben_)->planRevision == 1; }));
    QCOMPARE(latestScore(ben_)->of("find")->passLevel, 0.95);
    QVERIFY2(scoresOf(ben_).size() == 2, "the earlier score is kept");
    keep("review-13-pass-level");

    showTab(3);
    QVERIFY(column().text("ratingBlind").contains(QStringLiteral("Say who you are")));
    showTab(1);
    column().type("reviewReviewer", QStringLiteral("Dr. Weiss"));
    QTest::keyClick(column().seen<QLineEdit>("reviewReviewer"), Qt::Key_Return);
    showTab(3);
    QVERIFY(column().text("ratingBlind").contains(QStringLiteral("Blinded")));
    int rated = 0;
    for (QComboBox* each : find<QWidget>("reviewRating")->findChildren<QComboBox*>())
      if (each->objectName().startsWith(QStringLiteral("rating_"))) each->setCurrentIndex(1 + rated++ % 4 + 1);
    QVERIFY(rated >= 5);
    keep("review-14-rating");
    column().press("ratingFinish");
    const auto ratings = everyRating(ann_);
    QCOMPARE(ratings.ratings.size(), std::size_t(1));
    QVERIFY(ratings.ratings[0].rating.finished && ratings.ratings[0].rating.isBlinded());
    QVERIFY(column().text("ratingKept").contains(QStringLiteral("revision 1")));

    showTab(0);
    column().press("reviewClass");
    settle();
    QVERIFY(stage().text("classHardest").contains(QStringLiteral("Find the cyst")) || !stage().text("classHardest").isEmpty());
    auto* steps = stage().seen<QTreeWidget>("classSteps");
    QCOMPARE(steps->topLevelItemCount(), 3);
    keep("review-15-class");
    // Two groups of known standing suggest a level: two of each are needed.
    QVERIFY(stage().text("classSuggestion").contains(QStringLiteral("Two of each")));
    for (QComboBox* each : find<QTreeWidget>("classAttempts")->findChildren<QComboBox*>(QStringLiteral("classStanding")))
      each->setCurrentIndex(2);
    QVERIFY(stage().text("classSuggestion").contains(QStringLiteral("2 should pass")));
    // What is said of people is kept in the library, and taken back.
    const auto said = readStandings(libraryFolder());
    QVERIFY(said);
    QCOMPARE(said->size(), std::size_t(2));
    QVERIFY(standingIn(*said, ann_.filename().string()) == Standing::shouldPass);
    find<QTreeWidget>("classAttempts")->findChildren<QComboBox*>(QStringLiteral("classStanding")).front()->setCurrentIndex(0);
    QCOMPARE(readStandings(libraryFolder())->size(), std::size_t(1));
    QVERIFY(stage().text("classSuggestion").contains(QStringLiteral("Two of each")));
    stage().set("classLevel", 60.0);
    QVERIFY(waitUntil([this] { return isSettled() && latestScore(ben_)->of("find")->passLevel == 0.6; }));
    const QString page = files_.path(QStringLiteral("class.html")), own = files_.path(QStringLiteral("attempt.html")),
                  paper = files_.path(QStringLiteral("attempt.pdf"));
    QVERIFY(stage().seen<QPushButton>("classReport"));
    QMetaObject::invokeMethod(door(), "writeReportFile", Q_ARG(QString, page), Q_ARG(bool, true));
    QVERIFY(waitUntil([&] { return isSettled() && QFile::exists(page); }));
    QMetaObject::invokeMethod(door(), "writeReportFile", Q_ARG(QString, own), Q_ARG(bool, false));
    QVERIFY(waitUntil([&] { return isSettled() && QFile::exists(own); }));
    QFile read(own);
    QVERIFY(read.open(QIODevice::ReadOnly));
    const QByteArray text = read.readAll();
    QVERIFY2(text.contains("Find the cyst") && !text.contains("Ann"), "a code stands in place of the name");
    QMetaObject::invokeMethod(door(), "writeReportFile", Q_ARG(QString, paper), Q_ARG(bool, false));
    QVERIFY(waitUntil([&] { return isSettled() && QFile::exists(paper); }));
    QFile printed(paper);
    QVERIFY(printed.open(QIODevice::ReadOnly));
    QVERIFY(printed.read(5) == "%PDF-");
    if (!screenshotFolder().isEmpty()) {
      QFile::copy(paper, screenshotFolder() + QStringLiteral("/review-attempt.pdf"));
      QFile::copy(page, screenshotFolder() + QStringLiteral("/review-class.html"));
    }
    stage().press("classBack");
    QVERIFY(stage().seen<QWidget>("reviewedPicture"));
  }

  void everyPageFitsHasNamesAndIsReachedInBothLanguages_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("text_percent");
    QTest::addColumn<QSize>("size");
    QTest::newRow("English") << QStringLiteral("en") << 100 << QSize(1280, 720);
    QTest::newRow("German") << QStringLiteral("de") << 100 << QSize(1280, 720);
    QTest::newRow("German, large words") << QStringLiteral("de") << 200 << QSize(1366, 768);
  }
  void everyPageFitsHasNamesAndIsReachedInBothLanguages() {
    QFETCH(QString, language);
    QFETCH(int, text_percent);
    QFETCH(QSize, size);
    QSettings().setValue(QStringLiteral("textSize"), text_percent);
    QTranslator german;
    if (language == QLatin1String("de")) {
      QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
      QVERIFY(QApplication::installTranslator(&german));
      QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    }
    openReview(size);
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    showTab(1);
    column().type("reviewReviewer", QStringLiteral("Dr. Weiss"));
    QTest::keyClick(column().seen<QLineEdit>("reviewReviewer"), Qt::Key_Return);
    stage().type("reviewCommentText", QStringLiteral("Look here."));
    stage().press("reviewAddComment");
    QStringList wrong;
    const auto look = [&](const char* page) {
      settle();
      if (window_->width() > size.width() || window_->height() > size.height())
        wrong << QLatin1String(page) + QStringLiteral(" makes the window larger") << wideWidgets(*window_, size.width());
      for (const QString& each : cutTexts(*window_)) wrong << QLatin1String(page) + QStringLiteral(", cut: ") + each;
      for (const QString& each : namelessControls(*window_)) wrong << QLatin1String(page) + QStringLiteral(", without a name: ") + each;
      for (const QScrollBar* each : find<QWidget>("panel_review")->findChildren<QScrollBar*>())
        if (each->orientation() == Qt::Horizontal && each->isVisible())
          wrong << QLatin1String(page) + QStringLiteral(" is read sideways: ") + nameOf(*each);
      const std::string name = "review-" + language.toStdString() + (text_percent > 100 ? "-large-" : "-") + page;
      keep(name.c_str());
    };
    const char* pages[] = {"scans", "comments", "scores", "rating"};
    for (int n = 0; n < 4; ++n) {
      showTab(n);
      if (n == 2) column().seen<QTableWidget>("reviewMetrics")->selectRow(0);
      look(pages[n]);
    }
    showTab(0);
    column().press("reviewClass");
    look("class");
    stage().press("classBack");
    QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
    window_.reset();
    if (language == QLatin1String("de")) QApplication::removeTranslator(&german);
    QLocale::setDefault(QLocale::c());
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
  }

  void nothingToReviewSaysSo() {
    beginAnew();
    showWindowWithCase(files_.writeCase(QStringLiteral("empty")));
    window_->openPlugins();
    window_->showWorkspace("review");
    QVERIFY(waitUntil([this] { return stage().seen<QPushButton>("reviewLookAgain") != nullptr; }));
    keep("review-16-empty");
  }

  void aShippedCasesExpertIsFrameBeforeAnybodyTried() {
    beginAnew();
    const auto shipped = shippedCasesFolder();
    QVERIFY(shipped);
    showWindowWithCase(QString::fromStdString((*shipped / "liver-sweep-recorded").string()));
    window_->openPlugins();
    window_->showWorkspace("review");
    QVERIFY(waitUntil([this] {
      return column().seen<QComboBox>("reviewLesson") != nullptr && isSettled() && column().seen<QComboBox>("reviewLesson")->count() > 0;
    }));
    QVERIFY(waitUntil([this] { return isSettled() && !settingsOf("comparedPicture").isEmpty(); }));
    QVERIFY2(settingsOf("reviewedPicture").isEmpty(), "nobody has tried it");
    press(Qt::Key_N);
    settle();
    QVERIFY2(time() > QStringLiteral("0:00.0"), "to what the expert marked");
    stage().seen<QComboBox>("reviewHeat")->setCurrentIndex(2);
    keep("review-19-shipped");
  }

  void aLargeAndALightWindowFit() {
    openReview({1920, 1080});
    if (QTest::currentTestFailed()) return;
    chooseAnn();
    clickTime(6.0);
    applyTheme(lightTheme());
    keep("review-17-light");
    applyTheme(darkTheme());
    QVERIFY(stage().seen<QWidget>("reviewTracks")->width() > 1000);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ReviewTest)
#include "review_test.moc"
