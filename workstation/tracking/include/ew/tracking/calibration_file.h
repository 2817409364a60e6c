#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/tracking/tracker_calibration.h"

namespace ew {

// Calibrations lie in FOLDER/SOURCE.TOOL/rNNNN.json (the user's library has the folder trackers/calibrations): a revision is written once
// and stays.

/// @error notFound, notReadable, badHeader (not JSON), newerFormat, badField, notRigid
[[nodiscard]] Result<TrackerCalibration> readCalibration(const std::filesystem::path& file);

/// Where calibrations of a tracker's tool lie; names are made fit for files.
[[nodiscard]] std::filesystem::path calibrationFolder(const std::filesystem::path& root, const std::string& source,
                                                      const std::string& tool);

/// The newest revision; revision 0 (nothing was calibrated) when there is none.
/// @error as readCalibration: the newest one cannot be read
[[nodiscard]] Result<TrackerCalibration> latestCalibration(const std::filesystem::path& root, const std::string& source,
                                                           const std::string& tool);

/// Writes a new revision, whatever number the calibration has; the older ones stay.
/// @return as it was written, with its revision
/// @error notWritable; notRigid, badField: what readCalibration would refuse
[[nodiscard]] Result<TrackerCalibration> keepCalibration(const std::filesystem::path& root, TrackerCalibration calibration);

/// Files of all revisions, oldest first.
[[nodiscard]] std::vector<std::filesystem::path> calibrationRevisions(const std::filesystem::path& root, const std::string& source,
                                                                      const std::string& tool);

}  // namespace ew
