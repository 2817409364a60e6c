#pragma once

#include <QRect>
#include <vector>

namespace ew::ui {

/// Where the body mark lies. In the corner that was asked for when nothing there is covered, otherwise in another that is free; where none
/// is, the mark becomes smaller until one is; and where even the smallest has no room, it lies where it covers least.
/// @param room    of the scan, without its words, sliders and scales
/// @param taken   what must not be covered: the fan, the strip
/// @param corner  0 upper left, 1 upper right, 2 lower left, 3 lower right
/// @param most_px, least_px side of the square, least_px <= most_px
[[nodiscard]] QRect placeOfMark(const QRect& room, const std::vector<QRect>& taken, int corner, int most_px, int least_px);

}  // namespace ew::ui
