#pragma once

#include <vector>

#include "ew/core/message.h"
#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

namespace ew {

inline constexpr int kPointsOfFace = 17;

/// Of a point of the face that looks past the body, or out of it: a length that no gap reaches and every file can hold.
inline constexpr float kOpenAir_mm = 1000.0F;

/// How far the face lies off the skin at kPointsOfFace evenly spread points from its -x end to its +x end; below 0 it is pressed in.
/// Measured along the skin's normal at the nearest point, as long as the probe looks into the body there: up to 80 degrees from that
/// normal, further than a hand tips it (kMaxTip_rad). A free pose may look elsewhere. Then nearness is no contact: what counts is how far
/// the point's own line goes through air until it meets the skin,
///   gap = max(gap along the normal, cos(80 degrees) * length of that line), kOpenAir_mm where it meets none,
/// which on flat skin goes on from where the first rule ends. A point that lies below the skin is lifted by what the probe looks too far
/// away, from nothing at 80 degrees to kMaxPress_mm at 110; beyond it is in the air, however near the skin is: nobody holds a probe inside
/// a body.
/// Expects a rigid pose.
[[nodiscard]] std::vector<float> gapsToSkin_mm(const Probe& probe, const Pose& pose, const Skin& skin);

/// Part of the face that touches, 0..1: gaps of up to 3 mm are filled by gel.
[[nodiscard]] double contactShare(const std::vector<float>& gaps_mm);
/// The same, counting only points in front of which there are data (see dataInFrontOf): skin that nobody scanned shows nothing.
[[nodiscard]] double contactShare(const std::vector<float>& gaps_mm, const std::vector<bool>& data);

/// How a face lies on the skin, as one says it to who holds the probe.
enum class FaceOnSkin {
  touches,    ///< more than half of it
  partly,     ///< no more than half of it
  inAir,      ///< nowhere, and it looks at the body
  looksAway,  ///< nowhere, and no line of it meets skin
  tooDeep,    ///< pressed in deeper than any hand presses: what measures the probe is wrong
};
struct FaceReport {
  FaceOnSkin how = FaceOnSkin::touches;
  double away_mm = 0.0;  ///< of the nearest point of the face: above 0 off the skin, below 0 of the deepest one; 0 where it looks away
  bool operator==(const FaceReport&) const = default;
};
/// @param gaps_mm of gapsToSkin_mm; none: everything touches
[[nodiscard]] FaceReport faceOnSkin(const std::vector<float>& gaps_mm);
/// In words, and what to do; nothing where it touches with more than half.
[[nodiscard]] Message faceSentence(const FaceReport& report);

/// How firmly a hand presses a probe on when nothing else says so: 1 mm, and four fifths of how far the ends of a curved face lie behind
/// its foremost point, so that on flat skin the whole face touches; gel fills the rest. A convex face of 60 mm radius and 62 degrees: 7.9
/// mm.
[[nodiscard]] double usualPress_mm(const Probe& probe);

}  // namespace ew
