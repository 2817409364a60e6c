#include "ew/measurement/snap_target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measurement/calipers.h"

namespace ew::measurement::snap_target_test {
namespace {

Measurements withCross(glm::dvec2 at) {
  MeasurementList list;
  list.add(test::caliper(CaliperKind::distance, {at, at + glm::dvec2(40.0, 3.0)}));
  return list.now();
}

/// Dark above 30 mm, bright below; 0.25 mm a pixel, the face in the middle of the upper border.
struct Edge {
  GreyImage image{320, 240};
  DisplayGeometry geometry;
  Edge(bool markerLeft, bool upsideDown) {
    geometry = {320, 240, 0.25, {160.0, upsideDown ? 239.0 : 0.0}, markerLeft, upsideDown, 60.0};
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        const double depth_mm = 0.25 * (upsideDown ? 239 - y : y);
        viewOf(image).row(y)[x] = depth_mm < 30.0 ? 20 : 200;
      }
  }
};

TEST(SnapTarget, ACrossComesBeforeAllElseAndIsTakenExactly) {
  const Measurements shown = withCross({5.0, 30.0});
  const Edge edge(true, false);
  const auto view = viewOf(std::as_const(edge.image));
  const SnapTarget target = snapTarget({5.8, 30.9}, shown, {}, {}, view, edge.geometry);
  EXPECT_EQ(target, (SnapTarget{SnapKind::point, {5.0, 30.0}, 1}));
  SnapSearch own;
  own.except = 1;
  EXPECT_EQ(snapTarget({5.8, 30.9}, shown, {}, own, view, edge.geometry).kind, SnapKind::edge);
  EXPECT_EQ(snapTarget({5.0, 33.0}, shown, {}, {}).kind, SnapKind::none);  // beyond the reach
}

TEST(SnapTarget, AnEdgeIsFoundAlongTheLineHoweverTheImageIsTurned) {
  for (const bool markerLeft : {true, false})
    for (const bool upsideDown : {true, false}) {
      const Edge edge(markerLeft, upsideDown);
      const auto view = viewOf(std::as_const(edge.image));
      const SnapTarget first = snapTarget({12.0, 29.0}, {}, {}, {}, view, edge.geometry);
      EXPECT_EQ(first.kind, SnapKind::edge);
      EXPECT_DOUBLE_EQ(first.at.x, 12.0);
      EXPECT_NEAR(first.at.y, 29.875, 0.02);  // between the last dark pixel and the first bright one
      const glm::dvec2 from(0.0, 10.0);
      const SnapTarget along = snapTarget({11.5, 29.0}, {}, {&from, 1}, {}, view, edge.geometry);
      EXPECT_EQ(along.kind, SnapKind::edge);
      EXPECT_NEAR((along.at.x - from.x) / (along.at.y - from.y), 11.5 / 19.0, 1e-9);  // on the line that is drawn
      EXPECT_NEAR(along.at.y, 29.875, 0.1);
    }
}

TEST(SnapTarget, LevelAndPlumbAreThoseOfThePointBefore) {
  const glm::dvec2 from(10.0, 50.0);
  EXPECT_EQ(snapTarget({40.0, 50.5}, {}, {&from, 1}, {}), (SnapTarget{SnapKind::horizontal, {40.0, 50.0}, 0}));
  EXPECT_EQ(snapTarget({9.5, 20.0}, {}, {&from, 1}, {}), (SnapTarget{SnapKind::vertical, {10.0, 20.0}, 0}));
  EXPECT_EQ(snapTarget({40.0, 20.0}, {}, {&from, 1}, {}).kind, SnapKind::none);
  EXPECT_EQ(snapTarget({10.5, 50.5}, {}, {&from, 1}, {}).kind, SnapKind::none);  // on the point itself nothing is level
  EXPECT_EQ(snapTarget({40.0, 50.5}, {}, {}, {}).kind, SnapKind::none);
}

TEST(SnapTarget, InAStripNearIsWhatIsNearOnTheScreen) {
  SnapSearch search;
  search.scale = {80.0, 1.0};  // a second is as wide as 80 mm
  MeasurementList list;
  list.add({CaliperKind::interval, {{0, {{1.0, 30.0}, {2.0, 30.0}}}}});
  EXPECT_EQ(snapTarget({1.02, 30.5}, list.now(), {}, search).kind, SnapKind::point);
  EXPECT_EQ(snapTarget({1.1, 30.5}, list.now(), {}, search).kind, SnapKind::none);  // 8 mm
  const glm::dvec2 from(3.0, 60.0);
  EXPECT_EQ(snapTarget({3.005, 90.0}, {}, {&from, 1}, search), (SnapTarget{SnapKind::vertical, {3.0, 90.0}, 0}));
}

}  // namespace
}  // namespace ew::measurement::snap_target_test
