#include "panel/placement_view.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QResizeEvent>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "ew/widgets/words.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

constexpr int kSheet_px = 128;

}  // namespace

PlacementView::PlacementView(StitchSession& session, QWidget* parent) : ViewBase(session, parent), edits_(session.edits()) {
  setObjectName(QStringLiteral("placementView"));
  setToolTip({});
  lookFrom(Cut::coronal);
  // A little from above and from the side, so that depth can be read.
  const Plane seen = turned({{}, right_, down_, 1.0}, {}, {-18.0, 24.0, 0.0});
  right_ = seen.right;
  down_ = seen.down;
  connect(&session, &StitchSession::changed, this, [this] {
    // After a run things may lie far from where they were; while a hand drags, the view stays.
    if (fittedFor_ != document_.project().volumes.size() || foundFor_ != results_.found()) fitted_ = false;
    update();
  });
}

void PlacementView::lookFrom(Cut cut) {
  const Plane plane = planeOf(cut, {}, 1.0);
  right_ = plane.right;
  down_ = plane.down;
  update();
}

QPointF PlacementView::pixelAt(const glm::dvec3& p) const {
  const glm::dvec3 from = p - centre_mm_;
  return {width() / 2.0 + glm::dot(from, right_) / mmPerPixel_, height() / 2.0 + glm::dot(from, down_) / mmPerPixel_};
}

void PlacementView::fit() {
  glm::dvec3 low(1e300), high(-1e300);
  bool any = false;
  for (std::size_t n = 0; n < document_.project().volumes.size(); ++n) {
    const auto volume = inputs_.volume(n);
    if (!volume) continue;
    any = true;
    const Bounds box = boundsOf(placed(volume->grid, results_.toWorld(n)));
    low = glm::min(low, box.lowest_mm);
    high = glm::max(high, box.highest_mm);
  }
  fittedFor_ = document_.project().volumes.size();
  foundFor_ = results_.found();
  if (!any) return;
  fitted_ = true;
  centre_mm_ = 0.5 * (low + high);
  const double across = glm::length(high - low);
  mmPerPixel_ = std::max(1e-3, 0.95 * across / std::max(40, std::min(width(), height())));
}

const std::vector<PlacementView::Sheet>& PlacementView::sheetsOf(std::size_t index) {
  static const std::vector<Sheet> none;
  const auto volume = inputs_.volume(index);
  if (!volume) return none;
  auto& kept = sheets_[volume.get()];
  if (kept.first.lock() == volume) return kept.second;
  kept.first = volume;
  kept.second.clear();
  const Grid& grid = volume->grid;
  const glm::dvec3 extent = glm::dvec3(grid.dims) * grid.spacing_mm;
  const glm::dvec3 middle = middleOf(grid);
  for (int axis = 0; axis < 3; ++axis) {
    const int a = axis == 0 ? 1 : 0;
    const int b = axis == 2 ? 1 : 2;
    const double pixel_mm = std::max(extent[a], extent[b]) / kSheet_px;
    const glm::ivec2 size = glm::max(glm::ivec2(2), glm::ivec2(glm::round(glm::dvec2(extent[a], extent[b]) / pixel_mm)));
    const Plane plane{middle, grid.directions[a], grid.directions[b], pixel_mm};
    const GreySlice slice = sliced(*volume, plane, size, {});
    QImage image(size.x, size.y, QImage::Format_ARGB32);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const std::size_t at = static_cast<std::size_t>(y * size.x + x);
        const int grey = slice.grey[at];
        image.setPixel(x, y, slice.seen[at] != 0 ? qRgba(grey, grey, grey, 225) : qRgba(0, 0, 0, 0));
      }
    const glm::dvec3 along = pixel_mm * size.x * plane.right;
    const glm::dvec3 down = pixel_mm * size.y * plane.down;
    kept.second.push_back({image, middle - 0.5 * along - 0.5 * down, along, down});
  }
  return kept.second;
}

QPolygonF PlacementView::outline(const Sheet& sheet, const Transform<frame::World, frame::View>& toWorld) const {
  return {{pixelAt(carried(toWorld, sheet.corner_mm)), pixelAt(carried(toWorld, sheet.corner_mm + sheet.along_mm)),
           pixelAt(carried(toWorld, sheet.corner_mm + sheet.along_mm + sheet.down_mm)),
           pixelAt(carried(toWorld, sheet.corner_mm + sheet.down_mm))}};
}

