#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/persistence.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "ew/imaging/effects/persistence.h"

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

constexpr int kFractionBits = 7;  // 255 << 7 still fits a signed 16 bit difference
constexpr int kHalf = 1 << (kFractionBits - 1);

/// @param fresh share of the new image, 15 fraction bits
void persistPixels(int fresh, std::uint16_t* level, std::uint8_t* pixel, int count) {
  for (int x = 0; x < count; ++x) {
    const int difference = (pixel[x] << kFractionBits) - level[x];
    int move = (difference * fresh + (1 << 14)) >> 15;
    if (move == 0) move = (difference > 0) - (difference < 0);
    const int moved = level[x] + move;
    level[x] = static_cast<std::uint16_t>(moved);
    pixel[x] = static_cast<std::uint8_t>((moved + kHalf) >> kFractionBits);
  }
}

#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR

void persistRun(int fresh, std::uint16_t* level, std::uint8_t* pixel, int count) { persistPixels(fresh, level, pixel, count); }

#else

namespace hn = hwy::HWY_NAMESPACE;

/// persistPixels with vectors.
void persistRun(int fresh, std::uint16_t* level, std::uint8_t* pixel, int count) {
  const hn::ScalableTag<std::int16_t> d;
  const hn::RebindToUnsigned<decltype(d)> levels;
  const hn::Rebind<std::uint8_t, decltype(d)> pixels;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto share = hn::Set(d, static_cast<std::int16_t>(fresh));
  int x = 0;
  for (; x + lanes <= count; x += lanes) {
    const auto before = hn::BitCast(d, hn::LoadU(levels, level + x));
    const auto image = hn::ShiftLeft<kFractionBits>(hn::PromoteTo(d, hn::LoadU(pixels, pixel + x)));
    const auto difference = hn::Sub(image, before);
    const auto move = hn::MulFixedPoint15(difference, share);
    const auto oneStep = hn::Max(hn::Min(difference, hn::Set(d, 1)), hn::Set(d, -1));
    const auto moved = hn::Add(before, hn::IfThenElse(hn::Eq(move, hn::Zero(d)), oneStep, move));
    hn::StoreU(hn::BitCast(levels, moved), levels, level + x);
    hn::StoreU(hn::DemoteTo(pixels, hn::ShiftRight<kFractionBits>(hn::Add(moved, hn::Set(d, kHalf)))), pixels, pixel + x);
  }
  persistPixels(fresh, level + x, pixel + x, count - x);
}

#endif

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {

HWY_EXPORT(persistRun);

void beginPersistence(int width, int height, PersistenceMemory& memory) {
  EW_EXPECTS(width >= 0 && height >= 0);
  if (memory.width != width || memory.height != height) {
    memory.width = width;
    memory.height = height;
    memory.levels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    memory.empty = true;
  }
  memory.starting = memory.empty;
  memory.empty = false;
}

void persist(double share, std::span<const std::vector<RowSpan>> spans, int firstRow, int rows, ImageView<std::uint8_t> image,
             PersistenceMemory& memory) {
  EW_EXPECTS(image.width == memory.width && image.height == memory.height);
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(image.height));
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= image.height);
  const double usable = share > 0.0 ? std::min(share, 0.95) : 0.0;
  const bool start = memory.starting || usable == 0.0;
  const int fresh = std::min(static_cast<int>(std::lround((1.0 - usable) * 32768.0)), 32767);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    std::uint16_t* levels = memory.levels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(memory.width);
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
      std::uint8_t* pixel = image.row(y) + span.begin;
      std::uint16_t* level = levels + span.begin;
      const int count = span.end - span.begin;
      if (start)
        std::transform(pixel, pixel + count, level, [](std::uint8_t v) { return static_cast<std::uint16_t>(v << 7); });
      else
        HWY_DYNAMIC_DISPATCH(persistRun)(fresh, level, pixel, count);
    }
  }
}

}  // namespace ew
#endif
