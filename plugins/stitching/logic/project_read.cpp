#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "ew/core/nesting.h"
#include "ew/core/numbers.h"
#include "logic/places.h"
#include "logic/project_fields.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

#define EW_TRY(expression) \
  if (auto outcome = (expression); !outcome) return passOn(outcome.error())

constexpr std::array kPlacements = {Placement::unknown, Placement::tracker, Placement::hand};
constexpr std::array kMethods = {PairMethod::automatic, PairMethod::search, PairMethod::refine, PairMethod::landmarks, PairMethod::byHand};
constexpr std::array kDecisions = {Decision::undecided, Decision::accepted, Decision::rejected};
constexpr std::array kEfforts = {registration::ElasticEffort::fast, registration::ElasticEffort::balanced,
                                 registration::ElasticEffort::accurate};
constexpr std::array kSeamMethods = {SeamMethod::feather, SeamMethod::nearest, SeamMethod::graphCut};
constexpr std::array kAxes = {GridAxes::first, GridAxes::world};
constexpr double kFar_mm = 1e6;

Result<ProjectVolume> volumeOf(const Fields& entry, int format, const fs::path& folder, sdk::Files& files) {
  if (format == 1) {
    EW_TRY(entry.only({"file", "coverage", "name", "to_world"}));
  } else {
    EW_TRY(entry.only({"file", "coverage", "confidence", "calibration", "spacing_mm", "placement", "name", "to_world"}));
  }
  ProjectVolume volume;
  if (entry.find("file") == nullptr) return badField(entry.nameOf("file"), "missing", "the name of a volume or sweep file");
  for (const auto& [field, into] : {std::pair{"file", &volume.file}, std::pair{"coverage", &volume.coverage},
                                    std::pair{"confidence", &volume.confidence}, std::pair{"calibration", &volume.calibration}}) {
    auto file = entry.text(field, "a file name");
    if (!file) return passOn(file.error());
    if (!file->empty()) *into = folder / *file;
  }
  auto name = entry.text("name", "a name");
  if (!name) return passOn(name.error());
  volume.name = *name;
  EW_TRY(entry.number("spacing_mm", volume.spacing_mm, 0.0, 100.0, "a number up to 100, in mm, or 0 to choose it from the sweep"));
  volume.placement = Placement::tracker;
  EW_TRY(entry.word("placement", volume.placement, kPlacements));
  if (entry.find("to_world") != nullptr) {
    auto place = entry.place("to_world", folder, files);
    if (!place) return passOn(place.error());
    volume.toWorld = *place;
  }
  return volume;
}

/// Every volume gets a name of its own: the file's where the project gives none, counted up where that is taken.
Result<void> nameVolumes(std::vector<ProjectVolume>& volumes) {
  std::set<std::string> taken;
  for (std::size_t n = 0; n < volumes.size(); ++n)
    if (!volumes[n].name.empty() && !taken.insert(volumes[n].name).second)
      return badField("volumes[" + std::to_string(n) + "].name", shown(volumes[n].name), "a name that no other volume has");
  for (auto& volume : volumes) {
    if (!volume.name.empty()) continue;
    const std::string file = volume.file.filename().string();
    volume.name = file;
    for (int count = 2; !taken.insert(volume.name).second; ++count) volume.name = file + " (" + std::to_string(count) + ")";
  }
  return {};
}

Result<std::size_t> indexOf(const Fields& entry, const char* field, const std::vector<ProjectVolume>& volumes) {
  const json* value = entry.find(field);
  if (value != nullptr && value->is_string())
    for (std::size_t n = 0; n < volumes.size(); ++n)
      if (volumes[n].name == value->get_ref<const std::string&>()) return n;
  return badField(entry.nameOf(field), value == nullptr ? "missing" : shown(*value), "the name of one of the project's volumes");
}

Result<registration::LandmarkPair> landmarkOf(const Fields& entry) {
  EW_TRY(entry.only({"name", "fixed_mm", "moving_mm"}));
  registration::LandmarkPair landmark;
  auto name = entry.text("name", "a name");
  if (!name) return passOn(name.error());
  landmark.name = *name;
  EW_TRY(entry.point("fixed_mm", landmark.fixed_mm));
  EW_TRY(entry.point("moving_mm", landmark.moving_mm));
  return landmark;
}

