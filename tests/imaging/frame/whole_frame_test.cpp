// Whole frames with every effect: what must hold for an image, whatever path it took.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>

#include "ew/imaging/effects/gain.h"
#include "ew/imaging/frame.h"
#include "imaging/support/count_allocations.h"
#include "imaging/support/support.h"

namespace ew::whole_frame_test {
namespace {

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 55.0;
  probe.halfAngle_rad = 32.0 * std::numbers::pi / 180.0;
  probe.lines = 160;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 240.0;
  probe.defaultDepth_mm = 120.0;
  return probe;
}

Probe linearProbe() {
  Probe probe;
  probe.width_mm = 60.0;
  probe.defaultDepth_mm = 80.0;
  return probe;
}

/// Speckled tissue of 180 mm around the world's origin, with a bright ball; the probe looks into it along +y from y = -60.
Volume bodyVolume(const glm::dvec3& ball_mm = {0.0, 0.0, 0.0}, double ballRadius_mm = 5.0) {
  std::mt19937 random(3);
  Volume volume = testing::volumeOf({120, 160, 100}, [](int, int, int) { return 0.0; }, {1.5, 1.2, 1.8});
  volume.grid.origin_mm = {-89.25, -60.0, -89.1};
  std::size_t n = 0;
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 160; ++j)
      for (int i = 0; i < 120; ++i, ++n) {
        const glm::dvec3 p_mm = volume.grid.origin_mm + glm::dvec3(i, j, k) * volume.grid.spacing_mm;
        volume.echo[n] = static_cast<std::uint8_t>(glm::length(p_mm - ball_mm) < ballRadius_mm ? 255 : 70 + random() % 60);
      }
  return volume;
}

/// 1 everywhere, 7 in the ball.
Volume labelsOf(const Volume& body) {
  Volume labels = body;
  for (std::uint8_t& voxel : labels.echo) voxel = voxel >= 250 ? 7 : 1;
  return labels;
}

Pose poseAt(const glm::dvec3& origin_mm, double rotation_rad = 0.0, const glm::dvec3& axis = {0.2, 1.0, 0.1}) {
  Pose pose;
  pose.probeToWorld.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), origin_mm), rotation_rad, axis);
  return pose;
}

Knobs everyKnob() {
  Knobs knobs;
  knobs.gain = 1.2;
  knobs.dgc = {0.7, 0.8, 1, 1, 1.1, 1.2, 1.3, 1.4};
  knobs.dynamicRange_db = 55.0;
  knobs.greyMap = GreyMap::soft;
  knobs.edgeEnhancement = 0.4;
  knobs.persistence = 0.3;
  knobs.mode = DisplayMode::both;
  knobs.moreFoci_mm[0] = 90.0;
  return knobs;
}

Scene everyEffect() {
  Scene scene = sceneWithEverything();
  scene.tissues = {{.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 0.5},
                   {.label = 7, .name = "stone", .attenuation_dbPerCmMhz = 8.0, .reflection_db = 25.0}};
  return scene;
}

/// Air under the last quarter of the face.
std::vector<float> lifted() {
  std::vector<float> gaps_mm(32, -1.0F);
  std::fill(gaps_mm.begin() + 24, gaps_mm.end(), 20.0F);
  return gaps_mm;
}

struct Body {
  Volume echo = bodyVolume({0.0, 0.0, 0.0}, 12.0);
  Volume labels = labelsOf(echo);
  std::vector<float> gaps_mm = lifted();

  [[nodiscard]] FrameInput input(const Pose& pose, int number = 0) const {
    FrameInput input;
    input.echo = echo.view();
    input.labels = labels.view();
    input.pose = pose;
    input.gaps_mm = gaps_mm;
    input.time_s = number / 30.0;
    input.number = static_cast<std::uint64_t>(number);
    return input;
  }
};

GreyImage copyOf(ImageView<const std::uint8_t> view) {
  GreyImage image(view.width, view.height);
  for (int y = 0; y < view.height; ++y) std::copy(view.row(y), view.row(y) + view.width, viewOf(image).row(y));
  return image;
}

