#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "ew/core/frames.h"
#include "ew/registration/landmarks.h"
#include "registration/landmark_sets.h"

namespace ew::registration::registration_landmarks_test {
namespace {

using test::pairsOf;
using test::rigid;
using test::scattered;
using test::worst;

bool mentions(const LandmarkResult& result, const std::string& words) { return result.reason.english().find(words) != std::string::npos; }

const auto kTruth = rigid(0.6, {1.0, 2.0, 3.0}, {20.0, -30.0, 5.0});

TEST(LandmarkHardCases, CollinearPlacesCannotTellTheTurnAboutTheirLine) {
  std::vector<glm::dvec3> line;
  for (const double t : {-40.0, -10.0, 5.0, 60.0}) line.push_back(t * glm::normalize(glm::dvec3(1.0, 2.0, -1.0)));
  const auto found = registerLandmarks(pairsOf(line, kTruth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_TRUE(found->collinear);
  EXPECT_EQ(found->stop, StopReason::singular);
  EXPECT_TRUE(mentions(*found, "on one line")) << found->reason;
  EXPECT_LT(found->conditioning, 1e-6);
  EXPECT_TRUE(std::isinf(found->expectedError_mm));
  EXPECT_TRUE(checkRigid(found->fixedToMoving, 1e-9)) << "what is returned is a rigid transform all the same";
  EXPECT_LT(worst(found->fixedToMoving, kTruth, line), 1e-6) << "and one that takes the places onto each other";
}

TEST(LandmarkHardCases, PlacesNearlyOnALineCannotTellEither) {
  std::vector<glm::dvec3> line;
  for (const double t : {-40.0, -10.0, 5.0, 60.0}) line.emplace_back(t, 0.3 * std::sin(t), 0.2 * std::cos(t));
  const auto found = registerLandmarks(pairsOf(line, kTruth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_TRUE(found->collinear);
}

TEST(LandmarkHardCases, CoincidentPairsCountAsOnePlace) {
  const auto places = scattered(2, 5);
  auto pairs = pairsOf({places[0], places[1], places[0], places[1], places[0]}, kTruth);
  const auto found = registerLandmarks(pairs);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_EQ(found->coincident, (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_TRUE(mentions(*found, "'p2', 'p3' and 'p4'")) << found->reason;
}

TEST(LandmarkHardCases, ARepeatedPlaceAmongEnoughIsNamedAndDoesNoHarm) {
  auto places = scattered(5, 6);
  places.push_back(places[2]);
  const auto found = registerLandmarks(pairsOf(places, kTruth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_EQ(found->coincident, std::vector<std::size_t>{5});
  EXPECT_LT(worst(found->fixedToMoving, kTruth, places), 1e-8);
}

TEST(LandmarkHardCases, TooFewPlacesSayHowManyAreNeeded) {
  for (std::size_t count = 0; count < 3; ++count) {
    const auto places = scattered(count, 7);
    const auto found = registerLandmarks(pairsOf(places, kTruth));
    ASSERT_TRUE(found) << count;
    EXPECT_EQ(found->verdict, Verdict::cannotTell) << count;
    EXPECT_TRUE(mentions(*found, "three places")) << found->reason;
    EXPECT_LT(worst(found->fixedToMoving, kTruth, places), 1e-8) << "what there is, is brought together";
  }
}

TEST(LandmarkHardCases, OneWrongLandmarkIsNamedAndHasNoInfluence) {
  for (const std::size_t count : {std::size_t{4}, std::size_t{5}, std::size_t{8}, std::size_t{40}}) {
    const auto places = scattered(count, 100 + count);
    auto pairs = pairsOf(places, kTruth);
    pairs[1].name = "left kidney, upper pole";
    pairs[1].moving_mm += glm::dvec3(-14.0, 18.0, 9.0);
    const auto found = registerLandmarks(pairs);
    ASSERT_TRUE(found) << count;
    EXPECT_EQ(found->verdict, Verdict::aligned) << count << ": " << found->reason;
    EXPECT_EQ(found->outlying, std::vector<std::size_t>{1}) << count;
    EXPECT_TRUE(mentions(*found, "'left kidney, upper pole' does not fit")) << found->reason;
    EXPECT_LT(worst(found->fixedToMoving, kTruth, places), 1e-6) << count;
    EXPECT_LT(found->weight[1], 0.5);
  }
}

TEST(LandmarkHardCases, TwoLandmarksExchangedAreNamed) {
  const auto places = scattered(7, 9);
  auto pairs = pairsOf(places, kTruth);
  std::swap(pairs[2].moving_mm, pairs[5].moving_mm);
  const auto found = registerLandmarks(pairs);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_EQ(found->outlying, (std::vector<std::size_t>{2, 5}));
  EXPECT_LT(worst(found->fixedToMoving, kTruth, places), 1e-6);
}

TEST(LandmarkHardCases, ThreeThatContradictEachOtherCannotSayWhichIsWrong) {
  auto pairs = pairsOf(scattered(3, 10), kTruth);
  pairs[0].moving_mm += glm::dvec3(60.0, 40.0, -50.0);
  const auto found = registerLandmarks(pairs);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_TRUE(mentions(*found, "add a fourth")) << found->reason;
}

TEST(LandmarkHardCases, PairsWithNothingInCommonAreNotAligned) {
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto pairs = pairsOf(scattered(8, 200 + seed), kTruth);
    const auto elsewhere = scattered(8, 300 + seed);
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].moving_mm = elsewhere[i];
    const auto found = registerLandmarks(pairs);
    ASSERT_TRUE(found);
    refused += found->verdict == Verdict::notAligned ? 1 : 0;
  }
  EXPECT_EQ(refused, 20);
}

TEST(LandmarkHardCases, MirroredPlacesAreNamedAsSuch) {
  const auto places = scattered(6, 11);
  const auto found = registerLandmarks(pairsOf(places, {kTruth.matrix * glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0})}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::notAligned);
  EXPECT_TRUE(mentions(*found, "mirror image")) << found->reason;
  EXPECT_GT(glm::determinant(glm::dmat3(found->fixedToMoving.matrix)), 0.0) << "no mirror is ever returned";
}

TEST(LandmarkHardCases, PlacesInOnePlaneGiveTheTurnAndNoMirror) {
  const auto places = std::vector<glm::dvec3>{{0, 0, 0}, {50, 0, 0}, {0, 40, 0}, {30, 35, 0}};
  const auto found = registerLandmarks(pairsOf(places, kTruth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(worst(found->fixedToMoving, kTruth, scattered(5, 1)), 1e-8);
}

TEST(LandmarkHardCases, HalfATurnAboutAnyAxisIsFound) {
  for (const glm::dvec3& axis :
       {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1), glm::dvec3(-1, 2, 0)}) {
    for (const double off : {0.0, 1e-12, 1e-6}) {
      const auto truth = rigid(glm::pi<double>() - off, axis, {10.0, 20.0, 30.0});
      const auto found = registerLandmarks(pairsOf(scattered(5, 12), truth));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->verdict, Verdict::aligned);
      EXPECT_LT(worst(found->fixedToMoving, truth, scattered(5, 13)), 1e-8);
    }
  }
}

TEST(LandmarkHardCases, FarFromTheOriginNothingIsLost) {
  auto places = scattered(5, 14);
  for (auto& p : places) p += glm::dvec3(1e6, -1e6, 5e5);
  const auto found = registerLandmarks(pairsOf(places, kTruth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(worst(found->fixedToMoving, kTruth, places), 1e-5);
}

}  // namespace
}  // namespace ew::registration::registration_landmarks_test
