#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ew/imaging/flow_field.h"
#include "flow/flow_profile.h"
#include "flow/vessel_line.h"

namespace ew {
namespace {

using detail::JetProfile;
using detail::LinePlace;
using detail::ProfileValue;
using detail::VesselLine;
using detail::waveAt;
using detail::WavePhase;
using detail::WaveProfile;

struct VesselPlace : LinePlace {
  const VesselLine* vessel = nullptr;
};

VesselPlace nearestIn(const VesselLine& vessel, const glm::dvec3& p_mm) {
  VesselPlace nearest;
  nearest.vessel = &vessel;
  double least = 1e300;
  for (std::size_t n = 0; n + 1 < vessel.nodes.size(); ++n) {
    const LinePlace place = detail::placeOnPiece(vessel, n, p_mm);
    if (place.away_mm >= least) continue;
    least = place.away_mm;
    nearest = {place, &vessel};
  }
  return nearest;
}

double alongLine_mm(const VesselPlace& place) {
  const VesselLine::Node &a = place.vessel->nodes[place.node], &b = place.vessel->nodes[place.node + 1];
  return a.at_mm + place.share * (b.at_mm - a.at_mm);
}

/// Velocity of a section between two nodes, along it and across it, for each 1 of flow over area.
struct SectionProfile {
  const VesselPlace& place;
  const WaveProfile& undisturbed;

  [[nodiscard]] ProfileValue atNode(const VesselLine::Node& node, const ProfileValue& plain, double y) const {
    if (node.jetShare <= 0.0) return plain;
    const ProfileValue jet = node.jet.at(y);
    const double flow = undisturbed.flow();
    return {plain.velocity + node.jetShare * (flow * jet.velocity - plain.velocity),
            plain.within + node.jetShare * (flow * jet.within - plain.within)};
  }
  /// @return x: along the line, y: away from it
  [[nodiscard]] glm::dvec2 at(double y) const {
    const VesselLine::Node &a = place.vessel->nodes[place.node], &b = place.vessel->nodes[place.node + 1];
    const ProfileValue plain = undisturbed.at(y), here = atNode(a, plain, y), next = atNode(b, plain, y);
    const double length_mm = b.at_mm - a.at_mm, widens = (b.radius_mm - a.radius_mm) / length_mm;
    const double along = here.velocity + place.share * (next.velocity - here.velocity);
    const double drift = y > 1e-9 ? place.radius_mm / (2.0 * y) * (next.within - here.within) / length_mm : 0.0;
    return {along, along * y * widens - drift};
  }
};

double areaOf_mm2(double radius_mm) { return std::numbers::pi * radius_mm * radius_mm; }

}  // namespace

double flowAtPhase(const FlowWave& wave, double phase) {
  double flow = wave.mean;
  for (std::size_t n = 0; n < wave.harmonics.size(); ++n)
    flow += (wave.harmonics[n] * std::polar(1.0, 2.0 * std::numbers::pi * phase * static_cast<double>(n + 1))).real();
  return flow;
}

FlowWave waveThrough(const std::vector<double>& samples, int harmonics) {
  FlowWave wave{.mean = 0.0};
  if (samples.empty()) return wave;
  const auto count = static_cast<double>(samples.size());
  for (const double sample : samples) wave.mean += sample / count;
  const int known = std::min(harmonics, (static_cast<int>(samples.size()) - 1) / 2);
  for (int n = 1; n <= known; ++n) {
    std::complex<double> sum(0.0);
    for (std::size_t k = 0; k < samples.size(); ++k)
      sum += samples[k] * std::polar(2.0 / count, -2.0 * std::numbers::pi * n * static_cast<double>(k) / count);
    wave.harmonics.push_back(sum);
  }
  return wave;
}

double axisOverMean(double jet, double backflow) {
  const double share = JetProfile::share(jet);
  return (1.0 - share) * 2.0 + share * JetProfile(jet, backflow).at(0.0).velocity;
}

struct FlowTruth::Parts {
  FlowField field;
  std::vector<VesselLine> vessels;

