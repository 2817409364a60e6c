#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/sdk/ticket.h"

namespace ew::sdk {

/// What something drawn means; the host chooses the theme's colour for it.
enum class OverlayRole {
  guide,    ///< where to go, what to look at: the accent colour
  expert,   ///< of the expert: blue
  trainee,  ///< of the trainee: orange
  quiet,    ///< in the background of the rest: grey
  danger    ///< what is wrong: red
};

/// A line through points, in mm of its frame. Fewer than two points draw nothing.
template <class Frame>
struct OverlayLine {
  std::vector<Point<Frame>> points;
  OverlayRole role = OverlayRole::guide;
  bool isClosed = false;
  bool isFilled = false;  ///< lightly, with the outline; for closed lines
  bool isDashed = false;
  double width_px = 1.5;
};

/// A few words beside a point.
template <class Frame>
struct OverlayLabel {
  Point<Frame> at;
  std::string text;
  OverlayRole role = OverlayRole::guide;
  bool hasDot = true;  ///< the point is marked
};

/// A rectangle about a point: a plane to be found.
struct OverlayPlane {
  Transform<frame::World, frame::Probe> probeToWorld;  ///< the plane is the probe's image plane, x lateral and y axial
  double left_mm = -30.0, right_mm = 30.0;             ///< along x
  double top_mm = 0.0, bottom_mm = 60.0;               ///< along y
  OverlayRole role = OverlayRole::guide;
};

/// Drawn into the scan image: points of the probe's image plane (z is not looked at). They stay where they are in the tissue when the image
/// is zoomed, panned or inverted.
struct ScanDrawing {
  std::vector<OverlayLine<frame::Probe>> lines = {};
  std::vector<OverlayLabel<frame::Probe>> labels = {};
};

/// Drawn over the 3D view, in front of the body: points of the world.
struct BodyDrawing {
  std::vector<OverlayLine<frame::World>> lines = {};
  std::vector<OverlayLabel<frame::World>> labels = {};
  std::vector<OverlayPlane> planes = {};
};

/// One drawing of a plugin's, there until it is destroyed.
template <class Drawing>
class Overlay {
 public:
  virtual ~Overlay() = default;
  /// Replaces what is drawn, with the next image or turn of the event loop. Points that are not finite are left out.
  virtual void show(Drawing drawing) = 0;
};
using ScanOverlay = Overlay<ScanDrawing>;
using BodyOverlay = Overlay<BodyDrawing>;

/// What helps to find one's way in the 3D view, beside what is drawn there.
struct BodyAids {
  bool translucentSkin = false;
  std::vector<int> organs = {};  ///< numbers in the labels of what is scanned (Scanned::labels) whose surfaces are shown
  bool volumeBox = false;        ///< how far the volume reaches
  bool operator==(const BodyAids&) const = default;
};

/// Handles by which the user moves something in the body as a rigid body: an arrow along each axis of its own frame, a ring about each.
struct BodyHandles {
  struct Frame {};                                    ///< of what is moved: its origin is where the axes meet; mm
  Transform<frame::World, Frame> toWorld = {};        ///< rigid
  glm::dvec3 halfSize_mm{0.0};                        ///< of the box about the origin that is moved
  std::array<std::string, 3> axes = {"x", "y", "z"};  ///< what each is called, shown while it is used: "into the body"
  bool operator==(const BodyHandles&) const = default;
};
/// Told while handles are moved, and once more with `isOver` when that has ended; a drag that Escape ended gives back where it began.
using HandlesMoved = std::function<void(const Transform<frame::World, BodyHandles::Frame>& toWorld, bool isOver)>;
using HandlesOverlay = Overlay<BodyHandles>;

/// Drawings over the views: values that the host paints in the theme's colours. On the window's thread. What is drawn over an image never
/// gets into a saved image or a recording.
class Overlays {
 public:
  virtual ~Overlays();
  /// Never null; without a window nothing is drawn.
  [[nodiscard]] virtual std::shared_ptr<ScanOverlay> overScan() = 0;
  [[nodiscard]] virtual std::shared_ptr<BodyOverlay> overBody() = 0;
  /// Shows in the body what `aids` says, and nothing else of it, until the ticket is destroyed; then what was shown before. Who asks last
  /// is followed. Organs appear when their surfaces are made, which takes seconds.
  [[nodiscard]] virtual Ticket showInBody(const BodyAids& aids);

  /// Handles in the 3D view, there until what is returned is destroyed; whoever asks last has them. They are dragged with the mouse (Shift:
  /// whole millimetres and degrees), and moved by the arrows, Page up and Page down while the view has the focus (with Alt: turned). The
  /// handles go where they are dragged; show() puts them elsewhere, as after an undo.
  /// Never null; without a window nothing is shown and nobody moves anything.
  [[nodiscard]] virtual std::shared_ptr<HandlesOverlay> showHandles(const BodyHandles& handles, HandlesMoved moved);
  /// Asks the user to point at a place on the body: until the ticket is destroyed, clicks in the 3D view give `pointed` a point on the skin
  /// instead of moving the probe; looking around goes on. Who asks last is asked for. The user may stop it (Escape): then `stopped` is
  /// called, and the ticket has no effect any more.
  /// @param hint a sentence over the view meanwhile
  [[nodiscard]] virtual Ticket askForBodyPoint(const std::string& hint, std::function<void(const Point<frame::World>&)> pointed,
                                               std::function<void()> stopped);
};

}  // namespace ew::sdk
