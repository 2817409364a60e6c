#include "ew/tracking/calibration_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "made_tools.h"

namespace ew::calibration_file_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class CalibrationFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ =
        fs::path(::testing::TempDir()) / ("ew_calibration_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(root_);
  }
  void TearDown() override { fs::remove_all(root_); }
  static TrackerCalibration made() {
    test::Dice dice(3);
    TrackerCalibration calibration;
    calibration.source = "camera: /dev/video0";
    calibration.tool = "box-60";
    calibration.reference = "mannequin-board";
    calibration.body = "box-60";
    calibration.mannequin = "adult";
    calibration.probeToTool = test::anywhere<frame::Tool, frame::Probe>(dice);
    calibration.trackerToWorld = test::anywhere<frame::World, frame::Tracker>(dice);
    calibration.face = {"body_file", "2026-11-27T08:00:00Z", 0.0, 0.5, 1};
    calibration.alignment = {"landmarks", "2026-11-27T08:01:00Z", 1.1, 1.9, 5};
    return calibration;
  }
  json document() {
    auto kept = keepCalibration(root_, made());
    EXPECT_TRUE(kept);
    return json::parse(std::ifstream(calibrationRevisions(root_, made().source, made().tool).back()));
  }
  Result<TrackerCalibration> readBack(const json& value) {
    fs::create_directories(root_);
    std::ofstream(root_ / "one.json") << value;
    return readCalibration(root_ / "one.json");
  }
  fs::path root_;
};

TEST_F(CalibrationFiles, AreReadAsTheyWereWrittenToTheLastBit) {
  const auto kept = keepCalibration(root_, made());
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->revision, 1);
  const auto read = latestCalibration(root_, made().source, made().tool);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, *kept);
}

TEST_F(CalibrationFiles, CountRevisionsAndLeaveTheOlderOnes) {
  for (int n = 1; n <= 12; ++n) {
    auto next = made();
    next.alignment.samples = n;
    const auto kept = keepCalibration(root_, next);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->revision, n);
  }
  const auto files = calibrationRevisions(root_, made().source, made().tool);
  ASSERT_EQ(files.size(), 12u);
  EXPECT_EQ(readCalibration(files.front())->alignment.samples, 1);
  EXPECT_EQ(latestCalibration(root_, made().source, made().tool)->alignment.samples, 12);
  EXPECT_EQ(latestCalibration(root_, made().source, "another")->revision, 0);
  auto another = made();
  another.tool = "box/60";
  ASSERT_TRUE(keepCalibration(root_, another));
  EXPECT_EQ(latestCalibration(root_, another.source, "box/60")->tool, "box/60");
  EXPECT_EQ(calibrationRevisions(root_, made().source, made().tool).size(), 12u);
}

TEST_F(CalibrationFiles, RefuseANewerFormatAndEveryMissingOrCrookedField) {
  json whole = document();
  EXPECT_TRUE(readBack(whole));
  json newer = whole;
  newer["format"] = TrackerCalibration::kFormat + 1;
  EXPECT_EQ(readBack(newer).error().code, ErrorCode::newerFormat);
  for (const auto& item : whole.items()) {
    json part = whole;
    part.erase(item.key());
    EXPECT_FALSE(readBack(part)) << item.key();
  }
  json crooked = whole;
  crooked["probe_to_tool"][0] = 2.0;
  EXPECT_FALSE(readBack(crooked));
  json extra = whole;
  extra["colour"] = 1;
  EXPECT_FALSE(readBack(extra));
  EXPECT_EQ(readCalibration(root_ / "no-such.json").error().code, ErrorCode::notFound);
  auto wrong = made();
  wrong.trackerToWorld.matrix[0] *= 1.5;
  EXPECT_FALSE(keepCalibration(root_, wrong));
  EXPECT_EQ(calibrationRevisions(root_, made().source, made().tool).size(), 1u) << "nothing was written";
}

TEST_F(CalibrationFiles, SayWhenTheFolderCannotBeWritten) {
  fs::create_directories(root_.parent_path());
  std::ofstream(root_) << "a file in its way";
  const auto kept = keepCalibration(root_, made());
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

}  // namespace
}  // namespace ew::calibration_file_test
