#include "logic/project.h"

#include <gtest/gtest.h>

#include "library/temporary_folder.h"
#include "stitching/fake_host.h"

namespace ew::test {

Result<std::string> PlainFiles::readText(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return failure(ErrorCode::notFound, "There is no file '" + file.string() + "'; check the name.");
  return textOf(file);
}
Result<void> PlainFiles::writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return {};
}

}  // namespace ew::test

namespace ew::stitching {
namespace {

using nlohmann::json;
using test::MemoryVolumes;
using test::PlainFiles;
using test::QuietLog;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

json identity() { return rowsOf(glm::dmat4(1.0)); }

Error refused(const json& project) {
  PlainFiles files;
  const auto parsed = parseProject(project.dump(), "/nowhere", files);
  EXPECT_FALSE(parsed) << project;
  return parsed ? Error{} : parsed.error();
}

TEST(StitchProject, IsReadBackEqual) {
  PlainFiles files;
  StitchProject project;
  project.volumes.push_back(
      {"/data/a.mha", "/data/a-coverage.mha", matrixFromRows({0, -1, 0, 4.25, 1, 0, 0, -1.0 / 3.0, 0, 0, 1, 1e-9, 0, 0, 0, 1}), "right"});
  project.volumes.push_back({"/elsewhere/b.nrrd", {}, glm::dmat4(1.0), "b.nrrd"});
  project.options.spacing_mm = 0.45;
  project.options.featherWidth_mm = 7.5;
  project.options.axes = GridAxes::world;
  const std::string text = projectText(project, "/data");
  EXPECT_NE(text.find("\"a.mha\""), std::string::npos) << "below the project's folder: relative";
  EXPECT_NE(text.find("\"/elsewhere/b.nrrd\""), std::string::npos);
  const auto read = parseProject(text, "/data", files);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, project);
}

TEST(StitchProject, TakesAPlaceFromAFileOfSixteenNumbers) {
  const TemporaryFolder folder;
  PlainFiles files;
  writeText(folder / "a.txt", "1 0 0 10\n0 1 0 20\n0 0 1 30\n0 0 0 1\n");
  const json project = {{"volumes", {{{"file", "a.mha"}, {"to_world", "a.txt"}}}}};
  const auto read = parseProject(project.dump(), folder.path(), files);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(glm::dvec3(read->volumes[0].toWorld[3]), glm::dvec3(10, 20, 30));
  EXPECT_EQ(read->volumes[0].file, folder / "a.mha");
  EXPECT_EQ(read->volumes[0].name, "a.mha");
  writeText(folder / "a.txt", "1 0 0 10\n0 1 0 20\n");
  EXPECT_EQ(parseProject(project.dump(), folder.path(), files).error().code, ErrorCode::badField);
  writeText(folder / "a.txt", "2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  EXPECT_EQ(parseProject(project.dump(), folder.path(), files).error().code, ErrorCode::notRigid);
}

TEST(StitchProject, ThatNestsWithoutEndIsRefused) {
  PlainFiles files;
  const auto project = parseProject("{\"volumes\": " + std::string(1000000, '[') + std::string(1000000, ']') + "}", "/nowhere", files);
  ASSERT_FALSE(project);
  EXPECT_EQ(project.error().code, ErrorCode::badHeader);
}

TEST(StitchProject, NamesTheFieldThatIsWrong) {
  const json good = {{"volumes", {{{"file", "a.mha"}, {"to_world", identity()}}}}};
  struct Wrong {
    const char* pointer;
    json value;
    const char* field;
  };
  const Wrong wrongs[] = {{"/volumes", json::array(), "volumes"},
                          {"/volumes", 3, "volumes"},
                          {"/volumes/0", "a.mha", "volumes[0]"},
                          {"/volumes/0/file", 4, "volumes[0].file"},
                          {"/volumes/0/file", "", "volumes[0].file"},
                          {"/volumes/0/to_world", json::array({1, 2}), "volumes[0].to_world"},
                          {"/volumes/0/place", identity(), "volumes[0].place"},
                          {"/spacing", 1, "spacing"},
                          {"/spacing_mm", "fine", "spacing_mm"},
                          {"/spacing_mm", -1, "spacing_mm"},
                          {"/feather_mm", -1, "feather_mm"},
                          {"/interpolated_weight", 0, "interpolated_weight"},
                          {"/axes", "sideways", "axes"},
                          {"/format", "one", "format"}};
  for (const auto& wrong : wrongs) {
    json project = good;
    project[json::json_pointer(wrong.pointer)] = wrong.value;
    const Error problem = refused(project);
    EXPECT_EQ(problem.code, ErrorCode::badField) << problem;
    EXPECT_NE(problem.sentence.find(std::string("'") + wrong.field + "'"), std::string::npos) << problem;
    EXPECT_TRUE(problem.sentence.ends_with('.')) << problem;
  }
  json mirrored = good;
  mirrored["volumes"][0]["to_world"][0] = -1;
  EXPECT_EQ(refused(mirrored).code, ErrorCode::notRigid);
  json newer = good;
  newer["format"] = 2;
  EXPECT_EQ(refused(newer).code, ErrorCode::newerFormat);
  PlainFiles files;
  EXPECT_EQ(parseProject("{\"volumes\": [", "/", files).error().code, ErrorCode::badHeader);
  EXPECT_EQ(parseProject("[]", "/", files).error().code, ErrorCode::badField);
}

/// A project of two overlapping constants in memory, run as the command.
class StitchCommand : public testing::Test {
 protected:
  StitchCommand() {
    Volume a;
    a.grid.dims = {8, 4, 4};
    a.echo.assign(128, 40);
    volumes.volumes[(folder / "a.mha").string()] = a;
    a.echo.assign(128, 80);
    volumes.volumes[(folder / "b.mha").string()] = a;
    json place = identity();
    place[3] = 4.0;
    writeText(folder / "p.json", json{{"volumes", {{{"file", "a.mha"}}, {{"file", "b.mha"}, {"to_world", place}}}}}.dump());
  }
  Result<sdk::Commands::Outcome> run(const std::vector<std::string>& args) {
    return runStitchCommand(args, volumes, files, log, noProgress());
  }
  std::size_t entriesOf(const std::filesystem::path& where) const {
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(where)) ++entries;
    return entries;
  }

  TemporaryFolder folder;
  PlainFiles files;
  MemoryVolumes volumes{files};
  QuietLog log;
};

TEST_F(StitchCommand, WritesVolumeCoverageSourceAndProvenance) {
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string(), "--threads", "2"});
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->outputs.size(), 4u);
  for (const auto& file : outcome->outputs) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(entriesOf(folder / "out"), 4u);
  EXPECT_EQ(volumes.written["volume.mha"].grid.dims, glm::ivec3(12, 4, 4));
  const json provenance = json::parse(textOf(folder / "out/provenance.json"));
  EXPECT_EQ(provenance["inputs"].size(), 2u);
  EXPECT_EQ(provenance["inputs"][1]["to_world"][3], 4.0);
  EXPECT_NEAR(provenance["overlap_share"].get<double>(), 4.0 / 12.0, 1e-12);
}

TEST_F(StitchCommand, LeavesNothingBehindWhenWritingFails) {
  for (const int writes : {0, 1, 2}) {
    volumes.writesLeft = writes;
    const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string()});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::notWritable);
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "a folder made for this goes again";
  }
  std::filesystem::create_directory(folder / "old");
  writeText(folder / "old/volume.mha", "the result of last week");
  volumes.writesLeft = 2;
  ASSERT_FALSE(run({(folder / "p.json").string(), "-o", (folder / "old").string()}));
  EXPECT_EQ(textOf(folder / "old/volume.mha"), "the result of last week");
  EXPECT_EQ(entriesOf(folder / "old"), 1u);
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
    EXPECT_NE(outcome.error().sentence.find(kStitchUsage), std::string::npos) << outcome.error();
  }
  EXPECT_EQ(run({"nowhere.json", "-o", "x"}).error().code, ErrorCode::notFound);
}

TEST_F(StitchCommand, SaysWhichVolumeIsNotThere) {
  volumes.volumes.erase((folder / "b.mha").string());
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string()});
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.error().sentence.find("b.mha"), std::string::npos);
}

}  // namespace
}  // namespace ew::stitching
