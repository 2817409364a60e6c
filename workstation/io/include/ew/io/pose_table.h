#pragma once

#include <filesystem>

#include "ew/core/result.h"
#include "ew/io/sequence.h"

namespace ew {

/// Reads poses over time from a table of text (.csv, .tsv, .txt), one moment a line, as a recording of poses without images.
///
/// The first line names the columns, in any order, and their units. Between columns stands a comma, a semicolon or a tab (then numbers
/// may have decimal commas); blank lines and lines that begin with # are skipped. Lines end with LF, CR LF or CR.
///  - time: `time_s`, `time_ms` or `time_us`; any zero, rising from line to line
///  - place: `x_mm, y_mm, z_mm` (or `x_m` ...) and a quaternion `qw, qx, qy, qz` of length 1
///  - or a matrix, m with row and column from 0: `m00 ... m22` and its last column `m03_mm, m13_mm, m23_mm` (or `_m`)
///  - `status`, if there is one: OK, or a pose that is not used (INVALID, MISSING), whose numbers may be anything; other words are refused
/// The poses are those of the frame Probe in the frame Tracker, unless a line `# transform: ImageToReference` says otherwise; a way from
/// Image may scale, as a matrix, any other is a rotation and a translation.
/// A pose whose numbers are all blank or NaN counts as missing. Other columns, and those that say in another unit what is
/// said, are named in the notes.
/// @error notFound, notReadable, tooLarge (above 64 MiB), badHeader (no UTF-8, no header line, blanks between columns, columns that are
///        missing, stand twice or say poses in two ways), badField (the line and what is wrong with it)
[[nodiscard]] Result<Sequence> readPoseTable(const std::filesystem::path& file);

}  // namespace ew
