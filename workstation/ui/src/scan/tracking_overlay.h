#pragma once

#include <QColor>
#include <QImage>
#include <QRect>
#include <QString>

#include "ew/scanning/contact.h"
#include "ew/tracking/tracked_probe.h"

class QPainter;

namespace ew::ui {

// What lies over an image that is none of now, because a tracker has lost the probe. A frozen image is the user's own doing and keeps
// its grey; this one is pale, has a hatched border, and says why, since when and what to do. States differ in colour, icon and word.

/// A colour of its own for each state, on black; none is the one of a frozen image.
[[nodiscard]] QColor lossColour(TrackingState state);

/// The image without its colours and with little of its light.
[[nodiscard]] QImage paled(const QImage& image);

/// @param shown where the image lies: gets the hatched border
/// @param mayMove whether the hand takes the probe when it moves
void paintLoss(QPainter& painter, const QRect& shown, const TrackingReport& report, bool mayMove);

/// A line above an image that is live, where no body mark and no scale covers it.
/// @param iconName of resources/icons
void paintTrackingNote(QPainter& painter, const QRect& shown, const QString& iconName, const QColor& colour, const QString& words);

/// "12 s", "3 min"
[[nodiscard]] QString lossLength(double seconds);

}  // namespace ew::ui
