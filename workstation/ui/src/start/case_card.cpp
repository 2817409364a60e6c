#include "start/case_card.h"

#include <QPainterPath>
#include <QTextLayout>
#include <algorithm>

#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kTitleLines = 2;
constexpr int kIndicationLines = 2;
constexpr int kBar_px = 3;

/// A fan drawn in the accent's tone, for a case without an image: shape, not data.
void paintFan(QPainter& painter, const QRect& box) {
  const Theme theme = scanTheme();
  QPainterPath fan;
  const QPointF apex(box.center().x(), box.top() - 24.0);
  const double inner = 48.0;
  const double outer = box.height() + 8.0;
  fan.arcMoveTo(QRectF(apex.x() - inner, apex.y() - inner, 2 * inner, 2 * inner), 240);
  fan.arcTo(QRectF(apex.x() - inner, apex.y() - inner, 2 * inner, 2 * inner), 240, 60);
  fan.arcTo(QRectF(apex.x() - outer, apex.y() - outer, 2 * outer, 2 * outer), 300, -60);
  fan.closeSubpath();
  QColor fill = theme.accent;
  fill.setAlphaF(0.16);
  painter.setPen(QPen(theme.accent, 1.25));
  painter.setBrush(Qt::NoBrush);
  painter.fillPath(fan, fill);
  painter.drawPath(fan);
}

void paintImage(QPainter& painter, const QRect& box, const QImage* image) {
  painter.save();
  QPainterPath rounded;
  rounded.addRoundedRect(QRectF(box), 4, 4);
  painter.setClipPath(rounded);
  painter.fillRect(box, Qt::black);
  if (image == nullptr || image->isNull()) {
    paintFan(painter, box);
  } else {
    const QSize fitted = image->size().scaled(box.size(), Qt::KeepAspectRatioByExpanding);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect(box.center() - QPoint(fitted.width() / 2, fitted.height() / 2), fitted), *image);
  }
  painter.restore();
}

/// At most `lines` lines, the last one ending in an ellipsis when there is more. @return below what was painted
int paintText(QPainter& painter, const QRect& box, int lines, const QString& text, Qt::LayoutDirection direction) {
  if (text.isEmpty()) return box.top();
  const QFontMetrics metrics(painter.font());
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  option.setTextDirection(direction);
  option.setAlignment(direction == Qt::RightToLeft ? Qt::AlignRight : Qt::AlignLeft);
  QTextLayout layout(text, painter.font());
  layout.setTextOption(option);
  layout.beginLayout();
  int y = box.top();
  for (int n = 0; n < lines; ++n, y += metrics.lineSpacing()) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(box.width());
    if (n + 1 == lines && line.textStart() + line.textLength() < text.size()) {
      const QString rest = metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, box.width());
      painter.drawText(QRect(box.left(), y, box.width(), metrics.lineSpacing()), static_cast<int>(option.alignment()), rest);
    } else {
      line.draw(&painter, QPointF(box.left(), y));
    }
  }
  layout.endLayout();
  return y;
}

/// The one line below the title: region, level.
QString factsOf(const CaseRow& row) {
  QStringList facts{words(row.region), row.level ? levelWords(*row.level) : QString()};
  facts.removeAll(QString());
  return facts.join(QStringLiteral(" · "));
}

QString lessonsText(const CaseRow& row) { return lessonWords(row.lessons.size()) + QStringLiteral(" \u25be"); }

/// On the image, which is black in both themes.
void paintLessons(QPainter& painter, const QRect& box, const QString& text, bool isUnderMouse) {
  const Theme theme = scanTheme();
  painter.setPen(QPen(isUnderMouse ? theme.accent : theme.line, 1.0));
  QColor ground = theme.panel;
  ground.setAlphaF(0.88);
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.setFont(smallFont());
  painter.setPen(isUnderMouse ? theme.accent : theme.text);
  painter.drawText(box, Qt::AlignCenter, text);
}

void paintBar(QPainter& painter, const QRect& box, double fraction, Qt::LayoutDirection direction) {
  const Theme& theme = currentTheme();
  painter.fillRect(box, theme.line);
  const int done_px = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * box.width());
  painter.fillRect(
      direction == Qt::RightToLeft ? box.adjusted(box.width() - done_px, 0, 0, 0) : QRect(box.topLeft(), QSize(done_px, box.height())),
      theme.accent);
}

}  // namespace

QRect lessonsRect(const QRect& box, const CaseRow& row, Qt::LayoutDirection direction) {
  if (row.lessons.empty()) return {};
  const QFontMetrics metrics(smallFont());
  const int inset_px = kCardMargin_px + 8;
  const QSize size(metrics.horizontalAdvance(lessonsText(row)) + 16, metrics.height() + 8);
  const int left = direction == Qt::RightToLeft ? box.left() + inset_px : box.right() + 1 - inset_px - size.width();
  return {QPoint(left, box.top() + inset_px), size};
}

int cardHeight_px() {
  const QFontMetrics title(bold(textFont())), small(smallFont());
  return 2 * kCardMargin_px + kCardImage_px + 8 + kTitleLines * title.lineSpacing() + (2 + kIndicationLines) * small.lineSpacing() + 16;
}

void paintCard(QPainter& painter, const QRect& box, const CardLook& look) {
  const Theme& theme = currentTheme();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look.isCurrent ? theme.accent : look.isUnderMouse ? theme.quiet : theme.line, look.isCurrent ? 2.0 : 1.0));
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(QRectF(box).adjusted(1, 1, -1, -1), 6, 6);
  const QRect inside = box.adjusted(kCardMargin_px, kCardMargin_px, -kCardMargin_px, -kCardMargin_px);
  paintImage(painter, QRect(inside.topLeft(), QSize(inside.width(), kCardImage_px)), look.image);
  if (look.row == nullptr) return painter.restore();
  if (const QRect lessons = lessonsRect(box, *look.row, look.direction); !lessons.isEmpty())
    paintLessons(painter, lessons, lessonsText(*look.row), look.isLessonsUnderMouse);
  int y = inside.top() + kCardImage_px + 8;
  painter.setFont(bold(textFont()));
  painter.setPen(theme.text);
  y = paintText(painter, QRect(inside.left(), y, inside.width(), 0), kTitleLines, words(look.row->title), look.direction) + 4;
  painter.setFont(smallFont());
  painter.setPen(theme.quiet);
  y = paintText(painter, QRect(inside.left(), y, inside.width(), 0), 1, factsOf(*look.row), look.direction) + 4;
  paintText(painter, QRect(inside.left(), y, inside.width(), 0), kIndicationLines, words(look.row->indication), look.direction);
  const int bottom = inside.bottom() + 1;
  const bool isLearnt = look.row->progress.has_value() && look.state.text.isEmpty();
  if (look.state.fraction > 0.0 || isLearnt)
    paintBar(painter, QRect(inside.left(), bottom - kBar_px, inside.width(), kBar_px), isLearnt ? *look.row->progress : look.state.fraction,
             look.direction);
  if (const QString text = isLearnt ? progressWords(*look.row) : look.state.text; !text.isEmpty()) {
    const int line_px = QFontMetrics(smallFont()).lineSpacing();
    painter.setPen(theme.text);
    paintText(painter, QRect(inside.left(), bottom - kBar_px - 3 - line_px, inside.width(), 0), 1, text, look.direction);
  }
  painter.restore();
}

}  // namespace ew::ui
