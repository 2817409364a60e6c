#include "body/host_overlays.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr double kFarthest_px = 1e5;  // beyond it a painter takes long and shows nothing
constexpr int kFilled = 36;           // of 255, of the inside of an outline
constexpr double kDot_px = 3.5;

/// Blue and orange stay apart for those who do not tell red from green; a dark ground wants them lighter.
QColor colourOf(sdk::OverlayRole role, const Theme& theme) {
  switch (role) {
    case sdk::OverlayRole::guide:
      return theme.accent;
    case sdk::OverlayRole::expert:
      return theme.dark ? QColor(110, 165, 245) : QColor(25, 95, 190);
    case sdk::OverlayRole::trainee:
      return theme.dark ? QColor(240, 160, 70) : QColor(185, 90, 0);
    case sdk::OverlayRole::quiet:
      return theme.quiet;
    case sdk::OverlayRole::danger:
      return theme.danger;
  }
  return theme.accent;
}

bool canBePainted(const QPointF& at) { return std::abs(at.x()) < kFarthest_px && std::abs(at.y()) < kFarthest_px; }

template <class Frame>
class OverlayPainter {
 public:
  OverlayPainter(QPainter& painter, const Theme& theme, const std::function<QPointF(const Point<Frame>&)>& pixelOf)
      : painter_(painter), theme_(theme), pixelOf_(pixelOf) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setFont(smallFont());
  }

  void paint(const sdk::OverlayLine<Frame>& line) {
    QPainterPath path;
    bool isBegun = false;
    for (const Point<Frame>& point : line.points) {
      const QPointF at = pixelOf_(point);
      if (!canBePainted(at)) {  // not a number is neither
        isBegun = false;
        continue;
      }
      if (isBegun)
        path.lineTo(at);
      else
        path.moveTo(at);
      isBegun = true;
    }
    if (line.isClosed && isBegun) path.closeSubpath();
    const QColor colour = colourOf(line.role, theme_);
    if (line.isFilled && line.isClosed) {
      QColor inside = colour;
      inside.setAlpha(kFilled);
      painter_.fillPath(path, inside);
    }
    const double width_px = std::isfinite(line.width_px) ? std::min(std::max(line.width_px, 0.5), 16.0) : 1.5;
    // A dark edge keeps the line legible on bright echoes and on skin.
    painter_.strokePath(path, QPen(QColor(0, 0, 0, theme_.dark ? 110 : 40), width_px + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.strokePath(path, QPen(colour, width_px, line.isDashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  }

  void paint(const sdk::OverlayLabel<Frame>& label) {
    const QPointF at = pixelOf_(label.at);
    if (!canBePainted(at)) return;
    const QColor colour = colourOf(label.role, theme_);
    if (label.hasDot) {
      painter_.setPen(QPen(QColor(0, 0, 0, 140), 1.0));
      painter_.setBrush(colour);
      painter_.drawEllipse(at, kDot_px, kDot_px);
      painter_.setBrush(Qt::NoBrush);
    }
    if (label.text.empty()) return;
    const QString text = words(label.text);
    // Measured by the font: a painter without a pen measures nothing.
    const QFontMetricsF metrics(painter_.font());
    QRectF box(at.x() + 14.0, at.y() - 0.5 * metrics.height(), metrics.horizontalAdvance(text), metrics.height());
    const QRectF room = painter_.hasClipping() ? painter_.clipBoundingRect() : QRectF(painter_.viewport());
    if (box.right() + 6.0 > room.right()) box.moveRight(at.x() - 14.0);  // on the other side of its point
    QColor veil = theme_.panel;
    veil.setAlpha(200);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(veil);
    painter_.drawRoundedRect(box.adjusted(-6.0, -3.0, 6.0, 3.0), 4.0, 4.0);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(colour);
    painter_.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, text);
  }

 private:
  QPainter& painter_;
  const Theme& theme_;
  const std::function<QPointF(const Point<Frame>&)>& pixelOf_;
};

sdk::OverlayLine<frame::World> outlineOf(const sdk::OverlayPlane& plane) {
  sdk::OverlayLine<frame::World> line;
  line.role = plane.role;
  line.isClosed = true;
  line.isFilled = true;
  for (const auto& [x, y] : {std::pair{plane.left_mm, plane.top_mm}, std::pair{plane.right_mm, plane.top_mm},
                             std::pair{plane.right_mm, plane.bottom_mm}, std::pair{plane.left_mm, plane.bottom_mm}})
    line.points.push_back(plane.probeToWorld * Point<frame::Probe>{{x, y, 0.0}});
  return line;
}

}  // namespace

/// One drawing; when it goes, what it drew goes.
template <class Drawing>
class HostOverlays::Shown final : public sdk::Overlay<Drawing> {
 public:
  explicit Shown(std::function<void()> changed) : changed_(std::move(changed)) {}
  ~Shown() override { changed_(); }
  void show(Drawing drawing) override {
    drawing_ = std::move(drawing);
    changed_();
  }
  [[nodiscard]] const Drawing& drawing() const { return drawing_; }

 private:
  std::function<void()> changed_;
  Drawing drawing_;
};

/// Handles; when it goes, they go.
class HostOverlays::HandlesEntry final : public sdk::HandlesOverlay {
 public:
  HandlesEntry(HostOverlays& host, std::shared_ptr<Handles> handles) : host_(&host), handles_(std::move(handles)) {
    host_->handles_.push_back(handles_);
    Q_EMIT host_->handlesChanged();
  }
  ~HandlesEntry() override {
    if (host_ && std::erase(host_->handles_, handles_) > 0) Q_EMIT host_->handlesChanged();
  }
  HandlesEntry(const HandlesEntry&) = delete;
  HandlesEntry& operator=(const HandlesEntry&) = delete;
  void show(sdk::BodyHandles handles) override {
    if (handles_->shown == handles) return;
    handles_->shown = std::move(handles);
    if (host_) Q_EMIT host_->handlesChanged();
  }

 private:
  QPointer<HostOverlays> host_;
  std::shared_ptr<Handles> handles_;
};

HostOverlays::HostOverlays(QObject* parent) : QObject(parent) {}

template <class Drawing>
std::shared_ptr<HostOverlays::Shown<Drawing>> HostOverlays::made(std::vector<std::weak_ptr<Shown<Drawing>>>& all,
                                                                 void (HostOverlays::*changed)()) {
  std::erase_if(all, [](const auto& one) { return one.expired(); });
  auto shown = std::make_shared<Shown<Drawing>>([host = QPointer<HostOverlays>(this), changed] {
    if (host) Q_EMIT(host.data()->*changed)();
  });
  all.push_back(shown);
  return shown;
}

std::shared_ptr<sdk::ScanOverlay> HostOverlays::overScan() { return made(scan_, &HostOverlays::scanChanged); }
std::shared_ptr<sdk::BodyOverlay> HostOverlays::overBody() { return made(body_, &HostOverlays::bodyChanged); }

sdk::Ticket HostOverlays::showInBody(const sdk::BodyAids& aids) {
  auto kept = std::make_shared<const sdk::BodyAids>(aids);
  aids_.push_back(kept);
  Q_EMIT aidsChanged();
  return sdk::Ticket(nullptr, [host = QPointer<HostOverlays>(this), kept](void*) {
    if (host && std::erase(host->aids_, kept) > 0) Q_EMIT host->aidsChanged();
  });
}

std::shared_ptr<sdk::HandlesOverlay> HostOverlays::showHandles(const sdk::BodyHandles& handles, sdk::HandlesMoved moved) {
  return std::make_shared<HandlesEntry>(*this, std::make_shared<Handles>(Handles{handles, std::move(moved)}));
}

sdk::Ticket HostOverlays::askForBodyPoint(const std::string& hint, std::function<void(const Point<frame::World>&)> pointed,
                                          std::function<void()> stopped) {
  auto kept = std::make_shared<const Asking>(Asking{words(hint), std::move(pointed), std::move(stopped)});
  askings_.push_back(kept);
  Q_EMIT askingChanged();
  return sdk::Ticket(nullptr, [host = QPointer<HostOverlays>(this), kept](void*) {
    if (host && std::erase(host->askings_, kept) > 0) Q_EMIT host->askingChanged();
  });
}

void HostOverlays::stopAsking() {
  const auto all = std::exchange(askings_, {});
  if (all.empty()) return;
  Q_EMIT askingChanged();
  for (const auto& each : all)
    if (each->stopped) each->stopped();
}

bool HostOverlays::isBodyDrawnOver() const {
  return std::any_of(body_.begin(), body_.end(), [](const auto& weak) {
    const auto shown = weak.lock();
    return shown && !(shown->drawing().lines.empty() && shown->drawing().labels.empty() && shown->drawing().planes.empty());
  });
}

void HostOverlays::paintOverScan(QPainter& painter, const std::function<QPointF(const Point<frame::Probe>&)>& pixelOf) const {
  const Theme theme = scanTheme();
  OverlayPainter<frame::Probe> over(painter, theme, pixelOf);
  for (const auto& weak : scan_) {
    const auto shown = weak.lock();
    if (!shown) continue;
    for (const auto& line : shown->drawing().lines) over.paint(line);
    for (const auto& label : shown->drawing().labels) over.paint(label);
  }
}

void HostOverlays::paintOverBody(QPainter& painter, const std::function<QPointF(const Point<frame::World>&)>& pixelOf) const {
  OverlayPainter<frame::World> over(painter, currentTheme(), pixelOf);
  for (const auto& weak : body_) {
    const auto shown = weak.lock();
    if (!shown) continue;
    for (const auto& plane : shown->drawing().planes) over.paint(outlineOf(plane));
    for (const auto& line : shown->drawing().lines) over.paint(line);
    for (const auto& label : shown->drawing().labels) over.paint(label);
  }
}

}  // namespace ew::ui
