#pragma once

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Live echoes at the price that the console's quality names. What a machine shows (looks, pulse, aperture, gain) stays as asked, and so
/// does the lattice of scatterers: every quality forms the same grain, more or less exactly, so that none appears or goes when the quality
/// falls while the probe moves. What changes is the work:
///   Quality::weave   fast: two thirds of the samples along a pulse, a slice that ends at 0.65 of its reach; losses and surfaces are
///                    followed in its middle plane alone, with what the slope of a surface says of the planes beside it
///   Quality::linear  as asked, unchanged; three planes
///   Quality::cubic   fine: 4/3 of the samples, 5/4 of the reach; three planes
/// resources/docs/science/log/measurements.md, "Live echoes", says what each costs and how far it is from the forward model.
/// @param asked within its limits (scene.h), which the result keeps
[[nodiscard]] LiveEchoesEffect qualityOf(const LiveEchoesEffect& asked, Quality quality);

/// How much a frame of live echoes has to do, from the geometry alone; in tissue everywhere.
struct EchoWork {
  double scatterers = 0.0;  ///< in the slice under the beams: put on the grid, each once
  int lines = 0;
  int samples = 0;  ///< of each line
  int looks = 0;    ///< pulses that each line is filtered with
};

/// @param scene with live echoes; brought within limits
/// @param depth_mm of the image, > 0
[[nodiscard]] EchoWork echoWorkOf(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm);

}  // namespace ew
