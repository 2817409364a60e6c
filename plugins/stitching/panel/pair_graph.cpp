#include "panel/pair_graph.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/widgets/words.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

constexpr double kNode_px = 15.0;
constexpr double kReach_px = 9.0;

}  // namespace

void drawMark(QPainter& painter, const QRectF& box, StitchResults::Mark mark, const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = colourOfMark(mark, palette);
  const double side = std::min(box.width(), box.height());
  const QPointF c = box.center();
  const bool filled =
      mark == StitchResults::Mark::aligned || mark == StitchResults::Mark::notAligned || mark == StitchResults::Mark::cannotTell;
  painter.setPen(QPen(colour, 1.5));
  painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
  painter.drawEllipse(c, side / 2 - 0.75, side / 2 - 0.75);
  const double r = side * 0.22;
  QPen sign(filled ? palette.color(QPalette::Window) : colour, std::max(1.4, side / 8));
  sign.setCapStyle(Qt::RoundCap);
  painter.setPen(sign);
  painter.setBrush(Qt::NoBrush);
  switch (mark) {
    case StitchResults::Mark::aligned:
      painter.drawPolyline(QPolygonF({c + QPointF(-r, 0.1 * r), c + QPointF(-0.2 * r, 0.8 * r), c + QPointF(1.1 * r, -0.8 * r)}));
      break;
    case StitchResults::Mark::landmarks:
      painter.drawLine(c + QPointF(-1.2 * r, 0), c + QPointF(1.2 * r, 0));
      painter.drawLine(c + QPointF(0, -1.2 * r), c + QPointF(0, 1.2 * r));
      break;
    case StitchResults::Mark::byHand:
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      painter.drawEllipse(c, r, r);
      break;
    case StitchResults::Mark::cannotTell: {
      QFont font = painter.font();
      font.setPixelSize(static_cast<int>(side * 0.85));
      font.setBold(true);
      painter.setFont(font);
      painter.drawText(box, Qt::AlignCenter, QStringLiteral("?"));
      break;
    }
    case StitchResults::Mark::notAligned:
      painter.drawLine(c + QPointF(-r, -r), c + QPointF(r, r));
      painter.drawLine(c + QPointF(-r, r), c + QPointF(r, -r));
      break;
    case StitchResults::Mark::rejected:
      painter.drawLine(c + QPointF(-1.2 * r, 0), c + QPointF(1.2 * r, 0));
      break;
    case StitchResults::Mark::unknown:
      break;
  }
  painter.restore();
}

