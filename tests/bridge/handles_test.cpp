#include "ew/bridge/handles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

namespace ew::bridge::handles_test {
namespace {

/// Of the whole range from the first try on, whatever the size.
double between(double low, double high) { return low + (high - low) * (*rc::gen::resize(100, rc::gen::inRange(0, 1'000'001))) / 1e6; }

glm::dvec3 anyDirection() {
  glm::dvec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
  if (glm::length(p) < 1e-2) p = {0.3, -0.8, 0.5};
  return glm::normalize(p);
}

HandlesToWorld anyPose() {
  glm::dmat4 pose = glm::translate(glm::dmat4(1.0), glm::dvec3(between(-300, 300), between(-300, 300), between(-300, 300)));
  return {glm::rotate(pose, between(-3.1, 3.1), anyDirection())};
}

glm::dvec3 originOf(const HandlesToWorld& pose) { return glm::dvec3(pose.matrix[3]); }
glm::dvec3 axisOf(const HandlesToWorld& pose, int axis) { return glm::dvec3(pose.matrix[axis]); }
Ray sight(const glm::dvec3& eye_mm, const glm::dvec3& at_mm) { return {eye_mm, glm::normalize(at_mm - eye_mm)}; }
glm::dvec3 onRing(const HandlesPlace& place, int axis, double angle_rad, double share = kRingShare) {
  return originOf(place.toWorld) +
         share * place.reach_mm *
             (std::cos(angle_rad) * axisOf(place.toWorld, (axis + 1) % 3) + std::sin(angle_rad) * axisOf(place.toWorld, (axis + 2) % 3));
}
double largestDifference(const HandlesToWorld& a, const HandlesToWorld& b) {
  double largest = 0.0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) largest = std::max(largest, std::abs(a.matrix[c][r] - b.matrix[c][r]));
  return largest;
}

RC_GTEST_PROP(AlongAxis, FindsThePointOfTheAxisThatIsLookedAt, ()) {
  const glm::dvec3 origin_mm(between(-300, 300), between(-300, 300), between(-300, 300)), axis = anyDirection();
  const glm::dvec3 eye_mm = origin_mm + between(500, 3000) * anyDirection();
  const double wanted_mm = between(-200, 200);
  const Ray ray = sight(eye_mm, origin_mm + wanted_mm * axis);
  const auto found = alongAxis_mm(ray, origin_mm, axis);
  if (glm::length(glm::cross(ray.direction, axis)) < 0.15) RC_DISCARD("nearly along the line of sight");
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(*found - wanted_mm) < 1e-6);
}

RC_GTEST_PROP(AlongAxis, IsTheNearestPointForALineThatPassesBeside, ()) {
  const glm::dvec3 axis = anyDirection();
  const Ray ray = sight(1000.0 * anyDirection(), 80.0 * anyDirection());
  const auto found = alongAxis_mm(ray, glm::dvec3(0.0), axis);
  if (!found || std::abs(*found) > 1999.0) RC_DISCARD("no answer, or cut off");
  const auto apart = [&](double along_mm) {
    const glm::dvec3 p = along_mm * axis - ray.from_mm;
    return glm::length(p - glm::dot(p, ray.direction) * ray.direction);
  };
  RC_ASSERT(apart(*found) <= apart(*found + 0.5) + 1e-9);
  RC_ASSERT(apart(*found) <= apart(*found - 0.5) + 1e-9);
}

TEST(AlongAxis, HasNoAnswerForAnAxisThatPointsAtTheViewer) {
  EXPECT_FALSE(alongAxis_mm(sight({0, -1000, 0}, {5, 0, 0}), glm::dvec3(0.0), {0, 1, 0}).has_value());
  EXPECT_TRUE(alongAxis_mm(sight({0, -1000, 0}, {5, 0, 0}), glm::dvec3(0.0), {1, 0, 0}).has_value());
}

RC_GTEST_PROP(AngleAbout, ReadsTheAngleOfThePointThatIsLookedAt, ()) {
  const HandlesPlace place{anyPose(), between(30, 150)};
  const int axis = *rc::gen::inRange(0, 3);
  const double wanted_rad = between(-3.1, 3.1);
  const Ray ray = sight(originOf(place.toWorld) + between(500, 3000) * anyDirection(), onRing(place, axis, wanted_rad));
  const auto found = angleAbout_rad(ray, originOf(place.toWorld), axisOf(place.toWorld, axis), axisOf(place.toWorld, (axis + 1) % 3));
  if (std::abs(glm::dot(ray.direction, axisOf(place.toWorld, axis))) < 0.22) RC_DISCARD("from the edge");
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(std::remainder(*found - wanted_rad, glm::two_pi<double>())) < 1e-6);
}

