#pragma once

#include <cairo.h>

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/result.h"
#include "ew/paper/paper_size.h"
#include "ew/paper/pdf_file.h"

namespace ew {

struct PaperFont {
  double size_pt = 9.5;
  bool isBold = false;
  bool hasEvenFigures = false;  ///< all of one width, for columns of numbers
};
/// From the upper edge of a line to that of the next one, points.
[[nodiscard]] double lineHeight(const PaperFont& font);

/// A text in letters, broken into lines. Copies share it.
class PaperText {
 public:
  [[nodiscard]] int lines() const;  ///< at least one
  /// Of the longest line, points.
  [[nodiscard]] double width() const;
  [[nodiscard]] double widthOf(int line) const;
  /// Draws a line in the pen's colour. @param at where its base line begins
  void show(cairo_t* pen, int line, const glm::dvec2& at) const;

 private:
  friend class PaperPages;
  struct Layout;
  explicit PaperText(std::shared_ptr<const Layout> layout) : layout_(std::move(layout)) {}
  std::shared_ptr<const Layout> layout_;
};

/// What stands at the edges of every page.
struct PaperEdges {
  std::string title;                                    ///< above, cut where it is too long
  std::string foot;                                     ///< below
  std::function<std::string(int page, int of)> number;  ///< above, at the right: "Page 2 of 5"
};

/// Pages of text, tables and drawings that fill from above: whoever puts something on them asks for room first and moves on by what it
/// took. They are drawn when all are there, because each says how many there are. Lengths in points, from the upper left corner of what may
/// be printed on. Letters are those of Inter, where it is not installed of DejaVu Sans or of what else there is; what these do not have
/// comes from any font that has it. Text is cleaned as by printable(). Any thread, one at a time.
class PaperPages {
 public:
  /// @param language "en", "de_DE": for the breaking of lines @error unsupported: not one font is installed
  [[nodiscard]] static Result<PaperPages> begin(PaperSize paper, PaperEdges edges, std::string_view language = "en");
  PaperPages(PaperPages&&) noexcept;
  PaperPages& operator=(PaperPages&&) = delete;
  ~PaperPages();

  [[nodiscard]] static double mm(double length_mm) { return length_mm * kPointsPerMm; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double roomLeft() const { return bottom_ - y_; }
  [[nodiscard]] double roomOfAPage() const { return bottom_ - top_; }
  [[nodiscard]] int pages() const { return static_cast<int>(pages_.size()); }
  /// Nothing stands on this page yet.
  [[nodiscard]] bool isFresh() const { return y_ <= top_; }
  /// The next page, unless so much fits on this one, or on no page.
  void makeRoom(double height);
  void nextPage();
  void moveOn(double height) { y_ += height; }

  /// The text in lines of at most `width`; words that are longer are broken between letters.
  [[nodiscard]] PaperText text(const std::string& text, const PaperFont& font, double width) const;
  /// On one line, however long.
  [[nodiscard]] PaperText text(const std::string& text, const PaperFont& font) const;

  enum class Side { left, right };
  /// One line of a text. @param at the upper left corner of its box @param width of the box
  void line(const PaperText& text, int line, const PaperFont& font, const Rgb& ink, const glm::dvec2& at, double width,
            Side side = Side::left);
  /// A thin line over the whole width.
  void rule(double y);
  /// Anything else: called when the pages are drawn, with a pen whose state may be left changed.
  void draw(std::function<void(cairo_t*)> drawing);
  /// An entry in the list of contents for what stands here. @param level 1 is the highest
  void heading(int level, const std::string& text);

  /// All pages. @error internal (PdfFile::finish)
  [[nodiscard]] Result<std::string> pdf(const PdfAbout& about) const;

 private:
  struct Letters;
  using Drawing = std::function<void(cairo_t*)>;
  struct Entry {
    int level = 1, page = 1;
    double y = 0.0;
    std::string text;
  };
  PaperPages(PaperSize paper, PaperEdges edges, std::unique_ptr<Letters> letters);
  [[nodiscard]] std::vector<Drawing> edgesOf(int page) const;
  void addOutline(PdfFile& pdf) const;

  PaperSize paper_;
  PaperEdges edges_;
  std::unique_ptr<Letters> letters_;
  std::vector<std::vector<Drawing>> pages_{1};
  std::vector<Entry> entries_;
  double width_ = 0.0, top_ = 0.0, bottom_ = 0.0, y_ = 0.0;
};

/// The pen's colour.
void setInk(cairo_t* pen, const Rgb& ink);

}  // namespace ew
