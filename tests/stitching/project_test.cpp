#include "logic/project.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "logic/chain.h"

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

glm::dmat4 oddPlace() { return matrixFromRows({0, -1, 0, 4.25, 1, 0, 0, -1.0 / 3.0, 0, 0, 1, 1e-9, 0, 0, 0, 1}); }

/// A project in which no field has its default.
StitchProject fullProject() {
  StitchProject project;
  ProjectVolume right;
  right.file = "/data/a.mha";
  right.coverage = "/data/a-coverage.mha";
  right.confidence = "/data/maps/a.mha";
  right.placement = Placement::hand;
  right.toWorld = oddPlace();
  right.name = "right";
  ProjectVolume sweep;
  sweep.file = "/elsewhere/b.igs.mha";
  sweep.calibration = "/data/set.xml";
  sweep.spacing_mm = 0.7;
  sweep.placement = Placement::unknown;
  sweep.name = "b.igs.mha";
  ProjectVolume third;
  third.file = "/data/c.nrrd";
  third.name = "c.nrrd";
  project.volumes = {right, sweep, third};
  ProjectPair pair;
  pair.fixed = 0;
  pair.moving = 2;
  pair.method = PairMethod::byHand;
  pair.decision = Decision::accepted;
  pair.start = oddPlace();
  pair.landmarks = {{"gall bladder", {1, 2, 3}, {4, 5, 1.0 / 7.0}}, {"2", {0, 0, 1}, {1e-3, 0, 0}}};
  pair.maxTurn_deg = 60.0;
  pair.effort = registration::ElasticEffort::fast;
  ProjectPair other;
  other.fixed = 1;
  other.moving = 2;
  other.decision = Decision::rejected;
  project.pairs = {pair, other};
  ProjectSettings& settings = project.settings;
  settings.maxTurn_deg = 45.0;
  settings.trackerError_mm = 5.5;
  settings.trackerError_deg = 4.0;
  settings.equalise = false;
  settings.elastic = false;
  settings.effort = registration::ElasticEffort::accurate;
  settings.fallOff_mm = 31.0;
  settings.join.grid.spacing_mm = 0.45;
  settings.join.grid.featherWidth_mm = 7.5;
  settings.join.grid.interpolatedWeight = 0.5;
  settings.join.grid.axes = GridAxes::world;
  settings.join.seam.method = SeamMethod::nearest;
  settings.join.seam.cell_mm = 2.0;
  settings.join.seam.blend_mm = 3.0;
  settings.join.seam.confidenceWeight = 0.75;
  settings.join.seam.distanceWeight = 0.2;
  settings.join.seam.strokes = {{2, {1, -2, 3.5}, 8.0}};
  return project;
}

TEST(StitchProject, IsReadBackEqual) {
  PlainFiles files;
  const StitchProject project = fullProject();
  const std::string text = projectText(project, "/data");
  EXPECT_NE(text.find("\"a.mha\""), std::string::npos) << "below the project's folder: relative";
  EXPECT_NE(text.find("\"maps/a.mha\""), std::string::npos);
  EXPECT_NE(text.find("\"/elsewhere/b.igs.mha\""), std::string::npos);
  const auto read = parseProject(text, "/data", files);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, project);
  EXPECT_EQ(projectText(*read, "/data"), text);
  StitchProject plain;
  plain.volumes = {project.volumes[2]};
  const auto defaults = parseProject(R"({"format": 2, "volumes": [{"file": "c.nrrd"}]})", "/data", files);
  ASSERT_TRUE(defaults) << defaults.error();
  EXPECT_EQ(*defaults, plain) << "what is left out is what a new project has";
}

TEST(StitchProject, DiffersFromItselfWithAnyFieldOfTheFileChanged) {
  PlainFiles files;
  const json all = json::parse(projectText(fullProject(), "/data")).flatten();
  const auto plain = [&] { return *parseProject(all.unflatten().dump(), "/data", files); };
  for (const auto& [pointer, value] : all.items()) {
    json changed = all;
    if (value.is_number() && pointer.find("to_world") == std::string::npos && pointer.find("start") == std::string::npos &&
        pointer != "/format") {
      changed[pointer] = value.get<double>() * 0.5 + 0.3;
    } else if (value.is_boolean()) {
      changed[pointer] = !value.get<bool>();
    } else {
      continue;
    }
    const auto read = parseProject(changed.unflatten().dump(), "/data", files);
    ASSERT_TRUE(read) << pointer << read.error();
    EXPECT_FALSE(*read == plain()) << pointer;
  }
}

