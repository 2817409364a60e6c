#pragma once

#include <map>
#include <optional>
#include <vector>

#include "ew/controls/binding.h"

namespace ew::controls {

struct Learned {
  ControlId control;
  Encoding encoding = Encoding::absolute;
  bool operator==(const Learned&) const = default;
};

/// Finds which control is being moved, and how it says so, from a few of its events. A knob that stands somewhere sends ever new values; an
/// encoder sends the same small steps again. Steps to one side alone may mean two things: then it asks to be turned back.
class Learner {
 public:
  enum class Needs { move, moveOn, turnBack, knobInsteadOfButton };

  explicit Learner(Target::Kind wanted) : wanted_(wanted) {}

  void take(const ControlEvent& event);
  [[nodiscard]] const std::optional<Learned>& found() const { return found_; }
  [[nodiscard]] Needs needs() const { return needs_; }

 private:
  void judge(const ControlId& id);
  [[nodiscard]] bool standsAlone(const ControlId& byte, Encoding encoding) const;
  void judgeAction(const ControlEvent& event, int before);

  Target::Kind wanted_;
  std::map<ControlId, std::vector<int>> values_;
  std::optional<Learned> found_;
  Needs needs_ = Needs::move;
};

/// What values of one control, in their order, were sent as.
struct Judged {
  enum class State { tooFew, ambiguous, button, noise, known };
  State state = State::tooFew;
  Encoding encoding = Encoding::absolute;
  bool operator==(const Judged&) const = default;
};
[[nodiscard]] Judged judged(ControlKind kind, const std::vector<int>& values);

}  // namespace ew::controls
