#include "panel/slice_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ew/widgets/words.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

constexpr int kMostPixels = 400 * 1000;  // above it a plane is drawn coarser and smoothed: a drag must follow the hand
constexpr double kLattice_mm = 10.0;
const QColor kCross(0xd9, 0xb8, 0x4a);
const QColor kBehindWords(0, 0, 0, 200);

/// A word that is read on any image: dark around, as images may be bright where it stands.
void drawWord(QPainter& painter, const QRectF& box, int flags, const QString& word, const QColor& colour) {
  painter.setPen(kBehindWords);
  for (const QPointF& off : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1), QPointF(-1, -1), QPointF(1, 1)})
    painter.drawText(box.translated(off), flags, word);
  painter.setPen(colour);
  painter.drawText(box, flags, word);
}

QImage imageOf(const GreySlice& slice) {
  QImage image(slice.size.x, slice.size.y, QImage::Format_Grayscale8);
  for (int y = 0; y < slice.size.y; ++y)
    std::copy_n(slice.grey.data() + static_cast<std::ptrdiff_t>(y) * slice.size.x, slice.size.x, image.scanLine(y));
  return image;
}

QImage imageOf(const ColourSlice& slice) {
  QImage image(slice.size.x, slice.size.y, QImage::Format_RGB888);
  for (int y = 0; y < slice.size.y; ++y)
    std::copy_n(slice.rgb.data()->data() + static_cast<std::ptrdiff_t>(y) * slice.size.x * 3, 3 * slice.size.x, image.scanLine(y));
  return image;
}

}  // namespace

SliceView::SliceView(Kind kind, StitchSession& session, Tools& tools, QWidget* parent)
    : ViewBase(session, parent), mosaic_(session.mosaic()), kind_(kind), tools_(tools) {
  setMouseTracking(true);
  connect(&session, &StitchSession::changed, this, &SliceView::refresh);
  connect(&session, &StitchSession::lookChanged, this, &SliceView::refresh);
}

void SliceView::refresh() {
  dirty_ = true;
  update();
}

Plane SliceView::plane() const { return isOwnMoving() ? look_.movingPlane() : look_.plane(); }
void SliceView::setPlane(const Plane& next) {
  if (isOwnMoving())
    look_.setMovingPlane(next);
  else
    look_.setPlane(next);
}
glm::dvec3 SliceView::cross() const { return isOwnMoving() ? look_.movingCross() : look_.cross(); }
void SliceView::setCross(const glm::dvec3& p_mm) {
  if (isOwnMoving())
    look_.setMovingCross(p_mm);
  else
    look_.setCross(p_mm);
}

glm::dvec3 SliceView::pointUnder(const QPointF& at) const {
  QPointF where = at;
  if (kind_ == Kind::overlap && tools_.sideBySide) {  // both halves show the same plane
    const double half = width() / 2.0;
    where.setX((where.x() >= half ? where.x() - half : where.x()) + half / 2.0);
  }
  return pointAt(plane(), {width(), height()}, {where.x() - 0.5, where.y() - 0.5});
}

QPointF SliceView::pixelAt(const glm::dvec3& p_mm) const {
  const glm::dvec2 at = pixelOf(plane(), {width(), height()}, p_mm);
  return {at.x + 0.5, at.y + 0.5};
}

QImage SliceView::imageOfOverlap(const Plane& shown, const glm::ivec2& size, StitchLook::Stage stage) const {
  const auto fixed = inputs_.volume(look_.pair()->fixed);
  const auto moving = inputs_.volume(look_.pair()->moving);
  if (!fixed || !moving) return {};
  const int square = std::max(8, static_cast<int>(std::lround(std::min(size.x, size.y) / 7.0)));
  return imageOf(overlaid(sliced(*fixed, shown, size, look_.fixedMapping(stage)), sliced(*moving, shown, size, look_.movingMapping(stage)),
                          {tools_.overlay, square, tools_.flickerSecond}));
}

