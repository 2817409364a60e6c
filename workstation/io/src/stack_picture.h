#pragma once

#include "dicom_pixels.h"

namespace ew::detail {

/// One .png, .jpg, .jpeg or .pgm as grey levels. @error as readFirstOfStack
[[nodiscard]] Result<JpegGrey> readStackPicture(const std::filesystem::path& file, const Progress& progress);

}  // namespace ew::detail
