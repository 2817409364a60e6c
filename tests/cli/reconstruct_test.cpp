#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "cli/cli_world.h"

namespace ew::test::reconstruct_test {
namespace {

class ReconstructCommand : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha")); }
  Outcome reconstruct(std::vector<std::string> more) const {
    std::vector<std::string> words{"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  Sequence sweep = parallelSweep(8, 6, 5);
  TemporaryFolder folder;
};

TEST_F(ReconstructCommand, GivesBackTheFramesOfAParallelSweepExactly) {
  for (const std::string interpolation : {"nearest", "linear"}) {
    const auto outcome =
        reconstruct({"--spacing", "1", "--interpolation", interpolation, "--coverage", folder / "c.mha", "--report", folder / "r.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto read = readVolume(folder / "v.mha"), coverage = readVolume(folder / "c.mha");
    ASSERT_TRUE(read && coverage);
    const auto& grid = read->volume.grid;
    ASSERT_EQ(grid.dims, glm::ivec3(8, 6, 5));
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 8; ++i) ASSERT_EQ(read->volume.echo[grid.indexOf(i, j, k)], parallelSweepPixel(i, j, k)) << i << j << k;
    EXPECT_EQ(coverage->volume.echo, std::vector<std::uint8_t>(grid.voxelCount(), 2));
    const auto report = readJson(folder / "r.json");
    EXPECT_EQ(report["command"], "reconstruct");
    EXPECT_EQ(report["quality"]["frames_used"], 5);
    EXPECT_EQ(report["quality"]["frames_invalid"], 0);
    EXPECT_EQ(report["quality"]["frames_missing"], 0);
    EXPECT_EQ(report["quality"]["voxels_measured"], 240);
    EXPECT_EQ(report["quality"]["voxels_interpolated"], 0);
    EXPECT_EQ(report["grid"]["dims"], nlohmann::json({8, 6, 5}));
    EXPECT_EQ(report["options"]["interpolation"], interpolation);
    EXPECT_EQ(report["outputs"], nlohmann::json({folder / "v.mha", folder / "c.mha"}));
    EXPECT_GE(report["steps"].size(), 2u);
  }
}

TEST_F(ReconstructCommand, CutsTheFramesToTheClipOfTheCommandLine) {
  const auto outcome = reconstruct({"--spacing", "1", "--interpolation", "nearest", "--clip", "2", "1", "3", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto read = readVolume(folder / "v.mha");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->volume.grid.dims, glm::ivec3(4, 3, 5));
  EXPECT_EQ(read->volume.grid.origin_mm, glm::dvec3(2, 1, 0));
  EXPECT_EQ(read->volume.echo.front(), parallelSweepPixel(2, 1, 0));
}

TEST_F(ReconstructCommand, AVolumeOfAlmostNothingIsRefusedUntilItIsMeant) {
  const std::vector<std::string> little{"--spacing", "1", "--interpolation", "nearest", "--clip", "2", "1", "0", "2"};
  const auto refused = reconstruct(little);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("Only 6.3 % of the pixels"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find(": --accept-small."), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "v.mha"));
  auto meant = little;
  meant.emplace_back("--accept-small");
  EXPECT_EQ(reconstruct(meant).status, 0);
}

TEST_F(ReconstructCommand, ACalibrationInMetresIsRefusedUntilItIsMeant) {
  for (std::size_t n = 0; n < sweep.frames.size(); ++n) {
    sweep.frames[n].transforms = {{"Probe", "Reference", glm::dmat4(1.0), PoseStatus::ok}};
    sweep.frames[n].transforms[0].matrix[3].z = static_cast<double>(n);
  }
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  writeText(folder / "metres.xml",
            "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" "
            "Matrix=\"0.0001 0 0 0 0 0.0001 0 0 0 0 0.0001 0 0 0 0 1\"/></CoordinateDefinitions></PlusConfiguration>");
  const auto refused = reconstruct({"--spacing", "1", "--calibration", folder / "metres.xml"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("a pixel is 0.0001 x 0.0001 mm and the whole image 0.0008 x 0.0006 mm: is the matrix in metres?"),
            std::string::npos)
      << refused.err;
  EXPECT_NE(refused.err.find(": --accept-small."), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "v.mha"));
  EXPECT_EQ(reconstruct({"--spacing", "1", "--calibration", folder / "metres.xml", "--accept-small"}).status, 0);
}

TEST_F(ReconstructCommand, JoinsImagesWithPosesOfAnotherFile) {
  std::string table = "# transform: ImageToReference\ntime_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
  for (int n = 0; n < 5; ++n) table += std::to_string(10.0 + 0.1 * n) + ",0,0," + std::to_string(n) + ",1,0,0,0\n";
  writeText(folder / "p.csv", table);
  for (SequenceFrame& frame : sweep.frames) frame.transforms.clear();
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  const auto without = reconstruct({"--spacing", "1"});
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("--poses FILE"), std::string::npos) << without.err;
  const auto apart = reconstruct({"--spacing", "1", "--poses", folder / "p.csv"});
  EXPECT_EQ(apart.status, 1);
  EXPECT_NE(apart.err.find("images from 0 to 0.4 s (with an offset of 0 s), poses from 10 to 10.4 s"), std::string::npos) << apart.err;
  EXPECT_NE(apart.err.find(": --time-offset S."), std::string::npos) << apart.err;
  const auto joined = reconstruct(
      {"--spacing", "1", "--interpolation", "nearest", "--poses", folder / "p.csv", "--time-offset", "10", "--report", folder / "r.json"});
  ASSERT_EQ(joined.status, 0) << joined.err;
  const auto read = readVolume(folder / "v.mha");
  ASSERT_TRUE(read);
  const auto& grid = read->volume.grid;
  ASSERT_EQ(grid.dims, glm::ivec3(8, 6, 5));
  for (int k = 0; k < 5; ++k) EXPECT_EQ(read->volume.echo[grid.indexOf(3, 2, k)], parallelSweepPixel(3, 2, k));
  EXPECT_EQ(readJson(folder / "r.json")["options"]["poses"], std::string(folder / "p.csv"));
  const auto half = reconstruct({"--spacing", "1", "--poses", folder / "p.csv", "--time-offset", "10.2", "--report", folder / "r.json"});
  ASSERT_EQ(half.status, 0) << half.err;
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["frames_used"], 3);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["frames_invalid"], 2);
  EXPECT_NE(half.err.find("outside the times of the poses, which count as invalid: 2 of 5"), std::string::npos) << half.err;
  EXPECT_EQ(reconstruct({"--rate", "25"}).status, 2);
}

TEST_F(ReconstructCommand, TheCommandLineWinsOverTheCalibrationFile) {
  writeText(folder / "device.xml",
            "<PlusConfiguration><VolumeReconstruction OutputSpacing=\"2 2 2\" ClipRectangleOrigin=\"1 1\" ClipRectangleSize=\"5 3\" "
            "Interpolation=\"NEAREST_NEIGHBOR\" CompoundingMode=\"MAXIMUM\" /></PlusConfiguration>");
  const auto dims = [&](const std::vector<std::string>& more) {
    auto words = more;
    words.insert(words.end(), {"--calibration", folder / "device.xml", "--report", folder / "r.json"});
    const auto outcome = reconstruct(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto read = readVolume(folder / "v.mha");
    return read ? read->volume.grid.dims : glm::ivec3(0);
  };
  EXPECT_EQ(dims({"--spacing", "1"}), glm::ivec3(6, 4, 5));
  EXPECT_EQ(dims({"--spacing", "1", "--clip", "0", "0", "2", "2"}), glm::ivec3(3, 3, 5));
  EXPECT_EQ(dims({"--spacing", "1", "--no-clip"}), glm::ivec3(8, 6, 5));
  EXPECT_EQ(dims({}), glm::ivec3(4, 3, 3)) << "2 mm as the file says: round(5 / 2) + 1, round(3 / 2) + 1, round(4 / 2) + 1";
  EXPECT_EQ(readJson(folder / "r.json")["options"]["interpolation"], "nearest") << "the file's, as nothing else was said";
  EXPECT_EQ(readJson(folder / "r.json")["options"]["compounding"], "maximum");
  EXPECT_EQ(dims({"--interpolation", "linear", "--compounding", "mean"}), glm::ivec3(4, 3, 3));
  EXPECT_EQ(readJson(folder / "r.json")["options"]["interpolation"], "linear");
  EXPECT_EQ(readJson(folder / "r.json")["options"]["compounding"], "mean");
}

TEST_F(ReconstructCommand, FillsHolesOnlyWhenAsked) {
  sweep = parallelSweep(8, 6, 3);
  for (std::size_t n = 0; n < 3; ++n) sweep.frames[n].transforms[0].matrix[3].z = 3.0 * static_cast<double>(n);
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  ASSERT_EQ(reconstruct({"--spacing", "1", "--interpolation", "nearest", "--report", folder / "r.json"}).status, 0);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["voxels_interpolated"], 0);
  ASSERT_EQ(reconstruct({"--spacing", "1", "--interpolation", "nearest", "--fill-reach", "4", "--report", folder / "r.json"}).status, 0);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["voxels_interpolated"], 8 * 6 * 4);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["voxels_measured"], 8 * 6 * 3);
  const auto inMm = reconstruct({"--spacing", "1", "--interpolation", "nearest", "--fill-reach-mm", "4", "--report", folder / "r.json"});
  ASSERT_EQ(inMm.status, 0);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["voxels_interpolated"], 8 * 6 * 4);
  EXPECT_EQ(readJson(folder / "r.json")["options"]["fill_reach_mm"], 4.0);
  EXPECT_EQ(reconstruct({"--fill-reach-mm", "4", "--fill-reach", "4"}).status, 2);
  ASSERT_EQ(reconstruct({"--spacing", "1", "--fill", "--report", folder / "r.json"}).status, 0);
  EXPECT_EQ(readJson(folder / "r.json")["options"]["fill_reach_mm"], 7.5) << "2.5 times the 3 mm between frames";
  EXPECT_GT(readJson(folder / "r.json")["quality"]["voxels_interpolated"], 0);
  EXPECT_EQ(reconstruct({"--fill", "--fill-reach", "4"}).status, 2);
}

