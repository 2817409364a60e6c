#include "logic/project.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/nesting.h"
#include "ew/core/numbers.h"
#include "logic/places.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  return value.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 80);
}

tl::unexpected<Error> badField(const std::string& field, const std::string& found, const std::string& expected) {
  return failure(ErrorCode::badField, "'" + field + "' in the stitch project is " + found + "; it must be " + expected + ".",
                 {{"field", field}, {"found", found}, {"expected", expected}});
}

/// One object of the file with its place in it. Every read says by name what it does not like.
class Fields {
 public:
  Fields(const json& object, std::string prefix) : object_(object), prefix_(std::move(prefix)) {}

  [[nodiscard]] std::string nameOf(const char* field) const { return prefix_.empty() ? field : prefix_ + "." + field; }
  [[nodiscard]] const json* find(const char* field) const {
    const auto at = object_.find(field);
    return at == object_.end() ? nullptr : &*at;
  }

  [[nodiscard]] Result<void> only(std::initializer_list<const char*> known) const {
    for (const auto& [name, value] : object_.items())
      if (std::find(known.begin(), known.end(), name) == known.end())
        return failure(ErrorCode::badField,
                       "'" + nameOf(name.c_str()) + "' in the stitch project is not a field of it; correct the name or remove the field.",
                       {{"field", nameOf(name.c_str())}, {"found", shown(value)}});
    return {};
  }

  [[nodiscard]] Result<void> number(const char* field, double& into, double least, double most, const char* expected) const {
    const json* value = find(field);
    if (value == nullptr) return {};
    if (!value->is_number()) return badField(nameOf(field), shown(*value), expected);
    const double read = value->get<double>();
    if (!(read >= least && read <= most)) return badField(nameOf(field), shown(*value), expected);
    into = read;
    return {};
  }

  [[nodiscard]] Result<void> yesOrNo(const char* field, bool& into) const {
    const json* value = find(field);
    if (value == nullptr) return {};
    if (!value->is_boolean()) return badField(nameOf(field), shown(*value), "true or false");
    into = value->get<bool>();
    return {};
  }

  /// Empty when it is not there.
  [[nodiscard]] Result<std::string> text(const char* field, const char* expected) const {
    const json* value = find(field);
    if (value == nullptr) return std::string();
    if (!value->is_string() || value->get_ref<const std::string&>().empty()) return badField(nameOf(field), shown(*value), expected);
    return value->get<std::string>();
  }

  template <class Word, std::size_t n>
  [[nodiscard]] Result<void> word(const char* field, Word& into, const std::array<Word, n>& known) const {
    const json* value = find(field);
    if (value == nullptr) return {};
    std::string expected;
    for (std::size_t i = 0; i < n; ++i) {
      const char* name = stitching::nameOf(known[i]);
      if (*value == name) {
        into = known[i];
        return {};
      }
      expected += std::string(i == 0 ? "" : i + 1 == n ? " or " : ", ") + "\"" + name + "\"";
    }
    return badField(nameOf(field), shown(*value), expected);
  }

  [[nodiscard]] Result<void> point(const char* field, glm::dvec3& into) const {
    const json* value = find(field);
    const bool three = value != nullptr && value->is_array() && value->size() == 3 &&
                       std::all_of(value->begin(), value->end(), [](const json& n) { return n.is_number(); });
    if (!three) return badField(nameOf(field), value == nullptr ? "missing" : shown(*value), "three numbers, in mm");
    for (int axis = 0; axis < 3; ++axis) into[axis] = (*value)[static_cast<std::size_t>(axis)].get<double>();
    return {};
  }

  [[nodiscard]] Result<glm::dmat4> place(const char* field, const fs::path& folder, sdk::Files& files) const {
    const json& value = *find(field);
    if (value.is_string()) {
      const fs::path file = folder / value.get<std::string>();
      auto read = files.readText(file);
      if (!read) return passOn(read.error());
      return parseTransform(*read, file.filename().string());
    }
    const bool sixteen =
        value.is_array() && value.size() == 16 && std::all_of(value.begin(), value.end(), [](const json& n) { return n.is_number(); });
    if (!sixteen) return badField(nameOf(field), shown(value), "16 numbers, row by row, or the name of a file that holds them");
    std::array<double, 16> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = value[i].get<double>();
    const glm::dmat4 matrix = matrixFromRows(rows);
    if (auto rigid = checkRigid(matrix); !rigid) {
      Error problem = rigid.error();
      problem.sentence = "'" + nameOf(field) + "' in the stitch project cannot be used. " + problem.sentence;
      problem.context.emplace_back("field", nameOf(field));
      return passOn(std::move(problem));
    }
    return matrix;
  }

