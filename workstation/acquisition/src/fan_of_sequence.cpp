#include <algorithm>

#include "ew/acquisition/import.h"
#include "ew/acquisition/screen.h"
#include "fan_finder.h"

namespace ew {

Result<std::optional<ClipFan>> fanOf(const Sequence& sequence, Progress& progress) {
  constexpr std::size_t kMostLookedAt = 60;
  constexpr double kLeastAround = 0.03;  // of the frame: less black around a fan is the edge of the image
  std::optional<ClipFan> fan;
  if (sequence.pixels.empty() || sequence.frames.empty()) return fan;
  ScreenStatistics statistics(sequence.width, sequence.height);
  const std::size_t looked = std::min(kMostLookedAt, sequence.frames.size());
  for (std::size_t n = 0; n < looked; ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The import was stopped before it was complete.">());
    const auto pixels = sequence.framePixels(n * sequence.frames.size() / looked);
    CineFrame frame;
    frame.level = GreyImage(sequence.width, sequence.height);
    std::copy(pixels.begin(), pixels.end(), frame.level.pixels.begin());
    statistics.add(frame);
  }
  const auto found = detail::findFan(statistics);
  if (!found || found->quality < kLeastQuality || found->outline.shape == FanShape::linear) return fan;
  const GreyImage inside = maskOf(found->outline, sequence.width, sequence.height);
  const auto outside = static_cast<double>(std::count(inside.pixels.begin(), inside.pixels.end(), std::uint8_t{0}));
  if (outside < kLeastAround * static_cast<double>(inside.pixels.size())) return fan;
  fan = clipOf(found->outline).fan;
  return fan;
}

}  // namespace ew
