// Every expert's scan that is shipped: one moment of it is the same image in the lesson's window, where it is replayed (Review, stored
// clips, films, DICOM), and from the command.
#include <QProcess>
#include <algorithm>

#include "ew/io/image_file.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/recording.h"
#include "ew/scanning/replay.h"
#include "gui/support/case_aside.h"
#include "gui/support/usability_fixture.h"
#include "places.h"

namespace ew::ui::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 320, kHeight = 240;
constexpr int kRowsOfWords = 40;  // below, where a file has words burnt in

std::vector<std::uint8_t> pixelsOf(const DisplayImage& image) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.height(); ++y) pixels.insert(pixels.end(), image.grey.row(y), image.grey.row(y) + image.width());
  return pixels;
}

/// One frame of a scan, as a scan of its own: nothing before it shows in it.
ScanRecording timestampOf(const ScanRecording& scan, std::size_t frame) {
  ScanRecording moment{.caseId = scan.caseId, .title = scan.title, .size_px = {kWidth, kHeight}, .log = {}, .notes = {}};
  moment.log.addFrame(scan.log.frame(frame));
  return moment;
}

}  // namespace

class ShippedExpertsTest : public UsabilityFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { initUsabilityTranslations(); }
  void cleanup() { window_.reset(); }

  void oneMomentIsOneImage_data() {
    QTest::addColumn<QString>("folder");
    for (const auto& each : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "cases"))
      if (fs::exists(each.path() / "case.json"))
        QTest::newRow(each.path().filename().c_str()) << QString::fromStdString(each.path().string());
  }
  void oneMomentIsOneImage() {
    QFETCH(QString, folder);
    const QString copy = coarseCopyOf(folder.toStdString());
    showWindowWithCase(copy);
    session().setImageSize(kWidth, kHeight);
    const auto opened = loadCaseAside(copy.toStdString());
    QVERIFY(opened.has_value());
    const auto lessons = lessonsOf(*opened);
    QVERIFY(lessons.has_value());
    int scans = 0;
    for (const Lesson& lesson : *lessons)
      for (const LessonStep& step : lesson.steps) {
        const auto* watch = std::get_if<WatchTask>(&step.task);
        if (watch == nullptr) continue;
        const auto scan = readRecording(opened->folder / "parts" / std::string(kLessonsPart) / watch->recording);
        QVERIFY(scan.has_value());
        ++scans;
        const std::size_t last = scan->log.frameCount() - 1;
        for (const std::size_t frame : {std::size_t{0}, last / 3, last}) {
          const QByteArray what = QStringLiteral("%1, image %2").arg(QString::fromStdString(watch->recording)).arg(frame).toUtf8();
          const ScanRecording moment = timestampOf(*scan, frame);
          session().play(moment.log.frame(0));
          session().setImageSize(kWidth, kHeight);
          session().makeImageNow();
          const std::vector<std::uint8_t> inWindow = testing::pixelsOf(session());
          session().play({});
          QCOMPARE(inWindow.size(), std::size_t{kWidth * kHeight});
          QVERIFY2(std::count_if(inWindow.begin(), inWindow.end(), [](std::uint8_t level) { return level > 0; }) > kWidth * kHeight / 20,
                   what);

          Replay replay(moment.log, *session().subject());
          QVERIFY2(pixelsOf(replay.make(0, kWidth, kHeight)) == inWindow, what + ": replayed, it is another image");

          const QString file = files_.path(QStringLiteral("moment.seq.mha")), images = files_.path(QStringLiteral("images"));
          QVERIFY(writeRecording(moment, file.toStdString()).has_value());
          QDir(images).removeRecursively();
          QCOMPARE(QProcess::execute(QStringLiteral(EW_PROGRAM),
                                     {QStringLiteral("replay"), copy, QStringLiteral("--scan"), file, QStringLiteral("-o"), images}),
                   0);
          const auto written = readImage((images + QStringLiteral("/image_0000.png")).toStdString());
          QVERIFY2(written && written->width == kWidth && written->height == kHeight, what);
          QVERIFY2(std::equal(inWindow.begin(), inWindow.end() - std::ptrdiff_t{kRowsOfWords} * kWidth, written->pixels.begin()),
                   what + ": the command makes another image");
        }
      }
    QCOMPARE(scans, 2);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ShippedExpertsTest)
#include "shipped_experts_test.moc"