  /// A list of objects, or nothing when it is not there.
  [[nodiscard]] Result<std::vector<Fields>> objects(const char* field, const char* expected) const {
    std::vector<Fields> list;
    const json* value = find(field);
    if (value == nullptr) return list;
    if (!value->is_array()) return badField(nameOf(field), shown(*value), expected);
    for (std::size_t n = 0; n < value->size(); ++n) {
      const std::string name = nameOf(field) + "[" + std::to_string(n) + "]";
      if (!(*value)[n].is_object()) return badField(name, shown((*value)[n]), "an object");
      list.emplace_back((*value)[n], name);
    }
    return list;
  }

  /// An object, or an empty one when it is not there.
  [[nodiscard]] Result<Fields> object(const char* field) const {
    static const json kNothing = json::object();
    const json* value = find(field);
    if (value == nullptr) return Fields(kNothing, nameOf(field));
    if (!value->is_object()) return badField(nameOf(field), shown(*value), "an object");
    return Fields(*value, nameOf(field));
  }

 private:
  const json& object_;
  std::string prefix_;
};

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

std::string relativeText(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below && !folder.empty() ? relative : file).generic_string();
}

nlohmann::ordered_json pointOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

nlohmann::ordered_json entryOf(const ProjectVolume& volume, const fs::path& folder) {
  nlohmann::ordered_json entry;
  entry["name"] = volume.name;
  entry["file"] = relativeText(volume.file, folder);
  if (!volume.coverage.empty()) entry["coverage"] = relativeText(volume.coverage, folder);
  if (!volume.confidence.empty()) entry["confidence"] = relativeText(volume.confidence, folder);
  if (!volume.calibration.empty()) entry["calibration"] = relativeText(volume.calibration, folder);
  if (volume.spacing_mm != 0.0) entry["spacing_mm"] = volume.spacing_mm;
  entry["placement"] = nameOf(volume.placement);
  entry["to_world"] = rowsOf(volume.toWorld);
  return entry;
}

nlohmann::ordered_json entryOf(const ProjectPair& pair, const std::vector<ProjectVolume>& volumes) {
  nlohmann::ordered_json entry;
  entry["fixed"] = volumes.at(pair.fixed).name;
  entry["moving"] = volumes.at(pair.moving).name;
  entry["method"] = nameOf(pair.method);
  entry["decision"] = nameOf(pair.decision);
  if (pair.start) entry["start"] = rowsOf(*pair.start);
  for (const auto& landmark : pair.landmarks)
    entry["landmarks"].push_back(
        {{"name", landmark.name}, {"fixed_mm", pointOf(landmark.fixed_mm)}, {"moving_mm", pointOf(landmark.moving_mm)}});
  if (pair.maxTurn_deg) entry["max_turn_deg"] = *pair.maxTurn_deg;
  if (pair.effort) entry["effort"] = nameOf(*pair.effort);
  return entry;
}

}  // namespace

const char* nameOf(Placement placement) {
  switch (placement) {
    case Placement::unknown:
      return "unknown";
    case Placement::tracker:
      return "tracker";
    case Placement::hand:
      return "hand";
  }
  return "unknown";
}

const char* nameOf(PairMethod method) {
  switch (method) {
    case PairMethod::automatic:
      return "automatic";
    case PairMethod::search:
      return "search";
    case PairMethod::refine:
      return "refine";
    case PairMethod::landmarks:
      return "landmarks";
    case PairMethod::byHand:
      return "by hand";
  }
  return "automatic";
}

const char* nameOf(Decision decision) {
  switch (decision) {
    case Decision::undecided:
      return "undecided";
    case Decision::accepted:
      return "accepted";
    case Decision::rejected:
      return "rejected";
  }
  return "undecided";
}

