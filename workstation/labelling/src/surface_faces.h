#pragma once

#include "ew/labelling/label_surfaces.h"
#include "surface_net.h"

namespace ew::labelling {

/// Places the points of a net in mm and makes its faces triangles, which cross nowhere (label_surfaces.h says why).
/// @return false when cancelled
[[nodiscard]] bool makeFaces(const LabelRows& rows, const SurfaceNet& net, int threads, Progress& progress, LabelSurfaces& surfaces);

}  // namespace ew::labelling
