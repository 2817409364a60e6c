#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

#include "ew/core/numbers.h"
#include "ew/io/sequence.h"
#include "sweeps/transform_name.h"
#include "sweeps/usable_transform.h"

namespace ew {
namespace detail {

bool isUsable(const FrameTransform& transform) {
  const glm::dmat4& m = transform.matrix;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row])) return false;
  constexpr double nearly = 1e-9;
  if (std::abs(m[0][3]) > nearly || std::abs(m[1][3]) > nearly || std::abs(m[2][3]) > nearly || std::abs(m[3][3] - 1.0) > nearly)
    return false;
  // Relative to the lengths of the axes, so that a calibration of 1e-5 mm per pixel is as good as one of 1 mm.
  const double volume = std::abs(glm::determinant(glm::dmat3(m)));
  const double box = glm::length(glm::dvec3(m[0])) * glm::length(glm::dvec3(m[1])) * glm::length(glm::dvec3(m[2]));
  return box > 0.0 && volume > 1e-6 * box;
}

Message problemOf(const FrameTransform& transform) {
  if (isUsable(transform)) return {};
  const glm::dmat4& m = transform.matrix;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row])) return say<"it holds something that is no finite number">();
  if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0) {
    const std::string last = textOf(m[0][3]) + " " + textOf(m[1][3]) + " " + textOf(m[2][3]) + " " + textOf(m[3][3]);
    const bool turned = m[3][3] == 1.0 && glm::dvec3(m[3]) == glm::dvec3(0.0);
    return turned ? say<"its last row is %1 instead of 0 0 0 1, as when rows and columns are exchanged">(last)
                  : say<"its last row is %1 instead of 0 0 0 1">(last);
  }
  for (int column = 0; column < 3; ++column)
    if (!(glm::length(glm::dvec3(m[column])) > 0.0)) return say<"its column %1 holds nothing but 0">(column + 1);
  return say<"its first three columns do not span a space: all points would fall into one plane">();
}

bool giveThickness(FrameTransform& transform) {
  if (transform.from != "Image" || glm::dvec3(transform.matrix[2]) != glm::dvec3(0.0)) return false;
  const glm::dvec3 x(transform.matrix[0]), y(transform.matrix[1]);
  const glm::dvec3 upright = glm::cross(x, y);
  if (!(glm::length(upright) > 0.0)) return false;
  FrameTransform thick = transform;
  thick.matrix[2] = glm::dvec4(glm::normalize(upright) * std::sqrt(glm::length(x) * glm::length(y)), 0.0);
  if (!isUsable(thick)) return false;
  transform = std::move(thick);
  return true;
}

std::optional<TransformName> splitTransformName(std::string_view joined) {
  const auto mayBegin = [](char letter) { return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9'); };
  for (auto at = joined.find("To", 1); at != std::string_view::npos; at = joined.find("To", at + 1))
    if (at + 2 < joined.size() && mayBegin(joined[at + 2]))
      return TransformName{std::string(joined.substr(0, at)), std::string(joined.substr(at + 2))};
  return std::nullopt;
}

}  // namespace detail

std::optional<glm::dmat4> chain(std::span<const FrameTransform> transforms, std::string_view from, std::string_view to) {
  if (from == to) return glm::dmat4(1.0);
  struct Stop {
    std::string_view name;
    glm::dmat4 fromToHere{1.0};
  };
  std::vector<bool> tried(transforms.size(), false);
  std::set<std::string_view> seen{from};
  std::queue<Stop> ahead;
  ahead.push({from, glm::dmat4(1.0)});
  while (!ahead.empty()) {
    const Stop here = ahead.front();
    ahead.pop();
    for (std::size_t i = 0; i < transforms.size(); ++i) {
      const FrameTransform& step = transforms[i];
      const bool forwards = step.from == here.name;
      if (tried[i] || (!forwards && step.to != here.name)) continue;
      if (step.status != PoseStatus::ok || !detail::isUsable(step)) continue;
      tried[i] = true;
      const std::string_view next = forwards ? step.to : step.from;
      if (!seen.insert(next).second) continue;
      const glm::dmat4 fromToNext = (forwards ? step.matrix : glm::inverse(step.matrix)) * here.fromToHere;
      if (next == to) return fromToNext;
      ahead.push({next, fromToNext});
    }
  }
  return std::nullopt;
}

std::vector<std::string> reachableFrom(std::span<const FrameTransform> transforms, std::string_view from) {
  std::vector<std::string> reached{std::string(from)};
  for (std::size_t at = 0; at < reached.size(); ++at)
    for (const FrameTransform& step : transforms) {
      if (step.status != PoseStatus::ok || !detail::isUsable(step)) continue;
      for (const auto& [here, next] : {std::pair(&step.from, &step.to), std::pair(&step.to, &step.from)})
        if (*here == reached[at] && std::find(reached.begin(), reached.end(), *next) == reached.end()) reached.push_back(*next);
    }
  reached.erase(reached.begin());
  return reached;
}

}  // namespace ew