GreyImage imageOf(const Probe& probe, const Knobs& knobs, const Scene& scene, const Volume& volume, const Pose& pose, int width = 240,
                  int height = 220) {
  FrameMaker maker;
  maker.configure(probe, knobs, scene, volume.grid, width, height);
  return copyOf(maker.make(volume.view(), pose).grey);
}

TEST(WholeFrame, RunsEveryStepAndTimesIt) {
  const Body body;
  FrameMaker maker;
  maker.configure(convexProbe(), everyKnob(), everyEffect(), body.echo.grid, 240, 220, {.labels = true});
  EXPECT_EQ(maker.plan(), makePlan(convexProbe(), everyKnob(), everyEffect(), maker.geometry(), body.echo.grid, {.labels = true}));
  maker.make(body.input(poseAt({0, -58, 0})));
  EXPECT_EQ(maker.plan(), makePlan(convexProbe(), everyKnob(), everyEffect(), maker.geometry(), body.echo.grid, {.labels = true}, true));
  EXPECT_EQ(maker.plan().steps.size(), 13U);
  ASSERT_EQ(maker.lastTimes().size(), maker.plan().steps.size());
  for (std::size_t n = 0; n < maker.lastTimes().size(); ++n) {
    EXPECT_EQ(maker.lastTimes()[n].kind, maker.plan().steps[n].kind);
    EXPECT_GT(maker.lastTimes()[n].measured_us, 0.0) << nameOf(maker.lastTimes()[n].kind);
  }
}

TEST(WholeFrame, EveryEffectChangesTheImage) {
  const Body body;
  const auto imageWith = [&](const Knobs& knobs, const Scene& scene) {
    FrameMaker maker;
    maker.configure(convexProbe(), knobs, scene, body.echo.grid, 240, 220, {.labels = true});
    for (int n = 0; n < 3; ++n) maker.make(body.input(poseAt({3.0 * n, -58, 0}), n));
    return copyOf(maker.make(body.input(poseAt({9.0, -58, 0}), 3)).grey);
  };
  const GreyImage all = imageWith(everyKnob(), everyEffect());
  const auto without = [&](const char* what, auto change) {
    Knobs knobs = everyKnob();
    Scene scene = everyEffect();
    change(knobs, scene);
    EXPECT_NE(imageWith(knobs, scene), all) << what;
  };
  without("gain", [](Knobs& k, Scene&) { k.gain = 1.0; });
  without("TGC", [](Knobs& k, Scene&) { k.dgc = Knobs{}.dgc; });
  without("dynamic range", [](Knobs& k, Scene&) { k.dynamicRange_db = 0.0; });
  without("grey map", [](Knobs& k, Scene&) { k.greyMap = GreyMap::linear; });
  without("edges", [](Knobs& k, Scene&) { k.edgeEnhancement = 0.0; });
  without("persistence", [](Knobs& k, Scene&) { k.persistence = 0.0; });
  without("the second focus", [](Knobs& k, Scene&) { k.moreFoci_mm = {}; });
  without("the focus' method", [](Knobs& k, Scene&) { k.focusMethod = FocusMethod::rowStretch; });
  without("quality", [](Knobs& k, Scene&) { k.quality = Quality::weave; });
  without("elevation planes", [](Knobs& k, Scene&) { k.elevationPlanes = 3; });
  without("inversion", [](Knobs& k, Scene&) { k.upsideDown = true; });
  without("focus", [](Knobs&, Scene& s) { s.focus.reset(); });
  without("slice thickness", [](Knobs&, Scene& s) { s.sliceThickness.reset(); });
  without("shadow", [](Knobs&, Scene& s) { s.attenuation.reset(); });
  without("tissues", [](Knobs&, Scene& s) { s.tissues.clear(); });
  without("reverberation", [](Knobs&, Scene& s) { s.reverberation.reset(); });
  without("noise", [](Knobs&, Scene& s) { s.noise.reset(); });
  without("contact", [](Knobs&, Scene& s) { s.contact.reset(); });
}

