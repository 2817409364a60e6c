#include "trainee_hand.h"

#include <cmath>
#include <numbers>

#include "ew/scanning/contact.h"

namespace ew::assessment {
namespace {

constexpr int kMostMovements = 6;                  // a first one and its corrections
constexpr double kNear_mm = 1.0, kNear_deg = 1.0;  // what nobody corrects
constexpr double kCorrectionRest = 0.25;           // of a pause, before a correction
constexpr double kOverlap = 0.8;                   // of an image's width, from pass to pass of a faultless sweep
constexpr double kMargin_mm = 8.0;                 // beyond both ends of a structure

}  // namespace

int TraineeHand::countAbout(double mean) {
  // Poisson by waiting times (Knuth): a few draws for the small means of habits.
  int count = 0;
  if (mean <= 0.0) return count;
  const double end = std::exp(-std::min(mean, 20.0));
  for (double left = random_.unit(); left > end; left *= random_.unit()) ++count;
  return count;
}

void TraineeHand::think() {
  if (habits_.thinking_s > 0.0) plan_.rest(habits_.thinking_s * std::exp(error(0.35)));
}

void TraineeHand::pause(double factor) {
  if (habits_.pause_s > 0.0) plan_.rest(-factor * habits_.pause_s * std::log(1.0 - 0.99 * random_.unit()));
}

Hold TraineeHand::beside(const Hold& target, double deviation_mm, double deviation_deg) {
  Hold hold = target;
  if (deviation_mm > 0.0) {
    const double x_mm = error(deviation_mm);
    hold = slid(hold, skin_, x_mm, error(deviation_mm));
  }
  if (deviation_deg > 0.0) {
    const double deviation_rad = glm::radians(deviation_deg);
    const double rotation = error(deviation_rad), rock = error(deviation_rad);
    hold = turned(hold, rotation, rock, error(deviation_rad));
  }
  return hold;
}

Hold TraineeHand::pressed(const Hold& target) {
  if (habits_.press <= 0.0) return target;
  Hold hold = pressedOn(poseOf(target), skin_, probe_);
  hold.press_mm += (habits_.press - 1.0) * usualPress_mm(probe_) + error(habits_.pressError_mm);
  hold.press_mm = std::clamp(hold.press_mm, 0.0, kMaxPress_mm);
  return hold;
}

Hold TraineeHand::missed(const Hold& target, const Route& way, bool isFirst) {
  const double overshoot = isFirst ? habits_.overshoot : 0.0;
  if (overshoot == 0.0 && habits_.scatter == 0.0) return target;
  const glm::dmat3 upright(uprightPoseOf(target).probeToWorld.matrix);
  const glm::dvec3 whole_mm = target.contact.point_mm - plan_.now().contact.point_mm;
  const glm::dvec2 along_mm(glm::dot(whole_mm, upright[0]), glm::dot(whole_mm, upright[2]));
  const double far = overshoot + error(habits_.scatter), aside = 0.5 * error(habits_.scatter);
  Hold end = slid(target, skin_, far * along_mm.x - aside * along_mm.y, far * along_mm.y + aside * along_mm.x);
  const glm::dvec3 turn = way.turn_rad();
  const double angle = glm::length(turn), turnedFar = overshoot + error(habits_.scatter);
  glm::dvec3 extra = turnedFar * turn;
  for (int axis = 0; axis < 3; ++axis) extra[axis] += 0.5 * angle * error(habits_.scatter);
  return turned(end, extra.y, extra.z, extra.x);
}

void TraineeHand::move(const Hold& to, double slowest_mmPerS) {
  auto way = std::make_shared<const Route>(plan_.now(), to, skin_);
  const double speed_mmPerS = slowest_mmPerS > 0.0 ? slowest_mmPerS : habits_.slide_mmPerS;
  double seconds = std::max(
      {habits_.shortestMove_s, way->length_mm() / speed_mmPerS, glm::degrees(glm::length(way->turn_rad())) / habits_.turn_degPerS});
  if (habits_.pace > 0.0) seconds *= std::exp(error(habits_.pace));
  plan_.move(std::move(way), to, seconds);
}

void TraineeHand::reach(const Hold& target) {
  for (int n = 0; n < kMostMovements; ++n) {
    const Route way(plan_.now(), target, skin_);
    if (way.length_mm() < kNear_mm && glm::degrees(glm::length(way.turn_rad())) < kNear_deg && (n > 0 || plan_.now() == target)) return;
    if (n > 0) pause(kCorrectionRest);
    move(missed(target, way, n == 0));
  }
}

void TraineeHand::setOutWrongly(const Hold& target) {
  const glm::dmat3 upright(uprightPoseOf(plan_.now()).probeToWorld.matrix);
  const glm::dvec3 whole_mm = target.contact.point_mm - plan_.now().contact.point_mm;
  const glm::dvec2 along_mm(glm::dot(whole_mm, upright[0]), glm::dot(whole_mm, upright[2]));
  const double length_mm = std::max(glm::length(along_mm), 1.0);
  const double back_mm = std::min(std::max(0.4 * length_mm, habits_.searchReach_mm), 60.0);
  const glm::dvec2 wrong_mm = -back_mm / length_mm * along_mm;
  move(beside(slid(plan_.now(), skin_, wrong_mm.x, wrong_mm.y), 0.3 * back_mm, habits_.searchTurn_deg));
  pause();
}

void TraineeHand::find(const Hold& target) {
  if (happens(habits_.wrongWay)) setOutWrongly(target);
  for (int looks = countAbout(habits_.searches); looks > 0; --looks) {
    reach(beside(target, habits_.searchReach_mm, habits_.searchTurn_deg));
    pause();
  }
  reach(beside(target, habits_.planeError_mm, habits_.planeError_deg));
}

void TraineeHand::pass(const Hold& from, const Hold& to) {
  reach(from);
  for (int stops = countAbout(habits_.interruptions); stops > 0; --stops) {
    // Somewhere on what is left of the way, and a little back.
    const Route way(plan_.now(), to, skin_);
    const Pose there = way.at(random_.between(0.2, 0.8), skin_);
    Hold stop = holdFor(there, skin_);
    stop.press_mm = to.press_mm;
    move(stop, habits_.sweep_mmPerS);
    pause();
    move(slid(stop, skin_, 0.0, error(0.3 * habits_.searchReach_mm)), habits_.sweep_mmPerS);
  }
  move(to, habits_.sweep_mmPerS);
  pause(0.5);
}

void TraineeHand::sweepAlong(const Hold& middle, const TargetView& view, double halfWidth_mm) {
  const double kept = 0.5 * (1.0 - habits_.sweepShort);
  const double centre_mm = 0.5 * (view.front_mm + view.back_mm);
  const double half_mm = kept * (view.back_mm - view.front_mm) + (habits_.sweepShort > 0.0 ? 0.0 : kMargin_mm);
  const double width_mm = view.right_mm - view.left_mm;
  const double step_mm = 2.0 * halfWidth_mm * kOverlap * (1.0 + habits_.sweepGap);
  const int passes = std::clamp(static_cast<int>(std::ceil(width_mm / step_mm)), 1, 6);
  for (int n = 0; n < passes; ++n) {
    const double x_mm = view.left_mm + width_mm * (n + 0.5) / passes;
    const double side = n % 2 == 0 ? -1.0 : 1.0;
    pass(slid(middle, skin_, x_mm, centre_mm + side * half_mm), slid(middle, skin_, x_mm, centre_mm - side * half_mm));
  }
}

void TraineeHand::sweep(const TargetView& view, double halfWidth_mm) {
  const Hold middle = pressed(view.hold);
  find(middle);
  sweepAlong(middle, view, halfWidth_mm);
  if (happens(habits_.missedTarget)) return;  // one is taught to look at everything in two directions
  TargetView across = view;                   // the probe's lateral axis now points against its elevational one, that along its lateral one
  across.left_mm = -view.back_mm;
  across.right_mm = -view.front_mm;
  across.front_mm = view.left_mm;
  across.back_mm = view.right_mm;
  const Hold turnedRound = turned(middle, 0.5 * std::numbers::pi, 0.0, 0.0);
  reach(turnedRound);
  sweepAlong(turnedRound, across, halfWidth_mm);
}

void TraineeHand::lookThrough(const TargetView& view) {
  const double kept = 0.5 * (1.0 - habits_.sweepShort);
  const double half_mm = std::min(40.0, kept * (view.back_mm - view.front_mm));
  const double centre_mm = 0.5 * (view.front_mm + view.back_mm);
  const Hold middle = plan_.now();
  pass(slid(middle, skin_, 0.0, centre_mm - half_mm), slid(middle, skin_, 0.0, centre_mm + half_mm));
}

void TraineeHand::wanderUntil(double time_s) {
  const Hold home = plan_.now();
  while (plan_.end_s() < time_s) {
    const Hold there = beside(home, std::max(5.0, habits_.searchReach_mm), std::max(4.0, habits_.searchTurn_deg));
    move(there);
    plan_.rest(std::min(1.0 + habits_.pause_s, std::max(0.0, time_s - plan_.end_s())));
  }
}

}  // namespace ew::assessment
