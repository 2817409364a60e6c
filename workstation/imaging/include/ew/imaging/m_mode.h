#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/core/image.h"

namespace ew {

/// One beam over time: a strip whose columns are moments and whose rows are depths. New columns overwrite the oldest at a running cursor,
/// as on a machine. Allocates in configure alone.
class MModeStrip {
 public:
  /// @param width  columns of the strip, @param height rows, @param sweep_s time across it. A change clears the strip.
  void configure(int width, int height, double sweep_s);
  /// The beam as it is at `time_s`. Columns passed since the last call are filled by interpolating between the last beam and this one; time
  /// that stands still or runs backwards draws nothing; a jump of more than a sweep starts afresh.
  /// @param beam values from the face down, 0..255; resampled to the strip's height
  void add(double time_s, std::span<const std::uint8_t> beam);
  void clear();
  [[nodiscard]] ImageView<const std::uint8_t> picture() const;
  /// Column that is written next; a few columns ahead of it are black, so that the seam is seen.
  [[nodiscard]] int cursor() const { return cursor_; }

 private:
  GreyImage strip_;
  std::vector<std::uint8_t> last_;
  double sweep_s_ = 4.0;
  double lastTime_s_ = 0.0;
  double lastColumn_ = 0.0;
  int cursor_ = 0;
  bool started_ = false;
};

}  // namespace ew
