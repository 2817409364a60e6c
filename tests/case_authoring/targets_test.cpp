#include "logic/targets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "logic/tissues.h"

namespace ew::case_authoring {
namespace {

using nlohmann::json;

Case taught() {
  Case made;
  made.id = "a";
  made.title = "A";
  made.volume.file = "v.mha";
  made.targets = {pointTarget("bifurcation", {1.0, 2.0, 3.0}), structureTarget("stone", 4)};
  made.targets[0].otherFields["future"] = true;
  made.otherFields = json::parse(R"({"volume": {"future": 1}, "parts": {"lessons": {"format": 1, "lessons": [{"id": "l", "steps": [
      {"id": "1", "task": "point", "target": "stone"}, {"id": "2", "task": "free", "targets": ["bifurcation", "stone"]},
      {"id": "3", "task": "point", "target": "stone", "case": "another"}]}]}}})");
  return made;
}

TEST(Targets, AreRenamedTogetherWithTheStepsThatAskForThem) {
  const Case renamed = withTargetRenamed(taught(), 1, "gall stone");
  EXPECT_EQ(renamed.targets[1].name, "gall stone");
  EXPECT_EQ(stepsNaming(renamed, "gall stone"), 2u);
  EXPECT_EQ(stepsNaming(renamed, "stone"), 0u);
  EXPECT_EQ(renamed.otherFields["parts"]["lessons"]["lessons"][0]["steps"][2]["target"], "stone") << "that of another case";
}

TEST(Targets, OfOneNameKeepTheirSteps) {
  const Case twice = withTargetAdded(taught(), structureTarget("stone", 5));
  EXPECT_EQ(stepsNaming(withTargetRenamed(twice, 1, "first stone"), "stone"), 2u) << "the other may be meant";
}

TEST(Targets, KeepEverythingThatAnEditDoesNotName) {
  Case edited = withTarget(taught(), 0, [](CaseTarget& target) { target.tolerance_mm = 4.0; });
  EXPECT_EQ(edited.targets[0].tolerance_mm, 4.0);
  EXPECT_EQ(edited.targets[0].otherFields["future"], true);
  edited = withTargetMoved(edited, 0, 1);
  EXPECT_EQ(edited.targets[1].name, "bifurcation");
  EXPECT_EQ(edited.targets[1].otherFields["future"], true);
  edited = withoutTarget(withoutTarget(edited, 0), 0);
  EXPECT_TRUE(edited.targets.empty());
  EXPECT_EQ(edited.otherFields, taught().otherFields);
  EXPECT_EQ(targetAt(edited, 0), nullptr);
  EXPECT_EQ(withTarget(edited, 0, [](CaseTarget& target) { target.name = "nobody"; }), edited);
}

TEST(Targets, GetNamesAndNumbersThatNobodyHas) {
  EXPECT_EQ(freeTargetName(taught(), "stone"), "stone 2");
  EXPECT_EQ(freeTargetName(taught(), "Point"), "Point");
  Volume labels{{.dims = {4, 1, 1}}, {0, 1, 2, 3}, {}};
  EXPECT_EQ(freeLabel(taught(), &labels), 5);
  EXPECT_EQ(freeLabel(taught(), nullptr), 1);
  EXPECT_EQ(freeLabel(withTissue(taught(), 1, "bone", 7), nullptr), 2);
  labels.echo.resize(256);
  for (int n = 0; n < 256; ++n) labels.echo[static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(n);
  EXPECT_EQ(freeLabel(taught(), &labels), 0);
}

TEST(Tissues, OfALabelSwitchShadowsOnAndComeBack) {
  for (std::size_t n = 0; n < namedTissues().size(); ++n) {
    const Case with = withTissue(taught(), 4, "stone", n);
    EXPECT_EQ(tissueOf(with, 4), n);
    EXPECT_TRUE(with.scene.attenuation);
    const Case changed = withTissue(with, 4, "stone", (n + 1) % namedTissues().size());
    EXPECT_EQ(changed.scene.tissues.size(), 1u);
    EXPECT_FALSE(hasTissue(withTissue(with, 4, "stone", {}), 4));
  }
  Case own = withTissue(taught(), 4, "stone", 5);
  own.scene.tissues[0].reflection_db = 11.0;
  EXPECT_FALSE(tissueOf(own, 4));
  EXPECT_TRUE(hasTissue(own, 4));
}

RC_GTEST_PROP(TargetsProperty, MovingAndMovingBackIsNothing, ()) {
  Case made = taught();
  const int count = *rc::gen::inRange(2, 9);
  for (int n = 2; n < count; ++n) made = withTargetAdded(made, structureTarget("s" + std::to_string(n), n + 10));
  const auto from = static_cast<std::size_t>(*rc::gen::inRange(0, count)), to = static_cast<std::size_t>(*rc::gen::inRange(0, count));
  const Case moved = withTargetMoved(made, from, to);
  RC_ASSERT(moved.targets[to] == made.targets[from]);
  RC_ASSERT(withTargetMoved(moved, to, from) == made);
}

}  // namespace
}  // namespace ew::case_authoring
