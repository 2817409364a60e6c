#pragma once

#include "dicom_pixels.h"
#include "ew/io/dicom.h"

namespace ew::detail {

/// One .png, .jpg, .jpeg or .pgm as grey levels. @error as readFirstOfStack
[[nodiscard]] Result<JpegGrey> readStackPicture(const std::filesystem::path& file, const Progress& progress);

/// What becomes of a stack's coloured pixels, told in `notes`. @param named the folder, for sentences @error unsupported (asked)
[[nodiscard]] Result<void> settleStackColours(std::uint64_t colouredPixels, std::uint64_t pixels, ColourRule rule,
                                              const std::filesystem::path& named, std::vector<Message>& notes);

}  // namespace ew::detail
