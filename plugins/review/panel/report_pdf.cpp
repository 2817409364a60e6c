#include "panel/report_pdf.h"

#include <QBuffer>
#include <QImage>
#include <QLocale>
#include <QPageLayout>
#include <QSvgRenderer>
#include <algorithm>
#include <numeric>
#include <string_view>

#include "ew/io/safe_file.h"
#include "ew/reports/picture_file.h"
#include "panel/paper_pages.h"

namespace ew::review {
namespace {

constexpr int kResolution_dpi = 300;
constexpr double kText_pt = 9.5, kTable_pt = 8.0, kGap_mm = 2.5, kCellEdge_mm = 1.2;
constexpr double kPlot_mm = 104.0, kWidestPicture_mm = 130.0, kHighestPicture_mm = 90.0;
const QColor kInk(0x1d, 0x23, 0x29), kSoftText(0x4d, 0x56, 0x5f), kRule(0xc9, 0xcf, 0xd6);

QColor inkOf(ReportTone tone) {
  switch (tone) {
    case ReportTone::soft:
      return kSoftText;
    case ReportTone::good:
      return {0x1a, 0x6b, 0x3c};
    case ReportTone::bad:
      return {0xb3, 0x26, 0x1e};
    case ReportTone::caution:
      return {0x7a, 0x52, 0x00};
    default:
      return kInk;
  }
}

QString signFor(ReportTone tone) {
  switch (tone) {
    case ReportTone::plain:
    case ReportTone::soft:
      return QStringLiteral("\u2022");
    case ReportTone::good:
      return QStringLiteral("\u2713");
    case ReportTone::bad:
      return QStringLiteral("\u2717");
    case ReportTone::caution:
      return QStringLiteral("!");
  }
  return {};
}

/// A table with its columns measured.
struct MeasuredTable {
  const ReportTable& table;
  std::vector<double> widths;
};

/// Puts blocks on pages, one after another.
class PaperWriter {
 public:
  PaperWriter(PaperPages& pages, const ReportOptions& options) : pages_(pages), options_(options) {}

  void write(const ReportDocument& document) {
    text(document.title, PaperPages::font(16.0, true), kInk);
    if (!document.subtitle.empty()) text(document.subtitle, PaperPages::font(kText_pt), kSoftText);
    text(simulationSentence(), PaperPages::font(kText_pt, true), inkOf(ReportTone::caution));
    for (std::size_t n = 0; n < document.blocks.size(); ++n) {
      const ReportBlock& block = document.blocks[n];
      if (!std::holds_alternative<ReportPlot>(block)) endRowOfPlots();
      if (std::holds_alternative<ReportHeading>(block)) keepWithWhatItHeads(document.blocks, n);
      std::visit([this](const auto& one) { put(one); }, block);
    }
    endRowOfPlots();
  }

 private:
  [[nodiscard]] QString said(const Message& message) const { return QString::fromStdString(options_.say(message)); }
  void gap(double factor = 1.0) {
    if (!pages_.isFresh()) pages_.moveOn(pages_.mm(kGap_mm * factor));
  }
  void lines(const QStringList& all, const QFont& font, const QColor& ink, double x, double width) {
    for (const QString& one : all) {
      pages_.makeRoom(pages_.lineHeight(font));
      pages_.line(one, font, ink, x, pages_.y(), width);
      pages_.moveOn(pages_.lineHeight(font));
    }
  }
  void text(const Message& message, const QFont& font, const QColor& ink) {
    lines(pages_.linesOf(said(message), font, pages_.width()), font, ink, 0.0, pages_.width());
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
    pages_.makeRoom(std::min(pages_.mm(room_mm), pages_.roomOfAPage()));
  }
  void put(const ReportHeading& heading) {
    const QFont font = PaperPages::font(heading.level <= 2 ? 13.0 : heading.level == 3 ? 11.0 : 9.5, true);
    gap(heading.level <= 2 ? 2.0 : 1.0);
    text(heading.text, font, kInk);
  }
  void put(const ReportParagraph& paragraph) { text(paragraph.text, PaperPages::font(kText_pt), inkOf(paragraph.tone)); }
  void put(const ReportList& list) {
    const QFont font = PaperPages::font(kText_pt);
    const double indent = pages_.mm(5.0);
    for (const ReportItem& item : list.items) {
      const QStringList all = pages_.linesOf(said(item.text), font, pages_.width() - indent);
      pages_.makeRoom(pages_.lineHeight(font) * std::min(all.size(), 3));
      pages_.line(signFor(item.tone), font, inkOf(item.tone), 0.0, pages_.y(), indent);
      lines(all, font, kInk, indent, pages_.width() - indent);
    }
    gap();
  }
  void put(const ReportFacts& facts) {
    const QFont font = PaperPages::font(kText_pt);
    const double column = pages_.mm(52.0);
    for (const ReportFact& fact : facts.rows) {
      const QStringList name = pages_.linesOf(said(fact.name), font, column - pages_.mm(3.0));
      const QStringList value = pages_.linesOf(said(fact.value), font, pages_.width() - column);
      pages_.makeRoom(pages_.lineHeight(font) * std::max(name.size(), value.size()));
      for (int n = 0; n < std::max(name.size(), value.size()); ++n) {
        pages_.makeRoom(pages_.lineHeight(font));
        if (n < name.size()) pages_.line(name[n], font, kSoftText, 0.0, pages_.y(), column);
        if (n < value.size()) pages_.line(value[n], font, inkOf(fact.tone), column, pages_.y(), pages_.width() - column);
        pages_.moveOn(pages_.lineHeight(font));
      }
    }
    gap();
  }

