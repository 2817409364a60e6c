#include <algorithm>
#include <utility>

#include "cost_parts.h"
#include "ew/core/contract.h"
#include "ew/imaging/cost_of_accuracy.h"

namespace ew {
namespace {

/// The same scatterers, formed as finely as the settings go.
Scene finestScene(Scene scene) {
  scene.liveEchoes->samplesPerPulse = kFinestSamplesPerPulse;
  scene.liveEchoes->reach = kFinestReach;
  return scene;
}

}  // namespace

Result<CostOfAccuracy> measureCostOfEchoes(const FrameInput& subject, const Probe& probe, const Knobs& asked, const Scene& scene,
                                           const Pose& pose, int width, int height, const CostOptions& options, Progress& progress) {
  EW_EXPECTS(width >= 1 && height >= 1 && options.poses >= 1 && options.repeats >= 1);
  EW_EXPECTS(subject.tissue != nullptr && scene.liveEchoes.has_value());
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"The measurement was cancelled.">()); };
  if (auto usable = detail::checkUsable(pose); !usable) return passOn(usable.error());

  const std::vector<Pose> poses = detail::posesAround(pose, options.poses);
  const Scene quiet = detail::quietOf(limited(scene)), finest = finestScene(quiet);
  Knobs knobs = detail::neutralOf(asked);
  CostOfAccuracy result;
  result.ofEchoes = true;
  result.poses = options.poses;

  progress.report(say<"Forming the finest echoes">(), 0.0);
  std::vector<GreyImage> reference;
  CostOptions once = options;
  once.repeats = 1;
  knobs.quality = Quality::linear;
  const detail::CostBench fine{subject, probe, finest, poses, width, height, once};
  const double reference_ms =
      fine.time_ms(knobs, progress, [&](const Pose&, const ImageView<const std::uint8_t>& image, const FrameMaker& maker) {
        const GreyImage& kept = reference.emplace_back(copyOf(image));
        for (int y = 0; y < kept.height; ++y)
          for (const RowSpan& run : maker.spans()[static_cast<std::size_t>(y)])
            for (int x = run.begin; x < run.end; ++x) result.comparedPixels += image.at(x, y) > 0 ? 1 : 0;
      });
  if (reference_ms < 0.0) return cancelled();
  if (result.comparedPixels < detail::kFewestCompared) {
    return failure(ErrorCode::emptyVolume,
                   say<"The probe sees too little of the volume to compare; slide it over the volume and measure again.">());
  }

  const detail::CostBench bench{subject, probe, quiet, poses, width, height, options};
  for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic}) {
    progress.report(say<"Timing the qualities">(), 0.25 + 0.25 * static_cast<double>(result.qualities.size()));
    CostPoint point;
    point.knobs = asked;
    point.knobs.quality = knobs.quality = quality;
    detail::Difference difference;
    std::size_t n = 0;
    point.frame_ms = bench.time_ms(knobs, progress, [&](const Pose&, const ImageView<const std::uint8_t>& image, const FrameMaker& maker) {
      const GreyImage& exact = reference[n++];
      for (int y = 0; y < image.height; ++y)
        for (const RowSpan& run : maker.spans()[static_cast<std::size_t>(y)])
          for (int x = run.begin; x < run.end; ++x)
            if (const double level = viewOf(exact).at(x, y); level > 0.0) difference.add(image.at(x, y) - level);
    });
    if (point.frame_ms < 0.0) return cancelled();
    difference.putInto(point);
    result.qualities.push_back(point);
  }
  progress.report(say<"Timing the qualities">(), 1.0);
  return result;
}

}  // namespace ew
