#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "ew/cli/run_command.h"
#include "ew/tracking/calibration_file.h"
#include "places.h"

namespace ew::test::tracker_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class TrackerCommand : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  EnvironmentValue library_{"ECHOWEAVE_LIBRARY", folder_ / "library"};
};

TEST_F(TrackerCommand, PrintsWhatACameraNeedsOrWhatIsAskedFor) {
  const auto usual = run({"tracker", "print", "-o", folder_ / "marker.pdf", "--report", folder_ / "r.json"});
  EXPECT_EQ(usual.status, cli::kDone) << usual.err;
  EXPECT_EQ(readText(folder_ / "marker.pdf").substr(0, 5), "%PDF-");
  EXPECT_NE(usual.out.find("3 sheets"), std::string::npos) << usual.out;
  const json report = readJson(folder_ / "r.json");
  EXPECT_EQ(report["quality"]["pages"], 3);
  EXPECT_EQ(report["outputs"], json::array({folder_ / "marker.pdf"}));
  const auto one = run({"tracker", "print", "sleeve", "sleeve", "-o", folder_ / "one.pdf", "--paper", "letter", "--language", "de"});
  EXPECT_EQ(one.status, cli::kDone) << one.err;
  EXPECT_NE(one.out.find("1 sheet "), std::string::npos) << one.out;
}

TEST_F(TrackerCommand, RefusesABodyThatIsNotThereAndWritesNothing) {
  const auto outcome = run({"tracker", "print", "box-99", "-o", folder_ / "marker.pdf"});
  EXPECT_EQ(outcome.status, cli::kWrongUsage);
  EXPECT_NE(outcome.err.find("box-60"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "marker.pdf"));
  EXPECT_EQ(run({"tracker", "print"}).status, cli::kWrongUsage);
}

TEST_F(TrackerCommand, KeepsTheMeasuredScaleForTheNextTime) {
  EXPECT_EQ(run({"tracker", "print", "--measured-scale", "98.5"}).status, cli::kDone);
  const auto listed = run({"tracker", "list", "--json"});
  EXPECT_EQ(listed.status, cli::kDone) << listed.err;
  EXPECT_EQ(json::parse(listed.out)["measured_scale_mm"], 98.5);
  EXPECT_EQ(run({"tracker", "print", "--measured-scale", "80"}).status, cli::kWrongUsage);
}

TEST_F(TrackerCommand, ListsTheUsersBodiesBesideOurs) {
  fs::create_directories(fs::path(folder_ / "library") / "trackers" / "bodies");
  json own = json::parse(std::ifstream(fs::path(EW_SOURCE_DIR) / "resources" / "marker_bodies" / "mannequin-board.json"));
  own["panels"][0]["grid"]["first"] = 100;
  own["name"]["en"] = "Board of our school";
  std::ofstream(fs::path(folder_ / "library") / "trackers" / "bodies" / "school.json") << own;
  const auto listed = run({"tracker", "list"});
  EXPECT_EQ(listed.status, cli::kDone) << listed.err;
  for (const char* part : {"box-60", "sleeve", "Board of our school", "Cameras:", "SpaceMouse", "game controller"})
    EXPECT_NE(listed.out.find(part), std::string::npos) << part << "\n" << listed.out;
}

TEST_F(TrackerCommand, CheckAnswersNoForACalibrationOfWhichAPartIsMissing) {
  TrackerCalibration calibration;
  calibration.source = "camera";
  calibration.tool = "box-60";
  calibration.face = {"body_file", "2026-11-27T08:00:00Z", 0.0, 0.5, 1};
  ASSERT_TRUE(keepCalibration(folder_.path() / "calibrations", calibration));
  calibration.alignment = {"landmarks", "2026-11-27T08:01:00Z", 1.1, 1.9, 5};
  ASSERT_TRUE(keepCalibration(folder_.path() / "calibrations", calibration));
  const auto files = calibrationRevisions(folder_.path() / "calibrations", "camera", "box-60");
  ASSERT_EQ(files.size(), 2u);
  const auto half = run({"tracker", "check", files[0].string()});
  EXPECT_EQ(half.status, cli::kVerdict) << half.err;
  EXPECT_NE(half.out.find("alignment: not calibrated"), std::string::npos) << half.out;
  const auto whole = run({"tracker", "check", files[1].string(), "--report", folder_ / "r.json"});
  EXPECT_EQ(whole.status, cli::kDone) << whole.err;
  EXPECT_EQ(readJson(folder_ / "r.json")["verdict"], "usable");
  const auto missing = run({"tracker", "check", folder_ / "no.json"});
  EXPECT_EQ(missing.status, cli::kFailed);
  EXPECT_EQ(missing.out, "");
}

}  // namespace
}  // namespace ew::test::tracker_test
