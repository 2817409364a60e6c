#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "elastic/planar_registration.h"
#include "ew/core/elapsed.h"
#include "ew/core/figures.h"
#include "ew/core/quiet_progress.h"
#include "ew/registration/elastic.h"

namespace ew::registration {
namespace {

/// The settings' lengths are for images 100 mm wide with pixels of 0.4 mm. A smaller, finer image has finer speckle and smaller motion.
double unitOf(ImageView<const std::uint8_t> fixed, glm::dvec2 pixel_mm) {
  const double extent = std::max(fixed.width * pixel_mm.x, fixed.height * pixel_mm.y);
  return std::max(std::min(pixel_mm.x, pixel_mm.y), std::min(0.4, extent / 256.0));
}

/// Stiff where pixels are large (there a pixel holds little but speckle and chance), then as the speckle says.
PlanarLevel levelOf(double scale, double node_mm, double units, bool first) {
  PlanarLevel level{scale, node_mm, 0.4, 0.6, 15.0};
  if (units > 3.0 && first) {
    level.leastStiffness = 25.0 * units;
    level.mostStiffness = 1000.0;
  } else if (units > 1.7) {
    level.firmness = 1.2;
    level.leastStiffness = 1.0;
    level.mostStiffness = 30.0;
  }
  return level;
}

Result<void> check(ImageView<const std::uint8_t> fixed, ImageView<const std::uint8_t> moving, glm::dvec2 pixel_mm,
                   const Elastic2dOptions& options) {
  for (const auto& [image, name] : {std::pair{fixed, say<"fixed">()}, std::pair{moving, say<"moving">()}}) {
    if (image.data == nullptr || image.width < 1 || image.height < 1)
      return failure(ErrorCode::emptyVolume, say<"The %1 image has no pixels.">(name));
    if (image.stride < image.width) return failure(ErrorCode::badField, say<"The %1 image's rows overlap.">(name), {{"field", "stride"}});
  }
  if (!(pixel_mm.x > 0.0) || !(pixel_mm.y > 0.0) || !std::isfinite(pixel_mm.x) || !std::isfinite(pixel_mm.y))
    return failure(ErrorCode::badField, say<"The distance of pixels must be above 0 mm in x and in y.">(), {{"field", "pixel_mm"}});
  for (const double factor : options.factors) {
    if (!(factor >= 2.0) || !std::isfinite(factor))
      return failure(ErrorCode::badField, say<"A factor is the distance of nodes in pixels and must be at least 2.">(),
                     {{"field", "factors"}});
  }
  if (!(options.stiffness >= 0.0) || !std::isfinite(options.stiffness))
    return failure(ErrorCode::badField, say<"The stiffness must be 0 (automatic) or above.">(), {{"field", "stiffness"}});
  if (!(options.largestMotion_mm >= 0.0) || !std::isfinite(options.largestMotion_mm))
    return failure(ErrorCode::badField, say<"The largest motion must be 0 mm (no search) or above.">(), {{"field", "largestMotion_mm"}});
  if (options.iterations < 1) return failure(ErrorCode::badField, say<"At least one iteration is needed.">(), {{"field", "iterations"}});
  return {};
}

Message hundredths(double value) { return fixedNumeral(value, 2); }

Agreement agreementOf(const PlanarAgreement& found, double coverable) {
  Agreement out;
  out.correlation = found.correlation;
  out.overlapShare = coverable > 0.0 ? std::min(1.0, found.weight / coverable) : 0.0;
  out.chance = found.independent > 4.0 ? std::tanh(1.645 / std::sqrt(found.independent - 3.0)) : 1.0;
  return out;
}

PlanarSettings settingsOf(const Elastic2dOptions& options, double lengths) {
  PlanarSettings settings;
  settings.window_mm *= lengths;
  settings.slope_mm *= lengths;
  settings.bending_mm *= lengths;
  settings.brightness_mm *= lengths;
  settings.brightnessTerm = options.intensityTerm;
  settings.stiffness = options.stiffness;
  settings.iterations = options.iterations;
  settings.threads = options.threads;
  return settings;
}

/// The pyramid, coarse to fine.
/// @param lengths what the settings' lengths are multiplied by
std::vector<PlanarLevel> planarLevels(const Elastic2dOptions& options, double unit, double lengths, double finestPixel_mm) {
  std::vector<PlanarLevel> levels;
  if (options.factors.empty()) {
    // Which of the two last levels is used depends on the speckle, once the second has measured it.
    for (const auto& [units, nodes] : {std::pair{4.0, 16.0}, std::pair{2.0, 12.0}, std::pair{1.5, 12.0}, std::pair{1.0, 10.0}})
      levels.push_back(levelOf(std::max(1.0, units * unit / finestPixel_mm), nodes * lengths, units, levels.empty()));
  } else {
    std::vector<double> factors = options.factors;
    std::sort(factors.rbegin(), factors.rend());
    for (const double factor : factors) {
      const double scale = std::max(1.0, factor / 6.0);  // six pixels of its level from node to node, as the paper's last level has
      levels.push_back(levelOf(scale, factor * finestPixel_mm, scale * finestPixel_mm / unit, levels.empty()));
    }
  }
  if (options.singleResolution) levels.erase(levels.begin(), levels.end() - 1);
  return levels;
}

/// Lattice and shift of a level; what else `state` knows stays.
void layOut(glm::dvec2 extent_mm, const PlanarPair& pair, const PlanarLevel& level, glm::dvec2 shift_mm, PlanarState& state) {
  state.x = splineAxis(extent_mm.x, level.node_mm, pair.fixed.pixel_mm.x, pair.fixed.width);
  state.y = splineAxis(extent_mm.y, level.node_mm, pair.fixed.pixel_mm.y, pair.fixed.height);
  const std::size_t nodes = static_cast<std::size_t>(state.x.nodes()) * static_cast<std::size_t>(state.y.nodes());
  state.field.part[0].assign(nodes, static_cast<float>(shift_mm.x));
  state.field.part[1].assign(nodes, static_cast<float>(shift_mm.y));
  state.field.part[2].assign(nodes, 0.0F);
}

/// What a finer level begins with: the field found so far on its lattice.
PlanarState carriedTo(const PlanarState& state, glm::dvec2 extent_mm, const PlanarPair& pair, const PlanarLevel& level) {
  PlanarState next;
  layOut(extent_mm, pair, level, glm::dvec2(0.0), next);
  for (std::size_t k = 0; k < 3; ++k) next.field.part[k] = carriedOver(state.x, state.y, state.field.part[k], next.x, next.y);
  next.coherence = state.coherence;
  return next;
}

/// A displacement at the samples of an image.
struct FieldSamples {
  std::vector<float> x;
  std::vector<float> y;

