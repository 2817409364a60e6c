#include "logic/pair_review.h"

#include <gtest/gtest.h>

namespace ew::stitching::pair_review_test {
namespace {

using registration::Verdict;

PairOutcome found(Verdict verdict, PairMethod used = PairMethod::automatic) {
  PairOutcome outcome;
  outcome.used = used;
  outcome.rigid.verdict = verdict;
  return outcome;
}

PairDeformation warped(Verdict verdict) {
  PairDeformation warp;
  warp.verdict = verdict;
  return warp;
}

ProjectPair decided(Decision decision) {
  ProjectPair said;
  said.decision = decision;
  return said;
}

ProjectPair placedByHand() {
  ProjectPair said;
  said.method = PairMethod::byHand;
  return said;
}

TEST(PairReview, AsksForALookWhereADeformationIsInDoubtThoughThePoseIsAligned) {
  const PairOutcome outcome = found(Verdict::aligned);
  const PairDeformation right = warped(Verdict::aligned);
  EXPECT_EQ(reviewOf(&outcome, nullptr, {}, false), (PairReview{PairMark::aligned, false, false}));
  EXPECT_EQ(reviewOf(&outcome, &right, {}, false), (PairReview{PairMark::aligned, false, false}));
  // As where motion remains that the deformation does not follow: "no pair needs a look" stood beside it.
  for (const Verdict verdict : {Verdict::cannotTell, Verdict::notAligned}) {
    const PairDeformation doubtful = warped(verdict);
    EXPECT_EQ(reviewOf(&outcome, &doubtful, {}, false), (PairReview{PairMark::aligned, true, true}));
  }
}

TEST(PairReview, IsOverOnceAPersonHasDecided) {
  const PairOutcome outcome = found(Verdict::aligned);
  const PairDeformation doubtful = warped(Verdict::cannotTell);
  EXPECT_EQ(reviewOf(&outcome, &doubtful, decided(Decision::accepted), false), (PairReview{PairMark::aligned, true, false}));
  EXPECT_EQ(reviewOf(&outcome, &doubtful, decided(Decision::rejected), false), (PairReview{PairMark::rejected, false, false}));
}

TEST(PairReview, AsksOfEveryPoseThatIsNotProvedOrWasEdited) {
  const PairOutcome aligned = found(Verdict::aligned), unsure = found(Verdict::cannotTell), apart = found(Verdict::notAligned),
                    byHand = found(Verdict::aligned, PairMethod::byHand), placed = found(Verdict::aligned, PairMethod::landmarks);
  PairOutcome disbelieved = aligned;
  disbelieved.wrong = true;
  EXPECT_EQ(reviewOf(&unsure, nullptr, {}, false), (PairReview{PairMark::cannotTell, false, true}));
  EXPECT_EQ(reviewOf(&apart, nullptr, {}, false), (PairReview{PairMark::notAligned, false, true}));
  EXPECT_EQ(reviewOf(&disbelieved, nullptr, {}, false), (PairReview{PairMark::notAligned, false, true}));
  EXPECT_EQ(reviewOf(&byHand, nullptr, {}, false), (PairReview{PairMark::byHand, false, true}));
  EXPECT_EQ(reviewOf(&placed, nullptr, {}, false), (PairReview{PairMark::landmarks, false, false}));
  EXPECT_EQ(reviewOf(&aligned, nullptr, {}, true), (PairReview{PairMark::aligned, false, true}));
  EXPECT_EQ(reviewOf(&aligned, nullptr, placedByHand(), true), (PairReview{PairMark::byHand, false, true}));
  EXPECT_EQ(reviewOf(nullptr, nullptr, {}, false), PairReview{});
}

}  // namespace
}  // namespace ew::stitching::pair_review_test
