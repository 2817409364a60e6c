#include "logic/pair_review.h"

namespace ew::stitching {
namespace {

PairMark markOf(const PairOutcome& outcome) {
  switch (outcome.rigid.verdict) {
    case registration::Verdict::aligned:
      if (outcome.wrong) return PairMark::notAligned;
      if (outcome.used == PairMethod::byHand) return PairMark::byHand;
      return outcome.used == PairMethod::landmarks ? PairMark::landmarks : PairMark::aligned;
    case registration::Verdict::cannotTell:
      return PairMark::cannotTell;
    case registration::Verdict::notAligned:
      return PairMark::notAligned;
  }
  return PairMark::unknown;
}

}  // namespace

PairReview reviewOf(const PairOutcome* outcome, const PairDeformation* warp, const ProjectPair& said, bool isStale) {
  PairReview review;
  if (outcome != nullptr) review.mark = markOf(*outcome);
  if (isStale && said.method == PairMethod::byHand) review.mark = PairMark::byHand;  // moved away from what was proved
  if (said.decision == Decision::rejected) review.mark = PairMark::rejected;
  const bool isHeld = review.mark == PairMark::aligned || review.mark == PairMark::landmarks;
  review.warpDoubted = isHeld && warp != nullptr && warp->verdict != registration::Verdict::aligned;
  review.needsLook = outcome != nullptr && said.decision == Decision::undecided && (isStale || !isHeld || review.warpDoubted);
  return review;
}

}  // namespace ew::stitching
