#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew {

/// "x,y,width,height". @error badUsage
[[nodiscard]] Result<PixelRect> parsePixelRect(std::string_view text);

/// What an import left behind, by name and never by value.
struct Removed {
  std::vector<Message> fields;            ///< "(0010,0010) Patient's Name" ...; what was there and can name a person, a place or a time
  std::uint64_t privateFields = 0;        ///< fields of makers, dropped whatever they hold
  std::vector<PixelRect> blankedOutside;  ///< what was kept of each image; everything around it was cut away
  std::vector<PixelRect> blanked;         ///< rectangles the user named, made black
  std::uint64_t pixelsPerFrame = 0;       ///< cut away or blanked, of each frame
  bool operator==(const Removed&) const = default;
  [[nodiscard]] bool nothing() const { return fields.empty() && privateFields == 0 && pixelsPerFrame == 0; }
};

/// The report as sentences for a person.
[[nodiscard]] std::vector<Message> sentencesOf(const Removed& removed);

/// Makes the rectangles black in every frame of (frames x height x width) pixels; parts outside the image are ignored.
/// @return pixels of one frame that were made black
std::uint64_t blank(std::span<std::uint8_t> pixels, int width, int height, std::span<const PixelRect> rects);

}  // namespace ew
