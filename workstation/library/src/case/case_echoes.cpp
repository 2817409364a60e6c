#include "ew/library/case_echoes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "case/echo_files.h"
#include "case/flow_file.h"
#include "case/kept_maps.h"
#include "case/kept_motion.h"
#include "case/manifest.h"
#include "ew/core/contract.h"
#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"
#include "ew/library/echoes_field.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kMotionName = "echoes/motion.bin";
constexpr const char* kFlowName = "echoes/flow.json";
constexpr std::size_t kMostFlow_bytes = std::size_t{64} << 20;
constexpr double kFlowMargin_mm = 10.0;  // around the maps: tissue moves
constexpr std::size_t kMostSurfaces = 255, kMostFields = 128;
constexpr std::size_t kMostNodes = std::size_t{1} << 26;  // of all fields: 800 MB, as the cache takes of one
constexpr double kFarthestShift_mm = 300.0;
constexpr double kFarthestField_mm = 1e5;

constexpr std::array<std::pair<std::string_view, TissueMotion::Kind>, 4> kFieldWords{{{"breath", TissueMotion::Kind::breath},
                                                                                      {"pulse", TissueMotion::Kind::pulse},
                                                                                      {"bowel cosine", TissueMotion::Kind::bowelCosine},
                                                                                      {"bowel sine", TissueMotion::Kind::bowelSine}}};

/// A file of floats lies as the cache keeps it.
static_assert(std::endian::native == std::endian::little && sizeof(glm::vec3) == 3 * sizeof(float));

/// What the field says; files are relative to the case folder.
struct EchoFields {
  std::string distance, kind;  ///< empty: no surfaces
  std::vector<ReflectingSurface> surfaces;
  std::string motionFile;
  std::optional<TissueMotion> motion;  ///< fields without their shifts
  std::string flowFile;
};

ReflectingSurface surfaceIn(const JsonFields& object) {
  ReflectingSurface surface;
  surface.echoLevel = object.number("echo_level", -1000.0, 1000.0);
  surface.thickness_mm = object.number("thickness_mm", 0.01, 50.0);
  surface.fall_deg = object.number("fall_deg", 1.0, 90.0);
  surface.rough_db = object.number("rough_db", -100.0, 30.0);
  surface.roughFall_deg = object.number("rough_fall_deg", 1.0, 90.0);
  surface.sheets = static_cast<int>(object.whole("sheets", 1, 4));
  surface.sheetGap_mm = object.number("sheet_gap_mm", 0.0, 20.0);
  surface.frontOnly = object.flag("front_only");
  return surface;
}

glm::dvec3 triple(const JsonFields& object, std::string_view key, double lowest, double highest) {
  const std::vector<double> numbers = object.numbers(key, 3, 3, lowest, highest);
  return numbers.size() == 3 ? glm::dvec3(numbers[0], numbers[1], numbers[2]) : glm::dvec3(1.0);
}

TissueMotion motionIn(const JsonFields& object) {
  TissueMotion motion;
  motion.rhythms = rhythmsIn(object);
  std::size_t nodes = 0;
  for (const JsonFields& field : object.objects("fields", 0, kMostFields)) {
    TissueMotion::Mode& mode = motion.modes.emplace_back();
    mode.kind = field.word("kind", kFieldWords);
    constexpr double kMostAlong = 4096.0;
    mode.grid.dims = glm::ivec3(triple(field, "dims", 2.0, kMostAlong));
    mode.grid.spacing_mm = triple(field, "spacing_mm", 0.01, 1000.0);
    mode.grid.origin_mm = triple(field, "origin_mm", -kFarthestField_mm, kFarthestField_mm);
    nodes += mode.grid.voxelCount();
    if (nodes > kMostNodes) field.refuse("dims", say<"a grid with which all fields have at most %1 nodes">(kMostNodes));
  }
  return motion;
}