TEST(StitchProject, EffortOfAPairComesBeforeTheProjectsAndSaysNothingOfItsPose) {
  StitchProject project = fullProject();
  EXPECT_EQ(effortOf(project, 0, 2), registration::ElasticEffort::fast);
  EXPECT_EQ(effortOf(project, 2, 0), registration::ElasticEffort::fast);
  EXPECT_EQ(effortOf(project, 1, 2), project.settings.effort);
  EXPECT_TRUE(speaksOfPose(project.pairs[0]));
  ProjectPair alone;
  alone.fixed = 1;
  alone.moving = 2;
  EXPECT_TRUE(speaksOfPose(alone)) << "an entry that says nothing asks for a look";
  alone.effort = registration::ElasticEffort::fast;
  EXPECT_FALSE(speaksOfPose(alone));
  alone.decision = Decision::accepted;
  EXPECT_TRUE(speaksOfPose(alone));
}

/// Names of all fields, "pairs[].landmarks[].name" and so on.
void fieldsOf(const json& value, const std::string& name, std::set<std::string>& fields) {
  if (value.is_object()) {
    for (const auto& [key, each] : value.items()) {
      const std::string path = name.empty() ? key : name + "." + key;
      fields.insert(path);
      fieldsOf(each, path, fields);
    }
  } else if (value.is_array()) {
    for (const auto& each : value) fieldsOf(each, name + "[]", fields);
  }
}

void fieldsOfSchema(const json& schema, const std::string& name, std::set<std::string>& fields) {
  const json properties = schema.value("properties", json::object());
  for (const auto& [key, each] : properties.items()) {
    const std::string path = name.empty() ? key : name + "." + key;
    fields.insert(path);
    fieldsOfSchema(each, path, fields);
  }
  if (schema.contains("items")) fieldsOfSchema(schema["items"], name + "[]", fields);
}

TEST(StitchProject, HasTheFieldsOfItsSchemaAndNoOthers) {
  std::set<std::string> written, described;
  fieldsOf(json::parse(projectText(fullProject(), "/data")), "", written);
  fieldsOfSchema(json::parse(textOf(EW_SOURCE_DIR "/resources/schemas/stitch.schema.json")), "", described);
  EXPECT_EQ(written, described);
}

TEST(StitchProject, OfTheFirstFormatJoinsVolumesAsTheyLie) {
  PlainFiles files;
  const auto read = parseProject(R"({"format": 1, "volumes": [{"file": "a.mha", "name": "x"}, {"file": "b.mha", "name": "x"},
                                     {"file": "b.mha"}], "spacing_mm": 0.5, "feather_mm": 4, "axes": "world"})",
                                 "/data", files);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->settings.trackerError_mm, 0.0);
  EXPECT_FALSE(read->settings.elastic);
  EXPECT_FALSE(read->settings.equalise);
  EXPECT_EQ(read->settings.join.seam.method, SeamMethod::feather);
  EXPECT_EQ(read->settings.join.grid.spacing_mm, 0.5);
  EXPECT_EQ(read->settings.join.grid.featherWidth_mm, 4.0);
  EXPECT_EQ(read->settings.join.grid.axes, GridAxes::world);
  EXPECT_EQ(read->volumes[0].name, "x");
  EXPECT_EQ(read->volumes[1].name, "b.mha") << "names could repeat; now each has its own";
  EXPECT_EQ(read->volumes[2].name, "b.mha (2)");
  const auto again = parseProject(projectText(*read, "/data"), "/data", files);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, *read) << "saved as format 2 it says the same";
}

