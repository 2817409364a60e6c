#include "ew/body/body_canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QEvent>
#include <QList>
#include <QMetaObject>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "body_drawing.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

/// A plugin has this library once more: its canvases are known by the name of their class, and asked by names.
QList<QWidget*> canvasesSeenIn(const QWidget& window) {
  QList<QWidget*> found;
  for (QWidget* each : window.findChildren<QWidget*>())
    if (each->isVisible() && each->inherits(BodyCanvas::staticMetaObject.className())) found.push_back(each);
  return found;
}

}  // namespace

BodyCanvas::BodyCanvas(QWidget* parent) : QWidget(parent), scene_(std::make_unique<bridge::Scene3D>(*asked_)) {
  const auto tell = [this] {
    QMetaObject::invokeMethod(
        this, [this] { take(); }, Qt::QueuedConnection);
  };
  drawing_ = std::make_unique<BodyDrawing>(tell);
  setAttribute(Qt::WA_OpaquePaintEvent);
  asked_->SetReadyForRendering(false);
  resizeScenes();
}

BodyCanvas::~BodyCanvas() = default;

bool BodyCanvas::isValid() const { return drawing_->canDraw() && !hasGivenUp_; }
bool BodyCanvas::isSoftware() const { return drawing_->isSoftware(); }
bool BodyCanvas::isDrawing() const { return drawing_->isDrawing(); }
double BodyCanvas::took_ms() const { return drawing_->took_ms(); }
vtkGenericOpenGLRenderWindow& BodyCanvas::renderWindow() const { return drawing_->renderWindow(); }

void BodyCanvas::change(const Change& change) {
  change(*scene_);
  drawing_->change(change);
}

void BodyCanvas::changeLooks(Change change) { drawing_->change(std::move(change)); }

bridge::Sight BodyCanvas::sight() const {
  bridge::Sight seen = image_.isNull() ? scene_->sight() : sight_;
  const bool isStretched = !image_.isNull() && image_.size() != size_px();
  seen.window_px = isStretched ? glm::dvec2(width(), height()) : seen.window_px / devicePixelRatioF();
  return seen;
}

/// All that is seen of the widget, where its edge lies within a pixel of the screen too.
QSize BodyCanvas::size_px() const {
  const double ratio = devicePixelRatioF();
  return QSize(static_cast<int>(std::ceil(width() * ratio)), static_cast<int>(std::ceil(height() * ratio))).expandedTo({1, 1});
}

/// @return whether their size is another one than it was
bool BodyCanvas::resizeScenes() {
  if (sized_px_ == size_px()) return false;
  sized_px_ = size_px();
  asked_->SetSize(sized_px_.width(), sized_px_.height());
  static_cast<void>(scene_->mmPerPixelAt(glm::dvec3(0.0)));
  drawing_->resize(sized_px_);
  return true;
}

void BodyCanvas::draw(bridge::Scene3D::Edges edges) {
  EW_EXPECTS(isValid());
  resizeScenes();
  drawing_->draw(edges);
}

bool BodyCanvas::drawNow(bridge::Scene3D::Edges edges) {
  draw(edges);
  return finish();
}

bool BodyCanvas::finish() {
  drawing_->wait();
  take();
  return isDrawn_;
}

bool BodyCanvas::isAnyDrawing(const QWidget& window) {
  const QList<QWidget*> canvases = canvasesSeenIn(window);
  return std::any_of(canvases.begin(), canvases.end(), [](const QWidget* each) { return each->property("drawing").toBool(); });
}

bool BodyCanvas::finishAll(const QWidget& window) {
  bool isDrawn = true;
  for (QWidget* each : canvasesSeenIn(window)) {
    bool isOne = false;
    QMetaObject::invokeMethod(each, "finish", Qt::DirectConnection, Q_RETURN_ARG(bool, isOne));
    isDrawn = isDrawn && isOne;
  }
  return isDrawn;
}

void BodyCanvas::take() {
  std::optional<BodyDrawing::Ended> ended = drawing_->takeEnded();
  if (!ended) return;  // drawNow() was earlier
  isDrawn_ = ended->isDrawn;
  hasGivenUp_ = !ended->hasContext;
  if (!ended->image.isNull()) {
    image_ = std::move(ended->image);
    sight_ = ended->sight;
    update();
    Q_EMIT drawn();
  }
  if (!ended->isDrawn) Q_EMIT notDrawn();
}

bool BodyCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ScreenChangeInternal && resizeScenes()) Q_EMIT pixelsChanged();
  return QWidget::event(event);
}

void BodyCanvas::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  if (image_.isNull()) return painter.fillRect(event->rect(), palette().color(QPalette::Window));
  // Until it is drawn in its new size the last one fills the place.
  if (image_.size() != size_px()) {
    image_.setDevicePixelRatio(1.0);
    return painter.drawImage(rect(), image_);
  }
  const double ratio = devicePixelRatioF();
  // The edge of the widget may lie within a pixel of the screen, which the image covers in part or not at all.
  if (ratio != std::floor(ratio)) painter.fillRect(rect(), QColor(image_.pixel(image_.width() - 1, image_.height() - 1)));
  image_.setDevicePixelRatio(ratio);
  painter.drawImage(QPoint(0, 0), image_);
}

void BodyCanvas::resizeEvent(QResizeEvent*) { resizeScenes(); }

void BodyCanvas::showEvent(QShowEvent*) {
  drawing_->begin();
  if (!isValid()) Q_EMIT notDrawn();
}

}  // namespace ew
