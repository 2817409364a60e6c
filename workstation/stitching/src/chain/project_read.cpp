#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "chain/project_words.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/stitching/places.h"
#include "ew/stitching/project.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kFar_mm = 1e6;
constexpr std::size_t kMostLandmarks = 100000, kMostStrokes = 1000000;

constexpr std::size_t kLongestPath = 4096;

Message turn() { return say<"a number from 0 to 180, in degrees">(); }

/// A rigid matrix: 16 numbers, or a file of them.
template <class To, class From>
std::optional<Transform<To, From>> poseOf(const JsonFields& entry, const char* key, const fs::path& folder) {
  const json* value = entry.find(key);
  if (value == nullptr || !value->is_string()) {
    const auto matrix = entry.rigid(key, say<"16 numbers, row by row, or the name of a file that holds them">());
    return matrix ? std::optional(Transform<To, From>{*matrix}) : std::nullopt;
  }
  const fs::path file = folder / entry.text(key, {}, 1, kLongestPath);
  const auto text = readTextFile(file);
  if (!text) return entry.reading().refuse(text.error()), std::nullopt;
  auto read = parseTransform<To, From>(*text, file.filename().string());
  if (!read) return entry.reading().refuse(read.error()), std::nullopt;
  return *read;
}

ProjectVolume volumeOf(const JsonFields& entry, int format, const fs::path& folder) {
  if (format == 1) {
    entry.only({"file", "coverage", "name", "to_world"});
  } else {
    entry.only({"file", "coverage", "confidence", "calibration", "spacing_mm", "accept_small", "placement", "name", "to_world"});
  }
  ProjectVolume volume;
  if (!entry.has("file")) entry.refuse("file", say<"the name of a volume or sweep file">());
  for (const auto& [key, into] : {std::pair{"file", &volume.file}, std::pair{"coverage", &volume.coverage},
                                  std::pair{"confidence", &volume.confidence}, std::pair{"calibration", &volume.calibration}}) {
    if (entry.has(key)) *into = folder / entry.text(key, {}, 1, kLongestPath, say<"a file name">());
  }
  volume.name = entry.text("name", "", 1, kLongestPath, say<"a name">());
  volume.spacing_mm =
      entry.number("spacing_mm", 0.0, 100.0, volume.spacing_mm, say<"a number up to 100, in mm, or 0 to choose it from the sweep">());
  volume.acceptsSmall = entry.flag("accept_small", volume.acceptsSmall);
  volume.placement = entry.word("placement", kPlacementWords, std::optional(Placement::tracker));
  if (const auto pose = poseOf<frame::World, frame::View>(entry, "to_world", folder)) volume.toWorld = *pose;
  return volume;
}

/// Every volume gets a name of its own: the file's where the project gives none, counted up where that is taken.
void nameVolumes(const std::vector<JsonFields>& entries, std::vector<ProjectVolume>& volumes) {
  std::set<std::string> taken;
  for (std::size_t n = 0; n < volumes.size(); ++n)
    if (!volumes[n].name.empty() && !taken.insert(volumes[n].name).second)
      entries[n].refuse("name", say<"a name that no other volume has">());
  for (auto& volume : volumes) {
    if (!volume.name.empty()) continue;
    const std::string file = volume.file.filename().string();
    volume.name = file;
    for (int count = 2; !taken.insert(volume.name).second; ++count) volume.name = file + " (" + std::to_string(count) + ")";
  }
}

std::size_t indexOf(const JsonFields& entry, const char* key, const std::vector<ProjectVolume>& volumes) {
  const json* value = entry.find(key);
  if (value != nullptr && value->is_string())
    for (std::size_t n = 0; n < volumes.size(); ++n)
      if (volumes[n].name == value->get_ref<const std::string&>()) return n;
  entry.refuse(key, say<"the name of one of the project's volumes">());
  return 0;
}

