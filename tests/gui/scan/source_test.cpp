#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QTranslator>
#include <cmath>

#include <QTimer>
#include "ew/library/voxel_source.h"
#include "ew/ui_test_door/source.h"
#include "gui/support/window_fixture.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

/// A sweep whose frame n has the grey level 40 + 8 n everywhere, so that the image shown says by itself which frame it is.
class SourceTest : public WindowFixture {
  Q_OBJECT

 private:
  [[nodiscard]] SourceDialog* dialog() const { return window_->findChild<SourceDialog*>(); }
  [[nodiscard]] SourcePicker& picker() const { return *window_->findChild<SourcePicker*>(); }
  [[nodiscard]] QString textOf(const char* name) const { return dialog()->findChild<QLabel*>(QLatin1String(name))->text(); }

  [[nodiscard]] bool importSweep(const QString& sweep, bool keepSource) const {
    // The volume before was made and never saved, so the window asks about it, in an event loop of its own.
    QTimer gone;
    connect(&gone, &QTimer::timeout, &gone, [] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (question != nullptr && question->objectName() == QLatin1String("unsavedVolumeQuestion"))
        question->button(QMessageBox::Discard)->click();
    });
    gone.start(10);
    window_->open(sweep);
    QDialog* import = nullptr;
    const auto isThere = [&] { return (import = find<QDialog>("importDialog")) != nullptr && import->isVisible(); };
    if (!waitUntil(isThere)) return false;
    auto* make = import->findChild<QPushButton*>(QStringLiteral("makeVolume"));
    if (!waitUntil([&] { return make->isEnabled(); })) return false;
    import->findChild<QCheckBox*>(QStringLiteral("keepSource"))->setChecked(keepSource);
    import->findChild<QDoubleSpinBox*>(QStringLiteral("fillReach"))->setValue(0.0);
    import->findChild<QDoubleSpinBox*>(QStringLiteral("spacing"))->setValue(1.0);  // a pixel for every voxel
    QTest::mouseClick(make, Qt::LeftButton);
    const QString title = QFileInfo(sweep).fileName();
    if (!waitUntil([&] { return session().subject() && session().subject()->title == title.toStdString() && window_->isSettled(); }))
      return false;
    QApplication::setActiveWindow(window_.get());
    window_->scanView().setFocus();
    return true;
  }

  [[nodiscard]] QPoint inWidget(const QPoint& pixel) const { return window_->scanView().imageRect().topLeft() + pixel; }

  void altClick(const QPoint& pixel) const {
    QWidget* target = window_->scanView().childAt(inWidget(pixel));
    if (target == nullptr) target = &window_->scanView();
    QTest::mouseClick(target, Qt::LeftButton, Qt::AltModifier, target->mapFrom(&window_->scanView(), inWidget(pixel)));
  }

  /// Pixels of the image inside the fan and well inside the volume; what is to be found there is worked out by hand, not by the program.
  struct Spot {
    QPoint pixel;
    int frame = 0;
    double x_px = 0.0, y_px = 0.0;
  };
  [[nodiscard]] std::vector<Spot> spots() const {
    const ScanSubject& subject = *session().subject();
    const auto imageToWorld = session().imagePose().probeToWorld * session().geometry().imageToProbe();
    std::vector<Spot> found;
    for (int y = 4; y < session().geometry().height; y += 16) {
      for (const RowSpan& run : session().seen().spans()[static_cast<std::size_t>(y)]) {
        for (int x = run.begin + 2; x < run.end - 2; x += 24) {
          const auto at = imageToWorld * Point<frame::Image>{{x, y, 0.0}};
          const glm::dvec3 recorded = (subject.voxels.volume()->grid.voxelToWorld() * (subject.placedGrid.worldToVoxel() * at)).at;
          const QWidget* over = window_->scanView().childAt(inWidget({x, y}));
          if (over != nullptr && over->objectName() == QLatin1String("zoomOverview")) continue;  // hides the image there
          const double nearest = std::round(recorded.z);
          // Near a frame's plane and off the middle between two voxels, where rounding decides.
          if (recorded.x < 1.0 || recorded.x > 38.0 || recorded.y < 1.0 || recorded.y > 28.0 || recorded.z < 1.0 || recorded.z > 22.0 ||
              std::abs(recorded.z - nearest) > 0.2)
            continue;
          found.push_back({{x, y}, static_cast<int>(nearest), recorded.x, recorded.y});
        }
      }
    }
    return found;
  }

  void checkShows(const Spot& spot) const {
    QVERIFY(waitUntil([this] { return dialog() != nullptr && dialog()->isVisible() && !dialog()->image().isNull(); }));
    QCOMPARE(qGray(dialog()->image().pixel(20, 15)), 40 + 8 * spot.frame);
    QVERIFY2(textOf("sourceFrame").startsWith(QStringLiteral("%1 of 24").arg(spot.frame + 1)), qPrintable(textOf("sourceFrame")));
    QCOMPARE(textOf("sourceTime"), QStringLiteral("%1 s").arg(spot.frame * 0.1, 0, 'f', 3));
    QVERIFY(dialog()->cross().has_value());
    QVERIFY(std::abs(dialog()->cross()->x() - spot.x_px) < 1e-6 && std::abs(dialog()->cross()->y() - spot.y_px) < 1e-6);
    QVERIFY(textOf("sourceVoxel").startsWith(QLatin1String("measured")));
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void init() { showWindowWithCase(files_.writeCase(QStringLiteral("case"))); }
  void cleanup() { window_.reset(); }

  void altClickShowsTheFrameHoweverTheImageIsTurnedAndZoomed() {
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("turned.igs.mha")), true));
    QCOMPARE(session().subject()->provenance->frames.size(), std::size_t{24});
    Knobs usual = session().console().knobs();
    usual.depth_mm = 60.0;
    int looks = 0;
    for (const bool flipped : {false, true}) {
      for (const bool upsideDown : {false, true}) {
        for (const double zoom : {1.0, 1.5}) {
          Knobs knobs = usual;
          knobs.markerLeft = flipped != usual.markerLeft;
          knobs.upsideDown = upsideDown;
          knobs.zoom = zoom;
          session().console().setKnobs(knobs);
          session().makeImageNow();
          const std::vector<Spot> all = spots();
          if (all.empty()) continue;
          ++looks;
          for (const Spot& spot : {all.front(), all[all.size() / 2], all.back()}) {
            altClick(spot.pixel);
            checkShows(spot);
          }
        }
      }
    }
    QVERIFY2(looks >= 6, qPrintable(QString::number(looks)));
    // Beams give the same image plane as the display path.
    Knobs knobs = usual;
    session().console().setKnobs(knobs);
    Scene scene = session().console().scene();
    scene.focus.emplace();
    session().console().setScene(scene);
    session().makeImageNow();
    const std::vector<Spot> all = spots();
    QVERIFY(!all.empty());
    altClick(all[all.size() / 3].pixel);
    checkShows(all[all.size() / 3]);
  }

  void arrowsStepToNeighboursAndEscapeCloses() {
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("steps.igs.mha")), true));
    const std::vector<Spot> all = spots();
    QVERIFY(!all.empty());
    const Spot spot = all[all.size() / 2];
    altClick(spot.pixel);
    checkShows(spot);
    QTest::keyClick(dialog(), Qt::Key_Right);
    QTest::keyClick(dialog(), Qt::Key_Right);
    QCOMPARE(qGray(dialog()->image().pixel(20, 15)), 40 + 8 * (spot.frame + 2));
    QVERIFY(textOf("sourceFrame").contains(QLatin1String("2 after")));
    QTest::keyClick(dialog(), Qt::Key_Home);
    checkShows(spot);
    for (int n = 0; n < 30; ++n) QTest::keyClick(dialog(), Qt::Key_Left);
    QCOMPARE(qGray(dialog()->image().pixel(20, 15)), 40);
    QVERIFY(!dialog()->findChild<QPushButton*>(QStringLiteral("sourceBefore"))->isEnabled());
    for (const QPushButton* button : dialog()->findChildren<QPushButton*>()) QVERIFY(!button->accessibleName().isEmpty());
    QVERIFY(picker().mark().has_value());
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QVERIFY(waitUntil([this] { return dialog() == nullptr; }));
    QVERIFY(!picker().mark().has_value());
  }

  void theKeyboardAsksWithoutAMouseAndTheProbeStaysWhereItIs() {
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("keys.igs.mha")), true));
    const Hold before = session().probeControl().hold();
    QTest::keyClick(&window_->scanView(), Qt::Key_I);
    QVERIFY(waitUntil([this] { return picker().isPicking(); }));
    QTest::mouseClick(&picker(), Qt::LeftButton, Qt::NoModifier, picker().rect().center());
    QVERIFY(waitUntil([this] { return dialog() != nullptr && dialog()->isVisible(); }));
    const QPoint first = *picker().mark();
    QTest::keyClick(&picker(), Qt::Key_Right);
    QTest::keyClick(&picker(), Qt::Key_Down);
    QTest::keyClick(&picker(), Qt::Key_Return);
    QCOMPARE(*picker().mark(), first + QPoint(4, 4));
    QVERIFY(session().probeControl().hold() == before);
    QTest::keyClick(&picker(), Qt::Key_Escape);
    QVERIFY(!picker().isPicking());
    // The mark alone leaves the mouse to the probe, and goes when the plane does.
    QTest::keyClick(&window_->scanView(), Qt::Key_Q);
    QVERIFY(!(session().probeControl().hold() == before));
    session().makeImageNow();
    QVERIFY(!picker().mark().has_value());
  }

  void theQuestionIsNotOfferedWhereTheVolumeCannotAnswerIt() {
    const auto isOffered = [this] {
      for (const QAction* action : window_->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(Qt::Key_I)) return action->isEnabled();
      return true;
    };
    QVERIFY(!isOffered());
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("offered.igs.mha")), true));
    QVERIFY(isOffered());
  }

  void whatIsNotKnownIsSaidInASentence() {
    altClick({session().geometry().width / 2, session().geometry().height / 2});
    QVERIFY(waitUntil([this] { return dialog() != nullptr && dialog()->isVisible(); }));
    QVERIFY(!dialog()->shownFrame().has_value());
    QVERIFY(textOf("sourceSentence").contains(QLatin1String("Ctrl+O")));
    QTest::keyClick(dialog(), Qt::Key_Right);
    altClick({0, session().geometry().height - 1});
    QVERIFY(textOf("sourceSentence").contains(QLatin1String("inside the fan")));
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("unkept.igs.mha")), false));
    QVERIFY(session().subject()->provenance == nullptr);
    const QString sweep = files_.writeSweep(QStringLiteral("gone.igs.mha"));
    QVERIFY(importSweep(sweep, true));
    // The fan reaches deeper than the 40 mm of the sweep.
    const Spans& fan = session().seen().spans();
    std::size_t low = fan.size() - 1;
    while (low > 0 && (fan[low].empty() || fan[low].front().end - fan[low].front().begin < 8)) --low;
    QVERIFY(low > 0);
    altClick({(fan[low].front().begin + fan[low].front().end) / 2, static_cast<int>(low)});
    QVERIFY(textOf("sourceSentence").contains(QLatin1String("outside the volume")));
    const std::vector<Spot> all = spots();
    QVERIFY(!all.empty());
    QVERIFY(QFile::remove(sweep));
    altClick(all.front().pixel);
    QVERIFY(dialog()->shownFrame().has_value());
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    QVERIFY(dialog()->image().isNull());
    QVERIFY2(dialog()->problem().contains(QLatin1String("gone.igs.mha")), qPrintable(dialog()->problem()));
    QVERIFY(textOf("sourceFrame").startsWith(QStringLiteral("%1 of 24").arg(all.front().frame + 1)));
  }

  void inGermanAndBothThemesNothingIsClippedAt1280x720() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QVERIFY(importSweep(files_.writeSweep(QStringLiteral("german.igs.mha")), true));
    QApplication::installTranslator(&german);
    const std::vector<Spot> all = spots();
    QVERIFY(!all.empty());
    altClick(all.front().pixel);
    QVERIFY(waitUntil([this] { return dialog() != nullptr && !dialog()->image().isNull(); }));
    QVERIFY(dialog()->width() <= 1280 && dialog()->height() <= 720);
    QVERIFY2(textOf("sourceVoxel").startsWith(QLatin1String("gemessen")), qPrintable(textOf("sourceVoxel")));
    for (const bool dark : {true, false}) {
      window_->setDarkTheme(dark);
      QTest::qWait(50);
      for (const QLabel* label : dialog()->findChildren<QLabel*>()) {
        if (!label->isVisible()) continue;
        const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        QVERIFY2(label->height() >= needed - 1, qPrintable(label->text()));
      }
      for (const QPushButton* button : dialog()->findChildren<QPushButton*>())
        QVERIFY2(button->width() >= button->minimumSizeHint().width() - 1, qPrintable(button->text()));
    }
    QApplication::removeTranslator(&german);
    window_->setDarkTheme(true);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::SourceTest)
#include "source_test.moc"