void PlacementView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  beginPainting(painter, QColor(0x12, 0x13, 0x15));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const std::size_t count = document_.project().volumes.size();
  if (count == 0) return drawFocus(painter);
  if (!fitted_) fit();
  struct Seen {
    std::size_t volume;
    const Sheet* sheet;
    double depth;
  };
  std::vector<Seen> order;
  const glm::dvec3 away = glm::cross(right_, down_);
  for (std::size_t n = 0; n < count; ++n) {
    const auto toWorld = results_.toWorld(n);
    for (const Sheet& sheet : sheetsOf(n))
      order.push_back({n, &sheet, glm::dot(carried(toWorld, sheet.corner_mm + 0.5 * (sheet.along_mm + sheet.down_mm)), away)});
  }
  std::stable_sort(order.begin(), order.end(), [](const Seen& a, const Seen& b) { return a.depth > b.depth; });
  for (const Seen& seen : order) {
    const QPolygonF corners = outline(*seen.sheet, results_.toWorld(seen.volume));
    // Seen from afar a rectangle is a parallelogram: an affine map takes the image there.
    const QPointF along = (corners[1] - corners[0]) / seen.sheet->image.width();
    const QPointF down = (corners[3] - corners[0]) / seen.sheet->image.height();
    if (std::abs(along.x() * down.y() - along.y() * down.x()) < 1e-4) continue;  // edge on
    painter.save();
    painter.setTransform(QTransform(along.x(), along.y(), down.x(), down.y(), corners[0].x(), corners[0].y()), true);
    painter.drawImage(QPointF(0, 0), seen.sheet->image);
    painter.restore();
  }
  std::vector<QRectF> chips;
  for (std::size_t n = 0; n < count; ++n) {
    const auto volume = inputs_.volume(n);
    if (!volume) continue;
    const auto voxelToWorld = results_.toWorld(n) * volume->grid.voxelTo<frame::View>();
    const bool chosen = look_.chosenVolume() == n || held_ == n;
    QColor colour = colourOf(colourOfView(n));
    colour.setAlpha(chosen ? 255 : 150);
    painter.setPen(QPen(colour, chosen ? 2.0 : 1.0));
    QPointF corner[8];
    for (int c = 0; c < 8; ++c) {
      const glm::dvec3 voxel = glm::dvec3(c & 1, (c >> 1) & 1, c >> 2) * glm::dvec3(volume->grid.dims) - 0.5;
      corner[c] = pixelAt(carried(voxelToWorld, voxel));
    }
    for (int c = 0; c < 8; ++c)
      for (const int bit : {1, 2, 4})
        if ((c & bit) == 0) painter.drawLine(corner[c], corner[c | bit]);
    const QPointF* top = std::min_element(corner, corner + 8, [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    QRectF chip(top->x() - 10, std::max(2.0, top->y() - 20), 20, 17);
    // Boxes that nobody has placed yet lie in each other: their letters stand side by side.
    while (std::any_of(chips.begin(), chips.end(), [&](const QRectF& other) { return other.intersects(chip); })) chip.translate(22, 0);
    chips.push_back(chip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(chip, 3, 3);
    painter.setPen(colour.lighter(chosen ? 115 : 100));
    painter.drawText(chip, Qt::AlignCenter, words(letterOf(n)));
    painter.setBrush(Qt::NoBrush);
  }
  // Which way the patient lies.
  const QPointF origin(34, height() - 34);
  const std::pair<glm::dvec3, QString> axes[] = {
      {{1, 0, 0}, tr("L", "patient left")}, {{0, 1, 0}, tr("P", "posterior")}, {{0, 0, 1}, tr("H", "head")}};
  for (const auto& [direction, letter] : axes) {
    const QPointF way(glm::dot(direction, right_), glm::dot(direction, down_));
    painter.setPen(QPen(kViewQuiet, 1.0));
    painter.drawLine(origin, origin + 18.0 * way);
    if (std::hypot(way.x(), way.y()) > 0.3)
      painter.drawText(QRectF(origin + 26.0 * way - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, letter);
  }
  painter.setPen(kViewQuiet);
  painter.drawText(QRectF(64, height() - 40, width() - 72, 34), Qt::AlignRight | Qt::AlignBottom | Qt::TextWordWrap,
                   tr("Drag a box to move it, with Ctrl to turn it; right drag turns the view"));
  drawFocus(painter);
}

void PlacementView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int before = std::min(event->oldSize().width(), event->oldSize().height());
  if (before > 0) mmPerPixel_ *= static_cast<double>(before) / std::max(1, std::min(width(), height()));
}

int PlacementView::volumeUnder(const QPointF& at) {
  int found = -1;
  double nearest = 1e300;
  const glm::dvec3 away = glm::cross(right_, down_);
  for (std::size_t n = 0; n < document_.project().volumes.size(); ++n) {
    const auto toWorld = results_.toWorld(n);
    for (const Sheet& sheet : sheetsOf(n)) {
      if (!outline(sheet, toWorld).containsPoint(at, Qt::OddEvenFill)) continue;
      const double depth = glm::dot(carried(toWorld, sheet.corner_mm + 0.5 * (sheet.along_mm + sheet.down_mm)), away);
      // The chosen one first: what was placed last is often behind others.
      const double counted = look_.chosenVolume() == n ? -1e299 : depth;
      if (counted < nearest) {
        nearest = counted;
        found = static_cast<int>(n);
      }
    }
  }
  return found;
}

void PlacementView::place(std::size_t index, const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  wayOf_ += shift_mm;
  turnOf_ += rotation_deg;
  const auto volume = inputs_.volume(index);
  if (!volume) return;
  const glm::dvec3 middle = carried(heldFrom_ * volume->grid.voxelTo<frame::View>(), 0.5 * (glm::dvec3(volume->grid.dims) - 1.0));
  const QLocale locale;
  const QString letter = words(letterOf(index));
  const bool turns = turnOf_ != glm::dvec3(0.0);
  edits_.setPlace(index, motionOf<frame::World>(wayOf_, turnOf_, middle) * heldFrom_,
                  turns ? tr("rotate %1 by %2°").arg(letter, locale.toString(glm::length(turnOf_), 'f', 0))
                        : tr("move %1 by %2 mm").arg(letter, locale.toString(glm::length(wayOf_), 'f', 1)),
                  "place " + std::to_string(index));
}

void PlacementView::mousePressEvent(QMouseEvent* event) {
  last_ = event->localPos();
  dragging_ = event->button();
  held_.reset();
  if (dragging_ != Qt::LeftButton) return;
  const int under = volumeUnder(last_);
  if (under < 0) return;
  held_ = static_cast<std::size_t>(under);
  turning_ = event->modifiers().testFlag(Qt::ControlModifier);
  heldFrom_ = results_.toWorld(*held_);
  wayOf_ = turnOf_ = glm::dvec3(0.0);
  document_.endMerging();
  look_.chooseVolume(*held_);
}

void PlacementView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF way = event->localPos() - last_;
  last_ = event->localPos();
  if (dragging_ == Qt::LeftButton && held_) {
    if (turning_)
      place(*held_, {}, 0.4 * (way.x() * down_ * -1.0 + way.y() * right_));
    else
      place(*held_, mmPerPixel_ * (way.x() * right_ + way.y() * down_), {});
  } else if (dragging_ == Qt::MiddleButton) {
    centre_mm_ -= mmPerPixel_ * (way.x() * right_ + way.y() * down_);
    update();
  } else if (dragging_ != Qt::NoButton) {
    const Plane seen = turned({{}, right_, down_, 1.0}, {}, {-0.5 * way.y(), 0.5 * way.x(), 0.0});
    right_ = seen.right;
    down_ = seen.down;
    update();
  }
}

void PlacementView::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = Qt::NoButton;
  if (held_) document_.endMerging();
  held_.reset();
  update();
}

