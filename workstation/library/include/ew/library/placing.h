#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/data_file.h"
#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/library/case.h"
#include "ew/tracking/hand.h"

namespace ew {

/// Which directions of a volume's own file are those of the probe that recorded it. Without knowledge: an image from the front of a
/// patient in LPS, marker to the right.
struct SweepAxes {
  glm::dvec3 depth{0.0, 1.0, 0.0};     ///< away from the probe; unit vector
  glm::dvec3 lateral{-1.0, 0.0, 0.0};  ///< towards the marker; unit vector, at right angles to depth
  bool operator==(const SweepAxes&) const = default;
};

/// The mean directions of the frames of a recording, made orthogonal; nothing when they cancel out.
[[nodiscard]] std::optional<SweepAxes> sweepAxesOf(std::span<const TrackedFrame> frames);

/// What a case says of its volume ("volume.depth_direction", "volume.lateral_direction"); nothing where it does not.
[[nodiscard]] std::optional<SweepAxes> sweepAxesOf(const Case& placed);
/// The case with them, as a person or the recording says. They stand in Case::otherFields.
[[nodiscard]] Case withSweepAxes(Case placed, const SweepAxes& axes);
/// The same where nobody said them ("volume.probe_side_is_assumed"): whoever publishes the case is told.
[[nodiscard]] Case withAssumedAxes(Case placed, const SweepAxes& axes);
[[nodiscard]] bool assumesAxes(const Case& placed);

/// What of a volume is held against a body, in the volume's own file: few points, so that a hand that drags the volume sees the answer at
/// once.
struct PlacingShape {
  SweepAxes axes;
  std::vector<glm::dvec3> face_mm;    ///< on the near side, where the probe was: at most about 400 points
  std::vector<glm::dvec3> inside_mm;  ///< of the voxels with data: at most about 1500 points
};

/// The shape of a volume: its face is the first voxel with data of each line along the depth, as far as it lies within 12 mm of the
/// foremost (a fan's sides are no face). A voxel has data when it is covered or, without coverage, above grey 0.
[[nodiscard]] PlacingShape placingShapeOf(const Volume& volume, const SweepAxes& axes);
/// The same of a box of which nothing but the grid is known.
[[nodiscard]] PlacingShape placingShapeOf(const Grid& grid, const SweepAxes& axes);

/// How a placed volume lies against the skin. All zero for a shape without points.
struct Contact {
  double faceShare = 0.0;            ///< of the near face that lies within kGel_mm of the skin, 0 to 1
  double deepestGap_mm = 0.0;        ///< how far the face stands off the skin at most, >= 0
  double deepestIntrusion_mm = 0.0;  ///< how deep the face lies below the skin at most, >= 0
  double outsideShare = 0.0;         ///< of the voxels with data that lie outside the body, 0 to 1
  bool operator==(const Contact&) const = default;
};
inline constexpr double kGel_mm = 3.0;  ///< that gel bridges

[[nodiscard]] Contact contactOf(const PlacingShape& shape, const Transform<frame::World, frame::File>& fileToWorld, const Skin& skin);

/// A named place of a mannequin's body.
struct BodyLandmark {
  std::string id;  ///< "xiphoid"
  Words name;
  glm::dvec3 at_mm{0.0};  ///< on the skin, world
  bool operator==(const BodyLandmark&) const = default;
};

/// Where a probe is usually put for a region.
struct PlacingSite {
  std::string region;                      ///< "right upper quadrant"
  glm::dvec3 at_mm{0.0};                   ///< near the skin, world
  glm::dvec3 towards_mm{0.0};              ///< where the middle beam is to look
  glm::dvec3 lateralHint{-1.0, 0.0, 0.0};  ///< where the marker points, roughly
  bool operator==(const PlacingSite&) const = default;
};

/// What is known by name about a mannequin (resources/mannequin/landmarks/NAME.json).
struct MannequinLandmarks {
  std::vector<BodyLandmark> landmarks;
  std::vector<PlacingSite> sites;  ///< the first is taken where a region is not known
};
/// @param mannequin as Case::mannequin; empty: the default
/// @error notFound (nobody has named places of this mannequin), badHeader, badField, newerFormat
[[nodiscard]] Result<MannequinLandmarks> landmarksOf(const std::string& mannequin);

/// Whether a site is known by a word of `region`; an empty one is not.
[[nodiscard]] bool knowsRegion(const MannequinLandmarks& known, const std::string& region);
/// The site whose region is the longest one that `region` speaks of ("upper abdomen, right" knows "upper abdomen"), else the first; null
/// when there are none.
[[nodiscard]] const PlacingSite* siteFor(const MannequinLandmarks& known, const std::string& region);

/// Puts the near face of a volume flush against the skin at a site, its beams looking to where the site says: its middle comes to lie
/// on the skin's nearest point, then it moves along the beams until as much of the face as can be lies within kGel_mm. The beams are tipped
/// from the normal by at most 35 degrees, since a probe that is tipped further loses the skin.
[[nodiscard]] Transform<frame::World, frame::File> firstPlacement(const PlacingShape& shape, const Skin& skin, const PlacingSite& site);

/// The same place in the volume and on the body.
struct PlacingPair {
  std::string name;
  glm::dvec3 file_mm{0.0};
  glm::dvec3 world_mm{0.0};
  bool operator==(const PlacingPair&) const = default;
};

/// A placement by pairs of places.
struct LandmarkFit {
  Transform<frame::World, frame::File> fileToWorld;
  std::vector<double> residuals_mm;  ///< one per pair, >= 0
  double rms_mm = 0.0;               ///< of these
  /// With four pairs or more: the one without which the others agree far better; it took no part in the fit.
  std::optional<std::size_t> wrong = {};
};

/// The rigid placement, without scale, that brings pairs together in the least squares (registration/landmarks.h names the sources).
/// @error badField: fewer than three pairs, pairs at one place, all on a line, coordinates that are not finite
[[nodiscard]] Result<LandmarkFit> placeByLandmarks(std::span<const PlacingPair> pairs);

/// The skin of the mannequin of a case: its own, the program's, or the default.
/// @error as readBodySkin; unsupported for a mesh, whose skin only the window has
[[nodiscard]] Result<std::shared_ptr<const Skin>> skinOfMannequin(const std::string& mannequin,
                                                                  const std::filesystem::path& caseFolder = {});

}  // namespace ew
