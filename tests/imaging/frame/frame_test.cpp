#include "ew/imaging/frame.h"
#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "ew/imaging/effects/gain.h"
#include "imaging/support/count_allocations.h"
#include "imaging/support/support.h"

namespace ew::frame_test {
namespace {

Probe convexProbe() {
  Probe probe;
  probe.name = "convex";
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 55.0;
  probe.halfAngle_rad = 32.0 * std::numbers::pi / 180.0;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 240.0;
  probe.defaultDepth_mm = 150.0;
  return probe;
}

Probe linearProbe() {
  Probe probe;
  probe.name = "linear";
  return probe;
}

bool isInFan(const Probe& probe, double depth_mm, const glm::dvec3& p, double slack_mm) {
  if (probe.kind == ProbeKind::linear)
    return std::abs(p.x) <= 0.5 * probe.width_mm + slack_mm && p.y >= -slack_mm && p.y <= depth_mm + slack_mm;
  const double fromCentre_mm = p.y + probe.radius_mm;
  const double radius_mm = std::hypot(p.x, fromCentre_mm);
  const double beyondEdge_mm = std::abs(p.x) * std::cos(probe.halfAngle_rad) - fromCentre_mm * std::sin(probe.halfAngle_rad);
  return radius_mm >= probe.radius_mm - slack_mm && radius_mm <= probe.radius_mm + depth_mm + slack_mm && beyondEdge_mm <= slack_mm;
}

/// A bright ball-and-ramp volume around the origin of the world, which the probe looks into from y = -60.
Volume bodyVolume() {
  Volume volume = testing::volumeOf({120, 160, 100}, [](int i, int j, int k) { return 40 + i + j / 2.0 + (k % 7); }, {1.5, 1.2, 1.8});
  volume.grid.origin_mm = {-89.25, -60.0, -89.1};
  return volume;
}

Pose poseAt(const glm::dvec3& origin_mm, double rotation_rad = 0.0) {
  Pose pose;
  pose.probeToWorld.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), origin_mm), rotation_rad, glm::dvec3(0.2, 1.0, 0.1));
  return pose;
}

TEST(FitDisplay, ShowsTheWholeFanAndTouchesTheMarginsOnOneAxis) {
  for (const Probe& probe : {convexProbe(), linearProbe()})
    for (const auto& [width, height] : {std::pair{640, 480}, std::pair{480, 640}, std::pair{1200, 300}}) {
      const DisplayGeometry geometry = fitDisplay(probe, {}, width, height);
      EXPECT_EQ(geometry.depth_mm, probe.defaultDepth_mm);
      glm::dvec2 lowest(1e9), highest(-1e9);
      for (const glm::dvec2& p : fanOutline_mm(probe, {}, geometry.depth_mm)) {
        const glm::dvec2 px = geometry.face_px + p / geometry.pixel_mm;
        lowest = glm::min(lowest, px);
        highest = glm::max(highest, px);
      }
      EXPECT_GE(lowest.x, 0.0);
      EXPECT_GE(lowest.y, 0.0);
      EXPECT_LE(highest.x, width - 1.0);
      EXPECT_LE(highest.y, height - 1.0);
      const glm::dvec2 used = (highest - lowest) / glm::dvec2(width, height);
      EXPECT_NEAR(std::max(used.x, used.y), 0.96, 0.01);
    }
}

TEST(FitDisplay, ZoomsAboutTheMiddleOfTheImage) {
  Knobs knobs;
  const DisplayGeometry whole = fitDisplay(convexProbe(), knobs, 600, 500);
  knobs.zoom = 3.0;
  const DisplayGeometry zoomed = fitDisplay(convexProbe(), knobs, 600, 500);
  EXPECT_NEAR(zoomed.pixel_mm, whole.pixel_mm / 3.0, 1e-9);
  const Point<frame::Image> middle{{299.5, 249.5, 0.0}};
  const glm::dvec3 before = (whole.imageToProbe() * middle).at, after = (zoomed.imageToProbe() * middle).at;
  EXPECT_NEAR(glm::length(before - after), 0.0, 1e-9);
}