  void put(const ReportTable& table) {
    const MeasuredTable measured{table, columnWidths(table)};
    const QFont caption = PaperPages::font(kTable_pt);
    constexpr double kHeadAndRow_mm = 16.0;
    pages_.makeRoom(pages_.mm(kHeadAndRow_mm));
    lines(pages_.linesOf(said(table.caption), caption, pages_.width()), caption, kSoftText, 0.0, pages_.width());
    head(measured);
    for (const auto& row : table.rows) tableRow(measured, row);
    gap(1.6);
  }
  /// As wide as their texts, if need be no wider than their words, if need be less.
  std::vector<double> columnWidths(const ReportTable& table) {
    const double edges = 2.0 * pages_.mm(kCellEdge_mm), room = pages_.width() - edges * static_cast<double>(table.columns.size());
    std::vector<double> whole, word;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
      whole.push_back(0.0);
      word.push_back(0.0);
      const auto look = [&](const QString& cell, const QFont& font, bool isWhole) {
        whole[n] = std::max(whole[n], pages_.widthOf(cell, font));
        for (const QString& one : isWhole ? QStringList{cell} : cell.split(QLatin1Char(' ')))
          word[n] = std::max(word[n], pages_.widthOf(one, font));
      };
      look(said(table.columns[n].name), PaperPages::font(kTable_pt, true), false);
      for (const auto& row : table.rows) look(said(row[n].text), PaperPages::font(kTable_pt), table.columns[n].isNumber);
    }
    const double wholes = std::accumulate(whole.begin(), whole.end(), 0.0), words = std::accumulate(word.begin(), word.end(), 0.0);
    std::vector<double> widths;
    for (std::size_t n = 0; n < whole.size(); ++n) {
      double width = whole[n] + (room - wholes) / static_cast<double>(whole.size());
      if (wholes > room && words <= room) width = word[n] + (room - words) * (whole[n] - word[n]) / std::max(1.0, wholes - words);
      if (words > room) width = room * word[n] / words;
      widths.push_back(width + edges);
    }
    return widths;
  }
  void head(const MeasuredTable& of) {
    std::vector<ReportCell> cells;
    for (const ReportColumn& column : of.table.columns) cells.push_back({column.name, ReportTone::soft, {}});
    slice(of, cells, PaperPages::font(kTable_pt, true), false);
  }
  void tableRow(const MeasuredTable& of, const std::vector<ReportCell>& cells) { slice(of, cells, PaperPages::font(kTable_pt), true); }
  /// A row as a whole; one that no page holds, line by line.
  void slice(const MeasuredTable& of, const std::vector<ReportCell>& cells, const QFont& font, bool hasHead) {
    std::vector<QStringList> texts;
    int most = 1;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      texts.push_back(pages_.linesOf(said(cells[n].text), font, of.widths[n] - 2.0 * pages_.mm(kCellEdge_mm)));
      most = std::max(most, texts.back().size());
    }
    const double height = pages_.lineHeight(font), edge = pages_.mm(kCellEdge_mm);
    const auto room = [&](double wanted) {
      if (wanted <= pages_.roomLeft() || pages_.isFresh()) return;
      pages_.nextPage();
      if (hasHead) head(of);
    };
    room(height * most + 2.0 * edge);
    rule();
    pages_.moveOn(edge);
    for (int line = 0; line < most; ++line) {
      if (height > pages_.roomLeft()) room(height);
      double x = 0.0;
      for (std::size_t n = 0; n < cells.size(); ++n) {
        const bool isNumber = of.table.columns[n].isNumber;
        if (line < texts[n].size())
          pages_.line(texts[n][line], font, inkOf(cells[n].tone), x + edge, pages_.y(), of.widths[n] - 2.0 * edge,
                      isNumber ? Qt::AlignRight : Qt::AlignLeft);
        x += of.widths[n];
      }
      pages_.moveOn(height);
    }
    pages_.moveOn(edge);
  }
  void rule() {
    pages_.painter().setPen(QPen(kRule, pages_.mm(0.2)));
    pages_.painter().drawLine(QPointF(0.0, pages_.y()), QPointF(pages_.width(), pages_.y()));
  }

