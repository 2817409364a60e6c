#pragma once

#include <optional>
#include <string>

#include "ew/controls/event.h"

namespace ew::controls {

/// How the values of a control say what was done to it.
enum class Encoding {
  absolute,        ///< where it stands, from 0 to the highest value
  twosComplement,  ///< steps: 1, 2, ... to the right; 127, 126, ... to the left
  offset64,        ///< steps: 65, 66, ... to the right; 63, 62, ... to the left
  signBit,         ///< steps: 1, 2, ... to the right; 65, 66, ... to the left
  counter,         ///< counts steps around its whole range, as the wheel of a jog dial does
  button           ///< pressed from half of the range on
};

/// What a control does.
struct Target {
  enum class Kind { setting, action };
  Kind kind = Kind::setting;
  std::string id;                                   ///< of the setting ("gain") or of the action ("freeze")
  auto operator<=>(const Target&) const = default;  // NOLINT(modernize-use-nullptr): the 0 is the compiler's own
};

/// A control, how it is read, and what it does.
struct Binding {
  ControlId control;
  Encoding encoding = Encoding::absolute;
  Target target;
  bool reversed = false;  ///< right is less
  bool operator==(const Binding&) const = default;
};

/// Whether such a control can send values of that kind: a counter and a button need no knob.
[[nodiscard]] bool fits(Encoding encoding, ControlKind kind);

/// What is to be done after an event.
struct Motion {
  enum class Kind {
    none,
    to,     ///< the setting to `value`, 0..1 of its range
    by,     ///< the setting by `value` steps
    press,  ///< the action
    wait    ///< the knob does not stand where the setting does; `value` (0..1) says where the knob is
  };
  Kind kind = Kind::none;
  double value = 0.0;
  bool operator==(const Motion&) const = default;
};

/// Follows one control. A knob that says where it stands takes over softly: it moves the setting only once it has come to it or passed it,
/// so that nothing jumps.
class Follower {
 public:
  /// @param present where the setting stands, 0..1 of its range; empty: it has no range (the pose of the probe), and a knob moves it by as
  ///        much as it was turned, kStepsOfRange steps from end to end
  [[nodiscard]] Motion take(const Binding& binding, int value, std::optional<double> present);
  /// Where the setting went: a range of its own may round.
  void settle(double present) { left_ = present; }

  static constexpr int kStepsOfRange = 128;

 private:
  [[nodiscard]] Motion toward(double knob, double present);

  std::optional<int> lastValue_;
  std::optional<double> knob_;  ///< where it stood
  std::optional<double> left_;  ///< where this knob left the setting; empty: it has not taken over
};

}  // namespace ew::controls
