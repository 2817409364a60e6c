#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ew/core/image.h"

namespace ew {

/// One beam over time: a strip whose columns are moments and whose rows are depths. New columns overwrite the oldest at a running cursor,
/// as on a machine. Column c of a sweep shows the moment c * sweep_s / width after the first beam. Allocates in configure alone.
class MModeStrip {
 public:
  /// @param width   columns of the strip, >= 0
  /// @param height  rows, >= 0
  /// @param sweep_s time across it; not a number above 0 counts as 4. A change of any clears the strip, the same again does nothing.
  void configure(int width, int height, double sweep_s);
  /// The beam as it is at `time_s`. Columns passed since the last beam are filled by interpolating between it and this one; time that
  /// stands still, runs backwards or is not finite draws nothing, and so does every beam until the last time is passed again; a jump of
  /// more than a sweep, forwards or backwards, starts afresh.
  /// @param beam values from the face down, 0..255, stretched to the strip's height (effects/stretch.h); an empty one draws nothing
  void add(double time_s, std::span<const std::uint8_t> beam);
  void clear();
  [[nodiscard]] ImageView<const std::uint8_t> image() const;
  /// Column that is written next; an eighth of the strip, at most 6 columns, is black from here on, so that the seam is seen.
  [[nodiscard]] int cursor() const { return cursor_; }

  /// Seconds from one column to the next; 0 of a strip without columns.
  [[nodiscard]] double columnTime_s() const { return strip_.width > 0 ? sweep_s_ / strip_.width : 0.0; }
  /// The moment that a column shows, on the clock of add(); empty where nothing is drawn and where the seam is black.
  [[nodiscard]] std::optional<double> timeOf(int column) const;
  /// Where a moment is shown, from the column's middle at a whole number; empty when it is not drawn yet or was drawn over.
  [[nodiscard]] std::optional<double> columnOf(double time_s) const;
  /// Time between the two beams that the column of a moment was interpolated from: echoes have no finer time. Of a moment that is not
  /// shown that of the newest beams; 0 before there are two.
  [[nodiscard]] double beamInterval_s(double time_s) const;

 private:
  [[nodiscard]] int seam() const { return std::min(6, strip_.width / 8); }
  void draw(std::int64_t first, std::int64_t end, double lastColumn, double column);

  GreyImage strip_;
  std::vector<std::uint8_t> last_;
  std::vector<std::uint8_t> now_;
  std::vector<float> interval_s_;  ///< of each column, between the beams it lies between
  double sweep_s_ = 4.0;
  double start_s_ = 0.0;  ///< moment of the first column; columns are counted from it, so that no error adds up
  double lastTime_s_ = 0.0;
  std::int64_t newest_ = -1;  ///< column that was drawn last, counted from the start
  int cursor_ = 0;
  bool started_ = false;
};

}  // namespace ew
