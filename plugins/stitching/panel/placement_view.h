#pragma once

#include <QImage>
#include <QPolygonF>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/volume.h"
#include "ew/stitching/chain.h"
#include "logic/slices.h"
#include "panel/view_base.h"

namespace ew::stitching {

class AlignmentEdits;

/// The subvolumes as boxes with their middle slices, in their places, seen from a far eye (orthographic). A box is dragged to where it
/// belongs; with Ctrl it is turned. Right drag turns the view, the wheel brings it closer.
class PlacementView final : public ViewBase {
  Q_OBJECT

 public:
  explicit PlacementView(StitchSession& session, QWidget* parent = nullptr);
  [[nodiscard]] QPointF pixelAt(const glm::dvec3& p_world_mm) const override;
  void lookFrom(Cut cut);
  void fit();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  [[nodiscard]] bool wantsKey(QKeyEvent& event) override;

 private:
  struct Sheet {
    QImage image;
    glm::dvec3 corner_mm{0.0}, along_mm{0.0}, down_mm{0.0};  ///< in the volume's own frame: first pixel's corner and the two edges
  };
  [[nodiscard]] const std::vector<Sheet>& sheetsOf(std::size_t volume);
  [[nodiscard]] int volumeUnder(const QPointF& at);
  [[nodiscard]] QPolygonF outline(const Sheet& sheet, const Transform<frame::World, frame::View>& toWorld) const;
  void place(std::size_t volume, const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg);

  AlignmentEdits& edits_;
  std::map<const Volume*, std::pair<std::weak_ptr<const Volume>, std::vector<Sheet>>> sheets_;
  glm::dvec3 right_{1.0, 0.0, 0.0}, down_{0.0, 0.0, -1.0};
  glm::dvec3 centre_mm_{0.0};
  double mmPerPixel_ = 1.0;
  bool fitted_ = false;
  QPointF last_;
  std::optional<std::size_t> held_;
  bool turning_ = false;
  Transform<frame::World, frame::View> heldFrom_;
  glm::dvec3 wayOf_{0.0}, turnOf_{0.0};
  std::size_t fittedFor_ = 0;
  const ChainState* foundFor_ = nullptr;  ///< only compared
};

}  // namespace ew::stitching
