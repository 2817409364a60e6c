#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "ew/core/pose.h"
#include "ew/tracking/pose_source.h"

namespace guided_sweep {

/// A sweep from one pose to another, as a case keeps it.
struct SweepPlan {
  std::optional<ew::Pose> start, end;
  double duration_s = 6.0;  ///< 1 to 60
  [[nodiscard]] bool isWhole() const { return start && end; }
  bool operator==(const SweepPlan&) const = default;
};

/// The schema of the section "guided_sweep" of a case.
extern const char* const kSchema;
[[nodiscard]] nlohmann::json toJson(const SweepPlan& plan);
/// Expects what the schema accepts.
[[nodiscard]] SweepPlan planOf(const nlohmann::json& section);

/// Where the probe is after a part of the sweep, 0..1: the face moves along a line, the probe rotates evenly. Expects a whole plan.
[[nodiscard]] ew::Pose poseAlong(const SweepPlan& plan, double part);
/// Way of the middle of the face, mm; 0 unless the plan is whole.
[[nodiscard]] double length_mm(const SweepPlan& plan);

/// The sweep in time, from a moment of the scan's clock on.
class SweepPath final : public ew::PoseSource {
 public:
  /// Expects a whole plan.
  SweepPath(SweepPlan plan, double begin_s) : plan_(std::move(plan)), begin_s_(begin_s) {}
  [[nodiscard]] ew::Pose poseAt(double time_s) const override;
  [[nodiscard]] bool movesAfter(double time_s) const override { return time_s < end_s(); }
  [[nodiscard]] double end_s() const { return begin_s_ + plan_.duration_s; }

 private:
  SweepPlan plan_;
  double begin_s_;
};

}  // namespace guided_sweep