TEST(StitchProject, TurnsAPairThatIsWrittenTheOtherWayRound) {
  PlainFiles files;
  json project = {{"format", 2}, {"volumes", {{{"file", "a.mha"}}, {{"file", "b.mha"}}}}};
  project["pairs"] = {{{"fixed", "b.mha"},
                       {"moving", "a.mha"},
                       {"start", rowsOf(oddPlace())},
                       {"landmarks", {{{"fixed_mm", {1, 2, 3}}, {"moving_mm", {4, 5, 6}}}}}}};
  const auto read = parseProject(project.dump(), "/data", files);
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->pairs.size(), 1u);
  const ProjectPair& pair = read->pairs[0];
  EXPECT_EQ(pair.fixed, 0u);
  EXPECT_EQ(pair.moving, 1u);
  EXPECT_EQ(pair.landmarks[0].fixed_mm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(pair.landmarks[0].moving_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(pair.landmarks[0].name, "1");
  const glm::dmat4 product = *pair.start * oddPlace();
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(product[column], glm::dmat4(1.0)[column]), 1e-12);
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

struct Wrong {
  const char* pointer;
  json value;
  const char* field;
};

void expectNamed(const json& good, const std::vector<Wrong>& wrongs) {
  for (const auto& wrong : wrongs) {
    json project = good;
    project[json::json_pointer(wrong.pointer)] = wrong.value;
    const Error problem = refused(project);
    EXPECT_EQ(problem.code, ErrorCode::badField) << problem;
    EXPECT_NE(problem.sentence.find(std::string("'") + wrong.field + "'"), std::string::npos) << problem;
    EXPECT_TRUE(problem.sentence.ends_with('.')) << problem;
  }
}

TEST(StitchProject, NamesTheFieldThatIsWrong) {
  const json good = {{"volumes", {{{"file", "a.mha"}, {"to_world", identity()}}}}};
  expectNamed(good, {{"/volumes", json::array(), "volumes"},
                     {"/volumes", 3, "volumes"},
                     {"/volumes/0", "a.mha", "volumes[0]"},
                     {"/volumes/0/file", 4, "volumes[0].file"},
                     {"/volumes/0/file", "", "volumes[0].file"},
                     {"/volumes/0/to_world", json::array({1, 2}), "volumes[0].to_world"},
                     {"/volumes/0/place", identity(), "volumes[0].place"},
                     {"/volumes/0/placement", "tracker", "volumes[0].placement"},
                     {"/spacing", 1, "spacing"},
                     {"/spacing_mm", "fine", "spacing_mm"},
                     {"/spacing_mm", -1, "spacing_mm"},
                     {"/feather_mm", -1, "feather_mm"},
                     {"/interpolated_weight", 0, "interpolated_weight"},
                     {"/axes", "sideways", "axes"},
                     {"/settings", json::object(), "settings"},
                     {"/format", "one", "format"},
                     {"/format", 0, "format"},
                     {"/format", 1.5, "format"}});
  json mirrored = good;
  mirrored["volumes"][0]["to_world"][0] = -1;
  EXPECT_EQ(refused(mirrored).code, ErrorCode::notRigid);
  json newer = good;
  newer["format"] = 3;
  EXPECT_EQ(refused(newer).code, ErrorCode::newerFormat);
  PlainFiles files;
  EXPECT_EQ(parseProject("{\"volumes\": [", "/", files).error().code, ErrorCode::badHeader);
  EXPECT_EQ(parseProject("[]", "/", files).error().code, ErrorCode::badField);
}

TEST(StitchProject, NamesTheFieldOfTheSecondFormatThatIsWrong) {
  const json good = json::parse(projectText(fullProject(), "/data"));
  json many = json::array();
  for (std::size_t n = 0; n <= kMostVolumes; ++n) many.push_back({{"file", "a.mha"}});
  expectNamed(good, {{"/spacing_mm", 1, "spacing_mm"},
                     {"/volumes", many, "volumes"},
                     {"/volumes/0/name", "c.nrrd", "volumes[2].name"},
                     {"/volumes/0/placement", "guessed", "volumes[0].placement"},
                     {"/volumes/1/spacing_mm", -1, "volumes[1].spacing_mm"},
                     {"/volumes/1/calibration", 3, "volumes[1].calibration"},
                     {"/pairs", json::object(), "pairs"},
                     {"/pairs/0", 1, "pairs[0]"},
                     {"/pairs/0/fixed", "nobody", "pairs[0].fixed"},
                     {"/pairs/0/fixed", 0, "pairs[0].fixed"},
                     {"/pairs/0/moving", "right", "pairs[0].moving"},
                     {"/pairs/0/method", "guess", "pairs[0].method"},
                     {"/pairs/0/decision", true, "pairs[0].decision"},
                     {"/pairs/0/start", json::array({1}), "pairs[0].start"},
                     {"/pairs/0/max_turn_deg", 181, "pairs[0].max_turn_deg"},
                     {"/pairs/0/turn", 1, "pairs[0].turn"},
                     {"/pairs/0/effort", "heroic", "pairs[0].effort"},
                     {"/pairs/0/effort", nullptr, "pairs[0].effort"},
                     {"/pairs/0/landmarks", 5, "pairs[0].landmarks"},
                     {"/pairs/0/landmarks/1", 5, "pairs[0].landmarks[1]"},
                     {"/pairs/0/landmarks/1/fixed_mm", json::array({1, 2}), "pairs[0].landmarks[1].fixed_mm"},
                     {"/pairs/0/landmarks/1/moving_mm/2", nullptr, "pairs[0].landmarks[1].moving_mm"},
                     {"/pairs/1/fixed", "right", "pairs[1].fixed"},
                     {"/pairs/1/method", "by hand", "pairs[1].start"},
                     {"/pairs/1/method", "landmarks", "pairs[1].landmarks"},
                     {"/settings", 1, "settings"},
                     {"/settings/speed", 1, "settings.speed"},
                     {"/settings/max_turn_deg", 1e300, "settings.max_turn_deg"},
                     {"/settings/tracker_error_mm", -1, "settings.tracker_error_mm"},
                     {"/settings/tracker_error_deg", 0, "settings.tracker_error_deg"},
                     {"/settings/equalise", 1, "settings.equalise"},
                     {"/settings/effort", "heroic", "settings.effort"},
                     {"/settings/fall_off_mm", 0, "settings.fall_off_mm"},
                     {"/result/axes", "second", "result.axes"},
                     {"/result/threads", 2, "result.threads"},
                     {"/seam/method", "knife", "seam.method"},
                     {"/seam/cell_mm", 0, "seam.cell_mm"},
                     {"/seam/strokes/0/view", "nobody", "seam.strokes[0].view"},
                     {"/seam/strokes/0/at_mm", json::array({1, 2, 1e9}), "seam.strokes[0].at_mm"},
                     {"/seam/strokes/0/radius_mm", -2, "seam.strokes[0].radius_mm"}});
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
    auto outcome = runStitchCommand(args, volumes, files, noProgress());
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
  PlainFiles files;
  MemoryVolumes volumes{files};
};

TEST_F(StitchCommand, WritesVolumeCoverageSourceAndProvenance) {
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string(), "--threads", "2"});
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->outputs.size(), 4u);
  for (const auto& file : outcome->outputs) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(entriesOf(folder / "out"), 5u) << "and the folder of the steps";
  EXPECT_EQ(volumes.writtenAs("volume.mha").grid.dims, glm::ivec3(12, 4, 4));
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
  for (const int writes : {0, 1, 2}) {
    volumes.writesLeft = writes;
    const auto outcome = run({(folder / "p.json").string(), "-o", out});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::notWritable);
    EXPECT_EQ(textOf(folder / "out/provenance.json"), before) << "the result of last week";
    EXPECT_EQ(entriesOf(folder / "out"), 5u);
  }
  volumes.writesLeft = 1000;
  ASSERT_TRUE(run({(folder / "p.json").string(), "-o", out}));
  EXPECT_NE(textOf(folder / "out/provenance.json"), before);
}

