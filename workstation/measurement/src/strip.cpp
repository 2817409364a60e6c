#include "ew/measurement/strip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/resolution.h"

namespace ew::measurement {
namespace {

/// The beam that the strip shows.
std::optional<BeamGrid::Line> mLineOf(const Probe& probe, const Knobs& knobs, double depth_mm) {
  constexpr double kSamples = 8.0;  // its direction is all that counts
  const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, depth_mm / kSamples);
  if (grid.lines.empty()) return std::nullopt;
  const auto last = static_cast<double>(grid.lines.size() - 1);
  return grid.lines[static_cast<std::size_t>(std::lround(0.5 * (std::clamp(knobs.mLine, -1.0, 1.0) + 1.0) * last))];
}

}  // namespace

UncertaintyAt uncertaintyInStrip(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry,
                                 const MModeStrip& strip) {
  struct Known {
    ResolutionMap map;
    std::optional<BeamGrid::Line> line;
    std::map<double, double> interval_s;  // by the moment of a column
    double column_s = 0.0, row_mm = 0.0;
  };
  auto known = std::make_shared<Known>(
      Known{ResolutionMap(probe, knobs, scene, geometry.depth_mm), mLineOf(probe, knobs, geometry.depth_mm), {}, 0.0, 0.0});
  for (int column = 0; column < strip.image().width; ++column)
    if (const auto time_s = strip.timeOf(column)) known->interval_s.emplace(*time_s, strip.beamInterval_s(*time_s));
  known->column_s = strip.columnTime_s();
  known->row_mm = StripPlane(strip, geometry.depth_mm).rowDepth_mm();
  return [known = std::shared_ptr<const Known>(std::move(known))](int, const glm::dvec2& p) {
    PointUncertainty found;
    double interval_s = 0.0;
    if (!known->interval_s.empty()) {
      auto next = known->interval_s.lower_bound(p.x - 0.5 * known->column_s);
      if (next == known->interval_s.end()) --next;
      interval_s = next->second;
    }
    // A column and what it was interpolated from: both are even, and independent of each other.
    found.pixel = {std::hypot(known->column_s, interval_s), known->row_mm};
    const glm::dvec2 place = known->line ? known->line->origin_mm + p.y * known->line->direction : glm::dvec2(0.0, p.y);
    found.axial_mm = known->map.at(place).axial_mm;
    return found;
  };
}

std::optional<glm::dvec2> StripPlane::pointAt(glm::dvec2 pixel) const {
  const ImageView<const std::uint8_t> image = strip_->image();
  if (image.width < 1 || image.height < 2) return std::nullopt;
  const double column = std::clamp(std::round(pixel.x), 0.0, image.width - 1.0), row = std::clamp(pixel.y, 0.0, image.height - 1.0);
  const auto time_s = strip_->timeOf(static_cast<int>(column));
  if (!time_s) return std::nullopt;
  return glm::dvec2(*time_s, row * rowDepth_mm());
}

std::optional<glm::dvec2> StripPlane::pixelOf(glm::dvec2 point) const {
  const auto column = strip_->columnOf(point.x);
  if (!column || strip_->image().height < 2) return std::nullopt;
  return glm::dvec2(*column, point.y / rowDepth_mm());
}

double StripPlane::mmPerS() const { return strip_->columnTime_s() > 0.0 ? rowDepth_mm() / strip_->columnTime_s() : 1.0; }

double StripPlane::rowDepth_mm() const { return depth_mm_ / std::max(1, strip_->image().height - 1); }

}  // namespace ew::measurement