TEST(AngleAbout, HasNoAnswerFromTheEdgeOrBehindTheViewer) {
  EXPECT_FALSE(angleAbout_rad(sight({0, -1000, 0}, {5, 0, 1}), glm::dvec3(0.0), {0, 0, 1}, {1, 0, 0}).has_value());
  EXPECT_FALSE(angleAbout_rad({{0, 0, 500}, {0, 0, 1}}, glm::dvec3(0.0), {0, 0, 1}, {1, 0, 0}).has_value());
}

RC_GTEST_PROP(HandleDrag, PutsTheArrowWhereThePointerIs, ()) {
  const HandlesPlace place{anyPose(), 80.0};
  const Handle handle{Handle::Kind::move, *rc::gen::inRange(0, 3)};
  const glm::dvec3 axis = axisOf(place.toWorld, handle.axis), origin_mm = originOf(place.toWorld);
  const glm::dvec3 eye_mm = origin_mm + 1500.0 * anyDirection();
  if (!isUsable(place, handle, eye_mm)) RC_DISCARD("points at the viewer");
  const double grab_mm = between(15, 80), by_mm = between(-60, 60);
  HandleDrag drag(place, handle, sight(eye_mm, origin_mm + grab_mm * axis));
  drag.follow(sight(eye_mm, origin_mm + (grab_mm + 17.0) * axis));
  RC_ASSERT(std::abs(drag.follow(sight(eye_mm, origin_mm + (grab_mm + by_mm) * axis)) - by_mm) < 1e-6);
  HandlesToWorld expected = place.toWorld;
  expected.matrix[3] += glm::dvec4(by_mm * axis, 0.0);
  RC_ASSERT(largestDifference(drag.toWorld(), expected) < 1e-6);
  RC_ASSERT(checkRigid(drag.toWorld(), 1e-9).has_value());
}

RC_GTEST_PROP(HandleDrag, TurnsTheRingWithThePointerAndCountsWholeTurns, ()) {
  const HandlesPlace place{anyPose(), 80.0};
  const Handle handle{Handle::Kind::turn, *rc::gen::inRange(0, 3)};
  const glm::dvec3 axis = axisOf(place.toWorld, handle.axis), origin_mm = originOf(place.toWorld);
  // From a place from which the whole ring is seen.
  const glm::dvec3 eye_mm = origin_mm + 1500.0 * glm::normalize(axis + 0.5 * axisOf(place.toWorld, (handle.axis + 1) % 3)) *
                                            (*rc::gen::arbitrary<bool>() ? 1.0 : -1.0);
  const double begin_rad = between(-3.1, 3.1), by_rad = between(-9.0, 9.0);
  HandleDrag drag(place, handle, sight(eye_mm, onRing(place, handle.axis, begin_rad)));
  constexpr int kEvents = 12;
  for (int n = 1; n <= kEvents; ++n) drag.follow(sight(eye_mm, onRing(place, handle.axis, begin_rad + by_rad * n / kEvents)));
  RC_ASSERT(std::abs(drag.amount() - by_rad) < 1e-6);
  // The origin stays, the axis stays, and what was at the begin is now where the pointer is.
  RC_ASSERT(glm::distance(originOf(drag.toWorld()), origin_mm) < 1e-9);
  RC_ASSERT(glm::distance(axisOf(drag.toWorld(), handle.axis), axis) < 1e-9);
  const HandlesPlace now{drag.toWorld(), place.reach_mm};
  RC_ASSERT(glm::distance(onRing(now, handle.axis, begin_rad), onRing(place, handle.axis, begin_rad + by_rad)) < 1e-4);
}

TEST(HandleDrag, TurnsARingThatIsSeenFromItsEdgeTheWayThePointerGoes) {
  const HandlesPlace place{{}, 100.0};
  const glm::dvec3 eye_mm(0, -1500, 0);
  HandleDrag drag(place, {Handle::Kind::turn, 2}, sight(eye_mm, {0, -78, 0}));
  // What faces the viewer goes to the patient's left, +x, with the pointer: about +z.
  const double amount = drag.follow(sight(eye_mm, {20, -78, 0}));
  EXPECT_NEAR(amount, 20.0 / 78.0, 1e-9);
  EXPECT_GT(onRing({drag.toWorld(), 100.0}, 2, -glm::half_pi<double>()).x, 15.0);
}

