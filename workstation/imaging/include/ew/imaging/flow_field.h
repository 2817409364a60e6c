#pragma once

#include <complex>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/imaging/tissue_motion.h"

namespace ew {

/// Flow through a section over a beat, relative to a mean: mean + Re sum over n >= 1 of harmonics[n - 1] exp(2 pi i n phase), with the
/// phase 0..1 from one R peak to the next. A beat that is longer stretches all of it.
struct FlowWave {
  double mean = 1.0;
  std::vector<std::complex<double>> harmonics = {};
  bool operator==(const FlowWave&) const = default;
};
[[nodiscard]] double flowAtPhase(const FlowWave& wave, double phase);
/// The wave through samples at equal steps of the phase, the first at 0; relative to their own unit.
/// @param harmonics at most (samples - 1) / 2 of them are known
[[nodiscard]] FlowWave waveThrough(const std::vector<double>& samples, int harmonics);

/// A place on the line of a vessel, in the body at rest.
struct FlowNode {
  glm::dvec3 place_mm{0.0};
  double radius_mm = 1.0;  ///< > 0: of the lumen, where a stenosis narrows it of what is left
  /// Behind a stenosis blood goes on as a jet: its radius as a share of the lumen's; 1: there is none.
  double jet = 1.0;
  double backflow = 0.0;  ///< beside the jet, as a share of the flow that passes: of the reversed ring; 0..1
  /// Standard deviation of what turbulence adds along each axis, as a share of the section's mean speed; 0: laminar.
  double turbulence = 0.0;
  bool operator==(const FlowNode&) const = default;
};

/// Blood along one vessel.
struct FlowStream {
  std::string name;
  std::vector<FlowNode> line;  ///< at least two, the way blood goes; where `flow_mm3PerS` is below 0 it goes the other way
  double flow_mm3PerS = 0.0;   ///< through every section, for each 1 of the wave
  FlowWave wave = {};
  /// The profile of the steady part is 1 - (r/R)^n: 2 is a parabola, 9 nearly a plug.
  double bluntness = 2.0;
  double pulseWave_mmPerS = 0.0;  ///< the wave runs along the line as fast; 0: it is everywhere at once
  double delay_s = 0.0;           ///< of the wave at the line's first place against the R peak
  double breathShare = 0.0;       ///< of the flow that full inspiration adds to it, -1..1
  bool operator==(const FlowStream&) const = default;
};

/// What blood does in a body: the one description that colour, spectra, speckle and M-mode read, and their truth.
struct FlowField {
  BodyRhythms rhythms = {};
  double density_kgPerM3 = 1060.0;
  double viscosity_mPaS = 3.5;
  std::vector<FlowStream> streams = {};
  bool operator==(const FlowField&) const = default;
};

/// Blood at a place and time.
struct BloodVelocity {
  glm::dvec3 mean_mmPerS{0.0};
  double turbulence_mmPerS = 0.0;  ///< standard deviation along each axis
  int stream = -1;                 ///< of the field; -1: no blood here
};

/// A section across a vessel, with what a Doppler measurement of it should find.
struct FlowSection {
  glm::dvec3 middle_mm{0.0};
  glm::dvec3 along{0.0};         ///< the way the line goes, of length 1
  double radius_mm = 0.0;        ///< of the lumen, or what is left of it
  double flow_mm3PerS = 0.0;     ///< through it, along the line
  double mean_mmPerS = 0.0;      ///< over the section
  double forward_mmPerS = 0.0;   ///< the greatest velocity along the line, 0 where all goes back
  double backward_mmPerS = 0.0;  ///< the least, 0 where all goes forward
  /// Of the two the one that is farther from 0: what an envelope follows.
  [[nodiscard]] double greatest_mmPerS() const { return forward_mmPerS >= -backward_mmPerS ? forward_mmPerS : backward_mmPerS; }
};

/// Womersley's profile of one harmonic, over its mean across the section: 1 on average, complex for the lag of its layers.
/// @param alpha R sqrt(2 pi n f density / viscosity), >= 0; 0 gives the parabola
/// @param y     r / R, 0..1
/// Source: Womersley, J. Physiol. 127, 1955: [J0(a s) - J0(a s y)] / [J0(a s) - 2 J1(a s) / (a s)], s = i^(3/2).
[[nodiscard]] std::complex<double> womersleyProfile(double alpha, double y);
/// R sqrt(2 pi frequency density / viscosity).
[[nodiscard]] double womersleyNumber(double radius_mm, double frequency_hz, double density_kgPerM3, double viscosity_mPaS);

/// Velocity on the axis of a jet over the mean of its section, with the share that is not jet yet as a parabola has it.
/// @param jet, backflow as in FlowNode
[[nodiscard]] double axisOverMean(double jet, double backflow);

/// Answers what blood does. Profiles are as exact as the formulas: the slow and sure way, for truth and for what makes tables.
///
/// Velocity along the line is Q(t) / (pi R^2) times a profile whose mean over the section is 1: the steady part 1 - (r/R)^n, Womersley's
/// profile for each harmonic, and beside a stenosis a jet with a reversed ring. Across the line the velocity is what keeps the flow the
/// same through every section: with g(s, y) = 2 int_0^y f(s, y') y' dy' it is Q / (pi R^2) [f y R' - R / (2 y) dg/ds], which is free of
/// divergence in a straight vessel and follows the wall where that widens. What a wall that pulses takes in is left out (it is thin), and
/// at forks each place belongs to the vessel in which it lies deepest.
class FlowTruth {
 public:
  /// @param field streams of less than two nodes, or none of whose nodes has a radius, are passed over
  explicit FlowTruth(FlowField field);
  ~FlowTruth();
  FlowTruth(FlowTruth&&) noexcept;
  FlowTruth& operator=(FlowTruth&&) noexcept;

  [[nodiscard]] const FlowField& field() const;
  /// @param p_mm in the body at rest
  [[nodiscard]] BloodVelocity at(const glm::dvec3& p_mm, double time_s) const;
  /// The section of a stream nearest to a place; empty without such a stream.
  [[nodiscard]] std::optional<FlowSection> sectionNear(int stream, const glm::dvec3& p_mm, double time_s) const;
  /// Through a section of a stream, `along_mm` from its first node; mm^3/s.
  [[nodiscard]] double flowThrough_mm3PerS(int stream, double along_mm, double time_s) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace ew
