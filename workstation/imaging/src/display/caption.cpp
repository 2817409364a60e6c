#include "ew/imaging/caption.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace ew {
namespace {

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 9;  // two of them below the line
constexpr int kAdvance = 6;
constexpr int kLineAdvance = 11;
constexpr int kMargin_px = 4;
constexpr std::uint8_t kLetter = 150;
constexpr int kLargeImage_px = 900;  // from this width on every letter pixel becomes 2 x 2

struct Glyph {
  char letter;
  std::array<const char*, kGlyphHeight> rows;
};

constexpr std::array kGlyphs{
    Glyph{'a', {"     ", "     ", " ### ", "    #", " ####", "#   #", " ####", "     ", "     "}},
    Glyph{'b', {"#    ", "#    ", "#### ", "#   #", "#   #", "#   #", "#### ", "     ", "     "}},
    Glyph{'c', {"     ", "     ", " ### ", "#    ", "#    ", "#    ", " ### ", "     ", "     "}},
    Glyph{'d', {"    #", "    #", " ####", "#   #", "#   #", "#   #", " ####", "     ", "     "}},
    Glyph{'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### ", "     ", "     "}},
    Glyph{'f', {"  ## ", " #   ", "#### ", " #   ", " #   ", " #   ", " #   ", "     ", "     "}},
    Glyph{'g', {"     ", "     ", " ####", "#   #", "#   #", "#   #", " ####", "    #", " ### "}},
    Glyph{'h', {"#    ", "#    ", "#### ", "#   #", "#   #", "#   #", "#   #", "     ", "     "}},
    Glyph{'i', {"  #  ", "     ", " ##  ", "  #  ", "  #  ", "  #  ", " ### ", "     ", "     "}},
    Glyph{'j', {"   # ", "     ", "  ## ", "   # ", "   # ", "   # ", "   # ", "   # ", " ##  "}},
    Glyph{'k', {"#    ", "#    ", "#  # ", "# #  ", "##   ", "# #  ", "#  # ", "     ", "     "}},
    Glyph{'l', {" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "     ", "     "}},
    Glyph{'m', {"     ", "     ", "## # ", "# # #", "# # #", "# # #", "# # #", "     ", "     "}},
    Glyph{'n', {"     ", "     ", "#### ", "#   #", "#   #", "#   #", "#   #", "     ", "     "}},
    Glyph{'o', {"     ", "     ", " ### ", "#   #", "#   #", "#   #", " ### ", "     ", "     "}},
    Glyph{'p', {"     ", "     ", "#### ", "#   #", "#   #", "#   #", "#### ", "#    ", "#    "}},
    Glyph{'q', {"     ", "     ", " ####", "#   #", "#   #", "#   #", " ####", "    #", "    #"}},
    Glyph{'r', {"     ", "     ", "# ## ", "##   ", "#    ", "#    ", "#    ", "     ", "     "}},
    Glyph{'s', {"     ", "     ", " ####", "#    ", " ### ", "    #", "#### ", "     ", "     "}},
    Glyph{'t', {" #   ", " #   ", "#### ", " #   ", " #   ", " #   ", "  ## ", "     ", "     "}},
    Glyph{'u', {"     ", "     ", "#   #", "#   #", "#   #", "#   #", " ####", "     ", "     "}},
    Glyph{'v', {"     ", "     ", "#   #", "#   #", "#   #", " # # ", "  #  ", "     ", "     "}},
    Glyph{'w', {"     ", "     ", "# # #", "# # #", "# # #", "# # #", " # # ", "     ", "     "}},
    Glyph{'x', {"     ", "     ", "#   #", " # # ", "  #  ", " # # ", "#   #", "     ", "     "}},
    Glyph{'y', {"     ", "     ", "#   #", "#   #", "#   #", "#   #", " ####", "    #", " ### "}},
    Glyph{'z', {"     ", "     ", "#####", "   # ", "  #  ", " #   ", "#####", "     ", "     "}},
    Glyph{'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### ", "     ", "     "}},
    Glyph{'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "     ", "     "}},
    Glyph{'2', {" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####", "     ", "     "}},
    Glyph{'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### ", "     ", "     "}},
    Glyph{'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # ", "     ", "     "}},
    Glyph{'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### ", "     ", "     "}},
    Glyph{'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### ", "     ", "     "}},
    Glyph{'7', {"#####", "    #", "   # ", "  #  ", "  #  ", " #   ", " #   ", "     ", "     "}},
    Glyph{'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### ", "     ", "     "}},
    Glyph{'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  ", "     ", "     "}},
    Glyph{',', {"     ", "     ", "     ", "     ", "     ", "  #  ", "  #  ", " #   ", "     "}},
    Glyph{'.', {"     ", "     ", "     ", "     ", "     ", "     ", "  #  ", "     ", "     "}},
    Glyph{'-', {"     ", "     ", "     ", "     ", " ### ", "     ", "     ", "     ", "     "}},
};

std::vector<std::string> wrapped(std::string_view words, std::size_t lettersPerLine) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < words.size();) {
    const auto end = std::min(words.find(' ', at), words.size());
    const std::string word(words.substr(at, end - at));
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > lettersPerLine) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

template <class Pixel>
void fill(ImageView<Pixel> image, int left, int top, int size, std::uint8_t grey, bool onlyDarken) {
  for (int y = std::max(0, top); y < std::min(image.height, top + size); ++y)
    for (int x = std::max(0, left); x < std::min(image.width, left + size); ++x) {
      auto& pixel = image.at(x, y);
      pixel = onlyDarken ? glm::min(pixel, Pixel(grey)) : Pixel(grey);
    }
}

template <class Pixel>
void drawLine(ImageView<Pixel> image, const std::string& line, int left, int top, int scale, bool rim) {
  for (std::size_t n = 0; n < line.size(); ++n) {
    const auto glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(), [&](const Glyph& g) { return g.letter == line[n]; });
    if (glyph == kGlyphs.end()) continue;
    for (int y = 0; y < kGlyphHeight; ++y)
      for (int x = 0; x < kGlyphWidth; ++x) {
        if (glyph->rows[static_cast<std::size_t>(y)][x] != '#') continue;
        const int px = left + (static_cast<int>(n) * kAdvance + x) * scale;
        const int py = top + y * scale;
        if (rim)
          fill(image, px - scale, py - scale, 3 * scale, 16, true);
        else
          fill(image, px, py, scale, kLetter, false);
      }
  }
}

template <class Pixel>
void burn(ImageView<Pixel> image, std::string_view words) {
  const int scale = image.width >= kLargeImage_px ? 2 : 1;
  const int room = std::max(1, (image.width - 2 * kMargin_px) / (kAdvance * scale));
  const auto lines = wrapped(words, static_cast<std::size_t>(room));
  const int height = static_cast<int>(lines.size()) * kLineAdvance * scale;
  for (const bool rim : {true, false}) {  // every rim first, so that no rim darkens a neighbouring letter
    int top = image.height - kMargin_px - height;
    for (const auto& line : lines) {
      const int width = (static_cast<int>(line.size()) * kAdvance - 1) * scale;
      drawLine(image, line, (image.width - width) / 2, top, scale, rim);
      top += kLineAdvance * scale;
    }
  }
}

}  // namespace

void burnCaption(ImageView<std::uint8_t> image, std::string_view words) { burn(image, words); }
void burnCaption(ImageView<Rgb> image, std::string_view words) { burn(image, words); }

}  // namespace ew
