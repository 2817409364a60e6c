#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::detail {

using DicomTag = std::uint32_t;  ///< group in the upper, element in the lower 16 bits
using Bytes = std::span<const std::uint8_t>;

struct DicomItem;

/// One data element: its bytes stay in the file's buffer.
struct DicomElement {
  DicomTag tag = 0;
  std::array<char, 2> kind{'U', 'N'};  ///< value representation; "UN" where the file does not say and it does not matter
  Bytes value;
  std::vector<DicomItem> items;  ///< of a sequence
  std::vector<Bytes> fragments;  ///< of encapsulated pixels; the first is the offset table
};

/// Elements of a data set or of an item of a sequence, in file order.
struct DicomItem {
  std::vector<DicomElement> elements;
  bool bigEndian = false;

  [[nodiscard]] const DicomElement* find(DicomTag tag) const;
  /// Items of a sequence; none when it is not there.
  [[nodiscard]] std::span<const DicomItem> items(DicomTag tag) const;
  /// Without the padding at its ends; empty when it is not there.
  [[nodiscard]] std::string text(DicomTag tag) const;
  /// Whether a text of numbers has commas where the standard wants points ("0,5"); they are read as points.
  [[nodiscard]] bool hasDecimalCommas(DicomTag tag) const;
  /// Values of a text of numbers ("0.5\\0.5"), or of binary 16 bit unsigned, 32 bit and double values by their kind; those that cannot be
  /// read are left out with all after them.
  [[nodiscard]] std::vector<double> numbers(DicomTag tag) const;
  [[nodiscard]] std::optional<double> number(DicomTag tag) const;
  /// A whole number >= 0, or empty.
  [[nodiscard]] std::optional<std::uint64_t> count(DicomTag tag) const;
};

/// A whole DICOM file in memory.
struct DicomFile {
  std::filesystem::path file;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> inflated;  ///< the data set of a deflated file
  DicomItem meta;
  DicomItem data;
  std::string transferSyntax;
  std::vector<Message> notes;  ///< what was passed over, in sentences
};

/// @error notFound, notReadable, tooLarge
[[nodiscard]] Result<std::vector<std::uint8_t>> readWholeFile(const std::filesystem::path& file, std::uint64_t maxBytes);

/// Whether the file begins as DICOM does: preamble and "DICM", or the first elements of group 2 or 8 in little endian without them.
[[nodiscard]] bool looksLikeDicom(Bytes beginning);

/// Reads and takes apart a file without trusting one of its lengths: every element lies inside its parent, nesting and counts are bounded.
/// Bytes behind the pixels that are no element (padding, zeros, a line break), and an end mark of the pixels that is missing or overwritten
/// with zeros, cost nothing: they are passed over with a note. So does a last byte that is missing where it can be padding.
/// @param maxBytes of the file, and of what a deflated one becomes
/// @error notFound, notReadable, tooLarge, badHeader (no DICOM, or lengths that contradict each other), truncated, unsupported
[[nodiscard]] Result<DicomFile> readDicomFile(const std::filesystem::path& file, std::uint64_t maxBytes,
                                              const Progress& progress = noProgress());

}  // namespace ew::detail
