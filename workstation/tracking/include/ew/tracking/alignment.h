#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/tracking/hand.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// A named place of the mannequin and where the probe's face was when it touched that.
struct LandmarkTouch {
  std::string name;          ///< as shown
  glm::dvec3 world_mm{0.0};  ///< where it lies on the mannequin
  glm::dvec3 tracker_mm{0.0};
  bool operator==(const LandmarkTouch&) const = default;
};

struct AlignmentOptions {
  double touch_mm = 1.0;      ///< standard deviation of touching, per axis, > 0
  double falseAlarm = 0.001;  ///< how often one of good landmarks may be called wrong
  glm::dvec3 target_mm{0.0};  ///< world: where the alignment matters, for the expected error
  double trace_mm = 3.0;      ///< of tracing: residuals beyond count less and less
  bool operator==(const AlignmentOptions&) const = default;
};

enum class AlignmentVerdict {
  aligned,     ///< may be used
  notAligned,  ///< places contradict each other, and it cannot be said which is wrong
  cannotTell,  ///< too few, or they leave a freedom open
};

/// Tracker to mannequin.
struct Alignment {
  AlignmentVerdict verdict = AlignmentVerdict::cannotTell;
  Message sentence;  ///< what was found and what to do
  Transform<frame::World, frame::Tracker> trackerToWorld;
  std::vector<double> residual_mm;   ///< one per landmark or traced point, at the transform
  std::optional<std::size_t> wrong;  ///< the landmark that was left out because it contradicts the others
  double rms_mm = 0.0;               ///< of the residuals that took part
  double expected_mm = 0.0;          ///< expected error at the target (root mean square), from touch_mm or the residuals when they say more
  int used = 0;                      ///< landmarks or points that took part
  /// Of tracing: directions that the traced points leave open, each in words, and how well the rest is known.
  std::vector<Message> open;
  double spread_mm = 0.0;
  double spread_rad = 0.0;
};

/// Aligns by touched landmarks: least squares in closed form. With four or more, each is tried out: when leaving one out lowers the sum of
/// squares by more than chance does at `touch_mm` (chi square with three degrees of freedom, divided among all landmarks), that one is
/// wrong, is named and takes no part; when two explain it alike, both are named and the verdict is notAligned, since nobody can tell.
/// Expected error: Fitzpatrick, West and Maurer, IEEE Trans. Med. Imaging 17(5), 1998, equation 46; closed form: Arun, Huang and Blostein,
/// IEEE PAMI 9(5), 1987.
/// @error badField: a coordinate that is not finite, touch_mm not > 0
[[nodiscard]] Result<Alignment> alignByLandmarks(std::span<const LandmarkTouch> touched, const AlignmentOptions& options = {});

/// The order in which landmarks are best asked for: first the four that span the largest tetrahedron, since of four in nearly one plane it
/// cannot be told which is in the wrong place, then each time the one farthest from those before it.
/// @return indices of all
[[nodiscard]] std::vector<std::size_t> landmarkOrder(std::span<const glm::dvec3> world_mm);

/// Refines an alignment with places of the probe's face that slid over the skin. Least squares of distances to the surface with a robust
/// loss (Geman and McClure), about the linear equations of Chen and Medioni, Image Vision Comput. 10(3), 1992.
/// @param traced face positions in the tracker's frame, at least 30; a few thousand are thinned
/// @param start  a rough alignment (landmarks), within about 40 mm and 20 degrees
/// @error badField: not finite, fewer than 30 points
[[nodiscard]] Result<Alignment> alignBySurface(std::span<const glm::dvec3> traced, const Skin& skin,
                                               const Transform<frame::World, frame::Tracker>& start, const AlignmentOptions& options = {});

}  // namespace ew
