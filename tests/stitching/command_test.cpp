#include "logic/command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/io/volume_file.h"
#include "library/temporary_folder.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

/// A project of two overlapping constants, run as the command.
class StitchCommand : public testing::Test {
 protected:
  StitchCommand() {
    Volume a;
    a.grid.dims = {8, 4, 4};
    a.echo.assign(128, 40);
    EXPECT_TRUE(writeVolume(a, folder / "a.mha"));
    a.echo.assign(128, 80);
    EXPECT_TRUE(writeVolume(a, folder / "b.mha"));
    json place = rowsOf(glm::dmat4(1.0));
    place[3] = 4.0;
    writeText(folder / "p.json", json{{"volumes", {{{"file", "a.mha"}}, {{"file", "b.mha"}, {"to_world", place}}}}}.dump());
  }
  Result<sdk::Commands::Outcome> run(const std::vector<std::string>& args) {
    auto outcome = runStitchCommand(args, noProgress());
    if (outcome && outcome->putInPlace)
      if (auto put = outcome->putInPlace(); !put) return passOn(put.error());
    return outcome;
  }
  std::size_t entriesOf(const std::filesystem::path& where) const {
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(where)) ++entries;
    return entries;
  }

  TemporaryFolder folder;
};

TEST_F(StitchCommand, WritesVolumeCoverageSourceAndProvenance) {
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string(), "--threads", "2"});
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->outputs.size(), 5u);
  for (const auto& file : outcome->outputs) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(entriesOf(folder / "out"), 6u) << "and the folder of the steps";
  const auto made = readVolume(folder / "out/volume.mha");
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->volume.grid.dims, glm::ivec3(12, 4, 4));
  const json provenance = json::parse(textOf(folder / "out/provenance.json"));
  EXPECT_EQ(provenance["inputs"].size(), 2u);
  EXPECT_EQ(provenance["inputs"][1]["to_world"][3], 4.0);
  EXPECT_NEAR(provenance["overlap_share"].get<double>(), 4.0 / 12.0, 1e-12);
}

TEST_F(StitchCommand, LeavesNoHalfResultWhenWritingFails) {
  const std::string out = (folder / "out").string();
  ASSERT_TRUE(run({(folder / "p.json").string(), "-o", out}));
  const std::string before = textOf(folder / "out/provenance.json");
  json project = json::parse(textOf(folder / "p.json"));
  project["spacing_mm"] = 2.0;
  writeText(folder / "p.json", project.dump());
  // The same run elsewhere tells under which names the result waits; a folder that is not empty cannot become a file.
  ASSERT_TRUE(run({(folder / "p.json").string(), "-o", (folder / "elsewhere").string()}));
  std::string key;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "elsewhere/steps/volume"))
    if (entry.path().extension() == ".json") key = entry.path().stem().string();
  for (const char* name : {"volume.mha", "coverage.mha", "source.mha", "level.mha", "provenance.json"}) {
    const auto inTheWay = folder / "out/steps/volume" / (key + "-" + name);
    std::filesystem::create_directories(inTheWay / "full");
    const auto outcome = run({(folder / "p.json").string(), "-o", out});
    ASSERT_FALSE(outcome) << name;
    EXPECT_EQ(outcome.error().code, ErrorCode::notWritable) << outcome.error();
    EXPECT_EQ(textOf(folder / "out/provenance.json"), before) << "the result of last week";
    EXPECT_EQ(entriesOf(folder / "out"), 6u);
    std::filesystem::remove_all(inTheWay);
  }
  ASSERT_TRUE(run({(folder / "p.json").string(), "-o", out}));
  EXPECT_NE(textOf(folder / "out/provenance.json"), before);
}

TEST_F(StitchCommand, AResultWaitsUntilItIsPutInPlaceAndIsNotMadeAgain) {
  const std::string out = (folder / "out").string();
  {
    const auto outcome = runStitchCommand({(folder / "p.json").string(), "-o", out}, noProgress());
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(entriesOf(out), 1u) << "the folder of the steps";
  }
  const auto again = run({(folder / "p.json").string(), "-o", out});
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(entriesOf(out), 6u);
  EXPECT_EQ(again->quality.front(), (std::pair<std::string, double>{"steps_reused", 7.0}));
}

TEST_F(StitchCommand, NeverWritesOverItsInputsNorOverAForeignResult) {
  writeText(folder / "volume.mha", "my only copy");
  const auto foreign = run({(folder / "p.json").string(), "-o", folder.path().string()});
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.error().code, ErrorCode::notWritable) << foreign.error();
  EXPECT_EQ(textOf(folder / "volume.mha"), "my only copy");
  EXPECT_FALSE(std::filesystem::exists(folder / "steps")) << "refused before anything is made";
  std::filesystem::copy_file(folder / "a.mha", folder / "volume.mha", std::filesystem::copy_options::overwrite_existing);
  const std::string own = textOf(folder / "volume.mha");
  writeText(folder / "p.json", json{{"volumes", {{{"file", "volume.mha"}}}}}.dump());
  const auto input = run({(folder / "p.json").string(), "-o", folder.path().string()});
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, ErrorCode::badUsage) << input.error();
  EXPECT_EQ(textOf(folder / "volume.mha"), own);
}

TEST_F(StitchCommand, TellsHowEachPairEndedAndWhatNothingChecks) {
  json project = json::parse(textOf(folder / "p.json"));
  project["format"] = 2;
  project["settings"] = {{"elastic", false}};
  for (auto& volume : project["volumes"]) {
    volume["placement"] = "unknown";
    volume.erase("to_world");
  }
  json start = rowsOf(glm::dmat4(1.0));
  start[3] = -4.0;
  project["pairs"] = {{{"fixed", "a.mha"}, {"moving", "b.mha"}, {"method", "by hand"}, {"start", start}}};
  writeText(folder / "p.json", project.dump());
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string()});
  ASSERT_TRUE(outcome) << outcome.error();
  ASSERT_GE(outcome->notes.size(), 2u);
  EXPECT_EQ(outcome->notes[0].english(), "'a.mha' with 'b.mha': by hand, not checked. Placed by hand.");
  EXPECT_NE(outcome->notes[1].english().find("No loop checks"), std::string::npos) << outcome->notes[1];
}

TEST_F(StitchCommand, SaysHowItIsUsed) {
  const std::string project = (folder / "p.json").string();
  for (const auto& args : std::vector<std::vector<std::string>>{{},
                                                                {project},
                                                                {"-o", "x"},
                                                                {project, "-o"},
                                                                {project, "-o", "x", "--threads", "-2"},
                                                                {project, "-o", "x", "--threads", "many"},
                                                                {project, "-o", "x", "--quick"},
                                                                {project, project, "-o", "x"}}) {
    const auto outcome = run(args);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::badUsage);
    EXPECT_NE(outcome.error().sentence().find(kStitchUsage), std::string::npos) << outcome.error();
  }
  EXPECT_EQ(run({"nowhere.json", "-o", "x"}).error().code, ErrorCode::notFound);
}

TEST_F(StitchCommand, SaysWhichVolumeIsNotThere) {
  std::filesystem::remove(folder / "b.mha");
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string()});
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.error().sentence().find("b.mha"), std::string::npos);
}

}  // namespace
}  // namespace ew::stitching
