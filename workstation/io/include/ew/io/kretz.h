#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/deidentify.h"
#include "ew/io/volume_file.h"

namespace ew {

struct KretzOptions {
  double spacing_mm = 0.0;      ///< of the volume that is made; 0: the distance of samples along a beam
  bool mirrored = false;        ///< turn the elevational axis over: readers disagree about it, and the file does not tell
  std::optional<int> timeStep;  ///< from 1; needed when the file holds several volumes
  int threads = 0;              ///< 0: all cores; the voxels do not depend on it
};

struct KretzVolume {
  Volume volume;  ///< absent outside the scanned region
  Removed removed;
  std::vector<Message> notes;
};

/// Whether the file begins as GE Kretz files do.
[[nodiscard]] bool isKretz(const std::filesystem::path& file);

/// Reads an uncompressed GE Kretz volume (.vol, .v00), or one inside a private field of a DICOM file, and converts its beams to a regular
/// grid. A sample at radius r, beam angle theta and plane angle phi lies at
///   x = r sin(theta),  y = R (1 - cos(phi)) + r cos(theta) cos(phi),  z = (r cos(theta) - R) sin(phi),
/// x lateral, y away from the probe, z elevational, from the centre of the beams' arc; R is the depth of the axis the planes turn about.
/// Between samples it is interpolated linearly in r, theta and phi. Source: the published layout of the file (no standard exists).
/// @error notFound, notReadable, badHeader, badField, truncated, tooLarge, unsupported (wavelet compression, no B-mode volume),
///        missingCalibration (several volumes, none chosen), cancelled
[[nodiscard]] Result<KretzVolume> readKretz(const std::filesystem::path& file, const KretzOptions& options = {},
                                            Progress& progress = noProgress(), const ReaderLimits& limits = {});

}  // namespace ew
