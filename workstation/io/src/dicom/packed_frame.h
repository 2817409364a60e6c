#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dicom/dicom_dataset.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::detail {

/// What a packed image says about itself, before a codec sees it.
struct CodecHeader {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  int components = 0;
  int bits = 0;
  bool namesColours = false;  ///< JFIF or Adobe marker
  bool lumaChroma = false;    ///< as those markers say
  bool byPlanes = false;      ///< JPEG-LS: one scan a component
};

enum class Codec { jpeg, jpegLs, jpeg2000 };

/// Head of a JPEG, JPEG-LS or JPEG 2000 stream; empty when it is none that can be trusted to a decoder.
[[nodiscard]] std::optional<CodecHeader> packedHead(Codec codec, Bytes stream);

/// @error unsupported (the module with the decoders is missing)
[[nodiscard]] Result<void> unpackerThere();

/// Decoded samples in a process of its own, component after component of a pixel (or by planes, as head.byPlanes), each of `bits` in 1 or 2
/// bytes of the machine's order. Empty when the decoder refuses, takes longer than any image needs, or when `progress` asks to stop: look
/// there first. The stream's own size must be what `head` says.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpack(Codec codec, Bytes stream, const CodecHeader& head, int bitsAllocated,
                                                              int bitsStored, bool isSigned, const Progress& progress);

/// RLE of DICOM (PS3.5 annex G): `segments` byte planes of `planeSize` bytes each; empty when damaged.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpackRle(Bytes packed, std::size_t segments, std::size_t planeSize);

}  // namespace ew::detail
