// What a trainee sees of a case and of the window: no answers before the examination, the scan large, and every place with a way back.
#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QTranslator>
#include <algorithm>

#include "ew/library/case.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/start.h"
#include "ew/ui_test_door/window.h"
#include "ew/widgets/figures.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class TraineeTest : public WindowFixture {
  Q_OBJECT

 private:
  /// The usual test case, with everything a trainee may and may not read before the examination.
  [[nodiscard]] QString writeTold() const {
    const QString folder = files_.writeCase(QStringLiteral("gall stone folder"));
    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    opened->title = "Gall stone";
    opened->titleForTrainees = "Pain after meals";
    opened->previousExaminations = {{"two years ago", "ultrasound", "Nothing found."}};
    opened->findings = {"One stone with a bright front."};
    opened->diagnosis = "Solitary stone.";
    opened->targets = {{.kind = CaseTarget::Kind::plane, .name = "long axis", .probeToFile = Transform<frame::File, frame::Probe>{}},
                       {.kind = CaseTarget::Kind::point, .name = "the stone", .at_mm = glm::dvec3(0.0), .revealsFinding = true}};
    return saveCase(*opened, folder.toStdString()) ? folder : QString();
  }
  [[nodiscard]] QString shownTexts() const {
    QStringList texts;
    for (const QLabel* label : find<QWidget>("caseInfo")->findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('\n'));
  }
  [[nodiscard]] bool says(const QString& text) const { return shownTexts().contains(text); }
  void drag(QWidget* target, const QPoint& from, const QPoint& to) const {
    QTest::mousePress(target, Qt::LeftButton, Qt::NoModifier, from);
    // A splitter asks where on the screen the pointer is; without that it would be where the last one left it.
    QMouseEvent move(QEvent::MouseMove, to, target->mapToGlobal(to), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &move);
    QTest::mouseRelease(target, Qt::LeftButton, Qt::NoModifier, to);
    QTest::qWait(30);
  }
  [[nodiscard]] double bodyShare() const {
    const int body = find<QWidget>("bodyColumn")->width();
    return static_cast<double>(body) / (body + window_->scanView().width());
  }
  [[nodiscard]] int fanWidth_px() const {
    int widest = 0;
    for (const auto& row : session().seen().spans()) {
      if (!row.empty()) widest = std::max(widest, row.back().end - row.front().begin);
    }
    return widest;
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    showWindowWithCase(writeTold());
  }
  void cleanup() { window_.reset(); }

  void nothingOutsideOfAuthorNamesTheFinding() {
    QCOMPARE(find<QLabel>("title")->toolTip(), QStringLiteral("Pain after meals"));
    QVERIFY(!window_->windowTitle().contains(QLatin1String("stone"), Qt::CaseInsensitive));
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->findChild<QPushButton*>(QStringLiteral("recentFile")) != nullptr; }));
    const auto recent = window_->findChildren<QPushButton*>(QStringLiteral("recentFile"));
    QCOMPARE(recent.size(), 1);
    QCOMPARE(recent.front()->text(), QStringLiteral("Pain after meals"));
    QVERIFY(!recent.front()->toolTip().contains(QLatin1String("stone")));
    for (const QAction* action : window_->findChildren<QAction*>()) {
      const QString words = action->text() + action->toolTip();
      QVERIFY2(!words.contains(QLatin1String("gall stone"), Qt::CaseInsensitive), qPrintable(words));
    }
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    const QAbstractItemModel* cards = find<QAbstractItemView>("caseCards")->model();
    QVERIFY(cards->rowCount() > 0);
    for (int row = 0; row < cards->rowCount(); ++row) {
      for (const int role : {Qt::DisplayRole, Qt::AccessibleTextRole}) {
        const QString text = cards->data(cards->index(row, 0), role).toString();
        for (const char* answer : {"aneurysm", "stone", "fluid", "nodule", "normal"})
          QVERIFY2(!text.contains(QLatin1String(answer), Qt::CaseInsensitive), qPrintable(text));
      }
    }
    window_->setWorkspace(Workspace::author);
    QCOMPARE(find<QLabel>("title")->toolTip(), QStringLiteral("Gall stone"));
    window_->showStartPage();
    QCOMPARE(window_->findChildren<QPushButton*>(QStringLiteral("recentFile")).front()->text(), QStringLiteral("Gall stone"));
  }

  void theCaseStandsBelowTheBodyAndKeepsItsFindingsUntilAsked() {
    auto* info = find<CaseInfo>("caseInfo");
    QVERIFY(info != nullptr && info->isVisible());
    QVERIFY2(find<QWidget>("caseInfoHead")->height() + 1 == info->headHeight_px(), "the line to fold it is as high as it is meant");
    for (const char* words : {"Test Person", "female", "40 years", "To be looked at.", "two years ago", "Nothing found.", "long axis"}) {
      QVERIFY2(says(QLatin1String(words)), words);
    }
    for (const char* words : {"bright front", "Solitary", "the stone"}) QVERIFY2(!says(QLatin1String(words)), words);
    QTest::mouseClick(find<QPushButton>("showFindings"), Qt::LeftButton);
    QVERIFY(waitUntil([this] { return says(QStringLiteral("Solitary stone.")); }));
    QVERIFY(says(QStringLiteral("the stone")) && says(QStringLiteral("One stone with a bright front.")));
    // Another case begins without findings, and so does this one when it is opened again.
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(waitUntil([this] { return says(QStringLiteral("None.")); }));
    QVERIFY(!says(QStringLiteral("Solitary")) && !says(QStringLiteral("Healthy.")));
  }

  void tickedEntriesStayTickedAndTheFoldIsRemembered() {
    auto* box = find<QCheckBox>("caseInfoItem");
    QVERIFY(box != nullptr && !box->isChecked());
    box->click();
    QTest::mouseClick(find<QPushButton>("showFindings"), Qt::LeftButton);
    QVERIFY(waitUntil([this] { return says(QStringLiteral("Solitary stone.")); }));
    QVERIFY(find<QCheckBox>("caseInfoItem")->isChecked());
    auto* info = find<CaseInfo>("caseInfo");
    const int open_px = info->height();
    QTest::mouseClick(find<QPushButton>("caseInfoHead"), Qt::LeftButton);
    QVERIFY(waitUntil([info, open_px] { return info->height() < open_px / 2; }));
    window_.reset();
    showWindowWithCase(writeTold());
    QVERIFY(!find<CaseInfo>("caseInfo")->isOpen());
  }

  void theScanTakesTwoThirdsUntilTheBorderIsMovedAndThatIsKept() {
    QTest::qWait(50);
    QVERIFY2(std::abs(bodyShare() - ViewColumns::kBodyShare) < 0.03, qPrintable(QString::number(bodyShare())));
    auto* columns = qobject_cast<QSplitter*>(find<QWidget>("bodyColumn")->parentWidget());
    QVERIFY(columns != nullptr && columns->handleWidth() >= 5);
    QSplitterHandle* handle = columns->handle(2);
    const QPoint from = handle->rect().center();
    drag(handle, from, from + QPoint(120, 0));
    const double moved = bodyShare();
    QVERIFY2(moved > ViewColumns::kBodyShare + 0.05, qPrintable(QString::number(moved)));
    window_->resize(1500, 800);
    QTest::qWait(50);
    QVERIFY2(std::abs(bodyShare() - moved) < 0.03, qPrintable(QString::number(bodyShare())));
    window_.reset();
    showWindowWithCase(writeTold());
    QTest::qWait(50);
    QVERIFY2(std::abs(bodyShare() - moved) < 0.03, qPrintable(QString::number(bodyShare())));
  }

  void aSmallWindowHasANarrowBodyAndADoubleClickSwapsIt() {
    window_->resize(1024, 640);
    QTest::qWait(80);
    QVERIFY2(find<QWidget>("bodyColumn")->width() < 300, qPrintable(QString::number(find<QWidget>("bodyColumn")->width())));
    const int small_px = window_->scanView().width();
    View3D& view = window_->view3d();
    const Hold before = session().probeControl().hold();
    const QPoint onSkin = view.pixelOf(before.contact.point_mm).toPoint() + QPoint(30, 40);
    QTest::mouseClick(view.canvas(), Qt::LeftButton, Qt::NoModifier, onSkin);
    QTest::mouseDClick(view.canvas(), Qt::LeftButton, Qt::NoModifier, onSkin);
    QTest::qWait(80);
    QVERIFY(window_->scanView().width() < small_px);
    QVERIFY(find<QWidget>("bodyColumn")->width() > window_->scanView().width());
    QTest::mouseDClick(&window_->scanView(), Qt::LeftButton, Qt::NoModifier, window_->scanView().rect().center());
    QTest::qWait(80);
    QCOMPARE(window_->scanView().width(), small_px);
    window_->resize(1280, 720);
    QTest::qWait(80);
    QTest::mouseDClick(&window_->scanView(), Qt::LeftButton, Qt::NoModifier, window_->scanView().rect().center());
    QTest::qWait(50);
    QVERIFY2(std::abs(bodyShare() - ViewColumns::kBodyShare) < 0.03, "a window with room for both swaps nothing");
  }

  void aDoubleClickThatSwapsDoesNotMoveTheProbe() {
    window_->resize(1024, 640);
    QTest::qWait(80);
    View3D& view = window_->view3d();
    const Hold before = session().probeControl().hold();
    const QPoint at = view.pixelOf(before.contact.point_mm).toPoint() + QPoint(28, 36);
    QTest::mousePress(view.canvas(), Qt::LeftButton, Qt::NoModifier, at);
    QTest::mouseRelease(view.canvas(), Qt::LeftButton, Qt::NoModifier, at);
    QMouseEvent twice(QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view.canvas(), &twice);
    QVERIFY(session().probeControl().hold() == before);
  }

  void scanOnlyShowsNothingElseAndComesBack() {
    const int before_px = window_->scanView().width();
    QTest::keyClick(&window_->scanView(), Qt::Key_F12);
    QTest::qWait(50);
    QVERIFY(!window_->view3d().isVisible() && !window_->console().isVisible());
    QVERIFY(window_->scanView().width() > before_px * 3 / 2);
    const Hold hold = session().probeControl().hold();
    QTest::keyClick(&window_->scanView(), Qt::Key_Right);
    QVERIFY2(!(session().probeControl().hold() == hold), "the keys of the probe work on");
    QTest::keyClick(&window_->scanView(), Qt::Key_Escape);
    QTest::qWait(50);
    QVERIFY(window_->view3d().isVisible() && window_->console().isVisible());
    QCOMPARE(window_->scanView().width(), before_px);
    QTest::keyClick(&window_->scanView(), Qt::Key_F12);
    window_->setWorkspace(Workspace::author);
    QVERIFY2(window_->view3d().isVisible(), "an author's panels come with the body");
  }

  void slidersAndScaleStandInTheBlackCornersOfASector() {
    window_->resize(1024, 640);
    QTest::qWait(80);
    session().makeImageNow();
    const int beside_px = window_->scanView().width() - 88 - 64;
    QVERIFY2(fanWidth_px() > beside_px, qPrintable(QStringLiteral("%1 of %2").arg(fanWidth_px()).arg(beside_px)));
  }

  void noSliderOfTheTgcLiesOnTheFan() {
    for (const QSize& size : {QSize(1024, 640), QSize(1280, 720), QSize(1600, 900)})
      for (const char* probe : {"convex-3.5", "phased-2.5", "microconvex-6", "linear-7.5"}) {
        window_->resize(size);
        session().console().chooseProbe(probe);
        QTest::qWait(30);
        session().makeImageNow();
        const QRect box = window_->scanView().imageRect();
        const Spans fan = session().seen().spans();
        const auto* column = find<QWidget>("dgcColumn");
        for (int n = 1; n <= kDgcSliders; ++n) {
          const auto* slider = find<QSlider>(qPrintable(QStringLiteral("dgc%1").arg(n)));
          if (!slider->isVisible()) continue;
          const QRect at = slider->geometry().translated(column->pos());
          for (int y = std::max(at.top(), box.top()); y <= std::min(at.bottom(), box.bottom()); ++y) {
            const auto& runs = fan[static_cast<std::size_t>(y - box.top())];
            if (runs.empty()) continue;
            QVERIFY2(
                at.right() < box.left() + runs[0].begin,
                qPrintable(QStringLiteral("%1, %2 x %3: slider %4").arg(QLatin1String(probe)).arg(size.width()).arg(size.height()).arg(n)));
          }
        }
      }
  }

  void onAZoomedImageSlidersAndBodyMarkGiveWay() {
    ScanView& scan = window_->scanView();
    QVERIFY(find<QSlider>("dgc4")->isVisible());
    for (int i = 0; i < 4; ++i) QTest::keyClick(&scan, Qt::Key_Z);
    QTest::mouseMove(&scan, scan.rect().center());
    QTest::qWait(20);
    QVERIFY(!find<QWidget>("dgcColumn")->isVisible());
    QVERIFY(!find<QWidget>("bodyMark")->isVisible());
    QTest::mouseMove(&scan, QPoint(20, scan.height() / 2));
    QTest::qWait(20);
    QVERIFY2(find<QWidget>("dgcColumn")->isVisible(), "they come when the pointer is at them");
    session().console().setDetail(1.0, {});
    QTest::mouseMove(&scan, scan.rect().center());
    QTest::qWait(20);
    QVERIFY(find<QSlider>("dgc4")->isVisible());
  }

  void thePageOfKeysScrollsInASmallWindowAndHasAButtonToCloseIt() {
    window_->resize(1024, 640);
    QTest::qWait(50);
    QTest::keyClick(&window_->scanView(), Qt::Key_F1);
    auto* page = find<QFrame>("overlay");
    QVERIFY(page != nullptr && page->isVisible());
    QVERIFY(page->parentWidget()->rect().contains(page->geometry()));
    auto* scroll = page->findChild<QScrollArea*>();
    QVERIFY(scroll != nullptr && scroll->verticalScrollBar()->maximum() > 0);
    QVERIFY2(scroll->horizontalScrollBar()->maximum() == 0, "nothing beyond the right edge");
    for (const QLabel* label : page->findChildren<QLabel*>()) {
      QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->text()));
      static const QRegularExpression save(QStringLiteral("Ctrl\\+S(?!hift)"));
      QVERIFY2(!label->text().contains(save) && !label->text().contains(QLatin1String("cubic")), "an author's line on a trainee's page");
    }
    QTest::keyClick(page, Qt::Key_PageDown);
    QVERIFY(scroll->verticalScrollBar()->value() > 0 && page->isVisible());
    QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("closeKeys")), Qt::LeftButton);
    QVERIFY(waitUntil([this] { return find<QFrame>("overlay") == nullptr; }));
    window_->setWorkspace(Workspace::author);
    QTest::keyClick(&window_->scanView(), Qt::Key_F1);
    const auto labels = find<QFrame>("overlay")->findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) { return label->text().contains(QLatin1String("Ctrl+S")); }));
  }

  void aDragMovesTheProbeUntilTheImageIsZoomedAndThenTheDetail() {
    ScanView& scan = window_->scanView();
    const QPoint middle = scan.imageRect().center();
    Hold before = session().probeControl().hold();
    QCOMPARE(scan.cursor().shape(), Qt::SizeAllCursor);
    drag(&scan, middle, middle + QPoint(30, 0));
    QVERIFY(!(session().probeControl().hold() == before));
    for (int i = 0; i < 4; ++i) QTest::keyClick(&scan, Qt::Key_Z);
    session().makeImageNow();
    QCOMPARE(scan.cursor().shape(), Qt::OpenHandCursor);
    before = session().probeControl().hold();
    const auto shownAt = [this](const QPoint& at) {
      const QPointF pixel = QPointF(at - window_->scanView().imageRect().topLeft()) * window_->devicePixelRatioF();
      return session().geometry().probePoint_mm(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    };
    const glm::dvec2 taken_mm = shownAt(middle);
    drag(&scan, middle, middle + QPoint(40, -24));
    session().makeImageNow();
    QVERIFY2(session().probeControl().hold() == before, "the probe stays where it is");
    QVERIFY2(glm::distance(shownAt(middle + QPoint(40, -24)), taken_mm) < 1.5 * session().geometry().pixel_mm,
             "what was taken lies under the pointer");
    drag(&scan, middle, middle + QPoint(4000, 4000));
    session().makeImageNow();
    QVERIFY2(fanWidth_px() > 0, "the fan cannot be dragged out of sight");
  }

  void theFrozenProbeSaysWhyItDoesNotMove() {
    QTest::keyClick(&window_->scanView(), Qt::Key_F);
    const Hold before = session().probeControl().hold();
    QVERIFY(window_->scanView().said().isEmpty());
    QTest::keyClick(&window_->scanView(), Qt::Key_Up);
    QVERIFY(session().probeControl().hold() == before);
    QVERIFY2(window_->scanView().said().contains(QLatin1String("frozen")), qPrintable(window_->scanView().said()));
  }

  void theStartPageLeadsBackToTheOpenCaseWithoutLoadingItAnew() {
    const auto volume = session().subject()->voxels.volume();
    const Hold moved = turned(session().probeControl().hold(), 0.2, 0.0, 0.0);
    session().probeControl().setHold(moved);
    window_->showStartPage();
    QVERIFY(!find<QLabel>("position")->isVisible() && !find<QLabel>("contact")->isVisible());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QVERIFY(window_->scanView().isVisible() && find<QLabel>("position")->isVisible());
    window_->showStartPage();
    QTest::mouseClick(find<QPushButton>("startBack"), Qt::LeftButton);
    QVERIFY(window_->scanView().isVisible());
    window_->showStartPage();
    Q_EMIT find<StartPage>("startPage")->caseChosen(QString::fromStdString(window_->document().current()->folder.string()));
    QVERIFY(window_->scanView().isVisible());
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));  // the page's images may still be loading
    QVERIFY(session().subject()->voxels.volume() == volume && session().probeControl().hold() == moved);
  }

  void recentFilesAreNotTheCardsAgainAndOpenWithEnter() {
    const auto shipped = listCasesAside(*shippedCasesFolder()).cases;
    QVERIFY(!shipped.empty());
    const QString other = files_.writeCase(QStringLiteral("other"));
    QVERIFY(openCase(other));
    QStringList recent = QSettings().value(QStringLiteral("recent")).toStringList();
    recent.prepend(QString::fromStdString(shipped.front().folder.string()));
    QSettings().setValue(QStringLiteral("recent"), recent);
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    const auto buttons = window_->findChildren<QPushButton*>(QStringLiteral("recentFile"));
    QCOMPARE(buttons.size(), 2);
    auto* first = *std::find_if(buttons.begin(), buttons.end(),
                                [](const QPushButton* button) { return button->text() == QLatin1String("Pain after meals"); });
    first->setFocus();
    QTest::keyClick(first, Qt::Key_Return);
    QVERIFY(waitUntil([this] { return session().subject()->title == "Pain after meals" && window_->isSettled(); }));
  }

  void aTraineeReadsNoTimesOfFramesAndAnAuthorDoes() {
    QVERIFY(!find<QLabel>("plan")->isVisible());
    QVERIFY(!find<QPushButton>("qualityCubic")->isVisible() && find<QPushButton>("qualityFine")->isVisible());
    QVERIFY(find<QPushButton>("qualityFine")->isChecked());
    QTest::mouseClick(find<QPushButton>("qualityFast"), Qt::LeftButton);
    QCOMPARE(static_cast<int>(session().console().knobs().quality), static_cast<int>(Quality::weave));
    QTest::mouseClick(find<QPushButton>("advanced"), Qt::LeftButton);
    QVERIFY(find<QPushButton>("qualityCubic")->isVisible());
    window_->setWorkspace(Workspace::author);
    QVERIFY(find<QLabel>("plan")->isVisible());
  }

  void unsavedChangesStandBesideThePatientAndNotInPlaceOfTheName() {
    Case changed = *window_->document().current();
    changed.history = "Changed.";
    QVERIFY(window_->document().edit(changed, "Change the history", "history").has_value());
    const QString remark = find<QLabel>("titleRemark")->text();
    QVERIFY2(remark.contains(QLatin1String("Test Person")) && remark.contains(QLatin1String("unsaved")), qPrintable(remark));
    window_->document().undo();
    QCOMPARE(find<QLabel>("titleRemark")->text(), QStringLiteral("Test Person"));
  }

  void aSavedImageSaysWhichSideIsWhichAndWhoScanned() {
    const QDateTime at(QDate(2026, 11, 23), QTime(3, 4));
    const auto marker = [&] {
      const QImage saved = savedImage(session(), at);
      const int row = saved.height() - session().image().height() - 32 - 7, left = (saved.width() - session().image().width() - 56) / 2;
      int first = -1, last = -1;
      for (int x = 0; x < saved.width(); ++x)
        if (qGray(saved.pixel(x, row)) > 200) {
          last = x;
          if (first < 0) first = x;
        }
      return first < 0 ? -1 : (first + last) / 2 - left;
    };
    const double middle = session().geometry().face_px.x;
    const int before = marker();
    QVERIFY2(before >= 0, "there is a marker");
    QVERIFY(session().geometry().markerLeft == (before < middle));
    Knobs knobs = session().console().knobs();
    knobs.markerLeft = !knobs.markerLeft;
    session().console().setKnobs(knobs);
    session().makeImageNow();
    const int after = marker();
    QVERIFY2(after >= 0 && (after < middle) != (before < middle), "it changes sides with the image");
    OnImage on;
    on.person = QStringLiteral("Anna");
    QVERIFY(savedImage(session(), at, on) != savedImage(session(), at));
  }

  void aSavedImageHoldsTheImageItsScaleWhatItShowsAndTheWarning() {
    const ImageView<const std::uint8_t> shown = session().image().grey;
    const QDateTime at(QDate(2026, 11, 23), QTime(3, 4));
    const QImage saved = savedImage(session(), at);
    QCOMPARE(saved.format(), QImage::Format_Grayscale8);
    QVERIFY(saved.width() > shown.width && saved.height() > shown.height);
    // Somewhere in it the image lies, pixel for pixel: found by its brightest row.
    const int left = (saved.width() - shown.width - 56) / 2;
    const int top = saved.height() - shown.height - 32;
    for (int y = 0; y < shown.height; ++y)
      QVERIFY(std::equal(shown.row(y), shown.row(y) + shown.width, saved.constScanLine(top + y) + left));
    const auto lit = [&](const QRect& box) {
      int count = 0;
      for (int y = box.top(); y <= box.bottom(); ++y) {
        count += static_cast<int>(std::count_if(saved.constScanLine(y) + box.left(), saved.constScanLine(y) + box.right() + 1,
                                                [](std::uint8_t grey) { return grey > 60; }));
      }
      return count;
    };
    QVERIFY2(lit({0, 0, saved.width() / 2, 24}) > 50, "title");
    QVERIFY2(lit({saved.width() / 2, 0, saved.width() / 2, 24}) > 50, "date");
    QVERIFY2(lit({0, 24, saved.width(), 22}) > 100, "probe and settings");
    QVERIFY2(lit({left + shown.width, top, saved.width() - left - shown.width, shown.height}) > 100, "depth scale");
    // The words are the door's: only what leaves the program carries them, and all of it does.
    const QString file = files_.path(QStringLiteral("shown.png"));
    QVERIFY(writeShownImages({{&session(), {}, {}}}, 1, at, file.toStdString()).has_value());
    const QImage written(file);
    QCOMPARE(written.size(), saved.size());
    int words = 0;
    for (int y = 0; y < written.height(); ++y) {
      for (int x = 0; x < written.width(); ++x) {
        const bool differs = qGray(written.pixel(x, y)) != qGray(saved.pixel(x, y));
        QVERIFY2(!differs || y >= saved.height() - 28, "above its lower edge it is as it is shown");
        words += differs ? 1 : 0;
      }
    }
    QVERIFY2(words > 200, "simulation, not for diagnosis");
  }

  void aThumbnailIsKeptUntilTheCaseChanges() {
    const QByteArray cache = qgetenv("ECHOWEAVE_CACHE");
    qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache")).toUtf8());
    const QString folder = files_.writeCase(QStringLiteral("kept"));
    const auto opened = loadCaseAside(folder.toStdString());
    QVERIFY(opened.has_value());
    QImage image(32, 20, QImage::Format_Grayscale8);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 32; ++x) image.scanLine(y)[x] = static_cast<uchar>(7 * x + y);
    QVERIFY(keptThumbnail(*opened, image.size()).isNull());
    keepThumbnail(*opened, image);
    QCOMPARE(keptThumbnail(*opened, image.size()), image);
    QVERIFY(keptThumbnail(*opened, QSize(16, 10)).isNull());
    auto edited = *opened;
    edited.history = "A longer history than before.";
    QVERIFY(saveCase(edited, folder.toStdString()).has_value());
    QVERIFY2(keptThumbnail(edited, image.size()).isNull(), "the case is not what was painted");
    cache.isNull() ? qunsetenv("ECHOWEAVE_CACHE") : qputenv("ECHOWEAVE_CACHE", cache);
  }

  void figuresAreWrittenAsTheLanguageDoes() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(figure(1234.5, 1), QStringLiteral("1234,5"));
    QCOMPARE(clockText(65.25), QStringLiteral("1:05,3"));
    QCOMPARE(clockSeconds(65.25), QStringLiteral("1:05"));
    QLocale::setDefault(QLocale(QLocale::English));
    QCOMPARE(figure(1234.5, 1), QStringLiteral("1234.5"));
    QCOMPARE(clockText(65.25), QStringLiteral("1:05.3"));
    QLocale::setDefault(before);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::TraineeTest)
#include "trainee_test.moc"
