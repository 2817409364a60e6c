#include "ew/stitching/value_json.h"

#include <cmath>
#include <limits>

namespace ew::stitching {

using nlohmann::json;
using nlohmann::ordered_json;

/// JSON has no infinity.
ordered_json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}
double numberFrom(const json& value) {
  if (value.is_number()) return value.get<double>();
  const auto word = value.get<std::string>();
  const double infinite = std::numeric_limits<double>::infinity();
  return word == "inf" ? infinite : word == "-inf" ? -infinite : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> numbersFrom(const json& list) {
  std::vector<double> values;
  for (const auto& value : list) values.push_back(numberFrom(value));
  return values;
}

std::array<double, 16> rowsFrom(const json& data) {
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = numberFrom(data.at(i));
  return rows;
}
ordered_json jsonOf(const glm::dvec3& v) { return numbers(std::array{v.x, v.y, v.z}); }
glm::dvec3 vectorFrom(const json& data) { return {numberFrom(data.at(0)), numberFrom(data.at(1)), numberFrom(data.at(2))}; }

ordered_json jsonOf(const Grid& grid) {
  return {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
          {"spacing_mm", jsonOf(grid.spacing_mm)},
          {"origin_mm", jsonOf(grid.origin_mm)},
          {"directions", {jsonOf(grid.directions[0]), jsonOf(grid.directions[1]), jsonOf(grid.directions[2])}}};
}
Grid gridFrom(const json& data) {
  Grid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.dims[axis] = data.at("dims").at(static_cast<std::size_t>(axis)).get<int>();
    grid.directions[axis] = vectorFrom(data.at("directions").at(static_cast<std::size_t>(axis)));
  }
  grid.spacing_mm = vectorFrom(data.at("spacing_mm"));
  grid.origin_mm = vectorFrom(data.at("origin_mm"));
  return grid;
}

}  // namespace ew::stitching
