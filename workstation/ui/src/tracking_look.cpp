#include "tracking_look.h"

#include <QCoreApplication>

namespace ew::ui {
namespace {

/// Neither in order nor danger: the tracker is there, and shows nothing of now.
QColor waitingColour(const Theme& theme) { return theme.dark ? QColor(0xe3, 0xa9, 0x45) : QColor(0x8a, 0x56, 0x00); }

QString trackingWord(const char* word) { return QCoreApplication::translate("ew::ui::TrackingLook", word); }

}  // namespace

TrackingLook lookOf(TrackingState state, const Theme& theme) {
  switch (state) {
    case TrackingState::live:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "live")), QStringLiteral("tracking-live"), theme.accent};
    case TrackingState::outOfRange:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "out of range")), QStringLiteral("tracking-out-of-range"),
              waitingColour(theme)};
    case TrackingState::outOfView:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "out of view")), QStringLiteral("tracking-out-of-view"),
              waitingColour(theme)};
    case TrackingState::invalid:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "no usable pose")), QStringLiteral("tracking-invalid"), theme.danger};
    case TrackingState::duplicate:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "frozen reading")), QStringLiteral("tracking-duplicate"),
              waitingColour(theme)};
    case TrackingState::stale:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "silent")), QStringLiteral("tracking-stale"), waitingColour(theme)};
    case TrackingState::lost:
      return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "lost")), QStringLiteral("tracking-lost"), theme.danger};
    case TrackingState::off:
      break;
  }
  return {trackingWord(QT_TRANSLATE_NOOP("ew::ui::TrackingLook", "off")), QStringLiteral("tracking-off"), theme.quiet};
}

}  // namespace ew::ui
