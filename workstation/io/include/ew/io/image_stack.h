#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/deidentify.h"
#include "ew/io/dicom.h"
#include "ew/io/volume_file.h"

namespace ew {

/// The pictures of a folder, or those beside a numbered picture that differ from it in the number alone: .png, .jpg, .jpeg, .pgm, in the
/// order of their numbers.
/// @error notFound, notReadable, unsupported (no pictures)
[[nodiscard]] Result<std::vector<std::filesystem::path>> stackFiles(const std::filesystem::path& folderOrPicture);

struct StackOptions {
  std::optional<glm::dvec3> spacing_mm;  ///< of pixels along x and y and of pictures along z; must be given
  ColourRule colour = ColourRule::ask;
  std::vector<PixelRect> blank;
};

struct StackVolume {
  Volume volume;
  Removed removed;
  std::vector<Message> notes;
};

/// One picture of a stack, to look at.
struct StackPicture {
  GreyImage level;
  std::vector<std::uint8_t> coloured;  ///< like level.pixels: 1 where the source is coloured; empty: nowhere
};
/// The first picture of stackFiles(). @error as readImageStack, but for what the other pictures show
[[nodiscard]] Result<StackPicture> readFirstOfStack(const std::filesystem::path& folderOrPicture);

/// Reads a stack of equally large pictures as a volume: x to the right, y down, z from picture to picture.
/// @error as stackFiles; missingCalibration (no spacing), badField (pictures of different sizes), badHeader, tooLarge, unsupported (colours
///        and not told what to do), cancelled
[[nodiscard]] Result<StackVolume> readImageStack(const std::filesystem::path& folderOrPicture, const StackOptions& options,
                                                 Progress& progress = noProgress(), const ReadLimits& limits = {});

}  // namespace ew
