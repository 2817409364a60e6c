#include <algorithm>

#include "ew/assessment/step_metrics.h"
#include "ew/scanning/contact.h"

namespace ew {

std::vector<FrameDwell> heldFramesOf(const ScanLog& log) {
  std::vector<FrameDwell> held;
  held.reserve(log.frameCount());
  bool isFrozen = false, isPaused = false;
  double since_s = 0.0;
  const auto hold = [&](double until_s) {
    if (!held.empty() && !isFrozen && !isPaused) held.back().seconds += std::max(0.0, until_s - since_s);
    since_s = until_s;
  };
  std::size_t frame = 0;
  for (const ScanEvent& event : log.events()) {
    if (std::holds_alternative<FrameMade>(event.what)) {
      hold(event.time_s);
      held.push_back({frame++, 0.0});
    } else if (const auto* freeze = std::get_if<FreezeChanged>(&event.what)) {
      hold(event.time_s);
      isFrozen = freeze->isFrozen;
    } else if (const auto* note = std::get_if<Note>(&event.what)) {
      hold(event.time_s);
      if (note->kind == "pause") isPaused = true;
      if (note->kind == "resume") isPaused = false;
    }
  }
  return held;
}

std::vector<Pose> heldPosesOf(const ScanLog& log) {
  constexpr double kStep_s = 0.04;
  constexpr double kRest_s = 0.1;  // images that follow one another more quickly are a motion
  std::vector<Pose> poses;
  poses.reserve(log.frameCount());
  for (const FrameDwell& held : heldFramesOf(log)) {
    Pose pose = log.made(held.frame).pose;
    pose.time_s = log.frameTime_s(held.frame);
    poses.push_back(pose);
    if (held.seconds <= kRest_s) continue;
    const auto steps = static_cast<int>(held.seconds / kStep_s);
    for (int n = 1; n < steps; ++n) {
      Pose again = pose;
      again.time_s += n * kStep_s;
      poses.push_back(again);
    }
  }
  return poses;
}

ContactFigures contactOf(const ScanLog& log) {
  constexpr double kTouching = 0.5;  // of the face: less shows more black than image
  ContactFigures found;
  double seconds = 0.0, lost_s = 0.0, touching_s = 0.0, pressed_mmS = 0.0;
  bool hasGaps = false;
  for (const FrameDwell& held : heldFramesOf(log)) {
    const FrameMade& image = log.made(held.frame);
    if (image.pose.status != PoseStatus::ok) continue;
    const double share = image.gaps_mm.empty() ? 1.0 : contactShare(image.gaps_mm);
    if (!found.first_s) {
      if (share <= 0.0) continue;
      found.first_s = log.frameTime_s(held.frame);
    }
    seconds += held.seconds;
    if (share < kTouching) lost_s += held.seconds;
    if (image.gaps_mm.empty() || share <= 0.0) continue;
    hasGaps = true;
    touching_s += held.seconds;
    pressed_mmS += held.seconds * std::max(0.0, -static_cast<double>(*std::min_element(image.gaps_mm.begin(), image.gaps_mm.end())));
  }
  if (seconds > 0.0) found.lossShare = lost_s / seconds;
  if (hasGaps && touching_s > 0.0) found.press_mm = pressed_mmS / touching_s;
  return found;
}

double validShareOf(const ScanLog& log) {
  if (log.frameCount() == 0) return 1.0;
  std::size_t valid = 0;
  for (const ScanEvent& event : log.events())
    if (const auto* frame = std::get_if<FrameMade>(&event.what)) valid += frame->pose.status == PoseStatus::ok ? 1 : 0;
  return static_cast<double>(valid) / static_cast<double>(log.frameCount());
}

}  // namespace ew
