#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "ew/imaging/display.h"
#include "ew/scanning/state.h"
#include "ew/widgets/worker.h"
#include "scan/session.h"

namespace ew::ui {

class ScanView;

/// In a corner of a zoomed image the whole of it, small, with the part that is shown as a box; a drag moves the box. The small image is
/// formed on a thread of its own, some five times a second at most, so that the image itself waits for nothing.
class ZoomOverview final : public QWidget {
  Q_OBJECT

 public:
  ZoomOverview(Session& session, ScanView& scan);
  ~ZoomOverview() override;

  /// Of the present image, or of one a moment ago; null before the first.
  [[nodiscard]] const QImage& image() const { return image_; }
  /// The part that is shown, in widget coordinates.
  [[nodiscard]] QRectF box() const;
  [[nodiscard]] bool isUpToDate() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void place();
  void form();
  void moveTo(const QPointF& at);
  [[nodiscard]] const DisplayGeometry& geometryOfWhole() const;
  /// What the small image is to show.
  [[nodiscard]] ScanState wanted() const;

  Session& session_;
  ScanView& scan_;
  QImage image_;
  DisplayGeometry geometry_;
  std::optional<ScanState> formed_;  ///< of image_
  bool isForming_ = false;
  bool isDragged_ = false;
  QTimer soon_;
  struct Former;
  std::shared_ptr<Former> former_;  ///< the worker's
  Worker worker_;
};

}  // namespace ew::ui
