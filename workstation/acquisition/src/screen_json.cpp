#include <array>
#include <nlohmann/json.hpp>

#include "ew/acquisition/screen.h"
#include "ew/core/ending.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

using nlohmann::ordered_json;

constexpr double kDegree_rad = 0.017453292519943295;
constexpr int kVersion = 1;
constexpr double kFarthest_px = 1e6;

ordered_json toJson(const PixelRect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }
ordered_json toJson(glm::dvec2 p) { return {p.x, p.y}; }

ordered_json toJson(const FanOutline& outline) {
  ordered_json json{{"shape", wordIn(kFanShapeWords, outline.shape)}};
  if (outline.shape == FanShape::linear) {
    for (const glm::dvec2 corner : outline.corners_px) json["corners_px"].push_back(toJson(corner));
    return json;
  }
  json["apex_px"] = toJson(outline.apex_px);
  json["left_deg"] = factorGiving(outline.left_rad, kDegree_rad);
  json["right_deg"] = factorGiving(outline.right_rad, kDegree_rad);
  json["near_px"] = outline.near_px;
  json["far_px"] = outline.far_px;
  return json;
}

glm::dvec2 pointOf(const JsonFields& fields, std::string_view key) {
  const auto numbers = fields.numbers(key, 2, 2, -kFarthest_px, kFarthest_px);
  return numbers.size() == 2 ? glm::dvec2(numbers[0], numbers[1]) : glm::dvec2(0.0);
}

FanOutline outlineOf(const JsonFields& fields) {
  FanOutline outline;
  outline.shape = fields.word("shape", kFanShapeWords);
  if (outline.shape == FanShape::linear) {
    fields.only({"shape", "corners_px"});
    const nlohmann::json& corners = fields.list("corners_px", 4, 4, say<"four corners, clockwise from the upper left one">());
    for (std::size_t n = 0; n < corners.size() && n < 4; ++n) {
      const auto& corner = corners[n];
      const auto x = corner.is_array() && corner.size() == 2 ? numberWithin(corner[0], -kFarthest_px, kFarthest_px) : std::nullopt;
      const auto y = corner.is_array() && corner.size() == 2 ? numberWithin(corner[1], -kFarthest_px, kFarthest_px) : std::nullopt;
      if (!x || !y) {
        fields.refuse("corners_px", shown(corner), say<"x and y of each corner, in pixels">());
        break;
      }
      outline.corners_px[n] = {*x, *y};
    }
    return outline;
  }
  fields.only({"shape", "apex_px", "left_deg", "right_deg", "near_px", "far_px"});
  outline.apex_px = pointOf(fields, "apex_px");
  outline.left_rad = fields.number("left_deg", -90.0, 90.0) * kDegree_rad;
  outline.right_rad = fields.number("right_deg", -90.0, 90.0) * kDegree_rad;
  outline.near_px = fields.number("near_px", 0.0, kFarthest_px);
  outline.far_px = fields.number("far_px", 1.0, kFarthest_px);
  if (fields.good() && outline.right_rad <= outline.left_rad) fields.refuse("right_deg", say<"larger than \"left_deg\"">());
  if (fields.good() && outline.far_px <= outline.near_px) fields.refuse("far_px", say<"larger than \"near_px\"">());
  return outline;
}

std::vector<PixelRect> boxesOf(const JsonFields& fields, std::string_view key) {
  std::vector<PixelRect> boxes;
  for (const nlohmann::json& box : fields.list(key, 0, 10000)) {
    std::array<int, 4> numbers{};
    bool good = box.is_array() && box.size() == 4;
    for (std::size_t n = 0; good && n < 4; ++n) {
      const auto value = numberWithin(box[n], n < 2 ? -kFarthest_px : 1.0, kFarthest_px);
      good = value.has_value() && *value == static_cast<double>(static_cast<int>(*value));
      if (good) numbers[n] = static_cast<int>(*value);
    }
    if (!good) {
      fields.refuse(key, shown(box), say<"boxes of whole pixels: x, y, width, height">());
      break;
    }
    boxes.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  }
  return boxes;
}