/// @error badField
Result<EchoFields> echoFieldsIn(const json& echoes) {
  JsonReading reading(verbatim(kManifestName));
  const JsonFields object(echoes, reading, kEchoesField);
  EchoFields read;
  for (const JsonFields& each : object.objects("surfaces", 0, kMostSurfaces)) read.surfaces.push_back(surfaceIn(each));
  read.distance = object.text("distance", std::string(), 1, 1000);
  read.kind = object.text("kind", std::string(), 1, 1000);
  if (read.distance.empty() != read.kind.empty())
    object.refuse(read.kind.empty() ? "kind" : "distance", say<"there where the other of the two is">());
  if (object.has("motion")) {
    const JsonFields motion = object.object("motion");
    read.motionFile = motion.text("file", {}, 1, 1000);
    read.motion = motionIn(motion);
  }
  if (object.has("flow")) read.flowFile = object.object("flow").text("file", {}, 1, 1000);
  if (reading.problem()) return passOn(*reading.problem());
  return read;
}

tl::unexpected<Error> unusable(ErrorCode code, Message sentence, const std::string& field, const std::string& found) {
  return failure(code, std::move(sentence), {{"field", field}, {"found", found}});
}

tl::unexpected<Error> onAnotherGrid(const std::string& field, const std::string& found) {
  return unusable(
      ErrorCode::badField,
      say<"'%1' in case.json is \"%2\", which lies on another grid than the volume; import or publish the case again.">(field, found),
      field, found);
}

/// One of the maps, on the grid that it has to have.
Result<std::vector<std::uint8_t>> readMap(const Case& opened, const std::string& relative, const std::string& field, const Grid& grid,
                                          Progress& progress, std::vector<Message>& notes) {
  const auto file = volumeOfCase(opened.folder, relative, field);
  if (!file) return passOn(file.error());
  const auto header = readVolumeHeader(*file);
  if (!header) return passOn(header.error());
  if (header->sequence || header->grid.dims != grid.dims) return onAnotherGrid(field, relative);
  auto read = readLabelVolume(*file, progress);
  if (!read) return passOn(read.error());
  if (read->volume.grid != grid) return onAnotherGrid(field, relative);
  notes.insert(notes.end(), read->notes.begin(), read->notes.end());
  return std::move(read->volume.echo);
}

Result<void> readSurfaces(const Case& opened, const EchoFields& fields, TissueMaps& maps, Progress& progress, std::vector<Message>& notes) {
  if (fields.distance.empty()) return {};
  PartOfProgress first(progress, 0.0, 0.5), second(progress, 0.5, 1.0);
  auto distance = readMap(opened, fields.distance, "echoes.distance", maps.grid, first, notes);
  if (!distance) return passOn(distance.error());
  auto kind = readMap(opened, fields.kind, "echoes.kind", maps.grid, second, notes);
  if (!kind) return passOn(kind.error());
  const auto most = kind->empty() ? std::uint8_t{0} : *std::max_element(kind->begin(), kind->end());
  if (most > fields.surfaces.size())
    return unusable(ErrorCode::badField,
                    say<"'%1' in case.json is \"%2\", which names the surface %3 of %4; import or publish the case again.">(
                        std::string("echoes.kind"), fields.kind, static_cast<int>(most), fields.surfaces.size()),
                    "echoes.kind", fields.kind);
  maps.surfaceDistance = std::move(*distance);
  maps.surfaceKind = std::move(*kind);
  maps.surfaces = fields.surfaces;
  return {};
}

bool isShift(const glm::vec3& shift) {
  const auto good = [](float way) { return std::isfinite(way) && std::abs(static_cast<double>(way)) <= kFarthestShift_mm; };
  return good(shift.x) && good(shift.y) && good(shift.z);
}

