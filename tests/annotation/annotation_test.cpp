#include "ew/annotation/annotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ew::annotation::annotation_test {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A text of 20 x 4 mm, written towards -x of the plane, as where the marker is at the left.
TextSize leftward(const Annotation&) { return {{20.0, 4.0}, -1.0}; }

AnnotationList textAndArrow() {
  AnnotationList list;
  list.addText({-10.0, 30.0}, "RT KIDNEY");
  list.addArrow({5.0, 40.0}, {15.0, 60.0});
  return list;
}

TEST(AnnotationList, KeepsTextsAndArrowsWithTheirPlacesAndNumbers) {
  const AnnotationList list = textAndArrow();
  ASSERT_EQ(list.now().all.size(), 2u);
  EXPECT_EQ(list.now().all[0], (Annotation{1, AnnotationKind::text, {-10.0, 30.0}, {-10.0, 30.0}, "RT KIDNEY"}));
  EXPECT_EQ(list.now().all[1], (Annotation{2, AnnotationKind::arrow, {15.0, 60.0}, {5.0, 40.0}, {}}));
  EXPECT_EQ(list.now().nextNumber, 3);
  EXPECT_EQ(list.now().find(2), &list.now().all[1]);
  EXPECT_EQ(list.now().find(3), nullptr);
}

TEST(AnnotationList, MakesOneTidyLineOfWhatIsTyped) {
  AnnotationList list;
  const auto said = [&](std::string_view typed) {
    const int number = list.addText({0.0, 0.0}, typed);
    return number == 0 ? std::string("nothing") : list.now().find(number)->text;
  };
  EXPECT_EQ(said("  LIVER \t  RT\nLOBE \r\n"), "LIVER RT LOBE");
  EXPECT_EQ(said("NIERE LÄNGS"), "NIERE LÄNGS");
  EXPECT_EQ(said(std::string("A\x01\x1B\x7F") + "B"), "AB");
  EXPECT_EQ(said(" \n\t "), "nothing");
  // Cut in front of a letter: Ä has two bytes, so that 200 bytes would end within the hundredth one.
  std::string letters = "x";
  for (int n = 0; n < 150; ++n) letters += "Ä";
  EXPECT_EQ(said(letters), letters.substr(0, 199));
}

TEST(AnnotationList, TakesNothingThatHasNoPlaceOrNoLength) {
  AnnotationList list;
  EXPECT_EQ(list.addText({kNoNumber, 0.0}, "LIVER"), 0);
  EXPECT_EQ(list.addText({2e6, 0.0}, "LIVER"), 0);
  EXPECT_EQ(list.addArrow({0.0, 0.0}, {0.3, 0.3}), 0);
  EXPECT_EQ(list.addArrow({0.0, 0.0}, {kNoNumber, 10.0}), 0);
  EXPECT_FALSE(list.canUndo());
  for (std::size_t n = 0; n < kMostAnnotations; ++n) ASSERT_NE(list.addText({0.0, 0.0}, "A"), 0);
  EXPECT_EQ(list.addText({0.0, 0.0}, "one more"), 0);
  EXPECT_EQ(list.addArrow({0.0, 0.0}, {0.0, 9.0}), 0);
}

TEST(AnnotationList, MovesAWholeOrAnEndAndTakesADragBackInOneStep) {
  AnnotationList list = textAndArrow();
  EXPECT_TRUE(list.move(1, AnnotationPart::whole, {1.0, 0.0}));
  for (int n = 0; n < 9; ++n) EXPECT_TRUE(list.move(1, AnnotationPart::whole, {1.0, 0.5}, Change::goesOn));
  EXPECT_EQ(list.now().find(1)->at_mm, glm::dvec2(0.0, 34.5));
  EXPECT_TRUE(list.undo());
  EXPECT_EQ(list.now().find(1)->at_mm, glm::dvec2(-10.0, 30.0));
  EXPECT_TRUE(list.redo());
  EXPECT_EQ(list.now().find(1)->at_mm, glm::dvec2(0.0, 34.5));

  EXPECT_TRUE(list.move(2, AnnotationPart::tip, {1.0, 2.0}));
  EXPECT_EQ(list.now().find(2)->at_mm, glm::dvec2(16.0, 62.0));
  EXPECT_EQ(list.now().find(2)->tail_mm, glm::dvec2(5.0, 40.0));
  EXPECT_TRUE(list.move(2, AnnotationPart::tail, {0.0, 2.0}));
  EXPECT_EQ(list.now().find(2)->tail_mm, glm::dvec2(5.0, 42.0));
  EXPECT_TRUE(list.move(2, AnnotationPart::whole, {-1.0, 0.0}));
  EXPECT_EQ(list.now().find(2)->at_mm - list.now().find(2)->tail_mm, glm::dvec2(11.0, 20.0));

  const auto before = list.kept();
  EXPECT_FALSE(list.move(2, AnnotationPart::tip, {-11.0, -20.0})) << "its tip would lie on its tail";
  EXPECT_FALSE(list.move(1, AnnotationPart::tip, {1.0, 1.0})) << "a text has no ends";
  EXPECT_FALSE(list.move(1, AnnotationPart::whole, {kNoNumber, 0.0}));
  EXPECT_FALSE(list.move(7, AnnotationPart::whole, {1.0, 0.0}));
  EXPECT_EQ(list.kept(), before) << "nothing of this is a step";
}