const char* nameOf(registration::ElasticEffort effort) {
  switch (effort) {
    case registration::ElasticEffort::fast:
      return "fast";
    case registration::ElasticEffort::balanced:
      return "balanced";
    case registration::ElasticEffort::accurate:
      return "accurate";
  }
  return "balanced";
}

const char* nameOf(SeamMethod method) {
  switch (method) {
    case SeamMethod::feather:
      return "feather";
    case SeamMethod::nearest:
      return "nearest";
    case SeamMethod::graphCut:
      return "graph cut";
  }
  return "graph cut";
}

bool speaksOfPose(const ProjectPair& pair) {
  ProjectPair rest = pair;
  rest.effort.reset();
  ProjectPair nothing;
  nothing.fixed = pair.fixed;
  nothing.moving = pair.moving;
  return !pair.effort || !(rest == nothing);
}

registration::ElasticEffort effortOf(const StitchProject& project, std::size_t fixed, std::size_t moving) {
  const auto [low, high] = std::minmax(fixed, moving);
  for (const ProjectPair& pair : project.pairs)
    if (pair.fixed == low && pair.moving == high && pair.effort) return *pair.effort;
  return project.settings.effort;
}

const char* nameOf(GridAxes axes) { return axes == GridAxes::world ? "world" : "first"; }

bool operator==(const StitchProject& a, const StitchProject& b) {
  const auto grid = [](const StitchProject& p) {
    const StitchOptions& g = p.settings.join.grid;
    return std::tuple(g.spacing_mm, g.featherWidth_mm, g.interpolatedWeight, g.axes);
  };
  const auto seam = [](const StitchProject& p) {
    SeamOptions s = p.settings.join.seam;
    s.threads = 0;
    return s;
  };
  const auto rest = [](const StitchProject& p) {
    const ProjectSettings& s = p.settings;
    return std::tuple(s.maxTurn_deg, s.trackerError_mm, s.trackerError_deg, s.equalise, s.elastic, s.effort, s.fallOff_mm);
  };
  return a.volumes == b.volumes && a.pairs == b.pairs && rest(a) == rest(b) && grid(a) == grid(b) && seam(a) == seam(b);
}

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

std::string projectText(const StitchProject& project, const fs::path& folder) {
  nlohmann::ordered_json document;
  document["format"] = kProjectFormat;
  document["volumes"] = nlohmann::ordered_json::array();
  for (const auto& volume : project.volumes) document["volumes"].push_back(entryOf(volume, folder));
  document["pairs"] = nlohmann::ordered_json::array();
  for (const auto& pair : project.pairs) document["pairs"].push_back(entryOf(pair, project.volumes));
  const ProjectSettings& settings = project.settings;
  document["settings"] = {{"max_turn_deg", settings.maxTurn_deg},
                          {"tracker_error_mm", settings.trackerError_mm},
                          {"tracker_error_deg", settings.trackerError_deg},
                          {"equalise", settings.equalise},
                          {"elastic", settings.elastic},
                          {"effort", nameOf(settings.effort)},
                          {"fall_off_mm", settings.fallOff_mm}};
  const StitchOptions& grid = settings.join.grid;
  document["result"] = {{"spacing_mm", grid.spacing_mm},
                        {"feather_mm", grid.featherWidth_mm},
                        {"interpolated_weight", grid.interpolatedWeight},
                        {"axes", nameOf(grid.axes)}};
  const SeamOptions& seam = settings.join.seam;
  document["seam"] = {{"method", nameOf(seam.method)},
                      {"cell_mm", seam.cell_mm},
                      {"blend_mm", seam.blend_mm},
                      {"confidence_weight", seam.confidenceWeight},
                      {"distance_weight", seam.distanceWeight},
                      {"strokes", nlohmann::ordered_json::array()}};
  for (const auto& stroke : seam.strokes)
    document["seam"]["strokes"].push_back(
        {{"view", project.volumes.at(stroke.view).name}, {"at_mm", pointOf(stroke.at_mm)}, {"radius_mm", stroke.radius_mm}});
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace ew::stitching
