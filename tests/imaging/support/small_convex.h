#pragma once

#include "ew/imaging/probe.h"

namespace ew::testing {

/// An abdominal probe with few lines, for echoes that are formed live.
inline Probe smallConvex(double halfAngle_rad, int lines, double depth_mm) {
  Probe probe;
  probe.id = "convex";
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = halfAngle_rad;
  probe.lines = lines;
  probe.carrier_hz = 3.5e6;
  probe.carriers_hz = {3.5e6};
  probe.aperture_mm = 25.0;
  probe.elevationalThickness_mm = 3.0;
  probe.elevationalFocus_mm = 50.0;
  probe.elevationalAperture_mm = 10.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = depth_mm;
  return probe;
}

}  // namespace ew::testing
