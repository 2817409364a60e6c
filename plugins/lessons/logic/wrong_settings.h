#pragma once

#include <string>
#include <vector>

#include "ew/library/lesson.h"
#include "ew/scanning/state.h"

namespace ew::lessons {

/// How the machine stands when a step begins in which it is to be set.
struct WrongSettings {
  std::string probe;  ///< id; the present one where none is wrong
  Knobs knobs;
  bool operator==(const WrongSettings&) const = default;
};

/// Settings of which none is right, as near to the present ones as that allows: what is wrong already stays, a probe is another one that
/// the case offers, and each band is missed by a third of the room between it and the limit that is further away.
/// @param state as the machine stands @param offered probes of the case
[[nodiscard]] WrongSettings wrongSettings(const SettingsTask& task, const ScanState& state, const std::vector<Probe>& offered);

}  // namespace ew::lessons
