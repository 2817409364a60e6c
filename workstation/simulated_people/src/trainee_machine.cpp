#include "trainee_machine.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/step_work.h"

namespace ew::assessment {
namespace {

constexpr std::size_t kDepth = 0, kGain = 1, kRange = 2, kFocus = 3;
constexpr double kNearlyRight = 0.1, kNearlyRight_db = 2.0;

bool isLevel(std::size_t setting) { return setting == kGain || setting == kRange; }

double errorOf(const TraineeHabits& habits, std::size_t setting) {
  return setting == kDepth   ? habits.depthError
         : setting == kGain  ? habits.gainError_db
         : setting == kRange ? habits.rangeError_db
                             : habits.focusError;
}

void write(Knobs& knobs, std::size_t setting, double value) {
  double& knob = setting == kDepth   ? knobs.depth_mm
                 : setting == kGain  ? knobs.gain_db
                 : setting == kRange ? knobs.dynamicRange_db
                                     : knobs.focus_mm;
  knob = value;
}

}  // namespace

Machine machineOf(const ScanState& state) {
  Machine machine{};
  for (std::size_t n = 0; n < machine.size(); ++n) machine[n] = settingOf(state, std::string(kLessonSettings[n])).value_or(0.0);
  return machine;
}

Machine withBands(Machine wanted, const SettingsTask& task) {
  for (const SettingBand& band : task.bands)
    for (std::size_t n = 0; n < wanted.size(); ++n)
      if (band.setting == kLessonSettings[n]) wanted[n] = 0.5 * (band.lowest + band.highest);
  return wanted;
}

MachineChange setBy(const TraineeHabits& habits, RandomNumbers& random, const ScanState& now, const Machine& wanted, bool insists) {
  ScanState then = now;  // a focus that nobody set follows the depth
  MachineChange set;
  for (std::size_t n = 0; n < set.size(); ++n) {
    const double current = machineOf(then)[n];
    const bool isLeft = random.unit() < habits.settingLeft, isTooFar = random.unit() < habits.overcorrected;
    const double beside = errorOf(habits, n) * std::clamp(random.normal(), -2.5, 2.5);
    const double off = isLevel(n) ? std::abs(wanted[n] - current) / kNearlyRight_db
                                  : std::abs(std::log(std::max(wanted[n], 1.0) / std::max(current, 1.0))) / kNearlyRight;
    if (isLeft || (off <= 1.0 && !insists)) continue;
    const double aimed = isTooFar ? current + 2.0 * (wanted[n] - current) : wanted[n];
    double value = isLevel(n) ? aimed + beside : std::max(aimed, 1.0) * std::exp(beside);
    if (beside != 0.0) value = isLevel(n) ? std::round(value) : 5.0 * std::round(value / 5.0);  // knobs click
    if (n == kDepth) value = std::clamp(value, now.probe.minDepth_mm, now.probe.maxDepth_mm);
    if (n == kFocus) value = std::clamp(value, 5.0, machineOf(then)[kDepth]);
    set[n] = value;
    write(then.knobs, n, value);
  }
  return set;
}

double turnKnobs(const ScanState& now, const MachineChange& to, double from_s, HandPlan& plan) {
  constexpr int kClicks = 4;
  constexpr double kClick_s = 0.25, kNext_s = 0.8;
  ScanState then = now;
  double time_s = from_s;
  for (std::size_t n = 0; n < to.size(); ++n) {
    const double from = machineOf(then)[n];
    if (!to[n] || *to[n] == from) continue;
    for (int click = 1; click <= kClicks; ++click, time_s += kClick_s) {
      write(then.knobs, n, click == kClicks ? *to[n] : std::lerp(from, *to[n], static_cast<double>(click) / kClicks));
      then.knobs = limited(then.knobs);
      plan.set(time_s, now.probe, then.knobs);
    }
    time_s += kNext_s;
  }
  return time_s;
}

const Probe& chosenProbe(const TraineeHabits& habits, RandomNumbers& random, const std::vector<Probe>& offered,
                         const std::vector<std::string>& asked, const Probe& now) {
  const auto isAsked = [&](const Probe& probe) { return std::find(asked.begin(), asked.end(), probe.id) != asked.end(); };
  std::vector<const Probe*> right, wrong;
  for (const Probe& probe : offered) (isAsked(probe) ? right : wrong).push_back(&probe);
  const bool isWrong = random.unit() < habits.wrongProbe;
  const double which = random.unit();
  const auto& among = (isWrong && !wrong.empty()) || right.empty() ? wrong : right;
  if (&among == &right && isAsked(now)) return now;
  return *among[std::min(among.size() - 1, static_cast<std::size_t>(which * static_cast<double>(among.size())))];
}

}  // namespace ew::assessment