TEST(FitDisplay, ShowsThePannedPointInTheMiddleOfAZoomedImageAndNothingBesideTheFan) {
  for (const bool markerLeft : {true, false})
    for (const bool upsideDown : {true, false}) {
      Knobs knobs;
      knobs.markerLeft = markerLeft;
      knobs.upsideDown = upsideDown;
      const auto fitted = [&](const Pan& pan) { return fitDisplay(convexProbe(), knobs, 600, 500, pan); };
      const Point<frame::Image> middle{{299.5, 249.5, 0.0}};
      const glm::dvec3 whole = (fitted({}).imageToProbe() * middle).at;
      EXPECT_EQ(fitted({12.0, -20.0}), fitted({})) << "there is nothing to pan over";
      knobs.zoom = 4.0;
      const glm::dvec3 shown = (fitted({12.0, -20.0}).imageToProbe() * middle).at;
      EXPECT_NEAR(shown.x - whole.x, 12.0, fitted({}).pixel_mm) << "in whole pixels";
      EXPECT_NEAR(shown.y - whole.y, -20.0, 1e-9);
      const Pan usable = panWithinFan(convexProbe(), knobs, {900.0, 900.0});
      EXPECT_LT(usable.lateral_mm, 100.0);
      EXPECT_EQ(fitted({900.0, 900.0}), fitted(usable));
      EXPECT_EQ(fitted({std::nan(""), 0.0}), fitted({}));
      const Spans spans = fanSpans(convexProbe(), knobs, fitted(usable));
      EXPECT_TRUE(std::any_of(spans.begin(), spans.end(), [](const auto& row) { return !row.empty(); }))
          << "a corner of the fan is still shown";
    }
}

TEST(FitDisplay, KeepsTheDepthWithinTheProbesRange) {
  Knobs knobs;
  knobs.depth_mm = 1000.0;
  EXPECT_EQ(fitDisplay(convexProbe(), knobs, 100, 100).depth_mm, 240.0);
  knobs.depth_mm = 1.0;
  EXPECT_EQ(fitDisplay(convexProbe(), knobs, 100, 100).depth_mm, 40.0);
}

TEST(FanSpans, HoldExactlyThePixelsInsideTheFan) {
  EXPECT_TRUE(rc::check("spans", [] {
    Probe probe = *rc::gen::arbitrary<bool>() ? convexProbe() : linearProbe();
    if (probe.kind == ProbeKind::convex) {
      probe.radius_mm = *rc::gen::inRange(5, 100);
      probe.halfAngle_rad = *rc::gen::inRange(5, 84) * std::numbers::pi / 180.0;
    }
    Knobs knobs;
    knobs.zoom = *rc::gen::inRange(100, 800) / 100.0;
    knobs.markerLeft = *rc::gen::arbitrary<bool>();
    const DisplayGeometry geometry = fitDisplay(probe, knobs, *rc::gen::inRange(1, 200), *rc::gen::inRange(1, 200));
    const Spans spans = fanSpans(probe, {}, geometry);
    RC_ASSERT(spans.size() == static_cast<std::size_t>(geometry.height));
    for (int y = 0; y < geometry.height; ++y) {
      std::vector<bool> inside(static_cast<std::size_t>(geometry.width), false);
      int after = 0;
      for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
        RC_ASSERT(span.begin >= after && span.begin < span.end && span.end <= geometry.width);
        after = span.end;
        for (int x = span.begin; x < span.end; ++x) inside[static_cast<std::size_t>(x)] = true;
      }
      for (int x = 0; x < geometry.width; ++x) {
        const glm::dvec3 p = (geometry.imageToProbe() * Point<frame::Image>{{x, y, 0}}).at;
        const bool spanned = inside[static_cast<std::size_t>(x)];
        RC_ASSERT(isInFan(probe, geometry.depth_mm, p, spanned ? 1e-9 : -1e-9) == spanned);
      }
    }
  }));
}

TEST(FanSpans, OfAConvexFaceHaveTwoRunsAboveItsForemostPoint) {
  const DisplayGeometry geometry = fitDisplay(convexProbe(), {}, 640, 480);
  const Spans spans = fanSpans(convexProbe(), {}, geometry);
  EXPECT_EQ(spans[static_cast<std::size_t>(geometry.face_px.y) - 2].size(), 2U);
  EXPECT_EQ(spans[static_cast<std::size_t>(geometry.face_px.y) + 2].size(), 1U);
}

TEST(FanOutline, IsClosedAndLiesOnTheFansEdge) {
  for (const Probe& probe : {convexProbe(), linearProbe()}) {
    const auto outline = fanOutline_mm(probe, {}, 120.0, 32);
    EXPECT_EQ(outline.front(), outline.back());
    for (const glm::dvec2& p : outline) {
      EXPECT_TRUE(isInFan(probe, 120.0, {p, 0.0}, 1e-9));
      EXPECT_FALSE(isInFan(probe, 120.0, {p, 0.0}, -1e-6));
    }
  }
}

