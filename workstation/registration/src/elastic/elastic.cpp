#include "ew/registration/elastic.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "comparable.h"
#include "elastic/along_beams.h"
#include "elastic/left_motion.h"
#include "elastic/levels.h"
#include "elastic/wide_start.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"

namespace ew::registration {
namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr double kAgreement_mm = 2.0;  // voxels at which agreement is stated: speckle is suppressed, structure is not
constexpr double kCoarsest_mm = 4.0;
constexpr double kLookedAt_mm = 0.7;       // the finest voxels, from these on, at which motion left by the bend is looked for
constexpr double kLeftShare = 0.32;        // of the places that tell; less one deviation good bends reach 0.26, missed waves 0.33 to 0.96
constexpr double kLeftPlaces = 12.0;       // that must tell
constexpr double kStreakyMembrane = 5e-2;  // weight of slopes: what is left of shadows pulls far from tissue that holds against it
constexpr double kSearched = 3.0;          // measured on unrelated tissue, which reaches about 1.3 times the root of p / n

/// Places in a level are 32-bit numbers.
Result<void> checkSize(const Input& input, const char* side) {
  if (auto usable = checkInput(input, side); !usable) return passOn(usable.error());
  if (input.volume->grid.voxelCount() > (std::size_t{1} << 30))
    return failure(ErrorCode::tooLarge,
                   std::string("The ") + side + " volume has more than 2^30 voxels; resample it to a coarser spacing first.");
  return {};
}

Result<void> checkOptions(const ElasticOptions& options) {
  const auto refuse = [](const char* name, double value, const char* expected) {
    return failure(ErrorCode::badField,
                   std::string("The option ") + name + " is " + std::to_string(value) + "; it must be " + expected + ".");
  };
  const std::pair<const char*, double> nonNegative[] = {{"finestNode_mm", options.finestNode_mm},
                                                        {"finestVoxel_mm", options.finestVoxel_mm},
                                                        {"stiffness", options.stiffness},
                                                        {"largestMotion_mm", options.largestMotion_mm},
                                                        {"maxTime_s", options.maxTime_s}};
  for (const auto& [name, value] : nonNegative) {
    if (!(value >= 0.0) || !std::isfinite(value)) return refuse(name, value, "0 or more");
  }
  if (options.finestNode_mm > 0.0 && options.finestNode_mm < 1.0) return refuse("finestNode_mm", options.finestNode_mm, "0 or at least 1");
  if (options.largestMotion_mm > 50.0) return refuse("largestMotion_mm", options.largestMotion_mm, "at most 50; place the volumes first");
  if (!(options.leastJacobian > 0.0 && options.leastJacobian < 0.9))
    return refuse("leastJacobian", options.leastJacobian, "above 0 and below 0.9");
  return {};
}

double finestSpacing(const Grid& grid) {
  double finest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] > 1) finest = std::min(finest, grid.spacing_mm[axis]);
  }
  return std::isfinite(finest) ? finest : grid.spacing_mm.x;
}

ElasticSettings settingsFor(const ElasticOptions& options, const Grid& fixed) {
  ElasticSettings settings;
  settings.leastJacobian = options.leastJacobian;
  double finest = 0.5;
  int iterations = 12;
  switch (options.effort) {
    case ElasticEffort::fast:
      settings.node_mm = 10.0;
      finest = 1.0;
      break;
    case ElasticEffort::balanced:
      settings.node_mm = 8.0;
      settings.converged = 0.1;
      iterations = 20;
      break;
    case ElasticEffort::accurate:
      settings.node_mm = 6.0;
      settings.converged = 0.05;
      iterations = 30;
      break;
  }
  if (options.finestNode_mm > 0.0) settings.node_mm = options.finestNode_mm;
  if (options.finestVoxel_mm > 0.0) finest = options.finestVoxel_mm;
  finest = std::max(finest, finestSpacing(fixed));
  // Small volumes start with at least a handful of voxels along their shortest side.
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (fixed.dims[axis] > 1) shortest = std::min(shortest, fixed.dims[axis] * fixed.spacing_mm[axis]);
  }
  double voxel = std::max(finest, std::min(kCoarsest_mm, shortest / 8.0));
  while (voxel > 1.4 * finest) {
    settings.steps.push_back({voxel, iterations});
    voxel *= 0.5;
  }
  settings.steps.push_back({finest, iterations});
  if (options.stiffness > 0.0) settings.measureStiffness = false;
  return settings;
}