TEST(WholeFrame, IsTheSameOnOneTwoAndEightThreads) {
  const Body body;
  for (const bool onBeams : {true, false})
    for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic})
      for (const double zoom : {1.0, 5.0}) {
        Knobs knobs = everyKnob();
        knobs.quality = quality;
        knobs.zoom = zoom;
        const Scene scene = onBeams ? everyEffect() : Scene{};
        FrameMaker one(1), two(2), eight(8);
        for (FrameMaker* maker : {&one, &two, &eight})
          maker->configure(convexProbe(), knobs, scene, body.echo.grid, 240, 220, {.labels = true});
        for (int n = 0; n < 4; ++n) {
          const FrameInput input = body.input(poseAt({2.0 * n, -58, 1}, 0.3 * n), n);
          const GreyImage expected = copyOf(one.make(input).grey);
          ASSERT_EQ(copyOf(two.make(input).grey), expected) << "two threads, frame " << n;
          ASSERT_EQ(copyOf(eight.make(input).grey), expected) << "eight threads, frame " << n;
          ASSERT_EQ(copyOf(two.strip()), copyOf(one.strip()));
        }
      }
}

TEST(WholeFrame, AllocatesNothingOnceWarm) {
  const Body body;
  for (const int threads : {1, 2})
    for (const FocusMethod method : {FocusMethod::lateralKernel, FocusMethod::rowStretch}) {
      Knobs knobs = everyKnob();
      knobs.focusMethod = method;
      if (method == FocusMethod::rowStretch) {
        knobs.gainLaw = GainLaw::decibel;
        knobs.gain_db = 4.0;
      }
      const Scene scene = everyEffect();
      const Probe probe = convexProbe();
      FrameMaker maker(threads);
      maker.configure(probe, knobs, scene, body.echo.grid, 160, 140, {.labels = true});
      FrameInput touching = body.input({});
      touching.gaps_mm = {};
      const auto makeFrames = [&] {
        for (int n = 0; n < 16; ++n) {
          // Every other frame the whole face touches, so that both plans are run.
          FrameInput input = n % 2 == 0 ? body.input({}) : touching;
          input.pose = poseAt({0.1 * n, -55, 0}, 0.4 * n);
          input.time_s = 0.03 * n;
          input.number = static_cast<std::uint64_t>(n);
          maker.make(input);
        }
      };
      makeFrames();
      makeFrames();
      // Which thread meets which step for the first time is up to the machine: with two, some rounds may pass until both have met all.
      std::size_t allocations = 0;
      for (int round = 0; round < (threads == 1 ? 1 : 20); ++round) {
        const std::size_t before = testing::allocationCount();
        makeFrames();
        maker.configure(probe, knobs, scene, body.echo.grid, 160, 140, {.labels = true});
        allocations = testing::allocationCount() - before;
        if (allocations == 0) break;
      }
      EXPECT_EQ(allocations, 0U) << threads << " threads";
    }
}

TEST(WholeFrame, AllocatesNothingWhenTheWarmProbeIsFirstLifted) {
  const Body body;
  FrameMaker maker;
  maker.configure(convexProbe(), everyKnob(), everyEffect(), body.echo.grid, 160, 140, {.labels = true});
  const FrameInput offSkin = body.input(poseAt({0, -55, 0}), 9);
  FrameInput touching = body.input(poseAt({0, -55, 0}));
  touching.gaps_mm = {};
  for (int n = 0; n < 4; ++n) {
    touching.time_s = n / 30.0;
    maker.make(touching);
  }
  const std::size_t before = testing::allocationCount();
  maker.make(offSkin);
  EXPECT_EQ(testing::allocationCount(), before);
}

