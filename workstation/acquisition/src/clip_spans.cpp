#include "clip_spans.h"

#include <algorithm>
#include <cmath>

#include "ew/core/numbers.h"

namespace ew {
namespace {

bool finite(const glm::dvec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

Result<void> checkFan(const ClipFan& fan) {
  if (!finite(fan.origin_px) || !std::isfinite(fan.leftAngle_rad) || !std::isfinite(fan.rightAngle_rad) ||
      !std::isfinite(fan.startRadius_px) || !std::isfinite(fan.stopRadius_px))
    return failure(ErrorCode::badField, say<"The clip fan contains a value that is not a number; give origin, angles and radii in full.">(),
                   {{"field", "clip fan"}});
  if (!(fan.stopRadius_px > fan.startRadius_px))
    return failure(ErrorCode::badField,
                   say<"The clip fan ends at radius %1 px before it begins at %2 px; give a stop radius larger than the start radius.">(
                       textOf(fan.stopRadius_px), textOf(fan.startRadius_px)),
                   {{"field", "clip fan radius"}});
  return {};
}

class InsideFan {
 public:
  explicit InsideFan(const ClipFan& fan)
      : fan_(fan),
        smallestAngle_rad_(std::min(fan.leftAngle_rad, fan.rightAngle_rad)),
        largestAngle_rad_(std::max(fan.leftAngle_rad, fan.rightAngle_rad)) {}

  bool operator()(double x, double y) const {
    const double dx = x - fan_.origin_px.x;
    const double dy = y - fan_.origin_px.y;
    const double radius = std::hypot(dx, dy);
    if (radius < fan_.startRadius_px || radius > fan_.stopRadius_px) return false;
    const double angle_rad = std::atan2(dx, dy);
    return angle_rad >= smallestAngle_rad_ && angle_rad <= largestAngle_rad_;
  }

 private:
  ClipFan fan_;
  double smallestAngle_rad_;
  double largestAngle_rad_;
};

}  // namespace

Result<ClipRectangle> clipRectangle(const Clip& clip, int width, int height) {
  EW_EXPECTS(width > 0 && height > 0);
  const glm::dvec2 size_px = clip.size_px.value_or(glm::dvec2(width, height));
  if (!finite(clip.origin_px) || !finite(size_px))
    return failure(ErrorCode::badField, say<"The clip rectangle contains a value that is not a number; give origin and size in pixels.">(),
                   {{"field", "clip rectangle"}});
  const ClipRectangle rectangle{clip.origin_px.x, std::min(clip.origin_px.x + size_px.x, width - 1.0), clip.origin_px.y,
                                std::min(clip.origin_px.y + size_px.y, height - 1.0)};
  if (rectangle.left < 0.0 || rectangle.top < 0.0 || rectangle.left > width - 1.0 || rectangle.top > height - 1.0)
    return failure(ErrorCode::badField,
                   say<"The clip rectangle begins at (%1, %2) px, outside the %3 x %4 px frame; give an origin inside the frame.">(
                       textOf(rectangle.left), textOf(rectangle.top), width, height),
                   {{"field", "clip rectangle origin"}});
  if (rectangle.right < rectangle.left || rectangle.bottom < rectangle.top)
    return failure(ErrorCode::badField, say<"The clip rectangle has a negative size; give its width and height in pixels.">(),
                   {{"field", "clip rectangle size"}});
  return rectangle;
}

Result<ClipSpans> ClipSpans::of(const Clip& clip, int width, int height) {
  const auto rectangle = clipRectangle(clip, width, height);
  if (!rectangle) return passOn(rectangle.error());
  if (clip.fan) {
    if (const auto checked = checkFan(*clip.fan); !checked) return passOn(checked.error());
  }
  ClipSpans spans;
  spans.rectangle_ = *rectangle;
  spans.firstColumn_ = static_cast<int>(std::ceil(rectangle->left));
  const int lastColumn = static_cast<int>(std::floor(rectangle->right));
  spans.firstRow_ = static_cast<int>(std::ceil(rectangle->top));
  spans.lastRow_ = static_cast<int>(std::floor(rectangle->bottom));
  spans.firstOfRow_.reserve(static_cast<std::size_t>(height) + 1);
  for (int y = 0; y < height; ++y) {
    spans.firstOfRow_.push_back(spans.spans_.size());
    if (y < rectangle->top || y > rectangle->bottom || lastColumn < spans.firstColumn_) continue;
    if (!clip.fan) {
      spans.spans_.push_back({spans.firstColumn_, lastColumn + 1});
      continue;
    }
    const InsideFan inside(*clip.fan);
    for (int x = spans.firstColumn_; x <= lastColumn;) {
      while (x <= lastColumn && !inside(x, y)) ++x;
      const int begin = x;
      while (x <= lastColumn && inside(x, y)) ++x;
      if (x > begin) spans.spans_.push_back({begin, x});
    }
  }
  spans.firstOfRow_.push_back(spans.spans_.size());
  for (const Span& span : spans.spans_) spans.pixelCount_ += static_cast<std::size_t>(span.end - span.begin);
  if (spans.pixelCount_ == 0)
    return failure(ErrorCode::badField,
                   say<"The clip leaves no pixel of the frame; check the rectangle and the fan against the frame's size.">(),
                   {{"field", "clip"}});
  return spans;
}

}  // namespace ew
