#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/library/case.h"

namespace ew::test::phantom_test {
namespace {

/// The recipe of a shipped virtual patient; empty when none is shipped.
std::string shippedPatient() {
  const auto folder = shippedCasesFolder();
  if (!folder) return {};
  for (const auto& each : listCases(*folder).cases)
    if (!each.volume.recipe.empty()) return (each.folder / each.volume.recipe).string();
  return {};
}

TEST(PhantomCommand, WritesTruthAndSurfacesOfTheChosenParameters) {
  const auto folder = shippedCasesFolder();
  ASSERT_TRUE(folder);
  const std::string patient = (*folder / "upper-abdomen-gall-stone" / "patient.json").string();
  const TemporaryFolder out;
  const auto outcome = run({"phantom", patient, "--set", "stone_diameter_mm=9", "--truth", out / "truth.json", "--surface",
                            "gall stone=" + (out / "stone.stl"), "--edge", "0.7"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto truth = readJson(out / "truth.json");
  EXPECT_EQ(truth["parameters"]["stone_diameter_mm"]["value"], 9.0);
  bool found = false;
  for (const auto& each : truth["measurements"]) {
    if (each["name"] != "gall stone, width") continue;
    found = true;
    EXPECT_NEAR(each["value"].get<double>(), 9.0, 0.05);
    EXPECT_EQ(each["unit"], "mm");
  }
  EXPECT_TRUE(found);
  EXPECT_FALSE(truth["planes"].empty());
  EXPECT_GT(std::filesystem::file_size(out / "stone.stl"), 10000u);
  EXPECT_NE(run({"phantom", patient, "--surface", "gall stone", "--truth", out / "t.json"}).status, 0) << "a surface without a file";
  EXPECT_NE(run({"phantom", patient, "--set", "stone_diameter_mm=99", "--truth", out / "t.json"}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(out / "t.json"));
}

TEST(PhantomCommand, WritesTheLevelOfTissuesOnTheGridOfTheEcho) {
  const std::string patient = shippedPatient();
  ASSERT_FALSE(patient.empty());
  const TemporaryFolder folder;
  const auto outcome = run({"phantom", patient, "--volume", folder / "echo.mha", "--level", folder / "level.mha", "--spacing", "6"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto echo = readVolume(folder / "echo.mha"), level = readVolume(folder / "level.mha");
  ASSERT_TRUE(echo && level);
  EXPECT_EQ(level->volume.grid, echo->volume.grid);
  EXPECT_NE(level->volume.echo, echo->volume.echo);
  EXPECT_NE(outcome.out.find("reflecting surface"), std::string::npos) << outcome.out;
}

TEST(PhantomCommand, WritesEchoAndLabelsOfOneGridTheSameForEveryThreadCount) {
  const std::string patient = shippedPatient();
  ASSERT_FALSE(patient.empty()) << "a shipped case has a virtual patient";
  const TemporaryFolder folder;
  const auto make = [&](const std::string& name, const std::string& threads) {
    return run({"phantom", patient, "--volume", folder / (name + ".mha"), "--labels", folder / (name + "_labels.mha"), "--spacing", "6",
                "--seed", "7", "--threads", threads, "--report", folder / (name + ".json")});
  };
  const auto one = make("one", "1");
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(make("two", "2").status, 0);
  const auto volume = readVolume(folder / "one.mha"), again = readVolume(folder / "two.mha"),
             labels = readVolume(folder / "one_labels.mha");
  ASSERT_TRUE(volume && again && labels);
  EXPECT_EQ(volume->volume.echo, again->volume.echo);
  EXPECT_EQ(volume->volume.grid, labels->volume.grid);
  EXPECT_NEAR(volume->volume.grid.spacing_mm.x, 6.0, 1e-9);

  const auto report = readJson(folder / "one.json");
  EXPECT_EQ(report["seed"], 7);
  EXPECT_EQ(report["outputs"].size(), 2u);
  ASSERT_GT(report["organs"].size(), 3u);
  std::size_t counted = 0, liver_voxels = 0;
  for (const auto& organ : report["organs"]) {
    counted += organ["voxels"].get<std::size_t>();
    if (organ["name"] == "liver") liver_voxels = organ["voxels"];
  }
  std::size_t labelled = 0;
  for (const auto label : labels->volume.echo) labelled += label > 0 ? 1u : 0u;
  EXPECT_EQ(counted, labelled);
  EXPECT_GT(liver_voxels, 100u);
}

TEST(PhantomCommand, RefusesWhatIsNoPatientAndLeavesNothing) {
  const TemporaryFolder folder;
  writeText(folder / "p.json", "{\"organs\": 3}");
  writeText(folder / "broken.json", "{");
  for (const std::string name : {"p.json", "broken.json", "missing.json"}) {
    const auto outcome = run({"phantom", folder / name, "--volume", folder / "v.mha", "--report", folder / "r.json"});
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_EQ(outcome.err.rfind("echoweave: ", 0), 0u) << outcome.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"broken.json", "p.json"})) << name;
  }
}

TEST(PhantomCommand, RefusesASpacingThatNeedsMoreMemoryThanThereIs) {
  const std::string patient = shippedPatient();
  ASSERT_FALSE(patient.empty());
  const TemporaryFolder folder;
  const auto outcome = run({"phantom", patient, "--volume", folder / "v.mha", "--spacing", "0.01"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("spacing"), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(PhantomCommand, TellsHowBloodFlows) {
  const auto folder = shippedCasesFolder();
  ASSERT_TRUE(folder);
  const std::string neck = (*folder / "neck-carotid-thyroid" / "patient.json").string();
  const TemporaryFolder out;
  const auto outcome = run({"phantom", neck, "--blood", "33.2", "-4.5", "259.05", "--time", "0.2", "--truth", out / "truth.json",
                            "--report", out / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto blood = readJson(out / "report.json")["blood"];
  EXPECT_TRUE(blood["stream"].get<std::string>().starts_with("left ")) << blood;
  EXPECT_GT(blood["greatest_cm_per_s"].get<double>(), 30.0) << "systole";
  EXPECT_NEAR(blood["diameter_mm"].get<double>(), 6.0, 0.05);
  const auto flow = readJson(out / "truth.json")["flow"];
  EXPECT_EQ(flow["streams"].size(), 6u);
  for (const auto& stream : flow["streams"]) {
    EXPECT_GT(stream["psv_cm_per_s"].get<double>(), stream["edv_cm_per_s"].get<double>());
    EXPECT_GT(stream["ri"].get<double>(), 0.5);
  }
  ASSERT_EQ(flow["stenoses"].size(), 1u);
  EXPECT_EQ(flow["stenoses"][0]["stream"], "right internal carotid artery");

  EXPECT_EQ(run({"phantom", neck, "--blood", "0", "0", "0"}).status, 1) << "no vessel is there";
  const std::string stone = (*folder / "upper-abdomen-gall-stone" / "patient.json").string();
  EXPECT_NE(run({"phantom", stone, "--blood", "0", "0", "0"}).status, 0) << "its recipe says nothing of flow";
}

}  // namespace
}  // namespace ew::test::phantom_test
