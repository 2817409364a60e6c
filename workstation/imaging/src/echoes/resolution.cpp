#include "ew/imaging/resolution.h"

#include <algorithm>
#include <cmath>

#include "echo_beams.h"
#include "ew/core/contract.h"
#include "plan/planning.h"

namespace ew {

ResolutionMap::ResolutionMap(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm)
    : probe_(probe),
      knobs_(detail::withCarrierOf(probe, limited(knobs))),
      scene_(limited(scene)),
      depth_mm_(depth_mm),
      grid_(makeBeamGrid(probe, knobs_, depth_mm, depth_mm / 8.0)) {
  EW_EXPECTS(depth_mm > 0.0);
}

Resolution ResolutionMap::at(const glm::dvec2& p_mm) const {
  const glm::dvec2 place = lineAndSampleAt(probe_, knobs_, grid_, p_mm);
  const auto last = static_cast<double>(grid_.lines.size() - 1);
  const double line = std::isfinite(place.x) ? std::clamp(place.x, 0.0, last) : 0.5 * last;
  const auto below = static_cast<std::size_t>(std::min(std::floor(line), last - 1.0));
  const glm::dvec2 direction = glm::mix(grid_.lines[below].direction, grid_.lines[below + 1].direction, line - static_cast<double>(below));
  const double along_mm = std::isfinite(place.y) ? std::clamp(grid_.depth_mm(place.y), 0.0, depth_mm_) : 0.5 * depth_mm_;
  const detail::EchoBeams beams = detail::echoBeamsOf(probe_, knobs_, scene_, depth_mm_);
  return {detail::kFwhmOfSigma * beams.axialSigma_mm, detail::kFwhmOfSigma * beams.lateralSigma_mm(along_mm),
          std::atan2(direction.x, direction.y)};
}

}  // namespace ew
