#pragma once

#include <deque>
#include <functional>
#include <string>

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
  [[nodiscard]] std::string undoText() const;  ///< of the latest step; empty: nothing to undo
  [[nodiscard]] std::string redoText() const;
  /// Steps since the labels were given, so far as they were not undone.
  [[nodiscard]] std::size_t steps() const { return forgotten_ + done_.size(); }
  [[nodiscard]] std::size_t forgotten() const { return forgotten_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Step {
    std::string what;
    VoxelBox box;
    std::vector<std::uint8_t> runs;  ///< (difference, length) of the box's voxels in memory's order
  };
  void toggle(const Step& step);
  void forgetOldest();

  Volume labels_;
  std::vector<std::uint8_t> before_;  ///< as they were at the latest step
  std::deque<Step> done_;
  std::vector<Step> undone_;
  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::size_t forgotten_ = 0;
  bool isOpen_ = false;
  std::string openWhat_;
  VoxelBox openBox_;
};

}  // namespace ew::labelling
