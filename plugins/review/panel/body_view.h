#pragma once

#include <QPixmap>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "panel/session/review_scan.h"

namespace ew {
class BodyCanvas;
}  // namespace ew

namespace ew::bridge {
class Scene3D;
enum class CameraPreset;
}  // namespace ew::bridge

namespace ew::review {

class Playback;
class ScanPair;

/// Which regions of the volume are shown.
enum class Heat {
  none,
  trainee,   ///< how long the reviewed scan saw each
  expert,    ///< how long the other one did
  missed,    ///< that the other one saw and the reviewed one did not
  neverSeen  ///< that neither saw
};
inline constexpr int kHeats = 5;

/// Both scans on the translucent mannequin: their paths on the skin, the planes they rested at, where both probes are now, and which
/// regions were seen. Drag to look around, right drag to move, wheel to come closer.
class BodyView final : public QWidget {
  Q_OBJECT

 public:
  BodyView(const ScanPair& scans, const Playback& playback, QWidget* parent = nullptr);

  void setHeat(Heat heat);
  void setPlanesShown(bool shown);
  void showFrom(bridge::CameraPreset preset);
  /// How many regions are shown, and what they are, in words.
  [[nodiscard]] int shownRegions() const { return static_cast<int>(regions_.size()); }
  [[nodiscard]] QString heatWords() const;
  /// In the image that is painted by now.
  [[nodiscard]] QPointF pixelOf(const glm::dvec3& p_world_mm) const;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Glass;
  struct Region {
    glm::dvec3 middle_mm{0.0};
    double share = 1.0;  ///< of the longest that any was seen
  };
  void takeScans();
  void makeRegions();
  void restyle();
  void look(const std::function<void(bridge::Scene3D&)>& change);
  void moved();  ///< the camera, the room, or what is seen
  void paintOver(QPainter& painter);
  void makeStill();
  void paintRegions(QPainter& painter) const;
  void paintPath(QPainter& painter, Side side) const;
  void paintPlanes(QPainter& painter, Side side) const;
  void paintProbe(QPainter& painter, Side side) const;
  [[nodiscard]] QColor colour(Side side) const;

  const ScanPair& scans_;
  const Playback& playback_;
  BodyCanvas* canvas_ = nullptr;
  Glass* glass_ = nullptr;
  Heat heat_ = Heat::none;
  bool showsPlanes_ = true;
  const void* framedFor_ = nullptr;  ///< only compared
  std::vector<Region> regions_;
  std::optional<QPixmap> still_;  ///< all that does not change with time, as it is seen now
  QPointF last_;
};

[[nodiscard]] QString titleOf(Heat heat);

}  // namespace ew::review
