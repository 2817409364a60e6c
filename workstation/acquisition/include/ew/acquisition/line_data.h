#pragma once

#include <glm/glm.hpp>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"

namespace ew {

/// Where recorded scan lines lie, and the image they are meant to become. Names and meaning: io/gating_fields.h.
struct LineGeometry {
  bool curvilinear = true;
  double radiusStart_mm = 0.0;  ///< curvilinear: centre of the arc to the face
  double radiusStop_mm = 0.0;
  double theta_rad = 0.0;           ///< curvilinear: half of the opening; lines run from -theta to theta
  double imagingDepth_mm = 0.0;     ///< linear
  double transducerWidth_mm = 0.0;  ///< linear: between the outermost lines
  glm::ivec2 size_px{0};
  double pixel_mm = 0.0;
  glm::dvec2 face_px{0.0};  ///< the middle of the face
  bool operator==(const LineGeometry&) const = default;
};

/// Whether the rows of a sequence are scan lines (orientation FM, FU, NM, NU) rather than images.
[[nodiscard]] bool holdsScanLines(const Sequence& sequence);

/// The geometry that the recording itself states, else its device set.
/// @param device may be null
/// @error badField (a number that is missing or cannot be used, with its name), unsupported (lines to one side only, oblong pixels)
[[nodiscard]] Result<LineGeometry> lineGeometryOf(const Sequence& sequence, const DeviceSet* device);

/// The part of a converted image that holds echoes.
[[nodiscard]] Clip clipOf(const LineGeometry& geometry);

/// Turns scan lines of log-compressed brightness into images of orientation MF by bilinear scan conversion; poses and fields are kept.
/// The same pixels on any number of threads (0: all cores).
/// @error unsupported (RF or IQ data, images), badField (fewer than 2 lines or samples), tooLarge, cancelled
[[nodiscard]] Result<Sequence> convertLines(Sequence lines, const LineGeometry& geometry, int threads, Progress& progress,
                                            std::uint64_t maxBytes = kLargestVolume_bytes);

}  // namespace ew
