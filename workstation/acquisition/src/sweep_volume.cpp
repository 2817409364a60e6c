#include "ew/acquisition/sweep_volume.h"

#include <utility>

#include "ew/acquisition/sweep_geometry.h"

namespace ew {
namespace {

Result<void> checkFits(const ImportPlan& plan) {
  const std::uint64_t bytes = sweepVolumeBytes(plan);
  if (bytes <= plan.reconstruct.maxBytes) return {};
  return failure(
      ErrorCode::tooLarge,
      say<"The sweep would become %1 x %2 x %3 voxels and need %4 MiB, more than the %5 MiB allowed; give a coarser spacing_mm.">(
          plan.grid.dims.x, plan.grid.dims.y, plan.grid.dims.z, bytes >> 20, plan.reconstruct.maxBytes >> 20),
      {{"forecast_bytes", std::to_string(bytes)}});
}

}  // namespace

Result<SweepInput> openSweepVolume(const std::filesystem::path& sweep, const SweepVolumeOptions& options, Progress& progress) {
  SweepImportOptions import;
  if (!options.calibration.empty()) import.calibrations = {options.calibration};
  import.reconstruct.threads = options.threads;
  import.reconstruct.maxBytes = options.maxBytes;
  import.reconstruct.spacing_mm = options.spacing_mm;
  import.acceptsSmall = options.acceptsSmall;
  import.usual = {.spacing = options.spacing_mm <= 0.0, .interpolation = true, .compounding = true, .fillReach = true};
  return openSweep(sweep, import, progress);
}

std::uint64_t sweepVolumeBytes(const ImportPlan& plan) { return plan.bytes + plan.frameBytes + 2 * plan.grid.voxelCount(); }

Result<SweepVolume> makeSweepVolume(const SweepInput& opened, Progress& progress) {
  const ImportPlan& plan = opened.plan;
  const ReconstructOptions& how = plan.reconstruct;
  if (auto meant = checkMeant(opened); !meant) return passOn(meant.error());
  if (auto fits = checkFits(plan); !fits) return passOn(fits.error());
  PartOfProgress judging(progress, 0.0, 0.3), pasting(progress, 0.3, 0.65), again(progress, 0.65, 1.0);
  auto frames = posedFrames(opened);
  const auto maps = confidenceOfFrames(frames, how.clip, plan.confidence, how.threads, judging);
  if (!maps) return passOn(maps.error());
  if (how.compounding == Compounding::weighted)
    for (std::size_t n = 0; n < frames.size(); ++n) frames[n].weights = viewOf((*maps)[n]);
  auto echoes = reconstructOnto(plan.grid, frames, how, pasting);
  if (!echoes) return passOn(echoes.error());
  SweepVolume made;
  made.beams = beamsOf(frames, how.clip);
  made.notes = plan.notes;
  for (std::size_t n = 0; n < frames.size(); ++n) frames[n].pixels = viewOf((*maps)[n]);
  auto confidence = reconstructOnto(plan.grid, frames, how, again);
  if (!confidence) return passOn(confidence.error());
  made.volume = std::move(echoes->volume);
  made.confidence = std::move(confidence->volume.echo);
  return made;
}

}  // namespace ew
