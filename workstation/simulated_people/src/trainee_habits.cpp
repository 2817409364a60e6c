#include "ew/simulated_people/trainee_habits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/assessment/random_numbers.h"
#include "ew/core/word_table.h"

namespace ew {
namespace {

using assessment::RandomNumbers;
using H = TraineeHabits;

constexpr double kLeastProbability = 1e-3;  // that log odds are taken of

constexpr std::array kRanges = {
    HabitRange{"slide_mmPerS", &H::slide_mmPerS, 26.0, 38.0, 0.30, false, false},
    HabitRange{"turn_degPerS", &H::turn_degPerS, 20.0, 28.0, 0.30, false, false},
    HabitRange{"shortestMove_s", &H::shortestMove_s, 0.5, 0.4, 0.15, false, true},
    HabitRange{"pace", &H::pace, 0.25, 0.15, 0.30, false, true},
    HabitRange{"overshoot", &H::overshoot, 0.12, 0.06, 0.50, false, true},
    HabitRange{"scatter", &H::scatter, 0.15, 0.08, 0.30, false, true},
    HabitRange{"wobble_s", &H::wobble_s, 0.020, 0.013, 0.40, false, true},
    HabitRange{"tremor_mm", &H::tremor_mm, 0.10, 0.08, 0.40, false, true},
    HabitRange{"tremor_deg", &H::tremor_deg, 0.12, 0.10, 0.40, false, true},
    HabitRange{"wrongWay", &H::wrongWay, 0.30, 0.08, 0.80, true, true},
    HabitRange{"searches", &H::searches, 2.0, 0.8, 0.50, false, true},
    HabitRange{"searchReach_mm", &H::searchReach_mm, 18.0, 12.0, 0.40, false, true},
    HabitRange{"searchTurn_deg", &H::searchTurn_deg, 16.0, 11.0, 0.40, false, true},
    HabitRange{"pause_s", &H::pause_s, 1.4, 0.8, 0.40, false, true},
    HabitRange{"planeError_mm", &H::planeError_mm, 5.0, 2.8, 0.40, false, true},
    HabitRange{"planeError_deg", &H::planeError_deg, 6.5, 3.8, 0.40, false, true},
    HabitRange{"press", &H::press, 1.0, 1.0, 0.10, false, true},
    HabitRange{"pressError_mm", &H::pressError_mm, 1.2, 0.8, 0.40, false, true},
    HabitRange{"pressDrift_mm", &H::pressDrift_mm, 0.9, 0.6, 0.40, false, true},
    HabitRange{"contactLoss", &H::contactLoss, 0.04, 0.015, 0.70, true, true},
    HabitRange{"settingLeft", &H::settingLeft, 0.50, 0.15, 0.80, true, true},
    HabitRange{"overcorrected", &H::overcorrected, 0.20, 0.08, 0.80, true, true},
    HabitRange{"depthError", &H::depthError, 0.16, 0.08, 0.40, false, true},
    HabitRange{"gainError_db", &H::gainError_db, 4.0, 2.2, 0.40, false, true},
    HabitRange{"focusError", &H::focusError, 0.35, 0.22, 0.40, false, true},
    HabitRange{"rangeError_db", &H::rangeError_db, 6.0, 5.0, 0.40, false, true},
    HabitRange{"wrongProbe", &H::wrongProbe, 0.20, 0.05, 0.80, true, true},
    HabitRange{"wrongAnswer", &H::wrongAnswer, 0.40, 0.12, 0.80, true, true},
    HabitRange{"numberError", &H::numberError, 0.40, 0.30, 0.40, false, true},
    HabitRange{"mistaken", &H::mistaken, 0.18, 0.04, 0.80, true, true},
    HabitRange{"pointError_mm", &H::pointError_mm, 2.2, 1.5, 0.40, false, true},
    HabitRange{"caliperError_mm", &H::caliperError_mm, 1.6, 0.9, 0.40, false, true},
    HabitRange{"missedTarget", &H::missedTarget, 0.30, 0.08, 0.80, true, true},
    HabitRange{"sweep_mmPerS", &H::sweep_mmPerS, 28.0, 25.0, 0.30, false, true},
    HabitRange{"sweepGap", &H::sweepGap, 0.25, 0.08, 0.50, false, true},
    HabitRange{"sweepShort", &H::sweepShort, 0.20, 0.08, 0.60, true, true},
    HabitRange{"interruptions", &H::interruptions, 1.5, 0.6, 0.50, false, true},
    HabitRange{"thinking_s", &H::thinking_s, 6.0, 4.0, 0.40, false, true},
    HabitRange{"hints", &H::hints, 0.5, 0.15, 0.80, false, true},
};

/// To the scale that habits vary on, and back.
double scaled(const HabitRange& habit, double value) {
  if (!habit.isProbability) return std::log(value);
  const double p = std::clamp(value, kLeastProbability, 1.0 - kLeastProbability);
  return std::log(p / (1.0 - p));
}
double unscaled(const HabitRange& habit, double scale) { return habit.isProbability ? 1.0 / (1.0 + std::exp(-scale)) : std::exp(scale); }

void limit(TraineeHabits& habits) {
  habits.contactLoss = std::min(habits.contactLoss, 0.5);
  habits.sweepShort = std::min(habits.sweepShort, 0.9);
}

constexpr WordTable<SkillLevel, 3> kSkillLevelWords{
    {{"novice", SkillLevel::novice}, {"intermediate", SkillLevel::intermediate}, {"expert", SkillLevel::expert}}};

}  // namespace

std::string_view wordOf(SkillLevel level) { return wordIn(kSkillLevelWords, level); }

std::span<const HabitRange> habitRanges() { return kRanges; }

TraineeHabits habitsOf(SkillLevel level) {
  TraineeHabits habits;
  const double share = level == SkillLevel::novice ? 0.0 : level == SkillLevel::expert ? 1.0 : kIntermediateShare;
  for (const HabitRange& each : kRanges)
    habits.*each.member = unscaled(each, std::lerp(scaled(each, each.novice), scaled(each, each.expert), share));
  return habits;
}

TraineeHabits personOf(SkillLevel level, std::uint64_t seed) {
  TraineeHabits habits = habitsOf(level);
  RandomNumbers random(seed);
  const double talent = random.normal();  // below 0: better than the level
  for (const HabitRange& each : kRanges) {
    const double own = std::sqrt(kPersonCorrelation) * talent + std::sqrt(1.0 - kPersonCorrelation) * random.normal();
    const double worse = each.moreIsWorse ? own : -own;
    habits.*each.member = unscaled(each, scaled(each, habits.*each.member) + each.personSpread * worse);
  }
  limit(habits);
  return habits;
}

TraineeHabits onOneDay(const TraineeHabits& person, std::uint64_t seed) {
  TraineeHabits habits = person;
  RandomNumbers random(seed);
  for (const HabitRange& each : kRanges) {
    const double luck = kAttemptSpread * random.normal();
    if (habits.*each.member > 0.0) habits.*each.member = unscaled(each, scaled(each, habits.*each.member) + luck);
  }
  limit(habits);
  return habits;
}

}  // namespace ew
