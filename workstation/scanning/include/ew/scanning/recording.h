#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/scanning/events.h"

namespace ew {

inline constexpr int kRecordingFormat = 1;

/// A scan that can be seen again, image for image: what was scanned by name, and everything that decided the images.
struct ScanRecording {
  std::string caseId;            ///< of the case that was scanned; empty: a volume without a case
  std::string title;             ///< of what was scanned, as a trainee may read it
  glm::ivec2 size_px{640, 480};  ///< of the images
  ScanLog log;                   ///< at least one frame
  std::vector<Message> notes;    ///< what reading it had to decide, in sentences; not saved
};

/// Writes a sequence metafile without images (.seq.mha, .igs.mha, .mha), which PLUS and 3D Slicer read as a sequence of transforms: of each
/// frame the ProbeToWorldTransform in mm (LPS), its status and its Timestamp in seconds. What only this program knows stands in fields of
/// their own, which other programs keep: the format in EchoWeaveRecording, the image's number, the gaps to the skin and, of a body that
/// is not at rest, breath, pulse and bowel (BodyState); and in Events what happened since the frame before. Lines stay below the 1000
/// characters that those readers take. Complete or not at all.
/// @error notWritable, unsupported (ending), badField (no frame)
[[nodiscard]] Result<void> writeRecording(const ScanRecording& recording, const std::filesystem::path& file,
                                          Progress& progress = noProgress());

/// Reads what writeRecording wrote. A file whose end is missing gives the frames that are whole, and a note.
/// @error notFound, notReadable, badHeader, badField (field, value found, value expected), truncated, tooLarge, cancelled, newerFormat,
///        unsupported (a sequence that is no recording of a scan)
[[nodiscard]] Result<ScanRecording> readRecording(const std::filesystem::path& file, Progress& progress = noProgress());

/// Whether a file is a recording of a scan, by its header. @error as readRecording
[[nodiscard]] Result<bool> isRecording(const std::filesystem::path& file);

}  // namespace ew
