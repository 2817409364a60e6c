#pragma once

#include "ew/labelling/labels.h"

namespace ew::labelling {

/// From a seed through voxels of like echo.
struct GrowOptions {
  double smoothing_mm = 1.2;       ///< standard deviation of the Gaussian that echoes are averaged with first, at most, 0 to 5
  double reach_mm = 40.0;          ///< how far from the seed it may go, 1 to 100
  double bandWidth = 2.5;          ///< standard deviations about the mean of the seed's neighbourhood that count as like, 0.5 to 10
  double leastBand_levels = 8.0;   ///< the band's half width is at least this
  double edge_levelsPerMm = 14.0;  ///< a steeper slope of the averaged echo is an edge, which is not crossed; 0: edges do not count
  double neck_mm = 2.0;            ///< at most; passages narrower than this are not gone through, 0 to 20: what keeps it from leaking
  double largest_ml = 60.0;        ///< more is taken for a leak
};
enum class GrowStop {
  done,      ///< nothing more is like the seed
  tooLarge,  ///< it went on beyond largest_ml: nothing was labelled
  nothing    ///< the seed lies outside of the echoes, or on an edge: nothing was labelled
};
struct GrowResult {
  GrowStop stop = GrowStop::nothing;
  VoxelBox changed;
  double volume_ml = 0.0;                          ///< of what was grown; when it is too large, of what was reached by then
  double lowest_level = 0.0, highest_level = 0.0;  ///< the band that was chosen
  bool touchesReach = false;                       ///< it goes on beyond reach_mm
};

/// Labels what belongs to the seed. On the labels' grid echoes are averaged (over a voxel, then by the Gaussian); the band is the mean of
/// those within 3 mm of the seed that lie on no edge, and bandWidth of their standard deviations about it; voxels in the band and on no
/// edge are joined by faces, after passages narrower than neck_mm were closed (an opening by a ball), from the seed on. Holes of up to a
/// voxel's width, which speckle leaves, are closed. In a thin structure less is averaged (a quarter of its half thickness), the band is
/// chosen from fewer neighbours and narrower passages belong to it; its half thickness is how far echoes stay within 20 levels of the
/// seed's in the quarter of all directions in which they do so least. Last the region goes on over the slope that averaging made of its
/// border, to where echoes are half way between its own mean and that of what lies around it. Source: region growing as in Adams and
/// Bischof, Seeded region growing, IEEE Trans. Pattern Anal. Mach. Intell. 16(6), 1994; ours takes one seed and a fixed band, opens the
/// region, for speckle makes leaks, and finds the border at the half level.
/// @param echo     levels on their own grid, in the frame of the labels' grid; absent ones (coverage) are never labelled
/// @param seed_mm  of the file
/// @error cancelled (within 0.5 s); then nothing changed
[[nodiscard]] Result<GrowResult> growFrom(Volume& labels, const Volume& echo, const Grid& echoGrid, const glm::dvec3& seed_mm,
                                          const GrowOptions& options, const Brush& brush, Progress& progress);

}  // namespace ew::labelling