TEST(FrameMaker, ShowsTheVolumeInsideTheFanAndBlackOutside) {
  const Volume volume = bodyVolume();
  FrameMaker maker;
  maker.configure(convexProbe(), {}, {}, volume.grid, 320, 280);
  const Pose pose = poseAt({3.0, -55.0, 4.0}, 0.3);
  const auto image = maker.make(volume.view(), pose).grey;
  EXPECT_EQ(maker.lastStatus(), PoseStatus::ok);
  GreyImage whole(320, 280);
  SliceScratch scratch;
  slice(Quality::linear, volume.view(), volume.grid.worldToVoxel() * pose.probeToWorld * maker.geometry().imageToProbe(), viewOf(whole),
        scratch);
  int shown = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 p = (maker.geometry().imageToProbe() * Point<frame::Image>{{x, y, 0}}).at;
      const bool surelyInside = isInFan(convexProbe(), maker.geometry().depth_mm, p, -1e-9);
      if (!surelyInside && isInFan(convexProbe(), maker.geometry().depth_mm, p, 1e-9)) continue;
      ASSERT_EQ(image.at(x, y), surelyInside ? viewOf(whole).at(x, y) : 0);
      shown += image.at(x, y) > 0;
    }
  EXPECT_GT(shown, 10000);
}

TEST(FrameMaker, AppliesEquationFiveAtTheDepthOfEachRow) {
  const Volume volume = bodyVolume();
  Knobs neutral, turned;
  turned.gain = 1.4;
  turned.dgc = {0.4, 0.6, 1.2, 2.0, 1.0, 0.3, 0.8, 1.5};
  FrameMaker plain, amplified;
  plain.configure(convexProbe(), neutral, {}, volume.grid, 200, 220);
  amplified.configure(convexProbe(), turned, {}, volume.grid, 200, 220);
  const auto before = plain.make(volume.view(), poseAt({0, -58, 0})).grey;
  const auto after = amplified.make(volume.view(), poseAt({0, -58, 0})).grey;
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x) {
      const double depth = (plain.geometry().imageToProbe() * Point<frame::Image>{{x, y, 0}}).at.y / plain.geometry().depth_mm;
      const double factor = dgcAt(turned.dgc, std::clamp(depth, 0.0, 1.0));
      ASSERT_NEAR(after.at(x, y), std::min(1.4 * std::min(factor * before.at(x, y), 255.0), 255.0), 0.501);
    }
}

TEST(FitDisplay, PutsTheMarkedSideAtTheLeftUnlessAskedOtherwise) {
  const DisplayGeometry usual = fitDisplay(convexProbe(), {}, 101, 90);
  EXPECT_TRUE(usual.markerLeft);
  EXPECT_GT((usual.imageToProbe() * Point<frame::Image>{{0, 45, 0}}).at.x, 0.0) << "+x of the probe is its marked side";
  const DisplayGeometry other = fitDisplay(convexProbe(), {.markerLeft = false}, 101, 90);
  EXPECT_LT((other.imageToProbe() * Point<frame::Image>{{0, 45, 0}}).at.x, 0.0);
}

TEST(FrameMaker, ShowsTheBrightSideWhereTheMarkerIs) {
  Volume volume = bodyVolume();
  const Grid& grid = volume.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double x_mm = (grid.voxelToWorld() * Point<frame::Voxel>{{i, j, k}}).at.x;
        volume.echo[grid.indexOf(i, j, k)] = x_mm > 0.0 ? 200 : 50;
      }
  for (const bool markerLeft : {true, false}) {
    FrameMaker maker;
    maker.configure(linearProbe(), {.markerLeft = markerLeft}, {}, grid, 101, 90);
    const auto image = maker.make(volume.view(), poseAt({0, -50, 0})).grey;
    EXPECT_EQ(image.at(35, 45), markerLeft ? 200 : 50);
    EXPECT_EQ(image.at(65, 45), markerLeft ? 50 : 200);
  }
}

TEST(FrameMaker, MirrorsTheImageWhenTheMarkerChangesSides) {
  const Volume volume = bodyVolume();
  Knobs knobs;
  FrameMaker straight, mirrored;
  straight.configure(linearProbe(), knobs, {}, volume.grid, 101, 90);
  knobs.markerLeft = false;
  mirrored.configure(linearProbe(), knobs, {}, volume.grid, 101, 90);
  const auto a = straight.make(volume.view(), poseAt({0, -50, 0}, 0.2)).grey;
  const auto b = mirrored.make(volume.view(), poseAt({0, -50, 0}, 0.2)).grey;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) ASSERT_NEAR(a.at(x, y), b.at(a.width - 1 - x, y), 1);
}

