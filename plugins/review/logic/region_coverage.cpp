#include "logic/region_coverage.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/imaging/display.h"
#include "logic/review_tracks.h"

namespace ew::review {
namespace {

constexpr std::uint8_t kThere = 1;

bool hasEcho(const Volume& volume, const glm::dvec3& voxel) {
  const glm::ivec3 at(glm::round(voxel));
  if (!volume.grid.contains(at)) return false;
  const std::size_t index = volume.grid.indexOf(at.x, at.y, at.z);
  return volume.echo[index] > 0 && volume.coverageAt(index) != Coverage::absent;
}

}  // namespace

VolumeRegions::VolumeRegions(const Volume& volume, const Grid& placed, double side_mm) : side_mm_(side_mm) {
  EW_EXPECTS(side_mm > 0.0 && placed.dims == volume.grid.dims);
  Volume regions;
  Grid& grid = regions.grid;
  const glm::dvec3 extent_mm = glm::dvec3(placed.dims) * placed.spacing_mm;
  grid.dims = glm::max(glm::ivec3(1), glm::ivec3(glm::ceil(extent_mm / side_mm - 1e-9)));
  grid.spacing_mm = glm::dvec3(side_mm);
  grid.directions = placed.directions;
  // The regions' outer faces begin where the voxels' do.
  grid.origin_mm = placed.origin_mm + placed.directions * (0.5 * glm::dvec3(side_mm) - 0.5 * placed.spacing_mm);
  regions.echo.assign(grid.voxelCount(), 0);
  const glm::dvec3 voxelsPerRegion = side_mm / placed.spacing_mm;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 middle = (glm::dvec3(i, j, k) + 0.5) * voxelsPerRegion - 0.5;
        bool any = hasEcho(volume, middle);
        for (int corner = 0; corner < 8 && !any; ++corner) {
          const glm::dvec3 way(corner & 1 ? 0.25 : -0.25, corner & 2 ? 0.25 : -0.25, corner & 4 ? 0.25 : -0.25);
          any = hasEcho(volume, middle + way * voxelsPerRegion);
        }
        if (any) regions.echo[grid.indexOf(i, j, k)] = kThere;
      }
  voxels_ = std::make_shared<const OrganVoxels>(regions, kThere);
}

float RegionCoverage::longest_s() const { return seconds.empty() ? 0.0F : *std::max_element(seconds.begin(), seconds.end()); }

Result<RegionCoverage> regionCoverageOf(const VolumeRegions& regions, const ScanLog& log, const Part& part, Progress& progress) {
  RegionCoverage seen;
  seen.frames.assign(regions.count(), 0);
  seen.seconds.assign(regions.count(), 0.0F);
  const std::vector<TrackSpan> freezes = freezesOf(log, part);
  OrganCoverage frame(regions.voxels());
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    if (n % 16 == 0) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
      progress.report(say<"Looking at what was seen">(), static_cast<double>(n) / static_cast<double>(log.frameCount()));
    }
    const double time_s = log.frameTime_s(n);
    if (time_s < part.begin_s || time_s > part.end_s) continue;
    const ScanState state = log.frame(n);
    const double next_s = std::min(part.end_s, n + 1 < log.frameCount() ? log.frameTime_s(n + 1) : log.end_s());
    double lasts_s = next_s - time_s;
    for (const TrackSpan& freeze : freezes) lasts_s -= std::max(0.0, std::min(next_s, freeze.end_s) - std::max(time_s, freeze.begin_s));
    lasts_s = std::clamp(lasts_s, 0.0, kLongestFrame_s);
    frame.clear();
    if (frame.add({state.probe, resolvedDepth_mm(state.probe, state.knobs)}, state.pose, state.gaps_mm) == 0) continue;
    for (std::size_t region = 0; region < regions.count(); ++region) {
      if (!frame.isPassed(region)) continue;
      ++seen.frames[region];
      seen.seconds[region] += static_cast<float>(lasts_s);
    }
  }
  return seen;
}

}  // namespace ew::review
