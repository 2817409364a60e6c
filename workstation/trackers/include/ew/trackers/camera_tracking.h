#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/result.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/marker_body.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// How the corners of a found marker are measured.
enum class CornerMethod {
  contour,  ///< as the detector leaves them: whole pixels of a contour
  subPix,   ///< OpenCV's saddle point search (cornerSubPix); a marker's outer corner is no saddle
  edges,    ///< each side as a line through sub-pixel edge points of the undistorted image; corners are where the lines meet
};

struct CameraTrackingOptions {
  CornerMethod corners = CornerMethod::edges;
  double gamma = 2.2;                ///< grey levels are light to the power of 1 / gamma, as webcams encode it; 1: light itself
  int mostMarkers = 12;              ///< of a body, the largest first; 1..64
  bool halfSearch = true;            ///< the whole image is searched at half its size; corners are measured in the whole one all the same
  bool followsRegions = true;        ///< a body that was seen is looked for around the place where it should be
  double searchEvery_s = 0.5;        ///< the whole image nevertheless, this often
  double smallestMarker_px = 14.0;   ///< side of a marker below which it is not looked for
  double largestRms_px = 1.0;        ///< of the corners; above, the pose is invalid
  double largestSpread_mm = 4.0;     ///< standard deviation at the face; above, the pose is outOfRange
  double largestSpread_rad = 0.035;  ///< the same of the turn
  double readout_s = 0.0;            ///< from the first to the last row of a rolling shutter; 0: not known, only reported
  bool operator==(const CameraTrackingOptions&) const = default;
};

/// A marker of one of the bodies as it was found in an image.
struct MarkerSight {
  int id = 0;
  int body = 0;                            ///< index
  std::array<glm::dvec2, 4> corners_px{};  ///< order of Marker::corners_mm
  double blur_px = 0.0;                    ///< widest standard deviation of its edges across; 0 where edges were not measured
  double residual_px = 0.0;                ///< root mean square to the body's pose, where there is one
  bool used = false;                       ///< false: it disagreed with the others, or more were there than asked for
};

/// How a body stands in one image.
struct BodySight {
  TrackingState state = TrackingState::outOfView;      ///< live, outOfRange, outOfView or invalid
  Transform<frame::Camera, frame::Tool> bodyToCamera;  ///< rigid; of meaning where it is live or outOfRange
  int markers = 0;                                     ///< that the pose rests on
  double rms_px = 0.0;                                 ///< of their corners
  double spread_mm = 0.0;   ///< standard deviation of the place of the transducer face (of a board: of its middle), all directions together
  double spread_rad = 0.0;  ///< of the turn, all axes together
  bool ambiguous = false;   ///< two poses explain the image alike; outOfRange unless the last image tells which one goes on
  double flipRatio = 0.0;   ///< how many times the other pose of a flat view fits worse (rms); 0: there is no other
  double blur_px = 0.0;     ///< length of the motion in the image while it was exposed
  double speed_pxPerS = 0.0;  ///< of the face in the image, from the last image it was live in; 0: not known
  double skew_px = 0.0;       ///< by how much a rolling shutter shears the body: speed times the time its rows take
};

/// What one image shows.
struct CameraSight {
  std::vector<BodySight> bodies;     ///< one for each body, in their order
  std::vector<MarkerSight> markers;  ///< of all bodies
  bool searchedWhole = false;
  /// By how much black squares seem smaller than printed, in spreads of their edges on each side: ink, bloom, encoding. Carried on from
  /// image to image, since it belongs to the camera and the paper; with its standard deviation.
  double bleed = 0.0, bleedSpread = 0.0;
};

/// Finds marker bodies in the images of one camera, one image after another. Poses rest on the image alone: the ones before say where
/// to look, and which of two poses of a flat view goes on, and never pull an estimate.
///
/// Markers are found by OpenCV's ArUco detector; their corners are measured by CornerMethod; all corners of a body, taken back through
/// the lens, are explained by one pose (Huber's loss, Ceres), begun from both poses of every face in sight. A marker that disagrees is
/// left out. The second best pose is carried to its own minimum: unless it fits clearly worse, or the last live pose stands clearly nearer
/// to one of them, nothing is shown. Source of the two poses of a plane: T. Collins and A. Bartoli, Infinitesimal Plane-Based Pose
/// Estimation, IJCV 109, 2014 (OpenCV's).
class CameraTracker {
 public:
  /// @error badField: a body whose dictionary is not known, a marker that is no flat square, an id that two bodies share in a dictionary
  [[nodiscard]] static Result<CameraTracker> make(const CameraModel& model, std::vector<MarkerBody> bodies,
                                                  const CameraTrackingOptions& options = {});
  CameraTracker(CameraTracker&&) noexcept;
  CameraTracker& operator=(CameraTracker&&) noexcept;
  ~CameraTracker();

  /// @param grey   of the model's size
  /// @param time_s of the image, on any clock that does not fall
  [[nodiscard]] CameraSight track(ImageView<const std::uint8_t> grey, double time_s);
  /// As if no image had come before.
  void forget();

 private:
  struct State;
  explicit CameraTracker(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// What OpenCV's own estimatePoseBoard makes of an image with its default detector and sub-pixel corners, for comparison alone: it says
/// neither how sure it is nor whether the pose is flipped.
[[nodiscard]] std::vector<std::optional<Transform<frame::Camera, frame::Tool>>> plainBoardPoses(const CameraModel& model,
                                                                                                const std::vector<MarkerBody>& bodies,
                                                                                                ImageView<const std::uint8_t> grey);

}  // namespace ew
