#include "ew/stitching/stitch.h"

#include "ew/stitching/join.h"

namespace ew::stitching {

Result<StitchResult> stitch(std::span<const PlacedView> inputs, const StitchOptions& options, Progress& progress) {
  auto forecast = forecastStitch(inputs, options);
  if (!forecast) return passOn(forecast.error());
  std::vector<View> views;
  for (const PlacedView& input : inputs) {
    View view;
    view.volume = input.volume;
    view.toWorld = input.toWorld;
    view.name = input.name;
    views.push_back(std::move(view));
  }
  JoinOptions how;
  how.grid = options;
  how.seam.method = SeamMethod::feather;
  auto joined = join(views, {}, forecast->grid, how, progress);
  if (!joined) return passOn(joined.error());
  JoinReport& report = joined->report;
  return StitchResult{std::move(joined->volume),
                      std::move(joined->source),
                      std::move(report.contributions),
                      report.overlapShare,
                      report.disagreementRms,
                      std::move(report.notes),
                      report.seconds};
}

Result<StitchResult> stitch(std::span<const PlacedVolume> inputs, const StitchOptions& options, Progress& progress) {
  std::vector<PlacedView> views;
  for (const auto& input : inputs) views.push_back({&input.volume, input.toWorld, input.name});
  return stitch(views, options, progress);
}

}  // namespace ew::stitching
