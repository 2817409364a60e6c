#include "logic/alignment.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/motion.h"
#include "ew/assessment/time_warping.h"

namespace ew::review {
namespace {

/// Valid poses of a part, no nearer to each other than a step, the first and the last among them.
std::vector<Pose> thinned(const ScanLog& log, const Part& part, const AlignmentOptions& options) {
  std::vector<Pose> all = posesOf(log, part.begin_s, part.end_s);
  std::erase_if(all, [](const Pose& pose) { return pose.status != PoseStatus::ok; });
  if (all.empty()) return all;
  const double length_s = all.back().time_s - all.front().time_s;
  const double step_s = std::max(options.step_s, length_s / static_cast<double>(options.mostPoses));
  std::vector<Pose> kept;
  for (const Pose& pose : all)
    if (kept.empty() || pose.time_s >= kept.back().time_s + step_s - 1e-9) kept.push_back(pose);
  if (kept.back().time_s < all.back().time_s) kept.push_back(all.back());
  return kept;
}

double between(const std::vector<double>& from, const std::vector<double>& to, double x) {
  const auto above = std::lower_bound(from.begin(), from.end(), x);
  if (above == from.begin()) return to.front();
  if (above == from.end()) return to.back();
  const auto n = static_cast<std::size_t>(above - from.begin());
  const double gap = from[n] - from[n - 1];
  return gap > 0.0 ? to[n - 1] + (x - from[n - 1]) / gap * (to[n] - to[n - 1]) : to[n];
}

}  // namespace

Result<Alignment> Alignment::of(const ScanLog& first, const Part& firstPart, const ScanLog& second, const Part& secondPart,
                                Progress& progress, const AlignmentOptions& options) {
  const std::vector<Pose> a = thinned(first, firstPart, options), b = thinned(second, secondPart, options);
  if (a.empty() || b.empty())
    return failure(ErrorCode::noValidPose, say<"One of the scans has no valid pose of the probe; look at both on one clock.">());
  auto warped = warpTime(a, b, progress, options.mostBytes);
  if (!warped) return passOn(warped.error());
  Alignment made;
  made.mean_mm_ = warped->mean_mm;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double place = std::clamp(warped->inSecond(n), 0.0, static_cast<double>(b.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, b.size() - 1);
    made.first_s_.push_back(a[n].time_s);
    made.second_s_.push_back(b[below].time_s + (place - static_cast<double>(below)) * (b[above].time_s - b[below].time_s));
  }
  // The middle of what goes with an end is not the end: both scans begin and end together.
  if (a.size() > 1) {
    made.second_s_.front() = b.front().time_s;
    made.second_s_.back() = b.back().time_s;
  }
  return made;
}

double Alignment::inSecond_s(double first_s) const { return between(first_s_, second_s_, first_s); }
double Alignment::inFirst_s(double second_s) const { return between(second_s_, first_s_, second_s); }

void TwoScans::setOneClock(double offset_s) {
  alignment_.reset();
  if (std::isfinite(offset_s)) offset_s_ = offset_s;
}

Part TwoScans::range() const {
  if (alignment_) return {0.0, first_.length_s()};
  return {std::min(0.0, offset_s_), std::max(first_.length_s(), offset_s_ + second_.length_s())};
}

double TwoScans::inFirst_s(double clock_s) const { return std::clamp(first_.begin_s + clock_s, first_.begin_s, first_.end_s); }

double TwoScans::inSecond_s(double clock_s) const {
  const double time_s = alignment_ ? alignment_->inSecond_s(inFirst_s(clock_s)) : second_.begin_s + clock_s - offset_s_;
  return std::clamp(time_s, second_.begin_s, second_.end_s);
}

double TwoScans::fromFirst_s(double time_s) const { return time_s - first_.begin_s; }

double TwoScans::fromSecond_s(double time_s) const {
  if (alignment_) return alignment_->inFirst_s(time_s) - first_.begin_s;
  return time_s - second_.begin_s + offset_s_;
}

}  // namespace ew::review
