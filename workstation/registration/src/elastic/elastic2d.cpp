#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "elastic/planar_registration.h"
#include "ew/registration/elastic.h"

namespace ew::registration {
namespace {

/// The settings' lengths are for images 100 mm wide with pixels of 0.4 mm. A smaller, finer image has finer speckle and smaller motion.
double unitOf(ImageView<const std::uint8_t> fixed, glm::dvec2 pixel_mm) {
  const double extent = std::max(fixed.width * pixel_mm.x, fixed.height * pixel_mm.y);
  return std::max(std::min(pixel_mm.x, pixel_mm.y), std::min(0.4, extent / 256.0));
}

/// Stiff where pixels are large (there a pixel holds little but speckle and chance), then as the speckle says.
PlanarLevel levelOf(double scale, double node_mm, double units) {
  PlanarLevel level{scale, node_mm, 0.4, 0.6, 15.0};
  if (units > 3.0) {
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

std::string percent(double value) {
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

}  // namespace

Result<Elastic2dResult> registerElastic2d(ImageView<const std::uint8_t> fixedGrey, ImageView<const std::uint8_t> movingGrey,
                                          glm::dvec2 pixel_mm, const Elastic2dOptions& options, Progress& progress,
                                          const OnLevel& onLevel) {
  if (auto checked = check(fixedGrey, movingGrey, pixel_mm, options); !checked) return passOn(checked.error());
  const auto started = std::chrono::steady_clock::now();
  const auto secondsSince = [](auto then) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count(); };
  const auto cancelled = [] { return failure(ErrorCode::cancelled, "The registration was cancelled."); };

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
      levels.push_back(levelOf(std::max(1.0, units * unit / finestPixel), nodes * lengths, units));
  } else {
    std::vector<double> factors = options.factors;
    std::sort(factors.rbegin(), factors.rend());
    for (const double factor : factors) {
      const double scale = std::max(1.0, factor / 6.0);  // six pixels of its level from node to node, as the paper's last level has
      levels.push_back(levelOf(scale, factor * finestPixel, scale * finestPixel / unit));
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
    return result;
  };
  if (before.weight < 0.02 * static_cast<double>(judged.fixed.value.size()) || before.weight < 9.0)
    return finish(Verdict::cannotTell, StopReason::noOverlap,
                  "The two images show almost nothing in common places: check how they lie to each other.");

  PlanarState state;
  bool first = true;
  double done = 0.0;
  PlanarState kept;  // the last one that folds nowhere at full resolution
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const PlanarLevel& level = levels[n];
    if (chosen && !options.singleResolution && n >= 2) {
      const bool shared =
          state.coherence > 0.6;  // measured apart: 0.75 and above when the speckle moves with the tissue, 0.4 and below when not
      if ((n == 2) == shared) continue;
    }
    const auto began = std::chrono::steady_clock::now();
    progress.report("Registering", done);
    if (progress.cancelRequested()) return cancelled();
    const PlanarPair pair = planarPair(fixed, moving, level.scale, settings);
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
          if (!refinePlanar(pair, level, settings, other, progress) || !refinePlanar(pair, level, settings, state, progress))
            return cancelled();
          std::vector<float> x, y;
          const auto agreed = [&](const PlanarState& of) {
            evaluate(of.x, of.y, of.field.part[0], x);
            evaluate(of.x, of.y, of.field.part[1], y);
            const PlanarAgreement a = planarAgreement(pair, x, y);
            return std::atanh(std::min(0.999, a.correlation)) * std::sqrt(a.weight);
          };
          const double atRest = agreed(state);
          if (agreed(other) > 1.05 * atRest)
            state = std::move(other);
          else
            start(state, glm::dvec2(0.0));
        }
      }
      first = false;
    } else {
      PlanarState next;
      start(next, glm::dvec2(0.0));
      for (std::size_t k = 0; k < 3; ++k) next.field.part[k] = carriedOver(state.x, state.y, state.field.part[k], next.x, next.y);
      next.coherence = state.coherence;
      state = std::move(next);
    }
    if (!refinePlanar(pair, level, settings, state, progress)) return cancelled();
    shown(state, grey.fixed, fullX, fullY);
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
  progress.report("Registering", 1.0);
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
  const std::string figures = "(correlation " + percent(result.before.correlation) + " before, " + percent(result.after.correlation) +
                              " after, " + percent(result.after.chance) + " by chance)";
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
