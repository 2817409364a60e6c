#include "trackers/wizard/tracker_body_drawing.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

constexpr double kAroundBody_px = 16.0;
constexpr double kAroundPlaces_mm = 90.0;
constexpr double kPlaceReach_px = 14.0;  ///< of a click

void paintSign(QPainter& painter, const QPointF& at, TrackerBodyDrawing::Mark mark, const Theme& theme) {
  using Mark = TrackerBodyDrawing::Mark;
  const double r = scaled(mark == Mark::next ? 9.0 : 6.0);
  painter.setBrush(Qt::NoBrush);
  switch (mark) {
    case Mark::offered:
      painter.setPen(QPen(theme.quiet, 1.5));
      painter.drawEllipse(at, r / 2.0, r / 2.0);
      return;
    case Mark::next:
      painter.setPen(QPen(theme.accent, 2.5));
      painter.drawEllipse(at, r, r);
      painter.drawLine(at - QPointF(1.7 * r, 0.0), at - QPointF(0.6 * r, 0.0));
      painter.drawLine(at + QPointF(0.6 * r, 0.0), at + QPointF(1.7 * r, 0.0));
      painter.drawLine(at - QPointF(0.0, 1.7 * r), at - QPointF(0.0, 0.6 * r));
      painter.drawLine(at + QPointF(0.0, 0.6 * r), at + QPointF(0.0, 1.7 * r));
      return;
    case Mark::taken:
      painter.setPen(QPen(theme.accent, 1.5));
      painter.setBrush(theme.accent);
      painter.drawEllipse(at, r, r);
      painter.setPen(QPen(theme.onAccent, 2.0));
      painter.drawPolyline(QPolygonF(
          QVector<QPointF>{at + QPointF(-0.45 * r, 0.05 * r), at + QPointF(-0.1 * r, 0.4 * r), at + QPointF(0.5 * r, -0.35 * r)}));
      return;
    case Mark::bad:
      painter.setPen(QPen(theme.danger, 3.0));
      painter.drawLine(at - QPointF(r, r), at + QPointF(r, r));
      painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
      return;
  }
}

}  // namespace