TEST_F(ReconstructCommand, ChoosesVoxelsThatTheFramesCarry) {
  ASSERT_EQ(reconstruct({"--report", folder / "r.json"}).status, 0);
  EXPECT_EQ(readJson(folder / "r.json")["options"]["spacing_mm"], 1.0) << "two pixels would be 2 mm, and voxels are at most 1 mm";
  EXPECT_EQ(readJson(folder / "r.json")["options"]["fill_reach_mm"], 0.0) << "as PLUS does, unless asked";
}

TEST_F(ReconstructCommand, WritesWhichFrameOfTheFileEachVoxelCameFrom) {
  sweep.frames[1].transforms[0].status = PoseStatus::invalid;
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  ASSERT_EQ(reconstruct({"--spacing", "1", "--interpolation", "nearest", "--provenance", folder / "p.mhd"}).status, 0);
  const std::string header = readText(folder / "p.mhd");
  EXPECT_NE(header.find("ElementType = MET_USHORT"), std::string::npos) << header;
  const std::string raw = readText(folder / "p.raw");
  std::set<int> frames;
  for (std::size_t n = 0; n + 1 < raw.size(); n += 2)
    frames.insert(static_cast<unsigned char>(raw[n]) + 256 * static_cast<unsigned char>(raw[n + 1]));
  // The second frame is not used; 0 stands between them, where nothing was measured.
  std::set<int> expected{0};
  for (std::size_t n = 0; n < sweep.frames.size(); ++n)
    if (n != 1) expected.insert(static_cast<int>(n) + 1);
  EXPECT_EQ(frames, expected);
}

