#include "refine.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "../streaks.h"
#include "ew/core/elapsed.h"

namespace ew::registration {
namespace {

constexpr double kBlock_mm = 14.0;
// What blocks do not see, interpolation and local normalisation at the rims, doubles the spread: measured over seeds of phantoms.
constexpr double kUnseen = 4.0;
constexpr double kMostVoxels = 2e9;  // what 32 bit indices of the kernel reach

double cellsAt(const Grid& grid, double voxel_mm) {
  double cells = 1.0;
  for (int a = 0; a < 3; ++a) cells *= std::max(1.0, std::round(grid.dims[a] * grid.spacing_mm[a] / voxel_mm));
  return cells;
}

using NormalMatrix = Eigen::Matrix<double, 6, 6>;

/// In mm and mm at 50 mm lever.
NormalMatrix scaled(const std::array<double, 36>& normal) {
  NormalMatrix out;
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) out(r, c) = normal[6 * r + c] / ((r < 3 ? 1.0 : 50.0) * (c < 3 ? 1.0 : 50.0));
  }
  return out;
}

}  // namespace

Result<PairLevels> preparePair(const Input& fixed, const Input& moving, const std::vector<double>& voxel_mm, int threads,
                               Progress& progress) {
  for (const Input* side : {&fixed, &moving}) {
    if (cellsAt(side->volume->grid, voxel_mm.back()) > kMostVoxels) {
      return failure(ErrorCode::tooLarge, say<"The images at voxels of %1 mm are too large to register; ask for a coarser finest level.">(
                                              numeral(std::to_string(voxel_mm.back()))));
    }
  }
  PairLevels pair;
  ComparableOptions options;
  options.threads = threads;
  PartOfProgress one(progress, 0.0, 0.5);
  auto first = comparableImages(fixed, voxel_mm, options, one);
  if (!first) return passOn(first.error());
  pair.fixed = std::move(*first);
  PartOfProgress two(progress, 0.5, 1.0);
  auto second = comparableImages(moving, voxel_mm, options, two);
  if (!second) return passOn(second.error());
  pair.moving = std::move(*second);
  pair.agreement = voxel_mm.size() - 1;
  while (pair.agreement > 0 && voxel_mm[pair.agreement] < 1.4) --pair.agreement;
  pair.fixedCovered_mm3 = pair.fixed[pair.agreement].coveredVolume_mm3();
  pair.movingCovered_mm3 = pair.moving[pair.agreement].coveredVolume_mm3();
  pair.voxelsPerSample = voxelsPerSample(pair.fixed[pair.agreement], pair.moving[pair.agreement]);
  for (std::size_t l = 0; l < pair.moving.size(); ++l) {
    ComparableImage& level = pair.moving[l];
    pair.packedMoving.push_back(packed(level));
    if (l <= pair.agreement) continue;
    level.value = {};
    level.weight = {};
  }
  return pair;
}

std::uint64_t forecastPair_bytes(const Grid& fixed, const Grid& moving, const std::vector<double>& voxel_mm) {
  const ComparableMemory f = forecastComparable(fixed, voxel_mm);
  const ComparableMemory m = forecastComparable(moving, voxel_mm);
  std::uint64_t packedBytes = 0;
  for (const double voxel : voxel_mm) packedBytes += static_cast<std::uint64_t>(4.0 * cellsAt(moving, voxel));
  return std::max({f.peak_bytes, f.result_bytes + m.peak_bytes, f.result_bytes + m.result_bytes + packedBytes});
}

Remark remarkWith(RemarkCode what, std::vector<double> figures, const Evidence& evidence) {
  figures.insert(figures.end(), {evidence.agreement.correlation, evidence.agreement.overlapShare, evidence.significance});
  return {what, std::move(figures)};
}

double mostSignificance(const Evidence& evidence) { return std::atanh(kGoodCorrelation) * std::sqrt(evidence.samples); }

Remark onlyStreaks(const WithoutStreaks& fare, double sure) {
  if (fare.evidence.significance < sure) return remarkWith(RemarkCode::onlyStreaksAgree, {}, fare.evidence);
  return {RemarkCode::streaksDecide, {fare.moved.shift_mm, fare.moved.rotation_deg}};
}

