#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/volume.h"

namespace ew {

/// Where breath, pulse and bowel stand at a moment. All zero: the body at rest, as its maps and labels show it.
struct BodyState {
  double breath = 0.0;  ///< 0: end of expiration; 1: full inspiration
  double pulse = 0.0;   ///< 0: end of diastole; 1: as wide as vessels get
  double bowel = 0.0;   ///< phase of the waves along the gut, in turns: n and n + 1 are the same
  bool operator==(const BodyState&) const = default;
};

/// Cycles begin at n * period_s, each moved by up to half of `variation` periods to either side; the same cycle always by as much.
struct BodyRhythm {
  double period_s = 4.0;   ///< > 0
  double variation = 0.0;  ///< 0..0.4
  bool operator==(const BodyRhythm&) const = default;
};
/// Where a time lies in its cycle.
struct Cycle {
  double since_s = 0.0;     ///< its beginning
  double duration_s = 1.0;  ///< to the beginning of the next
};
/// A time that is no number, or beyond 10^9 s, counts as the beginning of a cycle of 1 s.
[[nodiscard]] Cycle cycleAt(const BodyRhythm& rhythm, double time_s);

/// What moves a body by itself, and when.
struct BodyRhythms {
  struct Breathing {
    BodyRhythm rhythm;
    double pause = 0.3;  ///< share of a cycle without motion, at the end of expiration
    double tidal = 1.0;  ///< a quiet breath, as a share of full inspiration, 0..1
    bool operator==(const Breathing&) const = default;
  };
  std::optional<Breathing> breathing = {};
  std::optional<BodyRhythm> pulse = {};
  std::optional<BodyRhythm> bowel = {};
  bool operator==(const BodyRhythms&) const = default;
};
/// The body at a time; the same time gives the same state. What has no rhythm is at rest.
/// Breath rises and falls like sin^2 (Lujan et al., Med. Phys. 26(5), 1999, n = 1, turned upside down), then pauses. The pulse is that of
/// an artery's diameter: it rises within 0.16 s and falls until the next beat (Nichols and O'Rourke, McDonald's Blood Flow in Arteries).
[[nodiscard]] BodyState bodyAt(const BodyRhythms& rhythms, double time_s);

/// How tissue moves with the body: what rests at x lies at x + sum of a_k D_k(x), with the fields D_k of this value and the amplitudes a_k
/// of a BodyState. Breath and pulse are one field each; waves along the gut are two, a quarter of a wave apart:
///   D(x, phase) = (cos phase - 1) C(x) + sin phase S(x), so that phase 0 is the gut as it is drawn.
/// A sum is what a body does where only one of them moves; where a breath b and a pulse p act on one place, the sum leaves out what the
/// pulse adds to the breath's share: at most |p| times the slope of the breath (0.55 mm times 0.5 in the shipped cases), and nothing where
/// tissue moves freely.
struct TissueMotion {
  enum class Kind { breath, pulse, bowelCosine, bowelSine };
  struct Mode {
    Kind kind = Kind::breath;
    Grid grid;  ///< in the frame of TissueMaps::grid; at least two nodes along each axis
    /// Per node, along the grid's own axes; three linear steps between. Beyond the grid a breath is as at its edge, all else at rest.
    std::vector<glm::vec3> shift_mm;
    bool operator==(const Mode&) const = default;
  };
  BodyRhythms rhythms;
  std::vector<Mode> modes;
  bool operator==(const TissueMotion&) const = default;
};

/// Of a field, in a state of the body.
[[nodiscard]] double amplitudeOf(TissueMotion::Kind kind, const BodyState& body);

}  // namespace ew
