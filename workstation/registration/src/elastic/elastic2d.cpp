#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "elastic/planar_registration.h"
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
  for (const auto& [image, name] : {std::pair{fixed, "fixed"}, std::pair{moving, "moving"}}) {
    if (image.data == nullptr || image.width < 1 || image.height < 1)
      return failure(ErrorCode::emptyVolume, std::string("The ") + name + " image has no pixels.");
    if (image.stride < image.width)
      return failure(ErrorCode::badField, std::string("The ") + name + " image's rows overlap.", {{"field", "stride"}});
  }
  if (!(pixel_mm.x > 0.0) || !(pixel_mm.y > 0.0) || !std::isfinite(pixel_mm.x) || !std::isfinite(pixel_mm.y))
    return failure(ErrorCode::badField, "The distance of pixels must be above 0 mm in x and in y.", {{"field", "pixel_mm"}});
  for (const double factor : options.factors) {
    if (!(factor >= 2.0) || !std::isfinite(factor))
      return failure(ErrorCode::badField, "A factor is the distance of nodes in pixels and must be at least 2.", {{"field", "factors"}});
  }
  if (!(options.stiffness >= 0.0) || !std::isfinite(options.stiffness))
    return failure(ErrorCode::badField, "The stiffness must be 0 (automatic) or above.", {{"field", "stiffness"}});
  if (!(options.largestMotion_mm >= 0.0) || !std::isfinite(options.largestMotion_mm))
    return failure(ErrorCode::badField, "The largest motion must be 0 mm (no search) or above.", {{"field", "largestMotion_mm"}});
  if (options.iterations < 1) return failure(ErrorCode::badField, "At least one iteration is needed.", {{"field", "iterations"}});
  return {};
}

std::string wholePercent(double value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

Agreement agreementOf(const PlanarAgreement& found, double coverable) {
  Agreement out;
  out.correlation = found.correlation;
  out.overlapShare = coverable > 0.0 ? std::min(1.0, found.weight / coverable) : 0.0;
  out.chance = found.independent > 4.0 ? std::tanh(1.645 / std::sqrt(found.independent - 3.0)) : 1.0;
  return out;
}

/// What a warp found on one half of the plane is worth on the other half.
struct HeldOut {
  double share = 1.0;  ///< of the motion that agrees best where it was not fitted; 0: none agrees better than nothing does
  double gain = 0.0;   ///< of correlation there, at that share
  double error = 1.0;  ///< standard error of a correlation there
};

/// Fits the warp twice, each time on every other square of a checkerboard, and judges each on the other squares. A warp that only fits
/// grain to grain gains nothing there.
/// @return nothing when cancelled
std::optional<HeldOut> heldOut(const PlanarPair& coarse, const PlanarLevel& coarseLevel, const PlanarPair& fine,
                               const PlanarLevel& fineLevel, const PlanarState& start, double square_mm, const PlanarSettings& settings,
                               Progress& progress) {
  constexpr int kShares = 5;  // 0, 1/4 .. 1
  std::array<double, kShares> agreed{};
  HeldOut out;
  double independent = 0.0;
  const auto half = [&](const PlanarPair& pair, int which, double guard_mm) {
    PlanarPair part = pair;
    for (int y = 0; y < part.fixed.height; ++y) {
      for (int x = 0; x < part.fixed.width; ++x) {
        const int a = static_cast<int>((x + 0.5) * part.fixed.pixel_mm.x / square_mm),
                  b = static_cast<int>((y + 0.5) * part.fixed.pixel_mm.y / square_mm);
        // Smoothed grain reaches over a border: what is judged keeps away from it.
        const double inX = (x + 0.5) * part.fixed.pixel_mm.x - a * square_mm, inY = (y + 0.5) * part.fixed.pixel_mm.y - b * square_mm;
        const bool atBorder = std::min({inX, inY, square_mm - inX, square_mm - inY}) < guard_mm;
        if ((a + b) % 2 != which || atBorder)
          part.fixed.weight[static_cast<std::size_t>(y) * static_cast<std::size_t>(part.fixed.width) + static_cast<std::size_t>(x)] = 0.0F;
      }
    }
    return part;
  };
  const glm::dvec2 extent_mm{fine.fixed.width * fine.fixed.pixel_mm.x, fine.fixed.height * fine.fixed.pixel_mm.y};
  for (const int which : {0, 1}) {
    PlanarState state = start;
    if (!refinePlanar(half(coarse, which, 0.0), coarseLevel, settings, state, progress)) return std::nullopt;
    PlanarState next;
    next.x = splineAxis(extent_mm.x, fineLevel.node_mm, fine.fixed.pixel_mm.x, fine.fixed.width);
    next.y = splineAxis(extent_mm.y, fineLevel.node_mm, fine.fixed.pixel_mm.y, fine.fixed.height);
    for (std::size_t k = 0; k < 3; ++k) next.field.part[k] = carriedOver(state.x, state.y, state.field.part[k], next.x, next.y);
    next.coherence = state.coherence;
    if (!refinePlanar(half(fine, which, 0.0), fineLevel, settings, next, progress)) return std::nullopt;
    const PlanarPair judged = half(fine, 1 - which, 1.6 * fine.fixed.pixel_mm.x);
    std::vector<float> ux, uy, x, y;
    evaluate(next.x, next.y, next.field.part[0], ux);
    evaluate(next.x, next.y, next.field.part[1], uy);
    x = ux;
    y = uy;
    for (int n = 0; n < kShares; ++n) {
      const float share = static_cast<float>(n) / (kShares - 1);
      for (std::size_t k = 0; k < ux.size(); ++k) {
        x[k] = share * ux[k];
        y[k] = share * uy[k];
      }
      const PlanarAgreement found = planarAgreement(judged, x, y);
      agreed[static_cast<std::size_t>(n)] += 0.5 * found.correlation;
      if (n == 0) independent += found.independent;
    }
  }
  const auto best = std::max_element(agreed.begin(), agreed.end());
  out.share = static_cast<double>(best - agreed.begin()) / (kShares - 1);
  out.gain = *best - agreed[0];
  out.error = 1.0 / std::sqrt(std::max(1.0, independent));
  return out;
}

}  // namespace

