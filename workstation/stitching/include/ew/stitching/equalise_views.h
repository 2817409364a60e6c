#pragma once

#include <span>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/stitching/join.h"

namespace ew::stitching {

struct EqualiseViewsOptions {
  double cell_mm = 4.0;      ///< views are compared by the means of cubes of this size
  double knot_mm = 15.0;     ///< a correction is a straight line between depths this far apart
  double smoothness = 0.02;  ///< how stiff a curve is where nothing says otherwise, as a share of the data's weight
  double common = 1.0;       ///< how much the curve that all have in common is held at 0, as a share of the data's weight
  int fewestCells = 12;      ///< two views overlap when they share so many cells
  int threads = 0;
};

struct ViewEqualisation {
  std::vector<GreyCorrection> corrections;  ///< one per view; the mean over a group of overlapping views is about 0
  int groups = 0;                           ///< between groups nothing is known
  double disagreementBefore_db = 0.0;       ///< median size of the difference between two views' cells, at a dynamic range of 60 dB
  double disagreementAfter_db = 0.0;
  std::vector<Message> notes;
};

/// Gain and depth gain of subvolumes brought together where they overlap. Depth runs along each view's beams; shadows, edges and
/// saturated cells are weighed down.
/// @error badField, emptyVolume, cancelled
[[nodiscard]] Result<ViewEqualisation> equaliseViews(std::span<const View> views, const EqualiseViewsOptions& options, Progress& progress);

}  // namespace ew::stitching
