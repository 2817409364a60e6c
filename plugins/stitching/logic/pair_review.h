#pragma once

#include "ew/stitching/chain.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

/// What holds a pair together. A pose that a person gave proves nothing about the images, and never has the sign of one that they proved.
enum class PairMark { unknown, aligned, landmarks, byHand, cannotTell, notAligned, rejected };

/// What is said of a pair in a word, from what a run found and what a person decided: list, graph and inspector say the same.
struct PairReview {
  PairMark mark = PairMark::unknown;
  bool warpDoubted = false;  ///< the rigid pose holds, and the deformation of the last run was not found to be right
  bool needsLook = false;    ///< not aligned, or deformed in doubt, and nobody has decided
  bool operator==(const PairReview&) const = default;
};

/// @param outcome of the last run; null: it did not look at the pair
/// @param warp    of the last run; null: the pair was not deformed
/// @param said    what the project says of the pair now
/// @param isStale whether the project or the places were edited since the run
[[nodiscard]] PairReview reviewOf(const PairOutcome* outcome, const PairDeformation* warp, const ProjectPair& said, bool isStale);

}  // namespace ew::stitching
