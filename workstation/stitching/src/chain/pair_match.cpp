#include "chain/pair_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chain/overlap.h"

namespace ew::stitching {
namespace {

using registration::PoseCovariance;
using registration::RigidResult;
using registration::Verdict;

constexpr double kByHand_mm = 3.0;  ///< what a person reaches by dragging
constexpr double kByHand_deg = 3.0;
/// Beyond such an error of the tracker a refinement may lie outside its reach, so that the search that follows has to be a wide one.
constexpr double kReach_mm = 8.0;
constexpr double kReach_deg = 6.0;

std::vector<float> sharesOf(std::span<const std::uint8_t> confidence) {
  std::vector<float> shares(confidence.size());
  std::transform(confidence.begin(), confidence.end(), shares.begin(), [](std::uint8_t c) { return static_cast<float>(c) / 255.0F; });
  return shares;
}

/// The largest distance between where two transforms take the corners of a grid.
double farthestApart_mm(const Grid& grid, const Transform<frame::Moving, frame::Fixed>& a,
                        const Transform<frame::Moving, frame::Fixed>& b) {
  double farthest = 0.0;
  const auto toFixed = grid.voxelTo<frame::Fixed>();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = carried(
        toFixed, glm::dvec3((corner & 1) * (grid.dims.x - 1), ((corner >> 1) & 1) * (grid.dims.y - 1), (corner >> 2) * (grid.dims.z - 1)));
    farthest = std::max(farthest, glm::distance(carried(a, p), carried(b, p)));
  }
  return farthest;
}

double leastSpacing_mm(const Grid& grid) { return std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}); }

RigidResult rigidOf(const registration::LandmarkResult& found) {
  RigidResult rigid;
  rigid.verdict = found.verdict;
  rigid.reason = found.reason;
  rigid.remarks = found.remarks;
  rigid.fixedToMoving = found.fixedToMoving;
  rigid.conditioning = found.conditioning;
  rigid.stop = found.stop;
  return rigid;
}

}  // namespace

PoseCovariance evenCovariance(double deviation_mm, double deviation_deg) {
  PoseCovariance covariance{};
  const double rotation_rad = deviation_deg * std::numbers::pi / 180.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    covariance[axis * 7] = deviation_mm * deviation_mm;
    covariance[(axis + 3) * 7] = rotation_rad * rotation_rad;
  }
  return covariance;
}

std::optional<PoseCovariance> landmarkCovariance(std::span<const registration::LandmarkPair> landmarks,
                                                 const registration::LandmarkResult& found, const glm::dvec3& centre_mm,
                                                 double pickError_mm) {
  glm::dvec3 mean(0.0);
  double count = 0.0;
  for (std::size_t n = 0; n < landmarks.size(); ++n) {
    const double weight = n < found.weight.size() ? found.weight[n] : 1.0;
    mean += weight * landmarks[n].fixed_mm;
    count += weight;
  }
  if (count < 2.5) return std::nullopt;
  mean /= count;
  glm::dmat3 inertia(0.0);
  for (std::size_t n = 0; n < landmarks.size(); ++n) {
    const double weight = n < found.weight.size() ? found.weight[n] : 1.0;
    const glm::dvec3 r = landmarks[n].fixed_mm - mean;
    inertia += weight * (glm::dot(r, r) * glm::dmat3(1.0) - glm::outerProduct(r, r));
  }
  if (!(glm::determinant(inertia) > 1e-3)) return std::nullopt;  // all on a line: the turn about it is free
  // Both places are met within pickError_mm, so their difference within its root of two.
  const double variance = 2.0 * pickError_mm * pickError_mm;
  const glm::dmat3 turn = variance * glm::inverse(inertia);
  // At another centre the turn moves it: error there = error at the mean + turn x arm.
  const glm::dvec3 arm = centre_mm - mean;
  const glm::dmat3 cross(0.0, arm.z, -arm.y, -arm.z, 0.0, arm.x, arm.y, -arm.x, 0.0);  // columns: cross * w = arm x w
  const glm::dmat3 shift = variance / count * glm::dmat3(1.0) + cross * turn * glm::transpose(cross);
  const glm::dmat3 mixed = -1.0 * (cross * turn);
  PoseCovariance covariance{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const auto at = [](int r, int c) { return static_cast<std::size_t>(6 * r + c); };
      covariance[at(row, column)] = shift[column][row];
      covariance[at(row + 3, column + 3)] = turn[column][row];
      covariance[at(row, column + 3)] = mixed[column][row];
      covariance[at(column + 3, row)] = mixed[column][row];
    }
  return covariance;
}

PairMethod firstMethod(const PairTask& task) {
  if (task.method != PairMethod::automatic) return task.method;
  if (task.landmarks.size() >= 3) return PairMethod::landmarks;
  return task.placesKnown ? PairMethod::refine : PairMethod::search;
}

SearchReach searchReach(const PairTask& task) {
  SearchReach reach;
  const bool beyond = task.trackerError_mm > kReach_mm || task.trackerError_deg > kReach_deg;
  if (beyond) reach = {task.maxRotation_deg, std::max(reach.shift_mm, 3.0 * task.trackerError_mm)};
  reach.rotation_deg = std::min(reach.rotation_deg, task.maxRotation_deg);
  return reach;
}

