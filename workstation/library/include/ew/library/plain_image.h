#pragma once

#include <string>

#include "ew/core/result.h"

namespace ew {

/// An image as it looks, pixel for pixel, and nothing else: no texts, dates, names, thumbnails, nor anything behind its end. Of a PNG the
/// chunks that make the image are kept, of a JPEG the segments.
/// @param ending becomes ".png" or ".jpg"
/// @error badHeader (damaged), unsupported (another kind of image); without the name of a file
[[nodiscard]] Result<std::string> plainImage(const std::string& bytes, std::string& ending);

}  // namespace ew
