#include "logic/targets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "logic/edits.h"
#include "logic/tissues.h"

namespace ew::case_authoring {
namespace {

using nlohmann::json;

json taught() {
  return json::parse(R"({"id": "a", "title": "A", "volume": {"file": "v.mha", "future": 1},
    "targets": [{"kind": "point", "name": "bifurcation", "at_mm": [1, 2, 3], "future": true}, {"kind": "structure", "name": "stone", "label": 4}],
    "parts": {"lessons": {"format": 1, "lessons": [{"id": "l", "steps": [
      {"id": "1", "task": "point", "target": "stone"}, {"id": "2", "task": "free", "targets": ["bifurcation", "stone"]},
      {"id": "3", "task": "point", "target": "stone", "case": "another"}]}]}}})");
}

TEST(Targets, AreRenamedTogetherWithTheStepsThatAskForThem) {
  const json renamed = withTargetRenamed(taught(), 1, "gall stone");
  EXPECT_EQ(textOf(targetAt(renamed, 1), "name"), "gall stone");
  EXPECT_EQ(stepsNaming(renamed, "gall stone"), 2u);
  EXPECT_EQ(stepsNaming(renamed, "stone"), 0u);
  EXPECT_EQ(renamed["parts"]["lessons"]["lessons"][0]["steps"][2]["target"], "stone") << "that of another case";
}

TEST(Targets, OfOneNameKeepTheirSteps) {
  const json twice = withTargetAdded(taught(), structureTarget("stone", 5));
  EXPECT_EQ(stepsNaming(withTargetRenamed(twice, 1, "first stone"), "stone"), 2u) << "the other may be meant";
}

TEST(Targets, KeepEverythingThatAnEditDoesNotName) {
  json edited = withTarget(taught(), 0, withField(targetAt(taught(), 0), "tolerance_mm", 4.0));
  EXPECT_EQ(targetAt(edited, 0)["future"], true);
  edited = withTargetMoved(edited, 0, 1);
  EXPECT_EQ(textOf(targetAt(edited, 1), "name"), "bifurcation");
  EXPECT_EQ(targetAt(edited, 1)["future"], true);
  edited = withoutTarget(withoutTarget(edited, 0), 0);
  EXPECT_FALSE(edited.contains("targets"));
  EXPECT_EQ(edited["volume"]["future"], 1);
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

TEST(Targets, PlacesComeBackAsTheyWereGiven) {
  const Transform<frame::File, frame::Probe> plane{
      glm::rotate(glm::translate(glm::dmat4(1.0), {3.0, -4.0, 5.5}), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -1.0)))};
  EXPECT_EQ(*planeOf(planeTarget("p", plane)), plane);
  EXPECT_EQ(*pointOf(pointTarget("p", {1.5, -2.25, 3.0})), glm::dvec3(1.5, -2.25, 3.0));
  EXPECT_FALSE(pointOf(structureTarget("s", 3)));
  EXPECT_EQ(labelOf(structureTarget("s", 3)), 3);
}

TEST(Tissues, OfALabelSwitchShadowsOnAndComeBack) {
  for (std::size_t n = 0; n < namedTissues().size(); ++n) {
    const json with = withTissue(taught(), 4, "stone", n);
    EXPECT_EQ(tissueOf(with, 4), n);
    EXPECT_TRUE(hasEffect(with, "scene.attenuation"));
    const json changed = withTissue(with, 4, "stone", (n + 1) % namedTissues().size());
    EXPECT_EQ(changed["scene"]["tissues"].size(), 1u);
    EXPECT_FALSE(hasTissue(withTissue(with, 4, "stone", {}), 4));
  }
  json own = withTissue(taught(), 4, "stone", 5);
  own["scene"]["tissues"][0]["reflection_db"] = 11.0;
  EXPECT_FALSE(tissueOf(own, 4));
  EXPECT_TRUE(hasTissue(own, 4));
}

RC_GTEST_PROP(TargetsProperty, MovingAndMovingBackIsNothing, ()) {
  json manifest = taught();
  const int count = *rc::gen::inRange(2, 9);
  for (int n = 2; n < count; ++n) manifest = withTargetAdded(manifest, structureTarget("s" + std::to_string(n), n + 10));
  const auto from = static_cast<std::size_t>(*rc::gen::inRange(0, count)), to = static_cast<std::size_t>(*rc::gen::inRange(0, count));
  const json moved = withTargetMoved(manifest, from, to);
  RC_ASSERT(targetAt(moved, to) == targetAt(manifest, from));
  RC_ASSERT(withTargetMoved(moved, to, from) == manifest);
}

}  // namespace
}  // namespace ew::case_authoring