  void put(const ReportPlot& plot) {
    const std::string svg = svgOf(plot, paperColours(), [this](const Message& message) { return options_.say(message); });
    QSvgRenderer drawing(QByteArray::fromRawData(svg.data(), static_cast<int>(svg.size())));
    const QSizeF size = drawing.viewBoxF().size();
    if (size.isEmpty()) return;
    const QFont font = PaperPages::font(plot.isSmall ? kTable_pt : kText_pt, true);
    const double between = pages_.mm(6.0);
    const double width = plot.isSmall ? 0.5 * (pages_.width() - between) : std::min(pages_.mm(kPlot_mm), pages_.width());
    const double high = width * size.height() / size.width(), shrink = std::min(1.0, (pages_.roomOfAPage() - pages_.mm(12.0)) / high);
    const QStringList title = pages_.linesOf(said(plot.title), font, width);
    const double height = pages_.lineHeight(font) * title.size() + high * shrink + pages_.mm(kGap_mm);
    if (!plot.isSmall || !isSecondOfRow_ || height > pages_.roomLeft()) {
      endRowOfPlots();
      pages_.makeRoom(height);
    }
    const double x = isSecondOfRow_ ? width + between : 0.0;
    double y = pages_.y();
    for (const QString& one : title) {
      pages_.line(one, font, kInk, x, y, width);
      y += pages_.lineHeight(font);
    }
    pages_.painter().setFont(PaperPages::font(kText_pt));  // what the drawing does not say it takes from the painter
    drawing.render(&pages_.painter(), QRectF(x, y, width * shrink, high * shrink));
    rowOfPlots_ = std::max(rowOfPlots_, height);
    isSecondOfRow_ = plot.isSmall && !isSecondOfRow_;
    if (!isSecondOfRow_) endRowOfPlots();
  }
  void endRowOfPlots() {
    pages_.moveOn(rowOfPlots_);
    rowOfPlots_ = 0.0;
    isSecondOfRow_ = false;
  }

  void put(const ReportPicture& picture) {
    const auto read = readPicture(picture.file);
    const QImage image =
        read ? QImage::fromData(QByteArray::fromRawData(read->bytes.data(), static_cast<int>(read->bytes.size()))) : QImage();
    if (!read) return put(ReportParagraph{read.error().message, ReportTone::caution});
    if (image.isNull()) {
      const std::string name = picture.file.filename().string();
      return put(ReportParagraph{say<"The picture '%1' is damaged.">(name), ReportTone::caution});
    }
    const QFont font = PaperPages::font(kTable_pt);
    const QStringList caption = pages_.linesOf(said(picture.caption), font, pages_.width());
    const QSizeF most(std::min(pages_.mm(kWidestPicture_mm), pages_.width()), pages_.mm(kHighestPicture_mm));
    constexpr double kPixel_mm = 25.4 / 96.0;  // small pictures stay small
    QSizeF size = QSizeF(image.size()) * pages_.mm(kPixel_mm);
    if (size.width() > most.width() || size.height() > most.height()) size.scale(most, Qt::KeepAspectRatio);
    pages_.makeRoom(size.height() + pages_.mm(1.0) + pages_.lineHeight(font) * caption.size());
    pages_.painter().drawImage(QRectF(QPointF(0.0, pages_.y()), size), image);
    pages_.moveOn(size.height() + pages_.mm(1.0));
    lines(caption, font, kSoftText, 0.0, pages_.width());
    gap(1.6);
  }

  PaperPages& pages_;
  const ReportOptions& options_;
  bool isSecondOfRow_ = false;
  double rowOfPlots_ = 0.0;
};

/// @param total pages; 0: not known yet @return how many there are
int print(const ReportDocument& document, const ReportOptions& options, Paper paper, int total, QByteArray& pdf) {
  pdf.clear();
  QBuffer buffer(&pdf);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(paper == Paper::letter ? QPageSize::Letter : QPageSize::A4));
  writer.setPageMargins(QMarginsF(16.0, 12.0, 16.0, 10.0), QPageLayout::Millimeter);
  writer.setResolution(kResolution_dpi);
  const QString title = QString::fromStdString(options.say(document.title));
  writer.setTitle(title);
  writer.setCreator(QStringLiteral("EchoWeave"));
  PaperPages pages(writer, title, QString::fromStdString(options.say(simulationSentence())), total);
  PaperWriter(pages, options).write(document);
  return pages.pages();
}

}  // namespace

Paper usualPaper() { return QLocale().measurementSystem() == QLocale::ImperialUSSystem ? Paper::letter : Paper::a4; }

QByteArray reportPdf(const ReportDocument& document, const ReportOptions& options, Paper paper) {
  QByteArray pdf;
  const int pages = print(document, options, paper, 0, pdf);
  print(document, options, paper, pages, pdf);
  return pdf;
}

Result<void> writeReportPdf(const ReportDocument& document, const ReportOptions& options, Paper paper, const std::filesystem::path& file) {
  const QByteArray pdf = reportPdf(document, options, paper);
  return writeFileSafely(file, std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
}

}  // namespace ew::review
