#include "ew/reports/report_pdf.h"

#include <algorithm>

#include "ew/io/safe_file.h"
#include "ew/library/timestamp.h"
#include "ew/reports/image_file.h"
#include "paper_image.h"
#include "paper_look.h"
#include "paper_plot.h"
#include "paper_table.h"
#include "report_words.h"

namespace ew {
namespace reports {
namespace {

constexpr double kPlot_mm = 104.0, kBetween_mm = 6.0, kWidestImage_mm = 130.0, kHighestImage_mm = 90.0;
constexpr double kPixel_mm = 25.4 / 96.0;  // at most: small images stay small

PaperFont headingFont(int level) { return {level <= 2 ? 13.0 : level == 3 ? 11.0 : 9.5, true, false}; }

/// Puts blocks on pages, one after another.
class PaperWriter {
 public:
  PaperWriter(PaperPages& pages, const ReportOptions& options) : pages_(pages), options_(options) {}

  void write(const ReportDocument& document) {
    text(document.title, kTitleFont, kInk);
    if (!document.subtitle.empty()) text(document.subtitle, kTextFont, kSoftInk);
    text(simulationSentence(), kStrongFont, inkOf(ReportTone::caution));
    for (std::size_t n = 0; n < document.blocks.size(); ++n) {
      const ReportBlock& block = document.blocks[n];
      if (!std::holds_alternative<ReportPlot>(block) && !std::holds_alternative<ReportImage>(block)) endRow();
      if (std::holds_alternative<ReportHeading>(block)) keepWithWhatItHeads(document.blocks, n);
      std::visit([this](const auto& one) { put(one); }, block);
    }
    endRow();
  }

 private:
  [[nodiscard]] PaperText laidOut(const Message& message, const PaperFont& font, double width) const {
    return pages_.text(options_.say(message), font, width);
  }
  void gap(double factor = 1.0) {
    if (!pages_.isFresh()) pages_.moveOn(kGap * factor);
  }
  void text(const Message& message, const PaperFont& font, const Rgb& ink) {
    putLines(pages_, laidOut(message, font, pages_.width()), font, ink, 0.0, pages_.width());
    gap();
  }

  /// Headings and words that follow each other stand with the first thing after them, or its beginning.
  void keepWithWhatItHeads(const std::vector<ReportBlock>& blocks, std::size_t n) {
    constexpr double kHeading_mm = 13.0, kWords_mm = 9.0, kBeginning_mm = 20.0;
    double room_mm = kBeginning_mm;
    for (; n < blocks.size(); ++n) {
      if (std::holds_alternative<ReportHeading>(blocks[n]))
        room_mm += kHeading_mm;
      else if (std::holds_alternative<ReportParagraph>(blocks[n]))
        room_mm += kWords_mm;
      else
        break;
    }
    const auto* block = n < blocks.size() ? std::get_if<ReportImage>(&blocks[n]) : nullptr;
    if (block != nullptr && block->isSmall) room_mm += kHighestImage_mm - kBeginning_mm;
    pages_.makeRoom(std::min(PaperPages::mm(room_mm), pages_.roomOfAPage()));
  }
  void put(const ReportHeading& heading) {
    gap(heading.level <= 2 ? 2.0 : 1.0);
    pages_.heading(heading.level, options_.say(heading.text));
    text(heading.text, headingFont(heading.level), kInk);
  }
  void put(const ReportParagraph& paragraph) { text(paragraph.text, kTextFont, inkOf(paragraph.tone)); }
  void put(const ReportList& list) {
    const double indent = PaperPages::mm(5.0), width = pages_.width() - indent;
    for (const ReportItem& item : list.items) {
      const PaperText words = laidOut(item.text, kTextFont, width);
      pages_.makeRoom(lineHeight(kTextFont) * std::min(words.lines(), 3));
      pages_.line(pages_.text(signOf(item.tone), kTextFont), 0, kTextFont, inkOf(item.tone), {0.0, pages_.y()}, indent);
      putLines(pages_, words, kTextFont, kInk, indent, width);
    }
    gap();
  }
  void put(const ReportFacts& facts) {
    const double column = PaperPages::mm(52.0), height = lineHeight(kTextFont);
    for (const ReportFact& fact : facts.rows) {
      const PaperText name = laidOut(fact.name, kTextFont, column - PaperPages::mm(3.0));
      const PaperText value = laidOut(fact.value, kTextFont, pages_.width() - column);
      const int lines = std::max(name.lines(), value.lines());
      pages_.makeRoom(height * lines);
      for (int n = 0; n < lines; ++n) {
        pages_.makeRoom(height);
        if (n < name.lines()) pages_.line(name, n, kTextFont, kSoftInk, {0.0, pages_.y()}, column);
        if (n < value.lines()) pages_.line(value, n, kTextFont, inkOf(fact.tone), {column, pages_.y()}, pages_.width() - column);
        pages_.moveOn(height);
      }
    }
    gap();
  }
  void put(const ReportTable& table) {
    putTable(pages_, table, options_);
    gap(1.6);
  }