  void scale(float by) {
    for (float& u : x) u *= by;
    for (float& u : y) u *= by;
  }
};

/// A pair with the level it was made for.
struct PairAtLevel {
  PlanarPair pair;
  PlanarLevel level;
};

/// What a warp found on one half of the plane is worth on the other half.
struct Holdout {
  double share = 1.0;  ///< of the motion that agrees best where it was not fitted; 0: none agrees better than nothing does
  double gain = 0.0;   ///< of correlation there, at that share
  double error = 1.0;  ///< standard error of a correlation there
};

/// The squares of one colour of a checkerboard.
/// @param guard_mm distance kept from their borders: smoothed grain reaches over them, so what is judged stays away
PlanarPair onColour(const PlanarPair& pair, int colour, double square_mm, double guard_mm) {
  PlanarPair part = pair;
  for (int y = 0; y < part.fixed.height; ++y) {
    for (int x = 0; x < part.fixed.width; ++x) {
      const int a = static_cast<int>((x + 0.5) * part.fixed.pixel_mm.x / square_mm),
                b = static_cast<int>((y + 0.5) * part.fixed.pixel_mm.y / square_mm);
      const double inX = (x + 0.5) * part.fixed.pixel_mm.x - a * square_mm, inY = (y + 0.5) * part.fixed.pixel_mm.y - b * square_mm;
      const bool atBorder = std::min({inX, inY, square_mm - inX, square_mm - inY}) < guard_mm;
      if ((a + b) % 2 != colour || atBorder)
        part.fixed.weight[static_cast<std::size_t>(y) * static_cast<std::size_t>(part.fixed.width) + static_cast<std::size_t>(x)] = 0.0F;
    }
  }
  return part;
}

/// Fits the warp twice, each time on every other square of a checkerboard, and judges each on the other squares. A warp that only fits
/// grain to grain gains nothing there.
/// @return nothing when cancelled
std::optional<Holdout> heldOut(const PairAtLevel& coarse, const PairAtLevel& fine, const PlanarState& start, double square_mm,
                               const PlanarSettings& settings, Progress& progress) {
  constexpr int kShares = 5;  // 0, 1/4 .. 1
  std::array<double, kShares> agreed{};
  double independent = 0.0;
  const glm::dvec2 extent_mm{fine.pair.fixed.width * fine.pair.fixed.pixel_mm.x, fine.pair.fixed.height * fine.pair.fixed.pixel_mm.y};
  for (const int colour : {0, 1}) {
    PlanarState state = start;
    if (!refinePlanar(onColour(coarse.pair, colour, square_mm, 0.0), coarse.level, settings, state, progress)) return std::nullopt;
    state = carriedTo(state, extent_mm, fine.pair, fine.level);
    if (!refinePlanar(onColour(fine.pair, colour, square_mm, 0.0), fine.level, settings, state, progress)) return std::nullopt;
    const PlanarPair judged = onColour(fine.pair, 1 - colour, square_mm, 1.6 * fine.pair.fixed.pixel_mm.x);
    FieldSamples whole;
    evaluate(state.x, state.y, state.field.part[0], whole.x);
    evaluate(state.x, state.y, state.field.part[1], whole.y);
    for (int n = 0; n < kShares; ++n) {
      FieldSamples part = whole;
      part.scale(static_cast<float>(n) / (kShares - 1));
      const PlanarAgreement found = planarAgreement(judged, part.x, part.y);
      agreed[static_cast<std::size_t>(n)] += 0.5 * found.correlation;
      if (n == 0) independent += found.independent;
    }
  }
  const auto best = std::max_element(agreed.begin(), agreed.end());
  return Holdout{.share = static_cast<double>(best - agreed.begin()) / (kShares - 1),
                 .gain = *best - agreed[0],
                 .error = 1.0 / std::sqrt(std::max(1.0, independent))};
}

/// How likely a field's agreement is no chance: Fisher's z of its correlation in standard deviations.
double significanceOf(const PlanarPair& pair, const PlanarState& state) {
  FieldSamples field;
  evaluate(state.x, state.y, state.field.part[0], field.x);
  evaluate(state.x, state.y, state.field.part[1], field.y);
  const PlanarAgreement a = planarAgreement(pair, field.x, field.y);
  return std::atanh(std::min(0.999, a.correlation)) * std::sqrt(std::max(0.0, a.independent - 3.0));
}

// Of the speckle, above which the images share it: measured apart, 0.75 and above when it moves with the tissue, 0.4 and below when not.
constexpr double kSharedSpeckle = 0.6;
Message nothingCommon() { return say<"The two images show almost nothing in common places: check how they lie to each other.">(); }

/// One registration: what its steps share, and the result as it grows.
class PlanarRun {
 public:
  PlanarRun(ImageView<const std::uint8_t> fixed, ImageView<const std::uint8_t> moving, glm::dvec2 pixel_mm, const Elastic2dOptions& options,
            Progress& progress, const OnLevel& onLevel);
  [[nodiscard]] Result<Elastic2dResult> run();

