#pragma once

// How the pixels of frames become voxels (ew/acquisition/reconstruct.h), and views one volume (ew/stitching/join.h): the choices alone, for
// cases and plugins that name them and make no volume.
namespace ew {

/// nearest: a pixel goes into the voxel whose centre is nearest, floor(at + 0.5) along each axis.
/// linear: a pixel is shared among the 8 voxels around it, by trilinear weights.
/// centred: measured are the voxels of `nearest`, and each takes what the frames show at its centre, not somewhere in it: read between
///          pixels, over an area as large as a voxel. Between two successive frames at most 2.5 voxels apart it takes their blend, as
///          FillMethod::sweep blends them; else the mean of the frames that pass through it, weighted with 1 - distance of the plane / half
///          the voxel's extent. For the mean and the weighted mean; with maximum and latest it is `nearest`.
enum class Interpolation { nearest, linear, centred };

/// What a voxel takes from the pixels that reach it.
/// mean:    floor(sum of weight * value / sum of weight + 0.5). With linear, a voxel is measured when its weight exceeds 1e-9 pixels.
/// maximum: the largest. A measured zero counts as measured.
/// latest:  the last one in the order of the frames, and within a frame of rows and columns.
/// weighted: as mean, each pixel counted with the weight its frame gives it (TrackedFrame::weights). A voxel that only pixels of weight 0
/// reach
///          is not measured. Equal weights give the voxels of the mean.
/// For maximum and latest with linear, a pixel reaches those of the 8 voxels where its weight is at least 1/8, so always one.
enum class Compounding { mean, maximum, latest, weighted };

}  // namespace ew

namespace ew::stitching {

/// How views are joined where they overlap.
enum class SeamMethod {
  /// No seam: each voxel is the mean of the views that cover it, weighted by the distance from each view's border (up to featherWidth_mm)
  /// and by interpolatedWeight where a view was interpolated. Constants are kept exactly; one view on its own grid passes unchanged.
  feather,
  nearest,  ///< each voxel to the view in whose inside it lies deepest
  graphCut  ///< along the surface where the views differ least
};

}  // namespace ew::stitching
