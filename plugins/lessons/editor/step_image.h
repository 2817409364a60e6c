#pragma once

#include <QByteArray>
#include <QImage>
#include <filesystem>
#include <string>

#include "ew/core/result.h"

namespace ew::lessons {

/// An image as a lesson keeps it: the pixels alone, at most 2048 along its longer side, upright; without what a camera or a program wrote
/// into the file about patient, place and time.
struct CleanImage {
  QByteArray bytes;
  std::string ending;  ///< ".png", or ".jpg" of what came as JPEG
};

/// @error notFound, notReadable, unsupported (neither PNG nor JPEG), tooLarge (more than 100 megapixels)
[[nodiscard]] Result<CleanImage> cleanImage(const std::filesystem::path& file);

}  // namespace ew::lessons
