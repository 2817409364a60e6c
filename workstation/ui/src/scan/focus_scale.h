#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "scan/session.h"

namespace ew::ui {

/// The right edge of the scan view: a click or a drag puts the nearest focus mark to the depth under the pointer. It draws nothing; the
/// view draws scale and marks. While the focus is off or the image is frozen, the mouse goes through to the view.
class FocusScale final : public QWidget {
  Q_OBJECT

 public:
  /// @param depthAt_mm depth at a y of this widget's parent
  FocusScale(Session& session, std::function<double(double)> depthAt_mm, QWidget* parent);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] bool isOn() const { return session_.console().scene().focus && !session_.isFrozen(); }
  void moveTo(double y_px);

  Session& session_;
  std::function<double(double)> depthAt_mm_;
  int dragged_ = -1;
};

/// The focus depths in use, the first one resolved, mm.
[[nodiscard]] std::vector<double> fociOf(const Session& session);

}  // namespace ew::ui