QImage SliceView::imageOfFourth(const Plane& shown, const glm::ivec2& size) {
  const ChainState* found = results_.found();
  const std::size_t fixed = look_.pair()->fixed;
  const auto toWorld = renamed<frame::World, frame::Fixed>(results_.toWorld(fixed));
  if (tools_.fourth == Tools::Fourth::displacement) {
    if (!look_.hasElastic()) {
      nothing_ = document_.project().settings.elastic ? tr("No deformation has been found yet. 'Elastic' finds one.")
                                                      : tr("The elastic step is switched off in this project.");
      return {};
    }
    const Mapping mine = look_.fixedMapping(StitchLook::Stage::elastic);
    const Mapping other = look_.movingMapping(StitchLook::Stage::elastic);
    // Every fourth pixel: a warp is smooth, and its colours are read in the large.
    const glm::ivec2 coarse = glm::max(size / 4, glm::ivec2(1));
    Plane wide = shown;
    wide.pixel_mm *= static_cast<double>(size.x) / coarse.x;
    std::vector<double> lengths;
    longest_mm_ = 0.0;
    for (int y = 0; y < coarse.y; ++y) {
      for (int x = 0; x < coarse.x; ++x) {
        const glm::dvec3 p = carried(mine.toWarp, pointAt(wide, coarse, {x, y}));
        const glm::dvec3 u = registration::displacementAt(*other.warp, p) - registration::displacementAt(*mine.warp, p);
        lengths.push_back(glm::length(u));
        longest_mm_ = std::max(longest_mm_, lengths.back());
      }
    }
    longest_mm_ = std::max(0.1, longest_mm_);
    ColourSlice slice{coarse, {}};
    for (const double length : lengths) slice.rgb.push_back(colourOfLength(length, longest_mm_));
    return imageOf(slice);
  }
  if (tools_.fourth == Tools::Fourth::seam) {
    if (found == nullptr || !found->seams) {
      nothing_ = tr("No seam has been cut yet. 'Compute mosaic' cuts it.");
      return {};
    }
    std::vector<WorldView> views;
    for (std::size_t n = 0; n < document_.project().volumes.size(); ++n) {
      const auto* warp = n < found->warps.size() && results_.isFoundFresh() ? &found->warps[n] : nullptr;
      views.push_back({inputs_.volume(n).get(), {toWorld, warp, rigidInverse(results_.toWorld(n))}});
    }
    return imageOf(seamImage(*found->seams, views, shown, size, toWorld));
  }
  const auto result = mosaic_.volume();
  if (!result) {
    nothing_ = tr("There is no stitched volume yet. 'Compute mosaic' makes it.");
    return {};
  }
  return imageOf(sliced(*result, shown, size, {toWorld, nullptr, {}}));
}

void SliceView::render() {
  dirty_ = false;
  nothing_.clear();
  image_ = {};
  if (!look_.pair()) {
    nothing_ = document_.project().volumes.empty() ? QString() : tr("Add a second volume; then pairs can be matched.");
    return;
  }
  const auto side = kind_ == Kind::moving ? look_.pair()->moving : look_.pair()->fixed;
  const auto volume = inputs_.volume(side);
  if (!volume && kind_ != Kind::fourth) {
    nothing_ = tr("%1 is being read, or cannot be read.").arg(words(document_.project().volumes[side].name));
    return;
  }
  const bool halves = kind_ == Kind::overlap && tools_.sideBySide;
  const int wide = halves ? width() / 2 : width();
  const double coarser = std::max(1.0, std::sqrt(static_cast<double>(wide) * height() / kMostPixels));
  const glm::ivec2 size = glm::max(glm::ivec2(1), glm::ivec2(glm::round(glm::dvec2(wide, height()) / coarser)));
  Plane shown = plane();
  shown.pixel_mm *= static_cast<double>(wide) / size.x;
  const auto stage = look_.stage();
  switch (kind_) {
    case Kind::fixed:
      image_ = imageOf(sliced(*volume, shown, size, look_.fixedMapping(stage)));
      break;
    case Kind::moving:
      image_ = imageOf(sliced(*volume, shown, size, isOwnMoving() ? Mapping{} : look_.movingMapping(stage)));
      break;
    case Kind::overlap:
      if (halves) {
        const QImage before = imageOfOverlap(shown, size, StitchLook::Stage::start);
        const QImage after = imageOfOverlap(shown, size, stage);
        if (before.isNull()) break;
        image_ = QImage(2 * size.x, size.y, QImage::Format_RGB888);
        QPainter both(&image_);
        both.drawImage(0, 0, before);
        both.drawImage(size.x, 0, after);
      } else {
        image_ = imageOfOverlap(shown, size, stage);
      }
      if (image_.isNull()) nothing_ = tr("Both volumes are needed here; one of them cannot be read.");
      break;
    case Kind::fourth:
      image_ = imageOfFourth(shown, size);
      break;
  }
}