PairGraph::PairGraph(StitchSession& session, QWidget* parent)
    : QWidget(parent), document_(session.document()), results_(session.results()), look_(session.look()) {
  setObjectName(QStringLiteral("pairGraph"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Graph of pairs"));
  lines_ = results_.pairs(look_.pair());
  connect(&session, &StitchSession::changed, this, [this] {
    lines_ = results_.pairs(look_.pair());
    update();
  });
}

QSize PairGraph::sizeHint() const { return {264, 208}; }
QSize PairGraph::minimumSizeHint() const { return {200, 104}; }

QPointF PairGraph::nodeAt(std::size_t volume) const {
  const auto count = static_cast<double>(std::max<std::size_t>(1, document_.project().volumes.size()));
  const QPointF middle(width() / 2.0, height() / 2.0);
  if (count < 2) return middle;
  // The first at the upper left, as one reads; two stand side by side.
  const double turn = count == 2 ? std::numbers::pi : std::numbers::pi * (1.0 + 1.0 / count);
  const double angle = turn + 2.0 * std::numbers::pi * static_cast<double>(volume) / count;
  const double rx = std::min(width() / 2.0 - kNode_px - 6.0, 112.0);
  const double ry = std::min(height() / 2.0 - kNode_px - 6.0, 112.0);
  return middle + QPointF(rx * std::cos(angle), ry * std::sin(angle));
}

QPointF PairGraph::middleOfEdge(std::size_t a, std::size_t b) const {
  // Not quite the middle: there the diagonals of a ring would meet.
  return nodeAt(a) + 0.4 * (nodeAt(b) - nodeAt(a));
}

void PairGraph::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& chosen = look_.pair();
  const auto* under = nodeUnder(pointer_) >= 0 ? nullptr : edgeUnder(pointer_);
  const auto draw = [&](const StitchResults::PairLine& line) {
    const bool isChosen = chosen && chosen->fixed == line.fixed && chosen->moving == line.moving;
    const bool isUnder = under != nullptr && under->fixed == line.fixed && under->moving == line.moving;
    const QLineF edge(nodeAt(line.fixed), nodeAt(line.moving));
    QPen pen(colourOfMark(line.mark, palette()), isChosen ? 4.0 : isUnder ? 3.0 : 2.0);
    using Mark = StitchResults::Mark;
    if (line.mark == Mark::unknown) {
      pen.setWidthF(isChosen ? 3.0 : isUnder ? 2.0 : 1.0);
      pen.setStyle(Qt::DotLine);
    } else if (line.mark == Mark::byHand) {
      pen.setDashPattern({8.0, 3.0});
    } else if (line.mark == Mark::cannotTell) {
      pen.setDashPattern({4.0, 3.0});
    } else if (line.mark == Mark::notAligned) {
      pen.setDashPattern({1.5, 2.0});
    } else if (line.mark == Mark::rejected) {
      pen.setStyle(Qt::DashDotLine);
    }
    if (isChosen) {
      QColor halo = palette().color(QPalette::Highlight);
      halo.setAlpha(70);
      painter.setPen(QPen(halo, 11.0, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(edge);
    }
    painter.setPen(pen);
    painter.drawLine(edge);
    const bool isGiven = line.mark == Mark::byHand || line.mark == Mark::landmarks;
    if (isGiven || line.mark == Mark::notAligned || line.mark == Mark::rejected || line.stale) {
      const QPointF at = middleOfEdge(line.fixed, line.moving);
      painter.setPen(Qt::NoPen);
      painter.setBrush(palette().color(QPalette::Window));
      painter.drawEllipse(at, 8.0, 8.0);
      if (line.stale && line.mark != Mark::rejected) {
        painter.setPen(QPen(colourOfMark(Mark::cannotTell, palette()), 1.8));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(QRectF(at.x() - 5, at.y() - 5, 10, 10), 60 * 16, 300 * 16);  // to be done again
      } else {
        drawMark(painter, QRectF(at.x() - 6, at.y() - 6, 12, 12), line.mark, palette());
      }
    }
  };
  for (const auto& line : lines_) draw(line);
  for (const auto& line : lines_)
    if (chosen && chosen->fixed == line.fixed && chosen->moving == line.moving) draw(line);
  QFont font = this->font();
  font.setBold(true);
  painter.setFont(font);
  for (std::size_t n = 0; n < document_.project().volumes.size(); ++n) {
    const QPointF at = nodeAt(n);
    const bool isChosen = chosen && (chosen->fixed == n || chosen->moving == n);
    painter.setPen(QPen(palette().color(isChosen ? QPalette::Highlight : QPalette::PlaceholderText), isChosen ? 2.5 : 1.5));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at, kNode_px, kNode_px);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(at.x() - 16, at.y() - 16, 32, 32), Qt::AlignCenter, words(letterOf(n)));
  }
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
}

int PairGraph::nodeUnder(const QPointF& at) const {
  for (std::size_t n = 0; n < document_.project().volumes.size(); ++n)
    if (QLineF(at, nodeAt(n)).length() <= kNode_px + 2.0) return static_cast<int>(n);
  return -1;
}

const StitchResults::PairLine* PairGraph::edgeUnder(const QPointF& at) const {
  const StitchResults::PairLine* nearest = nullptr;
  double least = kReach_px;
  for (const auto& line : lines_) {
    const QPointF from = nodeAt(line.fixed);
    const QPointF along = nodeAt(line.moving) - from;
    const double length2 = QPointF::dotProduct(along, along);
    if (length2 == 0.0) continue;
    const double share = std::clamp(QPointF::dotProduct(at - from, along) / length2, 0.0, 1.0);
    const double distance = QLineF(at, from + share * along).length();
    if (distance < least) {
      least = distance;
      nearest = &line;
    }
  }
  return nearest;
}

void PairGraph::mousePressEvent(QMouseEvent* event) {
  if (const int node = nodeUnder(event->localPos()); node >= 0) {
    look_.chooseVolume(static_cast<std::size_t>(node));
  } else if (const auto* edge = edgeUnder(event->localPos())) {
    look_.choosePair(edge->fixed, edge->moving);
  }
}

void PairGraph::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->localPos();
  setCursor(nodeUnder(pointer_) >= 0 || edgeUnder(pointer_) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void PairGraph::leaveEvent(QEvent*) {
  pointer_ = {-1, -1};
  update();
}

void PairGraph::chooseNext(int step) {
  if (lines_.empty()) return;
  int at = -1;
  for (std::size_t n = 0; n < lines_.size(); ++n)
    if (look_.pair() && look_.pair()->fixed == lines_[n].fixed && look_.pair()->moving == lines_[n].moving) at = static_cast<int>(n);
  const int count = static_cast<int>(lines_.size());
  const auto& next = lines_[static_cast<std::size_t>(at < 0 ? 0 : (at + step + count) % count)];
  look_.choosePair(next.fixed, next.moving);
}

void PairGraph::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Down:
      return chooseNext(1);
    case Qt::Key_Left:
    case Qt::Key_Up:
      return chooseNext(-1);
    default:
      QWidget::keyPressEvent(event);
  }
}

bool PairGraph::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) {
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QString text;
    if (const int node = nodeUnder(help->pos()); node >= 0) {
      text = QStringLiteral("%1: %2").arg(words(letterOf(static_cast<std::size_t>(node))),
                                          words(document_.project().volumes[static_cast<std::size_t>(node)].name));
    } else if (const auto* edge = edgeUnder(help->pos())) {
      text = tr("%1 to %2: %3").arg(words(letterOf(edge->fixed)), words(letterOf(edge->moving)), wordsOfMark(edge->mark));
      if (edge->wrong) text += QStringLiteral(", ") + tr("against what the other pairs say");
      if (edge->stale) text += QStringLiteral(", ") + tr("changed since it was matched");
    }
    if (text.isEmpty())
      QToolTip::hideText();
    else
      QToolTip::showText(help->globalPos(), text, this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace ew::stitching
