#pragma once

#include <QDateTime>
#include <QImage>

namespace ew::ui {

class Session;

/// The present picture as it is handed on: as it is on the screen, pixel for pixel, with a depth scale beside it, and above it what it
/// shows: the title of what is scanned, the probe, depth, gain and zoom, and when it was made. Along the lower edge it says that it is a
/// simulation. White on black, whatever the theme; grey levels.
/// @return Format_Grayscale8; null when there is no picture
[[nodiscard]] QImage savedPicture(const Session& session, const QDateTime& at);

}  // namespace ew::ui
