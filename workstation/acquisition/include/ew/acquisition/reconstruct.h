#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

enum class Interpolation { nearest, linear };
enum class Compounding { mean, maximum, latest };

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
  std::optional<glm::dvec2> size_px;  ///< absent: the whole frame
  std::optional<ClipFan> fan;
  bool operator==(const Clip&) const = default;
};

struct ReconstructOptions {
  double spacing_mm = 0.5;
  Interpolation interpolation = Interpolation::linear;
  Compounding compounding = Compounding::mean;
  int fillReach_voxels = 0;  ///< holes at most this far between measured voxels are filled; 0: none
  Clip clip;
  int threads = 0;  ///< 0: all cores; the voxels do not depend on it
  std::uint64_t maxBytes = 16ull << 30;
};

/// One frame of a sweep with its way into the world: (height x width) pixels.
struct PosedFrame {
  ImageView<const std::uint8_t> pixels;
  Transform<frame::World, frame::Image> imageToWorld;  ///< affine, mm per pixel included
};

struct ReconstructResult {
  Volume volume;  ///< with coverage
  std::size_t framesUsed = 0;
  std::size_t pixelsPasted = 0;
  std::size_t measuredVoxels = 0;
  std::size_t interpolatedVoxels = 0;
  double pasteSeconds = 0.0;
  double fillSeconds = 0.0;
};

/// Bytes the reconstruction will need at its peak, for the forecast shown before it starts.
[[nodiscard]] std::uint64_t forecastBytes(const Grid& grid, const ReconstructOptions& options);

/// The grid that holds every clipped pixel: aligned with the world, origin at the smallest corner coordinate over all frames, samples per
/// axis = round((largest - smallest) / spacing) + 1.
/// @error noValidPose (no frames), tooLarge (with the forecast), badField (spacing, clip outside the frame)
[[nodiscard]] Result<Grid> gridFor(std::span<const PosedFrame> frames, const ReconstructOptions& options);

/// Pastes every clipped pixel of every frame into the volume, compounds, fills holes of bounded reach and says per voxel which is which.
/// Sums are exact (64 bit for nearest), rounded once at the end.
/// @error as gridFor, cancelled
[[nodiscard]] Result<ReconstructResult> reconstruct(std::span<const PosedFrame> frames, const ReconstructOptions& options,
                                                    Progress& progress);

}  // namespace ew
