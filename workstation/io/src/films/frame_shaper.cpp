#include <algorithm>
#include <cmath>
#include <utility>

#include "films/cine_source.h"

namespace ew::detail {
namespace {

constexpr double kSquare = 0.002;  // less is no more than how a rate was rounded: half a pixel in 250

int stretched(int size, double by) { return std::max(1, static_cast<int>(std::lround(size * by))); }

/// Pixels along rows, or columns, at even places between those that are there.
struct Between {
  std::vector<int> from;
  std::vector<float> share;  ///< of the next one

  Between(int there, int wanted) : from(static_cast<std::size_t>(wanted)), share(static_cast<std::size_t>(wanted)) {
    for (int n = 0; n < wanted; ++n) {
      const double at = std::clamp((n + 0.5) * there / wanted - 0.5, 0.0, there - 1.0);
      const int before = std::min(static_cast<int>(at), std::max(0, there - 2));
      from[static_cast<std::size_t>(n)] = before;
      share[static_cast<std::size_t>(n)] = there < 2 ? 0.0F : static_cast<float>(at - before);
    }
  }
};

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, float share) {
  return static_cast<std::uint8_t>(std::lround(static_cast<float>(a) + share * (static_cast<float>(b) - static_cast<float>(a))));
}
Rgb mixed(const Rgb& a, const Rgb& b, float share) { return {mixed(a.r, b.r, share), mixed(a.g, b.g, share), mixed(a.b, b.b, share)}; }

template <class T>
std::vector<T> stretchedTo(const std::vector<T>& stored, int width, int height, int wide, int tall) {
  std::vector<T> out(static_cast<std::size_t>(wide) * static_cast<std::size_t>(tall));
  const Between across(width, wide), down(height, tall);
  auto to = out.begin();
  for (int y = 0; y < tall; ++y) {
    const auto row = static_cast<std::size_t>(y);
    const T* const upper = stored.data() + static_cast<std::ptrdiff_t>(down.from[row]) * width;
    const T* const lower = upper + (height > 1 ? width : 0);
    for (std::size_t x = 0; x < static_cast<std::size_t>(wide); ++x) {
      const int left = across.from[x], right = left + (width > 1 ? 1 : 0);
      *to++ = mixed(mixed(upper[left], upper[right], across.share[x]), mixed(lower[left], lower[right], across.share[x]), down.share[row]);
    }
  }
  return out;
}

}  // namespace

FrameShaper::FrameShaper(const CineInfo& stored, const Orientation& asked)
    : storedWide_(stored.width_px),
      storedTall_(stored.height_px),
      wide_(stored.width_px),
      tall_(stored.height_px),
      orientation_(then(stored.orientation, asked)) {
  if (std::abs(stored.pixelAspect - 1.0) < kSquare) return;
  stretches_ = true;
  if (stored.pixelAspect > 1.0)
    wide_ = stretched(wide_, stored.pixelAspect);
  else
    tall_ = stretched(tall_, 1.0 / stored.pixelAspect);
}

PixelRect FrameShaper::shaped(const PixelRect& stored) const {
  const auto scaled = [](int value, int from, int to) { return static_cast<int>(std::lround(static_cast<double>(value) * to / from)); };
  const int left = scaled(stored.x, storedWide_, wide_), top = scaled(stored.y, storedTall_, tall_);
  PixelRect rect{left, top, scaled(stored.x + stored.width, storedWide_, wide_) - left,
                 scaled(stored.y + stored.height, storedTall_, tall_) - top};
  int wide = wide_, tall = tall_;
  for (int turn = 0; turn < orientation_.quarterTurns; ++turn) {
    rect = {tall - rect.y - rect.height, rect.x, rect.height, rect.width};
    std::swap(wide, tall);
  }
  if (orientation_.mirrored) rect.x = wide - rect.x - rect.width;
  return rect;
}

void FrameShaper::shape(CineFrame& frame) {
  const int width = frame.level.width, height = frame.level.height;
  if (stretches_) {
    frame.level.pixels = stretchedTo(frame.level.pixels, width, height, wide_, tall_);
    if (!frame.coloured.empty()) frame.coloured = stretchedTo(frame.coloured, width, height, wide_, tall_);  // half and more counts
    if (!frame.colour.pixels.empty()) frame.colour.pixels = stretchedTo(frame.colour.pixels, width, height, wide_, tall_);
  }
  if (!orientation_.isUpright()) {
    putUpright(frame.level.pixels, wide_, tall_, orientation_, work_.level.pixels);
    frame.level.pixels.swap(work_.level.pixels);
    if (!frame.coloured.empty()) {
      putUpright(frame.coloured, wide_, tall_, orientation_, work_.coloured);
      frame.coloured.swap(work_.coloured);
    }
    if (!frame.colour.pixels.empty()) {
      putUpright(frame.colour.pixels, wide_, tall_, orientation_, work_.colour.pixels);
      frame.colour.pixels.swap(work_.colour.pixels);
    }
  }
  frame.level.width = width_px();
  frame.level.height = height_px();
  if (frame.colour.pixels.empty()) return;
  frame.colour.width = width_px();
  frame.colour.height = height_px();
}

}  // namespace ew::detail