TEST(FrameMaker, GivesABlackImageAndTheReasonForAPoseThatCannotBeUsed) {
  const Volume volume = bodyVolume();
  FrameMaker maker;
  maker.configure(convexProbe(), {}, {}, volume.grid, 64, 64);
  const auto isBlack = [&](const Pose& pose) {
    maker.make(volume.view(), poseAt({0, -50, 0}));
    const auto image = maker.make(volume.view(), pose).grey;
    return std::all_of(image.data, image.data + 64 * 64, [](std::uint8_t v) { return v == 0; });
  };
  Pose pose = poseAt({0, -50, 0});
  EXPECT_FALSE(isBlack(pose));
  pose.status = PoseStatus::missing;
  EXPECT_TRUE(isBlack(pose));
  EXPECT_EQ(maker.lastStatus(), PoseStatus::missing);
  EXPECT_TRUE(maker.lastTimes().empty());
  pose.status = PoseStatus::ok;
  pose.probeToWorld.matrix[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isBlack(pose));
  EXPECT_EQ(maker.lastStatus(), PoseStatus::invalid);
  pose = poseAt({0, -50, 0});
  pose.probeToWorld.matrix[0] *= 1.2;
  EXPECT_TRUE(isBlack(pose));
  EXPECT_EQ(maker.lastStatus(), PoseStatus::invalid);
  EXPECT_FALSE(isBlack(poseAt({0, -50, 0})));
}

TEST(FrameMaker, TimesEveryStepOfItsPlan) {
  const Volume volume = bodyVolume();
  Knobs knobs;
  knobs.quality = Quality::weave;
  knobs.gain = 2.0;
  knobs.zoom = 4.0;
  FrameMaker maker;
  maker.configure(convexProbe(), knobs, {}, volume.grid, 300, 300);
  maker.make(volume.view(), poseAt({0, -50, 0}));
  ASSERT_EQ(maker.lastTimes().size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(maker.lastTimes()[n].kind, maker.plan().steps[n].kind);
    EXPECT_GT(maker.lastTimes()[n].measured_us, 0.0);
  }
}

TEST(FrameMaker, AllocatesNothingOnceWarm) {
  const Volume volume = bodyVolume();
  for (const Quality quality : {Quality::weave, Quality::linear})
    for (const double zoom : {1.0, 6.0}) {
      Knobs knobs;
      knobs.quality = quality;
      knobs.zoom = zoom;
      knobs.gain = 1.5;
      FrameMaker maker;
      maker.configure(convexProbe(), knobs, {}, volume.grid, 300, 260);
      // The first rows of the zoom depend on the pose's direction; all directions have been seen after these.
      for (int n = 0; n < 40; ++n) maker.make(volume.view(), poseAt({0, -55, 0}, 0.16 * n));
      const std::size_t before = testing::allocationCount();
      for (int n = 0; n < 40; ++n) maker.make(volume.view(), poseAt({0.1 * n, -55, 0}, 0.16 * n));
      maker.configure(convexProbe(), knobs, {}, volume.grid, 300, 260);
      EXPECT_EQ(testing::allocationCount(), before);
    }
}

TEST(FrameMaker, ThatWasReconfiguredGivesTheSamePixelsAsANewOne) {
  const Volume volume = bodyVolume();
  std::mt19937 random(21);
  FrameMaker used;
  for (int trial = 0; trial < 60; ++trial) {
    Knobs knobs;
    knobs.gain = random() % 2 ? 1.0 : 1.7;
    if (random() % 2) knobs.dgc[random() % 8] = 0.5;
    knobs.quality = random() % 2 ? Quality::weave : Quality::linear;
    knobs.zoom = random() % 2 ? 1.0 : 2.5;
    knobs.depth_mm = random() % 2 ? 0.0 : 90.0;
    const Scene scene{.gainAndDgc = random() % 3 != 0};
    const Probe probe = random() % 2 ? convexProbe() : linearProbe();
    const int width = random() % 2 ? 120 : 90;
    FrameMaker fresh;
    used.configure(probe, knobs, scene, volume.grid, width, 100);
    fresh.configure(probe, knobs, scene, volume.grid, width, 100);
    const Pose pose = poseAt({0, -50, 0}, 0.1 * trial);
    const auto a = used.make(volume.view(), pose).grey;
    const auto b = fresh.make(volume.view(), pose).grey;
    ASSERT_TRUE(std::equal(a.data, a.data + width * 100, b.data)) << "trial " << trial;
    ASSERT_EQ(used.plan(), fresh.plan());
  }
}

}  // namespace
}  // namespace ew::frame_test