Result<ProjectPair> pairOf(const Fields& entry, const std::vector<ProjectVolume>& volumes, const fs::path& folder, sdk::Files& files) {
  EW_TRY(entry.only({"fixed", "moving", "method", "decision", "start", "landmarks", "max_turn_deg", "effort"}));
  ProjectPair pair;
  auto fixed = indexOf(entry, "fixed", volumes);
  if (!fixed) return passOn(fixed.error());
  auto moving = indexOf(entry, "moving", volumes);
  if (!moving) return passOn(moving.error());
  if (*fixed == *moving) return badField(entry.nameOf("moving"), shown(*entry.find("moving")), "another volume than fixed");
  pair.fixed = *fixed;
  pair.moving = *moving;
  EW_TRY(entry.word("method", pair.method, kMethods));
  EW_TRY(entry.word("decision", pair.decision, kDecisions));
  if (entry.find("start") != nullptr) {
    auto start = entry.place("start", folder, files);
    if (!start) return passOn(start.error());
    pair.start = *start;
  }
  auto landmarks = entry.objects("landmarks", "a list of objects with fixed_mm and moving_mm");
  if (!landmarks) return passOn(landmarks.error());
  for (const auto& each : *landmarks) {
    auto landmark = landmarkOf(each);
    if (!landmark) return passOn(landmark.error());
    if (landmark->name.empty()) landmark->name = std::to_string(pair.landmarks.size() + 1);
    pair.landmarks.push_back(std::move(*landmark));
  }
  if (entry.find("max_turn_deg") != nullptr) {
    double turn = 0.0;
    EW_TRY(entry.number("max_turn_deg", turn, 0.0, 180.0, "a number from 0 to 180, in degrees"));
    pair.maxTurn_deg = turn;
  }
  if (entry.find("effort") != nullptr) {
    pair.effort = registration::ElasticEffort::balanced;
    EW_TRY(entry.word("effort", *pair.effort, kEfforts));
  }
  if (pair.fixed > pair.moving) {
    std::swap(pair.fixed, pair.moving);
    if (pair.start) pair.start = rigidInverse(*pair.start);
    for (auto& landmark : pair.landmarks) std::swap(landmark.fixed_mm, landmark.moving_mm);
  }
  return pair;
}

Result<void> pairsOf(const Fields& document, const fs::path& folder, sdk::Files& files, StitchProject& project) {
  auto entries = document.objects("pairs", "a list of pairs");
  if (!entries) return passOn(entries.error());
  for (const auto& entry : *entries) {
    auto pair = pairOf(entry, project.volumes, folder, files);
    if (!pair) return passOn(pair.error());
    if (std::any_of(project.pairs.begin(), project.pairs.end(),
                    [&](const ProjectPair& other) { return other.fixed == pair->fixed && other.moving == pair->moving; }))
      return badField(
          entry.nameOf("fixed"),
          "'" + project.volumes[pair->fixed].name + "' with '" + project.volumes[pair->moving].name + "', which was said already",
          "one entry for each pair of volumes");
    if (pair->method == PairMethod::byHand && !pair->start)
      return badField(entry.nameOf("start"), "missing", "16 numbers, row by row, when the method is \"by hand\"");
    if (pair->method == PairMethod::landmarks && pair->landmarks.size() < 3)
      return badField(entry.nameOf("landmarks"), "a list of " + std::to_string(pair->landmarks.size()),
                      "a list of at least three when the method is \"landmarks\"");
    project.pairs.push_back(std::move(*pair));
  }
  return {};
}

