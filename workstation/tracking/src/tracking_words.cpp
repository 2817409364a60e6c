#include "ew/tracking/tracking_words.h"

namespace ew {

Message stateWord(TrackingState state) {
  switch (state) {
    case TrackingState::live:
      return say<"live">();
    case TrackingState::outOfRange:
      return say<"out of range">();
    case TrackingState::outOfView:
      return say<"out of view">();
    case TrackingState::invalid:
      return say<"not valid">();
    case TrackingState::duplicate:
      return say<"stuck">();
    case TrackingState::stale:
      return say<"no news">();
    case TrackingState::lost:
      return say<"lost">();
    case TrackingState::off:
      return say<"off">();
  }
  return {};
}

namespace {

Message sentenceWithoutTool(TrackingState state) {
  switch (state) {
    case TrackingState::live:
      return say<"The probe follows the tracker.">();
    case TrackingState::outOfRange:
      return say<"The tracker measures the probe too badly here; bring it nearer to the middle of what the tracker sees.">();
    case TrackingState::outOfView:
      return say<"The tracker does not see the probe; take away what stands between them.">();
    case TrackingState::invalid:
      return say<"The tracker sends something that is no place of a probe; look at its own program.">();
    case TrackingState::duplicate:
      return say<"The tracker sends the same reading again and again; look whether its own program hangs.">();
    case TrackingState::stale:
      return say<"The tracker is connected and sends nothing; look whether it measures.">();
    case TrackingState::lost:
      return say<"The connection to the tracker is gone; it is tried again by itself.">();
    case TrackingState::off:
      return say<"No tracker is in use.">();
  }
  return {};
}

}  // namespace

Message stateSentence(TrackingState state, const std::string& tool) {
  if (tool.empty()) return sentenceWithoutTool(state);
  switch (state) {
    case TrackingState::live:
      return say<"The probe follows '%1'.">(tool);
    case TrackingState::outOfRange:
      return say<"'%1' is measured too badly here; bring the probe nearer to the middle of what the tracker sees.">(tool);
    case TrackingState::outOfView:
      return say<"The tracker does not see '%1'; take away what stands between them.">(tool);
    case TrackingState::invalid:
      return say<"What the tracker sends for '%1' is no place of a probe; look at its own program.">(tool);
    case TrackingState::duplicate:
      return say<"The tracker sends the same reading of '%1' again and again; look whether its own program hangs.">(tool);
    case TrackingState::stale:
      return say<"Nothing has come of '%1' for a while; look whether the tracker measures.">(tool);
    case TrackingState::lost:
    case TrackingState::off:
      return sentenceWithoutTool(state);
  }
  return {};
}

}  // namespace ew
