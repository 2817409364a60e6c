#include "ew/assessment/time_warping.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kLever_mm = 60.0;

enum Step : std::uint8_t { both, inFirst, inSecond };

struct Held {
  glm::dvec3 face_mm;
  glm::dquat turn;
};

Held heldOf(const Transform<frame::World, frame::Probe>& pose) {
  return {glm::dvec3(pose.matrix[3]), glm::normalize(glm::quat_cast(glm::dmat3(pose.matrix)))};
}

double distance_mm(const Held& a, const Held& b) {
  const glm::dquat between = glm::conjugate(a.turn) * b.turn;
  const double angle_rad = 2.0 * std::atan2(glm::length(glm::dvec3(between.x, between.y, between.z)), std::abs(between.w));
  return std::hypot(glm::distance(a.face_mm, b.face_mm), kLever_mm * angle_rad);
}

}  // namespace

double poseDistance_mm(const Transform<frame::World, frame::Probe>& a, const Transform<frame::World, frame::Probe>& b) {
  return distance_mm(heldOf(a), heldOf(b));
}

double WarpingPath::inSecond(std::size_t n) const {
  EW_EXPECTS(!pairs.empty() && n <= pairs.back().first);
  const auto low = std::partition_point(pairs.begin(), pairs.end(), [&](const auto& each) { return each.first < n; });
  const auto high = std::partition_point(low, pairs.end(), [&](const auto& each) { return each.first <= n; });
  return 0.5 * static_cast<double>(low->second + std::prev(high)->second);
}

Result<WarpingPath> warpTime(std::span<const Pose> first, std::span<const Pose> second, Progress& progress, std::uint64_t mostBytes) {
  if (first.empty() || second.empty())
    return failure(ErrorCode::badUsage, say<"A scan without a valid pose cannot be compared; choose another one.">());
  const std::uint64_t bytes = static_cast<std::uint64_t>(first.size()) * second.size();
  if (bytes > mostBytes)
    return failure(ErrorCode::tooLarge,
                   say<"Putting scans of %1 and %2 poses on one clock takes %3 MiB of memory; compare shorter parts of them.">(
                       first.size(), second.size(), bytes >> 20),
                   {{"bytes", std::to_string(bytes)}});
  std::vector<Held> across;
  for (const Pose& each : second) across.push_back(heldOf(each.probeToWorld));
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<std::uint8_t> steps(static_cast<std::size_t>(bytes));
  std::vector<double> before(second.size(), kFar), now(second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
    progress.report(say<"Putting scans on one clock">(), static_cast<double>(i) / static_cast<double>(first.size()));
    const Held here = heldOf(first[i].probeToWorld);
    for (std::size_t j = 0; j < second.size(); ++j) {
      const double cost_mm = distance_mm(here, across[j]);
      if (i == 0 && j == 0) {
        now[0] = 2.0 * cost_mm;
        continue;
      }
      const double diagonal = i > 0 && j > 0 ? before[j - 1] + 2.0 * cost_mm : kFar;
      const double down = i > 0 ? before[j] + cost_mm : kFar, right = j > 0 ? now[j - 1] + cost_mm : kFar;
      now[j] = std::min({diagonal, down, right});
      steps[i * second.size() + j] = now[j] == diagonal ? both : now[j] == down ? inFirst : inSecond;
    }
    std::swap(before, now);
  }
  WarpingPath warped;
  double sum_mm = 0.0;
  for (std::size_t i = first.size() - 1, j = second.size() - 1;;) {
    warped.pairs.emplace_back(i, j);
    sum_mm += distance_mm(heldOf(first[i].probeToWorld), across[j]);
    if (i == 0 && j == 0) break;
    const std::uint8_t step = steps[i * second.size() + j];
    if (step != inSecond) --i;
    if (step != inFirst) --j;
  }
  std::reverse(warped.pairs.begin(), warped.pairs.end());
  warped.mean_mm = sum_mm / static_cast<double>(warped.pairs.size());
  return warped;
}

}  // namespace ew