void SliceView::drawLattice(QPainter& painter) const {
  const Mapping mine = look_.fixedMapping(StitchLook::Stage::elastic);
  const Mapping other = look_.movingMapping(StitchLook::Stage::elastic);
  const glm::dmat3 back = glm::transpose(glm::dmat3(mine.toWarp.matrix));
  const auto lines = deformedLattice(plane(), {width(), height()}, kLattice_mm, [&](const glm::dvec3& p) {
    const glm::dvec3 q = carried(mine.toWarp, p);
    return p + back * (registration::displacementAt(*other.warp, q) - registration::displacementAt(*mine.warp, q));
  });
  painter.setPen(QPen(QColor(255, 255, 255, 150), 1.0));
  for (const auto& line : lines) {
    QPolygonF points;
    for (const auto& p : line) points << QPointF(p.x + 0.5, p.y + 0.5);
    painter.drawPolyline(points);
  }
  // What the colours mean.
  const QRectF bar(width() - 24.0, 24.0, 8.0, std::min(120.0, height() - 48.0));
  for (int y = 0; y < static_cast<int>(bar.height()); ++y)
    painter.fillRect(QRectF(bar.left(), bar.bottom() - y - 1, bar.width(), 1.0), colourOf(colourOfLength(y, bar.height())));
  drawWord(painter, QRectF(0, bar.top() - 20, width() - 14.0, 16), Qt::AlignRight | Qt::AlignVCenter,
           QStringLiteral("%1 mm").arg(QLocale().toString(longest_mm_, 'f', 1)), kViewBright);
  drawWord(painter, QRectF(0, bar.bottom() + 2, width() - 14.0, 16), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"), kViewBright);
}

void SliceView::drawLandmarks(QPainter& painter) const {
  const auto marks = look_.landmarks();
  const auto& result = look_.landmarkResult();
  const Plane shown = plane();
  const bool moving = kind_ == Kind::moving;
  const Mapping toMoving = look_.movingMapping(look_.stage());
  const auto fromMoving = rigidInverse(toMoving.withoutWarp());
  const auto draw = [&](const glm::dvec3& own, const QString& word, const QColor& colour, bool chosen) {
    const glm::dvec3 p = moving && !isOwnMoving() ? carried(fromMoving, own) : own;
    const double off = std::abs(distanceTo(shown, p));
    if (off > 12.0) return;
    const QPointF at = pixelAt(p);
    QColor pen = colour;
    pen.setAlphaF(std::clamp(1.1 - off / 12.0, 0.25, 1.0));
    painter.setPen(QPen(QColor(0, 0, 0, 180), chosen ? 5.0 : 3.5));
    painter.setBrush(Qt::NoBrush);
    const double r = off < 1.0 ? 6.0 : 4.0;
    painter.drawEllipse(at, r, r);
    painter.setPen(QPen(pen, chosen ? 2.5 : 1.5));
    painter.drawEllipse(at, r, r);
    QPainterPath path;
    QFont font = painter.font();
    font.setBold(chosen);
    path.addText(at + QPointF(9, -5), font, word);
    painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0));
    painter.drawPath(path);
    painter.fillPath(path, pen);
  };
  for (std::size_t n = 0; n < marks.size(); ++n) {
    const bool outlying = result && std::find(result->outlying.begin(), result->outlying.end(), n) != result->outlying.end();
    draw(moving ? marks[n].moving_mm : marks[n].fixed_mm, QString::number(n + 1) + (outlying ? QStringLiteral("!") : QString()),
         outlying ? QColor(0xe0, 0x5a, 0x4e) : kCross, look_.chosenLandmark() == static_cast<int>(n));
  }
  const auto picked = moving ? look_.pickedMoving() : look_.pickedFixed();
  if (picked) draw(*picked, QString::number(marks.size() + 1) + QStringLiteral("?"), kViewAccent, true);
}

void SliceView::drawStrokes(QPainter& painter) const {
  const auto fromWorld = rigidInverse(results_.toWorld(look_.pair()->fixed));
  const Plane shown = plane();
  // Dabs of one stroke are seen as one shape: rims first, then what lies inside takes their place.
  QImage shapes(size(), QImage::Format_ARGB32_Premultiplied);
  shapes.fill(Qt::transparent);
  QPainter dabs(&shapes);
  dabs.setRenderHint(QPainter::Antialiasing);
  dabs.setPen(Qt::NoPen);
  dabs.setCompositionMode(QPainter::CompositionMode_Source);
  for (const bool rim : {true, false}) {
    for (const SeamStroke& stroke : document_.project().settings.join.seam.strokes) {
      const glm::dvec3 p = carried(fromWorld, stroke.at_mm);
      const double off = distanceTo(shown, p);
      if (std::abs(off) >= stroke.radius_mm) continue;
      const double r = std::sqrt(stroke.radius_mm * stroke.radius_mm - off * off) / shown.pixel_mm;
      QColor colour = colourOf(colourOfView(stroke.view));
      if (!rim) colour.setAlpha(70);
      dabs.setBrush(colour);
      dabs.drawEllipse(pixelAt(p), rim ? r : r - 1.5, rim ? r : r - 1.5);
    }
  }
  dabs.end();
  painter.drawImage(0, 0, shapes);
}

