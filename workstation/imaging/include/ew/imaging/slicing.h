#pragma once

#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/volume.h"
#include "ew/imaging/knobs.h"

namespace ew {

/// Scratch memory of the slicers; keep one per thread and reuse it, then slicing allocates nothing.
struct SliceScratch {
  std::vector<std::ptrdiff_t> templateOffsets;  ///< dT_i of Eq. 1
  std::vector<int> templateI, templateJ, templateK;
  GreyImage voxelSized;            ///< intermediate image of the zoom-in
  std::vector<std::uint8_t> rows;  ///< stretched rows waiting for their vertical stretch
};

/// Samples the plane z = 0 of the image frame, one voxel a pixel, by replicating a voxelised template line along a voxelised base
/// line (weaving). A pixel outside the volume becomes 0. Each row is clipped once.
/// @param imageToVoxel affine; pixel centres at integer coordinates
/// Source: Aiger & Cohen-Or 1998, Eq. 1, Fig. 3-4.
void sliceWeave(const VolumeView<const std::uint8_t>& volume, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
                ImageView<std::uint8_t> out, SliceScratch& scratch);

/// Samples the same plane by trilinear interpolation, exact on constants and on ramps within one rounding. A pixel more than half a
/// voxel outside the outermost voxel centres becomes 0; between, the outermost value continues (as in vtkImageReslice with Border on).
void sliceLinear(const VolumeView<const std::uint8_t>& volume, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
                 ImageView<std::uint8_t> out, SliceScratch& scratch);

/// The slicer of a quality. Zooming in (several pixels a voxel) with Quality::weave runs the paper's two interleaved stretches.
void slice(Quality quality, const VolumeView<const std::uint8_t>& volume, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
           ImageView<std::uint8_t> out, SliceScratch& scratch);

/// Pixel (x, y) of a width x height image lies at ((x - (width - 1) / 2) pixel_mm, y pixel_mm, 0) of the probe frame: the geometry of
/// `echoweave slice`.
[[nodiscard]] Transform<frame::Probe, frame::Image> sliceGeometry(int width, double pixel_mm);

}  // namespace ew