Result<TissueMotion> readMotion(const Case& opened, const EchoFields& fields) {
  const std::string field = "echoes.motion.file";
  const auto file = fileOfCase(opened.folder, fields.motionFile, field);
  if (!file) return passOn(file.error());
  TissueMotion motion = *fields.motion;
  std::uintmax_t expected = 0;
  for (const TissueMotion::Mode& mode : motion.modes) expected += mode.grid.voxelCount() * sizeof(glm::vec3);
  std::error_code problem;
  const std::uintmax_t size = fs::file_size(*file, problem);
  const auto cutOff = [&] {
    return unusable(ErrorCode::truncated,
                    say<"'%1' in case.json is \"%2\", which holds %3 bytes instead of %4; import or publish the case again.">(
                        field, fields.motionFile, problem ? std::uintmax_t{0} : size, expected),
                    field, fields.motionFile);
  };
  if (problem || size != expected) return cutOff();
  std::ifstream in(*file, std::ios::binary);
  for (TissueMotion::Mode& mode : motion.modes) {
    mode.shift_mm.resize(mode.grid.voxelCount());
    in.read(reinterpret_cast<char*>(mode.shift_mm.data()), static_cast<std::streamsize>(mode.shift_mm.size() * sizeof(glm::vec3)));
    if (!in) return cutOff();
    if (!std::all_of(mode.shift_mm.begin(), mode.shift_mm.end(), isShift))
      return unusable(ErrorCode::badField,
                      say<"'%1' in case.json is \"%2\", in which tissue moves by what is no number or by more than %3 mm; import or "
                          "publish the case again.">(field, fields.motionFile, static_cast<int>(kFarthestShift_mm)),
                      field, fields.motionFile);
  }
  return motion;
}

/// @error as fileOfCase and readJsonFile; badField
Result<FlowField> readFlow(const Case& opened, const EchoFields& fields) {
  const auto file = fileOfCase(opened.folder, fields.flowFile, "echoes.flow.file");
  if (!file) return passOn(file.error());
  const Message where = verbatim(fields.flowFile);
  const auto document = readJsonFile(*file, where, kMostFlow_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  FlowField flow = flowIn(JsonFields(*document, reading));
  if (reading.problem()) return passOn(*reading.problem());
  return flow;
}

/// Without the names of its streams, which say what a trainee may be asked for.
Result<void> writeFlow(FlowField flow, const fs::path& file) {
  for (FlowStream& stream : flow.streams) stream.name.clear();
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  return writeFileSafely(file, fileJsonOf(flow).dump());
}

/// The shifts of all fields, one after another.
Result<void> writeShifts(const TissueMotion& motion, const fs::path& file) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    for (const TissueMotion::Mode& mode : motion.modes)
      out.write(reinterpret_cast<const char*>(mode.shift_mm.data()),
                static_cast<std::streamsize>(mode.shift_mm.size() * sizeof(glm::vec3)));
    return {};
  });
}

ordered_json listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

ordered_json jsonOf(const TissueMotion& motion) {
  ordered_json written = keptJsonOf(motion.rhythms);
  written["file"] = kMotionName;
  written["fields"] = ordered_json::array();
  for (const TissueMotion::Mode& mode : motion.modes) {
    EW_EXPECTS(mode.grid.directions == glm::dmat3(1.0));
    written["fields"].push_back({{"kind", kFieldWords[static_cast<std::size_t>(mode.kind)].first},
                                 {"dims", {mode.grid.dims.x, mode.grid.dims.y, mode.grid.dims.z}},
                                 {"spacing_mm", listOf(mode.grid.spacing_mm)},
                                 {"origin_mm", listOf(mode.grid.origin_mm)}});
  }
  return written;
}

}  // namespace

std::vector<std::string> echoFilesOf(const Case& opened) {
  std::vector<std::string> files;
  const json& echoes = memberOf(opened.otherFields, kEchoesField);
  for (std::string file : {textAt(echoes, "distance"), textAt(echoes, "kind"), textAt(memberOf(echoes, "motion"), "file"),
                           textAt(memberOf(echoes, "flow"), "file")})
    if (!file.empty()) files.push_back(std::move(file));
  return files;
}