void SliceView::drawFrameWords(QPainter& painter) const {
  // Which way the patient lies, by the axis that points most that way.
  const glm::dmat3 turn =
      look_.pair() ? glm::dmat3(results_.toWorld(isOwnMoving() ? look_.pair()->moving : look_.pair()->fixed).matrix) : glm::dmat3(1.0);
  const auto letter = [](const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const bool up = direction[axis] > 0.0;
    return axis == 0   ? (up ? SliceView::tr("L", "patient left") : SliceView::tr("R", "patient right"))
           : axis == 1 ? (up ? SliceView::tr("P", "posterior") : SliceView::tr("A", "anterior"))
                       : (up ? SliceView::tr("H", "head") : SliceView::tr("F", "feet"));
  };
  const Plane shown = plane();
  const QRectF box = QRectF(rect()).adjusted(6, 4, -6, -4);
  drawWord(painter, box, Qt::AlignRight | Qt::AlignVCenter, letter(turn * shown.right), kViewQuiet);
  drawWord(painter, box, Qt::AlignLeft | Qt::AlignVCenter, letter(-(turn * shown.right)), kViewQuiet);
  drawWord(painter, box, Qt::AlignHCenter | Qt::AlignBottom, letter(turn * shown.down), kViewQuiet);
  drawWord(painter, box, Qt::AlignHCenter | Qt::AlignTop, letter(-(turn * shown.down)), kViewQuiet);
  // A length to compare with.
  double bar_mm = 10.0;
  while (bar_mm / shown.pixel_mm > width() / 3.0) bar_mm /= 2.0;
  while (bar_mm / shown.pixel_mm < 24.0 && bar_mm < 1000.0) bar_mm *= 2.0;
  const double length = bar_mm / shown.pixel_mm;
  const QPointF end(width() - 10.0, height() - 10.0);
  const QColor bright(0xc8, 0xcc, 0xd0);
  for (const QPen& pen : {QPen(kBehindWords, 4.0), QPen(bright, 2.0)}) {
    painter.setPen(pen);
    painter.drawLine(end - QPointF(length, 0), end);
  }
  drawWord(painter, QRectF(end.x() - 100, end.y() - 20, 100, 16), Qt::AlignRight | Qt::AlignVCenter,
           QStringLiteral("%1 mm").arg(QLocale().toString(bar_mm)), bright);
}

void SliceView::paintEvent(QPaintEvent*) {
  if (dirty_) render();
  QPainter painter(this);
  beginPainting(painter, Qt::black);
  if (image_.isNull()) {
    painter.setPen(kViewQuiet);
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, nothing_);
    return drawFocus(painter);
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), image_);
  const bool halves = kind_ == Kind::overlap && tools_.sideBySide;
  if (kind_ == Kind::fourth && tools_.fourth == Tools::Fourth::displacement) {
    drawLattice(painter);
    drawFrameWords(painter);
  } else if (!halves) {
    drawFrameWords(painter);
  }
  if (halves) {
    painter.setPen(QPen(kViewQuiet, 1.0));
    painter.drawLine(QPointF(width() / 2.0, 0), QPointF(width() / 2.0, height()));
    painter.setPen(kViewBright);
    painter.drawText(QRectF(8, height() - 24, width() / 2.0 - 16, 18), Qt::AlignLeft | Qt::AlignVCenter, tr("before"));
    painter.drawText(QRectF(width() / 2.0 + 8, height() - 24, width() / 2.0 - 16, 18), Qt::AlignLeft | Qt::AlignVCenter, tr("after"));
  }
  const bool seam = kind_ == Kind::fourth && tools_.fourth == Tools::Fourth::seam;
  if (seam || (kind_ == Kind::overlap && tools_.hand == Tools::Hand::paint && !halves)) drawStrokes(painter);
  if (seam) {
    // Which colour is whose.
    double y = height() - 12.0 - 16.0 * static_cast<double>(document_.project().volumes.size());
    for (std::size_t n = 0; n < document_.project().volumes.size(); ++n, y += 16.0) {
      painter.fillRect(QRectF(10, y + 3, 10, 10), colourOf(colourOfView(n)));
      painter.setPen(kViewBright);
      painter.drawText(QRectF(26, y, 60, 16), Qt::AlignLeft | Qt::AlignVCenter, words(letterOf(n)));
    }
  }
  if (!halves) {
    // A gap where the lines cross: what is looked at must be seen.
    const QPointF at = pixelAt(cross());
    QColor colour = kCross;
    colour.setAlpha(kind_ == Kind::fourth ? 120 : 200);
    painter.setPen(QPen(colour, 1.0));
    constexpr double kGap = 6.0, kArm = 48.0;
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
      painter.drawLine(at + kGap * way, at + kArm * way);
  }
  if (kind_ == Kind::fixed || kind_ == Kind::moving) drawLandmarks(painter);
  if (tools_.hand == Tools::Hand::paint && pointer_.x() >= 0 && (kind_ == Kind::overlap || seam) && !halves) {
    painter.setPen(QPen(colourOf(colourOfView(tools_.brushView)), 1.5));
    painter.setBrush(Qt::NoBrush);
    const double r = tools_.brush_mm / plane().pixel_mm;
    painter.drawEllipse(pointer_, r, r);
  }
  drawFocus(painter);
}

