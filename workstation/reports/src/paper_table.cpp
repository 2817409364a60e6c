#include "paper_table.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>

#include "paper_look.h"

namespace ew::reports {
namespace {

constexpr double kBelowCaption = 0.8 * kPointsPerMm;
constexpr double kCellEdge = 1.2 * kPointsPerMm, kCellSide = 1.6 * kPointsPerMm;  // of a cell, above and below; at its sides

struct Part {
  PaperText text;
  Rgb ink;
};
using Cell = std::vector<Part>;  // one under another
struct Row {
  std::vector<Cell> cells;
  int lines = 1;
};

int linesOf(const Cell& cell) {
  return std::accumulate(cell.begin(), cell.end(), 0, [](int lines, const Part& part) { return lines + part.text.lines(); });
}

/// How wide texts of tables are, each measured once.
class Widths {
 public:
  explicit Widths(const PaperPages& pages) : pages_(pages) {}
  double of(const std::string& text, const PaperFont& font) {
    const auto [known, isNew] = widths_.try_emplace({text, font.isBold}, 0.0);
    if (isNew) known->second = pages_.text(text, font).width();
    return known->second;
  }
  double ofLongestWord(const std::string& text, const PaperFont& font) {
    double longest = 0.0;
    std::istringstream words(text);
    for (std::string word; words >> word;) longest = std::max(longest, of(word, font));
    return longest;
  }

 private:
  const PaperPages& pages_;
  std::map<std::pair<std::string, bool>, double> widths_;
};

class TableWriter {
 public:
  TableWriter(PaperPages& pages, const ReportTable& table, const ReportOptions& options) : pages_(pages), table_(table), options_(options) {
    measureColumns();
    head_ = headRow();
  }

  void write() {
    const PaperText caption = pages_.text(options_.say(table_.caption), kTableFont, pages_.width());
    bool isFirst = true;
    const auto begin = [&](double firstRow) {
      const double words = table_.caption.empty() ? 0.0 : lineHeight(kTableFont) * caption.lines() + kBelowCaption;
      pages_.makeRoom(std::min(words + heightOf(head_, kTableHeadFont) + firstRow, pages_.roomOfAPage()));
      if (!table_.caption.empty()) {
        putLines(pages_, caption, kTableFont, kSoftInk, 0.0, pages_.width());
        pages_.moveOn(kBelowCaption);
      }
      put(head_, kTableHeadFont, false);
      isFirst = false;
    };
    for (const auto& cells : table_.rows) {
      const Row row = rowOf(cells);
      if (isFirst) begin(heightOf(row, kTableFont));
      put(row, kTableFont, true);
    }
    if (isFirst) begin(0.0);
    pages_.rule(pages_.y());
  }

 private:
  /// Columns are as wide as their texts; if need be no wider than their words, if need be less.
  void measureColumns() {
    const std::size_t count = table_.columns.size();
    const double sides = 2.0 * kCellSide, room = pages_.width() - sides * static_cast<double>(count);
    std::vector<double> whole(count, 0.0), word(count, 0.0);
    Widths measured(pages_);
    const auto look = [&](std::size_t column, const Message& message, const PaperFont& font, bool isWhole) {
      const std::string text = options_.say(message);
      const double width = measured.of(text, font);
      whole[column] = std::max(whole[column], width);
      word[column] = std::max(word[column], isWhole ? width : measured.ofLongestWord(text, font));
    };
    for (std::size_t n = 0; n < count; ++n) {
      look(n, table_.columns[n].name, kTableHeadFont, false);
      for (const auto& row : table_.rows) {
        look(n, row[n].text, kTableFont, table_.columns[n].isNumber);
        for (const Message& line : row[n].below) look(n, line, kTableFont, false);
      }
    }
    const double wholes = std::accumulate(whole.begin(), whole.end(), 0.0), words = std::accumulate(word.begin(), word.end(), 0.0);
    for (std::size_t n = 0; n < count; ++n) {
      double width = whole[n] + (room - wholes) / static_cast<double>(count);
      if (wholes > room) width = word[n] + (room - words) * (whole[n] - word[n]) / std::max(1.0, wholes - words);
      if (words > room) width = room * word[n] / words;
      columns_.push_back(width);
    }
  }
  [[nodiscard]] Row headRow() const {
    std::vector<ReportCell> cells;
    for (const ReportColumn& column : table_.columns) cells.push_back({column.name, ReportTone::soft, {}});
    return rowOf(cells, kTableHeadFont);
  }
  [[nodiscard]] Row rowOf(const std::vector<ReportCell>& cells, const PaperFont& font = kTableFont) const {
    Row row;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      Cell& cell = row.cells.emplace_back();
      const auto add = [&](const Message& message, ReportTone tone) {
        // A hair more than was measured, so that a text as wide as its column is not broken by the last digit of a sum.
        cell.push_back({pages_.text(options_.say(message), font, columns_[n] + 0.1), inkOf(tone)});
      };
      if (!cells[n].text.empty() || cells[n].below.empty()) add(cells[n].text, cells[n].tone);
      for (const Message& line : cells[n].below) add(line, ReportTone::soft);
      row.lines = std::max(row.lines, linesOf(cell));
    }
    return row;
  }
  static double heightOf(const Row& row, const PaperFont& font) { return lineHeight(font) * row.lines + 2.0 * kCellEdge; }

  void makeRoom(double height, bool hasHead) {
    if (height <= pages_.roomLeft() || pages_.isFresh()) return;
    if (hasHead) pages_.rule(pages_.y());
    pages_.nextPage();
    if (hasHead) put(head_, kTableHeadFont, false);
  }
  void put(const Row& row, const PaperFont& font, bool hasHead) {
    makeRoom(heightOf(row, font), hasHead);
    pages_.rule(pages_.y());
    pages_.moveOn(kCellEdge);
    for (int line = 0; line < row.lines; ++line) {
      makeRoom(lineHeight(font), hasHead);
      putLine(row, line, font);
      pages_.moveOn(lineHeight(font));
    }
    pages_.moveOn(kCellEdge);
  }
  void putLine(const Row& row, int line, const PaperFont& font) {
    double x = 0.0;
    for (std::size_t n = 0; n < row.cells.size(); ++n) {
      int ofPart = line;
      for (const Part& part : row.cells[n]) {
        if (ofPart >= 0 && ofPart < part.text.lines())
          pages_.line(part.text, ofPart, font, part.ink, {x + kCellSide, pages_.y()}, columns_[n],
                      table_.columns[n].isNumber ? PaperPages::Side::right : PaperPages::Side::left);
        ofPart -= part.text.lines();
      }
      x += columns_[n] + 2.0 * kCellSide;
    }
  }

  PaperPages& pages_;
  const ReportTable& table_;
  const ReportOptions& options_;
  std::vector<double> columns_;  // without their sides
  Row head_;
};

}  // namespace

void putTable(PaperPages& pages, const ReportTable& table, const ReportOptions& options) {
  if (!table.columns.empty()) TableWriter(pages, table, options).write();
}

}  // namespace ew::reports
