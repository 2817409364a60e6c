#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "ew/io/dicom.h"
#include "ew/io/image_stack.h"

namespace ew {

/// The DICOM files with images of a folder, whatever their endings, in the order of their names; empty where there are none.
[[nodiscard]] std::vector<std::filesystem::path> dicomFilesIn(const std::filesystem::path& folder);

struct DicomStackOptions {
  ColourRule colour = ColourRule::ask;
  std::vector<PixelRect> blank;
  bool keepText = false;
  bool acceptsSmall = false;  ///< a volume is made also when stills are missing between others that lie evenly
};

/// Reads a volume that is stored as one still a slice: joined by Image Position and Orientation (Patient) into the patient's mm (LPS),
/// whatever the names of the files. Files that seem to be stills and hold no DICOM data are named in a note. Levels deeper than 8 bits are
/// mapped alike in all stills.
/// @error notFound, unsupported (a cine among them, stills of several series, stills that do not say where they lie, planes that are no
/// regular
///        grid, coloured or with burned-in text and not told what to do: asked; stills are missing: "ask": "accept-small"), badField,
///        tooLarge, and as readDicomCine of one file
[[nodiscard]] Result<StackVolume> readDicomStack(const std::filesystem::path& folder, const DicomStackOptions& options = {},
                                                 Progress& progress = noProgress(), const ReaderLimits& limits = {});

/// One of the stills, to look at, with all its text; the spacing where the stills say it.
struct DicomStackImage {
  GreyImage level;
  std::optional<glm::dvec3> spacing_mm;
};
/// @error as readDicomStack
[[nodiscard]] Result<DicomStackImage> readFirstOfDicomStack(const std::filesystem::path& folder, Progress& progress = noProgress(),
                                                            const ReaderLimits& limits = {});

}  // namespace ew
