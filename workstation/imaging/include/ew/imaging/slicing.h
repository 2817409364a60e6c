#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/volume.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/slice_source.h"

namespace ew {

/// Pixels begin .. end - 1 of a row; both 0 when there are none.
struct RowSpan {
  int begin = 0;
  int end = 0;
  bool operator==(const RowSpan&) const = default;
};

/// Per row of an image the pixels that matter, left to right and without overlap: outside them a slicer neither reads nor writes.
using Spans = std::vector<std::vector<RowSpan>>;

/// One row of samples through a volume: samples span.begin .. span.end - 1 of row `row` of an image lie at
/// start_voxel + n * step_voxel, n from 0 at the image's first column.
struct SampleRow {
  glm::dvec3 start_voxel{0.0};
  glm::dvec3 step_voxel{0.0};
  int row = 0;
  RowSpan span;
};

/// Scratch memory of the slicers; keep one per thread and reuse it, then slicing allocates nothing.
struct SliceScratch {
  std::vector<std::uint32_t> templateLine;  ///< T_x of Eq. 1 along i, j, k: integer parts and 31 bit fractions
  std::vector<std::uint8_t> rows;           ///< zoom-in: a row of voxels and the two stretched rows it is blended from
  double zoomSampling_us = 0.0;             ///< what the last zoom-in spent on sampling alone; for reports
};

/// Samples the plane z = 0 of the image frame by replicating a voxelized template line along a voxelized base line (weaving). A pixel
/// outside the volume becomes 0. Each row is clipped once; a pixel costs one load from the volume.
/// @param source       voxels; one without voxels gives a black image
/// @param imageToVoxel affine, pixel centres at integer coordinates; a matrix that is not finite or reaches beyond 2^30 voxels gives a
///                     black image
/// Source: Aiger & Cohen-Or 1998, Eq. 1, Fig. 3-4. Ours differs: base and template keep their fractions (31 bits), and where the two
/// together reach a whole voxel the offset carries one stride. The sum of two separately rounded lines can miss the plane by a whole
/// voxel along each axis; with the carry every pixel is the voxel nearest to its centre, so no pixel shows a voxel that the plane does
/// not pierce and none is left out.
void sliceWeave(const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel, ImageView<std::uint8_t> out,
                SliceScratch& scratch);

/// Samples the same plane by trilinear interpolation, exact on constants and on ramps within one rounding. A pixel more than half a
/// voxel outside the outermost voxel centres becomes 0; between, the outermost value continues (as in vtkImageReslice with Border on).
void sliceLinear(const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel, ImageView<std::uint8_t> out,
                 SliceScratch& scratch);

/// Samples the same plane by cubic convolution over 4 x 4 x 4 voxels, exact on constants and, two voxels from the faces, on ramps within
/// one rounding. Nearer to a face the missing neighbours repeat the outermost voxel; beyond it the border is that of sliceLinear. Overshoot
/// is cut off at 0 and 255. Source: Keys, IEEE Trans. ASSP 29(6), 1981, a = -1/2, along i, j and k.
void sliceCubic(const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel, ImageView<std::uint8_t> out,
                SliceScratch& scratch);

/// The slicer of a quality. Zooming in (several pixels a voxel) with Quality::weave runs the paper's two interleaved stretches: rows of
/// voxel-sized samples are stretched as they are sampled, and blended downwards as soon as two of them are there. The direction along
/// which a pixel is not smaller than a voxel is not stretched. Pixels beside the volume's edge blend towards 0.
void slice(Quality quality, const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
           ImageView<std::uint8_t> out, SliceScratch& scratch);

/// The same within `spans` alone (one entry a row); other pixels of `out` are left as they are.
void slice(Quality quality, const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
           std::span<const std::vector<RowSpan>> spans, ImageView<std::uint8_t> out, SliceScratch& scratch);

/// The rows firstRow .. firstRow + rowCount - 1 alone: what the threads of a Bands do, each with a scratch of its own. Every pixel is the
/// one that the whole image has there.
void sliceBand(Quality quality, const SliceSource& source, const Transform<frame::Voxel, frame::Image>& imageToVoxel,
               std::span<const std::vector<RowSpan>> spans, int firstRow, int rowCount, ImageView<std::uint8_t> out, SliceScratch& scratch);

/// Samples along rows that need not lie in one plane (the scan lines of a probe), each from its own start with its own step. Nothing is
/// written outside the rows' spans. A row that is not finite or reaches beyond 2^30 voxels becomes 0.
void sampleRows(Quality quality, const SliceSource& source, std::span<const SampleRow> rows, ImageView<std::uint8_t> out,
                SliceScratch& scratch);

/// Pixel (x, y) of a width x height image lies at ((x - (width - 1) / 2) pixel_mm, y pixel_mm, 0) of the probe frame: the geometry of
/// `echoweave slice`.
[[nodiscard]] Transform<frame::Probe, frame::Image> sliceGeometry(int width, double pixel_mm);

}  // namespace ew