TEST(WholeFrame, ReconfiguredGivesTheSamePixelsAsANewOne) {
  const Body body;
  std::mt19937 random(5);
  FrameMaker used;
  for (int trial = 0; trial < 60; ++trial) {
    Knobs knobs;
    Scene scene;
    const auto maybe = [&] { return random() % 2 == 0; };
    if (maybe()) knobs.gain = 1.7;
    if (maybe()) knobs.gainLaw = GainLaw::decibel;
    if (maybe()) knobs.gain_db = maybe() ? 6.0 : -6.0;
    if (maybe()) knobs.tgc_db[2] = 12.0;
    if (maybe()) knobs.dynamicRange_db = 75.0;
    if (maybe()) knobs.greyMap = maybe() ? GreyMap::bright : GreyMap::clinical;
    if (maybe()) knobs.quality = Quality::weave;
    if (maybe()) knobs.zoom = 2.5;
    if (maybe()) knobs.depth_mm = 90.0;
    if (maybe()) knobs.edgeEnhancement = 0.5;
    if (maybe()) knobs.persistence = 0.5;
    if (maybe()) knobs.elevationPlanes = 3;
    if (maybe()) knobs.focus_mm = 40.0;
    if (maybe()) knobs.focusMethod = FocusMethod::rowStretch;
    if (maybe()) knobs.upsideDown = true;
    if (maybe()) knobs.mode = DisplayMode::both;
    if (maybe()) knobs.mLine = 0.4;
    if (maybe()) scene = everyEffect();
    if (maybe()) scene.sliceThickness.reset();
    if (maybe()) scene.focus.reset();
    if (maybe()) scene.noise.reset();
    if (maybe()) scene.recordedDynamicRange_db = 72.0;
    const bool hasLabels = maybe();
    const Probe probe = maybe() ? convexProbe() : linearProbe();
    const int width = maybe() ? 120 : 90;
    FrameMaker fresh;
    used.configure(probe, knobs, scene, body.echo.grid, width, 100, {.labels = hasLabels});
    used.forget();
    fresh.configure(probe, knobs, scene, body.echo.grid, width, 100, {.labels = hasLabels});
    FrameInput input = body.input(poseAt({0, -55, 0}, 0.1 * trial), trial);
    if (maybe()) input.gaps_mm = {};
    ASSERT_EQ(copyOf(used.make(input).grey), copyOf(fresh.make(input).grey)) << "trial " << trial;
    ASSERT_EQ(used.plan(), fresh.plan());
    ASSERT_EQ(copyOf(used.strip()), copyOf(fresh.strip())) << "trial " << trial;
  }
}

/// Equation 5 with its tone, pixel by pixel, behind everything that happens on beams.
TEST(WholeFrame, AppliesEquationFiveAtTheDepthOfEachRowOnBothPaths) {
  const Body body;
  for (const bool onBeams : {false, true})
    for (const bool upsideDown : {false, true}) {
      Scene scene = onBeams ? everyEffect() : Scene{};
      scene.recordedDynamicRange_db = 60.0;
      Knobs plain, turned;
      plain.upsideDown = upsideDown;
      turned = plain;
      turned.gain = 1.4;
      turned.dgc = {0.4, 0.6, 1.2, 2.0, 1.0, 0.3, 0.8, 1.5};
      const GreyImage before = imageOf(convexProbe(), plain, scene, body.echo, poseAt({0, -58, 0}));
      const GreyImage after = imageOf(convexProbe(), turned, scene, body.echo, poseAt({0, -58, 0}));
      const DisplayGeometry geometry = fitDisplay(convexProbe(), plain, before.width, before.height);
      for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
          const double depth = (geometry.imageToProbe() * Point<frame::Image>{{x, y, 0}}).at.y / geometry.depth_mm;
          const double factor = dgcAt(turned.dgc, std::clamp(depth, 0.0, 1.0));
          ASSERT_NEAR(viewOf(after).at(x, y), std::min(1.4 * std::min(factor * viewOf(before).at(x, y), 255.0), 255.0), 0.501);
        }
    }
}

