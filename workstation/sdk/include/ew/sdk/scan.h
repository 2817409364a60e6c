#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ew/core/figure.h"
#include "ew/core/result.h"
#include "ew/imaging/display.h"
#include "ew/imaging/display_image.h"
#include "ew/scanning/events.h"
#include "ew/scanning/state.h"
#include "ew/sdk/ticket.h"
#include "ew/tracking/pose_source.h"

namespace ew::sdk {

/// What is scanned, beside its images.
struct Scanned {
  Grid volume;                           ///< where the voxels lie in the world
  std::shared_ptr<const Volume> labels;  ///< which structure each voxel is (its `echo` holds the numbers); null: nobody knows
  Grid placedLabels;                     ///< where the labels lie in the world
  std::shared_ptr<const Skin> skin;      ///< that the hand slides on; null: none yet
  std::vector<Probe> probes;             ///< that may be chosen
  std::shared_ptr<const Volume> voxels;  ///< what is scanned, on the grid it was read with; `volume` is where it lies now
};

/// What is asked of a user who draws over the image.
struct StrokeRequest {
  using At = std::function<void(const Point<frame::Probe>&)>;
  std::string hint;        ///< a sentence over the image meanwhile
  double radius_mm = 0.0;  ///< of a circle about the pointer; 0: none
  At begun = {};           ///< the button went down
  At moved = {};           ///< and is held
  At ended = {};
  std::function<void()> stopped = {};  ///< the user ended it (Escape)
};

/// Something that was measured in the image with calipers, as it stands now.
struct ScanMeasurement {
  int number = 0;                           ///< stays while it is edited
  std::string kind;                         ///< of the caliper: "distance", "ellipse", "fitted_ellipse" ...
  std::vector<Point<frame::Probe>> points;  ///< of the image plane, mm
  std::vector<Figure> figures;              ///< the one that the caliper is for comes first
};

/// The scan as it goes on in the workstation: what every image is made with, and a way to move probe and settings and to give them back.
/// On the window's thread. Without a window nothing is scanned: there is no state, tickets do nothing,
/// and what would change the scan says so.
class Scan {
 public:
  virtual ~Scan();

  /// All that the latest image was made with; while the probe moves fast with less quality than the console asks for. Empty: no image.
  [[nodiscard]] virtual std::optional<ScanState> state() const = 0;
  /// The latest image. Its pixels are valid until the call ends that asked for it; empty: no image.
  [[nodiscard]] virtual DisplayImage image() const = 0;
  /// Where the fan lies in it.
  [[nodiscard]] virtual DisplayGeometry geometry() const = 0;
  /// As the console has them now.
  [[nodiscard]] virtual Knobs knobs() const = 0;
  /// On the scan's clock, the one of states, events and pose sources.
  [[nodiscard]] virtual double now_s() const = 0;

  /// What happens, as a recording of the scan would hold it: each image (FrameMade; image() is that image), before the first and where
  /// they changed since the image before also probe, settings and scene, and freezing. A recording that is played tells of its own images.
  using EventCallback = std::function<void(const ScanEvent&)>;
  [[nodiscard]] virtual Ticket onEvent(EventCallback callback) = 0;

  /// Takes the probe: until the ticket is destroyed the poses come from `source` and the hand rests; afterwards the probe is where the hand
  /// had left it. Who takes it last has it, and gives it back to who had it before. The user may take it back at any time (Escape): then
  /// `takenBack` is called, and the ticket has no effect any more. A source that throws leaves the probe where it was.
  [[nodiscard]] virtual Ticket drive(std::shared_ptr<const PoseSource> source, std::function<void()> takenBack) = 0;

  /// Puts the probe there, pulled to the skin, as if the hand had brought it: the hand goes on from it.
  /// @error badUsage (nothing is scanned, no skin yet, it is frozen, a recording is played)
  [[nodiscard]] virtual Result<void> placeProbe(const Transform<frame::World, frame::Probe>& probeToWorld);

  /// Sets what the console sets; brought within its limits.
  /// @error badUsage (no scan, it is frozen, or a recording is played)
  [[nodiscard]] virtual Result<void> apply(const Knobs& knobs) = 0;
  /// @param id of one of the probes that the case allows. @error badUsage (no scan, it is frozen, a recording is played, no such probe)
  [[nodiscard]] virtual Result<void> chooseProbe(const std::string& id) = 0;
  /// Empty: nothing is scanned.
  [[nodiscard]] virtual std::optional<Scanned> scanned() const;

  /// What is measured in the present image, in the order it was drawn. Empty without a window.
  [[nodiscard]] virtual std::vector<ScanMeasurement> measurements() const;
  /// Told whenever measurements() has changed.
  [[nodiscard]] virtual Ticket onMeasured(std::function<void()> callback);

  /// Asks the user to point at something: until the ticket is destroyed, clicks into the image (or a cross moved by the arrows, and Enter)
  /// give `pointed` a point of the image plane instead of moving the probe. Who asks last is asked for. The user may stop it (Escape):
  /// then `stopped` is called, and the ticket has no effect any more.
  /// @param hint a sentence over the image meanwhile
  [[nodiscard]] virtual Ticket askForPoint(const std::string& hint, std::function<void(const Point<frame::Probe>&)> pointed,
                                           std::function<void()> stopped);

  /// As askForPoint, for what is drawn with the button held; with the keyboard a cross and Enter give strokes of one point.
  [[nodiscard]] virtual Ticket askForStroke(StrokeRequest request);

  /// Shows labels in place of those of what is scanned, in the image (shadows) and in the body: while they are edited. They hold until
  /// something else is scanned, or the case names other labels.
  /// @param labels on a grid in the world, where the volume lies now; empty: the labels are again those of what is scanned
  /// @error badUsage (nothing is scanned)
  [[nodiscard]] virtual Result<void> showLabels(std::optional<Volume> labels);

  /// Freezes the image, or lets it go on. @error badUsage (no scan, or a recording is played)
  [[nodiscard]] virtual Result<void> setFrozen(bool frozen) = 0;
  /// Remembers probe and settings; when the ticket is destroyed they are again what they were, unless something else is scanned by
  /// then; while the scan is frozen, as soon as it goes on.
  [[nodiscard]] virtual Ticket keepSettings() = 0;
};

}  // namespace ew::sdk
