#include "ew/labelling/label_edits.h"

#include <gtest/gtest.h>

#include "labelling/support.h"

namespace ew::labelling {
namespace {

using test::emptyLabels;

VoxelBox ballAt(Volume& labels, const glm::dvec3& at, double radius_mm, std::uint8_t label) {
  return paintBall(labels, {&at, 1}, radius_mm, {.label = label});
}

TEST(LabelEdits, GiveTheSameBitsBackStepByStep) {
  LabelEdits edits(emptyLabels({30, 30, 30}, glm::dvec3(1.0)));
  std::vector<std::vector<std::uint8_t>> states{edits.labels().echo};
  for (int n = 0; n < 6; ++n) {
    edits.edit("ball", [&](Volume& labels) { return ballAt(labels, {3.0 * n - 8.0, n, 0.0}, 5.0, static_cast<std::uint8_t>(n % 3)); });
    states.push_back(edits.labels().echo);
  }
  ASSERT_EQ(edits.steps(), 5u) << "erasing where nothing is is no step";
  states.erase(states.begin());
  for (std::size_t n = states.size() - 1; n-- > 0;) {
    edits.undo();
    EXPECT_EQ(edits.labels().echo, states[n]);
  }
  EXPECT_TRUE(edits.undoText().empty());
  for (std::size_t n = 1; n < states.size(); ++n) {
    edits.redo();
    EXPECT_EQ(edits.labels().echo, states[n]);
  }
}

TEST(LabelEdits, TakeAStrokeAsOneStep) {
  LabelEdits edits(emptyLabels({30, 30, 30}, glm::dvec3(1.0)));
  edits.open("stroke");
  for (int n = 0; n < 10; ++n) edits.edit("dab", [&](Volume& labels) { return ballAt(labels, {n, 0.0, 0.0}, 3.0, 1); });
  edits.close();
  EXPECT_EQ(edits.steps(), 1u);
  EXPECT_EQ(edits.undoText(), "stroke");
  edits.undo();
  EXPECT_EQ(voxelsOf(edits.labels(), 1), 0u);
  EXPECT_EQ(edits.redoText(), "stroke");
}

TEST(LabelEdits, ForgetTheOldestStepsBeyondTheirBound) {
  LabelEdits edits(emptyLabels({60, 60, 60}, glm::dvec3(1.0)), 9000);
  for (int n = 0; n < 40; ++n)
    edits.edit("ball", [&](Volume& labels) { return ballAt(labels, {n - 20.0, 0.0, 0.0}, 9.0, static_cast<std::uint8_t>(1 + n % 2)); });
  EXPECT_LE(edits.bytes(), 9000u);
  EXPECT_GT(edits.forgotten(), 0u);
  EXPECT_EQ(edits.steps(), 40u);
  const std::size_t kept = edits.steps() - edits.forgotten();
  EXPECT_GT(kept, 2u);
  for (std::size_t n = 0; n < kept; ++n) edits.undo();
  EXPECT_TRUE(edits.undoText().empty());
}

TEST(LabelEdits, DoNotCountStepsThatWereUndoneAndReplaced) {
  LabelEdits edits(emptyLabels({60, 60, 60}, glm::dvec3(1.0)), 9000);
  edits.edit("first", [](Volume& labels) { return ballAt(labels, glm::dvec3(-20.0), 3.0, 1); });
  for (int n = 0; n < 200; ++n) {
    edits.edit("ball", [](Volume& labels) { return ballAt(labels, glm::dvec3(0.0), 9.0, 2); });
    edits.undo();
  }
  EXPECT_EQ(edits.forgotten(), 0u);
  EXPECT_LE(edits.bytes(), 9000u);
  EXPECT_EQ(edits.undoText(), "first");
}

RC_GTEST_PROP(LabelEditsProperty, UndoingAllIsTheBeginningAndRedoingAllTheEnd, ()) {
  Volume begin = emptyLabels({12, 11, 13}, glm::dvec3(1.0));
  for (std::size_t n = 0; n < begin.echo.size(); ++n) begin.echo[n] = static_cast<std::uint8_t>(n * 7 % 4);
  LabelEdits edits(begin);
  const int count = *rc::gen::inRange(1, 12);
  for (int n = 0; n < count; ++n) {
    const glm::dvec3 at(*rc::gen::inRange(-7, 8), *rc::gen::inRange(-7, 8), *rc::gen::inRange(-7, 8));
    const int label = *rc::gen::inRange(0, 5), radius_mm = *rc::gen::inRange(0, 6);
    edits.edit("ball", [&](Volume& labels) { return ballAt(labels, at, radius_mm, static_cast<std::uint8_t>(label)); });
    if (*rc::gen::inRange(0, 4) == 0) edits.undo();
  }
  const std::vector<std::uint8_t> end = edits.labels().echo;
  const std::size_t steps = edits.steps();
  for (std::size_t n = 0; n < steps; ++n) edits.undo();
  RC_ASSERT(edits.labels().echo == begin.echo);
  for (std::size_t n = 0; n < steps; ++n) edits.redo();
  RC_ASSERT(edits.labels().echo == end);
}

}  // namespace
}  // namespace ew::labelling
