#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/imaging/flow_field.h"
#include "flow/flow_profile.h"

namespace ew::detail {

/// A stream's line made ready: measured, its directions smoothed, its jets normalised.
struct VesselLine {
  struct Node {
    glm::dvec3 place_mm, along;  ///< along: of length 1
    double radius_mm, at_mm;     ///< at_mm: of the line, from its first node
    double jetShare;
    JetProfile jet;
    double turbulence;
  };
  std::size_t stream = 0;
  double alpha = 0.0;  ///< Womersley's number of one beat a period, at the mean radius; 0 without a pulse
  std::vector<Node> nodes;
};
/// Empty for a stream that is none: fewer than two places with a radius.
[[nodiscard]] std::optional<VesselLine> vesselLineOf(const FlowField& field, std::size_t stream);

/// Where a place lies to a piece of a line.
struct LinePlace {
  std::size_t node = 0;  ///< the one before it
  double share = 0.0;    ///< of the way to the next
  double away_mm = 0.0;  ///< from the line
  double radius_mm = 1.0;
  glm::dvec3 foot_mm{0.0};                                            ///< the nearest place of the piece
  bool isBeyond = false;                                              ///< before the line's beginning or behind its end
  [[nodiscard]] double depth() const { return away_mm / radius_mm; }  ///< 0 on the line, 1 at the wall
};
[[nodiscard]] LinePlace placeOnPiece(const VesselLine& line, std::size_t node, const glm::dvec3& p_mm);

/// How the wave of a stream stands where a section lies.
struct WavePhase {
  double phase = 0.0;
  double breath = 1.0;  ///< by which all of it is more
};
[[nodiscard]] WavePhase waveAt(const FlowField& field, const FlowStream& stream, double along_mm, double time_s);

/// Velocity of blood at a place of a piece, from its parts along the line and away from it.
[[nodiscard]] BloodVelocity bloodOf(const VesselLine& line, const LinePlace& place, const glm::dvec3& p_mm,
                                    const glm::dvec2& velocity_mmPerS, double meanSpeed_mmPerS);

}  // namespace ew::detail
