#include <algorithm>
#include <cmath>

#include "ew/acquisition/screen.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kNoise = 2;            ///< levels that a codec changes by itself
constexpr double kSameShare = 2e-4;  ///< of the pixels: a clock or a pointer moves, the scan does not
constexpr int kMostFrames = 60000;   ///< sums of squares of so many frames fit 32 bits

template <class Value>
Image<float> shareOf(int width, int height, const std::vector<Value>& counts, int of) {
  Image<float> share(width, height);
  const float each = of > 0 ? 1.0F / static_cast<float>(of) : 0.0F;
  for (std::size_t n = 0; n < counts.size(); ++n) share.pixels[n] = each * static_cast<float>(counts[n]);
  return share;
}

}  // namespace

ScreenStatistics::ScreenStatistics(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), lowest_(width_px, height_px, 255), highest_(width_px, height_px, 0) {
  const std::size_t pixels = lowest_.pixels.size();
  sum_.resize(pixels);
  squares_.resize(pixels);
  changes_.resize(pixels);
  coloured_.resize(pixels);
}

void ScreenStatistics::add(const CineFrame& frame) {
  EW_EXPECTS(frame.level.width == width_px_ && frame.level.height == height_px_);
  const std::vector<std::uint8_t>& level = frame.level.pixels;
  if (frames_ >= kMostFrames) return;
  if (frames_ > 0) {
    std::size_t changed = 0;
    for (std::size_t n = 0; n < level.size(); ++n) changed += std::abs(level[n] - last_.pixels[n]) > kNoise ? 1 : 0;
    if (static_cast<double>(changed) < kSameShare * static_cast<double>(level.size())) return;
    for (std::size_t n = 0; n < level.size(); ++n)
      changes_[n] = static_cast<std::uint16_t>(changes_[n] + (std::abs(level[n] - last_.pixels[n]) > kNoise ? 1 : 0));
  }
  for (std::size_t n = 0; n < level.size(); ++n) {
    const std::uint8_t value = level[n];
    lowest_.pixels[n] = std::min(lowest_.pixels[n], value);
    highest_.pixels[n] = std::max(highest_.pixels[n], value);
    sum_[n] += value;
    squares_[n] += static_cast<std::uint32_t>(value) * value;
  }
  if (!frame.coloured.empty())
    for (std::size_t n = 0; n < level.size(); ++n) coloured_[n] = static_cast<std::uint16_t>(coloured_[n] + frame.coloured[n]);
  last_ = frame.level;
  ++frames_;
}

Image<float> ScreenStatistics::mean() const { return shareOf(width_px_, height_px_, sum_, frames_); }
Image<float> ScreenStatistics::activity() const { return shareOf(width_px_, height_px_, changes_, frames_ - 1); }
Image<float> ScreenStatistics::colouredShare() const { return shareOf(width_px_, height_px_, coloured_, frames_); }

Image<float> ScreenStatistics::deviation() const {
  Image<float> result(width_px_, height_px_);
  const double count = std::max(frames_, 1);
  for (std::size_t n = 0; n < sum_.size(); ++n) {
    const double mean = sum_[n] / count;
    result.pixels[n] = static_cast<float>(std::sqrt(std::max(0.0, squares_[n] / count - mean * mean)));
  }
  return result;
}

}  // namespace ew
