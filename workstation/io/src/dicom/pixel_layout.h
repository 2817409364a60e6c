#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dicom/dicom_dataset.h"
#include "ew/io/volume_file.h"

namespace ew::detail {

inline constexpr DicomTag kPixelDataTag = 0x7FE00010u;

/// How the pixels of a DICOM file are stored, checked against each other and against the file.
struct PixelLayout {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  std::uint64_t frames = 1;
  int samples = 1;
  int bitsAllocated = 8;
  int bitsStored = 8;
  int highBit = 7;
  bool isSigned = false;
  bool planar = false;
  std::string photometric;
  std::string codec;           ///< "uncompressed", "JPEG" ...
  bool thinned = false;        ///< uncompressed colours that two neighbours of a row share
  std::vector<Message> notes;  ///< what the header leaves open or says wrongly, and what was passed over

  [[nodiscard]] std::uint64_t pixelsPerFrame() const { return rows * columns; }
  [[nodiscard]] std::uint64_t storedBytesPerFrame() const;  ///< uncompressed
  [[nodiscard]] bool beginsImage(Bytes fragment) const;     ///< packed: whether this fragment does
  [[nodiscard]] bool inColour() const { return samples == 3 || photometric == "PALETTE COLOR"; }
};

/// @error badField, unsupported (no pixels, a codec or a colour model that is not read), tooLarge, truncated
[[nodiscard]] Result<PixelLayout> pixelLayoutOf(const DicomFile& dicom, const ReaderLimits& limits);

}  // namespace ew::detail