 private:
  /// @return false where too little lies on each other
  [[nodiscard]] bool judgeBefore();
  /// Without factors the settings choose the levels, and the speckle chooses among these.
  [[nodiscard]] bool choosesLevels() const { return options_.factors.empty() && !options_.singleResolution; }
  [[nodiscard]] bool isLeftOut(std::size_t n) const;

  // A level. What can be cancelled returns false then.
  [[nodiscard]] bool refineLevel(std::size_t n);
  [[nodiscard]] const PlanarPair& pairOf(std::size_t n);
  [[nodiscard]] bool startFirst(const PlanarPair& pair, const PlanarLevel& level);
  [[nodiscard]] bool tryCommonShift(const PlanarPair& pair, const PlanarLevel& level);
  [[nodiscard]] bool followLargeMotion(const PlanarPair& pair, const PlanarLevel& level);
  void report(const PlanarPair& pair, std::chrono::steady_clock::time_point began);

  // What is made of the field that was kept.
  void takeBackFolds();
  [[nodiscard]] bool needsHeldOut() const;
  [[nodiscard]] std::optional<Holdout> askHeldOut();
  [[nodiscard]] bool isRefutedBy(const Holdout& held) const;
  void keepShareOf(const Holdout& held);
  [[nodiscard]] bool agreesAtRest() const { return result_.before.correlation > result_.before.chance; }

