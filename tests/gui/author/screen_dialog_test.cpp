#include "ew/ui_test_door/import.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "acquisition/screens.h"
#include "ew/io/clip_file.h"
#include "gui/support/answers.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"
#include "recordings.h"

namespace ew::ui {
namespace {

using testing::Answers;
using testing::keepScreenshot;
using testing::waitUntil;

constexpr double kReadable = 0.6;  // as in test_screens

/// Films and recorded screens, as the window takes them in.
class ScreenDialogTest : public testing::WindowFixture {
  Q_OBJECT

  QString folder_;  ///< of the film alone

  [[nodiscard]] ScreenDialog* dialog() const { return window_->findChild<ScreenDialog*>(QStringLiteral("screenDialog")); }
  template <class Widget>
  [[nodiscard]] Widget* in(const char* name) const {
    return dialog()->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] ScreenView& view() const { return *in<ScreenView>("screenView"); }
  [[nodiscard]] QString sentence() const { return in<QLabel>("screenSentence")->text(); }
  [[nodiscard]] QStringList files() const { return QDir(folder_).entryList(QDir::Files, QDir::Name); }

  [[nodiscard]] QString write(const std::vector<cv::Mat>& frames, const QString& name = QStringLiteral("screen.avi")) const {
    const QString file = folder_ + QLatin1Char('/') + name;
    auto clip = ClipWriter::open(file.toStdString(), frames.front().cols, frames.front().rows, 20.0);
    if (!clip) return {};
    for (const cv::Mat& image : frames) {
      RgbImage colour(image.cols, image.rows);
      for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x) {
          const auto& p = image.at<cv::Vec3b>(y, x);
          viewOf(colour).at(x, y) = Rgb(p[2], p[1], p[0]);
        }
      if (!clip->add(colour)) return {};
    }
    return clip->finish() ? file : QString();
  }

  /// One of those that test_screens reads from a film, with an apex and text over the scan.
  [[nodiscard]] static test::DrawnScreen madeFan() {
    for (const unsigned seed : {3U, 5U, 8U, 1U, 2U, 4U}) {
      test::DrawnScreen screen = test::madeScreen(seed, 12);
      const bool hasText = std::any_of(screen.texts.begin(), screen.texts.end(), [](const test::DrawnText& text) { return text.over; });
      if (screen.truth.shape == FanShape::convex && hasText) return screen;
    }
    return {};
  }

  void mouse(QEvent::Type type, const QPointF& at, Qt::MouseButtons held) const {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, QPointF(view().mapToGlobal(QPoint(0, 0))) + at, button, held, {});
    QApplication::sendEvent(&view(), &event);
  }
  void drag(const QPointF& from, const QPointF& to) const {
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    mouse(QEvent::MouseMove, 0.5 * (from + to), Qt::LeftButton);
    mouse(QEvent::MouseMove, to, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, to, Qt::NoButton);
  }
  void click(const QPointF& at) const { drag(at, at); }
  [[nodiscard]] QPointF middleOf(const PixelRect& rect) const {
    return view().placeOf({rect.x + 0.5 * rect.width - 0.5, rect.y + 0.5 * rect.height - 0.5});
  }
  [[nodiscard]] bool isReady() const { return dialog() != nullptr && dialog()->edit() != nullptr && dialog()->shownFrame() == 0; }

 private Q_SLOTS:
  void init() {
    folder_ = files_.path(QStringLiteral("films"));
    QDir(folder_).removeRecursively();
    QVERIFY(QDir().mkpath(folder_));
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
  }
  void cleanup() { window_.reset(); }