std::vector<Error> problemsOfEchoes(const Case& opened) {
  const json& echoes = memberOf(opened.otherFields, kEchoesField);
  if (echoes.is_null()) return {};
  const fs::path& folder = opened.folder;
  const auto fields = echoFieldsIn(echoes);
  if (!fields) return {fields.error()};
  std::vector<Error> problems;
  if (!opened.volume.recipe.empty())
    problems.push_back({ErrorCode::badField,
                        say<"'echoes' in case.json stands beside a recipe, which makes its own; take one of them out.">(),
                        {{"field", kEchoesField}, {"expected", "no echoes beside a recipe"}}});
  else if (opened.volume.level.empty())
    problems.push_back(fieldError(verbatim(kManifestName), kEchoesField, say<"given, and the volume has no level">(),
                                  say<"left out, or beside the volume.level that it belongs to">()));
  for (const auto& [file, field] : {std::pair{&fields->distance, "echoes.distance"}, std::pair{&fields->kind, "echoes.kind"}})
    if (!file->empty())
      if (auto found = volumeOfCase(folder, *file, field); !found) problems.push_back(found.error());
  if (!fields->motionFile.empty())
    if (auto found = fileOfCase(folder, fields->motionFile, "echoes.motion.file"); !found) problems.push_back(found.error());
  if (!fields->flowFile.empty())
    if (auto found = fileOfCase(folder, fields->flowFile, "echoes.flow.file"); !found) problems.push_back(found.error());
  return problems;
}

Result<CaseTissue> readTissue(const Case& opened, Volume level, const Grid& volume, Progress& progress, std::vector<Message>& notes) {
  const json& echoes = memberOf(opened.otherFields, kEchoesField);
  CaseTissue read{std::make_shared<TissueMaps>(recordedMaps(level.grid, std::move(level.echo)))};
  if (echoes.is_null()) return read;
  const auto fields = echoFieldsIn(echoes);
  if (!fields) return passOn(fields.error());
  if (read.maps->grid != volume) return onAnotherGrid("volume.level", opened.volume.level);
  read.maps->isRecorded = false;
  if (auto surfaces = readSurfaces(opened, *fields, *read.maps, progress, notes); !surfaces) return passOn(surfaces.error());
  if (fields->motion) {
    auto motion = readMotion(opened, *fields);
    if (!motion) return passOn(motion.error());
    read.motion = std::make_shared<TissueMotion>(std::move(*motion));
  }
  if (!fields->flowFile.empty()) {
    auto flow = readFlow(opened, *fields);
    if (!flow) return passOn(flow.error());
    read.flow = std::make_shared<const FlowField>(std::move(*flow));
  }
  return read;
}

Result<void> addEchoes(Case& into, const fs::path& folder, const TissueMaps& maps, const TissueMotion* motion, const FlowField* flow,
                       Progress& progress) {
  PartOfProgress first(progress, 0.0, 0.5), second(progress, 0.5, 1.0);
  ordered_json echoes = ordered_json::object();
  if (!maps.surfaces.empty() && !maps.surfaceDistance.empty()) {
    echoes["surfaces"] = ordered_json::array();
    for (const ReflectingSurface& surface : maps.surfaces) {
      echoes["surfaces"].push_back(keptJsonOf(surface));
      echoes["surfaces"].back().erase("name");
    }
    const auto distance = addVolume({maps.grid, maps.surfaceDistance, {}}, folder, first);
    if (!distance) return passOn(distance.error());
    const auto kind = addVolume({maps.grid, maps.surfaceKind, {}}, folder, second);
    if (!kind) return passOn(kind.error());
    echoes["distance"] = *distance;
    echoes["kind"] = *kind;
  }
  if (motion != nullptr) {
    if (auto written = writeShifts(*motion, folder / kMotionName); !written) return written;
    echoes["motion"] = jsonOf(*motion);
  }
  if (flow != nullptr) {
    FlowField within = flowWithin(*flow, boundsOf(maps.grid), kFlowMargin_mm);
    if (!within.streams.empty()) {
      if (auto written = writeFlow(std::move(within), folder / kFlowName); !written) return written;
      echoes["flow"] = {{"file", kFlowName}};
    }
  }
  into.otherFields[kEchoesField] = json(echoes);
  return {};
}

}  // namespace ew