/// Turned about its axis, the probe sees the same beams in the other order. Electronic noise has no place in the body: it is left out.
TEST(WholeFrame, IsMirroredExactlyWhenTheProbeTurnsByHalfATurn) {
  const Body body;
  Scene scene = everyEffect();
  scene.noise.reset();
  Knobs knobs = everyKnob();
  std::vector<float> mirroredGaps(body.gaps_mm.rbegin(), body.gaps_mm.rend());
  for (const Probe& probe : {convexProbe(), linearProbe()})
    for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic})
      for (const FocusMethod method : {FocusMethod::lateralKernel, FocusMethod::rowStretch}) {
        knobs.quality = quality;
        knobs.focusMethod = method;
        FrameMaker straight, turned;
        straight.configure(probe, knobs, scene, body.echo.grid, 241, 220, {.labels = true});
        turned.configure(probe, knobs, scene, body.echo.grid, 241, 220, {.labels = true});
        const Pose pose = poseAt({4, -57, 3}, 0.4);
        Pose half = pose;
        half.probeToWorld.matrix[0] *= -1.0;  // half a turn about y: x and z point the other way
        half.probeToWorld.matrix[2] *= -1.0;
        FrameInput input = body.input(half);
        input.gaps_mm = mirroredGaps;
        const GreyImage a = copyOf(straight.make(body.input(pose)).grey), b = copyOf(turned.make(input).grey);
        int apart = 0;
        for (int y = 0; y < a.height; ++y)
          for (int x = 0; x < a.width; ++x) apart += viewOf(a).at(x, y) != viewOf(b).at(a.width - 1 - x, y);
        EXPECT_EQ(apart, 0) << nameOf(makePlan(probe, knobs, scene, straight.geometry(), body.echo.grid).steps.front().kind)
                            << (method == FocusMethod::rowStretch ? ", stretch" : ", kernel");
      }
}

/// Largest difference between the image of a probe and the mirrored one of the same probe after half a turn.
int apartAfterHalfATurn(const Knobs& knobs, const Volume& volume) {
  const Pose pose = poseAt({4, -57, 3}, 0.4);
  Pose half = pose;
  half.probeToWorld.matrix[0] *= -1.0;
  half.probeToWorld.matrix[2] *= -1.0;
  const GreyImage a = imageOf(convexProbe(), knobs, {}, volume, pose, 241), b = imageOf(convexProbe(), knobs, {}, volume, half, 241);
  int most = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) most = std::max(most, std::abs(viewOf(a).at(x, y) - viewOf(b).at(a.width - 1 - x, y)));
  return most;
}

TEST(WholeFrame, OfTheDisplayPathIsMirroredExactlyWhenTheProbeTurnsByHalfATurn) {
  const Volume body = bodyVolume();
  Knobs knobs = everyKnob();
  EXPECT_EQ(apartAfterHalfATurn(knobs, body), 0);
  knobs.quality = Quality::cubic;
  EXPECT_EQ(apartAfterHalfATurn(knobs, body), 0);
  EXPECT_EQ(apartAfterHalfATurn({.quality = Quality::weave}, body), 0);
}

/// Grey level lost to the shadow at a point of the world, seen from `pose`.
double lossAt(const Volume& body, const Pose& pose, const glm::dvec3& p_world_mm) {
  Scene clear, shadowed;
  shadowed.attenuation.emplace();
  const int width = 300, height = 260;
  const GreyImage without = imageOf(convexProbe(), {}, clear, body, pose, width, height);
  const GreyImage with = imageOf(convexProbe(), {}, shadowed, body, pose, width, height);
  const DisplayGeometry geometry = fitDisplay(convexProbe(), {}, width, height);
  const glm::dmat4 worldToImage = glm::inverse(pose.probeToWorld.matrix * geometry.imageToProbe().matrix);
  const glm::dvec4 at = worldToImage * glm::dvec4(p_world_mm, 1.0);
  double sum = 0.0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = static_cast<int>(std::lround(at.x)) + dx, y = static_cast<int>(std::lround(at.y)) + dy;
      sum += viewOf(without).at(x, y) - viewOf(with).at(x, y);
    }
  return sum / 9.0;
}

