#pragma once

#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

namespace ew {

inline constexpr int kPointsOfFace = 17;

/// How far the face lies off the skin at kPointsOfFace evenly spread points from its -x end to its +x end; below 0 it is pressed in.
/// Measured along the skin's normal at the nearest point.
[[nodiscard]] std::vector<float> gapsToSkin_mm(const Probe& probe, const Pose& pose, const Skin& skin);

/// Part of the face that touches, 0..1: gaps of up to 3 mm are filled by gel.
[[nodiscard]] double contactShare(const std::vector<float>& gaps_mm);
/// The same, counting only points in front of which there are data (see dataInFrontOf): skin that nobody scanned shows nothing.
[[nodiscard]] double contactShare(const std::vector<float>& gaps_mm, const std::vector<bool>& data);

/// How firmly a hand presses a probe on when nothing else says so: 1 mm, and four fifths of how far the ends of a curved face lie behind
/// its foremost point, so that on flat skin the whole face touches; gel fills the rest. A convex face of 60 mm radius and 62 degrees: 7.9
/// mm.
[[nodiscard]] double usualPress_mm(const Probe& probe);

}  // namespace ew