std::optional<Remark> whyNothingCanBeSaid(const PairLevels& pair) {
  for (const double which : {0.0, 1.0}) {
    const ComparableImage& image = (which == 0.0 ? pair.fixed : pair.moving)[pair.agreement];
    const auto any = [](const std::vector<std::uint8_t>& weights) {
      return std::any_of(weights.begin(), weights.end(), [](std::uint8_t w) { return w != 0; });
    };
    if (!any(image.weight)) return Remark{RemarkCode::noEcho, {which}};
    if (!any(image.inner)) {
      const glm::ivec3 dims = image.grid.dims;
      const bool grid = std::min({dims.x, dims.y, dims.z}) < 3;  // else what is covered of it
      return Remark{RemarkCode::tooThin, {which, image.grid.spacing_mm.x, grid ? 0.0 : 1.0}};
    }
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t q = 0; q < image.value.size(); ++q) {
      if (image.weight[q] == 0) continue;
      squares += static_cast<double>(image.value[q]) * static_cast<double>(image.value[q]);
      count += 1.0;
    }
    if (squares < 0.01 * count) return Remark{RemarkCode::noStructure, {which}};
  }
  return std::nullopt;
}

Result<void> checkOptions(const RefineOptions& options) {
  const auto wrong = [](const char* field, double found, const Message& expected) {
    return failure(ErrorCode::badField,
                   say<"The registration option %1 is %2; it must be %3.">(verbatim(field), numeral(std::to_string(found)), expected));
  };
  if (!(options.coarsest_mm > 0.0 && options.coarsest_mm <= 100.0))
    return wrong("coarsest_mm", options.coarsest_mm, say<"above 0 and at most 100">());
  if (!(options.finest_mm > 0.0 && options.finest_mm <= 100.0))
    return wrong("finest_mm", options.finest_mm, say<"above 0 and at most 100">());
  if (!(options.searchRotation_deg >= 0.0 && options.searchRotation_deg <= 180.0))
    return wrong("searchRotation_deg", options.searchRotation_deg, say<"from 0 to 180">());
  if (!(options.searchShift_mm > 0.0)) return wrong("searchShift_mm", options.searchShift_mm, say<"above 0">());
  if (options.iterations < 1) return wrong("iterations", options.iterations, say<"1 or more">());
  return {};
}

bool evidenceAt(const PairLevels& pair, std::size_t level, const Transform<frame::Moving, frame::Fixed>& fixedToMoving, double perSample,
                int threads, Progress& progress, Evidence& evidence) {
  const ComparableImage& fixed = pair.fixed[level];
  PoseSums sums;
  const glm::dvec3 centre(0.0);
  if (!sumOverPair(fixed, pair.packedMoving[level], fixedToMoving, centre, {0.0, 0, -1, false, false}, threads, progress, sums))
    return false;
  const double voxel = fixed.grid.spacing_mm.x;
  evidence.agreement.correlation = sums.correlation();
  const double least = std::max(1e-9, std::min(pair.fixedCovered_mm3, pair.movingCovered_mm3));
  evidence.agreement.overlapShare = std::min(1.0, sums.count * voxel * voxel * voxel / least);
  evidence.samples = sums.count / perSample;
  evidence.agreement.chance = evidence.samples > 4.0 ? std::tanh(1.645 / std::sqrt(evidence.samples - 3.0)) : 1.0;
  evidence.significance = std::atanh(std::clamp(evidence.agreement.correlation, -0.999, 0.999)) * std::sqrt(evidence.samples);
  return true;
}

