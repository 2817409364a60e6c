#include "ew/imaging/m_mode.h"

#include <cmath>

#include "ew/imaging/effects/stretch.h"

namespace ew {

void MModeStrip::configure(int width, int height, double sweep_s) {
  EW_EXPECTS(width >= 0 && height >= 0);
  const double usable_s = sweep_s > 0.0 && std::isfinite(sweep_s) ? sweep_s : 4.0;
  if (width == strip_.width && height == strip_.height && usable_s == sweep_s_) return;
  sweep_s_ = usable_s;
  strip_.width = width;
  strip_.height = height;
  strip_.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  last_.resize(static_cast<std::size_t>(height));
  now_.resize(static_cast<std::size_t>(height));
  interval_s_.resize(static_cast<std::size_t>(width));
  clear();
}

void MModeStrip::clear() {
  std::fill(strip_.pixels.begin(), strip_.pixels.end(), std::uint8_t{0});
  std::fill(interval_s_.begin(), interval_s_.end(), 0.0F);
  cursor_ = 0;
  newest_ = -1;
  started_ = false;
}

std::optional<double> MModeStrip::timeOf(int column) const {
  if (column < 0 || column >= strip_.width || newest_ < 0) return std::nullopt;
  const std::int64_t back = (newest_ - column) % strip_.width;
  const std::int64_t at = newest_ - (back < 0 ? back + strip_.width : back);
  if (at < 0 || at <= newest_ - strip_.width + seam()) return std::nullopt;
  return start_s_ + static_cast<double>(at) * columnTime_s();
}

std::optional<double> MModeStrip::columnOf(double time_s) const {
  if (newest_ < 0 || !std::isfinite(time_s)) return std::nullopt;
  constexpr double kHalf = 0.5;
  const double at = (time_s - start_s_) / columnTime_s();
  const auto newest = static_cast<double>(newest_);
  if (at < -kHalf || at > newest + kHalf || at < newest - strip_.width + seam() + kHalf) return std::nullopt;
  return at - strip_.width * std::floor((at + kHalf) / strip_.width);
}

double MModeStrip::beamInterval_s(double time_s) const {
  if (newest_ < 0) return 0.0;
  const auto column = columnOf(time_s);
  const std::int64_t at = column ? std::llround(*column) : newest_;
  return interval_s_[static_cast<std::size_t>(at % strip_.width)];
}

ImageView<const std::uint8_t> MModeStrip::image() const { return viewOf(strip_); }

void MModeStrip::add(double time_s, std::span<const std::uint8_t> beam) {
  if (strip_.width == 0 || strip_.height == 0 || beam.empty() || !std::isfinite(time_s)) return;
  if (started_ && std::abs(time_s - lastTime_s_) > sweep_s_) clear();
  if (!started_) {
    started_ = true;
    start_s_ = lastTime_s_ = time_s;
    stretch(beam, now_);
    draw(0, 1, -1.0, 0.0);
    last_.swap(now_);
    return;
  }
  if (!(time_s > lastTime_s_)) return;
  const double columnsPerSecond = strip_.width / sweep_s_;
  const double lastColumn = (lastTime_s_ - start_s_) * columnsPerSecond;
  const double column = (time_s - start_s_) * columnsPerSecond;
  stretch(beam, now_);
  draw(static_cast<std::int64_t>(std::floor(lastColumn)) + 1, static_cast<std::int64_t>(std::floor(column)) + 1, lastColumn, column);
  last_.swap(now_);
  lastTime_s_ = time_s;
}

/// Columns first .. end - 1, counted from the start, between the last beam at lastColumn and this one at column; then the black ones.
void MModeStrip::draw(std::int64_t first, std::int64_t end, double lastColumn, double column) {
  if (first >= end) return;
  constexpr int kBits = 16;
  constexpr double kOne = 1 << kBits;
  const int width = strip_.width;
  const int begin = static_cast<int>(first % width);
  const auto weightOf = [&](std::int64_t at) { return (static_cast<double>(at) - lastColumn) / (column - lastColumn); };
  const double firstWeight = weightOf(first), step = 1.0 / (column - lastColumn);
  const int columns = static_cast<int>(std::min<std::int64_t>(end - first, width));
  const int black = seam();
  for (int y = 0; y < strip_.height; ++y) {
    std::uint8_t* row = viewOf(strip_).row(y);
    const int from = last_[static_cast<std::size_t>(y)], difference = now_[static_cast<std::size_t>(y)] - from;
    int x = begin;
    const auto next = [&x, width] { x = x + 1 == width ? 0 : x + 1; };
    for (int n = 0; n < columns; ++n, next()) {
      const int weight = static_cast<int>(std::min(firstWeight + n * step, 1.0) * kOne);
      row[x] = static_cast<std::uint8_t>((from * (1 << kBits) + difference * weight + (1 << (kBits - 1))) >> kBits);
    }
    for (int n = 0; n < black; ++n, next()) row[x] = 0;
  }
  const auto interval_s = static_cast<float>((column - std::max(lastColumn, 0.0)) * columnTime_s());
  for (int n = 0; n < columns; ++n) interval_s_[static_cast<std::size_t>((begin + n) % width)] = interval_s;
  newest_ = end - 1;
  cursor_ = static_cast<int>(end % width);
}

}  // namespace ew