ProjectPair pairOf(const JsonFields& entry, const std::vector<ProjectVolume>& volumes, const fs::path& folder) {
  entry.only({"fixed", "moving", "method", "decision", "start", "landmarks", "max_turn_deg", "effort"});
  ProjectPair pair;
  pair.fixed = indexOf(entry, "fixed", volumes);
  pair.moving = indexOf(entry, "moving", volumes);
  if (pair.fixed == pair.moving) entry.refuse("moving", say<"another volume than fixed">());
  pair.method = entry.word("method", kPairMethodWords, std::optional(pair.method));
  pair.decision = entry.word("decision", kDecisionWords, std::optional(pair.decision));
  pair.start = poseOf<frame::Moving, frame::Fixed>(entry, "start", folder);
  for (const JsonFields& each : entry.objects("landmarks", 0, kMostLandmarks, say<"a list of objects with fixed_mm and moving_mm">())) {
    each.only({"name", "fixed_mm", "moving_mm"});
    registration::LandmarkPair landmark;
    landmark.name = each.text("name", std::to_string(pair.landmarks.size() + 1), 1, kLongestPath, say<"a name">());
    landmark.fixed_mm = each.point("fixed_mm", kFar_mm, {}, say<"three numbers, in mm">());
    landmark.moving_mm = each.point("moving_mm", kFar_mm, {}, say<"three numbers, in mm">());
    pair.landmarks.push_back(std::move(landmark));
  }
  if (entry.has("max_turn_deg")) pair.maxRotation_deg = entry.number("max_turn_deg", 0.0, 180.0, {}, turn());
  if (entry.has("effort")) pair.effort = entry.word("effort", kElasticEffortWords, std::optional(registration::ElasticEffort::balanced));
  if (pair.fixed > pair.moving) {
    std::swap(pair.fixed, pair.moving);
    if (pair.start) pair.start = withRolesSwapped(*pair.start);
    for (auto& landmark : pair.landmarks) std::swap(landmark.fixed_mm, landmark.moving_mm);
  }
  return pair;
}

void pairsOf(const JsonFields& document, const fs::path& folder, StitchProject& project) {
  for (const JsonFields& entry : document.objects("pairs", 0, kMostVolumes * kMostVolumes, say<"a list of pairs">())) {
    ProjectPair pair = pairOf(entry, project.volumes, folder);
    if (!entry.good()) return;
    if (std::any_of(project.pairs.begin(), project.pairs.end(),
                    [&](const ProjectPair& other) { return other.fixed == pair.fixed && other.moving == pair.moving; }))
      entry.refuse("fixed",
                   say<"'%1' with '%2', which was said already">(project.volumes[pair.fixed].name, project.volumes[pair.moving].name),
                   say<"one entry for each pair of volumes">());
    if (pair.method == PairMethod::byHand && !pair.start)
      entry.refuse("start", say<"16 numbers, row by row, when the method is \"by hand\"">());
    if (pair.method == PairMethod::landmarks && pair.landmarks.size() < 3)
      entry.refuse("landmarks", say<"a list of %1">(pair.landmarks.size()),
                   say<"a list of at least three when the method is \"landmarks\"">());
    project.pairs.push_back(std::move(pair));
  }
}

void settingsOf(const JsonFields& f, ProjectSettings& settings) {
  f.only({"max_turn_deg", "tracker_error_mm", "tracker_error_deg", "equalise", "elastic", "effort", "fall_off_mm"});
  settings.maxRotation_deg = f.number("max_turn_deg", 0.0, 180.0, settings.maxRotation_deg, turn());
  settings.trackerError_mm = f.number("tracker_error_mm", 0.0, 1000.0, settings.trackerError_mm, say<"a number from 0 to 1000, in mm">());
  settings.trackerError_deg = f.number("tracker_error_deg", 0.0, 180.0, settings.trackerError_deg, turn());
  if ((settings.trackerError_mm == 0.0) != (settings.trackerError_deg == 0.0))
    f.refuse(settings.trackerError_mm == 0.0 ? "tracker_error_mm" : "tracker_error_deg", verbatim("0"),
             say<"above 0, or 0 together with the other one when recorded places are exact">());
  settings.equalise = f.flag("equalise", settings.equalise);
  settings.elastic = f.flag("elastic", settings.elastic);
  settings.effort = f.word("effort", kElasticEffortWords, std::optional(settings.effort));
  settings.fallOff_mm = f.number("fall_off_mm", 1.0, 1000.0, settings.fallOff_mm, say<"a number from 1 to 1000, in mm">());
}

void gridOf(const JsonFields& f, StitchOptions& grid) {
  grid.spacing_mm =
      f.number("spacing_mm", 0.0, 100.0, grid.spacing_mm, say<"a number up to 100, in mm, or 0 for the finest of the volumes">());
  grid.featherWidth_mm = f.number("feather_mm", 0.0, 1000.0, grid.featherWidth_mm, say<"a number from 0 to 1000, in mm">());
  const Message share = say<"above 0 and at most 1">();
  grid.interpolatedWeight = f.number("interpolated_weight", 0.0, 1.0, grid.interpolatedWeight, share);
  if (grid.interpolatedWeight == 0.0) f.refuse("interpolated_weight", share);
  grid.axes = f.word("axes", kGridAxesWords, std::optional(grid.axes));
}