  // How it ends.
  [[nodiscard]] Elastic2dResult finish(Verdict verdict, StopReason stop, Message reason);
  void leaveAtZero();
  [[nodiscard]] Elastic2dResult finishSingular();
  [[nodiscard]] Elastic2dResult finishRefuted(const Holdout& held);
  [[nodiscard]] Elastic2dResult conclude();

  void show(const PlanarState& state, const PlanarImage& on, FieldSamples& field) const;
  [[nodiscard]] Agreement stated(const PlanarAgreement& found) const;
  [[nodiscard]] double smallestJacobianOfFull() const;

  const Elastic2dOptions& options_;
  Progress& progress_;
  const OnLevel& onLevel_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  QuietProgress quiet_;
  glm::dvec2 pixel_mm_;
  glm::dvec2 extent_mm_;
  std::size_t count_;  ///< of the input's pixels
  double unit_;
  PlanarImage fixed_;
  PlanarImage moving_;
  PlanarPair grey_;  ///< for the paper's correlation: shadows included
  double coverable_ = 0.0;
  PlanarSettings settings_;
  std::vector<PlanarLevel> levels_;
  PlanarPair judged_;      ///< images of one size, on which the agreement is judged before and after
  FieldSamples onJudged_;  ///< the field at their samples
  FieldSamples full_;      ///< and at the input's pixels
  PlanarState state_;
  PlanarState atStart_;                   ///< of the first level
  PlanarState kept_;                      ///< the last one that folds nowhere at full resolution
  std::vector<PairAtLevel> firstLevels_;  ///< at most two, for the judgement by halves
  PlanarPair later_;                      ///< of a level behind these
  Elastic2dResult result_;
};

PlanarRun::PlanarRun(ImageView<const std::uint8_t> fixed, ImageView<const std::uint8_t> moving, glm::dvec2 pixel_mm,
                     const Elastic2dOptions& options, Progress& progress, const OnLevel& onLevel)
    : options_(options),
      progress_(progress),
      onLevel_(onLevel),
      quiet_(progress),
      pixel_mm_(pixel_mm),
      extent_mm_(fixed.width * pixel_mm.x, fixed.height * pixel_mm.y),
      count_(static_cast<std::size_t>(fixed.width) * static_cast<std::size_t>(fixed.height)),
      unit_(unitOf(fixed, pixel_mm)),
      fixed_(planarImageOf(fixed, pixel_mm)),
      moving_(planarImageOf(moving, pixel_mm)),
      grey_{fixed_, moving_} {
  if (options.shadows) {
    doubtShadows(fixed_);
    doubtShadows(moving_);
  }
  const auto total = [](const PlanarImage& image) {
    double sum = 0.0;
    for (const float w : image.weight) sum += static_cast<double>(w);
    return sum;
  };
  coverable_ = std::min(total(fixed_), total(moving_));
  const double finestPixel_mm = std::min(pixel_mm.x, pixel_mm.y), lengths = unit_ / 0.4;
  settings_ = settingsOf(options, lengths);
  levels_ = planarLevels(options, unit_, lengths, finestPixel_mm);
  judged_ = planarPair(fixed_, moving_, std::max(1.0, 2.0 * unit_ / finestPixel_mm), settings_);
  result_.columns = fixed.width;
  result_.rows = fixed.height;
  result_.displacement_mm.assign(count_, glm::vec2(0.0F));
}

Result<Elastic2dResult> PlanarRun::run() {
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"The registration was cancelled.">()); };
  if (!judgeBefore()) return finish(Verdict::cannotTell, StopReason::noOverlap, nothingCommon());
  for (std::size_t n = 0; n < levels_.size(); ++n) {
    if (!isLeftOut(n) && !refineLevel(n)) return cancelled();
  }
  progress_.report(say<"Registering">(), 0.8);
  takeBackFolds();
  if (state_.stop == StopReason::singular || state_.stop == StopReason::noOverlap) return finishSingular();
  if (needsHeldOut()) {
    const auto held = askHeldOut();
    if (!held) return cancelled();
    if (isRefutedBy(*held)) return finishRefuted(*held);
    keepShareOf(*held);
  }
  return conclude();
}

