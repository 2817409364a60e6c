#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/volume_file.h"

namespace ew {

enum class RawType { u8, i8, u16, i16, u32, i32, f32, f64 };
[[nodiscard]] const char* nameOf(RawType type);
[[nodiscard]] std::uint64_t bytesOf(RawType type);

/// How samples without a header are stored: x fastest, then y, then z.
struct RawLayout {
  glm::ivec3 dims{0};
  RawType type = RawType::u8;
  bool bigEndian = false;
  glm::dvec3 spacing_mm{0.0};  ///< must be given, above 0
  std::uint64_t offset = 0;    ///< bytes before the samples
  glm::dmat3 directions{1.0};  ///< columns: unit vectors of x, y, z in LPS
  bool operator==(const RawLayout&) const = default;
};

/// "256x256x180:u8:0.5" or "256x256x180:i16be:0.5,0.5,1.2:512": dimensions, type (u8 i8 u16 i16 u32 i32 f32 f64, with le or be), spacing in
/// mm (one number or three) and the offset of the samples (0). @error badUsage
[[nodiscard]] Result<RawLayout> parseRawLayout(std::string_view text);
[[nodiscard]] std::string textOf(const RawLayout& layout);

/// Reads samples as the layout says. Whole files that are longer are read with a note; shorter ones are refused. The origin is the first
/// voxel, which a note says.
/// @error as readVolume; badUsage (a layout that cannot be)
[[nodiscard]] Result<VolumeReadResult> readRawVolume(const std::filesystem::path& file, const RawLayout& layout,
                                                     Progress& progress = noProgress(), const ReaderLimits& limits = {});

/// Layouts whose size fits the file exactly, the likelier first: types of 1, 2 and 4 bytes, usual header lengths, usual image sizes. To
/// be offered, never applied: their spacing is 0. @param most how many at most
[[nodiscard]] std::vector<RawLayout> guessRawLayouts(std::uint64_t fileBytes, std::size_t most = 12);

/// The three middle slices (x y, x z, y z) as grey images, reading no more than they need: for the third one a place of the file a
/// sample.
/// @error as readRawVolume; cancelled
struct RawPreview {
  std::vector<std::uint8_t> xy, xz, yz;
};
[[nodiscard]] Result<RawPreview> previewRawVolume(const std::filesystem::path& file, const RawLayout& layout,
                                                  Progress& progress = noProgress());

}  // namespace ew