TEST_F(ReconstructCommand, WeighsByConfidenceWhenAskedAndSaysHow) {
  const auto confidence = [&](const std::vector<std::string>& more) {
    auto words = more;
    words.insert(words.end(), {"--spacing", "1", "--report", folder / "r.json"});
    const auto outcome = reconstruct(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return readJson(folder / "r.json")["options"]["confidence"];
  };
  EXPECT_EQ(confidence({}), nullptr);
  EXPECT_EQ(confidence({"--compounding", "weighted"}), "beamwise");
  EXPECT_EQ(readJson(folder / "r.json")["options"]["compounding"], "weighted");
  EXPECT_EQ(confidence({"--compounding", "weighted", "--confidence", "randomwalk"}), "randomwalk");
  const auto without = reconstruct({"--confidence", "beamwise"});
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.err.find("--compounding weighted"), std::string::npos) << without.err;
}

TEST_F(ReconstructCommand, CountsTheFramesItLeavesOut) {
  sweep.frames[1].transforms[0].status = PoseStatus::invalid;
  sweep.frames[3].transforms.clear();
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  ASSERT_EQ(reconstruct({"--spacing", "1", "--report", folder / "r.json"}).status, 0);
  const auto quality = readJson(folder / "r.json")["quality"];
  EXPECT_EQ(quality["frames_used"], 3);
  EXPECT_EQ(quality["frames_invalid"], 1);
  EXPECT_EQ(quality["frames_missing"], 1);
}

