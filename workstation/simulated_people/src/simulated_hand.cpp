#include "ew/simulated_people/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/gtc/constants.hpp>

#include "ew/assessment/random_numbers.h"

namespace ew {
namespace {

using assessment::RandomNumbers;

constexpr double kSlowing_s = 0.5;  // a movement that has this long to go at full speed is slowed down, as people do

/// Towards the end slower, never faster than the hand can, and never beyond what was told.
double stepOf(double amount, double fastest, double step_s) {
  return std::min({amount, fastest * step_s, std::max(amount / kSlowing_s, 2.0) * step_s});
}

Hold slidAlong(const Hold& hold, const Skin& skin, const glm::dvec3& along, double by_mm) {
  const glm::dmat3 upright(uprightPoseOf(hold).probeToWorld.matrix);
  glm::dvec3 tangent = along - glm::dot(along, hold.contact.outward) * hold.contact.outward;
  if (glm::length(tangent) < 1e-6) return hold;
  tangent = by_mm * glm::normalize(tangent);
  return slid(hold, skin, glm::dot(tangent, upright[0]), glm::dot(tangent, upright[2]));
}

Hold moved(const Hold& hold, const Skin& skin, const CompassAdvice& advice, double gain, const SimulatedHand& hand) {
  const double amount = std::abs(advice.amount);
  const double by_mm = gain * stepOf(amount, hand.fastestSlide_mmPerS, hand.step_s);
  const double by_rad = glm::radians(gain * stepOf(amount, hand.fastestTurn_degPerS, hand.step_s));
  const auto signOf = [](double number) { return number < 0.0 ? -1.0 : 1.0; };
  switch (advice.movement) {
    case HandMovement::slide:
      return slidAlong(hold, skin, advice.along, by_mm);
    case HandMovement::rotate:
    case HandMovement::turnRound:
      return turned(hold, signOf(advice.amount) * by_rad, 0.0, 0.0);
    case HandMovement::tilt:
      return turned(hold, 0.0, 0.0, signOf(advice.signedAmount) * by_rad);
    case HandMovement::rock:
      return turned(hold, 0.0, signOf(advice.signedAmount) * by_rad, 0.0);
    case HandMovement::press: {
      Hold pressed = hold;
      pressed.press_mm = std::clamp(hold.press_mm + signOf(advice.amount) * by_mm, 0.0, kMaxPress_mm);
      return pressed;
    }
    case HandMovement::stay:
    case HandMovement::none:
      break;
  }
  return hold;
}

Hold trembling(const Hold& hold, const Skin& skin, RandomNumbers& random, const SimulatedHand& hand) {
  const double x_mm = hand.tremor_mm * random.normal();
  const double z_mm = hand.tremor_mm * random.normal();
  const double angle_rad = glm::radians(hand.tremor_deg);
  const double rotation = angle_rad * random.normal();
  const double rock = angle_rad * random.normal();
  const double tilt = angle_rad * random.normal();
  return turned(slid(hold, skin, x_mm, z_mm), rotation, rock, tilt);
}

bool isOther(const CompassAdvice& a, const CompassAdvice& b) {
  return a.movement != b.movement || (a.movement == HandMovement::slide && glm::dot(a.along, b.along) < 0.5) ||
         a.signedAmount * b.signedAmount < 0.0 || (a.movement == HandMovement::rotate && a.amount * b.amount < 0.0);
}

}  // namespace

HandRun followCompass(const CompassTarget& target, const Hold& start, const Skin& skin, std::uint64_t seed, const SimulatedHand& hand) {
  RandomNumbers random(seed);
  HandRun run;
  Hold meant = start;
  std::optional<CompassAdvice> last;
  std::optional<CompassAdvice> followed;
  std::deque<CompassAdvice> heard;  // not acted upon yet
  const auto delay = static_cast<std::size_t>(std::lround(hand.reactionTime_s / hand.step_s));
  double gain = 1.0;
  double still_s = 0.0;
  for (run.time_s = 0.0; run.time_s < hand.patience_s; run.time_s += hand.step_s) {
    run.end = trembling(meant, skin, random, hand);
    run.error = planeError(target.plane, poseOf(run.end).probeToWorld);
    CompassAdvice advice = nextMovement(target, run.end, last);
    if (last && isOther(*last, advice)) ++run.changesOfAdvice;
    last = advice;
    if (advice.movement == HandMovement::none) return run;
    still_s = advice.movement == HandMovement::stay && isFound(run.error, target.tolerance) && !run.error.isMirrored ? still_s + hand.step_s
                                                                                                                     : 0.0;
    if (still_s >= hand.stillFor_s) {
      run.reached = true;
      return run;
    }
    heard.push_back(std::move(advice));
    if (heard.size() <= delay) continue;
    const CompassAdvice& now = heard.front();
    if (!followed || isOther(*followed, now)) gain = std::max(0.2, 1.0 + hand.executionError * random.normal());
    meant = moved(meant, skin, now, gain, hand);
    followed = now;
    heard.pop_front();
  }
  return run;
}

}  // namespace ew
