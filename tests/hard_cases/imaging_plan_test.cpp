// Settings that no console would give, and poses that no tracker should: the plan and its frames. Outcomes are in
// resources/docs/science/hard-cases.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "ew/imaging/frame.h"
#include "imaging/support/support.h"

namespace ew::imaging_plan_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 50.0;
  probe.halfAngle_rad = 0.5;
  probe.lines = 48;
  probe.minDepth_mm = 30.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = 80.0;
  return probe;
}

Knobs knobsOf(double value) {
  Knobs knobs;
  knobs.gain = value;
  knobs.dgc.fill(value);
  knobs.gainLaw = value > 1.0 ? GainLaw::decibel : static_cast<GainLaw>(99);
  knobs.gain_db = value;
  knobs.tgc_db.fill(value);
  knobs.depth_mm = value;
  knobs.focus_mm = value;
  knobs.moreFoci_mm.fill(value);
  knobs.carrier_hz = value;
  knobs.dynamicRange_db = value;
  knobs.greyMap = static_cast<GreyMap>(99);
  knobs.edgeEnhancement = value;
  knobs.persistence = value;
  knobs.elevationPlanes = value > 0.0 ? std::numeric_limits<int>::max() : std::numeric_limits<int>::min();
  knobs.steering_rad = value;
  knobs.zoom = value;
  knobs.mode = DisplayMode::both;
  knobs.mLine = value;
  knobs.mSweep_s = value;
  return knobs;
}

Scene sceneOf(double value) {
  Scene scene;
  scene.recordedDynamicRange_db = value;
  scene.focus = FocusEffect{.strength = value};
  scene.sliceThickness = SliceThicknessEffect{.scale = value};
  scene.attenuation = AttenuationEffect{value, value, value, value, value};
  scene.reverberation = ReverberationEffect{value, value, std::numeric_limits<int>::max(), true, value};
  scene.noise = NoiseEffect{.atFace_db = value, .growth_dbPerCmMhz = value};
  scene.contact = ContactEffect{.gel_mm = value, .ringDown_mm = value};
  scene.tissues = {{-5, "below every label", value, value}, {4711, "beyond every label", value, value}};
  return scene;
}

TEST(HardPlan, SettingsThatAreNoNumbersOrBeyondEveryLimitGiveTheImageOfTheNearestUsableOnes) {
  const Volume volume = testing::noiseVolume({60, 60, 60}, 4, glm::dvec3(2.0));
  std::vector<float> gaps_mm(9, 0.0F);
  gaps_mm[8] = std::numeric_limits<float>::infinity();
  FrameInput input;
  input.echo = volume.view();
  input.labels = volume.view();
  input.pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), {60, 1, 60});
  input.gaps_mm = gaps_mm;
  for (const double value : {kNan, kInf, -kInf, 1e300, -1e300, 1e-300, 0.0, -1.0}) {
    const Knobs knobs = knobsOf(value);
    const Scene scene = sceneOf(value);
    FrameMaker asked, usable;
    asked.configure(convexProbe(), knobs, scene, volume.grid, 90, 80, {.labels = true});
    usable.configure(convexProbe(), limited(knobs), limited(scene), volume.grid, 90, 80, {.labels = true});
    for (int n = 0; n < 3; ++n) {
      input.time_s = n == 1 ? value : 0.1 * n;
      const auto a = asked.make(input).grey, b = usable.make(input).grey;
      ASSERT_TRUE(std::equal(a.data, a.data + 90 * 80, b.data)) << value;
    }
    EXPECT_EQ(asked.plan(), usable.plan());
  }
}

TEST(HardPlan, OnePixelImagesAndTwoLineProbesRunEveryEffect) {
  const Volume volume = testing::noiseVolume({60, 60, 60}, 4, glm::dvec3(2.0));
  FrameInput input;
  input.echo = volume.view();
  input.pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), {60, 1, 60});
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}, std::pair{3, 2}})
    for (const int threads : {1, 8}) {
      Probe probe = convexProbe();
      probe.lines = 2;
      Knobs knobs{.edgeEnhancement = 1.0, .persistence = 0.5, .mode = DisplayMode::both};
      FrameMaker maker(threads);
      maker.configure(probe, knobs, sceneWithEverything(), volume.grid, width, height);
      const auto image = maker.make(input).grey;
      EXPECT_EQ(image.width, width);
      EXPECT_EQ(image.height, height);
    }
}

TEST(HardPlan, VolumesOfOneVoxelOrNoneAndLabelsElsewhereRunEveryEffect) {
  const Volume one = testing::noiseVolume({1, 1, 1}, 4);
  Volume far = testing::noiseVolume({9, 9, 9}, 4);
  far.grid.origin_mm = {1e6, -1e6, 1e6};
  Scene scene = sceneWithEverything();
  scene.tissues = {{7, "stone", 8.0, 25.0}};
  for (const SliceSource& echo : {SliceSource(one.view()), SliceSource(far.view()), SliceSource()}) {
    FrameMaker maker;
    maker.configure(convexProbe(), {}, scene, echo.grid, 60, 50, {.labels = true});
    FrameInput input;
    input.echo = echo;
    input.labels = far.view();
    maker.make(input);
    EXPECT_EQ(maker.lastStatus(), PoseStatus::ok);
    EXPECT_TRUE(maker.plan().onBeams);
  }
}

}  // namespace
}  // namespace ew::imaging_plan_test