/// How far correlations of structures reach, as a volume: sum over shifts along the axes of the product of both images' correlations.
double structureVolume(const LevelImage& fixed, const std::vector<float>& moved, const std::vector<float>& movedWeights) {
  double volume = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 1.0;
    for (int shift = 1; shift < std::min(fixed.dims[axis], 12); ++shift) {
      double f0 = 0.0, f1 = 0.0, w0 = 0.0, w1 = 0.0;
      glm::ivec3 off(0);
      off[axis] = shift;
      for (int k = 0; k + off.z < fixed.dims.z; ++k) {
        for (int j = 0; j + off.y < fixed.dims.y; ++j) {
          const std::size_t here = fixed.rowOf(j, k), there = fixed.rowOf(j + off.y, k + off.z) + static_cast<std::size_t>(off.x);
          for (int i = 0; i + off.x < fixed.dims.x; ++i) {
            const std::size_t a = here + static_cast<std::size_t>(i), b = there + static_cast<std::size_t>(i);
            if (movedWeights[a] <= 0.0F || movedWeights[b] <= 0.0F) continue;
            f0 += static_cast<double>(fixed.values[a] * fixed.values[a]);
            f1 += static_cast<double>(fixed.values[a] * fixed.values[b]);
            w0 += static_cast<double>(moved[a] * moved[a]);
            w1 += static_cast<double>(moved[a] * moved[b]);
          }
        }
      }
      const double product = f0 > 0.0 && w0 > 0.0 ? std::max(f1 / f0, 0.0) * std::max(w1 / w0, 0.0) : 0.0;
      if (product < 0.02) break;
      sum += 2.0 * product;
    }
    volume *= sum * fixed.spacing_mm[axis];
  }
  return volume;
}

double weightOf(const LevelImage& image) {
  const double sample = image.spacing_mm.x * image.spacing_mm.y * image.spacing_mm.z;
  if (image.weights.empty()) return sample * image.dims.x * image.dims.y * image.dims.z;
  double sum = 0.0;
  for (const float w : image.weights) sum += static_cast<double>(w);
  return sum * sample;
}

struct Stated {
  Agreement agreement;
  double independent = 0.0;  ///< structures in the overlap
  double deviation = 0.0;    ///< of the less structured image there, in units of the normalisation
};

bool agreementOf(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, const NodeGrid& nodes,
                 NodeValues values, int threads, Progress& progress, Stated& stated) {
  for (std::size_t n = 3; n < values.size(); n += 4) values[n] = 0.0F;  // brightness is no agreement
  LevelPair pair(fixed, moving, transform, nodes, threads);
  PairSums sums;
  if (!pair.warp(values, progress) || !pair.assemble({}, nullptr, sums, progress)) return false;
  const double sample = fixed.spacing_mm.x * fixed.spacing_mm.y * fixed.spacing_mm.z, n = sums.weight();
  const double smaller = std::min(weightOf(fixed), weightOf(moving));
  stated.agreement.correlation = sums.correlation();
  stated.agreement.overlapShare = smaller > 0.0 ? std::clamp(n * sample / smaller, 0.0, 1.0) : 0.0;
  if (n > 0.0) {
    const double ff = sums.at[4] / n - std::pow(sums.at[2] / n, 2), ww = sums.at[5] / n - std::pow(sums.at[3] / n, 2);
    stated.deviation = std::sqrt(std::max(0.0, std::min(ff, ww)));
    stated.independent = n * sample / structureVolume(fixed, pair.moved(), pair.movedWeights());
  }
  // Fisher: atanh of a correlation of n independent samples has the standard deviation 1 / sqrt(n - 3).
  stated.agreement.chance = stated.independent > 4.0 ? std::tanh(1.645 / std::sqrt(stated.independent - 3.0)) : 1.0;
  return true;
}

ControlGrid controlOf(const NodeGrid& nodes, const NodeValues& values, const Grid& fixed) {
  ControlGrid control;
  control.nodes.dims = nodes.dims;
  control.nodes.spacing_mm = nodes.spacing_mm;
  control.nodes.directions = fixed.directions;
  control.nodes.origin_mm = fixed.origin_mm + fixed.directions * nodes.first_mm;
  control.displacement_mm.reserve(nodes.count());
  for (std::size_t n = 0; n < values.size(); n += 4)
    control.displacement_mm.push_back(glm::vec3(fixed.directions * glm::dvec3(values[n], values[n + 1], values[n + 2])));
  return control;
}

}  // namespace