void PlacementView::mouseDoubleClickEvent(QMouseEvent*) {
  fit();
  update();
}

void PlacementView::wheelEvent(QWheelEvent* event) {
  mmPerPixel_ = std::clamp(mmPerPixel_ * std::pow(1.2, -event->angleDelta().y() / 120.0), 1e-3, 100.0);
  update();
  event->accept();
}

void PlacementView::keyPressEvent(QKeyEvent* event) {
  const bool ctrl = event->modifiers().testFlag(Qt::ControlModifier);
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 2.0;
  glm::dvec3 way{0.0};
  switch (event->key()) {
    case Qt::Key_Left:
      way = -right_;
      break;
    case Qt::Key_Right:
      way = right_;
      break;
    case Qt::Key_Up:
      way = -down_;
      break;
    case Qt::Key_Down:
      way = down_;
      break;
    case Qt::Key_1:
      return lookFrom(Cut::axial);
    case Qt::Key_2:
      return lookFrom(Cut::coronal);
    case Qt::Key_3:
      return lookFrom(Cut::sagittal);
    case Qt::Key_0:
      fit();
      return update();
    default:
      return QWidget::keyPressEvent(event);
  }
  if (!look_.chosenVolume()) return;
  const std::size_t chosen = *look_.chosenVolume();
  if (!event->isAutoRepeat()) document_.endMerging();
  heldFrom_ = results_.toWorld(chosen);
  wayOf_ = turnOf_ = glm::dvec3(0.0);
  if (ctrl)
    place(chosen, {}, 0.5 * step * glm::dvec3(glm::cross(glm::cross(right_, down_), way)));
  else
    place(chosen, step * way, {});
}

bool PlacementView::wantsKey(QKeyEvent& event) {
  constexpr std::array kOwn = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_0};
  return std::find(kOwn.begin(), kOwn.end(), event.key()) != kOwn.end();
}

}  // namespace ew::stitching