TEST(HandleDrag, ComesBackToWhereItBeganAndGoesInSteps) {
  const HandlesPlace place{{glm::translate(glm::dmat4(1.0), glm::dvec3(10, 20, 30))}, 80.0};
  const glm::dvec3 eye_mm(10, -1500, 30);
  const Ray grabbed = sight(eye_mm, {50, 20, 30});
  HandleDrag drag(place, {Handle::Kind::move, 0}, grabbed);
  drag.follow(sight(eye_mm, {62.4, 20, 30}));
  EXPECT_EQ(drag.toWorld(1.0).matrix[3], glm::dvec4(22, 20, 30, 1));
  drag.follow(grabbed);
  EXPECT_NEAR(drag.amount(), 0.0, 1e-9);
  EXPECT_EQ(drag.toWorld(1.0), place.toWorld);
  EXPECT_NEAR(moved(place.toWorld, {Handle::Kind::turn, 1}, glm::half_pi<double>()).matrix[0].z, -1.0, 1e-12) << "about y, z goes to x";
}

/// A parallel view from the front: x to the right, z up.
glm::dvec2 fromTheFront(const glm::dvec3& p_mm) { return {400.0 + p_mm.x, 300.0 - p_mm.z}; }
const glm::dvec3 kFront_mm(0, -1e5, 0);

TEST(HandleAt, FindsArrowsAndRingsWhereTheyAreSeen) {
  const HandlesPlace place{{}, 100.0};
  const auto at = [&](double x, double z) { return handleAt(place, kFront_mm, fromTheFront({x, 0, z}), fromTheFront, 7.0); };
  EXPECT_EQ(at(95, 0), (Handle{Handle::Kind::move, 0}));
  EXPECT_EQ(at(0, 50), (Handle{Handle::Kind::move, 2}));
  const double slant = 78.0 / std::sqrt(2.0);
  EXPECT_EQ(at(-slant, slant), (Handle{Handle::Kind::turn, 1})) << "the ring in the plane of the screen";
  EXPECT_EQ(at(-60, 1), (Handle{Handle::Kind::turn, 2})) << "seen from its edge, where no arrow is";
  EXPECT_EQ(at(0, 0).value().kind, Handle::Kind::turn) << "rings seen from their edge; the arrow along the line of sight cannot be used";
  EXPECT_FALSE(at(30, 30).has_value());
  EXPECT_FALSE(at(150, 0).has_value());
}

TEST(HandlesReach, FollowsTheBoxAsFarAsItCanBeUsedOnTheScreen) {
  EXPECT_DOUBLE_EQ(handlesReach_mm(1.0, {80, 60, 0}), 80.0);
  EXPECT_DOUBLE_EQ(handlesReach_mm(1.0, {4, 3, 0}), 62.0);
  EXPECT_DOUBLE_EQ(handlesReach_mm(0.5, {800, 600, 0}), 60.0);
}

RC_GTEST_PROP(AxesAsSeen, AreEachAxisOnceAndPointTheWayTheyAreSeen, ()) {
  const HandlesToWorld pose = anyPose();
  const glm::dmat4 camera = anyPose().matrix;
  const std::array<glm::dvec3, 3> views{glm::dvec3(camera[0]), glm::dvec3(camera[1]), glm::dvec3(camera[2])};
  const ViewAxes seen = axesAsSeen(pose, views[0], views[1], views[2]);
  const std::array<AxisSense, 3> senses{seen.right, seen.up, seen.away};
  std::set<int> axes;
  double sum = 0.0, naive = 0.0;
  for (std::size_t n = 0; n < 3; ++n) {
    axes.insert(senses[n].axis);
    const double along = senses[n].sign * glm::dot(axisOf(pose, senses[n].axis), views[n]);
    RC_ASSERT(along >= 0.0);
    sum += along;
    naive += std::abs(glm::dot(axisOf(pose, static_cast<int>(n)), views[n]));
  }
  RC_ASSERT(axes.size() == 3u);
  RC_ASSERT(sum >= naive - 1e-9);
}

TEST(AxesAsSeen, OfAnUnturnedFrameFromTheFront) {
  const ViewAxes seen = axesAsSeen({}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  EXPECT_EQ(seen.right, (AxisSense{0, 1.0}));
  EXPECT_EQ(seen.up, (AxisSense{2, 1.0}));
  EXPECT_EQ(seen.away, (AxisSense{1, 1.0}));
  EXPECT_EQ(axesAsSeen({}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}).right, (AxisSense{0, -1.0})) << "from the back";
}

}  // namespace
}  // namespace ew::bridge::handles_test