TEST_F(StitchCommand, AResultWaitsUntilItIsPutInPlaceAndIsNotMadeAgain) {
  const std::string out = (folder / "out").string();
  {
    const auto outcome = runStitchCommand({(folder / "p.json").string(), "-o", out}, volumes, files, noProgress());
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(entriesOf(out), 1u) << "the folder of the steps";
  }
  volumes.writesLeft = 0;
  ASSERT_TRUE(run({(folder / "p.json").string(), "-o", out}));
  EXPECT_EQ(entriesOf(out), 5u);
}

TEST_F(StitchCommand, NeverWritesOverItsInputsNorOverAForeignResult) {
  writeText(folder / "volume.mha", "my only copy");
  const auto foreign = run({(folder / "p.json").string(), "-o", folder.path().string()});
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.error().code, ErrorCode::notWritable) << foreign.error();
  EXPECT_EQ(textOf(folder / "volume.mha"), "my only copy");
  EXPECT_FALSE(std::filesystem::exists(folder / "steps")) << "refused before anything is made";
  volumes.volumes[(folder / "volume.mha").string()] = volumes.volumes[(folder / "a.mha").string()];
  writeText(folder / "p.json", json{{"volumes", {{{"file", "volume.mha"}}}}}.dump());
  const auto input = run({(folder / "p.json").string(), "-o", folder.path().string()});
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, ErrorCode::badUsage) << input.error();
  EXPECT_EQ(textOf(folder / "volume.mha"), "my only copy");
}

TEST_F(StitchCommand, TellsHowEachPairEndedAndWhatNothingChecks) {
  json project = json::parse(textOf(folder / "p.json"));
  project["format"] = 2;
  project["settings"] = {{"elastic", false}};
  for (auto& volume : project["volumes"]) {
    volume["placement"] = "unknown";
    volume.erase("to_world");
  }
  json start = identity();
  start[3] = -4.0;
  project["pairs"] = {{{"fixed", "a.mha"}, {"moving", "b.mha"}, {"method", "by hand"}, {"start", start}}};
  writeText(folder / "p.json", project.dump());
  const auto outcome = run({(folder / "p.json").string(), "-o", (folder / "out").string()});
  ASSERT_TRUE(outcome) << outcome.error();
  ASSERT_GE(outcome->notes.size(), 2u);
  EXPECT_EQ(outcome->notes[0], "'a.mha' with 'b.mha': by hand, not checked. Placed by hand.");
  EXPECT_NE(outcome->notes[1].find("No loop checks"), std::string::npos) << outcome->notes[1];
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
