// What a trainee and an author meet on their way through the window, each found by using it.
#include <QLabel>
#include <QOpenGLContext>
#include <QPushButton>
#include <QStackedWidget>
#include <chrono>
#include <functional>

#include "ew/library/case.h"
#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/body_gate.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {
namespace {

/// Counts what a widget paints.
class PaintCount final : public QObject {
 public:
  explicit PaintCount(QWidget& watched) { watched.installEventFilter(this); }
  int count = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count;
    return QObject::eventFilter(watched, event);
  }
};

}  // namespace

class JourneysTest : public WindowFixture {
  Q_OBJECT

 private:
  [[nodiscard]] QString writeCaseCalled(const QString& title) const {
    const QString folder = files_.writeCase(title);
    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    opened->title = title.toStdString();
    return saveCase(*opened, folder.toStdString()) ? folder : QString();
  }

 private Q_SLOTS:
  void init() { showWindowWithCase(writeCaseCalled(QStringLiteral("first"))); }
  void cleanup() { window_.reset(); }

  void theTitleOfACaseChosenOnTheStartPageStandsInTheTopBar() {
    window_->showStartPage();
    QVERIFY(find<QLabel>("title")->text().isEmpty());
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    const QString folder = writeCaseCalled(QStringLiteral("second"));
    Q_EMIT find<StartPage>("startPage")->caseChosen(folder);
    QVERIFY(waitUntil([this] { return session().subject()->title == "second"; }));
    QVERIFY2(find<QLabel>("title")->text() == QLatin1String("second"), qPrintable(find<QLabel>("title")->text()));
  }

  void ofTwoCasesChosenInHasteTheLaterOneOpens() {
    const QString second = writeCaseCalled(QStringLiteral("second"));
    const QString third = writeCaseCalled(QStringLiteral("third"));
    for (const bool again : {false, true}) {
      window_->open(again ? third : second);
      window_->open(again ? third : second);
      window_->open(again ? second : third);
      QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
      QTest::qWait(20);
      QCOMPARE(session().subject()->title, std::string(again ? "second" : "third"));
    }
  }

  void thePageOfKeysGivesTheFocusBackSoThatTheArrowsStillMoveTheProbe() {
    window_->scanView().setFocus();
    QTest::keyClick(&window_->scanView(), Qt::Key_F1);
    QVERIFY(!window_->scanView().hasFocus());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    QVERIFY(waitUntil([this] { return window_->scanView().hasFocus(); }));
    for (const char* button : {"workspaceExplore", "freeze", "freeze", "qualityFast", "dgcReset"}) {
      QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton);
      QVERIFY2(window_->scanView().hasFocus(), button);
    }
    const Hold before = session().probeControl().hold();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
    QVERIFY(!(session().probeControl().hold() == before));
  }

  void keysOfTheConsoleWorkWhileItIsHiddenBesideAnAuthorsPanels() {
    window_->setWorkspace(Workspace::author);
    QVERIFY(!window_->console().isVisible());
    QTest::keyClick(&window_->scanView(), Qt::Key_1);
    QVERIFY(session().console().knobs().quality == Quality::weave);
    QTest::keyClick(&window_->scanView(), Qt::Key_2);
    QVERIFY(session().console().knobs().quality == Quality::linear);
    const Knobs before = session().console().knobs();
    QTest::keyClick(&window_->scanView(), Qt::Key_X);
    QVERIFY(!(session().console().knobs() == before));
  }

  void besideTheVolumeTheScanSaysWhereItIsAndWithinItDoesNot() {
    window_->bodyMark().setShown(false);  // it stands in a corner, as sliders and scale do
    QVERIFY(session().seesVolume());
    const QImage within = window_->scanView().grab().toImage();
    const auto wordsIn = [this](const QImage& shown) {
      // Without the sliders and the scale, which stand in the corners.
      const QRect box = window_->scanView().imageRect().adjusted(88, 0, -64, 0);
      int lit = 0;
      for (int y = box.top(); y < box.bottom(); ++y)
        for (int x = box.left(); x < box.right(); ++x) lit += qGray(shown.pixel(x, y)) > 60 ? 1 : 0;
      return lit;
    };
    Knobs silent = session().console().knobs();
    silent.gain = 0.0;
    session().console().setKnobs(silent);
    session().makeImageNow();
    QVERIFY2(wordsIn(window_->scanView().grab().toImage()) < 100, "an image turned down to black is not beside the volume");
    session().console().setKnobs(Knobs{});
    Hold away = session().probeControl().hold();
    away.contact.point_mm.z -= 700.0;
    session().probeControl().setHold(away);
    session().makeImageNow();
    QVERIFY(!session().seesVolume());
    QVERIFY2(wordsIn(window_->scanView().grab().toImage()) > 300, "nothing tells a user why the image is black");
  }

  void aSlowBodyDoesNotHoldUpTheScan() {
    auto* canvas = qobject_cast<BodyCanvas*>(window_->view3d().canvas());
    if (!QOpenGLContext::supportsThreadedOpenGL()) QSKIP("OpenGL knows one thread only");
    window_->view3d().renderNow();
    PaintCount scans(window_->scanView());
    test::BodyGate gate(*canvas);
    int moves = 0, scansBefore = -1;
    const auto moveUntil = [&](const std::function<bool()>& ready) {
      return waitUntil([&] {
        session().probeControl().setHold(turned(session().probeControl().hold(), ++moves % 2 == 0 ? 0.02 : -0.02, 0.0, 0.0));
        return ready();
      });
    };
    const bool goesOn = moveUntil([&] {
      if (scansBefore < 0 && gate.passed() == 1) scansBefore = scans.count;
      return scansBefore >= 0 && scans.count >= scansBefore + 10;
    });
    QVERIFY2(goesOn, qPrintable(QStringLiteral("%1 scans, %2 of them before the body was drawn").arg(scans.count).arg(scansBefore)));
    // And after a drawing as long as that the scan has both cores for a moment.
    gate.letGo();
    QVERIFY(moveUntil([&] { return gate.passed() >= 2 && !gate.drawn().empty(); }));
    const std::chrono::duration<double, std::milli> rested = gate.begun()[1] - gate.drawn()[0];
    QVERIFY2(rested.count() > 95.0, qPrintable(QString::number(rested.count())));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::JourneysTest)
#include "journeys_test.moc"
