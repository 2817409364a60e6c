#pragma once

#include "dicom/dicom_pixels.h"
#include "ew/io/dicom.h"

namespace ew::detail {

/// One .png, .jpg, .jpeg or .pgm as grey levels. @error as readFirstOfStack
[[nodiscard]] Result<JpegGrey> readStackImage(const std::filesystem::path& file, const Progress& progress);

/// How much wider than high the pixels of such an image are, seen upright as it is read; 1 where it does not say.
[[nodiscard]] double pixelAspectOfImage(const std::filesystem::path& file);

/// What becomes of a stack's coloured pixels, told in `notes`. @param named the folder, for sentences @error unsupported (asked)
[[nodiscard]] Result<void> settleStackColours(std::uint64_t colouredPixels, std::uint64_t pixels, ColourRule rule,
                                              const std::filesystem::path& named, std::vector<Message>& notes);

}  // namespace ew::detail
