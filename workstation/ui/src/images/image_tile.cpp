#include "images/image_tile.h"

#include <QMouseEvent>
#include <QPainter>

#include "annotate/annotation_layer.h"
#include "annotate/body_mark_view.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"
#include "measure/calipers/caliper_layer.h"
#include "scan/scan_view.h"

namespace ew::ui {

ImageTile::ImageTile(Jobs& jobs, QWidget* parent)
    : QWidget(parent), calipers_(session_, jobs), annotated_(session_), mark_(session_), view_(new ScanView(session_, this)) {
  setObjectName(QStringLiteral("keptPicture"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(tr("Another image"));
  setToolTip(
      tipWithKeys(tr("Click to measure or write on this image, or to scan where there is none yet (%1: the next image)"), "pictures.next"));
  view_->setObjectName(QStringLiteral("keptScanView"));
  view_->setAttribute(Qt::WA_TransparentForMouseEvents);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->setControlsEnabled(false);
  new CaliperLayer(session_, calipers_, *view_);
  new AnnotationLayer(session_, annotated_, *view_);
  markView_ = new BodyMarkView(mark_, *view_);
  connect(&session_, &Session::imageChanged, this, &ImageTile::showOrHide);
  connect(&calipers_, &Calipers::changed, markView_, &QWidget::raise);  // the calipers came to lie over it
  showOrHide();
}

ImageTile::~ImageTile() {
  // The views look at what is a member here.
  session_.disconnect();
  calipers_.disconnect();
  annotated_.disconnect();
  mark_.disconnect();
  delete view_;
}

void ImageTile::clear() {
  session_.clear();
  showOrHide();
}

void ImageTile::setMarkCorner(int corner) { markView_->placeIn(corner); }

void ImageTile::showOrHide() {
  view_->setVisible(!isEmpty());
  update();
}

void ImageTile::resizeEvent(QResizeEvent*) { view_->setGeometry(rect()); }

void ImageTile::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  // Later: what is asked for may move this image elsewhere while it handles its event.
  QMetaObject::invokeMethod(this, &ImageTile::asked, Qt::QueuedConnection);
}

void ImageTile::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!isEmpty()) return;
  painter.setFont(textFont());
  painter.setPen(scanTheme().quiet);
  painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, tr("No image here yet. Click to scan here."));
}

}  // namespace ew::ui
