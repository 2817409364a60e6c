#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "ew/core/result.h"
#include "image_header.h"

namespace ew::detail {

/// Sample bytes of a file from front to back, unpacked, in the file's byte order.
class ByteSource {
 public:
  virtual ~ByteSource();
  /// Fills the front of `into` and says how many bytes; fewer than asked for only at the end.
  /// @error notReadable (the medium, or a damaged compressed stream)
  [[nodiscard]] virtual Result<std::size_t> read(std::span<std::uint8_t> into) = 0;
};

struct OpenedBytes {
  std::unique_ptr<ByteSource> source;
  std::uint64_t packedBytes = 0;  ///< bytes of the file the samples are unpacked from
};

/// @param promisedBytes sample bytes the header promises; needed for samples that stand at the end of their file
[[nodiscard]] Result<OpenedBytes> openSamples(const ImageHeader& header, std::uint64_t promisedBytes);

}  // namespace ew::detail
