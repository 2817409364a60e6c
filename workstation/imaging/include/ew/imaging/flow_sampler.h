#pragma once

#include <memory>
#include <vector>

#include "ew/imaging/flow_field.h"

namespace ew {

/// Where the waves of all streams stand at one time. Made by FlowSampler::prepare, which allocates nothing the second time.
struct FlowMoment {
  /// Of a stream's wave at its first node; along the line it is later by the way it runs.
  struct Stream {
    double time_s = 0.0;                     ///< there: less the stream's delay
    double since_s = 0.0, duration_s = 1.0;  ///< of the beat there
    double durationBefore_s = 1.0;           ///< of the beat before, which has not left the vessel yet
    double unit_mm3PerS = 0.0;               ///< flow for each 1 of the wave, with the breath in it
  };
  std::vector<Stream> streams;
};

/// A flow field made ready for frames: profiles in tables by phase and depth, vessels in a grid of cells.
///
/// Velocities are FlowTruth's within 1 % of the section's greatest: both are linear between 256 phases and 97 radii, and one table serves
/// streams of a wave whose Womersley numbers differ by less than 2 %. The layout is ours.
class FlowSampler {
 public:
  /// Takes 200 kB for each wave and size of vessel, 1 kB for each node with a jet, and in each cell of 2 mm 4 bytes and 8 for every piece
  /// of a vessel that may reach there.
  explicit FlowSampler(const FlowField& field);
  ~FlowSampler();
  FlowSampler(FlowSampler&&) noexcept;
  FlowSampler& operator=(FlowSampler&&) noexcept;

  /// The box that holds all blood; empty (lowest above highest) without any.
  [[nodiscard]] const Bounds& bounds() const;
  void prepare(double time_s, FlowMoment& moment) const;
  /// @param moment prepared by this sampler; @param p_mm in the body at rest. May be called by several threads.
  [[nodiscard]] BloodVelocity at(const FlowMoment& moment, const glm::dvec3& p_mm) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace ew