void seamOf(const JsonFields& f, const std::vector<ProjectVolume>& volumes, SeamOptions& seam) {
  f.only({"method", "cell_mm", "blend_mm", "confidence_weight", "distance_weight", "strokes"});
  seam.method = f.word("method", kSeamMethodWords, std::optional(seam.method));
  seam.cell_mm = f.number("cell_mm", 0.1, 100.0, seam.cell_mm, say<"a number from 0.1 to 100, in mm">());
  seam.blend_mm = f.number("blend_mm", 0.0, 100.0, seam.blend_mm, say<"a number from 0 to 100, in mm">());
  seam.confidenceWeight = f.number("confidence_weight", 0.0, 1000.0, seam.confidenceWeight);
  seam.distanceWeight = f.number("distance_weight", 0.0, 1000.0, seam.distanceWeight);
  for (const JsonFields& entry : f.objects("strokes", 0, kMostStrokes, say<"a list of objects with view, at_mm and radius_mm">())) {
    entry.only({"view", "at_mm", "radius_mm"});
    SeamStroke stroke;
    stroke.view = indexOf(entry, "view", volumes);
    stroke.at_mm = entry.point("at_mm", kFar_mm, {}, say<"three numbers within 1000 m">());
    stroke.radius_mm = entry.number("radius_mm", 0.1, 1000.0, stroke.radius_mm, say<"a number from 0.1 to 1000, in mm">());
    seam.strokes.push_back(stroke);
  }
}

/// What the first format meant: places are right, nothing is registered or cut, inputs are blended.
void joinAsTheyLie(ProjectSettings& settings) {
  settings.trackerError_mm = 0.0;
  settings.trackerError_deg = 0.0;
  settings.equalise = false;
  settings.elastic = false;
  settings.join.seam.method = SeamMethod::feather;
}

}  // namespace

Result<std::array<double, 16>> parseRigidRows(const std::string& text, const std::string& name) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 16)
    return failure(ErrorCode::badField,
                   numbers ? say<"'%1' holds %2 numbers; a transform is 16 numbers, row by row.">(name, numbers->size())
                           : say<"'%1' holds something that is not a number; a transform is 16 numbers, row by row.">(name),
                   {{"file", name}});
  std::array<double, 16> rows{};
  std::copy(numbers->begin(), numbers->end(), rows.begin());
  if (auto rigid = checkRigid(matrixFromRows(rows)); !rigid) {
    Error problem = rigid.error();
    problem.message = say<"The transform in '%1' cannot be used. %2">(name, problem.message);
    problem.context.emplace_back("file", name);
    return passOn(std::move(problem));
  }
  return rows;
}

Result<StitchProject> parseProject(const std::string& textOfProject, const fs::path& folder) {
  const auto parsed = parseJson(textOfProject, say<"The stitch project">());
  if (!parsed) return passOn(parsed.error());
  JsonReading reading(say<"the stitch project">());
  const JsonFields document(*parsed, reading);
  const auto format = document.whole("format", 1, 1LL << 52, 1, say<"a whole number from 1">());  // the first one could leave it out
  if (reading.problem()) return passOn(*reading.problem());
  if (format > kProjectFormat)
    return failure(ErrorCode::newerFormat,
                   say<"The stitch project has format %1, and this program reads formats up to %2; open it with a newer EchoWeave.">(
                       format, kProjectFormat),
                   {{"found", std::to_string(format)}, {"expected", "at most " + std::to_string(kProjectFormat)}});
  if (format == 1) {
    document.only({"format", "volumes", "spacing_mm", "feather_mm", "interpolated_weight", "axes"});
  } else {
    document.only({"format", "volumes", "pairs", "settings", "result", "seam"});
  }

  StitchProject project;
  const auto entries = document.objects("volumes", 1, kMostVolumes, say<"a list of 1 to %1 volumes">(kMostVolumes));
  for (const JsonFields& entry : entries) project.volumes.push_back(volumeOf(entry, static_cast<int>(format), folder));
  if (reading.problem()) return passOn(*reading.problem());
  if (format == 1)
    for (std::size_t n = 0; n < project.volumes.size(); ++n)  // names could repeat
      for (std::size_t before = 0; before < n; ++before)
        if (project.volumes[n].name == project.volumes[before].name) project.volumes[n].name.clear();
  nameVolumes(entries, project.volumes);
  if (format == 1) {
    joinAsTheyLie(project.settings);
    gridOf(document, project.settings.join.grid);
  } else {
    pairsOf(document, folder, project);
    settingsOf(document.object("settings"), project.settings);
    const JsonFields result = document.object("result");
    result.only({"spacing_mm", "feather_mm", "interpolated_weight", "axes"});
    gridOf(result, project.settings.join.grid);
    seamOf(document.object("seam"), project.volumes, project.settings.join.seam);
  }
  if (reading.problem()) return passOn(*reading.problem());
  return project;
}

}  // namespace ew::stitching