Result<Elastic2dResult> registerElastic2d(ImageView<const std::uint8_t> fixedGrey, ImageView<const std::uint8_t> movingGrey,
                                          glm::dvec2 pixel_mm, const Elastic2dOptions& options, Progress& progress,
                                          const OnLevel& onLevel) {
  if (auto checked = check(fixedGrey, movingGrey, pixel_mm, options); !checked) return passOn(checked.error());
  const auto started = std::chrono::steady_clock::now();
  const auto secondsSince = [](auto then) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count(); };
  const auto cancelled = [] { return failure(ErrorCode::cancelled, "The registration was cancelled."); };

  QuietProgress quiet(progress);
  Elastic2dResult result;
  result.columns = fixedGrey.width;
  result.rows = fixedGrey.height;
  const std::size_t count = static_cast<std::size_t>(fixedGrey.width) * static_cast<std::size_t>(fixedGrey.height);
  result.displacement_mm.assign(count, glm::vec2(0.0F));

  PlanarImage fixed = planarImageOf(fixedGrey, pixel_mm), moving = planarImageOf(movingGrey, pixel_mm);
  const PlanarPair grey{fixed, moving};  // for the paper's correlation: shadows included
  if (options.shadows) {
    doubtShadows(fixed);
    doubtShadows(moving);
  }
  const auto total = [](const PlanarImage& image) {
    double sum = 0.0;
    for (const float w : image.weight) sum += static_cast<double>(w);
    return sum;
  };
  const double coverable = std::min(total(fixed), total(moving));

  const double unit = unitOf(fixedGrey, pixel_mm), finestPixel = std::min(pixel_mm.x, pixel_mm.y);
  PlanarSettings settings;
  const double lengths = unit / 0.4;
  settings.window_mm *= lengths;
  settings.slope_mm *= lengths;
  settings.bending_mm *= lengths;
  settings.brightness_mm *= lengths;
  settings.brightnessTerm = options.intensityTerm;
  settings.stiffness = options.stiffness;
  settings.iterations = options.iterations;
  settings.threads = options.threads;

  const glm::dvec2 extent_mm{fixedGrey.width * pixel_mm.x, fixedGrey.height * pixel_mm.y};
  std::vector<PlanarLevel> levels;
  const bool chosen = options.factors.empty();
  if (chosen) {
    // Which of the two last levels is used depends on the speckle, once the second has measured it.
    for (const auto& [units, nodes] : {std::pair{4.0, 16.0}, std::pair{2.0, 12.0}, std::pair{1.5, 12.0}, std::pair{1.0, 10.0}})
      levels.push_back(levelOf(std::max(1.0, units * unit / finestPixel), nodes * lengths, units, levels.empty()));
  } else {
    std::vector<double> factors = options.factors;
    std::sort(factors.rbegin(), factors.rend());
    for (const double factor : factors) {
      const double scale = std::max(1.0, factor / 6.0);  // six pixels of its level from node to node, as the paper's last level has
      levels.push_back(levelOf(scale, factor * finestPixel, scale * finestPixel / unit, levels.empty()));
    }
  }
  if (options.singleResolution) levels.erase(levels.begin(), levels.end() - 1);

  // The agreement is judged on images of one size before and after.
  const PlanarPair judged = planarPair(fixed, moving, std::max(1.0, 2.0 * unit / finestPixel), settings);
  std::vector<float> ux(judged.fixed.value.size(), 0.0F), uy = ux;
  const PlanarAgreement before = planarAgreement(judged, ux, uy);
  result.before = result.after =
      agreementOf(before, coverable * static_cast<double>(judged.fixed.value.size()) / static_cast<double>(count));
  std::vector<float> fullX(count, 0.0F), fullY(count, 0.0F);
  result.correlationBefore = result.correlationAfter = planarAgreement(grey, fullX, fullY).correlation;
  const auto shown = [&](const PlanarState& state, const PlanarImage& on, std::vector<float>& x, std::vector<float>& y) {
    const SplineAxis alongX = splineAxis(extent_mm.x, state.x.node_mm, on.pixel_mm.x, on.width);
    const SplineAxis alongY = splineAxis(extent_mm.y, state.y.node_mm, on.pixel_mm.y, on.height);
    evaluate(alongX, alongY, state.field.part[0], x);
    evaluate(alongX, alongY, state.field.part[1], y);
  };
  const auto finish = [&](Verdict verdict, StopReason stop, std::string reason) {
    result.verdict = verdict;
    result.stop = stop;
    result.reason = std::move(reason);
    result.seconds = secondsSince(started);
    progress.report("Registering", 1.0);
    return result;
  };
  if (before.weight < 0.02 * static_cast<double>(judged.fixed.value.size()) || before.weight < 9.0)
    return finish(Verdict::cannotTell, StopReason::noOverlap,
                  "The two images show almost nothing in common places: check how they lie to each other.");

  PlanarState state;
  bool first = true;
  double done = 0.0;
  struct Kept {
    PlanarPair pair;
    PlanarLevel level;
  };
  std::vector<Kept> firstLevels;  // for the judgement by halves
  PlanarState startState;
  PlanarState kept;  // the last one that folds nowhere at full resolution
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const PlanarLevel& level = levels[n];
    if (chosen && !options.singleResolution && n >= 2) {
      const bool shared =
          state.coherence > 0.6;  // measured apart: 0.75 and above when the speckle moves with the tissue, 0.4 and below when not
      if ((n == 2) == shared) continue;
    }
    const auto began = std::chrono::steady_clock::now();
    progress.report("Registering", 0.8 * done);  // the rest is the judgement
    if (progress.cancelRequested()) return cancelled();
    if (firstLevels.size() < 2) firstLevels.push_back({planarPair(fixed, moving, level.scale, settings), level});
    const PlanarPair later = firstLevels.size() < 2 || n >= 2 ? planarPair(fixed, moving, level.scale, settings) : PlanarPair{};
    const PlanarPair& pair = n < firstLevels.size() ? firstLevels[n].pair : later;
    const auto start = [&](PlanarState& fresh, glm::dvec2 shift_mm) {
      fresh.x = splineAxis(extent_mm.x, level.node_mm, pair.fixed.pixel_mm.x, pair.fixed.width);
      fresh.y = splineAxis(extent_mm.y, level.node_mm, pair.fixed.pixel_mm.y, pair.fixed.height);
      const std::size_t nodes = static_cast<std::size_t>(fresh.x.nodes()) * static_cast<std::size_t>(fresh.y.nodes());
      fresh.field.part[0].assign(nodes, static_cast<float>(shift_mm.x));
      fresh.field.part[1].assign(nodes, static_cast<float>(shift_mm.y));
      fresh.field.part[2].assign(nodes, 0.0F);
    };
    if (first) {
      start(state, glm::dvec2(0.0));
      if (options.largestMotion_mm > 0.0 && !options.singleResolution) {
        const glm::dvec2 shift = commonShift_mm(pair, options.largestMotion_mm);
        if (shift != glm::dvec2(0.0)) {
          PlanarState other;
          start(other, shift);
          if (!refinePlanar(pair, level, settings, other, quiet) || !refinePlanar(pair, level, settings, state, quiet)) return cancelled();
          std::vector<float> x, y;
          const auto agreed = [&](const PlanarState& of) {
            evaluate(of.x, of.y, of.field.part[0], x);
            evaluate(of.x, of.y, of.field.part[1], y);
            const PlanarAgreement a = planarAgreement(pair, x, y);
            return std::atanh(std::min(0.999, a.correlation)) * std::sqrt(std::max(0.0, a.independent - 3.0));
          };
          const double atRest = agreed(state);
          if (agreed(other) > 1.05 * atRest)
            state = std::move(other);
          else
            start(state, glm::dvec2(0.0));
        }
      }
      first = false;
      startState = state;
    } else {
      PlanarState next;
      start(next, glm::dvec2(0.0));
      for (std::size_t k = 0; k < 3; ++k) next.field.part[k] = carriedOver(state.x, state.y, state.field.part[k], next.x, next.y);
      next.coherence = state.coherence;
      state = std::move(next);
    }
    if (!refinePlanar(pair, level, settings, state, quiet)) return cancelled();
    shown(state, grey.fixed, fullX, fullY);
    if (chosen && n == 0 && !options.singleResolution) {
      float farthest = 0.0F;
      for (std::size_t k = 0; k < count; ++k) farthest = std::max(farthest, std::hypot(fullX[k], fullY[k]));
      // A motion this large under so stiff a warp is larger in truth: the same pixels follow it more freely before the finer ones come.
      if (static_cast<double>(farthest) > 8.0 * unit) {
        PlanarLevel freer = levelOf(level.scale, level.node_mm, 4.0, false);
        if (!refinePlanar(pair, freer, settings, state, quiet)) return cancelled();
        shown(state, grey.fixed, fullX, fullY);
      }
    }
    const double least = smallestJacobian(fullX, fullY, result.columns, result.rows, pixel_mm.x, pixel_mm.y);
    Level report;
    report.voxel_mm = std::sqrt(pair.fixed.pixel_mm.x * pair.fixed.pixel_mm.y);
    report.node_mm = std::sqrt(state.x.node_mm * state.y.node_mm);
    report.iterations = state.iterations;
    report.correlationBefore = result.correlationAfter;
    result.correlationAfter = report.correlationAfter = planarAgreement(grey, fullX, fullY).correlation;
    report.seconds = secondsSince(began);
    result.levels.push_back(report);
    result.stiffness = state.stiffness;
    result.speckleCorrelation = state.coherence;
    if (least > 0.5 * settings.leastJacobian || kept.iterations == 0) {
      kept = state;
      result.smallestJacobian = least;
    }
    if (onLevel) onLevel(report);
    done = static_cast<double>(n + 1) / static_cast<double>(levels.size());
  }
  progress.report("Registering", 0.8);
  shown(kept, grey.fixed, fullX, fullY);
  // Coarse samples may miss a cell that the input's pixels show folded: then the field is taken back until none is.
  double share = 1.0;
  while (result.smallestJacobian < 0.5 * settings.leastJacobian && share > 0.05) {
    share *= 0.8;
    for (std::size_t n = 0; n < count; ++n) {
      fullX[n] *= 0.8F;
      fullY[n] *= 0.8F;
    }
    result.smallestJacobian = smallestJacobian(fullX, fullY, result.columns, result.rows, pixel_mm.x, pixel_mm.y);
  }
  shown(kept, judged.fixed, ux, uy);
  if (share < 1.0) {
    for (float& u : ux) u *= static_cast<float>(share);
    for (float& u : uy) u *= static_cast<float>(share);
  }
  const PlanarAgreement after = planarAgreement(judged, ux, uy);
  result.after = agreementOf(after, coverable * static_cast<double>(judged.fixed.value.size()) / static_cast<double>(count));
  const auto nothing = [&] {
    std::fill(result.displacement_mm.begin(), result.displacement_mm.end(), glm::vec2(0.0F));
    result.after = result.before;
    result.correlationAfter = result.correlationBefore;
    result.smallestJacobian = 1.0;
    result.largestMotion_mm = 0.0;
  };
  if (state.stop == StopReason::singular || state.stop == StopReason::noOverlap) {
    nothing();
    return finish(
        Verdict::cannotTell, state.stop,
        state.stop == StopReason::singular
            ? "An image is flat where the other one shows something: there is nothing to go by, and the displacement is left at zero."
            : "The two images show almost nothing in common places: check how they lie to each other.");
  }
  // Where the speckle is another one, the agreement of the fitted pixels proves little: the warp is asked to agree where it was not fitted.
  if (chosen && !options.singleResolution && firstLevels.size() == 2 && state.coherence < 0.6) {
    PlanarSettings quick = settings;
    quick.iterations = std::min(settings.iterations, 8);
    const auto held = heldOut(firstLevels[0].pair, firstLevels[0].level, firstLevels[1].pair, firstLevels[1].level, startState, 16.0 * unit,
                              quick, quiet);
    if (!held) return cancelled();
    // Images that agree no better than by chance as they lie have to show much more.
    const double needed = result.before.correlation > result.before.chance ? 0.7 : 6.0;
    if (held->share <= 0.0 || held->gain < needed * held->error) {
      const bool common = result.before.correlation > result.before.chance;
      nothing();
      return finish(common ? Verdict::aligned : Verdict::cannotTell, StopReason::noImprovement,
                    std::string(common ? "The images agree as they lie, and no warp" : "No warp") +
                        " agrees better where it was not fitted: the displacement is left at zero (gain of correlation there " +
                        wholePercent(held->gain) + ", its error " + wholePercent(held->error) + ").");
    }
    // Half of the evidence makes twice the noise: the best share of the motion found from all of it lies nearer to 1.
    const double keep = 2.0 * held->share / (1.0 + held->share);
    if (keep < 1.0) {
      for (float& u : fullX) u *= static_cast<float>(keep);
      for (float& u : fullY) u *= static_cast<float>(keep);
      for (float& u : ux) u *= static_cast<float>(keep);
      for (float& u : uy) u *= static_cast<float>(keep);
      result.smallestJacobian = smallestJacobian(fullX, fullY, result.columns, result.rows, pixel_mm.x, pixel_mm.y);
      result.correlationAfter = planarAgreement(grey, fullX, fullY).correlation;
      result.after = agreementOf(planarAgreement(judged, ux, uy),
                                 coverable * static_cast<double>(judged.fixed.value.size()) / static_cast<double>(count));
    }
  }
  const std::string figures = "(correlation " + wholePercent(result.before.correlation) + " before, " +
                              wholePercent(result.after.correlation) + " after, " + wholePercent(result.after.chance) + " by chance)";
  if (result.after.correlation <= result.before.correlation || result.after.correlation <= result.after.chance) {
    nothing();
    const bool common = result.before.correlation > result.before.chance;
    return finish(common ? Verdict::aligned : Verdict::cannotTell, StopReason::noImprovement,
                  (common ? "No warp agrees better than the images as they lie, and they agree: the displacement is left at zero "
                          : "No warp agrees better than chance does: the displacement is left at zero ") +
                      figures + ".");
  }
  for (std::size_t n = 0; n < count; ++n) {
    result.displacement_mm[n] = {fullX[n], fullY[n]};
    result.largestMotion_mm = std::max(result.largestMotion_mm, std::hypot(static_cast<double>(fullX[n]), static_cast<double>(fullY[n])));
  }
  return finish(Verdict::aligned, state.stop, "The warped image agrees with the fixed one " + figures + ".");
}

}  // namespace ew::registration