bool PlanarRun::judgeBefore() {
  onJudged_.x.assign(judged_.fixed.value.size(), 0.0F);
  onJudged_.y = onJudged_.x;
  full_.x.assign(count_, 0.0F);
  full_.y = full_.x;
  const PlanarAgreement before = planarAgreement(judged_, onJudged_.x, onJudged_.y);
  result_.before = result_.after = stated(before);
  result_.correlationBefore = result_.correlationAfter = planarAgreement(grey_, full_.x, full_.y).correlation;
  return before.weight >= 0.02 * static_cast<double>(judged_.fixed.value.size()) && before.weight >= 9.0;
}

/// Of the last two levels one is used: the finer one where the speckle is shared.
bool PlanarRun::isLeftOut(std::size_t n) const { return choosesLevels() && n >= 2 && (n == 2) == (state_.coherence > kSharedSpeckle); }

bool PlanarRun::refineLevel(std::size_t n) {
  const auto began = std::chrono::steady_clock::now();
  progress_.report(say<"Registering">(),
                   0.8 * static_cast<double>(result_.levels.size()) / static_cast<double>(levels_.size()));  // the rest is the judgement
  if (progress_.cancelRequested()) return false;
  const PlanarLevel& level = levels_[n];
  const PlanarPair& pair = pairOf(n);
  if (n == 0) {
    if (!startFirst(pair, level)) return false;
  } else {
    state_ = carriedTo(state_, extent_mm_, pair, level);
  }
  if (!refinePlanar(pair, level, settings_, state_, quiet_)) return false;
  show(state_, grey_.fixed, full_);
  if (choosesLevels() && n == 0 && !followLargeMotion(pair, level)) return false;
  report(pair, began);
  return true;
}

const PlanarPair& PlanarRun::pairOf(std::size_t n) {
  PlanarPair pair = planarPair(fixed_, moving_, levels_[n].scale, settings_);
  if (n < 2) return firstLevels_.emplace_back(PairAtLevel{std::move(pair), levels_[n]}).pair;
  later_ = std::move(pair);
  return later_;
}

bool PlanarRun::startFirst(const PlanarPair& pair, const PlanarLevel& level) {
  layOut(extent_mm_, pair, level, glm::dvec2(0.0), state_);
  if (options_.largestMotion_mm > 0.0 && !options_.singleResolution && !tryCommonShift(pair, level)) return false;
  atStart_ = state_;
  return true;
}

/// Starts from the shift of all that correlates best, where descending from there agrees better than from rest.
bool PlanarRun::tryCommonShift(const PlanarPair& pair, const PlanarLevel& level) {
  const glm::dvec2 shift = commonShift_mm(pair, options_.largestMotion_mm);
  if (shift == glm::dvec2(0.0)) return true;
  PlanarState other;
  layOut(extent_mm_, pair, level, shift, other);
  if (!refinePlanar(pair, level, settings_, other, quiet_) || !refinePlanar(pair, level, settings_, state_, quiet_)) return false;
  if (significanceOf(pair, other) > 1.05 * significanceOf(pair, state_))
    state_ = std::move(other);
  else
    layOut(extent_mm_, pair, level, glm::dvec2(0.0), state_);
  return true;
}

