#include "ew/acquisition/recorded_images.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "clip_spans.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

/// The rectangle around all spans, one pixel wider where the frame has one, so that its edge fades as that of the fan does.
struct Cut {
  int left = 0, right = 0, top = 0, bottom = 0;  ///< both ends belong to it
};

Cut cutOf(const ClipSpans& spans, int width, int height) {
  Cut cut{width, -1, height, -1};
  for (int y = spans.firstRow(); y <= spans.lastRow(); ++y)
    for (const Span& span : spans.row(y)) {
      cut.left = std::min(cut.left, span.begin);
      cut.right = std::max(cut.right, span.end - 1);
      cut.top = std::min(cut.top, y);
      cut.bottom = std::max(cut.bottom, y);
    }
  return {std::max(0, cut.left - 1), std::min(width - 1, cut.right + 1), std::max(0, cut.top - 1), std::min(height - 1, cut.bottom + 1)};
}

}  // namespace

Result<Sequence> recordedImages(const SweepInput& opened, int every) {
  EW_EXPECTS(every >= 1);
  const std::vector<TrackedFrame> frames = posedFrames(opened);
  if (frames.empty())
    return failure(ErrorCode::badField, say<"No image of the recording has a pose, so none can be kept.">(), {{"field", "frames"}});
  const int width = opened.sequence.width, height = opened.sequence.height;
  const auto spans = ClipSpans::of(opened.plan.reconstruct.clip, width, height);
  if (!spans) return passOn(spans.error());
  const Cut cut = cutOf(*spans, width, height);
  Sequence made;
  made.width = cut.right - cut.left + 1;
  made.height = cut.bottom - cut.top + 1;
  made.orientation = "MF";
  made.imageType = "BRIGHTNESS";
  const std::size_t pixels = static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height);
  glm::dmat4 toWhole(1.0);
  toWhole[3] = glm::dvec4(cut.left, cut.top, 0.0, 1.0);
  for (std::size_t n = 0; n < frames.size(); n += static_cast<std::size_t>(every)) {
    SequenceFrame said;
    said.imageStatus = PoseStatus::ok;
    said.transforms.push_back({kImageFrame, kReferenceFrame, frames[n].imageToWorld.matrix * toWhole, PoseStatus::ok});
    made.frames.push_back(std::move(said));
    const std::size_t begin = made.pixels.size();
    made.pixels.resize(begin + pixels, std::uint8_t{0});
    for (int y = cut.top; y <= cut.bottom; ++y)
      for (const Span& span : spans->row(y))
        std::copy_n(frames[n].pixels.row(y) + span.begin, span.end - span.begin,
                    made.pixels.data() + begin + static_cast<std::size_t>(y - cut.top) * static_cast<std::size_t>(made.width) +
                        static_cast<std::size_t>(span.begin - cut.left));
  }
  return made;
}

}  // namespace ew