ordered_json toJson(const ScreenCorrection& correction) {
  ordered_json json = ordered_json::object();
  if (correction.turned.quarterTurns != 0) json["turn_deg"] = correction.turned.degrees();
  if (correction.turned.mirrored) json["mirror"] = true;
  if (correction.outline) json["outline"] = toJson(*correction.outline);
  if (correction.depth_mm) json["depth_mm"] = *correction.depth_mm;
  if (correction.tick_mm) json["tick_mm"] = *correction.tick_mm;
  for (const auto& [key, boxes] : {std::pair("added", &correction.added), std::pair("removed", &correction.removed)}) {
    json[key] = ordered_json::array();
    for (const PixelRect& box : *boxes) json[key].push_back(toJson(box));
  }
  return json;
}

ordered_json toJson(const ScreenAnalysis& found) {
  ordered_json json{{"size_px", {found.width_px, found.height_px}}, {"frames", found.frames}, {"quality", found.quality}};
  json["outline"] = found.outline ? toJson(*found.outline) : ordered_json(nullptr);
  if (found.ticks)
    json["ticks"] = {{"x_px", found.ticks->x_px},   {"first_px", found.ticks->first_px}, {"spacing_px", found.ticks->spacing_px},
                     {"count", found.ticks->count}, {"every", found.ticks->every},       {"residual_px", found.ticks->residual_px}};
  json["parts"] = ordered_json::array();
  for (const ScreenPart& part : found.parts) json["parts"].push_back({{"kind", nameOf(part.kind)}, {"box_px", toJson(part.rect)}});
  return json;
}

Orientation orientationOf(const JsonFields& fields) {
  const auto degrees = static_cast<int>(fields.whole("turn_deg", 0, 270, 0));
  if (degrees % 90 != 0) fields.refuse("turn_deg", say<"0, 90, 180 or 270, clockwise">());
  return {degrees / 90, fields.flag("mirror", false)};
}

}  // namespace

std::filesystem::path screenFileBeside(const std::filesystem::path& recording) {
  // "liver.1.igs.mha" and "liver.2.igs.mha" have files of their own.
  std::filesystem::path name = recording.filename().stem();
  if (hasEnding(name, ".igs")) name = name.stem();
  return recording.parent_path() / (name.string() + ".screen.json");
}

Result<void> writeScreen(const ScreenAnalysis& found, const ScreenCorrection& correction, const std::filesystem::path& file) {
  const ordered_json document{
      {"format", "echoweave-screen"}, {"version", kVersion}, {"found", toJson(found)}, {"correction", toJson(correction)}};
  return writeFileSafely(file, document.dump(2) + "\n");
}

Result<ScreenCorrection> readScreenCorrection(const std::filesystem::path& file) {
  const auto document = readJsonFile(file, verbatim(file.filename().string()), 64u << 20);
  if (!document) return passOn(document.error());
  JsonReading reading(verbatim(file.filename().string()), {"note"});
  const JsonFields whole(*document, reading);
  whole.only({"format", "version", "found", "correction"});
  if (whole.text("format", "echoweave-screen") != "echoweave-screen") whole.refuse("format", verbatim("\"echoweave-screen\""));
  const long long version = whole.whole("version", 1, 1000000, kVersion);
  if (reading.good() && version > kVersion)
    return failure(
        ErrorCode::newerFormat,
        say<"'%1' has version %2 of its format and this program knows %3; use a newer EchoWeave.">(file.filename(), version, kVersion),
        {{"file", file.string()}});
  const JsonFields fields = whole.object("correction");
  fields.only({"turn_deg", "mirror", "outline", "depth_mm", "tick_mm", "added", "removed"});
  ScreenCorrection correction;
  correction.turned = orientationOf(fields);
  if (fields.has("outline")) correction.outline = outlineOf(fields.object("outline"));
  if (fields.has("depth_mm")) correction.depth_mm = fields.number("depth_mm", 0.1, 10000.0);
  if (fields.has("tick_mm")) correction.tick_mm = fields.number("tick_mm", 0.01, 10000.0);
  correction.added = boxesOf(fields, "added");
  correction.removed = boxesOf(fields, "removed");
  if (reading.problem()) return passOn(*reading.problem());
  return correction;
}

}  // namespace ew
