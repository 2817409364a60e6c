#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ew {

/// How a stored image becomes one that is seen upright: turned clockwise, then mirrored left to right.
struct Orientation {
  int quarterTurns = 0;  ///< clockwise, 0 to 3
  bool mirrored = false;

  [[nodiscard]] bool isUpright() const { return quarterTurns == 0 && !mirrored; }
  [[nodiscard]] bool swapsSides() const { return quarterTurns % 2 != 0; }
  [[nodiscard]] int degrees() const { return 90 * quarterTurns; }  ///< clockwise
  bool operator==(const Orientation&) const = default;
};

/// First one, then the other.
[[nodiscard]] Orientation then(const Orientation& first, const Orientation& second);

/// The tag 274 of TIFF and Exif: 1 to 8. Empty: there is no such orientation.
[[nodiscard]] std::optional<Orientation> orientationOfTag(int tag);

/// A matrix that takes stored pixels (x right, y down) to shown ones: x' = a x + c y, y' = b x + d y, in any scale. Empty: it turns by an
/// angle in between or is none.
[[nodiscard]] std::optional<Orientation> orientationOfMatrix(double a, double b, double c, double d);

/// The orientation that Exif data state: a TIFF header with its first directory. Upright where they state none, or cannot be read.
[[nodiscard]] Orientation orientationOfExif(std::span<const std::uint8_t> tiff);
/// The same of a JPEG (APP1) or PNG (eXIf) file's bytes.
[[nodiscard]] Orientation orientationOfImage(std::span<const std::uint8_t> file);

/// Pixels as stored, row after row, put upright. @param width, height as stored, @param upright becomes as large
template <class T>
void putUpright(const std::vector<T>& stored, int width, int height, const Orientation& orientation, std::vector<T>& upright) {
  const int across = orientation.swapsSides() ? height : width, down = orientation.swapsSides() ? width : height;
  upright.resize(stored.size());
  // One step to the right in the upright image is so many to the right and down in the stored one, by its turns; one step down likewise.
  constexpr std::ptrdiff_t rightX[] = {1, 0, -1, 0}, rightY[] = {0, -1, 0, 1}, downX[] = {0, 1, 0, -1}, downY[] = {1, 0, -1, 0};
  const int turns = orientation.quarterTurns;
  const std::ptrdiff_t firstX = turns == 2 || turns == 3 ? width - 1 : 0, firstY = turns == 1 || turns == 2 ? height - 1 : 0;
  std::ptrdiff_t stepX = rightY[turns] * width + rightX[turns];
  const std::ptrdiff_t stepY = downY[turns] * width + downX[turns];
  std::ptrdiff_t first = firstY * width + firstX;
  if (orientation.mirrored) {
    first += stepX * (across - 1);
    stepX = -stepX;
  }
  auto to = upright.begin();
  for (int y = 0; y < down; ++y) {
    const T* from = stored.data() + first + y * stepY;
    for (int x = 0; x < across; ++x, from += stepX) *to++ = *from;
  }
}

}  // namespace ew
