#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/registration/elastic.h"
#include "ew/registration/landmarks.h"
#include "ew/registration/pose_graph.h"
#include "ew/registration/rigid.h"
#include "ew/stitching/equalise_views.h"
#include "ew/stitching/join.h"

namespace ew::stitching {

inline constexpr int kProjectFormat = 2;  ///< 1: volumes with places alone, joined as they lie; still read

inline constexpr std::size_t kMostVolumes = 254;  ///< the result names its source in 8 bits

/// Where a subvolume's place comes from.
enum class Placement {
  unknown,  ///< nobody knows: it is matched without a tracker
  tracker,  ///< recorded: believed within the tracker's error, refined by the images
  hand      ///< put there by a person: a start, believed less
};

/// One line of a project.
struct ProjectVolume {
  std::filesystem::path file;        ///< a volume, or a sweep (then it is reconstructed)
  std::filesystem::path coverage;    ///< empty: every voxel counts as measured
  std::filesystem::path confidence;  ///< volume of 0..255 on the same grid; empty: 1 wherever covered
  double spacing_mm = 0.0;           ///< of a sweep's reconstruction; 0: chosen from the sweep
  Placement placement = Placement::tracker;
  Transform<frame::World, frame::View> toWorld = {};
  std::string name;                   ///< the file's name when the project gives none; unique in a project
  std::filesystem::path calibration;  ///< device set of a sweep; empty: the recording says everything itself
  bool acceptsSmall = false;          ///< a sweep is taken also when there is something to ask about it (checkMeant)
  bool operator==(const ProjectVolume&) const = default;
};

/// How a pair is brought together.
enum class PairMethod {
  automatic,  ///< refine when both places are known, else search; landmarks, where there are three or more, come first
  search,     ///< without a tracker, whatever is known
  refine,     ///< from the places as they are (or `start`)
  landmarks,  ///< by landmarks alone
  byHand      ///< `start` as it is
};
/// What a person said about a pair.
enum class Decision { undecided, accepted, rejected };

struct ProjectPair {
  std::size_t fixed = 0;  ///< index of the volume; fixed < moving
  std::size_t moving = 0;
  PairMethod method = PairMethod::automatic;
  Decision decision = Decision::undecided;
  std::optional<Transform<frame::Moving, frame::Fixed>> start;  ///< fixedToMoving: nudged or dragged by hand
  std::vector<registration::LandmarkPair> landmarks;
  std::optional<double> maxRotation_deg;              ///< of the search; absent: the project's
  std::optional<registration::ElasticEffort> effort;  ///< of bending this pair; absent: the project's
  bool operator==(const ProjectPair&) const = default;
};
/// Whether the entry says more than how hard to try to warp the pair: such a pair is matched even where its places need no matching.
[[nodiscard]] bool speaksOfPose(const ProjectPair& pair);

/// How a project's views are joined when it says nothing: levels pass over more widely than speckle.
[[nodiscard]] inline JoinOptions joinOfProject() {
  JoinOptions join;
  join.seam.levelBlend_mm = 10.0;
  return join;
}

struct ProjectSettings {
  double maxRotation_deg = 30.0;
  double trackerError_mm = 3.0;  ///< how far recorded places are believed; 0, and 0 degrees: they are exact, nothing is registered rigidly
  double trackerError_deg = 2.0;
  bool equalise = true;
  bool elastic = true;
  registration::ElasticEffort effort = registration::ElasticEffort::balanced;
  double fallOff_mm = 25.0;            ///< the warp is gone this far outside the overlap
  JoinOptions join = joinOfProject();  ///< threads and maxBytes are not part of the file
};

/// A stitch project (resources/docs/author/stitching.md, resources/schemas/stitch.schema.json): what a person asked for, never what was
/// found; so the same project gives the same result, from the panel or from the command line. What was found lies in the output folder
/// (chain.h).
struct StitchProject {
  std::vector<ProjectVolume> volumes;
  std::vector<ProjectPair> pairs;  ///< pairs with anything to say; all others of overlapping volumes are automatic
  ProjectSettings settings;
};
/// How hard a pair is warped: what is said about it, else what is said about all.
[[nodiscard]] registration::ElasticEffort effortOf(const StitchProject& project, std::size_t fixed, std::size_t moving);

/// Whether both ask for the same: what is not part of the file (threads, maxBytes, block) does not count.
bool operator==(const StitchProject& a, const StitchProject& b);

/// The words of the file: "tracker", "refine", "accepted", …
[[nodiscard]] const char* nameOf(Placement placement);
[[nodiscard]] const char* nameOf(PairMethod method);
[[nodiscard]] const char* nameOf(Decision decision);
[[nodiscard]] const char* nameOf(registration::ElasticEffort effort);
[[nodiscard]] const char* nameOf(SeamMethod method);
[[nodiscard]] const char* nameOf(GridAxes axes);

/// Pairs may be written in either order of their volumes; they are turned so that fixed < moving.
/// @param folder against which relative paths are resolved
/// @error badHeader (not JSON), badField (field, value found, value expected; also a field nobody knows), newerFormat, notRigid, and what
///        reading a transform file says
[[nodiscard]] Result<StitchProject> parseProject(const std::string& text, const std::filesystem::path& folder);

/// The project as text that parseProject reads back to an equal one. Paths below `folder` are written relative to it.
[[nodiscard]] std::string projectText(const StitchProject& project, const std::filesystem::path& folder);

/// The files of a project that projectText writes by their whole path, because they do not lie in `folder` or below it.
[[nodiscard]] std::vector<std::filesystem::path> filesElsewhere(const StitchProject& project, const std::filesystem::path& folder);

/// A rigid matrix from text: 16 numbers, row by row, separated by blanks or line ends.
/// @error badField, notRigid
[[nodiscard]] Result<std::array<double, 16>> parseRigidRows(const std::string& text, const std::string& name);
template <class To, class From>
[[nodiscard]] Result<Transform<To, From>> parseTransform(const std::string& text, const std::string& name) {
  const auto rows = parseRigidRows(text, name);
  if (!rows) return passOn(rows.error());
  return Transform<To, From>{matrixFromRows(*rows)};
}

}  // namespace ew::stitching
