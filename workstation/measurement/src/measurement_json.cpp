#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/measurement/measurement_list.h"

namespace ew::measurement {
namespace {

using nlohmann::json;

constexpr std::size_t kMostMeasurements = 1000;
constexpr int kLargestNumber = 1000000;

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kSideWords{{{"", ""}, {"right", "right"}, {"left", "left"}}};

std::vector<glm::dvec2> pointsIn(const JsonFields& fields, const CaliperShape& shape) {
  std::vector<glm::dvec2> points;
  const json& listed = fields.list("points", shape.fewest, shape.most, say<"a list of %1 to %2 points">(shape.fewest, shape.most));
  for (std::size_t n = 0; n < listed.size(); ++n) {
    const json& each = listed[n];
    const bool isPair = each.is_array() && each.size() == 2;
    const auto x = isPair ? numberWithin(each[0], -kFarthestPoint, kFarthestPoint) : std::nullopt;
    const auto y = isPair ? numberWithin(each[1], -kFarthestPoint, kFarthestPoint) : std::nullopt;
    if (!x || !y) {
      fields.refuse("points[" + std::to_string(n) + "]", ew::shown(each), say<"two numbers, a point">());
      return {};
    }
    points.emplace_back(*x, *y);
  }
  return points;
}

CaliperKind kindIn(const JsonFields& fields) {
  const auto kind = caliperKindOf(fields.text("kind"));
  if (!kind)
    fields.refuse("kind", say<"a kind of caliper: distance, poly_line, ellipse, fitted_ellipse, trace, angle, ratio, ellipsoid, discs, "
                              "biplane, interval, slope, heart_rate or depth_distance">());
  return kind.value_or(CaliperKind::distance);
}

Caliper caliperIn(const JsonFields& fields) {
  Caliper caliper;
  caliper.kind = kindIn(fields);
  caliper.cycles = static_cast<int>(fields.whole("cycles", 1, kMostCycles, 1));
  const CaliperShape shape = shapeOf(caliper.kind);
  for (const JsonFields& part : fields.objects("parts", shape.parts, shape.parts)) {
    part.only({"picture", "points"});
    caliper.parts.push_back({static_cast<int>(part.whole("picture", 0, 1000, 0)), pointsIn(part, shape)});
  }
  return caliper;
}

}  // namespace

json toJson(const Measurements& measurements) {
  json all = json::array();
  for (const Measurement& each : measurements.all) {
    json parts = json::array();
    for (const CaliperPart& part : each.caliper.parts) {
      json points = json::array();
      for (const glm::dvec2& point : part.points) points.push_back(json::array({point.x, point.y}));
      parts.push_back({{"picture", part.image}, {"points", std::move(points)}});
    }
    json one = {{"number", each.number}, {"kind", wordOf(each.caliper.kind)}, {"parts", std::move(parts)}};
    if (!each.name.empty()) one["name"] = each.name;
    if (!each.item.empty()) one["item"] = each.item;
    if (!each.side.empty()) one["side"] = each.side;
    if (each.caliper.cycles != 1) one["cycles"] = each.caliper.cycles;
    all.push_back(std::move(one));
  }
  return {{"format", kMeasurementsFormat}, {"next_number", measurements.nextNumber}, {"measurements", std::move(all)}};
}

Result<Measurements> measurementsFromJson(const json& document, const Message& where) {
  JsonReading reading(where);
  const JsonFields fields(document, reading);
  requireFormat(fields, kMeasurementsFormat);
  fields.only({"format", "next_number", "measurements"});
  Measurements made;
  made.nextNumber = static_cast<int>(fields.whole("next_number", 1, kLargestNumber));
  std::set<int> numbers;
  for (const JsonFields& each : fields.objects("measurements", 0, kMostMeasurements)) {
    each.only({"number", "name", "item", "side", "kind", "cycles", "parts"});
    Measurement one;
    one.number = static_cast<int>(each.whole("number", 1, made.nextNumber - 1, {}, say<"a whole number from 1 to below next_number">()));
    if (each.good() && !numbers.insert(one.number).second) each.refuse("number", say<"a number that no other measurement has">());
    one.name = each.text("name", "", 0);
    one.item = each.text("item", "", 0);
    one.side = each.word("side", kSideWords, std::optional<std::string_view>(""));
    one.caliper = caliperIn(each);
    made.all.push_back(std::move(one));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return made;
}

}  // namespace ew::measurement
