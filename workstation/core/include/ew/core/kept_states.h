#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ew {

/// Whether a change is a step of its own, or goes on with the last one: a drag is many moves and one step back.
enum class Change { begins, goesOn };

/// A value with undo and redo. Every state is a whole, unchanging value, so that whoever shows one keeps it and nothing has to be taken
/// back piece by piece. Not for several threads at once; the states are.
template <class Value>
class KeptStates {
 public:
  static constexpr std::size_t kMost = 1000;  ///< steps back; older ones are forgotten

  explicit KeptStates(Value first = {}) : states_{std::make_shared<const Value>(std::move(first))} {}

  [[nodiscard]] const Value& now() const { return *states_[at_]; }
  /// The same, to be kept: it stays as it is whatever happens here.
  [[nodiscard]] std::shared_ptr<const Value> kept() const { return states_[at_]; }

  /// Takes away what could be done again.
  void step(Value next, Change change = Change::begins) {
    states_.resize(at_ + 1);
    auto state = std::make_shared<const Value>(std::move(next));
    if (change == Change::goesOn && at_ > 0) {
      states_[at_] = std::move(state);
      return;
    }
    states_.push_back(std::move(state));
    if (states_.size() > kMost) states_.erase(states_.begin());
    at_ = states_.size() - 1;
  }

  [[nodiscard]] bool canUndo() const { return at_ > 0; }
  [[nodiscard]] bool canRedo() const { return at_ + 1 < states_.size(); }
  bool undo() {
    if (!canUndo()) return false;
    --at_;
    return true;
  }
  bool redo() {
    if (!canRedo()) return false;
    ++at_;
    return true;
  }

 private:
  std::vector<std::shared_ptr<const Value>> states_;
  std::size_t at_ = 0;
};

}  // namespace ew