  void put(const ReportPlot& plot) {
    const double width = plot.isSmall ? halfWidth() : std::min(PaperPages::mm(kPlot_mm), pages_.width());
    const PlotColours colours = paperColours();
    const std::function<std::string(const Message&)> words = [this](const Message& message) { return options_.say(message); };
    PaperCanvas canvas(pages_, colours, words);
    const double high = std::visit([&](const auto& data) { return draw(canvas, data); }, plot.data);
    const PaperFont font{plot.isSmall ? kTableFont.size_pt : kTextFont.size_pt, true, false};
    const PaperText title = laidOut(plot.title, font, width);
    const double titleHeight = lineHeight(font) * title.lines() + PaperPages::mm(1.0);
    const double most = pages_.roomOfAPage() - titleHeight - kGap;
    const double scale = std::min(width / kPlotWidth, most / high), height = titleHeight + scale * high + kGap;
    const double x = placeInRow(plot.isSmall, height);
    putLinesAt(title, font, kInk, {x, pages_.y()}, width);
    pages_.draw(std::move(canvas).drawing({x, pages_.y() + titleHeight}, scale));
    standInRow(plot.isSmall, height);
  }

  /// Room for a plot or image, of which small ones stand two in a row. @return how far from the left
  double placeInRow(bool isSmall, double height) {
    if (!isSmall || !isSecondOfRow_ || height > pages_.roomLeft()) {
      endRow();
      pages_.makeRoom(height);
    }
    return isSecondOfRow_ ? pages_.width() - halfWidth() : 0.0;
  }
  void standInRow(bool isSmall, double height) {
    row_ = std::max(row_, height);
    isSecondOfRow_ = isSmall && !isSecondOfRow_;
    if (!isSecondOfRow_) endRow();
  }
  void endRow() {
    pages_.moveOn(row_);
    row_ = 0.0;
    isSecondOfRow_ = false;
  }
  [[nodiscard]] double halfWidth() const { return 0.5 * (pages_.width() - PaperPages::mm(kBetween_mm)); }
  void putLinesAt(const PaperText& text, const PaperFont& font, const Rgb& ink, const glm::dvec2& at, double width) {
    for (int n = 0; n < text.lines(); ++n) pages_.line(text, n, font, ink, {at.x, at.y + n * lineHeight(font)}, width);
  }

  void put(const ReportImage& block) {
    const auto read = imageOf(block);
    if (!read) return putInstead(ReportParagraph{read.error().message, ReportTone::caution});
    const auto image = paperImage(*read, block.file.filename().string());
    if (!image) return putInstead(ReportParagraph{image.error().message, ReportTone::caution});
    const double width = block.isSmall ? halfWidth() : pages_.width();
    const PaperText caption = laidOut(block.caption, kTableFont, width);
    const glm::dvec2 most(std::min(PaperPages::mm(kWidestImage_mm), width), PaperPages::mm(kHighestImage_mm));
    const double pixel = std::min({PaperPages::mm(kPixel_mm), most.x / image->size.x, most.y / image->size.y});
    const double height = pixel * image->size.y + PaperPages::mm(1.0);
    const double withCaption = height + lineHeight(kTableFont) * caption.lines();
    const double x = placeInRow(block.isSmall, withCaption);
    pages_.draw([surface = image->surface, x, y = pages_.y(), pixel](cairo_t* pen) {
      cairo_translate(pen, x, y);
      cairo_scale(pen, pixel, pixel);
      cairo_set_source_surface(pen, surface.get(), 0.0, 0.0);
      cairo_paint(pen);
    });
    putLinesAt(caption, kTableFont, kSoftInk, {x, pages_.y() + height}, width);
    standInRow(block.isSmall, withCaption + 1.6 * kGap);
  }
  /// Of an image that cannot be shown.
  void putInstead(const ReportParagraph& paragraph) {
    endRow();
    put(paragraph);
  }

  PaperPages& pages_;
  const ReportOptions& options_;
  bool isSecondOfRow_ = false;
  double row_ = 0.0;  // how high it is
};

}  // namespace
}  // namespace reports

Result<std::string> pdfOf(const ReportDocument& document, const ReportOptions& options, PaperSize paper) {
  const auto number = [&options](int page, int of) { return options.say(say<"Page %1 of %2">(page, of)); };
  const std::string title = options.say(document.title);
  auto pages = PaperPages::begin(paper, {title, options.say(simulationSentence()), number}, options.language);
  if (!pages) return passOn(pages.error());
  reports::PaperWriter(*pages, options).write(document);
  return pages->pdf({title, document.at ? timestampText(*document.at) : std::string()});
}

Result<void> writeReportPdf(const ReportDocument& document, const ReportOptions& options, PaperSize paper,
                            const std::filesystem::path& file) {
  const auto pdf = pdfOf(document, options, paper);
  if (!pdf) return passOn(pdf.error());
  return writeFileSafely(file, *pdf);
}

}  // namespace ew
