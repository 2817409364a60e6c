#pragma once

#include <functional>
#include <string>

#include "ew/core/history.h"
#include "ew/labelling/labels.h"

namespace ew::labelling {

/// A label volume that is edited step by step, with undo. A step keeps what it changed: the differences in the box it touched, run by run,
/// a few hundred bytes for a stroke. Beside the labels a copy of them as they were at the last step is held.
class LabelEdits {
 public:
  /// @param mostBytes that steps may hold; the oldest are forgotten beyond it (at least the latest stays)
  explicit LabelEdits(Volume labels, std::size_t mostBytes = std::size_t{64} << 20);

  [[nodiscard]] const Volume& labels() const { return labels_; }

  /// Changes labels within a step named `what`: the one that is open, or a step of its own.
  /// @param change returns the box outside of which nothing changed
  void edit(const std::string& what, const std::function<VoxelBox(Volume&)>& change);
  /// Edits until close() are one step: a stroke with the button held. A step that changed nothing is none.
  void open(const std::string& what);
  void close();

  void undo();
  void redo();
  [[nodiscard]] std::string undoText() const { return steps_.undoName(); }  ///< of the latest step; empty: nothing to undo
  [[nodiscard]] std::string redoText() const { return steps_.redoName(); }
  /// Steps since the labels were given, so far as they were not undone.
  [[nodiscard]] std::size_t steps() const { return steps_.steps(); }
  [[nodiscard]] std::size_t forgotten() const { return steps_.forgotten(); }
  [[nodiscard]] std::size_t bytes() const { return steps_.cost(bytesOf); }

 private:
  struct Step {
    VoxelBox box;
    std::vector<std::uint8_t> runs;  ///< (difference, length) of the box's voxels in memory's order
  };
  static std::size_t bytesOf(const Step& step) { return step.runs.size(); }
  void toggle(const Step& step);

  Volume labels_;
  std::vector<std::uint8_t> before_;  ///< as they were at the latest step
  History<Step> steps_;               ///< each as what it changed; the first is none
  std::size_t mostBytes_;
  bool isOpen_ = false;
  std::string openWhat_;
  VoxelBox openBox_;
};

}  // namespace ew::labelling