Result<void> settingsOf(const Fields& document, ProjectSettings& settings) {
  auto object = document.object("settings");
  if (!object) return passOn(object.error());
  const Fields& f = *object;
  EW_TRY(f.only({"max_turn_deg", "tracker_error_mm", "tracker_error_deg", "equalise", "elastic", "effort", "fall_off_mm"}));
  EW_TRY(f.number("max_turn_deg", settings.maxTurn_deg, 0.0, 180.0, "a number from 0 to 180, in degrees"));
  EW_TRY(f.number("tracker_error_mm", settings.trackerError_mm, 0.0, 1000.0, "a number from 0 to 1000, in mm"));
  EW_TRY(f.number("tracker_error_deg", settings.trackerError_deg, 0.0, 180.0, "a number from 0 to 180, in degrees"));
  if ((settings.trackerError_mm == 0.0) != (settings.trackerError_deg == 0.0)) {
    const char* zero = settings.trackerError_mm == 0.0 ? "tracker_error_mm" : "tracker_error_deg";
    return badField(f.nameOf(zero), "0", "above 0, or 0 together with the other one when recorded places are exact");
  }
  EW_TRY(f.yesOrNo("equalise", settings.equalise));
  EW_TRY(f.yesOrNo("elastic", settings.elastic));
  EW_TRY(f.word("effort", settings.effort, kEfforts));
  EW_TRY(f.number("fall_off_mm", settings.fallOff_mm, 1.0, 1000.0, "a number from 1 to 1000, in mm"));
  return {};
}

Result<void> gridOf(const Fields& f, StitchOptions& grid) {
  EW_TRY(f.number("spacing_mm", grid.spacing_mm, 0.0, 100.0, "a number up to 100, in mm, or 0 for the finest of the volumes"));
  EW_TRY(f.number("feather_mm", grid.featherWidth_mm, 0.0, 1000.0, "a number from 0 to 1000, in mm"));
  const char* share = "above 0 and at most 1";
  EW_TRY(f.number("interpolated_weight", grid.interpolatedWeight, 0.0, 1.0, share));
  if (grid.interpolatedWeight == 0.0) return badField(f.nameOf("interpolated_weight"), "0", share);
  EW_TRY(f.word("axes", grid.axes, kAxes));
  return {};
}

Result<void> seamOf(const Fields& document, const std::vector<ProjectVolume>& volumes, SeamOptions& seam) {
  auto object = document.object("seam");
  if (!object) return passOn(object.error());
  const Fields& f = *object;
  EW_TRY(f.only({"method", "cell_mm", "blend_mm", "confidence_weight", "distance_weight", "strokes"}));
  EW_TRY(f.word("method", seam.method, kSeamMethods));
  EW_TRY(f.number("cell_mm", seam.cell_mm, 0.1, 100.0, "a number from 0.1 to 100, in mm"));
  EW_TRY(f.number("blend_mm", seam.blend_mm, 0.0, 100.0, "a number from 0 to 100, in mm"));
  EW_TRY(f.number("confidence_weight", seam.confidenceWeight, 0.0, 1000.0, "a number from 0 to 1000"));
  EW_TRY(f.number("distance_weight", seam.distanceWeight, 0.0, 1000.0, "a number from 0 to 1000"));
  auto strokes = f.objects("strokes", "a list of objects with view, at_mm and radius_mm");
  if (!strokes) return passOn(strokes.error());
  for (const auto& entry : *strokes) {
    EW_TRY(entry.only({"view", "at_mm", "radius_mm"}));
    SeamStroke stroke;
    auto view = indexOf(entry, "view", volumes);
    if (!view) return passOn(view.error());
    stroke.view = *view;
    EW_TRY(entry.point("at_mm", stroke.at_mm));
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(stroke.at_mm[axis]) <= kFar_mm))
        return badField(entry.nameOf("at_mm"), shown(*entry.find("at_mm")), "three numbers within 1000 m");
    EW_TRY(entry.number("radius_mm", stroke.radius_mm, 0.1, 1000.0, "a number from 0.1 to 1000, in mm"));
    seam.strokes.push_back(stroke);
  }
  return {};
}

/// What the first format meant: places are right, nothing is registered or cut, inputs are blended.
void joinAsTheyLie(ProjectSettings& settings) {
  settings.trackerError_mm = 0.0;
  settings.trackerError_deg = 0.0;
  settings.equalise = false;
  settings.elastic = false;
  settings.join.seam.method = SeamMethod::feather;
}

