#include "ew/stitching/project.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "library/temporary_folder.h"
#include "places.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

json identity() { return rowsOf(glm::dmat4(1.0)); }

Error refused(const json& project) {
  const auto parsed = parseProject(project.dump(), "/nowhere");
  EXPECT_FALSE(parsed) << project;
  return parsed ? Error{} : parsed.error();
}

Transform<frame::World, frame::View> oddPlace() {
  return {matrixFromRows({0, -1, 0, 4.25, 1, 0, 0, -1.0 / 3.0, 0, 0, 1, 1e-9, 0, 0, 0, 1})};
}

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
  sweep.acceptsSmall = true;
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
  pair.start = renamed<frame::Moving, frame::Fixed>(oddPlace());
  pair.landmarks = {{"gall bladder", {1, 2, 3}, {4, 5, 1.0 / 7.0}}, {"2", {0, 0, 1}, {1e-3, 0, 0}}};
  pair.maxRotation_deg = 60.0;
  pair.effort = registration::ElasticEffort::fast;
  ProjectPair other;
  other.fixed = 1;
  other.moving = 2;
  other.decision = Decision::rejected;
  project.pairs = {pair, other};
  ProjectSettings& settings = project.settings;
  settings.maxRotation_deg = 45.0;
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
  const StitchProject project = fullProject();
  const std::string text = projectText(project, "/data");
  EXPECT_NE(text.find("\"a.mha\""), std::string::npos) << "below the project's folder: relative";
  EXPECT_NE(text.find("\"maps/a.mha\""), std::string::npos);
  EXPECT_NE(text.find("\"/elsewhere/b.igs.mha\""), std::string::npos);
  const auto read = parseProject(text, "/data");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, project);
  EXPECT_EQ(projectText(*read, "/data"), text);
  StitchProject plain;
  plain.volumes = {project.volumes[2]};
  const auto defaults = parseProject(R"({"format": 2, "volumes": [{"file": "c.nrrd"}]})", "/data");
  ASSERT_TRUE(defaults) << defaults.error();
  EXPECT_EQ(*defaults, plain) << "what is left out is what a new project has";
}

TEST(StitchProject, DiffersFromItselfWithAnyFieldOfTheFileChanged) {
  const json all = json::parse(projectText(fullProject(), "/data")).flatten();
  const auto plain = [&] { return *parseProject(all.unflatten().dump(), "/data"); };
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
    const auto read = parseProject(changed.unflatten().dump(), "/data");
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
  fieldsOfSchema(json::parse(textOf(std::string(EW_SOURCE_DIR) + "/resources/schemas/stitch.schema.json")), "", described);
  EXPECT_EQ(written, described);
}

TEST(StitchProject, OfTheFirstFormatJoinsVolumesAsTheyLie) {
  const auto read = parseProject(R"({"format": 1, "volumes": [{"file": "a.mha", "name": "x"}, {"file": "b.mha", "name": "x"},
                                     {"file": "b.mha"}], "spacing_mm": 0.5, "feather_mm": 4, "axes": "world"})",
                                 "/data");
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
  const auto again = parseProject(projectText(*read, "/data"), "/data");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, *read) << "saved as format 2 it says the same";
}

TEST(StitchProject, TurnsAPairThatIsWrittenTheOtherWayRound) {
  json project = {{"format", 2}, {"volumes", {{{"file", "a.mha"}}, {{"file", "b.mha"}}}}};
  project["pairs"] = {{{"fixed", "b.mha"},
                       {"moving", "a.mha"},
                       {"start", rowsOf(oddPlace())},
                       {"landmarks", {{{"fixed_mm", {1, 2, 3}}, {"moving_mm", {4, 5, 6}}}}}}};
  const auto read = parseProject(project.dump(), "/data");
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->pairs.size(), 1u);
  const ProjectPair& pair = read->pairs[0];
  EXPECT_EQ(pair.fixed, 0u);
  EXPECT_EQ(pair.moving, 1u);
  EXPECT_EQ(pair.landmarks[0].fixed_mm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(pair.landmarks[0].moving_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(pair.landmarks[0].name, "1");
  const glm::dmat4 product = pair.start->matrix * oddPlace().matrix;
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(product[column], glm::dmat4(1.0)[column]), 1e-12);
}

TEST(StitchProject, TakesAPlaceFromAFileOfSixteenNumbers) {
  const TemporaryFolder folder;
  writeText(folder / "a.txt", "1 0 0 10\n0 1 0 20\n0 0 1 30\n0 0 0 1\n");
  const json project = {{"volumes", {{{"file", "a.mha"}, {"to_world", "a.txt"}}}}};
  const auto read = parseProject(project.dump(), folder.path());
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(glm::dvec3(read->volumes[0].toWorld.matrix[3]), glm::dvec3(10, 20, 30));
  EXPECT_EQ(read->volumes[0].file, folder / "a.mha");
  EXPECT_EQ(read->volumes[0].name, "a.mha");
  writeText(folder / "a.txt", "1 0 0 10\n0 1 0 20\n");
  EXPECT_EQ(parseProject(project.dump(), folder.path()).error().code, ErrorCode::badField);
  writeText(folder / "a.txt", "2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  EXPECT_EQ(parseProject(project.dump(), folder.path()).error().code, ErrorCode::notRigid);
}

TEST(StitchProject, ThatNestsWithoutEndIsRefused) {
  const auto project = parseProject("{\"volumes\": " + std::string(1000000, '[') + std::string(1000000, ']') + "}", "/nowhere");
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
    EXPECT_NE(problem.sentence().find(std::string("'") + wrong.field + "'"), std::string::npos) << problem;
    EXPECT_TRUE(problem.sentence().ends_with('.')) << problem;
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
  EXPECT_EQ(parseProject("{\"volumes\": [", "/").error().code, ErrorCode::badHeader);
  EXPECT_EQ(parseProject("[]", "/").error().code, ErrorCode::badField);
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

}  // namespace
}  // namespace ew::stitching
