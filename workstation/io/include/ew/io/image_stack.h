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

/// The images of a folder, or those beside a numbered image that differ from it in the number alone: .png, .jpg, .jpeg, .pgm, in the
/// order of their numbers.
/// @error notFound, notReadable, unsupported (no images)
[[nodiscard]] Result<std::vector<std::filesystem::path>> stackFiles(const std::filesystem::path& folderOrImage);

struct StackOptions {
  std::optional<glm::dvec3> spacing_mm;  ///< of pixels along x and y and of images along z; must be given
  ColourRule colour = ColourRule::ask;
  std::vector<PixelRect> blank;
};

struct StackVolume {
  Volume volume;
  Removed removed;
  std::vector<Message> notes;
};

/// One image of a stack, to look at.
struct StackImage {
  GreyImage level;
  std::vector<std::uint8_t> coloured;  ///< like level.pixels: 1 where the source is coloured; empty: nowhere
};
/// The first image of stackFiles(). @error as readImageStack, but for what the other images show
[[nodiscard]] Result<StackImage> readFirstOfStack(const std::filesystem::path& folderOrImage);

/// Reads a stack of equally large images as a volume: x to the right, y down, z from image to image.
/// @error as stackFiles; missingCalibration (no spacing), badField (images of different sizes), badHeader, tooLarge, unsupported (colours
///        and not told what to do), cancelled
[[nodiscard]] Result<StackVolume> readImageStack(const std::filesystem::path& folderOrImage, const StackOptions& options,
                                                 Progress& progress = noProgress(), const ReaderLimits& limits = {});

}  // namespace ew