TrackerBodyDrawing::TrackerBodyDrawing(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("trackerBody"));
  setAccessibleName(tr("The mannequin from the front, with the places to be touched"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize TrackerBodyDrawing::sizeHint() const { return {scaled(280), scaled(400)}; }
QSize TrackerBodyDrawing::minimumSizeHint() const { return {scaled(180), scaled(220)}; }

void TrackerBodyDrawing::setBody(const std::vector<glm::vec3>& points_mm) {
  body_ = points_mm;
  if (!body_.empty()) {
    low_ = glm::dvec2(1e9);
    high_ = glm::dvec2(-1e9);
    for (const glm::vec3& p : body_) {
      low_ = glm::min(low_, glm::dvec2(p.x, p.z));
      high_ = glm::max(high_, glm::dvec2(p.x, p.z));
    }
  }
  paintBody();
  update();
}

void TrackerBodyDrawing::lookAt(const std::vector<glm::dvec3>& places_mm) {
  if (places_mm.empty()) return;
  low_ = glm::dvec2(1e9);
  high_ = glm::dvec2(-1e9);
  for (const glm::dvec3& p : places_mm) {
    low_ = glm::min(low_, glm::dvec2(p.x, p.z) - kAroundPlaces_mm);
    high_ = glm::max(high_, glm::dvec2(p.x, p.z) + kAroundPlaces_mm);
  }
  paintBody();
  update();
}

void TrackerBodyDrawing::setPlaces(std::vector<Place> places) {
  places_ = std::move(places);
  QStringList said;
  for (const Place& each : places_)
    if (each.mark == Mark::next) said << tr("next: %1").arg(each.name);
  setAccessibleDescription(said.join(QStringLiteral("; ")));
  update();
}

void TrackerBodyDrawing::setProbe(const std::optional<glm::dvec3>& at_mm) {
  if (probe_ == at_mm) return;
  probe_ = at_mm;
  update();
}

double TrackerBodyDrawing::scale() const {
  const glm::dvec2 size_mm = glm::max(high_ - low_, glm::dvec2(1.0));
  return std::min((width() - 2.0 * kAroundBody_px) / size_mm.x, (height() - 2.0 * kAroundBody_px) / size_mm.y);
}

/// The patient's left is at the right, the head above.
QPointF TrackerBodyDrawing::pixelOf(const glm::dvec3& at_mm) const {
  const glm::dvec2 middle = 0.5 * (low_ + high_);
  return {width() / 2.0 + (at_mm.x - middle.x) * scale(), height() / 2.0 - (at_mm.z - middle.y) * scale()};
}

/// Each corner of the surface that faces the viewer as a dot of its shade: enough to know a body by, and quick.
void TrackerBodyDrawing::paintBody() {
  shade_ = QImage(size(), QImage::Format_ARGB32_Premultiplied);
  shade_.fill(Qt::transparent);
  if (body_.empty() || width() < 8 || height() < 8) return;
  double front = 1e9;
  double back = -1e9;
  for (const glm::vec3& p : body_) {
    front = std::min(front, static_cast<double>(p.y));
    back = std::max(back, static_cast<double>(p.y));
  }
  std::vector<const glm::vec3*> byDepth;
  byDepth.reserve(body_.size());
  for (const glm::vec3& p : body_) byDepth.push_back(&p);
  std::sort(byDepth.begin(), byDepth.end(), [](const glm::vec3* a, const glm::vec3* b) { return a->y > b->y; });
  const Theme& theme = currentTheme();
  QPainter painter(&shade_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const double r = std::max(2.0, 6.0 * scale());
  for (const glm::vec3* p : byDepth) {
    const double nearness = std::clamp((back - static_cast<double>(p->y)) / std::max(back - front, 1.0), 0.0, 1.0);
    const double share = theme.dark ? 0.18 + 0.4 * nearness : 0.12 + 0.3 * nearness;
    const auto mixed = [share](int ground, int text) { return static_cast<int>(std::lround(ground + (text - ground) * share)); };
    painter.setBrush(QColor(mixed(theme.ground.red(), theme.quiet.red()), mixed(theme.ground.green(), theme.quiet.green()),
                            mixed(theme.ground.blue(), theme.quiet.blue())));
    painter.drawEllipse(pixelOf(glm::dvec3(*p)), r, r);
  }
}

void TrackerBodyDrawing::resizeEvent(QResizeEvent*) { paintBody(); }

void TrackerBodyDrawing::paintEvent(QPaintEvent*) {
  const Theme& theme = currentTheme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme.ground);
  painter.drawImage(0, 0, shade_);
  painter.setFont(smallFont());
  painter.setPen(theme.quiet);
  const QRect edges = rect().adjusted(8, 8, -8, -8);
  painter.drawText(edges, Qt::AlignLeft | Qt::AlignTop, tr("patient's right"));
  painter.drawText(edges, Qt::AlignRight | Qt::AlignTop, tr("left"));
  for (const Mark mark : {Mark::offered, Mark::taken, Mark::bad, Mark::next})  // what counts most lies over the others
    for (const Place& each : places_)
      if (each.mark == mark) paintSign(painter, pixelOf(each.at_mm), mark, theme);
  if (!probe_) return;
  const QPointF at = pixelOf(*probe_);
  painter.setPen(QPen(theme.text, 2.0));
  painter.setBrush(theme.ground);
  painter.drawRoundedRect(QRectF(at.x() - 5.0, at.y() - 5.0, 10.0, 10.0), 2.0, 2.0);
}

void TrackerBodyDrawing::mousePressEvent(QMouseEvent* event) {
  const Place* nearest = nullptr;
  double distance = kPlaceReach_px;
  for (const Place& each : places_) {
    const QPointF to = pixelOf(each.at_mm) - event->localPos();
    const double away = std::hypot(to.x(), to.y());
    if (away >= distance) continue;
    distance = away;
    nearest = &each;
  }
  if (nearest != nullptr) Q_EMIT chosen(QString::fromStdString(nearest->id));
}

}  // namespace ew::ui
