#include "ew/imaging/flow_trial.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

#include "echoes/echo_beams.h"
#include "ew/core/contract.h"
#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/display.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/frame.h"
#include "flow/echo_powers.h"

namespace ew {
namespace {

using std::numbers::pi;
using Clock = std::chrono::steady_clock;
double since_us(Clock::time_point start) { return std::chrono::duration<double, std::micro>(Clock::now() - start).count(); }

constexpr int kSize_px = 160;
constexpr double kEdge = 3.0;  // standard deviations of the cell that hold scatterers

/// The gate nearest to the vessel's axis below the middle of the face: its place among the sums.
std::size_t gateOf(const BeamGrid& grid, double depth_mm) {
  std::size_t nearest = 0;
  double best = 1e300;
  for (std::size_t line = 0; line < grid.lines.size(); ++line)
    for (int gate = 0; gate < grid.samples; ++gate) {
      const glm::dvec2 at = grid.lines[line].origin_mm + grid.depth_mm(gate) * grid.lines[line].direction;
      const double away = glm::distance(at, glm::dvec2(0.0, depth_mm));
      if (away >= best) continue;
      best = away;
      nearest = static_cast<std::size_t>(gate) * grid.lines.size() + line;
    }
  return nearest;
}

}  // namespace

glm::dvec3 TrialVessel::along() const { return {std::sin(angle_rad), -std::cos(angle_rad), 0.0}; }
double TrialVessel::fromAxis_mm(const glm::dvec3& p_mm) const {
  const glm::dvec3 off = p_mm - glm::dvec3(0.0, depth_mm, 0.0);
  return glm::length(off - glm::dot(off, along()) * along());
}
double TrialVessel::towards_mmPerS() const { return axis_mmPerS * std::cos(angle_rad); }

FlowField fieldOf(const TrialVessel& vessel) {
  constexpr double kReach_mm = 80.0;
  FlowField field;
  FlowStream stream;
  stream.name = "vessel";
  for (const double at_mm : {-kReach_mm, 0.0, kReach_mm})
    stream.line.push_back({glm::dvec3(0.0, vessel.depth_mm, 0.0) + at_mm * vessel.along(), vessel.radius_mm});
  const double meanOverAxis = vessel.bluntness / (vessel.bluntness + 2.0);
  stream.flow_mm3PerS = vessel.axis_mmPerS * meanOverAxis * pi * vessel.radius_mm * vessel.radius_mm;
  stream.bluntness = vessel.bluntness;
  field.streams.push_back(std::move(stream));
  return field;
}

TissueMaps mapsOf(const TrialVessel& vessel) {
  TissueMaps maps;
  maps.grid.dims = {100, 100, 24};
  maps.grid.spacing_mm = glm::dvec3(0.5);
  maps.grid.origin_mm = {-25.0, -2.0, -6.0};
  maps.level.resize(maps.grid.voxelCount());
  for (int k = 0; k < maps.grid.dims.z; ++k)
    for (int j = 0; j < maps.grid.dims.y; ++j)
      for (int i = 0; i < maps.grid.dims.x; ++i) {
        const glm::dvec3 mm = maps.grid.origin_mm + maps.grid.spacing_mm * glm::dvec3(i, j, k);
        const bool isBlood = vessel.fromAxis_mm(mm) < vessel.radius_mm;
        maps.level[maps.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(isBlood ? 0.0 : vessel.tissueLevel);
      }
  return maps;
}

Probe trialProbe() {
  Probe probe;
  probe.id = "linear";
  probe.carrier_hz = 7.5e6;
  probe.maxSteering_rad = 0.4;
  probe.elevationalThickness_mm = 1.2;
  probe.elevationalFocus_mm = 20.0;
  probe.elevationalAperture_mm = 4.0;
  probe.defaultDepth_mm = 40.0;
  return probe;
}

Knobs trialKnobs(const TrialVessel& vessel) {
  Knobs knobs;
  knobs.colour = ColourDoppler{.boxWidth = 0.1,
                               .boxMiddle_mm = vessel.depth_mm,
                               .boxHeight_mm = 5.0,
                               .carrier_hz = 5e6,
                               .prf_hz = 4000.0,
                               .wallFilter = WallFilterSetting::low,
                               .persistence = 0.0,
                               .everyLine = 1,
                               .smoothing = 0};
  return knobs;
}

Scene trialScene(double signalToNoise_db) {
  Scene scene;
  scene.noise = NoiseEffect{
      .atFace_db = detail::kBloodAt5MHz_db + detail::kNarrowBand_db - signalToNoise_db, .growth_dbPerCmMhz = 0.0, .largest_db = 0.0};
  return scene;
}

void TrialSums::add(const PacketSums& sums) {
  const double off = meanVelocity({sums.r0, sums.r1 * std::polar(1.0, -pi * about_)});
  sum_ += off;
  squares_ += off * off;
  power_ += sums.r0;
  ++count_;
}

TrialEstimates TrialSums::result() const {
  EW_EXPECTS(count_ > 0);
  const double mean = sum_ / count_;
  return {about_ + mean, std::sqrt(std::max(0.0, squares_ / count_ - mean * mean)), power_ / count_, 0.0};
}

TrialEstimates estimatesOfColour(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene, int frames) {
  const TissueMaps maps = mapsOf(vessel);
  const FlowSampler sampler(fieldOf(vessel));
  const Probe probe = trialProbe();
  FrameMaker maker(1);
  maker.configure(probe, knobs, scene, maps.grid, kSize_px, kSize_px, {.tissue = true, .flow = true});
  FrameInput input;
  input.echo = VolumeView<const std::uint8_t>{maps.level.data(), maps.grid};
  input.tissue = &maps;
  input.tissueGrid = maps.grid;
  input.flow = &sampler;
  TrialSums sums(vessel.towards_mmPerS() / colourBoxOf(probe, knobs).nyquist_mmPerS);
  const std::size_t gate = gateOf(maker.colourGrid(), vessel.depth_mm);
  double took_us = 0.0;
  for (int n = 0; n < frames; ++n) {
    ++input.number;
    input.time_s += 0.05;
    maker.make(input);
    for (const StepTime& step : maker.lastTimes())
      if (step.kind == StepKind::colour) took_us += step.measured_us;
    const FrameMemory memory = maker.memory();
    const float* at = memory.colour.sums.data() + 3 * gate;
    sums.add({static_cast<double>(at[0]), {static_cast<double>(at[1]), static_cast<double>(at[2])}});
  }
  TrialEstimates found = sums.result();
  const ColourBox box = colourBoxOf(probe, knobs);
  const double gates = box.lines * (box.bottom_mm - box.top_mm) / maker.colourGrid().sampleSpacing_mm;
  found.packet_us = took_us / frames / gates;
  return found;
}

TrialCell cellOf(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene) {
  EW_EXPECTS(knobs.colour.has_value());
  const Probe probe = trialProbe();
  const ColourBox box = colourBoxOf(probe, knobs);
  Knobs atCarrier = knobs;
  atCarrier.carrier_hz = box.carrier_hz;
  const detail::EchoBeams beams = detail::echoBeamsOf(probe, atCarrier, scene, resolvedDepth_mm(probe, knobs));
  return {beams.lateralSigma_mm(vessel.depth_mm), beams.elevationalSigma_mm(vessel.depth_mm),
          0.5 * detail::kDopplerCycles * beams.wavelength_mm / detail::kFwhmOfSigma};
}

TrialEstimates estimatesOfScatterers(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene, const TrialScatterers& scatterers,
                                     int packets) {
  const ColourBox box = colourBoxOf(trialProbe(), knobs);
  const TrialCell cell = cellOf(vessel, knobs, scene);
  const double wavelength_mm = 4.0 * box.nyquist_mmPerS / box.prf_hz;
  std::mt19937 random(scatterers.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  const WallFilter filter(box.packet, box.filterOrder);
  const auto start = Clock::now();
  // A region that holds all of the cell, and what flows into it meanwhile.
  const double way_mm = std::abs(vessel.axis_mmPerS) * box.packet / box.prf_hz;
  const glm::dvec3 half_mm =
      kEdge * glm::dvec3(cell.lateral_mm, cell.axial_mm, cell.elevational_mm) + 0.5 * way_mm * glm::abs(vessel.along());
  const int count = static_cast<int>(scatterers.perMm3 * 8.0 * half_mm.x * half_mm.y * half_mm.z);
  std::vector<std::vector<std::complex<float>>> all;
  double power = 0.0;
  for (int n = 0; n < packets; ++n) {
    auto& samples = all.emplace_back(static_cast<std::size_t>(box.packet));
    for (int each = 0; each < count; ++each) {
      const glm::dvec3 middle_mm = half_mm * glm::dvec3(even(random), even(random), even(random));
      const double y = vessel.fromAxis_mm(middle_mm + glm::dvec3(0.0, vessel.depth_mm, 0.0)) / vessel.radius_mm;
      if (y >= 1.0) continue;
      const glm::dvec3 step_mm = vessel.axis_mmPerS * (1.0 - std::pow(y, vessel.bluntness)) / box.prf_hz * vessel.along();
      for (int k = 0; k < box.packet; ++k) {
        const glm::dvec3 at_mm = middle_mm + (k - 0.5 * (box.packet - 1)) * step_mm;
        const glm::dvec3 off = at_mm / glm::dvec3(cell.lateral_mm, cell.axial_mm, cell.elevational_mm);
        const double squared = glm::dot(off, off);
        if (squared > 16.0) continue;
        samples[static_cast<std::size_t>(k)] +=
            std::complex<float>(std::polar(std::exp(-0.5 * squared), -4.0 * pi * at_mm.y / wavelength_mm));
      }
    }
    for (const auto& sample : samples) power += static_cast<double>(std::norm(sample));
  }
  power /= static_cast<double>(packets) * box.packet;
  const double noise = std::sqrt(0.5 * power / scatterers.signalToNoise);
  TrialSums sums(vessel.towards_mmPerS() / box.nyquist_mmPerS);
  for (auto& samples : all) {
    for (auto& sample : samples) sample += std::complex<float>(std::complex<double>(noise * normal(random), noise * normal(random)));
    filter.apply(samples);
    sums.add(sumsOf(samples));
  }
  TrialEstimates found = sums.result();
  found.packet_us = since_us(start) / packets;
  return found;
}

}  // namespace ew
