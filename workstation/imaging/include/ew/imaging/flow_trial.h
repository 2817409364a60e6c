#pragma once

#include <vector>

#include "ew/imaging/doppler.h"
#include "ew/imaging/flow_field.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/tissue_maps.h"

namespace ew {

/// A straight vessel in soft tissue below the middle of a linear probe, whose answer is known: what Doppler is measured against.
struct TrialVessel {
  double angle_rad = 0.0;  ///< between the beam and the way blood goes, in the image plane; 0: towards the probe
  double depth_mm = 20.0;  ///< of its axis below the middle of the face
  double radius_mm = 3.0;
  double axis_mmPerS = 200.0;  ///< on the axis
  double bluntness = 2.0;      ///< as FlowStream::bluntness
  double tissueLevel = 45.0;   ///< of the maps, around it; 0: nothing echoes
  [[nodiscard]] glm::dvec3 along() const;
  /// From its axis. @param p_mm of the probe frame
  [[nodiscard]] double fromAxis_mm(const glm::dvec3& p_mm) const;
  /// On its axis along the beam, towards the probe positive.
  [[nodiscard]] double towards_mmPerS() const;
};
[[nodiscard]] FlowField fieldOf(const TrialVessel& vessel);
/// (100 x 100 x 24) voxels of 0.5 mm around the image.
[[nodiscard]] TissueMaps mapsOf(const TrialVessel& vessel);

/// A probe for it, 5 MHz of colour through a slice as thin as good ones are.
[[nodiscard]] Probe trialProbe();
/// A small box about the vessel's axis, without anything between neighbours or frames.
[[nodiscard]] Knobs trialKnobs(const TrialVessel& vessel);
/// Noise of one power at every depth, so many decibels below what a gate full of blood sends at 5 MHz.
[[nodiscard]] Scene trialScene(double signalToNoise_db);

/// Of many packets: mean and standard deviation of their velocities, in units of the Nyquist velocity, and what a packet took.
struct TrialEstimates {
  double mean = 0.0;
  double deviation = 0.0;
  double power = 0.0;
  double packet_us = 0.0;
};
/// Adds up estimates about a velocity, so that those that went around count as near.
class TrialSums {
 public:
  explicit TrialSums(double about) : about_(about) {}
  void add(const PacketSums& sums);
  [[nodiscard]] TrialEstimates result() const;

 private:
  double about_, sum_ = 0.0, squares_ = 0.0, power_ = 0.0;
  int count_ = 0;
};

/// What the colour box finds on the vessel's axis, a packet a frame; the time is the whole box's share for one gate.
[[nodiscard]] TrialEstimates estimatesOfColour(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene, int frames);

/// The same gate seen as scatterers that move through it one by one, each sending exp(-4 pi i depth / wavelength) times the two-way
/// amplitude of beam and pulse where it is: nothing of the statistics is put in. The slow and sure way, for tests and benchmarks.
struct TrialScatterers {
  double perMm3 = 60.0;
  double signalToNoise = 100.0;  ///< power
  unsigned seed = 11;
};
[[nodiscard]] TrialEstimates estimatesOfScatterers(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene,
                                                   const TrialScatterers& scatterers, int packets);

/// Standard deviations of the two-way amplitude of a gate.
struct TrialCell {
  double lateral_mm = 0.5, elevational_mm = 0.5, axial_mm = 0.3;
};
[[nodiscard]] TrialCell cellOf(const TrialVessel& vessel, const Knobs& knobs, const Scene& scene);

}  // namespace ew
