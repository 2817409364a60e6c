#include "ew/io/deidentify.h"

#include <algorithm>

#include "ew/core/numbers.h"

namespace ew {

Result<PixelRect> parsePixelRect(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  const auto numbers = parseIntegers(spaced);
  const auto usable = [](long long value) { return value >= 0 && value <= 1'000'000; };
  if (!numbers || numbers->size() != 4 || !std::all_of(numbers->begin(), numbers->end(), usable) || (*numbers)[2] < 1 || (*numbers)[3] < 1)
    return failure(ErrorCode::badUsage,
                   say<"'%1' is no rectangle; give x,y,width,height in pixels from the upper left corner.">(std::string(text)));
  return PixelRect{static_cast<int>((*numbers)[0]), static_cast<int>((*numbers)[1]), static_cast<int>((*numbers)[2]),
                   static_cast<int>((*numbers)[3])};
}

std::vector<Message> sentencesOf(const Removed& removed) {
  std::vector<Message> sentences;
  if (!removed.fields.empty())
    sentences.push_back(say<"Left out, because they can name a person, a place or a time: %1.">(joined(removed.fields, ", ")));
  if (removed.privateFields > 0)
    sentences.push_back(removed.privateFields == 1 ? say<"1 private field of the maker left out.">()
                                                   : say<"%1 private fields of the maker left out.">(removed.privateFields));
  if (removed.pixelsPerFrame > 0)
    sentences.push_back(say<"%1 pixels of each image cut away or made black, with any text in them.">(removed.pixelsPerFrame));
  if (sentences.empty()) sentences.push_back(say<"Nothing that names a person was found.">());
  return sentences;
}

std::uint64_t blank(std::span<std::uint8_t> pixels, int width, int height, std::span<const PixelRect> rects) {
  if (width < 1 || height < 1) return 0;
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint8_t> black(size, 0);
  for (const PixelRect& rect : rects) {
    const int right = static_cast<int>(std::min<long long>(width, static_cast<long long>(rect.x) + rect.width));
    const int bottom = static_cast<int>(std::min<long long>(height, static_cast<long long>(rect.y) + rect.height));
    for (int y = std::max(0, rect.y); y < bottom; ++y)
      for (int x = std::max(0, rect.x); x < right; ++x)
        black[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = 1;
  }
  for (std::size_t n = 0; n < pixels.size(); ++n)
    if (black[n % size] != 0) pixels[n] = 0;
  return static_cast<std::uint64_t>(std::count(black.begin(), black.end(), 1));
}

}  // namespace ew
