#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "echoes/echo_beams.h"
#include "ew/imaging/display.h"
#include "ew/imaging/doppler.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/frame.h"

/// A straight vessel in soft tissue below a linear probe, and scatterers that move through one gate of it.
namespace ew::testing::colour {

inline constexpr double kDepth_mm = 20.0;  ///< of the vessel's axis below the middle of the face

inline Probe linear() {
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

struct Vessel {
  double angle_deg = 45.0;  ///< between the beam and the way blood goes, which is towards the probe
  double radius_mm = 3.0;
  double axis_mmPerS = 200.0;
  double bluntness = 2.0;  ///< 2: a parabola
  double tissueLevel = 45.0;
  [[nodiscard]] glm::dvec3 along() const {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    return {std::sin(angle), -std::cos(angle), 0.0};
  }
  [[nodiscard]] double meanShare() const { return bluntness / (bluntness + 2.0); }
};

inline FlowField fieldOf(const Vessel& vessel) {
  FlowField field;
  const glm::dvec3 middle(0.0, kDepth_mm, 0.0);
  FlowStream stream;
  stream.name = "vessel";
  for (const double at_mm : {-80.0, 0.0, 80.0}) stream.line.push_back({middle + at_mm * vessel.along(), vessel.radius_mm});
  stream.flow_mm3PerS = vessel.axis_mmPerS * vessel.meanShare() * std::numbers::pi * vessel.radius_mm * vessel.radius_mm;
  stream.bluntness = vessel.bluntness;
  field.streams.push_back(stream);
  return field;
}

inline double fromAxis_mm(const Vessel& vessel, const glm::dvec3& p_mm) {
  const glm::dvec3 off = p_mm - glm::dvec3(0.0, kDepth_mm, 0.0);
  return glm::length(off - glm::dot(off, vessel.along()) * vessel.along());
}

inline TissueMaps tissueOf(const Vessel& vessel) {
  TissueMaps maps;
  maps.grid.dims = {100, 100, 24};
  maps.grid.spacing_mm = glm::dvec3(0.5);
  maps.grid.origin_mm = {-25.0, -2.0, -6.0};
  maps.level.resize(maps.grid.voxelCount());
  for (int k = 0; k < maps.grid.dims.z; ++k)
    for (int j = 0; j < maps.grid.dims.y; ++j)
      for (int i = 0; i < maps.grid.dims.x; ++i) {
        const glm::dvec3 mm = maps.grid.origin_mm + 0.5 * glm::dvec3(i, j, k);
        const bool isBlood = fromAxis_mm(vessel, mm) < vessel.radius_mm;
        maps.level[maps.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(isBlood ? 0.0 : vessel.tissueLevel);
      }
  return maps;
}

/// A small box about the vessel's axis, without anything between neighbours or frames.
inline Knobs plainKnobs() {
  Knobs knobs;
  ColourDoppler colour;
  colour.boxWidth = 0.1;
  colour.boxHeight_mm = 5.0;
  colour.boxMiddle_mm = kDepth_mm;
  colour.carrier_hz = 5e6;
  colour.prf_hz = 4000.0;
  colour.wallFilter = WallFilterSetting::low;
  colour.smoothing = 0;
  colour.persistence = 0.0;
  colour.everyLine = 1;
  knobs.colour = colour;
  return knobs;
}

/// Noise of one power at every depth, so many dB below what blood sends; far below it without a number.
inline Scene sceneOf(double signalToNoise_db = 60.0) {
  Scene scene;
  // What is blood's level at 5 MHz, and what a narrow band wins: measured by ColourDoppler.SaysWhatItsLevelsAre.
  scene.noise = NoiseEffect{.atFace_db = -78.0 + 4.0 - signalToNoise_db, .growth_dbPerCmMhz = 0.0, .largest_db = 0.0};
  return scene;
}

struct Shot {
  Vessel vessel = {};
  Knobs knobs = plainKnobs();
  Scene scene = sceneOf();
  Probe probe = linear();
};

/// Makes frames of a shot and tells what was measured at a gate.
class ColourScan {
 public:
  explicit ColourScan(const Shot& shot, int threads = 1)
      : shot_(shot), maps_(tissueOf(shot.vessel)), sampler_(fieldOf(shot.vessel)), maker_(threads) {
    maker_.configure(shot.probe, shot.knobs, shot.scene, maps_.grid, 320, 320, {.tissue = true, .flow = true});
    input_.echo = VolumeView<const std::uint8_t>{maps_.level.data(), maps_.grid};
    input_.tissue = &maps_;
    input_.tissueGrid = maps_.grid;
    input_.flow = &sampler_;
  }
  DisplayImage next() {
    ++input_.number;
    input_.time_s += 0.05;
    return maker_.make(input_);
  }
  [[nodiscard]] FrameInput& input() { return input_; }
  [[nodiscard]] FrameMaker& maker() { return maker_; }
  [[nodiscard]] const FrameMaker& maker() const { return maker_; }
  [[nodiscard]] ColourBox box() const { return colourBoxOf(shot_.probe, shot_.knobs); }
  [[nodiscard]] const TissueMaps& maps() const { return maps_; }
  /// Gate and line nearest to a place in the image plane, and what lies there.
  struct Gate {
    int line = 0, gate = 0;
    glm::dvec2 at_mm{0.0}, direction{0.0};
  };
  [[nodiscard]] Gate gateAt(const glm::dvec2& p_mm) const {
    const BeamGrid& grid = maker_.colourGrid();
    Gate nearest;
    double best = 1e300;
    for (int line = 0; line < static_cast<int>(grid.lines.size()); ++line)
      for (int gate = 0; gate < grid.samples; ++gate) {
        const BeamGrid::Line& way = grid.lines[static_cast<std::size_t>(line)];
        const glm::dvec2 at = way.origin_mm + grid.depth_mm(gate) * way.direction;
        if (glm::distance(at, p_mm) >= best) continue;
        best = glm::distance(at, p_mm);
        nearest = {line, gate, at, way.direction};
      }
    return nearest;
  }
  [[nodiscard]] PacketSums sumsAt(const Gate& gate) const {
    const ColourMemory memory = maker_.memory().colour;
    const float* at = memory.sums.data() + std::size_t{3} * (static_cast<std::size_t>(gate.gate) * static_cast<std::size_t>(memory.lines) +
                                                             static_cast<std::size_t>(gate.line));
    return {static_cast<double>(at[0]), {static_cast<double>(at[1]), static_cast<double>(at[2])}};
  }

 private:
  Shot shot_;
  TissueMaps maps_;
  FlowSampler sampler_;
  FrameMaker maker_;
  FrameInput input_;
};

/// Standard deviations of the two-way amplitude of a resolution cell, as the colour box has them.
struct CellSize {
  double lateral_mm, elevational_mm, axial_mm;
};
inline CellSize cellAt(const Probe& probe, Knobs knobs, const Scene& scene, double depth_mm) {
  const double carrier_hz = knobs.colour->carrier_hz;
  knobs.carrier_hz = carrier_hz;
  const detail::EchoBeams beams = detail::echoBeamsOf(probe, knobs, scene, resolvedDepth_mm(probe, knobs));
  // Four cycles there and back, at half of their height.
  return {beams.lateralSigma_mm(depth_mm), beams.elevationalSigma_mm(depth_mm), 4.0 * 0.5 * 1.54e6 / carrier_hz / 2.3548200450309493};
}

/// Mean and standard deviation of velocity estimates about a velocity, in units of the Nyquist velocity.
struct Estimates {
  double mean = 0.0, deviation = 0.0, power = 0.0;
};
class EstimateSums {
 public:
  explicit EstimateSums(double about) : about_(about) {}
  void add(const PacketSums& sums) {
    const double off = meanVelocity({sums.r0, sums.r1 * std::polar(1.0, -std::numbers::pi * about_)});
    sum_ += off;
    squares_ += off * off;
    power_ += sums.r0;
    ++count_;
  }
  [[nodiscard]] Estimates result() const {
    const double mean = sum_ / count_;
    return {about_ + mean, std::sqrt(squares_ / count_ - mean * mean), power_ / count_};
  }

 private:
  double about_, sum_ = 0.0, squares_ = 0.0, power_ = 0.0;
  int count_ = 0;
};

/// The same of scatterers, each of which moves through the gate along the flow and sends back exp(-4 pi i depth / wavelength) times the
/// two-way amplitude of beam and pulse where it is: what colour is to be like, with nothing of its statistics put in.
struct ScattererScan {
  Vessel vessel;
  double wavelength_mm = 0.308, prf_hz = 4000.0;
  double lateralSigma_mm = 0.4, elevationalSigma_mm = 0.5, axialSigma_mm = 0.26;
  int packet = 10, filterOrder = 0;
  double signalToNoise = 100.0;  ///< power

  [[nodiscard]] Estimates run(double about, int packets, unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    const WallFilter filter(packet, filterOrder);
    EstimateSums estimates(about);
    // A box that holds all of the cell, and what flows into it meanwhile.
    const glm::dvec3 along = vessel.along();
    const double way_mm = std::abs(vessel.axis_mmPerS) * packet / prf_hz;
    const glm::dvec3 half = 3.0 * glm::dvec3(lateralSigma_mm, axialSigma_mm, elevationalSigma_mm) + 0.5 * way_mm * glm::abs(along);
    const int count = static_cast<int>(60.0 * 8.0 * half.x * half.y * half.z);
    std::vector<std::complex<float>> samples(static_cast<std::size_t>(packet));
    double power = 0.0;
    std::vector<std::vector<std::complex<float>>> all;
    for (int n = 0; n < packets; ++n) {
      std::fill(samples.begin(), samples.end(), std::complex<float>(0.0F));
      for (int each = 0; each < count; ++each) {
        const glm::dvec3 start = half * glm::dvec3(even(random), even(random), even(random));
        const double y = fromAxis_mm(vessel, start + glm::dvec3(0.0, kDepth_mm, 0.0)) / vessel.radius_mm;
        if (y >= 1.0) continue;
        const glm::dvec3 step = vessel.axis_mmPerS * (1.0 - std::pow(y, vessel.bluntness)) / prf_hz * along;
        for (int k = 0; k < packet; ++k) {
          const glm::dvec3 at = start + (k - 0.5 * (packet - 1)) * step;
          const double e = at.x * at.x / (lateralSigma_mm * lateralSigma_mm) + at.y * at.y / (axialSigma_mm * axialSigma_mm) +
                           at.z * at.z / (elevationalSigma_mm * elevationalSigma_mm);
          if (e > 16.0) continue;
          samples[static_cast<std::size_t>(k)] +=
              std::complex<float>(std::polar(std::exp(-0.5 * e), -4.0 * std::numbers::pi * at.y / wavelength_mm));
        }
      }
      for (const auto& sample : samples) power += static_cast<double>(std::norm(sample));
      all.push_back(samples);
    }
    power /= static_cast<double>(packets) * packet;
    const double noise = std::sqrt(0.5 * power / signalToNoise);
    for (auto& one : all) {
      for (auto& sample : one) sample += std::complex<float>(std::complex<double>(noise * normal(random), noise * normal(random)));
      filter.apply(one);
      estimates.add(sumsOf(one));
    }
    return estimates.result();
  }
};

}  // namespace ew::testing::colour
