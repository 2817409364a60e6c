#pragma once

#include <rapidcheck.h>

#include <numbers>
#include <utility>

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::testing {

inline double numberBetween(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6; }

/// A usual probe of a kind.
inline Probe probeOf(ProbeKind kind) {
  constexpr double kDegree_rad = std::numbers::pi / 180.0;
  Probe probe;
  probe.kind = kind;
  probe.minDepth_mm = 20.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = 120.0;
  const auto sector = [&probe](double radius_mm, double opening_deg) {
    probe.radius_mm = radius_mm;
    probe.halfAngle_rad = 0.5 * kDegree_rad * opening_deg;
    probe.width_mm = 2.0 * probe.radius_mm * probe.halfAngle_rad;
  };
  switch (kind) {
    case ProbeKind::linear:
      probe.width_mm = 40.0;
      probe.maxSteering_rad = 20.0 * kDegree_rad;
      probe.trapezoidHalfAngle_rad = 12.0 * kDegree_rad;
      break;
    case ProbeKind::convex:
      sector(60.0, 62.0);
      break;
    case ProbeKind::phased:
      sector(0.0, 90.0);
      probe.width_mm = 20.0;
      break;
    case ProbeKind::endocavity:
      sector(10.5, 140.0);
      break;
    case ProbeKind::sweptSector:
      sector(14.0, 90.0);
      break;
  }
  return probe;
}

/// Any probe that a file may describe, with console settings that change its fan.
inline rc::Gen<std::pair<Probe, Knobs>> probeAtRandom() {
  return rc::gen::exec([] {
    constexpr double kDegree_rad = std::numbers::pi / 180.0;
    Probe probe =
        probeOf(*rc::gen::element(ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector));
    Knobs knobs;
    probe.lines = *rc::gen::inRange(2, 300);
    probe.width_mm = numberBetween(5.0, 100.0);
    if (isSector(probe.kind)) {
      if (probe.kind != ProbeKind::phased) probe.radius_mm = numberBetween(3.0, 100.0);
      probe.halfAngle_rad = kDegree_rad * numberBetween(2.5, 85.0);
    } else {
      probe.maxSteering_rad = kDegree_rad * numberBetween(0.0, 45.0);
      probe.trapezoidHalfAngle_rad = kDegree_rad * numberBetween(0.1, 30.0);
      knobs.steering_rad = kDegree_rad * numberBetween(-50.0, 50.0);
      knobs.trapezoid = *rc::gen::arbitrary<bool>();
    }
    return std::pair{probe, knobs};
  });
}

}  // namespace ew::testing
