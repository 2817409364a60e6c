#include "scan/tracking_look.h"

#include "ew/tracking/tracking_words.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

/// Neither in order nor danger: the tracker is there, and shows nothing of now.
QColor waitingColour(const Theme& theme) { return theme.dark ? QColor(0xe3, 0xa9, 0x45) : QColor(0x8a, 0x56, 0x00); }

}  // namespace

TrackingLook lookOf(TrackingState state, const Theme& theme) {
  switch (state) {
    case TrackingState::live:
      return {words(stateWord(state)), QStringLiteral("tracking-live"), theme.accent};
    case TrackingState::outOfRange:
      return {words(stateWord(state)), QStringLiteral("tracking-out-of-range"), waitingColour(theme)};
    case TrackingState::outOfView:
      return {words(stateWord(state)), QStringLiteral("tracking-out-of-view"), waitingColour(theme)};
    case TrackingState::invalid:
      return {words(stateWord(state)), QStringLiteral("tracking-invalid"), theme.danger};
    case TrackingState::duplicate:
      return {words(stateWord(state)), QStringLiteral("tracking-duplicate"), waitingColour(theme)};
    case TrackingState::stale:
      return {words(stateWord(state)), QStringLiteral("tracking-stale"), waitingColour(theme)};
    case TrackingState::lost:
      return {words(stateWord(state)), QStringLiteral("tracking-lost"), theme.danger};
    case TrackingState::off:
      break;
  }
  return {words(stateWord(state)), QStringLiteral("tracking-off"), theme.quiet};
}

}  // namespace ew::ui