TEST(AnnotationList, ChangesAndRemovesWordsAsTheyAreTyped) {
  AnnotationList list;
  const int number = list.addText({0.0, 0.0}, "RT KIDNEY LONG");
  EXPECT_FALSE(list.setText(number, " RT KIDNEY LONG ")) << "it says so already";
  EXPECT_TRUE(list.removeLastWord(number));
  EXPECT_EQ(list.now().find(number)->text, "RT KIDNEY");
  EXPECT_TRUE(list.setText(number, "LT KIDNEY"));
  EXPECT_TRUE(list.removeLastWord(number));
  EXPECT_TRUE(list.removeLastWord(number));
  EXPECT_TRUE(list.now().all.empty());
  EXPECT_FALSE(list.removeLastWord(number));
  EXPECT_TRUE(list.undo());
  EXPECT_EQ(list.now().find(number)->text, "LT");
  EXPECT_TRUE(list.setText(number, "  "));
  EXPECT_TRUE(list.now().all.empty());
}

TEST(AnnotationList, NeverGivesANumberTwice) {
  AnnotationList list = textAndArrow();
  EXPECT_TRUE(list.clear());
  EXPECT_FALSE(list.clear());
  EXPECT_EQ(list.addText({0.0, 0.0}, "LIVER"), 3);
  EXPECT_TRUE(list.remove(3));
  EXPECT_EQ(list.addArrow({0.0, 0.0}, {0.0, 5.0}), 4);
}

TEST(AnnotationNear, FindsATextInItsBoxAndTheEndsOfAnArrowBeforeItsShaft) {
  const AnnotationList list = textAndArrow();
  const auto found = [&](glm::dvec2 at_mm) { return annotationNear(list.now(), at_mm, 1.0, leftward); };
  // The text begins at x = -10 and is written towards -x.
  for (const glm::dvec2 inside : {glm::dvec2(-10.0, 30.0), glm::dvec2(-29.9, 31.9), glm::dvec2(-20.0, 28.1)}) {
    ASSERT_TRUE(found(inside));
    EXPECT_EQ(found(inside)->number, 1);
    EXPECT_EQ(found(inside)->distance_mm, 0.0);
  }
  EXPECT_FALSE(found({-8.5, 30.0}));
  EXPECT_FALSE(found({-20.0, 33.5}));
  EXPECT_TRUE(found({-9.5, 30.0})) << "half a millimetre beside it, within reach";

  ASSERT_TRUE(found({10.0, 50.0}));
  EXPECT_EQ(found({10.0, 50.0})->part, AnnotationPart::whole);
  EXPECT_EQ(found({14.6, 59.2})->part, AnnotationPart::tip) << "on the shaft, and within reach of the tip";
  EXPECT_EQ(found({5.0, 40.5})->part, AnnotationPart::tail);
  EXPECT_FALSE(found({12.0, 50.0}));
}

TEST(AnnotationNear, TakesTheNewerOneOfTwoOnEachOther) {
  AnnotationList list;
  list.addText({0.0, 0.0}, "LIVER");
  list.addText({0.0, 0.0}, "LIVER");
  EXPECT_EQ(annotationNear(list.now(), {-1.0, 0.0}, 1.0, leftward)->number, 2);
}

TEST(HomePosition, LiesWithinTheImage) {
  EXPECT_EQ(limited({{1.5, -0.2}}).share, glm::dvec2(1.0, 0.0));
  EXPECT_EQ(limited({{kNoNumber, 0.3}}).share, glm::dvec2(HomePosition().share.x, 0.3));
}

}  // namespace
}  // namespace ew::annotation::annotation_test