std::uint64_t forecastElastic_bytes(const Grid& fixed, const Grid& moving, const ElasticOptions& options) {
  const ElasticSettings settings = settingsFor(options, fixed);
  const auto levelOf = [&](const Grid& grid) {
    double floats = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double finest = settings.steps.back().voxel_mm;
      const double samples = finest < 1.3 * grid.spacing_mm[axis]
                                 ? grid.dims[axis]
                                 : std::max(1.0, std::round(grid.dims[axis] * grid.spacing_mm[axis] / finest));
      floats *= axis == 0 ? strideOf(static_cast<int>(samples)) : samples;
    }
    return floats;
  };
  const NodeGrid nodes = nodesFor(fixed, settings.node_mm);
  // Values and weights of both images and of the moved one, beliefs, blocks and moments of the nodes.
  const double bytes = 4.0 * (4.0 * levelOf(fixed) + 2.0 * levelOf(moving)) +
                       static_cast<double>(fixed.voxelCount() + moving.voxelCount()) +
                       static_cast<double>(nodes.count()) * (2.0 * 27.0 * 64.0 + 302.0 * 4.0 + 27.0 * 8.0);
  return static_cast<std::uint64_t>(bytes);
}

Result<ElasticResult> registerElastic(const Input& fixed, const Input& moving, const glm::dmat4& start, const ElasticOptions& options,
                                      Progress& progress, const OnLevel& onLevel) {
  const auto begun = Clock::now();
  if (auto usable = checkSize(fixed, "fixed"); !usable) return passOn(usable.error());
  if (auto usable = checkSize(moving, "moving"); !usable) return passOn(usable.error());
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  if (auto usable = checkRigid(start); !usable) return passOn(usable.error());
  const auto cancelled = [] { return failure(ErrorCode::cancelled, "The elastic registration was cancelled."); };

  const Grid& grid = fixed.volume->grid;
  ElasticSettings settings = settingsFor(options, grid);
  const AxesTransform transform = axesTransformOf(grid, moving.volume->grid, start);
  const int threads = threadCount(options.threads);
  const auto outOfTime = [&] { return options.maxTime_s > 0.0 && secondsSince(begun) > options.maxTime_s; };

  QuietProgress quiet(progress);
  ElasticResult result;
  result.fixedToMoving.rigid = start;
  ElasticState state;
  state.nodes = nodesFor(grid, settings.node_mm);
  state.values.assign(4 * state.nodes.count(), 0.0F);
  if (options.stiffness > 0.0) state.stiffness = options.stiffness;
  const NodeValues nothing = state.values;
  result.uncertainty.assign(state.nodes.count(), 1.0F);

  std::array<std::vector<std::uint8_t>, 2> belief;
  if (!forEachTask(2, threads, quiet, "Preparing the images",
                   [&](int side) { belief[static_cast<std::size_t>(side)] = beliefOf(side == 0 ? fixed : moving); }))
    return cancelled();
  std::optional<BeamPair> takenOut;
  LevelImage fixedStated, movingStated;      // the level at which agreement is stated
  LevelImage fixedLookedAt, movingLookedAt;  // without samples: the one before
  Stated before, after;
  double decided = 0.0;
  bool stopped = false;
  const auto finish = [&](Verdict verdict, Remark remark, StopReason stop) {
    result.verdict = verdict;
    result.remarks = {std::move(remark)};
    result.reason = sentencesOf(result.remarks);
    result.stop = stop;
    result.fixedToMoving.control = controlOf(state.nodes, state.values, grid);
    result.jacobian = jacobianOf(result.fixedToMoving.control);
    result.residualRms = std::sqrt(state.noise);
    result.stiffness = state.stiffness;
    for (const glm::vec3& u : result.fixedToMoving.control.displacement_mm)
      result.largestMotion_mm = std::max(result.largestMotion_mm, static_cast<double>(glm::length(u)));
    result.before = before.agreement;
    result.after = after.agreement;
    result.seconds = secondsSince(begun);
    progress.report("Registering", 1.0);
    return result;
  };

  const auto voxels = [](const Input& input) { return static_cast<double>(input.volume->grid.voxelCount()); };
  const bool alike = std::abs(voxels(fixed) - voxels(moving)) < 0.25 * voxels(fixed);  // one would wait for the other
  double work = 0.0, done = 0.0;
  for (const auto& step : settings.steps) work += std::pow(step.voxel_mm, -2.0);
  const auto finestFrom = [&](double voxel_mm) {
    std::size_t best = 0;
    for (std::size_t s = 0; s < settings.steps.size(); ++s) {
      if (settings.steps[s].voxel_mm >= voxel_mm - 1e-9) best = s;
    }
    return best;
  };
  const std::size_t statedStep = finestFrom(kAgreement_mm), lookedAtStep = finestFrom(kLookedAt_mm);
  for (std::size_t s = 0; s < settings.steps.size() && !stopped; ++s) {
    const auto levelBegun = Clock::now();
    const ElasticSettings::Step& step = settings.steps[s];
    PartOfProgress part(progress, 0.95 * done / work, 0.95 * (done + std::pow(step.voxel_mm, -2.0)) / work);
    done += std::pow(step.voxel_mm, -2.0);
    part.report("Preparing the images", 0.0);
    LevelImage fixedLevel, movingLevel;
    const auto makeLevels = [&](const BeamPair* along, LevelImage& f, LevelImage& m) {
      const auto make = [&](int side, int own) {
        const Beams* beams = along == nullptr ? nullptr : side == 0 ? &along->fixed : &along->moving;
        return makeLevel(side == 0 ? fixed : moving, belief[static_cast<std::size_t>(side)], step.voxel_mm, settings.window_mm, own, quiet,
                         side == 0 ? f : m, beams);
      };
      if (threads == 1 || !alike) return make(0, threads) && make(1, threads);
      // Beside each other also what one image does on one thread: memory that is cleared, small images that are smoothed.
      std::array<std::uint8_t, 2> made{};
      const int each = (threads + 1) / 2;
      return forEachTask(2, 2, quiet, "Preparing the images", [&](int side) { made[static_cast<std::size_t>(side)] = make(side, each); }) &&
             made[0] != 0 && made[1] != 0;
    };
    if (!makeLevels(takenOut ? &*takenOut : nullptr, fixedLevel, movingLevel)) return cancelled();
    if (s == 0) {
      if (weightOf(fixedLevel) * weightOf(movingLevel) <= 0.0)
        return finish(Verdict::cannotTell, {Says::nothingBelieved}, StopReason::noOverlap);
      takenOut = beamsToTakeOut(fixed, moving, start, transform, state.nodes, makeLevels, threads, quiet, fixedLevel, movingLevel);
      if (progress.cancelRequested()) return cancelled();
      if (takenOut) settings.prior.membrane = kStreakyMembrane;
    }
    LevelOutcome outcome;
    if (s == 0 && options.largestMotion_mm > 0.0) {
      PartOfProgress looking(part, 0.2, 0.6);
      const std::vector<NodeValues> starts =
          wideStarts(fixedLevel, movingLevel, transform, state.nodes, options.largestMotion_mm, threads, looking);
      if (starts.empty()) return cancelled();
      ElasticState best = state;
      double most = -std::numeric_limits<double>::infinity();
      for (int n = -1; n < static_cast<int>(starts.size()); ++n) {
        ElasticState tried = state;
        if (n >= 0) tried.values = starts[static_cast<std::size_t>(n)];
        if (n == 0 && tried.values == nothing) continue;
        if (!unfold(tried.nodes, settings.leastJacobian, tried.values)) continue;
        const double each = 0.4 / static_cast<double>(starts.size() + 1), begin = 0.6 + each * (n + 1);
        PartOfProgress one(part, begin, begin + each);
        const LevelOutcome found =
            refineLevel(fixedLevel, movingLevel, transform, step.iterations, Placed::roughly, settings, threads, outOfTime, tried, one);
        if (found.cancelled) return cancelled();
        if (found.singular || found.noOverlap) {
          if (n < 0) outcome = found;
          continue;
        }
        if (found.worth > most) {
          most = found.worth;
          best = std::move(tried);
          outcome = found;
        }
      }
      state = std::move(best);
    } else {
      PartOfProgress refining(part, 0.2, 1.0);
      const Placed placed = s == 0 ? Placed::roughly : s + 1 < settings.steps.size() ? Placed::nearly : Placed::closely;
      outcome = refineLevel(fixedLevel, movingLevel, transform, step.iterations, placed, settings, threads, outOfTime, state, refining);
    }
    if (outcome.cancelled) return cancelled();
    if (outcome.noOverlap) return finish(Verdict::cannotTell, {Says::apartWherePlaced}, StopReason::noOverlap);
    if (outcome.singular) {
      state.values = nothing;
      return finish(Verdict::cannotTell, {Says::nothingToFollow}, StopReason::singular);
    }
    result.stop = outcome.iterations < step.iterations ? StopReason::converged : StopReason::iterationLimit;
    if (outcome.timeUp) {
      result.stop = StopReason::timeLimit;
      stopped = true;
    }
    if (s <= statedStep) decided = outcome.decided;
    if (!outcome.uncertainty.empty()) result.uncertainty = std::move(outcome.uncertainty);
    result.levels.push_back({step.voxel_mm, settings.node_mm, outcome.iterations, outcome.correlationBefore, outcome.correlationAfter,
                             secondsSince(levelBegun)});
    if (onLevel) onLevel(result.levels.back());
    if (s == statedStep || (stopped && s < statedStep)) {
      fixedStated = std::move(fixedLevel);
      movingStated = std::move(movingLevel);
    } else if (s == lookedAtStep) {
      fixedLookedAt = std::move(fixedLevel);
      movingLookedAt = std::move(movingLevel);
    }
  }
  if (!agreementOf(fixedStated, movingStated, transform, state.nodes, nothing, threads, quiet, before) ||
      !agreementOf(fixedStated, movingStated, transform, state.nodes, state.values, threads, quiet, after))
    return cancelled();

  // A field with p parameters that the images decide explains p of n independent structures by itself; the best of many starts, more.
  if (after.independent > 4.0)
    after.agreement.chance =
        std::min(1.0, std::sqrt(after.agreement.chance * after.agreement.chance + kSearched * decided / after.independent));
  const StopReason stop = result.stop;
  if (!(after.agreement.correlation > before.agreement.correlation)) {
    state.values = nothing;
    after = before;
    std::fill(result.uncertainty.begin(), result.uncertainty.end(), 1.0F);
    const bool good = before.agreement.correlation > before.agreement.chance;
    return finish(good ? Verdict::aligned : Verdict::cannotTell, {good ? Says::startKeptGood : Says::startKept},
                  stopped ? stop : StopReason::noImprovement);
  }
  // Where the start itself shows common tissue beyond doubt, bending only has to better it.
  const bool shared = before.agreement.correlation > 2.0 * before.agreement.chance;
  if (!shared && after.agreement.correlation <= after.agreement.chance) {
    const bool enough = after.agreement.chance < 0.35;
    state.values = nothing;
    return finish(enough ? Verdict::notAligned : Verdict::cannotTell,
                  {enough ? Says::bendContradicts : Says::bendTooLittleShared, {after.agreement.correlation, after.agreement.overlapShare}},
                  stopped ? stop : StopReason::noImprovement);
  }
  // Structure larger than the waves of a motion correlates well while the motion itself is missed: small places are asked.
  LeftMotion left;
  const bool separate = fixedLookedAt.dims.x > 0;
  LevelPair pair(separate ? fixedLookedAt : fixedStated, separate ? movingLookedAt : movingStated, transform, state.nodes, threads);
  if (!pair.warp(state.values, quiet) || !lookForLeftMotion(pair, state.nodes, threads, quiet, left)) return cancelled();
  for (std::size_t n = 0; n < left.nodeShare.size(); ++n) {
    if (left.nodeShare[n] > 0.5F) result.uncertainty[n] = std::max(result.uncertainty[n], left.nodeShare[n]);
  }
  result.leftShare = left.share;
  if (left.blocks >= kLeftPlaces && left.share - left.deviation > kLeftShare)
    return finish(Verdict::cannotTell,
                  {Says::motionIsLeft, {left.share, left.length_mm, after.agreement.correlation, after.agreement.overlapShare}}, stop);
  return finish(Verdict::aligned,
                {Says::bendAgrees, {after.agreement.correlation, after.agreement.overlapShare, before.agreement.correlation}}, stop);
}

}  // namespace ew::registration
