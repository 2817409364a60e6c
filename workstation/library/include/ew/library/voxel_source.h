#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "ew/acquisition/import.h"
#include "ew/core/pose.h"
#include "ew/imaging/display.h"

namespace ew {

/// A frame that went into a volume.
struct FrameProvenance {
  std::size_t number = 0;                                   ///< in the recording, from 0
  std::optional<double> time_s = {};                        ///< as recorded
  Transform<frame::World, frame::Image> imageToWorld = {};  ///< the volume's own world, before it is placed; pixels in orientation MF
};

/// Where each voxel of a volume came from: 2 bytes a voxel, the way every frame lies, and where the images can be read again.
struct Provenance {
  std::filesystem::path sweep;          ///< the recording
  SweepImportOptions options;           ///< how it was read
  Grid grid;                            ///< of the volume as it was reconstructed
  std::vector<std::uint16_t> source;    ///< voxelCount() values: 1 + index into `frames`, 0 for none
  std::vector<FrameProvenance> frames;  ///< in the order of the recording
  int width_px = 0;
  int height_px = 0;
  std::size_t recordedFrames = 0;  ///< with those that have no pose and are not in the volume
};

struct SweepReconstruction {
  SweepImport imported;  ///< its source has gone into the provenance
  Provenance provenance;
};

/// importSweep, and what is needed to find a voxel's frame again.
/// @param options those it was planned with, keepSource among them; @param sweep its file
/// @error as importSweep; tooLarge also for more than 65534 frames with a pose
[[nodiscard]] Result<SweepReconstruction> importTracedSweep(SweepInput opened, const std::filesystem::path& sweep,
                                                            const SweepImportOptions& options, Progress& progress);

/// What is known of a point of the image.
struct VoxelSource {
  enum class Found {
    frame,   ///< `frame`, `at_px` and `distance_mm` say which
    absent,  ///< no frame reached the voxel and nothing was filled in
    outside  ///< the point lies beside the volume
  };
  Found found = Found::outside;
  glm::ivec3 voxel{0};
  Coverage coverage = Coverage::absent;
  std::size_t frame = 0;            ///< index into Provenance::frames
  glm::dvec2 at_px{0.0};            ///< on that frame, orientation MF
  double distance_mm = 0.0;         ///< of the point from the frame's plane
  Point<frame::World> at_recorded;  ///< the point in the volume's own world
};

/// The point of the scan plane that a pixel of the image shows. Flips, zoom and size are in the geometry.
[[nodiscard]] Point<frame::World> pointShownAt(const DisplayGeometry& geometry, const Pose& pose, const glm::dvec2& pixel);

/// The source of the voxel nearest to a point.
/// @param volume     whose coverage says what was measured; of provenance.grid.dims
/// @param placedGrid where the volume lies now; of the same dims
[[nodiscard]] VoxelSource voxelSourceAt(const Provenance& provenance, const Volume& volume, const Grid& placedGrid,
                                        const Point<frame::World>& at);

/// The recording's images again, turned and converted as for the volume.
/// @error as openSweep; badField when the recording is no longer the one that the volume was made from
[[nodiscard]] Result<Sequence> readTracedImages(const Provenance& provenance, Progress& progress);

}  // namespace ew