bool refineThrough(const PairLevels& pair, std::size_t first, std::size_t last, const Transform<frame::Moving, frame::Fixed>& start,
                   const RefineOptions& options, int threads, Progress& progress, const OnLevel& onLevel, RigidResult& result) {
  result.fixedToMoving = start;
  Descent descent;
  for (std::size_t l = first; l <= last; ++l) {
    const auto begun = std::chrono::steady_clock::now();
    const double voxel = pair.fixed[l].grid.spacing_mm.x;
    DescentOptions level;
    level.iterations = options.iterations;
    level.stop_mm = l == last ? 0.004 * voxel : 0.03 * voxel;
    level.limit_mm = 2.0 * voxel;
    descent = descend(pair.fixed[l], pair.packedMoving[l], result.fixedToMoving, level, threads, progress);
    if (descent.stop == StopReason::cancelled) return false;
    result.fixedToMoving = descent.fixedToMoving;
    Level report;
    report.voxel_mm = voxel;
    report.iterations = descent.iterations;
    report.correlationBefore = descent.correlationBefore;
    report.correlationAfter = descent.sums.correlation();
    report.seconds = secondsSince(begun);
    result.levels.push_back(report);
    if (onLevel) onLevel(report);
    result.stop = descent.stop;
    if (descent.stop == StopReason::noOverlap || descent.stop == StopReason::singular) return true;
  }

  // Covariance: normal equations cover how the images hold the pose, blocks how far their parts pull it about.
  const ComparableImage& fixed = pair.fixed[last];
  PassOptions pass;
  pass.lossScale = 2.0 * descent.sums.residualRms();
  pass.blockVoxels = std::max(2, static_cast<int>(std::lround(kBlock_mm / fixed.grid.spacing_mm.x)));
  pass.perBlock = true;
  PoseSums sums;
  std::vector<PoseSums> blocks;
  const glm::dvec3 centre = descent.centre_mm;
  result.centre_mm = centre;
  if (!sumOverPair(fixed, pair.packedMoving[last], result.fixedToMoving, centre, pass, threads, progress, sums, &blocks)) return false;
  result.residualRms = sums.residualRms();
  const NormalMatrix normal = scaled(sums.normal);
  const Eigen::SelfAdjointEigenSolver<NormalMatrix> eigen(normal);
  const double least = eigen.eigenvalues()[0];
  const double most = eigen.eigenvalues()[5];
  result.conditioning = most > 0.0 ? std::max(0.0, least) / most : 0.0;
  if (!(most > 0.0) || result.conditioning < 1e-6) {
    result.stop = StopReason::singular;
    return true;
  }
  const NormalMatrix inverse = normal.inverse() * sums.stiffness();
  NormalMatrix spread = NormalMatrix::Zero();
  int used = 0;
  for (const PoseSums& block : blocks) {
    if (block.count <= 0.0) continue;
    Eigen::Matrix<double, 6, 1> pull;
    for (int r = 0; r < 6; ++r) pull[r] = block.right[r] / (r < 3 ? 1.0 : 50.0);
    spread += pull * pull.transpose();
    ++used;
  }
  if (used > 8) {
    spread *= kUnseen * used / (used - 6);
    const NormalMatrix covariance = inverse * spread * inverse;
    PoseCovariance out{};
    for (int r = 0; r < 6; ++r) {
      for (int q = 0; q < 6; ++q) out[6 * r + q] = covariance(r, q) / ((r < 3 ? 1.0 : 50.0) * (q < 3 ? 1.0 : 50.0));
    }
    result.covariance = out;
  }
  return true;
}

void keepInstead(const Transform<frame::Moving, frame::Fixed>& kept, RigidResult& result) {
  if (result.covariance) {
    const Transform<frame::Fixed, frame::Fixed> motion = inverse(kept) * result.fixedToMoving;
    const glm::dvec3 shift = carried(motion, result.centre_mm) - result.centre_mm;
    const glm::dmat4& apart = motion.matrix;
    const Eigen::Matrix3d turned = (Eigen::Matrix3d() << apart[0][0], apart[1][0], apart[2][0], apart[0][1], apart[1][1], apart[2][1],
                                    apart[0][2], apart[1][2], apart[2][2])
                                       .finished();
    const Eigen::AngleAxisd turn(turned);
    Eigen::Matrix<double, 6, 1> error;
    error << shift.x, shift.y, shift.z, turn.angle() * turn.axis();
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c < 6; ++c) (*result.covariance)[6 * r + c] += error[r] * error[c];
    }
  }
  result.fixedToMoving = kept;
  result.stop = StopReason::noImprovement;
}

Streaks streaksOf(const Input& fixed, const Input& moving, const PairLevels& pair, int threads, Progress& progress) {
  Streaks streaks;
  const auto fill = [&](const Input& side, const ComparableImage& image, std::vector<Beams>& directions) {
    if (side.beams) {
      directions = {*side.beams};
      return;
    }
    for (const glm::dvec3& found : findStreaks(image, threads, progress)) directions.push_back({found});
    streaks.found = streaks.found || !directions.empty();
  };
  fill(fixed, pair.fixed[0], streaks.fixed);
  fill(moving, pair.moving[0], streaks.moving);
  return streaks;
}

