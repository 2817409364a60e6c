#pragma once

#include <QImage>
#include <QString>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "logic/slices.h"
#include "panel/stitch_look.h"
#include "panel/view_base.h"

namespace ew::stitching {

class Mosaic;

/// What the hand does in the views, shared by all of them.
struct Tools {
  enum class Hand { look, pick, paint };
  enum class Fourth { placement, displacement, seam, result };
  Hand hand = Hand::look;
  Overlay overlay = Overlay::checkerboard;
  bool flickerSecond = false;
  bool sideBySide = false;
  Fourth fourth = Fourth::placement;
  double brush_mm = 5.0;
  std::size_t brushView = 0;
};

/// A plane through one volume or through both over each other, with cross-hairs, landmarks and what else belongs into it.
/// Left drag moves the cross-hairs, wheel steps through, Ctrl + wheel zooms, middle drag shifts, right drag turns the plane.
class SliceView final : public ViewBase {
  Q_OBJECT

 public:
  enum class Kind { fixed, moving, overlap, fourth };
  SliceView(Kind kind, StitchSession& session, Tools& tools, QWidget* parent = nullptr);

  /// Asked about every key first; `act` false: only whether it is wanted.
  std::function<bool(QKeyEvent&, bool act)> keys;
  std::function<void()> toolsChanged;

  /// The pixel at which a point of this view's own frame is drawn (the moving volume's frame in the moving view, else the fixed one).
  [[nodiscard]] QPointF pixelAt(const glm::dvec3& p_mm) const override;
  void refresh();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  [[nodiscard]] bool wantsKey(QKeyEvent& event) override { return keys && keys(event, false); }

 private:
  [[nodiscard]] bool isOwnMoving() const { return kind_ == Kind::moving && !look_.isLinked(); }
  [[nodiscard]] Plane plane() const;
  void setPlane(const Plane& plane);
  [[nodiscard]] glm::dvec3 cross() const;
  void setCross(const glm::dvec3& p_mm);
  [[nodiscard]] glm::dvec3 pointUnder(const QPointF& at) const;
  void render();
  [[nodiscard]] QImage imageOfOverlap(const Plane& plane, const glm::ivec2& size, StitchLook::Stage stage) const;
  [[nodiscard]] QImage imageOfFourth(const Plane& plane, const glm::ivec2& size);
  void drawLattice(QPainter& painter) const;
  void drawLandmarks(QPainter& painter) const;
  void drawStrokes(QPainter& painter) const;
  void drawFrameWords(QPainter& painter) const;
  void paintStroke(const QPointF& at);

  const Mosaic& mosaic_;
  Kind kind_;
  Tools& tools_;
  QImage image_;
  QString nothing_;  ///< what to do when there is no image
  bool dirty_ = true;
  double longest_mm_ = 0.0;
  QPointF from_;
  Plane planeFrom_;
  QPointF pointer_{-1, -1};
  std::optional<glm::dvec3> lastStroke_;
};

}  // namespace ew::stitching
