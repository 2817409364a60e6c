#include "ew/scanning/replay.h"

#include <algorithm>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

Replay::Replay(const ScanLog& log, ScanSubject subject, int threads) : log_(log), scanner_(threads) {
  EW_EXPECTS(log.frameCount() > 0);
  scanner_.show(std::move(subject));
}

std::size_t Replay::history(const ScanLog& log, std::size_t frame) {
  const ScanState state = log.frame(frame);
  const std::size_t persisting = framesToSettle(state.knobs);
  std::size_t before = std::min(frame, persisting);
  if (state.knobs.mode != DisplayMode::bMode) {
    const std::size_t first = log.frameAt(state.time_s - state.knobs.mSweep_s);
    before = std::max(before, frame - std::min(frame, first));
  }
  return before;
}

DisplayImage Replay::make(std::size_t frame, int width_px, int height_px) {
  EW_EXPECTS(frame < log_.frameCount());
  std::size_t next = last_ ? *last_ + 1 : 0;
  if (last_ && frame != next) {
    const std::size_t from = frame - std::min(frame, history(log_, frame));
    if (frame < next || from > next) {
      scanner_.forget();
      next = from;
    }
  }
  for (; next < frame; ++next) scanner_.make(log_.frame(next), width_px, height_px);
  last_ = frame;
  return scanner_.make(log_.frame(frame), width_px, height_px);
}

}  // namespace ew
