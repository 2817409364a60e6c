#include "panel/body_view.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ew/body/body_canvas.h"
#include "ew/bridge/mannequin.h"
#include "ew/imaging/display.h"
#include "ew/widgets/theme.h"
#include "panel/review_words.h"
#include "panel/session/playback.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

namespace {

constexpr double kTranslucent = 0.4;
constexpr double kLeastShare = 0.12;  // of what was seen shortest, so that it is seen at all

}  // namespace

/// Above the drawn scene, and through it goes every click.
class BodyView::Glass final : public QWidget {
 public:
  explicit Glass(BodyView* view) : QWidget(view), view_(view) { setAttribute(Qt::WA_TransparentForMouseEvents); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    view_->paintOver(painter);
  }

 private:
  BodyView* view_;
};

QString titleOf(Heat heat) {
  switch (heat) {
    case Heat::none:
      return BodyView::tr("Regions: off");
    case Heat::trainee:
      return BodyView::tr("Seen by the trainee");
    case Heat::expert:
      return BodyView::tr("Seen by the expert");
    case Heat::missed:
      return BodyView::tr("Missed by the trainee");
    case Heat::neverSeen:
      return BodyView::tr("Seen by neither");
  }
  return {};
}

BodyView::BodyView(const ScanPair& scans, const Playback& playback, QWidget* parent) : QWidget(parent), scans_(scans), playback_(playback) {
  setObjectName(QStringLiteral("reviewBody"));
  setAccessibleName(tr("Both scans on the body"));
  setMinimumSize(160, 160);
  canvas_ = new BodyCanvas(this);
  canvas_->setObjectName(QStringLiteral("reviewBodyCanvas"));
  canvas_->setAccessibleName(accessibleName());
  canvas_->setFocusPolicy(Qt::ClickFocus);
  canvas_->changeLooks([](bridge::Scene3D& scene) {
    scene.setBodyOpacity(kTranslucent);
    scene.setProbeVisible(false);
  });
  restyle();
  canvas_->installEventFilter(this);
  glass_ = new Glass(this);
  connect(&scans_, &ScanPair::changed, this, &BodyView::takeScans);
  // What lies over the body moves with it, not before it.
  connect(canvas_, &BodyCanvas::drawn, this, [this] {
    still_.reset();
    glass_->update();
  });
  connect(canvas_, &BodyCanvas::pixelsChanged, this, &BodyView::moved);
  connect(&playback_, &Playback::timeChanged, this, [this] { glass_->update(); });
  takeScans();
}

QColor BodyView::colour(Side side) const { return colourOf(whoOf(side), currentTheme().dark); }

void BodyView::takeScans() {
  if (scans_.mannequin() && canvas_->scene().mannequin() != scans_.mannequin())
    canvas_->change([mannequin = scans_.mannequin()](bridge::Scene3D& scene) { scene.setMannequin(mannequin); });
  const ReviewScan* scan = scans_.opened(kReviewed) != nullptr ? scans_.opened(kReviewed) : scans_.opened(kCompared);
  if (scan == nullptr) {
    canvas_->change([](bridge::Scene3D& scene) { scene.clearVolumeBox(); });
    framedFor_ = nullptr;
  } else {
    canvas_->change([grid = scan->subject.placedGrid](bridge::Scene3D& scene) {
      scene.setVolumeBox(grid);
      scene.setBoxVisible(true);
    });
    const void* about = scan->subject.voxels.volume().get();
    if (framedFor_ != about) {
      canvas_->change([](bridge::Scene3D& scene) {
        scene.showFrom(bridge::CameraPreset::front);
        scene.fitToVolume();
        scene.orbit(0.45, 0.3);
        scene.zoom(1.3);
      });
    }
    framedFor_ = about;
  }
  makeRegions();
  moved();
}

void BodyView::setHeat(Heat heat) {
  heat_ = heat;
  makeRegions();
  still_.reset();
  glass_->update();
}

void BodyView::setPlanesShown(bool shown) {
  showsPlanes_ = shown;
  still_.reset();
  glass_->update();
}

