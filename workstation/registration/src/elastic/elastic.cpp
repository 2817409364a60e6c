#include "ew/registration/elastic.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "comparable.h"
#include "elastic/along_beams.h"
#include "elastic/levels.h"
#include "elastic/residual_motion.h"
#include "elastic/wide_start.h"
#include "ew/core/contract.h"
#include "ew/core/elapsed.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"

namespace ew::registration {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kAgreement_mm = 2.0;  // voxels at which agreement is stated: speckle is suppressed, structure is not
constexpr double kCoarsest_mm = 4.0;
constexpr double kLookedAt_mm = 0.7;       // the finest voxels, from these on, at which motion left by the warp is looked for
constexpr double kLeftShare = 0.32;        // of the places that tell; less one deviation good warps reach 0.26, missed waves 0.33 to 0.96
constexpr double kLeftPlaces = 12.0;       // that must tell
constexpr double kStreakyMembrane = 5e-2;  // weight of slopes: what is left of shadows pulls far from tissue that holds against it
constexpr double kSearched = 3.0;          // measured on unrelated tissue, which reaches about 1.3 times the root of p / n

/// Places in a level are 32-bit numbers.
Result<void> checkSize(const Input& input, const Message& side) {
  if (auto usable = checkInput(input, side); !usable) return passOn(usable.error());
  if (input.volume->grid.voxelCount() > (std::size_t{1} << 30))
    return failure(ErrorCode::tooLarge, say<"The %1 volume has more than 2^30 voxels; resample it to a coarser spacing first.">(side));
  return {};
}

Result<void> checkOptions(const ElasticOptions& options) {
  const auto refuse = [](const char* name, double value, const Message& expected) {
    return failure(ErrorCode::badField,
                   say<"The option %1 is %2; it must be %3.">(verbatim(name), numeral(std::to_string(value)), expected));
  };
  const std::pair<const char*, double> nonNegative[] = {{"finestNode_mm", options.finestNode_mm},
                                                        {"finestVoxel_mm", options.finestVoxel_mm},
                                                        {"stiffness", options.stiffness},
                                                        {"largestMotion_mm", options.largestMotion_mm},
                                                        {"maxTime_s", options.maxTime_s}};
  for (const auto& [name, value] : nonNegative) {
    if (!(value >= 0.0) || !std::isfinite(value)) return refuse(name, value, say<"0 or more">());
  }
  if (options.finestNode_mm > 0.0 && options.finestNode_mm < 1.0)
    return refuse("finestNode_mm", options.finestNode_mm, say<"0 or at least 1">());
  if (options.largestMotion_mm > 50.0)
    return refuse("largestMotion_mm", options.largestMotion_mm, say<"at most 50; place the volumes first">());
  if (!(options.leastJacobian > 0.0 && options.leastJacobian < 0.9))
    return refuse("leastJacobian", options.leastJacobian, say<"above 0 and below 0.9">());
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

double voxelsOf(const Input& input) { return static_cast<double>(input.volume->grid.voxelCount()); }

/// Both images of a level.
struct LevelImages {
  LevelImage fixed;
  LevelImage moving;
};

/// One registration: what its levels share, and the result as it grows.
class ElasticRun {
 public:
  ElasticRun(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start, const ElasticOptions& options,
             Progress& progress, const OnLevel& onLevel);
  [[nodiscard]] Result<ElasticResult> run();

 private:
  using Step = ElasticSettings::Step;
  using End = std::optional<Result<ElasticResult>>;  // nothing: it goes on

  [[nodiscard]] bool findBeliefs();
  [[nodiscard]] std::size_t finestStepFrom(double voxel_mm) const;

  // A level.
  [[nodiscard]] End doLevel(std::size_t s);
  [[nodiscard]] bool makeLevels(double voxel_mm, const BeamPair* along, LevelImage& fixed, LevelImage& moving);
  [[nodiscard]] bool takeOutBeams(double voxel_mm, LevelImages& images);
  [[nodiscard]] LevelOutcome searchWidely(const LevelImages& images, const Step& step, Progress& part);
  [[nodiscard]] LevelOutcome refine(const LevelImages& images, std::size_t s, Progress& part);
  void take(LevelOutcome& outcome, std::size_t s, Clock::time_point begun);
  void keep(LevelImages& images, std::size_t s);

  // What is made of the field found.
  [[nodiscard]] bool stateAgreement();
  [[nodiscard]] ElasticResult keepStart();
  [[nodiscard]] ElasticResult refuse();
  [[nodiscard]] bool findResidualMotion(ResidualMotion& left);
  [[nodiscard]] Result<ElasticResult> judge();

  [[nodiscard]] ElasticResult finish(Verdict verdict, Remark remark, StopReason stop);
  [[nodiscard]] static tl::unexpected<Error> cancelled();

  const Input& fixed_;
  const Input& moving_;
  const Transform<frame::Moving, frame::Fixed>& start_;
  const ElasticOptions& options_;
  Progress& progress_;
  const OnLevel& onLevel_;
  Clock::time_point begun_ = Clock::now();
  QuietProgress quiet_;
  ElasticSettings settings_;
  AxesTransform transform_;
  int threads_;
  std::function<bool()> outOfTime_;
  std::size_t statedStep_;    ///< at whose level agreement is stated
  std::size_t lookedAtStep_;  ///< at whose level motion that is left is looked for
  double work_ = 0.0;         ///< of all levels, and of those done
  double done_ = 0.0;
  ElasticState state_;
  NodeValues nothing_;
  std::array<std::vector<std::uint8_t>, 2> belief_;
  std::optional<BeamPair> takenOut_;
  LevelImages statedAt_;
  LevelImages lookedAt_;  ///< without samples: the one at which agreement is stated
  Stated before_;
  Stated after_;
  double decided_ = 0.0;
  bool stopped_ = false;
  ElasticResult result_;
};

ElasticRun::ElasticRun(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                       const ElasticOptions& options, Progress& progress, const OnLevel& onLevel)
    : fixed_(fixed),
      moving_(moving),
      start_(start),
      options_(options),
      progress_(progress),
      onLevel_(onLevel),
      quiet_(progress),
      settings_(settingsFor(options, fixed.volume->grid)),
      transform_(axesTransformOf(fixed.volume->grid, moving.volume->grid, start)),
      threads_(threadCount(options.threads)),
      outOfTime_([this] { return options_.maxTime_s > 0.0 && secondsSince(begun_) > options_.maxTime_s; }),
      statedStep_(finestStepFrom(kAgreement_mm)),
      lookedAtStep_(finestStepFrom(kLookedAt_mm)) {
  for (const Step& step : settings_.steps) work_ += std::pow(step.voxel_mm, -2.0);
  state_.nodes = nodesFor(fixed.volume->grid, settings_.node_mm);
  state_.values.assign(4 * state_.nodes.count(), 0.0F);
  if (options.stiffness > 0.0) state_.stiffness = options.stiffness;
  nothing_ = state_.values;
  result_.fixedToMoving.rigid = start;
  result_.uncertainty.assign(state_.nodes.count(), 1.0F);
}

Result<ElasticResult> ElasticRun::run() {
  if (!findBeliefs()) return cancelled();
  for (std::size_t s = 0; s < settings_.steps.size() && !stopped_; ++s) {
    if (End end = doLevel(s)) return std::move(*end);
  }
  if (!stateAgreement()) return cancelled();
  return judge();
}

bool ElasticRun::findBeliefs() {
  return forEachTask(2, threads_, quiet_, say<"Preparing the images">(),
                     [&](int side) { belief_[static_cast<std::size_t>(side)] = beliefOf(side == 0 ? fixed_ : moving_); });
}

std::size_t ElasticRun::finestStepFrom(double voxel_mm) const {
  std::size_t best = 0;
  for (std::size_t s = 0; s < settings_.steps.size(); ++s) {
    if (settings_.steps[s].voxel_mm >= voxel_mm - 1e-9) best = s;
  }
  return best;
}

ElasticRun::End ElasticRun::doLevel(std::size_t s) {
  const auto begun = Clock::now();
  const Step& step = settings_.steps[s];
  const double work = std::pow(step.voxel_mm, -2.0);
  PartOfProgress part(progress_, 0.95 * done_ / work_, 0.95 * (done_ + work) / work_);
  done_ += work;
  part.report(say<"Preparing the images">(), 0.0);
  LevelImages images;
  if (!makeLevels(step.voxel_mm, takenOut_ ? &*takenOut_ : nullptr, images.fixed, images.moving)) return cancelled();
  if (s == 0) {
    if (weightOf(images.fixed) * weightOf(images.moving) <= 0.0)
      return finish(Verdict::cannotTell, {RemarkCode::nothingBelieved}, StopReason::noOverlap);
    if (!takeOutBeams(step.voxel_mm, images)) return cancelled();
  }
  LevelOutcome outcome = s == 0 && options_.largestMotion_mm > 0.0 ? searchWidely(images, step, part) : refine(images, s, part);
  if (outcome.cancelled) return cancelled();
  if (outcome.noOverlap) return finish(Verdict::cannotTell, {RemarkCode::apartWherePlaced}, StopReason::noOverlap);
  if (outcome.singular) {
    state_.values = nothing_;
    return finish(Verdict::cannotTell, {RemarkCode::nothingToFollow}, StopReason::singular);
  }
  take(outcome, s, begun);
  keep(images, s);
  return std::nullopt;
}

/// @param along beams along which something is taken out; null: nothing is
/// @return false when cancelled; so are the others
bool ElasticRun::makeLevels(double voxel_mm, const BeamPair* along, LevelImage& fixed, LevelImage& moving) {
  const auto make = [&](int side, int threads) {
    const Beams* beams = along == nullptr ? nullptr : side == 0 ? &along->fixed : &along->moving;
    return makeLevel(side == 0 ? fixed_ : moving_, belief_[static_cast<std::size_t>(side)], voxel_mm, settings_.window_mm, threads, quiet_,
                     side == 0 ? fixed : moving, beams);
  };
  const bool alike = std::abs(voxelsOf(fixed_) - voxelsOf(moving_)) < 0.25 * voxelsOf(fixed_);  // one would wait for the other
  if (threads_ == 1 || !alike) return make(0, threads_) && make(1, threads_);
  // Concurrently also what one image does on one thread: memory that is cleared, small images that are smoothed.
  std::array<std::uint8_t, 2> made{};
  const int each = (threads_ + 1) / 2;
  return forEachTask(2, 2, quiet_, say<"Preparing the images">(),
                     [&](int side) { made[static_cast<std::size_t>(side)] = make(side, each); }) &&
         made[0] != 0 && made[1] != 0;
}

bool ElasticRun::takeOutBeams(double voxel_mm, LevelImages& images) {
  const auto make = [&](const BeamPair* along, LevelImage& fixed, LevelImage& moving) {
    return makeLevels(voxel_mm, along, fixed, moving);
  };
  takenOut_ = beamsToTakeOut(fixed_, moving_, start_, transform_, state_.nodes, make, threads_, quiet_, images.fixed, images.moving);
  if (progress_.cancelRequested()) return false;
  if (takenOut_) settings_.prior.membrane = kStreakyMembrane;
  return true;
}

/// Refines from nothing and from each of the starts of the wide search; the one of most worth goes on.
LevelOutcome ElasticRun::searchWidely(const LevelImages& images, const Step& step, Progress& part) {
  LevelOutcome outcome;
  PartOfProgress looking(part, 0.2, 0.6);
  const std::vector<NodeValues> starts =
      wideStarts(images.fixed, images.moving, transform_, state_.nodes, options_.largestMotion_mm, threads_, looking);
  if (starts.empty()) {
    outcome.cancelled = true;
    return outcome;
  }
  ElasticState best = state_;
  double most = -std::numeric_limits<double>::infinity();
  for (int n = -1; n < static_cast<int>(starts.size()); ++n) {
    ElasticState tried = state_;
    if (n >= 0) tried.values = starts[static_cast<std::size_t>(n)];
    if (n == 0 && tried.values == nothing_) continue;
    if (!unfold(tried.nodes, settings_.leastJacobian, tried.values)) continue;
    const double each = 0.4 / static_cast<double>(starts.size() + 1), begin = 0.6 + each * (n + 1);
    PartOfProgress one(part, begin, begin + each);
    LevelOutcome found =
        refineLevel(images.fixed, images.moving, transform_, step.iterations, Placed::roughly, settings_, threads_, outOfTime_, tried, one);
    if (found.cancelled) return found;
    if (found.singular || found.noOverlap) {
      if (n < 0) outcome = std::move(found);
      continue;
    }
    if (found.worth > most) {
      most = found.worth;
      best = std::move(tried);
      outcome = std::move(found);
    }
  }
  state_ = std::move(best);
  return outcome;
}

LevelOutcome ElasticRun::refine(const LevelImages& images, std::size_t s, Progress& part) {
  PartOfProgress refining(part, 0.2, 1.0);
  const Placed placed = s == 0 ? Placed::roughly : s + 1 < settings_.steps.size() ? Placed::nearly : Placed::closely;
  return refineLevel(images.fixed, images.moving, transform_, settings_.steps[s].iterations, placed, settings_, threads_, outOfTime_,
                     state_, refining);
}

/// What a level came to goes into the result.
void ElasticRun::take(LevelOutcome& outcome, std::size_t s, Clock::time_point begun) {
  const Step& step = settings_.steps[s];
  result_.stop = outcome.iterations < step.iterations ? StopReason::converged : StopReason::iterationLimit;
  if (outcome.timeUp) {
    result_.stop = StopReason::timeLimit;
    stopped_ = true;
  }
  if (s <= statedStep_) decided_ = outcome.decided;
  if (!outcome.uncertainty.empty()) result_.uncertainty = std::move(outcome.uncertainty);
  result_.levels.push_back(
      {step.voxel_mm, settings_.node_mm, outcome.iterations, outcome.correlationBefore, outcome.correlationAfter, secondsSince(begun)});
  if (onLevel_) onLevel_(result_.levels.back());
}

void ElasticRun::keep(LevelImages& images, std::size_t s) {
  if (s == statedStep_ || (stopped_ && s < statedStep_))
    statedAt_ = std::move(images);
  else if (s == lookedAtStep_)
    lookedAt_ = std::move(images);
}

bool ElasticRun::stateAgreement() {
  const auto& [fixed, moving] = statedAt_;
  if (!agreementOf(fixed, moving, transform_, state_.nodes, nothing_, threads_, quiet_, before_) ||
      !agreementOf(fixed, moving, transform_, state_.nodes, state_.values, threads_, quiet_, after_))
    return false;
  // A field with p parameters that the images decide explains p of n independent structures by itself; the best of many starts, more.
  if (after_.independent > 4.0)
    after_.agreement.chance =
        std::min(1.0, std::sqrt(after_.agreement.chance * after_.agreement.chance + kSearched * decided_ / after_.independent));
  return true;
}

Result<ElasticResult> ElasticRun::judge() {
  const Agreement &before = before_.agreement, &after = after_.agreement;
  if (!(after.correlation > before.correlation)) return keepStart();
  // Where the start itself shows common tissue beyond doubt, bending only has to better it.
  const bool shared = before.correlation > 2.0 * before.chance;
  if (!shared && after.correlation <= after.chance) return refuse();
  ResidualMotion left;
  if (!findResidualMotion(left)) return cancelled();
  const StopReason stop = result_.stop;
  if (left.blocks >= kLeftPlaces && left.share - left.deviation > kLeftShare)
    return finish(Verdict::cannotTell, {RemarkCode::motionRemains, {left.share, left.length_mm, after.correlation, after.overlapShare}},
                  stop);
  return finish(Verdict::aligned, {RemarkCode::warpAgrees, {after.correlation, after.overlapShare, before.correlation}}, stop);
}

/// No field agrees better than none.
ElasticResult ElasticRun::keepStart() {
  state_.values = nothing_;
  after_ = before_;
  std::fill(result_.uncertainty.begin(), result_.uncertainty.end(), 1.0F);
  const bool good = before_.agreement.correlation > before_.agreement.chance;
  return finish(good ? Verdict::aligned : Verdict::cannotTell, {good ? RemarkCode::startKeptGood : RemarkCode::startKept},
                stopped_ ? result_.stop : StopReason::noImprovement);
}

/// The field agrees no better than chance does.
ElasticResult ElasticRun::refuse() {
  const Agreement& after = after_.agreement;
  const bool enough = after.chance < 0.35;
  state_.values = nothing_;
  return finish(enough ? Verdict::notAligned : Verdict::cannotTell,
                {enough ? RemarkCode::warpContradicts : RemarkCode::warpTooLittleShared, {after.correlation, after.overlapShare}},
                stopped_ ? result_.stop : StopReason::noImprovement);
}

/// Structure larger than the waves of a motion correlates well while the motion itself is missed: small places are asked.
bool ElasticRun::findResidualMotion(ResidualMotion& left) {
  const auto& [fixed, moving] = lookedAt_.fixed.dims.x > 0 ? lookedAt_ : statedAt_;
  LevelPair pair(fixed, moving, transform_, state_.nodes, threads_);
  if (!pair.warp(state_.values, quiet_) || !lookForResidualMotion(pair, state_.nodes, threads_, quiet_, left)) return false;
  for (std::size_t n = 0; n < left.nodeShare.size(); ++n) {
    if (left.nodeShare[n] > 0.5F) result_.uncertainty[n] = std::max(result_.uncertainty[n], left.nodeShare[n]);
  }
  result_.residualShare = left.share;
  return true;
}

ElasticResult ElasticRun::finish(Verdict verdict, Remark remark, StopReason stop) {
  result_.verdict = verdict;
  result_.remarks = {std::move(remark)};
  result_.reason = messageOf(result_.remarks);
  result_.stop = stop;
  result_.fixedToMoving.control = controlOf(state_.nodes, state_.values, fixed_.volume->grid);
  result_.jacobian = jacobianOf(result_.fixedToMoving.control);
  result_.residualRms = std::sqrt(state_.noise);
  result_.stiffness = state_.stiffness;
  for (const glm::vec3& u : result_.fixedToMoving.control.displacement_mm)
    result_.largestMotion_mm = std::max(result_.largestMotion_mm, static_cast<double>(glm::length(u)));
  result_.before = before_.agreement;
  result_.after = after_.agreement;
  result_.seconds = secondsSince(begun_);
  progress_.report(say<"Registering">(), 1.0);
  return std::move(result_);
}

tl::unexpected<Error> ElasticRun::cancelled() { return failure(ErrorCode::cancelled, say<"The elastic registration was cancelled.">()); }

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

Result<ElasticResult> registerElastic(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                      const ElasticOptions& options, Progress& progress, const OnLevel& onLevel) {
  if (auto usable = checkSize(fixed, say<"fixed">()); !usable) return passOn(usable.error());
  if (auto usable = checkSize(moving, say<"moving">()); !usable) return passOn(usable.error());
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  if (auto usable = checkRigid(start); !usable) return passOn(usable.error());
  return ElasticRun(fixed, moving, start, options, progress, onLevel).run();
}

}  // namespace ew::registration