TEST_F(ReconstructCommand, QuietSaysNothing) {
  const auto outcome = reconstruct({"--spacing", "1", "--quiet"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(ReconstructCommand, SaysWhatItNeedsBeforeItTakesIt) {
  const auto said = reconstruct({"--spacing", "0.3999999943166175"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.err.find(" voxels of 0.4 mm needs about "), std::string::npos) << said.err;
  EXPECT_NE(said.out.find(" voxels of 0.4 mm in the frame"), std::string::npos) << said.out;
}

TEST_F(ReconstructCommand, ProgressNeverGoesBack) {
  const auto said = reconstruct({"--spacing", "1", "--interpolation", "centred"});
  ASSERT_EQ(said.status, 0) << said.err;
  int before = -1;
  std::istringstream in(said.err);
  for (std::string line; std::getline(in, line);) {
    if (line.find(" %  ") == std::string::npos) continue;
    const int now = std::stoi(line);
    EXPECT_GE(now, before) << said.err;
    before = now;
  }
}

TEST_F(ReconstructCommand, ProgressIsPlainLinesInAFileAndABarOnATerminal) {
  const auto plain = reconstruct({"--spacing", "1"});
  EXPECT_NE(plain.err.find(" %  "), std::string::npos) << plain.err;
  EXPECT_EQ(plain.err.find('\r'), std::string::npos);
  const auto bar = run({"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha", "--spacing", "1"}, nullptr, true);
  EXPECT_NE(bar.err.find("\r\x1b[2K["), std::string::npos);
  EXPECT_EQ(bar.err.substr(bar.err.rfind('\r')), "\r\x1b[2K") << "the bar is gone in the end";
}

/// Every wrong input: status 1, one sentence, nothing left behind.
class WrongSweep : public ReconstructCommand {
 protected:
  void expectRefused(const std::vector<std::string>& more, const std::vector<std::string>& named) {
    const auto before = folder.names();
    auto words = more;
    words.insert(words.end(), {"--coverage", folder / "c.mha", "--report", folder / "r.json"});
    const auto outcome = reconstruct(words);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    const auto sentence = outcome.err.rfind("echoweave: ");
    ASSERT_NE(sentence, std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin() + static_cast<std::ptrdiff_t>(sentence), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const auto& part : named) EXPECT_NE(outcome.err.find(part, sentence), std::string::npos) << part << "\n" << outcome.err;
    EXPECT_EQ(folder.names(), before);
  }
};

TEST_F(WrongSweep, ATruncatedSequenceIsRefusedAtEveryLength) {
  const std::string whole = readText(folder / "s.igs.mha");
  for (std::size_t length : {std::size_t{0}, std::size_t{40}, whole.size() / 3, whole.size() / 2, whole.size() - 30, whole.size() - 1}) {
    writeText(folder / "s.igs.mha", whole.substr(0, length));
    expectRefused({}, {"s.igs.mha"});
  }
}

TEST_F(WrongSweep, AHeaderThatPromisesATerabyteIsRefusedAtOnce) {
  writeText(
      folder / "s.igs.mha",
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nCompressedData = False\nDimSize = 10000 10000 10000\nElementType = MET_UCHAR\n"
      "Kinds = domain domain list\nUltrasoundImageOrientation = MF\nElementDataFile = LOCAL\nabc");
  expectRefused({}, {"1000000000000"});
}

TEST_F(WrongSweep, ASweepWithoutASingleValidPoseIsRefused) {
  for (auto& frame : sweep.frames) frame.transforms[0].status = PoseStatus::invalid;
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  expectRefused({}, {"5"});
}

TEST_F(WrongSweep, AMissingCalibrationIsNamed) {
  for (auto& frame : sweep.frames) {
    frame.transforms[0].from = "Probe";
    frame.transforms[0].to = "Tracker";
  }
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  expectRefused({}, {"calibration"});
}

TEST_F(WrongSweep, AFrameNobodyKnowsIsNamed) { expectRefused({"--image-to", "Moon"}, {"Moon"}); }

TEST_F(WrongSweep, ACalibrationThatIsNotThereOrIsNoDeviceSetIsNamed) {
  expectRefused({"--calibration", folder / "none.xml"}, {"none.xml"});
  writeText(folder / "noise.xml", "not xml");
  expectRefused({"--calibration", folder / "noise.xml"}, {"noise.xml"});
}

TEST_F(WrongSweep, ASpacingThatNeedsMoreMemoryThanThereIsIsRefusedWithItsForecast) { expectRefused({"--spacing", "0.00002"}, {"spacing"}); }

TEST_F(WrongSweep, AClipOutsideTheFrameIsRefused) { expectRefused({"--clip", "20", "20", "5", "5"}, {"clip"}); }

TEST_F(WrongSweep, AClipThatReachesBeyondTheFrameIsRefused) {
  expectRefused({"--clip", "0", "0", "500", "500"}, {"The clip rectangle of 500 x 500 px from (0, 0) on reaches beyond the "});
}

TEST_F(WrongSweep, AnUnwritableOutputIsFoundBeforeTheSweepIsRead) {
  const auto outcome = run({"reconstruct", "no-such-sweep.igs.mha", "-o", "/proc/v.mha"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("/proc"), std::string::npos) << outcome.err;
}

TEST_F(WrongSweep, TheSweepItselfIsNeverWrittenOver) {
  const std::string before = readText(folder / "s.igs.mha");
  const auto outcome = run({"reconstruct", folder / "s.igs.mha", "-o", folder / "s.igs.mha"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(readText(folder / "s.igs.mha"), before);
}

TEST_F(WrongSweep, StoppingLeavesNothing) {
  const std::atomic<bool> cancel{true};
  const auto outcome = run({"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha", "--coverage", folder / "c.mha"}, &cancel);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("echoweave: "), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.igs.mha"});
}

}  // namespace
}  // namespace ew::test::reconstruct_test
