#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ew/bridge/mannequin.h"
#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

class vtkRenderWindow;

namespace ew::bridge {

class OrganSurfaces;
struct Handle;
struct HandlesFrame;
struct HandlesPlace;

/// Seen from the patient's front, back, right, left and head; `overview` is from the front and above, from the side that shows the fan
/// best, and what the scene begins with once mannequin and pose are there.
enum class CameraPreset { front, back, right, left, top, overview };

struct Ray {
  glm::dvec3 from_mm{0.0};
  glm::dvec3 direction{0.0};  ///< unit length, away from the viewer
};

/// Where a scene is seen from, in a window of that size: a copy that stays as it is.
struct Sight {
  glm::dvec3 eye_mm{0.0};
  glm::dvec3 forward{0.0, 1.0, 0.0}, right{1.0, 0.0, 0.0}, up{0.0, 0.0, 1.0};  ///< unit, world
  glm::dvec2 window_px{1.0};

  /// From the window's upper left corner. A point behind the viewer lies far outside.
  [[nodiscard]] glm::dvec2 pixelOf(const glm::dvec3& p_world_mm) const;
  [[nodiscard]] double mmPerPixelAt(const glm::dvec3& p_world_mm) const;
};

/// Red, green, blue, each 0..1.
struct SceneColours {
  glm::dvec3 groundTop{0.125, 0.130, 0.145};
  glm::dvec3 groundBottom{0.095, 0.100, 0.112};
  glm::dvec3 skin{0.80, 0.69, 0.615};
  double rim = 0.66;  ///< brightness left where the skin turns away from the viewer, 0..1
  glm::dvec3 box{0.78, 0.80, 0.83};
  glm::dvec3 accent{0.310, 0.706, 0.753};
  glm::dvec3 housing{0.72, 0.73, 0.75};
  glm::dvec3 covered{0.65, 0.71, 0.68};  ///< skin with data below it
  glm::dvec3 cube{0.30, 0.315, 0.345};   ///< which names the sides
  glm::dvec3 letter{0.93, 0.94, 0.96};
  std::array<glm::dvec3, 3> axes{glm::dvec3(0.94, 0.63, 0.30), glm::dvec3(0.31, 0.71, 0.75), glm::dvec3(0.50, 0.66, 0.98)};  ///< of handles
  glm::dvec3 used{1.0, 1.0, 1.0};  ///< of the handle under the pointer
};
[[nodiscard]] SceneColours darkColours();
[[nodiscard]] SceneColours lightColours();

/// What stands in the 3D view: mannequin, volume box, probe, fan; and the camera that looks at it. Draws into a render window it is
/// given, and only when render() is called. Points on the screen are in device pixels from the window's upper left corner.
/// The fan, the box and the probe lie in a layer over the body, so the body never hides the fan; a probe behind the body turns
/// translucent. A cube in the lower right corner names the body's sides. Body triangles facing away are not drawn; no multisampling, no
/// depth peeling (both cost a multiple on software GL). The body's pixels are kept: while neither it nor the camera changes, only what
/// lies over it is drawn.
class Scene3D {
 public:
  explicit Scene3D(vtkRenderWindow& window);
  ~Scene3D();
  Scene3D(const Scene3D&) = delete;
  Scene3D& operator=(const Scene3D&) = delete;

  void setMannequin(std::shared_ptr<const Mannequin> mannequin);
  [[nodiscard]] std::shared_ptr<const Mannequin> mannequin() const;
  void setBodyOpacity(double opacity);  ///< 0..1; 1 is opaque
  /// How much of what lies below each corner of the mannequin's surface was recorded, 0..1: the skin is tinted there. Empty, and after
  /// another mannequin: unknown.
  void setCoverage(std::vector<float> shares);

  void setVolumeBox(const Grid& grid);
  void clearVolumeBox();
  /// Whether the box is drawn where there is one.
  void setBoxVisible(bool visible);
  /// Inside the body, seen where it is translucent; null: none.
  void setOrgans(std::shared_ptr<const OrganSurfaces> organs);

  /// Handles (ew/bridge/handles.h) before all else, as large as suits the view. @param halfSize_mm of the box about the origin
  void setHandles(const Transform<frame::World, HandlesFrame>& toWorld, const glm::dvec3& halfSize_mm);
  void clearHandles();
  /// The one under the pointer, or in the hand; null: none.
  void setUsedHandle(const Handle* used);
  /// Where they stand as they are seen now; empty: there are none.
  [[nodiscard]] std::optional<HandlesPlace> handles() const;
  [[nodiscard]] std::optional<Handle> handleAt(glm::dvec2 at_px, double near_px) const;

  /// Housing and fan of a probe, the fan down to `depth_mm` and leaning as the knobs steer it; nothing is shown before the first pose.
  void setProbe(const Probe& probe, double depth_mm, const Knobs& knobs = {});
  void setPose(const Pose& pose);  ///< one that is not ok hides probe and fan
  void setProbeVisible(bool visible);
  /// The live image, drawn inside the fan's outline where it belongs; copied.
  void setFanImage(const DisplayImage& image, const DisplayGeometry& geometry);
  void clearFanImage();  ///< the fan becomes a tinted pane
  /// Corners of the drawn fan in the world, in the order of fanOutline_mm; empty while it is hidden.
  [[nodiscard]] std::vector<glm::dvec3> fanCorners_mm() const;

  void setColours(const SceneColours& colours);

  void showFrom(CameraPreset preset);
  void fitToVolume();                           ///< keeps the direction of view; the trunk when there is no box
  void orbit(double right_rad, double up_rad);  ///< the viewer moves around the focal point; 85 degrees up or down at most
  void pan(glm::dvec2 by_px);                   ///< the scene follows the pointer; the focal point stays near the body
  void zoom(double factor);                     ///< above 1 comes closer; from 150 mm to 6 m

  [[nodiscard]] Ray rayAt(glm::dvec2 at_px) const;
  [[nodiscard]] std::optional<Skin::Contact> contactAt(glm::dvec2 at_px) const;
  [[nodiscard]] bool isProbeAt(glm::dvec2 at_px) const;
  [[nodiscard]] glm::dvec2 pixelOf(const glm::dvec3& p_world_mm) const;
  [[nodiscard]] double mmPerPixelAt(const glm::dvec3& p_world_mm) const;
  [[nodiscard]] Sight sight() const;
  /// The square in the window's lower right corner that the cube takes.
  [[nodiscard]] int cubeSide_px() const;
  [[nodiscard]] glm::dvec3 cameraRight() const;  ///< unit, world
  [[nodiscard]] glm::dvec3 cameraUp() const;     ///< unit, world
  [[nodiscard]] glm::dvec3 eye_mm() const;

  /// Smooth edges cost two thirds more (42 against 72 ms of one core for 97 000 triangles at 760 x 800 on software GL): a moving image
  /// does without.
  enum class Edges { quick, smooth };
  void render(Edges edges = Edges::smooth);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::bridge