TEST(WholeFrame, ShadowsLieAlongTheBeamsOfThePresentView) {
  const glm::dvec3 ball_mm{0.0, 0.0, 0.0};
  const Volume body = bodyVolume(ball_mm, 6.0);
  for (const double tilt_rad : {-0.5, -0.2, 0.0, 0.3, 0.6})
    for (const double sideways_mm : {-15.0, 0.0, 15.0}) {
      // The probe swings about the ball in its image plane and slides sideways: the beam through the ball leaves it in another direction.
      Pose pose;
      pose.probeToWorld.matrix = glm::translate(glm::rotate(glm::dmat4(1.0), tilt_rad, {0, 0, 1}), {sideways_mm, -55.0, 0.0});
      // Beams of a convex probe run through the centre of its arc.
      const glm::dvec3 apex_mm(pose.probeToWorld.matrix * glm::dvec4(0.0, -convexProbe().radius_mm, 0.0, 1.0));
      const glm::dvec3 away = glm::normalize(ball_mm - apex_mm);
      const glm::dvec3 across(-away.y, away.x, 0.0);
      EXPECT_GT(lossAt(body, pose, ball_mm + 30.0 * away), 50.0) << tilt_rad << " " << sideways_mm;
      EXPECT_LT(lossAt(body, pose, ball_mm + 30.0 * away + 14.0 * across), 10.0) << tilt_rad << " " << sideways_mm;
      EXPECT_LT(lossAt(body, pose, ball_mm + 30.0 * away - 14.0 * across), 10.0) << tilt_rad << " " << sideways_mm;
      EXPECT_LT(lossAt(body, pose, ball_mm - 20.0 * away), 10.0) << "before the ball, " << tilt_rad << " " << sideways_mm;
    }
}

TEST(WholeFrame, OfAPoseThatCannotBeUsedIsBlackWithEveryEffectOn) {
  const Body body;
  FrameMaker maker;
  maker.configure(convexProbe(), everyKnob(), everyEffect(), body.echo.grid, 120, 110, {.labels = true});
  const auto sum = [&](const Pose& pose) {
    maker.make(body.input(poseAt({0, -55, 0})));
    const auto image = maker.make(body.input(pose)).grey;
    int total = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) total += image.at(x, y);
    return total;
  };
  EXPECT_GT(sum(poseAt({0, -55, 0})), 0);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    Pose pose = poseAt({0, -55, 0});
    pose.probeToWorld.matrix[1][1] = bad;
    EXPECT_EQ(sum(pose), 0);
    EXPECT_EQ(maker.lastStatus(), PoseStatus::invalid);
    EXPECT_TRUE(maker.lastTimes().empty());
  }
  EXPECT_GT(sum(poseAt({0, -55, 0})), 0);
}

TEST(WholeFrame, SurvivesGapsTimesAndVolumesThatAreNone) {
  const Body body;
  FrameMaker maker;
  maker.configure(convexProbe(), everyKnob(), everyEffect(), body.echo.grid, 120, 110, {.labels = true});
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  const std::vector<float> gaps{kNan, kInf, -kInf, 1e30F, 0.0F};
  const std::vector<float> oneGap{20.0F};
  FrameInput input = body.input(poseAt({0, -55, 0}));
  input.gaps_mm = gaps;
  input.time_s = static_cast<double>(kNan);
  maker.make(input);
  input.gaps_mm = oneGap;
  maker.make(input);
  input.labels = {};
  maker.make(input);
  input.echo = {};
  const auto image = maker.make(input).grey;
  EXPECT_EQ(maker.lastStatus(), PoseStatus::ok);
  EXPECT_EQ(image.width, 120);
}

