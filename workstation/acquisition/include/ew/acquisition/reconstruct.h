#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/compounding.h"
#include "ew/core/image.h"
#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// How holes are filled; both only between what was measured, at most `fillReach_mm` apart.
/// bridges: between measured voxels along 13 directions (fill_holes.h).
/// sweep:   first between successive frames, along the way the probe took: a voxel between their planes has a place in the image, (1 - t)
/// of
///          its projection on the one and t of that on the other, t being the distance from the first plane over the sum of both. It takes
///          (1 - t) of the one frame there and t of the other, read over an area as large as a voxel. Its ends are the two points of the
///          frames at that place; both must lie in the clip. Several such pairs are averaged by 1 / distance^2 of their ends. What is then
///          left is bridged. Frames that follow each other at more than a right angle are not joined. Source: Coupe et al., "3D freehand
///          ultrasound reconstruction based on probe trajectory", MICCAI 2005, section 2: the probe trajectory method. Ours differs: place
///          and t come from the two projections in closed form, exact for shifted frames and within angle^2 / 8 of the radius for turned
///          ones, and measured voxels keep what was pasted.
enum class FillMethod { bridges, sweep };

/// Which pixels of a frame are image: a rectangle, and within it optionally a fan. Pixel coordinates, centres at integers.
struct ClipFan {
  glm::dvec2 origin_px{0.0};   ///< apex of the sector angles
  double leftAngle_rad = 0.0;  ///< atan2(x, y) from the downward axis; either order
  double rightAngle_rad = 0.0;
  double startRadius_px = 0.0;
  double stopRadius_px = 0.0;
  bool operator==(const ClipFan&) const = default;
};
struct Clip {
  glm::dvec2 origin_px{0.0};
  std::optional<glm::dvec2> size_px = {};  ///< absent: the whole frame
  std::optional<ClipFan> fan = {};
  bool operator==(const Clip&) const = default;
};

struct ReconstructOptions {
  double spacing_mm = 0.5;
  Interpolation interpolation = Interpolation::linear;
  Compounding compounding = Compounding::mean;
  double fillReach_mm = 0.0;  ///< holes between measured ends at most this far apart are filled and marked interpolated; 0: none
  FillMethod fillMethod = FillMethod::sweep;
  Clip clip = {};
  int threads = 0;           ///< 0: all cores; the voxels do not depend on it
  bool keepWeights = false;  ///< also return each voxel's weight; compounding mean and weighted only
  bool keepSource = false;   ///< also return which frame each voxel came from: 2 bytes a voxel more; at most 65534 frames
  std::uint64_t maxBytes = kLargestVolume_bytes;
};

/// One frame of a sweep with its way into the world: (height x width) pixels.
struct TrackedFrame {
  ImageView<const std::uint8_t> pixels;
  Transform<frame::World, frame::Image> imageToWorld;  ///< affine, mm per pixel included
  ImageView<const std::uint8_t> weights = {};          ///< as large as `pixels`, 0 to 255 for 0 to 1: confidence; no data: all are 1
};

struct ReconstructResult {
  Volume volume;               ///< with coverage
  std::vector<float> weights;  ///< with keepWeights: pixels that went into each voxel, before hole filling; else empty
  /// With keepSource: 1 + the number of the frame a voxel came from, 0 for none; else empty. A measured voxel's is the frame of the pixel
  /// nearest to its centre, the earlier of two; a filled one's the nearer of the two frames it was read from, or that of the nearer end of
  /// its shortest bridge.
  std::vector<std::uint16_t> source;
  std::size_t framesUsed = 0;
  std::size_t pixelsPasted = 0;  ///< clipped pixels of all frames
  std::size_t measuredVoxels = 0;
  std::size_t interpolatedVoxels = 0;
  double pasteSeconds = 0.0;
  double fillSeconds = 0.0;
};

/// Bytes the reconstruction will need at its peak beside the frames, for the forecast shown before it starts: the volume and its coverage
/// (2 bytes a voxel), weights (4) and sources (2) when they are kept, the hole filling's marks (2 bits a voxel) and the sums of the bricks
/// in work.
[[nodiscard]] std::uint64_t forecastBytes(const Grid& grid, const ReconstructOptions& options);

/// The grid that holds every clipped pixel: aligned with the world, origin at the smallest corner coordinate over all frames, samples per
/// axis = round((largest - smallest) / spacing) + 1.
/// Frames are of one size; their matrices may be mirrored, oblique or sheared.
/// @error noValidPose (no frames), tooLarge (with the forecast), badField (spacing, threads, reach, clip outside the frame, frames of
///        different sizes, weights of another size, a matrix that is not affine, not finite or maps the image onto a line or point)
[[nodiscard]] Result<Grid> gridFor(std::span<const TrackedFrame> frames, const ReconstructOptions& options);

/// Pastes every clipped pixel of every frame into the volume, compounds, fills holes of bounded reach and says per voxel which is which.
/// Pixel positions are stepped along a row with 40 bits after the point: after 10^5 pixels they are off by less than 1e-7 voxel.
/// Sums are exact for nearest (64 bit integers) and of doubles for linear, each rounded once at the end. The volume is worked on in bricks,
/// each by one thread in the order of frames, rows and columns, so the voxels are the same however many threads there are.
/// @error as gridFor, cancelled; tooLarge also when 2^28 pixels or more fall into one voxel
[[nodiscard]] Result<ReconstructResult> reconstruct(std::span<const TrackedFrame> frames, const ReconstructOptions& options,
                                                    Progress& progress);

/// As reconstruct, onto a grid that the caller chose, so that volumes of several sets of frames can be compared voxel by voxel.
/// @param grid as gridFor gives it for these frames or for a set that contains them
/// @error as reconstruct; badField (a grid that is oblique, is not of options.spacing_mm, or does not hold every clipped pixel)
[[nodiscard]] Result<ReconstructResult> reconstructOnto(const Grid& grid, std::span<const TrackedFrame> frames,
                                                        const ReconstructOptions& options, Progress& progress);

/// A point as one frame sees it.
struct FrameProjection {
  glm::dvec2 at_px{0.0};     ///< along the frame's normal; may lie outside the image
  double distance_mm = 0.0;  ///< of the point from the frame's plane
};

/// @param imageToWorld affine, its first two columns not parallel
[[nodiscard]] FrameProjection projectionOnto(const Transform<frame::World, frame::Image>& imageToWorld, const Point<frame::World>& at);

/// Where in the sweep a point of the volume came from.
struct SourceFrame {
  std::size_t frame = 0;     ///< index into the frames that were reconstructed
  glm::dvec2 at_px{0.0};     ///< the point's projection onto that frame
  double distance_mm = 0.0;  ///< of the point from the frame's plane
};

/// The source of the voxel nearest to a point, as a click in the volume asks for it; nothing outside the grid and for absent voxels.
/// @param source as ReconstructResult::source, voxelCount() values
[[nodiscard]] std::optional<SourceFrame> sourceFrameAt(const Grid& grid, std::span<const std::uint16_t> source,
                                                       std::span<const TrackedFrame> frames, const Point<frame::World>& at);

}  // namespace ew
