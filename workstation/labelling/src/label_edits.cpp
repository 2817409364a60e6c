#include "ew/labelling/label_edits.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ew::labelling {
namespace {

/// Differences of a box as runs of (value, length 1 to 255).
template <class At>
std::vector<std::uint8_t> runsOf(const VoxelBox& box, const At& differenceAt, bool& isSame) {
  std::vector<std::uint8_t> runs;
  isSame = true;
  for (int k = box.first.z; k < box.end.z; ++k)
    for (int j = box.first.y; j < box.end.y; ++j)
      for (int i = box.first.x; i < box.end.x; ++i) {
        const std::uint8_t value = differenceAt(i, j, k);
        if (value != 0) isSame = false;
        if (!runs.empty() && runs[runs.size() - 2] == value && runs.back() < 255) {
          ++runs.back();
        } else {
          runs.push_back(value);
          runs.push_back(1);
        }
      }
  return runs;
}

}  // namespace

LabelEdits::LabelEdits(Volume labels, std::size_t mostBytes)
    : labels_(std::move(labels)), before_(labels_.echo), steps_({}, std::numeric_limits<std::size_t>::max()), mostBytes_(mostBytes) {}

void LabelEdits::edit(const std::string& what, const std::function<VoxelBox(Volume&)>& change) {
  const bool isAlone = !isOpen_;
  if (isAlone) open(what);
  openBox_ = joined(openBox_, change(labels_));
  if (isAlone) close();
}

void LabelEdits::open(const std::string& what) {
  close();
  isOpen_ = true;
  openWhat_ = what;
  openBox_ = {};
}

void LabelEdits::close() {
  if (!std::exchange(isOpen_, false)) return;
  const Grid& grid = labels_.grid;
  bool isSame = true;
  Step step{openBox_, {}};
  step.runs = runsOf(
      step.box,
      [&](int i, int j, int k) {
        const std::size_t at = grid.indexOf(i, j, k);
        return static_cast<std::uint8_t>(labels_.echo[at] ^ before_[at]);
      },
      isSame);
  if (isSame) return;
  step.runs.shrink_to_fit();
  for (int k = step.box.first.z; k < step.box.end.z; ++k)
    for (int j = step.box.first.y; j < step.box.end.y; ++j) {
      const auto first = static_cast<std::ptrdiff_t>(grid.indexOf(step.box.first.x, j, k));
      std::copy_n(labels_.echo.begin() + first, step.box.end.x - step.box.first.x, before_.begin() + first);
    }
  steps_.step(std::move(step), std::move(openWhat_), {});
  steps_.forgetBeyond(mostBytes_, bytesOf);
}

void LabelEdits::toggle(const Step& step) {
  const Grid& grid = labels_.grid;
  const glm::ivec3 size = step.box.end - step.box.first;
  std::size_t n = 0;
  for (std::size_t run = 0; run < step.runs.size(); run += 2) {
    const std::uint8_t difference = step.runs[run];
    for (int left = step.runs[run + 1]; left > 0; --left, ++n) {
      if (difference == 0) continue;
      const int within = static_cast<int>(n);
      const std::size_t at = grid.indexOf(step.box.first.x + within % size.x, step.box.first.y + within / size.x % size.y,
                                          step.box.first.z + within / size.x / size.y);
      before_[at] = labels_.echo[at] ^= difference;
    }
  }
}

void LabelEdits::undo() {
  close();
  const auto step = steps_.kept();
  if (steps_.undo()) toggle(*step);
}

void LabelEdits::redo() {
  close();
  if (steps_.redo()) toggle(steps_.now());
}

}  // namespace ew::labelling
