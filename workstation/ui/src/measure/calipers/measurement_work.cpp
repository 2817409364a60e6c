#include "measure/calipers/measurement_work.h"

#include <algorithm>
#include <array>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"

namespace ew::ui {
namespace {

using measurement::CombinationKind;
using measurement::FigureKind;
using nlohmann::json;

constexpr std::size_t kMostKeptImages = 2000;
constexpr long long kLargestImage = 1LL << 52;
constexpr int kLargestKeptNumber = 1000000;

constexpr std::array kCombinationKinds{CombinationKind::ratio, CombinationKind::percent, CombinationKind::reduction,
                                       CombinationKind::ellipsoid, CombinationKind::biplane};
constexpr std::array kFigureKinds{FigureKind::length,    FigureKind::circumference, FigureKind::area,    FigureKind::longAxis,
                                  FigureKind::shortAxis, FigureKind::angle,         FigureKind::ratio,   FigureKind::volume,
                                  FigureKind::slope,     FigureKind::heartRate,     FigureKind::duration};

/// The kind whose word stands there.
template <class Kind, std::size_t N>
Kind kindIn(const JsonFields& fields, const char* key, const std::array<Kind, N>& kinds) {
  const std::string word = fields.text(key);
  for (const Kind kind : kinds)
    if (measurement::wordOf(kind) == word) return kind;
  fields.refuse(key, say<"a kind that this program knows">());
  return kinds[0];
}

json jsonOfGeometry(const DisplayGeometry& geometry) {
  return {
      {"size_px", {geometry.width, geometry.height}},        {"pixel_mm", geometry.pixel_mm},      {"depth_mm", geometry.depth_mm},
      {"face_px", {geometry.face_px.x, geometry.face_px.y}}, {"marker_left", geometry.markerLeft}, {"upside_down", geometry.upsideDown}};
}

DisplayGeometry geometryIn(const JsonFields& fields) {
  DisplayGeometry geometry;
  const auto size = fields.numbers("size_px", 2, 2, 1, 8192);
  const auto face = fields.numbers("face_px", 2, 2, -1e9, 1e9);
  geometry.pixel_mm = fields.number("pixel_mm", 1e-6, 1e6);
  geometry.depth_mm = fields.number("depth_mm", 1e-6, 1e6);
  geometry.markerLeft = fields.flag("marker_left");
  geometry.upsideDown = fields.flag("upside_down");
  if (!fields.good()) return {};
  geometry.width = static_cast<int>(size[0]);
  geometry.height = static_cast<int>(size[1]);
  geometry.face_px = {face[0], face[1]};
  return geometry;
}

json jsonOfSheet(const MeasurementWork::Sheet& sheet) {
  json one = {{"package", sheet.package}, {"answers", json::array()}, {"found", json::array()}};
  if (sheet.gestation_weeks) one["gestation_weeks"] = *sheet.gestation_weeks;
  for (const auto& answer : sheet.answers)
    one["answers"].push_back({{"label", answer.label}, {"side", answer.side}, {"choice", answer.choice}});
  for (const auto& [image, number] : sheet.found) one["found"].push_back({{"picture", image}, {"number", number}});
  return one;
}

std::uint64_t imageIn(const JsonFields& fields) { return static_cast<std::uint64_t>(fields.whole("picture", 0, kLargestImage)); }
int numberIn(const JsonFields& fields) { return static_cast<int>(fields.whole("number", 1, kLargestKeptNumber)); }

MeasurementWork::Sheet sheetIn(const JsonFields& fields) {
  MeasurementWork::Sheet sheet;
  sheet.package = fields.text("package");
  if (fields.has("gestation_weeks")) sheet.gestation_weeks = fields.number("gestation_weeks", 0.0, 45.0);
  for (const JsonFields& each : fields.objects("answers", 0, 1000))
    sheet.answers.push_back({each.text("label"), each.text("side", "", 0), each.text("choice")});
  for (const JsonFields& each : fields.objects("found", 0, 10000)) sheet.found.emplace_back(imageIn(each), numberIn(each));
  return sheet;
}

}  // namespace

json jsonOf(const MeasurementWork& work) {
  json images = json::array(), sheets = json::array(), combinations = json::array();
  for (const ImageMeasurements& each : work.images)
    images.push_back(
        {{"picture", each.image}, {"geometry", jsonOfGeometry(each.geometry)}, {"measured", measurement::toJson(each.measurements)}});
  for (const MeasurementWork::Sheet& each : work.sheets) sheets.push_back(jsonOfSheet(each));
  for (const measurement::Combination& each : work.combinations) {
    json of = json::array();
    for (const measurement::FigureRef& figure : each.of)
      of.push_back({{"picture", figure.image}, {"number", figure.number}, {"figure", measurement::wordOf(figure.figure)}});
    combinations.push_back({{"kind", measurement::wordOf(each.kind)}, {"of", std::move(of)}});
  }
  return {{"format", kMeasuredWorkFormat},
          {"images", std::move(images)},
          {"worksheets", std::move(sheets)},
          {"current", work.current},
          {"results", std::move(combinations)}};
}

ScanRecording statesOf(const MeasurementWork& work) {
  ScanRecording states;
  double time_s = 0.0;
  for (const ImageMeasurements& each : work.images) {
    if (time_s == 0.0) states.size_px = {std::max(1, each.geometry.width), std::max(1, each.geometry.height)};
    ScanState state = each.state;
    state.time_s = time_s;
    states.log.addFrame(state);
    time_s += 1.0;
  }
  return states;
}

Result<MeasurementWork> measuredWorkFrom(const json& document, const ScanRecording& states, const Message& where) {
  JsonReading reading(where);
  const JsonFields fields(document, reading);
  requireFormat(fields, kMeasuredWorkFormat);
  MeasurementWork work;
  std::size_t frame = 0;
  for (const JsonFields& each : fields.objects("images", 0, kMostKeptImages)) {
    ImageMeasurements image;
    image.image = imageIn(each);
    image.geometry = geometryIn(each.object("geometry"));
    if (!reading.good() || frame >= states.log.frameCount()) break;
    auto measured = measurement::measurementsFromJson(each.object("measured").value(), where);
    if (!measured) return passOn(measured.error());
    image.measurements = std::move(*measured);
    image.state = states.log.frame(frame++);
    work.images.push_back(std::move(image));
  }
  for (const JsonFields& each : fields.objects("worksheets", 0, 100)) work.sheets.push_back(sheetIn(each));
  work.current = fields.text("current", "", 0);
  for (const JsonFields& each : fields.objects("results", 0, 1000)) {
    measurement::Combination one;
    one.kind = kindIn(each, "kind", kCombinationKinds);
    for (const JsonFields& of : each.objects("of", 1, 10))
      one.of.push_back({imageIn(of), numberIn(of), kindIn(of, "figure", kFigureKinds)});
    work.combinations.push_back(std::move(one));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return work;
}

}  // namespace ew::ui