  explicit Parts(FlowField described) : field(std::move(described)) {
    for (std::size_t n = 0; n < field.streams.size(); ++n)
      if (auto vessel = detail::vesselLineOf(field, n)) vessels.push_back(std::move(*vessel));
  }
  [[nodiscard]] const VesselLine* vesselOfStream(int stream) const {
    const auto found =
        std::find_if(vessels.begin(), vessels.end(), [&](const VesselLine& vessel) { return std::cmp_equal(vessel.stream, stream); });
    return found == vessels.end() ? nullptr : &*found;
  }
};

FlowTruth::FlowTruth(FlowField field) : parts_(std::make_unique<const Parts>(std::move(field))) {}
FlowTruth::~FlowTruth() = default;
FlowTruth::FlowTruth(FlowTruth&&) noexcept = default;
FlowTruth& FlowTruth::operator=(FlowTruth&&) noexcept = default;

const FlowField& FlowTruth::field() const { return parts_->field; }

BloodVelocity FlowTruth::at(const glm::dvec3& p_mm, double time_s) const {
  VesselPlace place;
  for (const VesselLine& vessel : parts_->vessels) {
    const VesselPlace nearest = nearestIn(vessel, p_mm);
    if (nearest.isBeyond || !(nearest.depth() < 1.0)) continue;
    if (!place.vessel || nearest.depth() < place.depth()) place = nearest;
  }
  if (!place.vessel) return {};
  const FlowStream& stream = parts_->field.streams[place.vessel->stream];
  const WavePhase wave = waveAt(parts_->field, stream, alongLine_mm(place), time_s);
  const WaveProfile undisturbed(stream, place.vessel->alpha, wave.phase);
  const double mean_mmPerS = wave.breath * stream.flow_mm3PerS / areaOf_mm2(place.radius_mm);
  const glm::dvec2 velocity = mean_mmPerS * SectionProfile{place, undisturbed}.at(place.depth());
  return detail::bloodOf(*place.vessel, place, p_mm, velocity, std::abs(mean_mmPerS * undisturbed.flow()));
}

std::optional<FlowSection> FlowTruth::sectionNear(int stream, const glm::dvec3& p_mm, double time_s) const {
  const VesselLine* vessel = parts_->vesselOfStream(stream);
  if (!vessel) return std::nullopt;
  const VesselPlace place = nearestIn(*vessel, p_mm);
  const FlowStream& described = parts_->field.streams[vessel->stream];
  const WavePhase wave = waveAt(parts_->field, described, alongLine_mm(place), time_s);
  const WaveProfile undisturbed(described, vessel->alpha, wave.phase);
  const VesselLine::Node &a = vessel->nodes[place.node], &b = vessel->nodes[place.node + 1];
  FlowSection section;
  section.middle_mm = place.foot_mm;
  section.along = glm::normalize(a.along + place.share * (b.along - a.along));
  section.radius_mm = place.radius_mm;
  const double unit_mmPerS = wave.breath * described.flow_mm3PerS / areaOf_mm2(place.radius_mm);
  section.flow_mm3PerS = wave.breath * described.flow_mm3PerS * undisturbed.flow();
  section.mean_mmPerS = unit_mmPerS * undisturbed.flow();
  constexpr int kSteps = 256;
  for (int n = 0; n < kSteps; ++n) {
    const double velocity = unit_mmPerS * SectionProfile{place, undisturbed}.at(static_cast<double>(n) / kSteps).x;
    section.forward_mmPerS = std::max(section.forward_mmPerS, velocity);
    section.backward_mmPerS = std::min(section.backward_mmPerS, velocity);
  }
  return section;
}

double FlowTruth::flowThrough_mm3PerS(int stream, double along_mm, double time_s) const {
  const VesselLine* vessel = parts_->vesselOfStream(stream);
  if (!vessel) return 0.0;
  const FlowStream& described = parts_->field.streams[vessel->stream];
  const WavePhase wave = waveAt(parts_->field, described, std::clamp(along_mm, 0.0, vessel->nodes.back().at_mm), time_s);
  return wave.breath * described.flow_mm3PerS * flowAtPhase(described.wave, wave.phase);
}

}  // namespace ew
