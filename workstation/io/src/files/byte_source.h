#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "files/image_header.h"

namespace ew::detail {

/// Sample bytes of a file from front to back, unpacked, in the file's byte order.
class ByteSource {
 public:
  virtual ~ByteSource();
  /// Fills the front of `into` and says how many bytes; fewer than asked for only at the end.
  /// @error notReadable (the medium, or a damaged compressed stream)
  [[nodiscard]] virtual Result<std::size_t> read(std::span<std::uint8_t> into) = 0;
};

struct ByteStream {
  std::unique_ptr<ByteSource> source;
  std::uint64_t packedBytes = 0;  ///< bytes of the file the samples are unpacked from
};

/// Goes to the first sample; what lies before it in a packed stream is unpacked for that, as long as `progress` does not ask to stop.
/// @param promisedBytes sample bytes the header promises; needed for samples that stand at the end of their file
/// @error notReadable, truncated (too few bytes for what the header promises, as far as their number tells), unsupported, cancelled
[[nodiscard]] Result<ByteStream> openSamples(const ImageHeader& header, std::uint64_t promisedBytes, const Progress& progress);

/// Refuses before memory is taken what so few bytes cannot hold.
/// @param promisedSamples numbers, for samples written as text
/// @error truncated
[[nodiscard]] Result<void> checkAgainstFile(const ImageHeader& header, std::uint64_t promisedBytes, std::uint64_t promisedSamples,
                                            std::uint64_t packedBytes);

}  // namespace ew::detail
