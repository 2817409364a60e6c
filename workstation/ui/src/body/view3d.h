#pragma once

#include <QPoint>
#include <QString>
#include <QWidget>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/bridge/mannequin.h"
#include "ew/bridge/organ_surfaces.h"
#include "ew/bridge/scene3d.h"
#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

class QPainter;

namespace ew::ui {

/// The mannequin with volume box, probe and live fan, as an interactive image. Every setter asks for one redraw soon
/// after the current turn of the event loop; nothing is drawn twice. Points are in logical pixels of its canvas, above which
/// the buttons of the camera stand.
class View3D : public QWidget {
  Q_OBJECT

 public:
  explicit View3D(QWidget* parent = nullptr);
  ~View3D() override;

  void setMannequin(std::shared_ptr<const bridge::Mannequin> mannequin);
  /// The surface the probe slides on; before a mannequin is set an ellipsoid of a trunk's size, never null.
  [[nodiscard]] std::shared_ptr<const Skin> skin() const;

  /// How much of what lies below each corner of the mannequin's surface was recorded, 0..1; empty: unknown.
  void setCoverage(std::vector<float> shares);
  void setVolumeBox(const Grid& grid);
  void clearVolumeBox();

  void setProbe(const Probe& probe, double depth_mm, const Knobs& knobs = {});
  void setPose(const Pose& pose);  ///< a pose that is not ok hides probe and fan
  void setProbeVisible(bool visible);
  /// Pixels and where they lie; copied, so the view may change afterwards.
  void setFanImage(const DisplayImage& image, const DisplayGeometry& geometry);
  void clearFanImage();  ///< the fan becomes a tinted pane
  /// The same, and asks for no drawing.
  void bringFanImage(const DisplayImage& image, const DisplayGeometry& geometry);
  /// Called before each drawing, to bring what only a drawing needs: not every image of the scan is drawn here.
  void setBeforeDrawing(std::function<void()> bring);

  void setDarkTheme(bool dark);
  void setBodyOpacity(double opacity);  ///< 0..1; the user's choice
  /// What a lesson shows in place of what the user chose; empty: the user's choice counts again.
  struct Aids {
    bool translucent = false;
    bool box = false;
    std::shared_ptr<const bridge::OrganSurfaces> organs;
  };
  void setAids(std::optional<Aids> aids);
  [[nodiscard]] QString defaultHint() const;

  void showFrom(bridge::CameraPreset preset);
  void fitToVolume();  ///< looks at the volume box, or at the trunk when there is none

  /// Draws once, soon, on the canvas's own thread: after what is to be painted now, and after a rest from the end of the last drawing,
  /// twice as long as that took, ten times without a graphics processor, but no longer than 100 ms. While something is drawn nothing else
  /// is. Edges are smoothed when nothing was asked for a quarter of a second after a drawing.
  void render();
  /// Waits for a drawing with smooth edges, for screenshots; the image is complete when this returns.
  /// @return false: nothing was drawn, as the view is not seen or OpenGL fails
  bool renderNow();
  /// What is said in place of a body that cannot be drawn.
  [[nodiscard]] static QString whyNoBody();

  /// Where the ray through a pixel first meets the skin.
  [[nodiscard]] std::optional<Skin::Contact> contactAt(const QPoint& at) const;
  /// Line of sight through a pixel.
  [[nodiscard]] bridge::Ray rayAt(const QPointF& at) const;
  /// Whether the pixel shows the probe's housing.
  [[nodiscard]] bool isProbeAt(const QPoint& at) const;
  /// Paints over the view whenever it is drawn, and once now; empty: nothing lies over it.
  void setOver(std::function<void(QPainter&)> paint);
  /// Where it is, or will be with the next drawing.
  [[nodiscard]] QPointF pixelOf(const glm::dvec3& p_world_mm) const;
  /// Where what is painted by now was drawn from, in logical pixels: for what is painted over it.
  [[nodiscard]] bridge::Sight sight() const;

  /// The widget that receives mouse, wheel and keys.
  [[nodiscard]] QWidget* canvas() const;
  /// As it was asked for, whether it is drawn by now or not.
  [[nodiscard]] const bridge::Scene3D& scene() const;
  /// Of the camera, handles and the like; what `change` has captured is its own.
  void change(const std::function<void(bridge::Scene3D&)>& change);
  /// The same of what scene() is not asked about, made where the body is drawn.
  void changeLooks(std::function<void(bridge::Scene3D&)> change);

 Q_SIGNALS:
  void mannequinChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rest();
  void drawRested();
  void draw(bridge::Scene3D::Edges edges);
  [[nodiscard]] bool prepareDrawing(bridge::Scene3D::Edges edges);
  void showAids();
  void retranslate();
  void placeOverlays();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::ui