Result<int> formatOf(const json& document) {
  if (!document.contains("format")) return 1;  // the first one could leave it out
  const json& format = document["format"];
  if (!format.is_number_integer() || format.get<double>() < 1) return badField("format", shown(format), "a whole number from 1");
  if (format.get<double>() > kProjectFormat)
    return failure(ErrorCode::newerFormat,
                   "The stitch project has format " + format.dump() + ", and this program reads formats up to " +
                       std::to_string(kProjectFormat) + "; open it with a newer EchoWeave.",
                   {{"found", format.dump()}, {"expected", "at most " + std::to_string(kProjectFormat)}});
  return format.get<int>();
}

}  // namespace

Result<glm::dmat4> parseTransform(const std::string& text, const std::string& name) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 16)
    return failure(ErrorCode::badField,
                   "'" + name + "' holds " + (numbers ? std::to_string(numbers->size()) + " numbers" : "something that is not a number") +
                       "; a transform is 16 numbers, row by row.",
                   {{"file", name}});
  std::array<double, 16> rows{};
  std::copy(numbers->begin(), numbers->end(), rows.begin());
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (auto rigid = checkRigid(matrix); !rigid) {
    Error problem = rigid.error();
    problem.sentence = "The transform in '" + name + "' cannot be used. " + problem.sentence;
    problem.context.emplace_back("file", name);
    return passOn(std::move(problem));
  }
  return matrix;
}

Result<StitchProject> parseProject(const std::string& textOfProject, const fs::path& folder, sdk::Files& files) {
  if (nestsDeeperThan(textOfProject))
    return failure(ErrorCode::badHeader, "The stitch project nests too deeply to be one; check that it is the right file.");
  json parsed;
  try {
    parsed = json::parse(textOfProject);
  } catch (const json::exception& problem) {
    return failure(ErrorCode::badHeader,
                   "The stitch project is not valid JSON; correct the place named at the end of this message or choose "
                   "another file (" +
                       std::string(problem.what()) + ").");
  }
  if (!parsed.is_object()) return badField("the whole file", shown(parsed), "an object with the field volumes");
  const auto format = formatOf(parsed);
  if (!format) return passOn(format.error());
  const Fields document(parsed, "");
  if (*format == 1) {
    EW_TRY(document.only({"format", "volumes", "spacing_mm", "feather_mm", "interpolated_weight", "axes"}));
  } else {
    EW_TRY(document.only({"format", "volumes", "pairs", "settings", "result", "seam"}));
  }
  if (!parsed.contains("volumes") || !parsed["volumes"].is_array() || parsed["volumes"].empty())
    return badField("volumes", parsed.contains("volumes") ? shown(parsed["volumes"]) : "missing", "a list of at least one volume");
  if (parsed["volumes"].size() > kMostVolumes)
    return badField("volumes", shown(parsed["volumes"]), "a list of at most " + std::to_string(kMostVolumes));

  StitchProject project;
  auto entries = document.objects("volumes", "a list of volumes");
  if (!entries) return passOn(entries.error());
  for (const auto& entry : *entries) {
    auto volume = volumeOf(entry, *format, folder, files);
    if (!volume) return passOn(volume.error());
    project.volumes.push_back(std::move(*volume));
  }
  if (*format == 1)
    for (std::size_t n = 0; n < project.volumes.size(); ++n)  // names could repeat
      for (std::size_t before = 0; before < n; ++before)
        if (project.volumes[n].name == project.volumes[before].name) project.volumes[n].name.clear();
  EW_TRY(nameVolumes(project.volumes));
  if (*format == 1) {
    joinAsTheyLie(project.settings);
    EW_TRY(gridOf(document, project.settings.join.grid));
    return project;
  }
  EW_TRY(pairsOf(document, folder, files, project));
  EW_TRY(settingsOf(document, project.settings));
  auto result = document.object("result");
  if (!result) return passOn(result.error());
  EW_TRY(result->only({"spacing_mm", "feather_mm", "interpolated_weight", "axes"}));
  EW_TRY(gridOf(*result, project.settings.join.grid));
  EW_TRY(seamOf(document, project.volumes, project.settings.join.seam));
  return project;
}

}  // namespace ew::stitching