  void aFilmThatLiesOnItsHeadIsTurnedAndMirrored() {
    test::DrawnScreen screen = madeFan();
    QVERIFY(!screen.frames.empty());
    const double width = screen.frames.front().cols;
    for (cv::Mat& image : screen.frames) cv::rotate(image, image, cv::ROTATE_180);
    window_->open(write(screen.frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    const ScreenEdit& edit = *dialog()->edit();
    drag(view().placeOf({9.5, 9.5}), view().placeOf({59.5, 29.5}));
    QVERIFY(!edit.correction().added.empty());
    auto* const turn = in<QComboBox>("screenTurn");
    turn->setCurrentIndex(2);
    Q_EMIT turn->activated(2);
    QVERIFY2(!turn->isEnabled(), "while it is looked through");
    QVERIFY(waitUntil([&] { return turn->isEnabled() && dialog()->shownFrame() == 0; }));
    QVERIFY(edit.outline().has_value());
    QVERIFY(glm::distance(edit.outline()->apex_px, screen.truth.apex_px) * screen.pixel_mm < 2.0);
    QVERIFY(edit.correction().turned == (Orientation{2, false}));
    QVERIFY2(edit.correction().added.empty(), "the box lay elsewhere");
    QVERIFY(in<QLabel>("screenNotes")->text().contains(QStringLiteral("taken back")));
    keepScreenshot(*dialog(), "screen-turned");
    in<QCheckBox>("screenMirror")->setChecked(true);
    QVERIFY(waitUntil([&] { return turn->isEnabled() && edit.correction().turned.mirrored && dialog()->shownFrame() == 0; }));
    QVERIFY(std::abs(edit.outline()->apex_px.x - (width - 1.0 - screen.truth.apex_px.x)) * screen.pixel_mm < 2.0);
    in<QDoubleSpinBox>("screenDepth")->setValue(100.0);
    const QString target = folder_ + QStringLiteral("/turned.igs.mha");
    Answers answers({{QStringLiteral("fileDialog"), testing::type(target)}});
    in<QPushButton>("screenImport")->click();
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && !window_->jobs().isSaving(); }));
    const auto said = readScreenCorrection((folder_ + QStringLiteral("/turned.screen.json")).toStdString());
    QVERIFY(said);
    QVERIFY(said->turned == (Orientation{2, true}));
  }

  void aFilmIsCorrectedMeasuredAndImportedWithoutItsText() {
    const test::DrawnScreen screen = madeFan();
    QVERIFY(!screen.frames.empty());
    window_->open(write(screen.frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    const ScreenEdit& edit = *dialog()->edit();
    QVERIFY(edit.outline().has_value());
    const FanOutline found = *edit.outline();
    QVERIFY(glm::distance(found.apex_px, screen.truth.apex_px) * screen.pixel_mm < 2.0);
    const std::size_t boxes = edit.boxes().size();
    QVERIFY(boxes > 0);
    QCOMPARE(files(), QStringList{QStringLiteral("screen.avi")});

    // The apex goes where it is dragged, and back.
    const glm::dvec2 elsewhere = found.apex_px + glm::dvec2(12.0, 14.0);
    const QPointF from = view().placeOf(found.apex_px), to = view().placeOf(elsewhere);
    QVERIFY2(QRectF(view().rect()).contains(from), "the apex lies in sight");
    drag(from, to);
    QVERIFY(glm::distance(edit.outline()->apex_px, elsewhere) < 1e-6);
    QVERIFY(std::abs(edit.outline()->left_rad - found.left_rad) > 0.01);
    QTest::mouseClick(in<QPushButton>("screenBack"), Qt::LeftButton);
    QVERIFY(*edit.outline() == found);

    // A box is left and taken again; a new one is drawn and goes with a click.
    const PixelRect first = edit.boxes().front().rect;
    click(middleOf(first));
    QVERIFY(!edit.boxes().front().counts);
    click(middleOf(first));
    QVERIFY(edit.boxes().front().counts);
    drag(view().placeOf({9.5, 9.5}), view().placeOf({59.5, 29.5}));
    QCOMPARE(edit.boxes().size(), boxes + 1);
    QVERIFY(edit.boxes().back().rect == (PixelRect{10, 10, 50, 20}));
    click(middleOf(edit.boxes().back().rect));
    QCOMPARE(edit.boxes().size(), boxes);

    // The depth is typed as the screen states it.
    const double depth_mm = std::round(100.0 * screen.truth.depth_px() * screen.pixel_mm) / 100.0;
    in<QDoubleSpinBox>("screenDepth")->setValue(depth_mm);
    const auto geometry = edit.geometry();
    QVERIFY(geometry && geometry->pixel_mm);
    QVERIFY(std::abs(*geometry->pixel_mm / screen.pixel_mm - 1.0) < 0.01);

    // A hundred pixels are measured in the frame that is shown, and only there.
    in<QPushButton>("screenMeasure")->click();
    const glm::dvec2 end(0.5 * (geometry->width_px - 100), 0.5 * geometry->height_px);
    drag(view().placeOf(end), view().placeOf(end + glm::dvec2(100.0, 0.0)));
    const QRegularExpression figures(QStringLiteral("1: ([0-9.]+) ± ([0-9.]+) mm"));
    const auto said = figures.match(in<QLabel>("screenDistances")->text());
    QVERIFY2(said.hasMatch(), qPrintable(in<QLabel>("screenDistances")->text()));
    QVERIFY(std::abs(said.captured(1).toDouble() - 100.0 * *geometry->pixel_mm) < 0.06);
    const double sigma_mm = *geometry->pixel_mm * std::max(1.0, 1.0 / view().scale()) / std::sqrt(6.0);  // of two ends, along the line
    QVERIFY2(std::abs(said.captured(2).toDouble() / sigma_mm - 1.0) < 0.1, qPrintable(said.captured(0)));
    QTest::keyClick(&view(), Qt::Key_Right);
    QVERIFY(waitUntil([&] { return dialog()->shownFrame() == 1; }));
    QVERIFY(!figures.match(in<QLabel>("screenDistances")->text()).hasMatch());
    QTest::keyClick(&view(), Qt::Key_End);
    QVERIFY(waitUntil([&] { return dialog()->shownFrame() == 11; }));
    QTest::keyClick(&view(), Qt::Key_Home);
    QVERIFY(waitUntil([&] { return dialog()->shownFrame() == 0; }));
    QVERIFY(figures.match(in<QLabel>("screenDistances")->text()).hasMatch());
    QTest::keyClick(&view(), Qt::Key_Space);
    QVERIFY(waitUntil([&] { return dialog()->shownFrame() > 1; }));
    QTest::keyClick(&view(), Qt::Key_Space);
    in<QPushButton>("screenMeasure")->click();

    // Cleaned: what lies beside the scan is black.
    in<QCheckBox>("screenCleaned")->setChecked(true);
    const auto brightest = [&] {
      const QImage seen = view().grab().toImage();
      const QPointF corner = view().placeOf({0.0, 0.0}), below = view().placeOf({160.0, 170.0});
      int most = 0;
      for (int y = std::max(2, static_cast<int>(corner.y())); y < below.y(); ++y)
        for (int x = std::max(2, static_cast<int>(corner.x())); x < below.x(); ++x)
          if (const glm::dvec2 p = view().pixelAt(QPointF(x, y)); !found.contains(p + glm::dvec2(4.0, 4.0)) && p.x < 100.0)
            most = std::max(most, qGray(seen.pixel(x, y)));
      return most;
    };
    QVERIFY(waitUntil([&] { return brightest() == 0; }));
    in<QCheckBox>("screenCleaned")->setChecked(false);
    QVERIFY(waitUntil([&] { return brightest() > 40; }));  // dimmed, because it becomes black

    // Nothing was stored so far; now the cleaned recording is, and what was corrected.
    QCOMPARE(files(), QStringList{QStringLiteral("screen.avi")});
    const QString target = folder_ + QStringLiteral("/liver.igs.mha");
    Answers answers({{QStringLiteral("fileDialog"), testing::type(target)}});
    in<QPushButton>("screenImport")->click();
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && !window_->jobs().isSaving(); }));
    QCOMPARE(answers.asked, QStringList{QStringLiteral("fileDialog")});
    QVERIFY2(sentence().contains(target), qPrintable(sentence()));
    QCOMPARE(files(), (QStringList{QStringLiteral("liver.igs.mha"), QStringLiteral("liver.screen.json"), QStringLiteral("screen.avi")}));
    const auto stored = readSequence(target.toStdString());
    QVERIFY(stored);
    QCOMPARE(stored->frames.size(), std::size_t{12});
    const ScreenCleaner cleaner(*geometry, {});
    QCOMPARE(stored->width, cleaner.kept().width);
    QVERIFY(std::abs(stored->frames[3].transforms.at(0).matrix[0][0] - *geometry->pixel_mm) < 1e-9);
    for (const std::size_t n : {std::size_t{0}, std::size_t{11}}) {
      GreyImage frame(stored->width, stored->height);
      const auto pixels = stored->framePixels(n);
      std::copy(pixels.begin(), pixels.end(), frame.pixels.begin());
      for (const test::DrawnText& text : screen.texts)
        if (text.over) QVERIFY2(test::readability(frame, cleaner.kept(), text) < kReadable, text.text.c_str());
    }
    const auto kept = readScreenCorrection(folder_.toStdString() + "/liver.screen.json");
    QVERIFY(kept && *kept == edit.correction());
  }

  /// The journey of a case author with a film of a real liver: imported, cleaned, measured.
  void aRealSweepComesBackOutOfAFilmOfItsScreen() {
    const auto file = test::recording("liver-sweep/liver_sweep.igs.mha");
    if (!std::filesystem::exists(file)) QSKIP("for want of recordings: ../shared/data/liver-sweep is not there");
    const auto sweep = readSequence(file);
    QVERIFY(sweep);
    const test::DrawnScreen screen = test::screenAround(*sweep, test::liverSweepOutline(), test::kLiverSweepPixel_mm, 102);
    window_->open(write(screen.frames, QStringLiteral("screen.mp4")));
    QVERIFY(waitUntil([&] { return isReady(); }));
    keepScreenshot(*dialog(), "screen-found");
    const ScreenEdit& edit = *dialog()->edit();
    QVERIFY(edit.outline().has_value());
    const FanOutline& found = *edit.outline();
    QVERIFY(glm::distance(found.apex_px, screen.truth.apex_px) * screen.pixel_mm < 2.0);
    const double degree = std::acos(-1.0) / 180.0;
    QVERIFY(std::abs(found.left_rad - screen.truth.left_rad) < degree && std::abs(found.right_rad - screen.truth.right_rad) < degree);
    QVERIFY(edit.found().ticks.has_value());

    // The marks stand a centimetre apart, and a true distance of the sweep is measured.
    in<QDoubleSpinBox>("screenTick")->setValue(screen.tick_mm);
    in<QPushButton>("screenMeasure")->click();
    const glm::dvec2 from = glm::dvec2(300.0, 200.0) + glm::dvec2(test::kScanAt.x, test::kScanAt.y), to = from + glm::dvec2(60.0, 240.0);
    drag(view().placeOf(from), view().placeOf(to));
    const auto said = QRegularExpression(QStringLiteral("1: ([0-9.]+) ± ([0-9.]+) mm")).match(in<QLabel>("screenDistances")->text());
    QVERIFY2(said.hasMatch(), qPrintable(in<QLabel>("screenDistances")->text()));
    const double truth_mm = glm::distance(from, to) * test::kLiverSweepPixel_mm;
    QVERIFY2(std::abs(said.captured(1).toDouble() - truth_mm) < 2.0 * said.captured(2).toDouble(),
             qPrintable(QStringLiteral("%1 instead of %2 mm").arg(said.captured(0)).arg(truth_mm)));
    keepScreenshot(*dialog(), "screen-measured");
    in<QPushButton>("screenMeasure")->click();
    in<QCheckBox>("screenCleaned")->setChecked(true);
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    keepScreenshot(*dialog(), "screen-cleaned");

    const QString target = folder_ + QStringLiteral("/liver.igs.mha");
    Answers answers({{QStringLiteral("fileDialog"), testing::type(target)}});
    in<QPushButton>("screenImport")->click();
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && !window_->jobs().isSaving(); }));
    keepScreenshot(*dialog(), "screen-stored");
    const auto stored = readSequence(target.toStdString());
    QVERIFY(stored);
    QCOMPARE(stored->frames.size(), screen.frames.size());
    // What was stored is the sweep: well within the scan its levels are those of the recording, but for what a film's compression takes.
    const auto geometry = edit.geometry();
    QVERIFY(geometry);
    const PixelRect kept = ScreenCleaner(*geometry, {}).kept();
    const glm::ivec2 corner(kept.x - test::kScanAt.x, kept.y - test::kScanAt.y);
    const auto was = sweep->framePixels(0), is = stored->framePixels(0);
    double sum = 0.0;
    int count = 0;
    for (int y = 150; y < 500; ++y)
      for (int x = 250; x < 480; ++x, ++count)
        sum += std::abs(static_cast<int>(was[static_cast<std::size_t>(y * sweep->width + x)]) -
                        static_cast<int>(is[static_cast<std::size_t>((y - corner.y) * stored->width + x - corner.x)]));
    QVERIFY2(sum / count < 4.0, qPrintable(QString::number(sum / count)));
  }

  void anOutlineThatWasNotFoundIsStated() {
    const std::vector<cv::Mat> frames(6, cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90)));
    window_->open(write(frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    if (dialog()->edit()->outline()) QSKIP("an even image has an outline now");
    QVERIFY(!in<QPushButton>("screenImport")->isEnabled());
    auto* shape = in<QComboBox>("screenShape");
    shape->setCurrentIndex(2);
    Q_EMIT shape->activated(2);
    QVERIFY(dialog()->edit()->outline().has_value());
    QVERIFY(in<QPushButton>("screenImport")->isEnabled());
    const FanOutline stated = *dialog()->edit()->outline();
    in<QPushButton>("screenAgain")->click();
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    QVERIFY(*dialog()->edit()->outline() == stated);
    // Keys move what they have taken hold of.
    QTest::keyClick(&view(), Qt::Key_H);
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(dialog()->edit()->outline()->corners_px[0] == stated.corners_px[0] + glm::dvec2(10.0, 0.0));
  }

  void aDamagedFilmIsRefusedInASentence() {
    const QString file = folder_ + QStringLiteral("/broken.avi");
    QVERIFY(writeFileSafely(file.toStdString(), std::string("RIFF\x10\x00\x00\x00", 8) + "AVI LIST" + std::string(500, 'x')));
    window_->open(file);
    QVERIFY(waitUntil([&] { return dialog() != nullptr && !window_->jobs().isRunning(); }));
    QVERIFY(waitUntil([&] { return sentence().contains(QStringLiteral("broken.avi")); }));
    QVERIFY(!in<QPushButton>("screenImport")->isEnabled());
    QVERIFY(dialog()->edit() == nullptr);
  }

  void closingWhileItIsReadStopsIt() {
    window_->open(write(test::madeScreen(3, 12).frames));
    QVERIFY(waitUntil([&] { return dialog() != nullptr; }));
    in<QPushButton>("screenClose")->click();
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    QVERIFY(waitUntil([&] { return dialog() == nullptr; }));
    QCOMPARE(files(), QStringList{QStringLiteral("screen.avi")});
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
  }

  void whatWasCorrectedIsAskedAboutBeforeItGoes() {
    window_->open(write(madeFan().frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    QVERIFY(!dialog()->isUnsaved());
    in<QDoubleSpinBox>("screenDepth")->setValue(80.0);
    QVERIFY(dialog()->isUnsaved());
    {
      Answers stay({{QStringLiteral("unsavedScreenQuestion"), testing::press(QMessageBox::Cancel)}});
      in<QPushButton>("screenClose")->click();
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedScreenQuestion")});
      QVERIFY(dialog()->isVisible());
      QVERIFY(!window_->close());
    }
    Answers discard({{QStringLiteral("unsavedScreenQuestion"), testing::press(QMessageBox::Discard)}});
    in<QPushButton>("screenClose")->click();
    QCOMPARE(discard.asked, QStringList{QStringLiteral("unsavedScreenQuestion")});
    QVERIFY(waitUntil([&] { return dialog() == nullptr || !dialog()->isVisible(); }));
  }

  void closingWhileWhatWasCorrectedIsWrittenIsADecision() {
    window_->open(write(madeFan().frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    in<QDoubleSpinBox>("screenDepth")->setValue(80.0);
    const QString target = folder_ + QStringLiteral("/written.igs.mha");
    {
      Answers stay({{QStringLiteral("fileDialog"), testing::type(target)},
                    {QStringLiteral("writingScreenQuestion"), testing::press(QMessageBox::Cancel)}});
      in<QPushButton>("screenImport")->click();
      QVERIFY2(dialog()->isUnsaved(), "it may still fail");
      in<QPushButton>("screenClose")->click();  // the end of the job is an event that has not been seen yet
      QCOMPARE(stay.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("writingScreenQuestion")}));
      QVERIFY(dialog()->isVisible());
    }
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    QVERIFY2(QFile::exists(target), qPrintable(sentence()));
    QVERIFY(!dialog()->isUnsaved());
    Answers nobody({});
    in<QPushButton>("screenClose")->click();
    QVERIFY(nobody.asked.isEmpty());
    QVERIFY(waitUntil([&] { return dialog() == nullptr || !dialog()->isVisible(); }));
  }

  void whatCouldNotBeWrittenIsStillAskedAbout() {
    window_->open(write(madeFan().frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    in<QDoubleSpinBox>("screenDepth")->setValue(80.0);
    const QString gone = folder_ + QStringLiteral("/gone");
    QVERIFY(QDir().mkpath(gone));
    {
      // Whoever wants to close it while it is written answers when that has failed.
      Answers close({{QStringLiteral("fileDialog"),
                      [gone](QWidget& dialog) {
                        testing::type(gone + QStringLiteral("/written.igs.mha"))(dialog);
                        QDir(gone).removeRecursively();
                      }},
                     {QStringLiteral("writingScreenQuestion"), [this](QWidget& question) {
                        auto* poll = new QTimer(&question);
                        connect(poll, &QTimer::timeout, &question, [this, &question] {
                          if (!window_->jobs().isRunning()) question.findChild<QPushButton*>(QStringLiteral("closeWhileWriting"))->click();
                        });
                        poll->start(10);
                      }}});
      in<QPushButton>("screenImport")->click();
      in<QPushButton>("screenClose")->click();
      QCOMPARE(close.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("writingScreenQuestion")}));
    }
    QVERIFY(dialog()->isVisible());
    QVERIFY2(dialog()->isUnsaved(), qPrintable(sentence()));
    Answers stay({{QStringLiteral("unsavedScreenQuestion"), testing::press(QMessageBox::Cancel)}});
    in<QPushButton>("screenClose")->click();
    QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedScreenQuestion")});
    QVERIFY(dialog()->isVisible());
  }

  void whoSavesWhileItIsLookedThroughIsToldThatNothingWasSaved() {
    window_->open(write(madeFan().frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    in<QDoubleSpinBox>("screenDepth")->setValue(80.0);
    auto* const turn = in<QComboBox>("screenTurn");
    turn->setCurrentIndex(2);
    Q_EMIT turn->activated(2);
    QVERIFY2(!turn->isEnabled(), "while it is looked through");
    bool isLooking = false;
    Answers save({{QStringLiteral("unsavedScreenQuestion"), [&](QWidget& question) {
                     isLooking = !turn->isEnabled();
                     testing::press(QMessageBox::Save)(question);
                   }}});
    in<QPushButton>("screenClose")->click();
    QCOMPARE(save.asked.constFirst(), QStringLiteral("unsavedScreenQuestion"));
    if (!isLooking) QSKIP("it was looked through before anybody could answer");
    QVERIFY2(sentence().contains(QStringLiteral("Nothing was saved")), qPrintable(sentence()));
    QVERIFY(dialog()->isVisible());
    QVERIFY(waitUntil([&] { return turn->isEnabled(); }));
  }

  void theDialogFitsASmallScreen() {
    window_->open(write(test::madeScreen(5, 12).frames));
    QVERIFY(waitUntil([&] { return isReady(); }));
    const QSize least = dialog()->minimumSizeHint();
    QVERIFY2(least.width() <= 1280 && least.height() <= 720, qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
    for (const QWidget* each : dialog()->findChildren<QWidget*>()) {
      if (qobject_cast<const QLabel*>(each) != nullptr) continue;  // its text is its name
      if (each->focusPolicy() == Qt::NoFocus || !each->isVisible() || each->objectName().isEmpty() ||
          each->objectName().startsWith(QLatin1String("qt_")))
        continue;
      const auto* button = qobject_cast<const QAbstractButton*>(each);
      QVERIFY2(!each->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()) || !each->toolTip().isEmpty(),
               qPrintable(each->objectName()));
    }
  }
};

}  // namespace
}  // namespace ew::ui

EW_WINDOW_TEST_MAIN(ew::ui::ScreenDialogTest)
#include "screen_dialog_test.moc"
