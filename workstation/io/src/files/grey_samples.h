#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/io/volume_file.h"
#include "files/image_header.h"

namespace ew::detail {

/// How many of the samples are wanted: `pixels` from the front of the `promised` the header speaks of.
struct SampleRequest {
  std::uint64_t pixels = 0;
  std::uint64_t promised = 0;
  Message what = say<"Reading">();
};

/// The samples as 8 bit grey levels: 8 bit unsigned ones as they are, colours as luminance, other types linearly from smallest..largest to
/// 0..255. What was decided is appended to `notes`, and what makes the result doubtful (samples that look like RF or IQ) to `warnings`,
/// too. Sizes are checked against the limits and the file before memory is taken.
/// @error truncated, tooLarge, badHeader (more samples than promised), notReadable, badField, unsupported (channels), cancelled
[[nodiscard]] Result<std::vector<std::uint8_t>> readGrey(const ImageHeader& header, const SampleRequest& request,
                                                         const ReaderLimits& limits, Progress& progress, std::vector<Message>& notes,
                                                         std::vector<Message>* warnings = nullptr);

/// Says in one sentence that the user stopped the reading or writing of `file`.
[[nodiscard]] tl::unexpected<Error> stopped(const std::filesystem::path& file);

}  // namespace ew::detail
