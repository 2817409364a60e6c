#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ew/acquisition/reconstruct.h"

namespace ew {

/// Pixels [begin, end) of one row.
struct Span {
  int begin = 0;
  int end = 0;
};

/// The clip rectangle in pixels, cut to the last pixel index of a width x height frame. Both ends belong to it.
struct ClipRectangle {
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
};

/// @error badField when the rectangle or the fan is not made of finite numbers or begins outside the frame
[[nodiscard]] Result<ClipRectangle> clipRectangle(const Clip& clip, int width, int height);

/// Which pixels of every row are image, worked out once for all frames. A row may hold several spans: the near arc of a fan splits it.
class ClipSpans {
 public:
  /// @error as clipRectangle; badField when no pixel is left
  [[nodiscard]] static Result<ClipSpans> of(const Clip& clip, int width, int height);

  [[nodiscard]] std::span<const Span> row(int y) const {
    const auto at = static_cast<std::size_t>(y);
    return {spans_.data() + firstOfRow_[at], firstOfRow_[at + 1] - firstOfRow_[at]};
  }
  [[nodiscard]] int height() const { return static_cast<int>(firstOfRow_.size()) - 1; }
  [[nodiscard]] int firstColumn() const { return firstColumn_; }
  [[nodiscard]] int firstRow() const { return firstRow_; }
  [[nodiscard]] int lastRow() const { return lastRow_; }
  [[nodiscard]] std::size_t pixelCount() const { return pixelCount_; }
  [[nodiscard]] const ClipRectangle& rectangle() const { return rectangle_; }

 private:
  ClipRectangle rectangle_;
  std::vector<Span> spans_;
  std::vector<std::size_t> firstOfRow_;
  int firstColumn_ = 0;
  int firstRow_ = 0;
  int lastRow_ = 0;
  std::size_t pixelCount_ = 0;
};

}  // namespace ew
