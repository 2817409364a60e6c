#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// What a reader may take from an untrusted file; sizes are checked before memory is taken.
struct ReaderLimits {
  std::uint64_t maxBytes = kLargestVolume_bytes;  ///< of samples in memory
};

/// A volume as read, with what the reader had to decide, in sentences for the user ("Spacing is 1 x 1 x 1 with …: treat as unknown").
struct VolumeReadResult {
  Volume volume;
  std::vector<Message> notes;
  std::vector<Message> warnings = {};  ///< of the notes, those that make the result doubtful: samples that look like RF or IQ
  bool spacingKnown = true;            ///< false: 1 x 1 x 1 mm at 0 without rotation, which converters write when they know no better
  Message spacingProblem = {};  ///< why the spacing is not known although the file states one (a unit that is none); then it is not known
  std::uint64_t timeSteps = 1;  ///< volumes one after the other in the file
};

struct VolumeReadOptions {
  std::uint64_t timeStep = 1;  ///< which of several volumes in the file, from 1
};

/// Reads .mha, .mhd (+ raw), .nrrd, .nhdr, .nii, .nii.gz into 8 bit echo levels with LPS directions. Other sample types are mapped
/// linearly from their smallest..largest value to 0..255, and a note says so.
/// @error notFound, notReadable, badHeader, badField (name, found, expected), truncated, tooLarge, unsupported, emptyVolume, cancelled,
///        badUsage (a time step that is not there)
[[nodiscard]] Result<VolumeReadResult> readVolume(const std::filesystem::path& file, Progress& progress = noProgress(),
                                                  const ReaderLimits& limits = {}, const VolumeReadOptions& options = {});

/// What a file promises, from its header alone.
struct VolumeHeader {
  bool sequence = false;                     ///< frames of a recording, no volume; then `grid` says nothing
  Grid grid;                                 ///< of a volume
  std::vector<std::filesystem::path> files;  ///< the header's own file and, where it is another, that of the samples
};
/// @error as readVolume, but for what only the samples show
[[nodiscard]] Result<VolumeHeader> readVolumeHeader(const std::filesystem::path& file);

/// Reads a volume of labels: each sample stands for itself, so nothing but one 8 bit unsigned value a voxel is taken.
/// @error as readVolume; unsupported (another sample type, colours, a header that rescales)
[[nodiscard]] Result<VolumeReadResult> readLabelVolume(const std::filesystem::path& file, Progress& progress = noProgress(),
                                                       const ReaderLimits& limits = {});

struct WriteOptions {
  bool compress = true;  ///< .mha only; a .mhd + .raw is never compressed, so that it can be mapped
};

/// Writes .mha or .mhd + .raw, aside first and renamed when complete: a failure leaves what was there before.
/// Coverage goes to a file of its own: `writeCoverage`.
/// @error notWritable, unsupported (ending), emptyVolume, cancelled
[[nodiscard]] Result<void> writeVolume(const Volume& volume, const std::filesystem::path& file, Progress& progress = noProgress(),
                                       const WriteOptions& options = {});

/// The coverage of a volume (0 absent, 1 interpolated, 2 measured) as a volume file of the same grid; and back.
[[nodiscard]] Result<void> writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress = noProgress(),
                                         const WriteOptions& options = {});
[[nodiscard]] Result<void> readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress& progress = noProgress());

/// How far each voxel of a volume may be trusted, 0 to 255 for 0 to 1, as a volume file of the same grid; and back.
/// @param confidence voxelCount() values
/// @error as writeVolume; as readVolume, unsupported (samples that are not of 8 bits), badField (another grid)
[[nodiscard]] Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const std::filesystem::path& file,
                                           Progress& progress = noProgress(), const WriteOptions& options = {});
[[nodiscard]] Result<std::vector<std::uint8_t>> readConfidence(const Grid& grid, const std::filesystem::path& file,
                                                               Progress& progress = noProgress());

/// Which frame each voxel came from, as a volume file of 16 bit samples on the volume's grid: 1 + the frame's number, 0 for none.
/// @param sources voxelCount() values
/// @error as writeVolume
[[nodiscard]] Result<void> writeSources(const Grid& grid, std::span<const std::uint16_t> sources, const std::filesystem::path& file,
                                        Progress& progress = noProgress(), const WriteOptions& options = {});

}  // namespace ew
