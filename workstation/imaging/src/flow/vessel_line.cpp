#include "flow/vessel_line.h"

#include <algorithm>
#include <cmath>

namespace ew::detail {

std::optional<VesselLine> vesselLineOf(const FlowField& field, std::size_t stream) {
  VesselLine line{.stream = stream, .alpha = 0.0, .nodes = {}};
  for (const FlowNode& node : field.streams[stream].line) {
    if (!(node.radius_mm > 0.0)) continue;
    const bool isFirst = line.nodes.empty();
    const double step_mm = isFirst ? 0.0 : glm::distance(node.place_mm, line.nodes.back().place_mm);
    if (!isFirst && !(step_mm > 1e-9)) continue;
    line.nodes.push_back({node.place_mm, glm::dvec3(0.0), node.radius_mm, isFirst ? 0.0 : line.nodes.back().at_mm + step_mm,
                          JetProfile::share(node.jet), JetProfile(node.jet, node.backflow), std::max(node.turbulence, 0.0)});
  }
  if (line.nodes.size() < 2) return std::nullopt;
  const std::size_t last = line.nodes.size() - 1;
  double radii_mm = 0.0;
  for (std::size_t n = 0; n <= last; ++n) {
    const glm::dvec3 before = n > 0 ? glm::normalize(line.nodes[n].place_mm - line.nodes[n - 1].place_mm) : glm::dvec3(0.0);
    const glm::dvec3 after = n < last ? glm::normalize(line.nodes[n + 1].place_mm - line.nodes[n].place_mm) : glm::dvec3(0.0);
    const glm::dvec3 both = before + after;
    line.nodes[n].along = glm::length(both) > 1e-6 ? glm::normalize(both) : before;  // a line that turns back on itself
    radii_mm += line.nodes[n].radius_mm;
  }
  if (field.rhythms.pulse)
    line.alpha = womersleyNumber(radii_mm / static_cast<double>(last + 1), 1.0 / field.rhythms.pulse->period_s, field.density_kgPerM3,
                                 field.viscosity_mPaS);
  return line;
}

LinePlace placeOnPiece(const VesselLine& line, std::size_t node, const glm::dvec3& p_mm) {
  const VesselLine::Node &a = line.nodes[node], &b = line.nodes[node + 1];
  const glm::dvec3 way = b.place_mm - a.place_mm;
  const double free = glm::dot(p_mm - a.place_mm, way) / glm::dot(way, way), share = std::clamp(free, 0.0, 1.0);
  const glm::dvec3 foot = a.place_mm + share * way;
  LinePlace place{node, share, glm::distance(p_mm, foot), a.radius_mm + share * (b.radius_mm - a.radius_mm), foot, false};
  place.isBeyond = (node == 0 && free < 0.0) || (node + 2 == line.nodes.size() && free > 1.0);
  return place;
}

WavePhase waveAt(const FlowField& field, const FlowStream& stream, double along_mm, double time_s) {
  WavePhase wave;
  if (field.rhythms.pulse) {
    const double late_s = stream.delay_s + (stream.pulseWave_mmPerS > 0.0 ? along_mm / stream.pulseWave_mmPerS : 0.0);
    const Cycle cycle = cycleAt(*field.rhythms.pulse, time_s - late_s);
    wave.phase = cycle.since_s / cycle.duration_s;
  }
  if (stream.breathShare != 0.0) wave.breath += stream.breathShare * bodyAt(field.rhythms, time_s).breath;
  return wave;
}

BloodVelocity bloodOf(const VesselLine& line, const LinePlace& place, const glm::dvec3& p_mm, const glm::dvec2& velocity_mmPerS,
                      double meanSpeed_mmPerS) {
  const VesselLine::Node &a = line.nodes[place.node], &b = line.nodes[place.node + 1];
  const glm::dvec3 along = glm::normalize(a.along + place.share * (b.along - a.along));
  glm::dvec3 outwards = p_mm - place.foot_mm;
  outwards -= glm::dot(outwards, along) * along;
  BloodVelocity blood;
  blood.stream = static_cast<int>(line.stream);
  blood.mean_mmPerS = velocity_mmPerS.x * along;
  if (const double length = glm::length(outwards); length > 1e-9) blood.mean_mmPerS += velocity_mmPerS.y / length * outwards;
  blood.turbulence_mmPerS = (a.turbulence + place.share * (b.turbulence - a.turbulence)) * meanSpeed_mmPerS;
  return blood;
}

}  // namespace ew::detail
