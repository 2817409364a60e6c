#pragma once

#include <QColor>
#include <QPointF>
#include <QWidget>
#include <glm/glm.hpp>

namespace ew::stitching {

class ProjectDocument;
class ProjectInputs;
class StitchLook;
class StitchResults;
class StitchSession;

/// Colours on the black of a view, whatever the window's theme.
inline const QColor kViewQuiet(0x9b, 0xa1, 0xa8);
inline const QColor kViewBright(0xe9, 0xeb, 0xed);
inline const QColor kViewAccent(0x4f, 0xb3, 0xbf);

/// What the views of the stage share: keys that come before the window's shortcuts, small type on a dark ground, a frame for the one that
/// has the focus, and where a point is drawn.
class ViewBase : public QWidget {
  Q_OBJECT

 public:
  ViewBase(StitchSession& session, QWidget* parent);
  /// The pixel at which a point of the view's own frame is drawn.
  [[nodiscard]] virtual QPointF pixelAt(const glm::dvec3& p_mm) const = 0;
  Q_INVOKABLE QPointF pixelOfPoint(double x, double y, double z) const { return pixelAt({x, y, z}); }

 protected:
  bool event(QEvent* event) override;
  [[nodiscard]] virtual bool wantsKey(QKeyEvent& event) = 0;
  void beginPainting(QPainter& painter, const QColor& ground) const;
  void drawFocus(QPainter& painter) const;

  ProjectDocument& document_;
  const ProjectInputs& inputs_;
  const StitchResults& results_;
  StitchLook& look_;
  Qt::MouseButton dragging_ = Qt::NoButton;
};

}  // namespace ew::stitching
