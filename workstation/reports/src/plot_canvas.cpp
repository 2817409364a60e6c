#include "plot_canvas.h"

#include <algorithm>

namespace ew::reports {
namespace {

constexpr double kLetterWidth = 0.56 * kTextSize;  // of a sans serif, as a mean; a little more than it takes

bool beginsLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; }

}  // namespace

double widthOf(std::string_view text) {
  return kLetterWidth * static_cast<double>(std::count_if(text.begin(), text.end(), [](char byte) { return beginsLetter(byte); }));
}

void PlotCanvas::fitted(double x, double y, double right, const Message& message) {
  std::string said = words(message);
  if (widthOf(said) > right - x) {
    auto letters = static_cast<int>((right - x) / kLetterWidth) - 1;
    std::size_t end = 0;
    while (end < said.size() && (letters > 0 || !beginsLetter(said[end]))) letters -= beginsLetter(said[end++]) ? 1 : 0;
    said = said.substr(0, end) + "…";
  }
  text(x, y, Anchor::start, said);
}

}  // namespace ew::reports
