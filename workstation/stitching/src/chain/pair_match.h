#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "ew/registration/pose_graph.h"
#include "ew/stitching/chain.h"

namespace ew::stitching {

/// A volume of a project as the steps use it.
struct ViewData {
  std::shared_ptr<const Volume> volume;
  std::vector<std::uint8_t> confidence;  ///< 255 for 1; empty: 1 wherever covered
  std::optional<Beams> beams;            ///< in its own frame; empty: not known
  std::string name;
};

/// What is asked of one pair, with everything that its answer depends on.
struct PairTask {
  PairMethod method = PairMethod::automatic;
  bool placesKnown = false;
  Transform<frame::Moving, frame::Fixed> start = {};  ///< fixedToMoving: from the places or by hand
  std::vector<registration::LandmarkPair> landmarks;
  double maxRotation_deg = 30.0;
  double trackerError_mm = 3.0;
  double trackerError_deg = 2.0;
  double finest_mm = 0.75;  ///< voxels of the last level, as RefineOptions::finest_mm
};

/// Which way an automatic pair goes at first.
[[nodiscard]] PairMethod firstMethod(const PairTask& task);

/// How far about its start a pair is searched when refining from there does not end aligned.
struct SearchReach {
  double rotation_deg = 20.0;  ///< never more than the task's largest turn
  double shift_mm = 30.0;
};
/// As `register --method rigid` does; where the tracker may be off by more than refining reaches (8 mm or 6 degrees), as far as the task's
/// largest turn and three times the tracker's error.
[[nodiscard]] SearchReach searchReach(const PairTask& task);

/// Memory for it at the peak, both volumes not counted; a search that may follow is counted.
[[nodiscard]] std::uint64_t forecastPair_bytes(const Grid& fixed, const Grid& moving, const PairTask& task);

/// Brings two volumes together rigidly as the task says.
/// @error what registering says, with the names of both volumes; cancelled
[[nodiscard]] Result<PairOutcome> matchPair(const ViewData& fixed, const ViewData& moving, const PairTask& task, int threads,
                                            Progress& progress, const registration::OnLevel& onLevel);

/// Deviations of the same size along and about each axis.
[[nodiscard]] registration::PoseCovariance evenCovariance(double deviation_mm, double deviation_deg);

/// How well pairs of landmarks fix a pose, about `centre_mm` in the fixed frame, when each place is met within pickError_mm.
[[nodiscard]] std::optional<registration::PoseCovariance> landmarkCovariance(std::span<const registration::LandmarkPair> landmarks,
                                                                             const registration::LandmarkResult& found,
                                                                             const glm::dvec3& centre_mm, double pickError_mm);

}  // namespace ew::stitching
