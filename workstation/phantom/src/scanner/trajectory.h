#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ew/phantom/virtual_sweep.h"
#include "patient/anatomy.h"
#include "shapes/smooth_noise.h"

namespace ew::phantom {

/// Where the probe of a sweep is at every moment, not at its images alone: trackers lag and jitter between them.
/// Before the beginning and after the end the probe stays where it was then.
class Trajectory {
 public:
  /// The patient must outlive the trajectory.
  /// @error badField (stations: none, too many, off the skin, outside the patient's box, looking out of the body, turned about; an
  ///        indentation too deep for the probe)
  [[nodiscard]] static Result<Trajectory> along(const Patient& patient, const Probe& probe, const SweepRecipe& recipe);

  [[nodiscard]] Transform<frame::World, frame::Probe> poseAt(double time_s) const;
  /// Where the motor stands, mm or degrees; 0 for a hand.
  [[nodiscard]] double motorAt(double time_s) const;
  /// The pose at motor position 0.
  [[nodiscard]] const Transform<frame::World, frame::Probe>& start() const { return start_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }

 private:
  /// What is joined smoothly between stations: the place, the image's lateral direction, and how the probe leans against the skin.
  using Knot = std::array<double, 10>;
  Trajectory(const Patient& patient, const Probe& probe, const SweepRecipe& recipe);
  [[nodiscard]] Result<void> placeStations();
  void measurePath();
  [[nodiscard]] double shareOfWay(double time_s) const;
  [[nodiscard]] Knot between(double knot) const;
  [[nodiscard]] Transform<frame::World, frame::Probe> handPose(double knot, double time_s) const;
  [[nodiscard]] glm::dmat3 skinFrame(const glm::dvec3& p_mm, const glm::dvec3& lateral) const;
  [[nodiscard]] Transform<frame::World, frame::Probe> pressed(const glm::dmat3& axes, const glm::dvec3& contact_mm) const;

  const Patient* patient_;
  Probe probe_;
  SweepRecipe recipe_;
  double duration_s_ = 0.0;
  double patch_mm_ = 1.0;
  Transform<frame::World, frame::Probe> start_;
  std::vector<Knot> knots_;
  std::vector<double> knotAt_;       // parameter of each knot
  std::vector<double> wayAt_;        // way made at evenly spaced parameters, as a share of the whole
  std::vector<double> shareOfTime_;  // way made at evenly spaced times, as a share of the whole
  std::vector<SmoothNoise> lean_;    // slow, about x, y, z
  std::vector<SmoothNoise> wander_;  // slow, along x, z
  std::vector<SmoothNoise> tremor_;  // fast, along x, z and about x, z
};

}  // namespace ew::phantom