Result<WithoutStreaks> fareWithoutStreaks(const Input& fixed, const Input& moving, const Streaks& streaks,
                                          const std::vector<double>& voxel_mm, std::size_t first,
                                          const Transform<frame::Moving, frame::Fixed>& pose, double sure, int threads, Progress& progress,
                                          PairLevels& pair) {
  struct Way {
    Input fixed;
    Input moving;
  };
  std::vector<Way> ways;
  for (std::size_t f = 0; f < std::max<std::size_t>(1, streaks.fixed.size()); ++f) {
    for (std::size_t m = 0; m < std::max<std::size_t>(1, streaks.moving.size()); ++m) {
      Way way{fixed, moving};
      if (!streaks.fixed.empty()) way.fixed.beams = streaks.fixed[f];
      if (!streaks.moving.empty()) way.moving.beams = streaks.moving[m];
      ways.push_back(way);
    }
  }
  const auto prepare = [&](const Way& way) -> Result<void> {
    pair = {};  // before the next takes its memory
    auto prepared = preparePair(way.fixed, way.moving, voxel_mm, threads, progress);
    if (!prepared) return passOn(prepared.error());
    pair = std::move(*prepared);
    return {};
  };
  WithoutStreaks best;
  std::size_t chosen = 0;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    if (auto prepared = prepare(ways[w]); !prepared) return passOn(prepared.error());
    WithoutStreaks fare;
    fare.fixedToMoving = pose;
    glm::dvec3 middle(0.0);
    bool lost = false;
    for (std::size_t l = first; l <= std::max(first, pair.agreement) && !lost; ++l) {
      const double voxel = pair.fixed[l].grid.spacing_mm.x;
      DescentOptions options;
      options.stop_mm = 0.03 * voxel;
      options.limit_mm = 2.0 * voxel;
      const Descent descent = descend(pair.fixed[l], pair.packedMoving[l], fare.fixedToMoving, options, threads, progress);
      if (descent.stop == StopReason::cancelled) return failure(ErrorCode::cancelled, say<"Registration was cancelled.">());
      lost = descent.stop == StopReason::noOverlap || descent.stop == StopReason::singular;
      if (lost) break;
      fare.fixedToMoving = descent.fixedToMoving;
      middle = descent.centre_mm;
    }
    if (!lost) {
      fare.moved = differenceOf(pose, fare.fixedToMoving, middle);
      if (!evidenceAt(pair, pair.agreement, fare.fixedToMoving, pair.voxelsPerSample, threads, progress, fare.evidence))
        return failure(ErrorCode::cancelled, say<"Registration was cancelled.">());
    }
    const bool moves = elsewhere(fare.moved);
    fare.rests = moves || fare.evidence.significance < sure;
    if (w == 0) {
      best = fare;
      if (!fare.rests) return best;
    } else if (moves && fare.evidence.significance > best.evidence.significance) {
      best = fare;
      chosen = w;
    }
  }
  if (chosen + 1 != ways.size()) {
    if (auto prepared = prepare(ways[chosen]); !prepared) return passOn(prepared.error());
  }
  return best;
}

bool halvesApart(const PairLevels& pair, std::size_t first, std::size_t last, const Transform<frame::Moving, frame::Fixed>& start,
                 int threads, Progress& progress, double& disagree_mm) {
  std::array<Transform<frame::Moving, frame::Fixed>, 2> poses{start, start};
  disagree_mm = std::numeric_limits<double>::infinity();
  glm::dvec3 lowest(0.0);
  glm::dvec3 highest(0.0);
  for (int half = 0; half < 2; ++half) {
    for (std::size_t l = first; l <= last; ++l) {
      const double voxel = pair.fixed[l].grid.spacing_mm.x;
      DescentOptions options;
      options.iterations = 15;
      options.stop_mm = 0.03 * voxel;
      options.limit_mm = 2.0 * voxel;
      options.half = half;
      options.blockVoxels = std::max(2, static_cast<int>(std::lround(kBlock_mm / voxel)));
      const Descent descent = descend(pair.fixed[l], pair.packedMoving[l], poses[half], options, threads, progress);
      if (descent.stop == StopReason::cancelled) return false;
      if (descent.stop == StopReason::noOverlap || descent.stop == StopReason::singular) return true;
      poses[half] = descent.fixedToMoving;
      lowest = descent.sums.lowest;
      highest = descent.sums.highest;
    }
  }
  const auto toFixed = pair.fixed[last].grid.voxelTo<frame::Fixed>();
  disagree_mm = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const auto p = toFixed * Point<frame::Voxel>{{(corner & 1) != 0 ? highest.x : lowest.x, (corner & 2) != 0 ? highest.y : lowest.y,
                                                  (corner & 4) != 0 ? highest.z : lowest.z}};
    disagree_mm = std::max(disagree_mm, glm::length((poses[0] * p).at - (poses[1] * p).at));
  }
  return true;
}

}  // namespace ew::registration
