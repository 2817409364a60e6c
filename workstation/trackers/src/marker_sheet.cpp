#include "ew/trackers/marker_sheet.h"

#include <algorithm>
#include <sstream>

#include "ew/io/safe_file.h"
#include "ew/paper/pdf_file.h"
#include "marker_dictionary.h"

namespace ew {
namespace {

constexpr double kLineSpacing = 1.3;  // of the font's size

void polygon(cairo_t* pen, const std::array<glm::dvec2, 4>& corners) {
  cairo_move_to(pen, corners[0].x, corners[0].y);
  for (std::size_t n = 1; n < 4; ++n) cairo_line_to(pen, corners[n].x, corners[n].y);
  cairo_close_path(pen);
}

/// All black squares of a marker in one path: filled one by one, viewers show hairs between them.
void drawMarker(cairo_t* pen, const SheetMarker& marker, const std::string& dictionary) {
  const MarkerSquares squares = squaresOf(dictionary, marker.id);
  const glm::dvec2 right = (marker.corners[1] - marker.corners[0]) / static_cast<double>(squares.side);
  const glm::dvec2 down = (marker.corners[3] - marker.corners[0]) / static_cast<double>(squares.side);
  const auto at = [&](int column, int row) {
    return marker.corners[0] + static_cast<double>(column) * right + static_cast<double>(row) * down;
  };
  cairo_new_path(pen);
  for (int row = 0; row < squares.side; ++row)
    for (int column = 0; column < squares.side; ++column)
      if (squares.isBlack[static_cast<std::size_t>(row * squares.side + column)] != 0)
        polygon(pen, {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
  cairo_fill(pen);
}

void drawLine(cairo_t* pen, const SheetLine& line) {
  constexpr double kDashes[] = {3.0, 2.0}, kDots[] = {0.6, 1.4};
  cairo_set_line_width(pen, line.kind == SheetLine::Kind::cut ? 0.25 : 0.2);
  switch (line.kind) {
    case SheetLine::Kind::fold:
      cairo_set_dash(pen, kDashes, 2, 0.0);
      break;
    case SheetLine::Kind::shape:
      cairo_set_dash(pen, kDots, 2, 0.0);
      break;
    case SheetLine::Kind::cut:
    case SheetLine::Kind::scale:
      cairo_set_dash(pen, nullptr, 0, 0.0);
      break;
  }
  cairo_move_to(pen, line.from.x, line.from.y);
  cairo_line_to(pen, line.to.x, line.to.y);
  cairo_stroke(pen);
}

/// A ruler of 100 mm: thin ticks whose middles are exact, longer ones every 50 mm.
void drawScale(cairo_t* pen, const SheetLine& scale) {
  drawLine(pen, scale);
  const glm::dvec2 along = glm::normalize(scale.to - scale.from), side(along.y, -along.x);
  const glm::dvec2 out = along.x > 0.5 ? side : -side;
  for (int n = 0; n <= 10; ++n) {
    const glm::dvec2 p = scale.from + 10.0 * n * along;
    drawLine(pen, {SheetLine::Kind::scale, p, p + (n % 5 == 0 ? 3.0 : 1.5) * out});
  }
  cairo_set_font_size(pen, 3.2);
  const char* label = "100 mm";
  cairo_text_extents_t extents;
  cairo_text_extents(pen, label, &extents);
  const glm::dvec2 p = scale.from + 75.0 * along + 2.2 * out;
  cairo_save(pen);
  cairo_translate(pen, p.x, p.y);
  if (along.y > 0.5) cairo_rotate(pen, -1.5707963267948966);
  cairo_move_to(pen, -0.5 * extents.width, 0.0);
  cairo_show_text(pen, label);
  cairo_restore(pen);
}

double widthOf(cairo_t* pen, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(pen, text.c_str(), &extents);
  return std::max(extents.x_advance, extents.x_bearing + extents.width);
}

/// The text broken into lines of at most `width_mm`; empty when a word alone is longer.
std::vector<std::string> brokenLines(cairo_t* pen, const std::string& text, double width_mm) {
  std::istringstream words(text);
  std::vector<std::string> lines;
  for (std::string word; words >> word;) {
    if (widthOf(pen, word) > width_mm) return {};
    if (!lines.empty() && widthOf(pen, lines.back() + " " + word) <= width_mm)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

/// Draws a text with the largest letters that its box has room for. @return whether there are any
bool drawText(cairo_t* pen, const SheetText& text, const SheetWords& words) {
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, text.isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  for (double letters = text.letters_mm; letters >= 0.5 * text.letters_mm; letters -= 0.1) {
    cairo_set_font_size(pen, letters);
    std::vector<std::vector<std::string>> paragraphs;
    double height = 0.0;
    bool fits = true;
    for (const Message& paragraph : text.paragraphs) {
      paragraphs.push_back(brokenLines(pen, words(paragraph), text.box_mm.x));
      fits = fits && !paragraphs.back().empty();
      height += (kLineSpacing * static_cast<double>(paragraphs.back().size()) + (paragraphs.size() > 1 ? 0.4 : 0.0)) * letters;
    }
    if (!fits || height > text.box_mm.y) continue;
    double y = text.at.y + letters + (text.isMiddle ? 0.5 * (text.box_mm.y - height) : 0.0);
    for (const auto& lines : paragraphs) {
      for (const std::string& line : lines) {
        cairo_move_to(pen, text.at.x + (text.isMiddle ? 0.5 * (text.box_mm.x - widthOf(pen, line)) : 0.0), y);
        cairo_show_text(pen, line.c_str());
        y += kLineSpacing * letters;
      }
      y += 0.4 * letters;
    }
    return true;
  }
  return false;
}

Result<void> drawPage(cairo_t* pen, const SheetPage& page, const SheetWords& words) {
  cairo_save(pen);
  cairo_scale(pen, kPointsPerMm, kPointsPerMm);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
  cairo_set_source_rgb(pen, 0.0, 0.0, 0.0);
  cairo_new_path(pen);
  for (const auto& square : page.blackSquares) polygon(pen, square);
  cairo_fill(pen);
  for (const SheetMarker& marker : page.markers) drawMarker(pen, marker, page.dictionary);
  for (const SheetLine& line : page.lines) drawLine(pen, line);
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (const SheetLine& scale : page.scales) drawScale(pen, scale);
  for (const SheetText& text : page.texts)
    if (!drawText(pen, text, words))
      return failure(ErrorCode::tooLarge,
                     say<"The texts of the marker body %1 do not fit on its sheet; make the body smaller or its texts shorter.">(page.body),
                     {{"body", page.body}});
  cairo_restore(pen);
  return {};
}

}  // namespace

Result<void> writeMarkerSheet(std::span<const PaperBody> bodies, PaperSize paper, const std::filesystem::path& file,
                              const SheetWords& words, std::string_view language) {
  const SheetWords spoken = words ? words : [](const Message& message) { return message.english(); };
  PdfFile pdf(sizeOf(paper), {"EchoWeave", {}});
  for (const PaperBody& body : bodies) {
    const auto page = layOut(body, paper, language);
    if (!page) return passOn(page.error());
    pdf.setPageSize(page->size_mm);
    if (auto drawn = drawPage(pdf.pen(), *page, spoken); !drawn) return drawn;
    pdf.endPage();
  }
  const auto bytes = pdf.finish();
  if (!bytes) return passOn(bytes.error());
  return writeFileSafely(file, *bytes);
}

}  // namespace ew
