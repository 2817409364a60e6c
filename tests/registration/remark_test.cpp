#include "ew/registration/remark.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "ew/registration/landmarks.h"

namespace ew::registration::remark_test {
namespace {

constexpr int kCount = static_cast<int>(RemarkCode::count_);

std::string said(const Remark& remark, Wording wording = Wording::full) { return messageOf(remark, wording).english(); }

TEST(Remark, HasAWordOfItsOwnThatIsReadBack) {
  std::set<std::string> words;
  for (int n = 0; n < kCount; ++n) {
    const auto what = static_cast<RemarkCode>(n);
    ASSERT_NE(nameOf(what), nullptr) << n;
    EXPECT_FALSE(std::string(nameOf(what)).empty()) << n;
    EXPECT_TRUE(words.insert(nameOf(what)).second) << nameOf(what);
    EXPECT_EQ(saysFrom(nameOf(what)), what);
  }
  EXPECT_FALSE(saysFrom("something else"));
}

TEST(Remark, IsASentenceWhateverFiguresItHas) {
  for (int n = 0; n < kCount; ++n) {
    const Remark bare{static_cast<RemarkCode>(n)};
    for (const Wording wording : {Wording::full, Wording::brief}) {
      const std::string sentence = said(bare, wording);
      ASSERT_FALSE(sentence.empty()) << nameOf(bare.what);
      EXPECT_EQ(sentence.back(), '.') << sentence;
    }
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(said({bare.what, std::vector<double>(8, infinite), {"a"}}).find("inf"), std::string::npos) << nameOf(bare.what);
  }
}

TEST(Remark, LeavesAgreementAndAllButEightNamesOutWhenBrief) {
  EXPECT_EQ(said({RemarkCode::onePoseStandsOut, {3.14, 0.26, 0.82, 0.12, 33.06}}, Wording::brief),
            "One pose stands out by a margin of 3.1, and halves of the overlap registered apart agree to 0.3 mm.");
  EXPECT_EQ(said({RemarkCode::startMayBeFar, {4.0, 0.82, 0.12, 33.06}}, Wording::brief),
            "Halves of the overlap registered apart contradict each other by 4.0 mm: the start may be too far off.");
  EXPECT_EQ(said({RemarkCode::warpAgrees, {0.82, 0.88, 0.5}}, Wording::brief), "Deformed, the volumes agree.");
  const Remark many{RemarkCode::placesRepeat, {}, {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"}};
  EXPECT_EQ(said(many, Wording::brief), "'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h' and 2 more repeat the place of an earlier pair.");
  EXPECT_EQ(said(many), "'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i' and 'j' repeat the place of an earlier pair.");
}

TEST(Remark, SaysItsFiguresInTheirPlaces) {
  EXPECT_EQ(said({RemarkCode::onePoseStandsOut, {3.14, 0.26, 0.82, 0.12, 33.06}}),
            "One pose stands out by a margin of 3.1, and halves of the overlap registered apart agree to 0.3 mm (correlation 0.82 over "
            "12 % overlap, z score 33.1).");
  EXPECT_EQ(said({RemarkCode::placesAgreeBut, {4, 0.84, 6.0, 2, 3}, {"stone", ""}}),
            "4 pairs agree within 0.8 mm (rms); 'stone' and number 3 do not fit, by 6 mm.");
  EXPECT_EQ(
      said({RemarkCode::motionRemains, {0.93, 2.44, 0.82, 0.88}}),
      "Residual motion that the deformation does not follow: at 93 % of the places that can tell, tissue lies elsewhere, by 2.4 mm in the "
      "mean (deformed, a correlation of 0.82 over 88 % of the smaller volume).");
  EXPECT_EQ(said({RemarkCode::twoReadings, {1, 1, 4}, {"fork", ""}}),
            "One can read the pairs in two ways: without 'fork', or without number 4. Add a pair or correct one.");
  EXPECT_EQ(messageOf(std::vector<Remark>{{RemarkCode::streaksTakenOut, {9.0, 13.2}}, {RemarkCode::placedByHand}}).english(),
            "Shadows and other streaks were taken out, which drew the volumes 9.0 mm and 13.2 degrees elsewhere. Placed by hand.");
}

/// Of images that correlate well over little and of those that correlate weakly the verdict is the same, "cannot tell"; the sentence says
/// which of the two it is, and what to do.
TEST(Remark, OfTooLittleEvidenceNeverContradictsItsFigures) {
  EXPECT_EQ(said({RemarkCode::bestHardlyBetter, {0.98, 0.66, 9.8}}),
            "In the best pose the images agree, but the overlap shows too little structure to rule out chance (correlation 0.98 over 66 % "
            "overlap, z score 9.8); look whether they fit, or give landmarks, a tracker's pose or more overlap.");
  EXPECT_EQ(said({RemarkCode::hardlyBetter, {0.98, 0.66, 7.8}}, Wording::brief),
            "The images agree, but the overlap shows too little structure to rule out chance; look whether they fit, or give landmarks, a "
            "tracker's pose or more overlap.");
  EXPECT_EQ(said({RemarkCode::bestHardlyBetter, {0.31, 0.66, 9.8}}),
            "In the best pose the images agree in part, and too little to rule out chance (correlation 0.31 over 66 % overlap, z score "
            "9.8); look whether they fit, or give landmarks, a tracker's pose or more overlap.");
  for (const RemarkCode what : {RemarkCode::overlapTooSmall, RemarkCode::hardlyBetter, RemarkCode::foundTooSmall,
                                RemarkCode::bestHardlyBetter, RemarkCode::onlyStreaksAgree})
    for (const double correlation : {0.3, 0.7, 0.98}) {
      const std::string sentence = said({what, {correlation, 0.66, 7.0}});
      EXPECT_EQ(sentence.find("unrelated"), std::string::npos) << sentence;
      EXPECT_NE(sentence.find("landmarks"), std::string::npos) << "says what to do: " << sentence;
    }
}

TEST(Remark, OfAResultIsWhatItsReasonSays) {
  std::vector<LandmarkPair> pairs;
  for (const glm::dvec3& p : {glm::dvec3{0, 0, 0}, {40, 0, 0}, {0, 30, 0}, {0, 0, 20}, {25, 20, 15}, {10, 5, 40}})
    pairs.push_back({"p" + std::to_string(pairs.size()), p, p});
  pairs[2].moving_mm.x += 25.0;
  pairs.push_back(pairs[0]);
  const auto found = registerLandmarks(pairs);
  ASSERT_TRUE(found) << found.error();
  ASSERT_EQ(found->remarks.size(), 2u) << found->reason;
  EXPECT_EQ(found->remarks[0].what, RemarkCode::placesAgreeBut);
  EXPECT_EQ(found->remarks[0].names, std::vector<std::string>{"p2"});
  EXPECT_EQ(found->remarks[1].what, RemarkCode::placesRepeat);
  EXPECT_EQ(found->reason, messageOf(found->remarks));
}

}  // namespace
}  // namespace ew::registration::remark_test
