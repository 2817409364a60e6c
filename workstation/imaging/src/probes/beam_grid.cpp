#include "ew/imaging/beam_grid.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "fan_shape.h"

namespace ew {

double BeamGrid::lineSpacing_mm(double depth_mm) const {
  EW_EXPECTS(lines.size() >= 2);
  const Line& left = lines[lines.size() / 2 - 1];
  const Line& right = lines[lines.size() / 2];
  const glm::dvec2 between_mm = right.origin_mm - left.origin_mm + depth_mm * (right.direction - left.direction);
  const glm::dvec2 along = glm::normalize(left.direction + right.direction);
  return std::abs(between_mm.x * along.y - between_mm.y * along.x);
}

BeamGrid makeBeamGrid(const Probe& probe, const Knobs& knobs, double depth_mm, double sampleSpacing_mm, double look_rad) {
  EW_EXPECTS(probe.lines >= 2 && std::isfinite(depth_mm) && depth_mm > 0.0 && sampleSpacing_mm > 0.0);
  EW_EXPECTS(depth_mm / sampleSpacing_mm * probe.lines < 4e9);  // the indices of a scan conversion have 32 bits
  const detail::FanShape fan = detail::fanShapeOf(probe, knobs, look_rad);
  BeamGrid grid;
  grid.lines.reserve(static_cast<std::size_t>(probe.lines));
  for (int n = 0; n < probe.lines; ++n) {
    // A quotient of whole numbers, so that line n and its mirror image differ in the sign alone.
    const detail::FanShape::Line line = fan.lineAt(static_cast<double>(2 * n - (probe.lines - 1)) / (probe.lines - 1));
    grid.lines.push_back({line.origin_mm, line.direction});
  }
  const int intervals = std::max(1, static_cast<int>(std::ceil(depth_mm / sampleSpacing_mm - 1e-9)));
  grid.samples = intervals + 1;
  grid.sampleSpacing_mm = depth_mm / intervals;
  return grid;
}

glm::dvec2 lineAndSampleAt(const Probe& probe, const Knobs& knobs, const BeamGrid& grid, const glm::dvec2& p_mm, double look_rad) {
  const detail::FanShape::Place place = detail::fanShapeOf(probe, knobs, look_rad).placeOf(p_mm);
  const double middle = 0.5 * static_cast<double>(grid.lines.size() - 1);
  return {middle + middle * place.across, place.depth_mm / grid.sampleSpacing_mm};
}

void rowsOf(const BeamGrid& grid, const Transform<frame::Voxel, frame::Probe>& probeToVoxel, glm::dvec2 elevation_mm,
            std::vector<SampleRow>& rows) {
  rows.resize(grid.lines.size());
  const double elevationStep_mm = (elevation_mm.y - elevation_mm.x) / (grid.samples - 1);
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const BeamGrid::Line& line = grid.lines[n];
    const glm::dvec2 step_mm = line.direction * grid.sampleSpacing_mm;
    rows[n].start_voxel = (probeToVoxel * Point<frame::Probe>{{line.origin_mm, elevation_mm.x}}).at;
    rows[n].step_voxel = (probeToVoxel * Direction<frame::Probe>{{step_mm, elevationStep_mm}}).along;
    rows[n].row = static_cast<int>(n);
    rows[n].span = {0, grid.samples};
  }
}

}  // namespace ew
