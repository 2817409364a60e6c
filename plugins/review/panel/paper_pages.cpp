#include "panel/paper_pages.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QTextLayout>

namespace ew::review {
namespace {

constexpr double kEdgeText_pt = 8.0, kHeadRoom_mm = 10.0, kFootRoom_mm = 9.0;
const QColor kSoftInk(0x4d, 0x56, 0x5f);

}  // namespace

PaperPages::PaperPages(QPdfWriter& writer, QString title, QString foot, int total)
    : writer_(writer), painter_(&writer), title_(std::move(title)), foot_(std::move(foot)), total_(total) {
  dotsPerMm_ = writer.resolution() / 25.4;
  width_ = painter_.viewport().width();
  top_ = y_ = mm(kHeadRoom_mm);
  bottom_ = painter_.viewport().height() - mm(kFootRoom_mm);
  drawEdges();
}

void PaperPages::makeRoom(double height) {
  if (height > roomLeft() && !isFresh()) nextPage();
}

void PaperPages::nextPage() {
  writer_.newPage();
  ++page_;
  y_ = top_;
  drawEdges();
}

QFont PaperPages::font(double size_pt, bool isBold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPointSizeF(size_pt);
  font.setBold(isBold);
  return font;
}

QStringList PaperPages::linesOf(const QString& text, const QFont& font, double width) {
  QStringList lines;
  for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
    QTextLayout layout(paragraph, font, &writer_);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine one = layout.createLine(); one.isValid(); one = layout.createLine()) {
      one.setLineWidth(width);
      lines << paragraph.mid(one.textStart(), one.textLength()).trimmed();
    }
    layout.endLayout();
    if (paragraph.isEmpty()) lines << QString();
  }
  return lines;
}

double PaperPages::lineHeight(const QFont& font) { return QFontMetricsF(font, &writer_).lineSpacing(); }

double PaperPages::widthOf(const QString& text, const QFont& font) { return QFontMetricsF(font, &writer_).horizontalAdvance(text); }

void PaperPages::line(const QString& text, const QFont& font, const QColor& colour, double x, double y, double width,
                      Qt::Alignment alignment) {
  painter_.setFont(font);
  painter_.setPen(colour);
  painter_.drawText(QRectF(x, y, width, lineHeight(font)),
                    static_cast<int>(alignment | Qt::AlignTop) | Qt::TextSingleLine | Qt::TextDontClip, text);
}

void PaperPages::drawEdges() {
  const QFont small = font(kEdgeText_pt);
  const QFontMetricsF metrics(small, &writer_);
  const QString number = total_ > 0 ? QCoreApplication::translate("ew::review", "Page %1 of %2").arg(page_).arg(total_) : QString();
  const double room = width_ - metrics.horizontalAdvance(number) - mm(6.0);
  line(metrics.elidedText(title_, Qt::ElideRight, room), small, kSoftInk, 0.0, 0.0, room);
  line(number, small, kSoftInk, 0.0, 0.0, width_, Qt::AlignRight);
  painter_.setPen(QPen(QColor(0xc9, 0xcf, 0xd6), mm(0.2)));
  painter_.drawLine(QPointF(0.0, mm(5.5)), QPointF(width_, mm(5.5)));
  line(foot_, small, kSoftInk, 0.0, bottom_ + mm(4.0), width_);
}

}  // namespace ew::review