void SliceView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  dirty_ = true;
  if (kind_ == Kind::fixed) look_.setViewSide(std::min(width(), height()));
}

void SliceView::paintStroke(const QPointF& at) {
  const glm::dvec3 p = carried(results_.toWorld(look_.pair()->fixed), pointUnder(at));
  if (lastStroke_ && glm::length(*lastStroke_ - p) < 0.5 * tools_.brush_mm) return;
  lastStroke_ = p;
  document_.edit(withStroke(document_.project(), {tools_.brushView, p, tools_.brush_mm}),
                 tr("prefer %1 at the seam").arg(words(letterOf(tools_.brushView))), "stroke");
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (!look_.pair() || image_.isNull()) return;
  from_ = event->localPos();
  planeFrom_ = plane();
  dragging_ = event->button();
  if (dragging_ != Qt::LeftButton) return;
  const bool seam = kind_ == Kind::fourth && tools_.fourth == Tools::Fourth::seam;
  if (tools_.hand == Tools::Hand::pick && (kind_ == Kind::fixed || kind_ == Kind::moving)) {
    dragging_ = Qt::NoButton;
    const glm::dvec3 p = pointUnder(from_);
    const bool moving = kind_ == Kind::moving;
    look_.pick(moving, moving && !isOwnMoving() ? look_.movingMapping(look_.stage())(p) : p);
  } else if (tools_.hand == Tools::Hand::paint && (seam || kind_ == Kind::overlap)) {
    lastStroke_.reset();
    document_.endMerging();
    paintStroke(from_);
  } else {
    setCross(pointUnder(from_));
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->localPos();
  if (tools_.hand == Tools::Hand::paint) update();
  if (dragging_ == Qt::NoButton || !look_.pair()) return;
  const QPointF way = pointer_ - from_;
  const bool seam = kind_ == Kind::fourth && tools_.fourth == Tools::Fourth::seam;
  if (dragging_ == Qt::LeftButton) {
    if (tools_.hand == Tools::Hand::paint && (seam || kind_ == Kind::overlap))
      paintStroke(pointer_);
    else
      setCross(pointUnder(pointer_));
  } else if (dragging_ == Qt::MiddleButton) {
    Plane next = planeFrom_;
    next.centre_mm -= next.pixel_mm * (way.x() * next.right + way.y() * next.down);
    setPlane(next);
  } else if (dragging_ == Qt::RightButton) {
    setPlane(turned(planeFrom_, cross(), {-0.4 * way.y(), 0.4 * way.x(), 0.0}));
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent*) {
  if (dragging_ == Qt::LeftButton && tools_.hand == Tools::Hand::paint) document_.endMerging();
  dragging_ = Qt::NoButton;
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && tools_.hand == Tools::Hand::look) look_.fit();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!look_.pair()) return;
  const double turns = event->angleDelta().y() / 120.0;
  if (turns == 0.0) return;
  Plane next = plane();
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    // What is under the pointer stays there.
    const glm::dvec3 held = pointUnder(event->position());
    const double factor = std::pow(1.2, -turns);
    const double pixel_mm = std::clamp(next.pixel_mm * factor, 0.01, 5.0);
    next.centre_mm = held + (next.centre_mm - held) * (pixel_mm / next.pixel_mm);
    next.pixel_mm = pixel_mm;
    setPlane(next);
  } else {
    const double step_mm = event->modifiers().testFlag(Qt::ShiftModifier) ? 5.0 : 1.0;
    setCross(cross() + turns * step_mm * next.normal());
  }
  event->accept();
}

void SliceView::leaveEvent(QEvent*) {
  pointer_ = {-1, -1};
  update();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (!keys || !keys(*event, true)) QWidget::keyPressEvent(event);
}

}  // namespace ew::stitching