/// A large motion under so stiff a warp is larger in truth: the same pixels follow it more freely before the finer ones come.
bool PlanarRun::followLargeMotion(const PlanarPair& pair, const PlanarLevel& level) {
  float farthest = 0.0F;
  for (std::size_t k = 0; k < count_; ++k) farthest = std::max(farthest, std::hypot(full_.x[k], full_.y[k]));
  if (!(static_cast<double>(farthest) > 8.0 * unit_)) return true;
  if (!refinePlanar(pair, levelOf(level.scale, level.node_mm, 4.0, false), settings_, state_, quiet_)) return false;
  show(state_, grey_.fixed, full_);
  return true;
}

void PlanarRun::report(const PlanarPair& pair, std::chrono::steady_clock::time_point began) {
  const double least = smallestJacobianOfFull();
  Level report;
  report.voxel_mm = std::sqrt(pair.fixed.pixel_mm.x * pair.fixed.pixel_mm.y);
  report.node_mm = std::sqrt(state_.x.node_mm * state_.y.node_mm);
  report.iterations = state_.iterations;
  report.correlationBefore = result_.correlationAfter;
  result_.correlationAfter = report.correlationAfter = planarAgreement(grey_, full_.x, full_.y).correlation;
  report.seconds = secondsSince(began);
  result_.levels.push_back(report);
  result_.stiffness = state_.stiffness;
  result_.speckleCorrelation = state_.coherence;
  if (least > 0.5 * settings_.leastJacobian || kept_.iterations == 0) {
    kept_ = state_;
    result_.smallestJacobian = least;
  }
  if (onLevel_) onLevel_(report);
}

/// Coarse samples may miss a cell that the input's pixels show folded: then the field is taken back until none is.
void PlanarRun::takeBackFolds() {
  show(kept_, grey_.fixed, full_);
  double share = 1.0;
  while (result_.smallestJacobian < 0.5 * settings_.leastJacobian && share > 0.05) {
    share *= 0.8;
    full_.scale(0.8F);
    result_.smallestJacobian = smallestJacobianOfFull();
  }
  show(kept_, judged_.fixed, onJudged_);
  if (share < 1.0) onJudged_.scale(static_cast<float>(share));
  result_.after = stated(planarAgreement(judged_, onJudged_.x, onJudged_.y));
}

/// Where the speckle is another one, the agreement of the fitted pixels proves little: the warp is asked to agree where it was not fitted.
bool PlanarRun::needsHeldOut() const { return choosesLevels() && firstLevels_.size() == 2 && state_.coherence < kSharedSpeckle; }

std::optional<Holdout> PlanarRun::askHeldOut() {
  PlanarSettings quick = settings_;
  quick.iterations = std::min(settings_.iterations, 8);
  return heldOut(firstLevels_[0], firstLevels_[1], atStart_, 16.0 * unit_, quick, quiet_);
}

/// Images that agree no better than by chance as they lie have to show much more.
bool PlanarRun::isRefutedBy(const Holdout& held) const {
  const double needed = agreesAtRest() ? 0.7 : 6.0;
  return held.share <= 0.0 || held.gain < needed * held.error;
}

/// Half of the evidence makes twice the noise: the best share of the motion found from all of it lies nearer to 1.
void PlanarRun::keepShareOf(const Holdout& held) {
  const double keep = 2.0 * held.share / (1.0 + held.share);
  if (!(keep < 1.0)) return;
  full_.scale(static_cast<float>(keep));
  onJudged_.scale(static_cast<float>(keep));
  result_.smallestJacobian = smallestJacobianOfFull();
  result_.correlationAfter = planarAgreement(grey_, full_.x, full_.y).correlation;
  result_.after = stated(planarAgreement(judged_, onJudged_.x, onJudged_.y));
}

Elastic2dResult PlanarRun::finish(Verdict verdict, StopReason stop, Message reason) {
  result_.verdict = verdict;
  result_.stop = stop;
  result_.reason = std::move(reason);
  result_.seconds = secondsSince(started_);
  progress_.report(say<"Registering">(), 1.0);
  return std::move(result_);
}