void BodyView::makeRegions() {
  regions_.clear();
  const ReviewScan* first = scans_.opened(kReviewed);
  const ReviewScan* second = scans_.opened(kCompared);
  const ReviewScan* base = heat_ == Heat::expert ? second : first;
  if (heat_ == Heat::none || base == nullptr || base->regions == nullptr) return;
  const bool isShared = first != nullptr && second != nullptr && first->regions == second->regions;
  if (heat_ == Heat::missed && !isShared) return;
  const double longest = std::max(1e-6, static_cast<double>(base->seen.longest_s()));
  for (std::size_t n = 0; n < base->regions->count(); ++n) {
    const bool isSeen = base->seen.frames[n] > 0;
    const bool isSeenByOther = isShared && second->seen.frames[n] > 0;
    const bool isShown = heat_ == Heat::missed ? !isSeen && isSeenByOther : heat_ == Heat::neverSeen ? !isSeen && !isSeenByOther : isSeen;
    if (!isShown) continue;
    // A second more tells little where there were many: the square root spreads the short ones.
    const bool isTime = heat_ == Heat::trainee || heat_ == Heat::expert;
    regions_.push_back({glm::dvec3(base->regions->middles_mm()[n]),
                        isTime ? std::max(kLeastShare, std::sqrt(static_cast<double>(base->seen.seconds[n]) / longest)) : 1.0});
  }
}

QString BodyView::heatWords() const {
  const ReviewScan* base = scans_.opened(heat_ == Heat::expert ? kCompared : kReviewed);
  if (heat_ == Heat::none || base == nullptr) return {};
  if (base->regions == nullptr) return tr("The volume is too large to be kept in memory; its regions are not counted.");
  const ReviewScan* other = scans_.opened(kCompared);
  if (heat_ == Heat::missed && (other == nullptr || other->regions != base->regions))
    return tr("Both scans have to be of one case for this.");
  const QLocale locale;
  const double share = 100.0 * static_cast<double>(regions_.size()) / static_cast<double>(std::max<std::size_t>(1, base->regions->count()));
  QString text = tr("%1 % of the volume").arg(locale.toString(share, 'f', 1));
  if (heat_ == Heat::trainee || heat_ == Heat::expert)
    text += QStringLiteral("  ·  ") + tr("longest %1 s").arg(locale.toString(static_cast<double>(base->seen.longest_s()), 'f', 1));
  return text;
}

void BodyView::showFrom(bridge::CameraPreset preset) {
  look([preset](bridge::Scene3D& scene) { scene.showFrom(preset); });
}

void BodyView::look(const std::function<void(bridge::Scene3D&)>& change) {
  canvas_->change(change);
  moved();
}

void BodyView::restyle() {
  canvas_->changeLooks([colours = currentTheme().dark ? bridge::darkColours() : bridge::lightColours()](bridge::Scene3D& scene) {
    scene.setColours(colours);
  });
}

void BodyView::moved() {
  if (isVisible() && canvas_->isValid()) return canvas_->draw(bridge::Scene3D::Edges::smooth);
  still_.reset();
  glass_->update();
}

void BodyView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  canvas_->setGeometry(rect());
  glass_->setGeometry(rect());
  glass_->raise();
  moved();
}

void BodyView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  moved();
}

void BodyView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || canvas_ == nullptr) return;
  restyle();
  moved();
}

bool BodyView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != canvas_) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      last_ = static_cast<QMouseEvent*>(event)->localPos();
      canvas_->setFocus(Qt::MouseFocusReason);
      return true;
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->buttons() == Qt::NoButton) return true;
      const QPointF way = mouse->localPos() - last_;
      last_ = mouse->localPos();
      if (mouse->buttons().testFlag(Qt::LeftButton))
        look([way](bridge::Scene3D& scene) { scene.orbit(-0.01 * way.x(), 0.01 * way.y()); });
      else
        look([by_px = canvas_->devicePixelRatioF() * glm::dvec2(way.x(), way.y())](bridge::Scene3D& scene) { scene.pan(by_px); });
      return true;
    }
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      return true;
    case QEvent::Wheel:
      look([factor = std::pow(1.001, static_cast<QWheelEvent*>(event)->angleDelta().y())](bridge::Scene3D& scene) { scene.zoom(factor); });
      return true;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

QPointF BodyView::pixelOf(const glm::dvec3& p_world_mm) const {
  const glm::dvec2 at = canvas_->sight().pixelOf(p_world_mm);
  return {at.x, at.y};
}

}  // namespace ew::review
