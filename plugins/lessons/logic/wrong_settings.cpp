#include "logic/wrong_settings.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/step_work.h"
#include "ew/imaging/display.h"

namespace ew::lessons {
namespace {

struct SettingRange {
  double lowest = 0.0, highest = 0.0;
};

/// Between which values the console sets it.
SettingRange rangeOf(const std::string& setting, const ScanState& state) {
  if (setting == "depth_mm") return {state.probe.minDepth_mm, state.probe.maxDepth_mm};
  if (setting == "gain_db") return {-30.0, 30.0};
  if (setting == "dynamic_range_db") return {20.0, 120.0};
  return {1.0, resolvedDepth_mm(state.probe, state.knobs)};
}

double* knobOf(const std::string& setting, Knobs& knobs) {
  if (setting == "depth_mm") return &knobs.depth_mm;
  if (setting == "gain_db") return &knobs.gain_db;
  if (setting == "dynamic_range_db") return &knobs.dynamicRange_db;
  return setting == "focus_mm" ? &knobs.focus_mm : nullptr;
}

double missing(const SettingBand& band, const SettingRange& range) {
  const double below = band.lowest - range.lowest, above = range.highest - band.highest;
  return below >= above ? std::floor(band.lowest - below / 3.0) : std::ceil(band.highest + above / 3.0);
}

}  // namespace

WrongSettings wrongSettings(const SettingsTask& task, const ScanState& state, const std::vector<Probe>& offered) {
  ScanState wrong = state;
  const auto isRight = [&](const Probe& probe) { return std::find(task.probes.begin(), task.probes.end(), probe.id) != task.probes.end(); };
  const auto other = std::find_if_not(offered.begin(), offered.end(), isRight);
  if (isRight(state.probe) && other != offered.end()) wrong.probe = *other;
  for (const SettingBand& band : task.bands) {
    double* knob = knobOf(band.setting, wrong.knobs);
    const auto value = settingOf(wrong, band.setting);
    if (knob == nullptr || !value || *value < band.lowest || *value > band.highest) continue;
    *knob = missing(band, rangeOf(band.setting, wrong));
  }
  return {wrong.probe.id, wrong.knobs};
}

}  // namespace ew::lessons