void PlanarRun::leaveAtZero() {
  std::fill(result_.displacement_mm.begin(), result_.displacement_mm.end(), glm::vec2(0.0F));
  result_.after = result_.before;
  result_.correlationAfter = result_.correlationBefore;
  result_.smallestJacobian = 1.0;
  result_.largestMotion_mm = 0.0;
}

Elastic2dResult PlanarRun::finishSingular() {
  leaveAtZero();
  return finish(Verdict::cannotTell, state_.stop,
                state_.stop == StopReason::singular
                    ? say<"An image is flat where the other one shows something: there is nothing to go by, and the displacement is left "
                          "at zero.">()
                    : nothingCommon());
}

Elastic2dResult PlanarRun::finishRefuted(const Holdout& held) {
  const bool common = agreesAtRest();
  const Message gain = hundredths(held.gain), error = hundredths(held.error);
  leaveAtZero();
  return finish(common ? Verdict::aligned : Verdict::cannotTell, StopReason::noImprovement,
                common ? say<"The images agree as they lie, and no warp agrees better where it was not fitted: the displacement is left at "
                             "zero (gain of correlation there %1, its error %2).">(gain, error)
                       : say<"No warp agrees better where it was not fitted: the displacement is left at zero (gain of correlation there "
                             "%1, its error %2).">(gain, error));
}

Elastic2dResult PlanarRun::conclude() {
  const Message figures = say<"(correlation %1 before, %2 after, %3 by chance)">(
      hundredths(result_.before.correlation), hundredths(result_.after.correlation), hundredths(result_.after.chance));
  if (result_.after.correlation <= result_.before.correlation || result_.after.correlation <= result_.after.chance) {
    leaveAtZero();
    const bool common = agreesAtRest();
    return finish(
        common ? Verdict::aligned : Verdict::cannotTell, StopReason::noImprovement,
        common ? say<"No warp agrees better than the images as they lie, and they agree: the displacement is left at zero %1.">(figures)
               : say<"No warp agrees better than chance does: the displacement is left at zero %1.">(figures));
  }
  for (std::size_t n = 0; n < count_; ++n) {
    const glm::vec2 u(full_.x[n], full_.y[n]);
    result_.displacement_mm[n] = u;
    result_.largestMotion_mm = std::max(result_.largestMotion_mm, std::hypot(static_cast<double>(u.x), static_cast<double>(u.y)));
  }
  return finish(Verdict::aligned, state_.stop, say<"The warped image agrees with the fixed one %1.">(figures));
}

void PlanarRun::show(const PlanarState& state, const PlanarImage& on, FieldSamples& field) const {
  const SplineAxis alongX = splineAxis(extent_mm_.x, state.x.node_mm, on.pixel_mm.x, on.width);
  const SplineAxis alongY = splineAxis(extent_mm_.y, state.y.node_mm, on.pixel_mm.y, on.height);
  evaluate(alongX, alongY, state.field.part[0], field.x);
  evaluate(alongX, alongY, state.field.part[1], field.y);
}

Agreement PlanarRun::stated(const PlanarAgreement& found) const {
  return agreementOf(found, coverable_ * static_cast<double>(judged_.fixed.value.size()) / static_cast<double>(count_));
}

double PlanarRun::smallestJacobianOfFull() const {
  return smallestJacobian(full_.x, full_.y, result_.columns, result_.rows, pixel_mm_.x, pixel_mm_.y);
}

}  // namespace

Result<Elastic2dResult> registerElastic2d(ImageView<const std::uint8_t> fixed, ImageView<const std::uint8_t> moving, glm::dvec2 pixel_mm,
                                          const Elastic2dOptions& options, Progress& progress, const OnLevel& onLevel) {
  if (auto checked = check(fixed, moving, pixel_mm, options); !checked) return passOn(checked.error());
  return PlanarRun(fixed, moving, pixel_mm, options, progress, onLevel).run();
}

}  // namespace ew::registration
