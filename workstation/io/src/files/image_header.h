#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew::detail {

enum class SampleType { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64, none };
[[nodiscard]] std::uint64_t bytesOf(SampleType type);
[[nodiscard]] Message nameOf(SampleType type);

enum class Packing { raw, deflated, text };

using Fields = std::vector<std::pair<std::string, std::string>>;

/// What MetaImage, NRRD and NIfTI headers say, in one form: where the samples are, how they are stored and where they lie.
struct ImageHeader {
  std::filesystem::path file;                ///< the header's own file
  std::filesystem::path dataFile;            ///< where the samples are; may be the same
  std::uint64_t dataOffset = 0;              ///< bytes of the data file before the samples
  std::uint64_t skipUnpacked = 0;            ///< bytes to drop after unpacking
  bool dataAtEnd = false;                    ///< raw samples are the last bytes of the data file
  std::optional<std::uint64_t> packedBytes;  ///< bytes of the compressed stream, where the header says so
  Packing packing = Packing::raw;
  SampleType type = SampleType::u8;
  bool bigEndian = false;
  std::uint64_t channels = 1;                  ///< values stored side by side for each sample
  bool coloursNamed = false;                   ///< the header says that they are colours
  std::optional<std::uint64_t> wantedChannel;  ///< set: they are volumes woven into each other, sample by sample; which one is read, from 0
  std::vector<std::uint64_t> sizes;            ///< x fastest, without channels
  Grid geometry;                               ///< spacing, origin and directions (LPS); dims are in `sizes`
  bool hasGeometry = false;                    ///< spacing or place differ from 1 x 1 x 1 mm at the origin, and their unit is known
  Message spacingProblem;                      ///< why the spacing is not known although the file states one, or a place; empty otherwise
  std::vector<std::string> kinds;              ///< of the axes in `sizes`; empty when the file says nothing
  double slope = 1.0;                          ///< value = slope * stored + intercept
  double intercept = 0.0;
  Fields fields;           ///< everything that is not about storage and place, in file order
  bool endsEarly = false;  ///< the last lines are missing, or a part of one
  std::vector<Message> notes;
};

/// @error notFound, notReadable, badHeader, badField, truncated, tooLarge, unsupported
[[nodiscard]] Result<ImageHeader> readImageHeader(const std::filesystem::path& file);
/// @param mayEndEarly of a file without samples: whether a header that breaks off is taken as far as it goes
[[nodiscard]] Result<ImageHeader> readMetaHeader(const std::filesystem::path& file, bool mayEndEarly = false);
[[nodiscard]] Result<ImageHeader> readNrrdHeader(const std::filesystem::path& file);
[[nodiscard]] Result<ImageHeader> readNiftiHeader(const std::filesystem::path& file);

/// Whether the samples are frames of a recording. `Kinds` decides; a list without any per-frame field that has a place in the world is a
/// volume all the same, because reconstructions with the sequence's `Kinds` left in them exist.
[[nodiscard]] bool describesSequence(const ImageHeader& header);

/// Whether `key` is "Seq_Frame<number>_<name>"; then `frame` and `name` say which.
struct FrameKey {
  std::uint64_t frame = 0;
  std::string_view name;
};
[[nodiscard]] std::optional<FrameKey> frameKey(std::string_view key);

/// The product, or empty when it does not fit 64 bits.
[[nodiscard]] std::optional<std::uint64_t> productOf(std::span<const std::uint64_t> factors);
[[nodiscard]] Message countText(std::optional<std::uint64_t> count);
/// One of two texts by the count, which stands at %1 of both: `counted<"%1 frame is black.", "%1 frames are black.">(frames)`.
template <Literal one, Literal many, class... More>
[[nodiscard]] Message counted(std::uint64_t count, const More&... more) {
  return count == 1 ? say<one>(count, more...) : say<many>(count, more...);
}
[[nodiscard]] std::string sizesText(std::span<const std::uint64_t> sizes);

[[nodiscard]] Message quoted(const std::filesystem::path& file);
/// What a file holds, for a sentence: its beginning, in letters that can be shown.
[[nodiscard]] std::string shortened(const std::string& found);
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string lowerCase(std::string_view text);
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view text);

/// From which sides the three axes come, as MetaImage's AnatomicalOrientation says it: "RAI" of axes to the left, posterior and superior.
/// Empty where an axis lies along none of the body's.
[[nodiscard]] std::string anatomicalOrientation(const glm::dmat3& directions);

/// Millimetres in a unit of length by its name or sign ("mm", "cm", "um", "microns" ...), whatever its case; 1 for an empty one, which says
/// nothing. Empty: no unit of length.
[[nodiscard]] std::optional<double> lengthUnit_mm(std::string_view unit);

/// Why a spacing in such a unit is not known.
[[nodiscard]] Message unknownUnit(const std::filesystem::path& file, std::string_view unit);

/// Success when the file is there and is a regular file.
[[nodiscard]] Result<void> checkIsFile(const std::filesystem::path& file);

/// The samples' file named in a header: relative to the header, there, and a regular file.
[[nodiscard]] Result<std::filesystem::path> resolveDataFile(const std::filesystem::path& header, std::string_view name);

/// A field that cannot be used: its name, what was found and what was expected.
/// @param field, found a name and a value as the file has them are verbatim(); such a value is shortened()
[[nodiscard]] tl::unexpected<Error> badField(const std::filesystem::path& file, const Message& field, const Message& found,
                                             const Message& expected);

/// A third direction and spacing for flat images, and whether the place is anything but neutral.
void completeGeometry(ImageHeader& header);

/// Says in `spacingProblem` along which axes the file states no spacing, so that the 1 mm there is nobody's. Nothing is said where a unit
/// is the problem already, or where the file says nothing about its place at all, which completeGeometry() knows.
void noteUnstatedSpacing(ImageHeader& header, const std::array<bool, 3>& stated);

}  // namespace ew::detail