std::uint64_t forecastPair_bytes(const Grid& fixed, const Grid& moving, const PairTask& task) {
  const PairMethod first = firstMethod(task);
  const auto both = static_cast<double>(fixed.voxelCount() + moving.voxelCount());
  // Confidences as numbers, one volume on its way to the finest level, and the images of both at that and the coarser ones.
  if (first == PairMethod::byHand) return static_cast<std::uint64_t>(4.0 * both);
  const double finest_mm = std::max(task.finest_mm, std::min(leastSpacing_mm(fixed), leastSpacing_mm(moving)));
  const double atFinest = std::pow(std::min(leastSpacing_mm(fixed), leastSpacing_mm(moving)) / finest_mm, 3.0);
  const auto refined = static_cast<std::uint64_t>((4.0 + 15.0 * atFinest) * both) + 13 * std::max(fixed.voxelCount(), moving.voxelCount());
  if (first == PairMethod::landmarks) return refined;
  registration::PartialOptions search;
  search.maxRotation_deg = first == PairMethod::search ? task.maxRotation_deg : searchReach(task).rotation_deg;
  search.refine.finest_mm = task.finest_mm;
  return std::max(refined, registration::forecastPartial_bytes(fixed, moving, search));
}

Result<PairOutcome> matchPair(const ViewData& fixed, const ViewData& moving, const PairTask& task, int threads, Progress& progress,
                              const registration::OnLevel& onLevel) {
  const auto named = [&](Error problem) {
    if (problem.code != ErrorCode::cancelled)
      problem.message = say<"'%1' and '%2' could not be registered. %3">(fixed.name, moving.name, problem.message);
    return passOn(std::move(problem));
  };
  const std::vector<float> fixedConfidence = sharesOf(fixed.confidence);
  const std::vector<float> movingConfidence = sharesOf(moving.confidence);
  const registration::Input fixedInput{fixed.volume.get(), fixedConfidence, fixed.beams};
  const registration::Input movingInput{moving.volume.get(), movingConfidence, moving.beams};
  registration::RefineOptions refining;
  refining.finest_mm = task.finest_mm;
  refining.threads = threads;
  const auto meetingPoint = [&](const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
    const Grid& grid = fixed.volume->grid;
    const auto overlap = overlapOf(*fixed.volume, *moving.volume, fixedToMoving);
    return overlap ? overlap->centre_mm : carried(grid.voxelToWorld(), 0.5 * glm::dvec3(grid.dims - 1));
  };

  PairOutcome outcome;
  outcome.used = firstMethod(task);
  switch (outcome.used) {
    case PairMethod::byHand:
      outcome.rigid.verdict = Verdict::aligned;
      outcome.rigid.remarks = {{registration::RemarkCode::placedByHand}};
      outcome.rigid.reason = registration::messageOf(outcome.rigid.remarks);
      outcome.rigid.fixedToMoving = task.start;
      outcome.rigid.covariance = evenCovariance(kByHand_mm, kByHand_deg);
      outcome.rigid.centre_mm = meetingPoint(task.start);
      return outcome;
    case PairMethod::landmarks: {
      auto found = registration::registerLandmarks(task.landmarks);
      if (!found) return named(found.error());
      outcome.rigid = rigidOf(*found);
      const registration::LandmarkOptions picked;
      outcome.rigid.centre_mm = meetingPoint(found->fixedToMoving);
      outcome.rigid.covariance = landmarkCovariance(task.landmarks, *found, outcome.rigid.centre_mm, picked.pickError_mm);
      const double trusted_mm = 3.0 * std::max(picked.pickError_mm, found->expectedError_mm);
      outcome.landmarks = std::move(*found);
      if (task.method != PairMethod::automatic || outcome.rigid.verdict == Verdict::cannotTell) return outcome;
      // The images say it better than fingers do, as long as they do not run away from them.
      auto refined = registration::refineRigid(fixedInput, movingInput, outcome.rigid.fixedToMoving, refining, progress, onLevel);
      if (!refined) return named(refined.error());
      if (refined->verdict == Verdict::aligned &&
          farthestApart_mm(fixed.volume->grid, refined->fixedToMoving, outcome.rigid.fixedToMoving) < 2.0 * trusted_mm)
        outcome.rigid = std::move(*refined);
      return outcome;
    }
    case PairMethod::refine: {
      const SearchReach reach = searchReach(task);
      refining.searchRotation_deg = reach.rotation_deg;
      refining.searchShift_mm = reach.shift_mm;
      auto refined = registration::refineRigid(fixedInput, movingInput, task.start, refining, progress, onLevel);
      if (!refined) return named(refined.error());
      outcome.rigid = std::move(*refined);
      return outcome;
    }
    case PairMethod::search:
    case PairMethod::automatic:
      break;
  }
  registration::PartialOptions searching;
  searching.maxRotation_deg = task.maxRotation_deg;
  searching.refine = refining;
  searching.threads = threads;
  auto found = registration::matchPartial(fixedInput, movingInput, searching, progress, onLevel);
  if (!found) return named(found.error());
  outcome.rigid = std::move(found->best);
  outcome.hypotheses = std::move(found->hypotheses);
  return outcome;
}

}  // namespace ew::stitching
