#include "ew/tracking/fit_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "alignment_words.h"

namespace ew {
namespace {

constexpr double kStretch_s = 1.0;
constexpr double kLongestGap_s = 0.3;  // between samples of one stretch
constexpr std::size_t kFewestSamples = 6;
constexpr double kMostWay_mm = 90.0;   // who goes faster carries the probe
constexpr double kLeastWay_mm = 4.0;   // a hand that stands still claims nothing
constexpr double kSteadyShare = 0.15;  // of the way: how much the distance may change
constexpr double kSteady_mm = 1.5;     // or so much, by noise and by how hard a hand presses
constexpr double kFarthest_mm = 40.0;  // beyond this from the skin nobody means to touch it
constexpr double kLooksIn = 0.5;       // cosine of the beam against the inward normal: 60 degrees
constexpr double kMemory_s = 20.0;

/// Of a sequence that is sorted.
double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

}  // namespace

void FitCheck::add(const Pose& pose, const Skin& skin, bool isUsed) {
  const bool isBreak = !second_.empty() && (pose.time_s < second_.back().time_s || pose.time_s - second_.back().time_s > kLongestGap_s);
  if (!isUsed || pose.status != PoseStatus::ok || isBreak) second_.clear();
  if (!isUsed || pose.status != PoseStatus::ok) return;
  Sample sample;
  sample.time_s = pose.time_s;
  sample.face_mm = glm::dvec3(pose.probeToWorld.matrix[3]);
  const Skin::Contact foot = skin.nearest(sample.face_mm);
  sample.foot_mm = foot.point_mm;
  sample.distance_mm = glm::dot(sample.face_mm - foot.point_mm, foot.outward) < 0.0 ? -glm::distance(sample.face_mm, foot.point_mm)
                                                                                    : glm::distance(sample.face_mm, foot.point_mm);
  sample.looksIn = glm::dot(glm::normalize(glm::dvec3(pose.probeToWorld.matrix[1])), -foot.outward) > kLooksIn;
  second_.push_back(sample);
  if (second_.back().time_s - second_.front().time_s < kStretch_s) return;
  judgeSecond();
  second_.clear();
}

void FitCheck::judgeSecond() {
  if (second_.size() < kFewestSamples) return;
  std::vector<double> distances;
  double way_mm = 0.0;
  // Noise of single readings is no way: steps are counted between points a seventh of the stretch apart.
  const std::size_t step = std::max<std::size_t>(1, second_.size() / 7);
  for (std::size_t n = 0; n < second_.size(); ++n) {
    if (!second_[n].looksIn || std::abs(second_[n].distance_mm) > kFarthest_mm) return;
    distances.push_back(second_[n].distance_mm);
    if (n >= step && n % step == 0) way_mm += glm::distance(second_[n].foot_mm, second_[n - step].foot_mm);
  }
  std::sort(distances.begin(), distances.end());
  const double change_mm = quantile(distances, 0.95) - quantile(distances, 0.05);
  if (way_mm < kLeastWay_mm || way_mm > kMostWay_mm || change_mm > std::max(kSteady_mm, kSteadyShare * way_mm)) return;
  stretches_.push_back({second_.front().time_s, second_.back().time_s, quantile(distances, 0.5), way_mm});
  while (stretches_.front().begin_s < stretches_.back().end_s - kMemory_s) stretches_.pop_front();
  judgeStretches();
}

void FitCheck::judgeStretches() {
  std::vector<double> distances;
  double way_mm = 0.0;
  claimed_s_ = 0.0;
  for (const Stretch& stretch : stretches_) {
    distances.push_back(stretch.distance_mm);
    way_mm += stretch.way_mm;
    claimed_s_ += stretch.end_s - stretch.begin_s;
  }
  std::sort(distances.begin(), distances.end());
  gap_mm_ = quantile(distances, 0.5);
  if (claimed_s_ < options_.forAtLeast_s || way_mm < options_.slid_mm) {
    off_ = false;
    return;
  }
  // Three quarters have to agree: a hand that carries the probe above the skin was on it shortly before.
  off_ = quantile(distances, 0.25) > options_.gap_mm || quantile(distances, 0.75) < -options_.press_mm;
}

Message FitCheck::problem() const {
  if (!off_) return {};
  if (gap_mm_ > 0.0)
    return say<"The calibration no longer fits: the probe moves over the skin, but is measured %1 mm above it. Align it again.">(
        tenths(gap_mm_));
  return say<"The calibration no longer fits: the probe is measured %1 mm inside the body, deeper than a hand presses. Align it again.">(
      tenths(-gap_mm_));
}

void FitCheck::reset() {
  second_.clear();
  stretches_.clear();
  gap_mm_ = claimed_s_ = 0.0;
  off_ = false;
}

}  // namespace ew
