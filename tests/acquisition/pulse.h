#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "acquisition/sweeps.h"
#include "ew/acquisition/gating.h"

namespace ew::pulse {

inline double bell(double x, double width) { return std::exp(-0.5 * x * x / (width * width)); }

/// P, Q, R, S and T of beats whose R peaks stand at `beats_s`, mV.
inline double ecgAt(const std::vector<double>& beats_s, double t_s) {
  double mv = 0.0;
  for (const double beat_s : beats_s) {
    const double t = t_s - beat_s;
    if (std::abs(t) > 0.7) continue;
    mv += 0.15 * bell(t + 0.16, 0.022) - 0.12 * bell(t + 0.026, 0.008) + bell(t, 0.011) - 0.2 * bell(t - 0.028, 0.009) +
          0.3 * bell(t - 0.26, 0.045);
  }
  return mv;
}

inline BodySignal ecg(const std::vector<double>& beats_s, double duration_s, double rate_hz) {
  BodySignal signal;
  for (int n = 0; n / rate_hz <= duration_s; ++n) {
    signal.time_s.push_back(n / rate_hz);
    signal.value.push_back(ecgAt(beats_s, n / rate_hz));
  }
  return signal;
}

/// Beats from 0.4 s on, of lengths that vary by `share` to either side.
inline std::vector<double> beats(double duration_s, double length_s, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> vary(-share, share);
  std::vector<double> beats_s;
  for (double t = 0.4; t < duration_s - 0.2; t += length_s * (1.0 + vary(random))) beats_s.push_back(t);
  return beats_s;
}

/// How wide a vessel is along a beat, 0 to 1: a quick rise and a slow fall.
inline double widthAt(double phase) {
  return phase < 0.2 ? 0.5 - 0.5 * std::cos(std::numbers::pi * phase / 0.2) : 0.5 + 0.5 * std::cos(std::numbers::pi * (phase - 0.2) / 0.8);
}

inline double hashed(int i, int j, int k) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9E3779B1u ^ static_cast<std::uint32_t>(j) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(k) * 0xC2B2AE3Du;
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  h ^= h >> 15;
  return static_cast<double>(h) / 4294967295.0 - 0.5;
}

/// Grains of one mm on a lattice, between them linear.
inline double lattice(const glm::dvec3& p_mm) {
  const glm::dvec3 low = glm::floor(p_mm), share = p_mm - low;
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    const double weight = (step.x ? share.x : 1.0 - share.x) * (step.y ? share.y : 1.0 - share.y) * (step.z ? share.z : 1.0 - share.z);
    const glm::ivec3 at = glm::ivec3(low) + step;
    value += weight * hashed(at.x, at.y, at.z);
  }
  return value;
}

/// Texture fixed in the world: three lattices turned against each other, so that no straight way through them is periodic.
inline double texture(const glm::dvec3& p_mm) {
  const glm::dvec3 a(0.36, 0.48, 0.8), b(-0.8, 0.6, 0.0), c(-0.48, -0.64, 0.6);
  const glm::dvec3 turned(glm::dot(a, p_mm), glm::dot(b, p_mm), glm::dot(c, p_mm));
  const glm::dvec3 again(glm::dot(a, turned), glm::dot(c, turned), glm::dot(b, turned));
  return (lattice(1.07 * turned + 31.4) + lattice(0.83 * again - 17.7) + lattice(1.31 * glm::dvec3(turned.y, again.x, again.z) + 7.3)) /
         1.7;
}

struct Tube {
  double rest_mm = 6.0;    ///< radius at the end of diastole
  double widens_mm = 2.0;  ///< by how much the radius grows
  double length_s = 0.8;   ///< of a beat; phase 0 at time 0
  double speed_mmPerS = 4.0;
  double fps = 25.0;
  bool pulsates = true;
  double pixel_mm = 0.5;

  [[nodiscard]] double phaseAt(double t_s) const { return t_s / length_s - std::floor(t_s / length_s); }
  [[nodiscard]] double radiusAt(double phase) const { return rest_mm + (pulsates ? widens_mm * widthAt(phase) : 0.0); }
};

/// Frames across a tube along z, as a slowly moved probe sees it: dark lumen, bright textured tissue that gives way to it.
inline sweeps::Sweep imaged(const Tube& tube, int frames) {
  const int size = static_cast<int>(32.0 / tube.pixel_mm);
  const double pixel_mm = tube.pixel_mm;
  sweeps::Sweep sweep;
  for (int n = 0; n < frames; ++n) {
    const double t_s = n / tube.fps, z_mm = tube.speed_mmPerS * t_s, radius_mm = tube.radiusAt(tube.phaseAt(t_s));
    sweep.add(sweeps::imageOf(size, size,
                              [&](int x, int y) {
                                const double px_mm = pixel_mm * x - 16.0, py_mm = pixel_mm * y - 16.0;
                                const double r_mm = std::hypot(px_mm, py_mm);
                                const double inside = 0.5 - 0.5 * std::tanh((r_mm - radius_mm) / 0.4);
                                // Tissue outside keeps its area: what lay at rest on radius q lies at r now.
                                const double q_mm =
                                    std::sqrt(std::max(0.0, r_mm * r_mm - radius_mm * radius_mm + tube.rest_mm * tube.rest_mm));
                                const double scale = r_mm > 0.0 ? q_mm / r_mm : 1.0;
                                const double tissue = 120.0 + 90.0 * texture({px_mm * scale, py_mm * scale, z_mm});
                                return static_cast<int>(std::lround(10.0 * inside + tissue * (1.0 - inside)));
                              }),
              sweeps::matrixOf({pixel_mm, 0, 0}, {0, pixel_mm, 0}, {0, 0, pixel_mm}, {-16.0, -16.0, z_mm}));
  }
  return sweep;
}

/// Diameter of the dark lumen in a volume, mm: from the area below half of the tissue's level, mean over the slices that have frames.
inline double diameterIn(const Volume& volume) {
  const Grid& grid = volume.grid;
  double sum_mm = 0.0;
  int slices = 0;
  for (int k = 0; k < grid.dims.z; ++k) {
    std::size_t measured = 0;
    double area = 0.0;
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const std::size_t index = grid.indexOf(i, j, k);
        if (volume.coverageAt(index) == Coverage::absent) continue;
        ++measured;
        area += volume.echo[index] < 65 ? 1.0 : 0.0;
      }
    if (measured < static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y) * 9 / 10) continue;
    sum_mm += 2.0 * std::sqrt(area * grid.spacing_mm.x * grid.spacing_mm.y / std::numbers::pi);
    ++slices;
  }
  return slices > 0 ? sum_mm / slices : 0.0;
}

}  // namespace ew::pulse
