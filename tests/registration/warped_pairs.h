#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "registration/tissue.h"

/// Pairs of volumes whose warp is known.
namespace ew::test {

inline constexpr double kTurn = 2.0 * 3.14159265358979323846;

/// A warp of at most `amplitude_mm` that changes along all axes.
inline glm::dvec3 warp(const glm::dvec3& p, double amplitude_mm) {
  return amplitude_mm / 1.5 *
         glm::dvec3(std::sin(kTurn * p.y / 70.0), std::cos(kTurn * (p.z + 10.0) / 80.0), std::sin(kTurn * (p.x + p.z) / 90.0));
}

struct Pair {
  Volume fixed;
  Volume moving;
};

/// The same tissue, warped by a known field: the moving volume shows it upright.
inline Pair warpedPair(const Grid& grid, double amplitude_mm, double noise, unsigned seed = 3) {
  const Tissue tissue(seed);
  return {imaged(
              grid, [&](const glm::dvec3& p) { return tissue.at(p + warp(p, amplitude_mm)); }, noise, 11),
          imaged(
              grid, [&](const glm::dvec3& p) { return tissue.at(p); }, noise, 12)};
}

}  // namespace ew::test
