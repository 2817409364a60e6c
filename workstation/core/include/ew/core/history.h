#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/contract.h"

namespace ew {

/// Whether a change is a step of its own, or goes on with the last one: a drag is many moves and one step back.
enum class Change { begins, goesOn };

/// A value with undo and redo. Every state is a whole, unchanging value, so that whoever shows one keeps it and nothing has to be taken
/// back piece by piece. Steps may have names, and keys by which steps in a row become one. Where a whole state would be too large, a value
/// says what its step changed, and whoever holds the state applies it (labelling/label_edits.h). Not for several threads at once; the
/// states are.
template <class Value>
class History {
 public:
  static constexpr std::size_t kMost = 1000;

  /// @param most states, >= 2; older ones are forgotten
  explicit History(Value first = {}, std::size_t most = kMost)
      : states_{State{std::make_shared<const Value>(std::move(first)), {}}}, most_(most) {}

  [[nodiscard]] const Value& now() const { return *states_[at_].value; }
  /// The same, to be kept: it stays as it is whatever happens here.
  [[nodiscard]] std::shared_ptr<const Value> kept() const { return states_[at_].value; }

  /// Takes away what could be done again.
  void step(Value next, Change change = Change::begins) { put(std::move(next), {}, change == Change::goesOn && at_ > 0); }
  /// A step with a name. After one with the same key, which is not empty, it goes on with it, and its name counts.
  void step(Value next, std::string name, std::string mergeKey) {
    const bool goesOn = canMerge(mergeKey);
    put(std::move(next), std::move(name), goesOn);
    mergeKey_ = std::move(mergeKey);
  }
  /// The value before the step that one with this key would go on with; null: it would be a step of its own.
  [[nodiscard]] const Value* beforeMerging(const std::string& mergeKey) const {
    return canMerge(mergeKey) ? states_[at_ - 1].value.get() : nullptr;
  }
  /// The last step never was: undone, and nothing to be done again. There is one.
  void forgetStep() {
    EW_EXPECTS(canUndo());
    undo();
    states_.resize(at_ + 1);
  }
  /// The next step is one of its own, whatever its key: a hand has let go.
  void endMerging() { mergeKey_.clear(); }

  [[nodiscard]] bool canUndo() const { return at_ > 0; }
  [[nodiscard]] bool canRedo() const { return at_ + 1 < states_.size(); }
  [[nodiscard]] std::string undoName() const { return canUndo() ? states_[at_].name : std::string(); }  ///< empty: no step, or no name
  [[nodiscard]] std::string redoName() const { return canRedo() ? states_[at_ + 1].name : std::string(); }
  /// Since the first value, so far as they were not undone.
  [[nodiscard]] std::size_t steps() const { return forgotten_ + at_; }
  [[nodiscard]] std::size_t forgotten() const { return forgotten_; }  ///< of steps(): cannot be undone any more
  bool undo() {
    endMerging();
    if (!canUndo()) return false;
    --at_;
    return true;
  }
  bool redo() {
    endMerging();
    if (!canRedo()) return false;
    ++at_;
    return true;
  }

  /// Whether any state, also one that was taken back, is so.
  template <class Predicate>
  [[nodiscard]] bool wasEver(const Predicate& isSo) const {
    return std::any_of(states_.begin(), states_.end(), [&](const State& state) { return isSo(*state.value); });
  }

  /// What the values behind the oldest add up to, also of those that were taken back.
  template <class Cost>
  [[nodiscard]] std::size_t cost(const Cost& costOf) const {
    std::size_t all = 0;
    for (std::size_t n = 1; n < states_.size(); ++n) all += costOf(*states_[n].value);
    return all;
  }
  /// Forgets the oldest until those behind it cost no more; the latest step stays.
  template <class Cost>
  void forgetBeyond(std::size_t most, const Cost& costOf) {
    for (std::size_t left = cost(costOf); left > most && at_ > 1; forgetOldest()) left -= costOf(*states_[1].value);
  }

 private:
  struct State {
    std::shared_ptr<const Value> value;
    std::string name;  ///< of the step that led to it
  };
  [[nodiscard]] bool canMerge(const std::string& mergeKey) const { return !mergeKey.empty() && mergeKey == mergeKey_ && at_ > 0; }
  void put(Value next, std::string name, bool inPlace) {
    endMerging();
    states_.resize(at_ + 1);
    State state{std::make_shared<const Value>(std::move(next)), std::move(name)};
    if (inPlace) {
      states_[at_] = std::move(state);
      return;
    }
    states_.push_back(std::move(state));
    at_ = states_.size() - 1;
    if (states_.size() > most_) forgetOldest();
  }
  void forgetOldest() {
    states_.erase(states_.begin());
    --at_;
    ++forgotten_;
  }

  std::vector<State> states_;
  std::size_t most_;
  std::size_t at_ = 0;
  std::size_t forgotten_ = 0;
  std::string mergeKey_;
};

/// Numbered entries with undo and redo. Not for several threads at once; the states are.
/// @tparam List has the entries as `all`, each with its `number`, and the number of the next as `nextNumber`
template <class List>
class EntryHistory {
 public:
  explicit EntryHistory(List first = {}) : states_(std::move(first)) {}

  [[nodiscard]] const List& now() const { return states_.now(); }
  /// The same, to be kept: it stays as it is whatever happens here.
  [[nodiscard]] std::shared_ptr<const List> kept() const { return states_.kept(); }

  bool remove(int number) {
    List next = now();
    if (std::erase_if(next.all, [&](const auto& each) { return each.number == number; }) == 0) return false;
    states_.step(std::move(next));
    return true;
  }
  bool clear() {  ///< false when there is nothing
    if (now().all.empty()) return false;
    states_.step({{}, now().nextNumber});
    return true;
  }

  [[nodiscard]] bool canUndo() const { return states_.canUndo(); }
  [[nodiscard]] bool canRedo() const { return states_.canRedo(); }
  bool undo() { return states_.undo(); }
  bool redo() { return states_.redo(); }

 protected:
  /// A step in which `edit` changes the entry of that number. @return whether there is one and it did
  template <class Edit>
  bool edit(int number, Change change, Edit edit) {
    List next = now();
    const auto found = std::find_if(next.all.begin(), next.all.end(), [&](const auto& each) { return each.number == number; });
    if (found == next.all.end() || !edit(*found)) return false;
    states_.step(std::move(next), change);
    return true;
  }
  /// Adds an entry with the next number. @return its number
  template <class Entry>
  int add(Entry entry) {
    List next = now();
    entry.number = next.nextNumber++;
    const int number = entry.number;
    next.all.push_back(std::move(entry));
    states_.step(std::move(next));
    return number;
  }

 private:
  History<List> states_;
};

}  // namespace ew