TEST(WholeFrame, GoesByGreyLevelWhereAFrameComesWithoutItsLabels) {
  const Body body;
  Scene scene;
  scene.attenuation.emplace();
  scene.tissues = {{.label = 0, .name = "outside", .attenuation_dbPerCmMhz = 5.0},
                   {.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 5.0}};
  FrameMaker maker, byGrey;
  maker.configure(convexProbe(), {}, scene, body.echo.grid, 120, 110, {.labels = true});
  byGrey.configure(convexProbe(), {}, scene, body.echo.grid, 120, 110);
  FrameInput input = body.input(poseAt({0, -55, 0}));
  const GreyImage byTissue = copyOf(maker.make(input).grey);
  input.labels = {};
  const GreyImage expected = copyOf(byGrey.make(input).grey);
  EXPECT_NE(byTissue.pixels, expected.pixels);
  EXPECT_EQ(copyOf(maker.make(input).grey).pixels, expected.pixels);
}

TEST(MMode, ShowsTheBeamItFollowsWithAndWithoutBeams) {
  // Layers along y alone: every beam of a linear probe shows the same depths.
  Volume layers = testing::volumeOf({60, 160, 40}, [](int, int j, int) { return 20.0 + (j / 8) % 5 * 50.0; }, {2.0, 1.0, 2.0});
  layers.grid.origin_mm = {-59.0, 0.0, -39.0};
  for (const bool onBeams : {false, true}) {
    Knobs knobs{.gain = 1.1, .mode = DisplayMode::both};
    knobs.mSweep_s = 1.0;
    Scene scene;
    if (onBeams) scene.noise = NoiseEffect{.atFace_db = -87.0, .growth_dbPerCmMhz = 0.0};
    FrameMaker maker;
    maker.configure(linearProbe(), knobs, scene, layers.grid, 200, 160);
    ASSERT_EQ(maker.plan().onBeams, onBeams);
    FrameInput input;
    input.echo = layers.view();
    input.pose = poseAt({0, 5, 0});
    for (int n = 0; n < 15; ++n) {
      input.time_s = n / 30.0;
      maker.make(input);
    }
    const auto image = maker.make(input).grey;
    const auto strip = maker.strip();
    ASSERT_EQ(strip.width, 200);
    ASSERT_EQ(strip.height, 160);
    EXPECT_GT(maker.stripCursor(), 80);
    const DisplayGeometry& geometry = maker.geometry();
    int apart = 0, compared = 0;
    for (int y = 0; y < 160; ++y) {
      const double depth_mm = (y + 0.5) / 160.0 * geometry.depth_mm;
      const double row = geometry.face_px.y + depth_mm / geometry.pixel_mm;
      if (row < 1 || row > 158) continue;
      // Layers end at multiples of 8 mm; beside an edge a pixel of one grid may be on its other side.
      const double toEdge_mm = std::abs(std::remainder(depth_mm + 5.0 + 0.5, 8.0));
      if (toEdge_mm < 1.5) continue;
      ++compared;
      apart += std::abs(strip.at(40, y) - image.at(100, static_cast<int>(std::lround(row)))) > 6;
    }
    EXPECT_GT(compared, 80);
    EXPECT_EQ(apart, 0) << (onBeams ? "beams" : "one beam");
  }
}

TEST(MMode, HasNoStripInBModeAndForgetsWhenAsked) {
  const Body body;
  FrameMaker maker;
  maker.configure(convexProbe(), {}, {}, body.echo.grid, 100, 90);
  maker.make(body.input(poseAt({0, -55, 0})));
  EXPECT_EQ(maker.strip().width, 0);
  maker.configure(convexProbe(), {.mode = DisplayMode::mMode}, {}, body.echo.grid, 100, 90);
  for (int n = 0; n < 20; ++n) maker.make(body.input(poseAt({0, -55, 0}), n));
  EXPECT_GT(maker.stripCursor(), 5);
  maker.forget();
  EXPECT_EQ(maker.stripCursor(), 0);
  maker.make(body.input(poseAt({0, -55, 0}), 21));
  EXPECT_LE(maker.stripCursor(), 1);
}

}  // namespace
}  // namespace ew::whole_frame_test
