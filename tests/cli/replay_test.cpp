#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/imaging/caption.h"
#include "ew/io/image_file.h"
#include "ew/scanning/replay.h"
#include "scanning/small_scan.h"

namespace ew::test::replay_command_test {
namespace {

class ReplayCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(writeVolume(*waves(), folder / "v.mha"));
    recording.size_px = {160, 120};
    for (int n = 0; n < 40; ++n) recording.log.addFrame(movingState(n));
    ASSERT_TRUE(writeRecording(recording, folder / "r.seq.mha"));
  }
  [[nodiscard]] std::size_t filesIn(const std::string& name) const {
    const std::filesystem::directory_iterator all(folder / name);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  TemporaryFolder folder;
  ScanRecording recording;
};

TEST_F(ReplayCommand, WritesTheImagesThatWereSeenWithTheWarningOnThem) {
  const auto outcome = run({"replay", folder / "v.mha", "--scan", folder / "r.seq.mha", "-o", folder / "out", "--every", "13", "--threads",
                            "2", "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(filesIn("out"), 4U);
  Replay replay(recording.log, subjectOf(ScanVoxels::asStored(waves()), "waves"));
  for (std::size_t n = 0; n < recording.log.frameCount(); ++n) {
    const DisplayImage image = replay.make(n, 160, 120);
    if (n % 13 != 0) continue;
    GreyImage expected(160, 120);
    for (int y = 0; y < 120; ++y) std::copy_n(image.grey.row(y), 160, viewOf(expected).row(y));
    burnCaption(viewOf(expected), kNotForDiagnosis);
    const auto written = readImage(folder / ("out/image_000" + std::to_string(n / 13) + ".png"));
    ASSERT_TRUE(written) << written.error();
    EXPECT_EQ(*written, expected) << n;
  }
  EXPECT_EQ(readJson(folder / "report.json")["quality"]["recorded_images"], 40);
}

TEST_F(ReplayCommand, WritesAFilm) {
  const auto outcome =
      run({"replay", folder / "v.mha", "--scan", folder / "r.seq.mha", "-o", folder / "f.avi", "--rate", "15", "--size", "320x240"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_GT(std::filesystem::file_size(folder / "f.avi"), 5000U);
  EXPECT_NE(outcome.out.find("film of 20 images"), std::string::npos) << outcome.out << outcome.err;
}

TEST_F(ReplayCommand, RefusesWhatItCannotUseAndLeavesNothing) {
  writeText(folder / "cut.seq.mha", readText(folder / "r.seq.mha").substr(0, 300));
  ASSERT_TRUE(writeRecording(recording, folder / "again.seq.mha"));
  const std::tuple<std::string, std::string, std::string> cases[] = {{"v.mha", "out", "poses alone"},
                                                                     {"cut.seq.mha", "out", "cut.seq.mha"},
                                                                     {"nowhere.seq.mha", "out", "nowhere.seq.mha"},
                                                                     {"again.seq.mha", "f.wmv/x.avi", "f.wmv"}};
  for (const auto& [scan, output, says] : cases) {
    const auto outcome = run({"replay", folder / "v.mha", "--scan", folder / scan, "-o", folder / output});
    EXPECT_NE(outcome.status, 0) << scan;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << scan;
  }
}

}  // namespace
}  // namespace ew::test::replay_command_test
