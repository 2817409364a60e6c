// Whole frames against kept images; README.md beside this file says how they were made and when to renew them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

#include "ew/imaging/frame.h"
#include "ew/io/image_file.h"
#include "imaging/support/support.h"
#include "places.h"

namespace ew::frames_test {
namespace {

namespace fs = std::filesystem;

/// Evenly spread over 0..1, the same on every machine.
double hashed(int i, int j, int k) {
  std::uint32_t h =
      static_cast<std::uint32_t>(i) * 73856093U ^ static_cast<std::uint32_t>(j) * 19349663U ^ static_cast<std::uint32_t>(k) * 83492791U;
  h ^= h >> 15;
  h *= 2246822519U;
  h ^= h >> 13;
  h *= 3266489917U;
  h ^= h >> 16;
  return static_cast<double>(h) / 4294967296.0;
}

/// Speckled tissue 120 mm across with a dark cyst, a bright stone and a vessel that runs obliquely. The probe looks along +y.
Volume body() {
  Volume volume = testing::volumeOf({80, 100, 60},
                                    [](int i, int j, int k) {
                                      const glm::dvec3 p_mm =
                                          glm::dvec3(i, j, k) * glm::dvec3(1.5, 1.2, 1.8) - glm::dvec3(59.25, 0.0, 53.1);
                                      const glm::dvec3 vessel = p_mm - glm::dvec3(-0.5 * p_mm.y + 30.0, p_mm.y, 0.2 * p_mm.y - 8.0);
                                      if (glm::length(p_mm - glm::dvec3(12, 45, 3)) < 3.5) return 235.0;
                                      if (glm::length(p_mm - glm::dvec3(10, 40, 0)) < 14.0) return 12.0;
                                      if (glm::length(vessel) < 5.0) return 25.0;
                                      const double layers = p_mm.y < 8.0 ? 60.0 : 0.0;
                                      return 70.0 + layers + 90.0 * hashed(i, j, k) * hashed(j, k, i);
                                    },
                                    {1.5, 1.2, 1.8});
  volume.grid.origin_mm = {-59.25, 0.0, -53.1};
  return volume;
}

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 50.0;
  probe.halfAngle_rad = 0.55;
  probe.minDepth_mm = 30.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = 110.0;
  return probe;
}

Pose poseFor(double rotation_rad) {
  Pose pose;
  pose.probeToWorld.matrix =
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(2, 3, 1)), rotation_rad, glm::normalize(glm::dvec3(0.3, 1, 0.2)));
  return pose;
}

struct Kept {
  const char* name;
  Probe probe;
  Knobs knobs;
  double rotation_rad = 0.0;
  Scene scene = {};
  bool isLifted = false;  ///< the last quarter of the face (its +x end) is off the skin
};

/// What ctest's list of names shows for a parameter.
void PrintTo(const Kept& kept, std::ostream* out) { *out << kept.name; }

std::vector<Kept> keptFrames() {
  Knobs weave{.quality = Quality::weave}, zoomedWeave{.zoom = 3.0, .quality = Quality::weave}, zoomed{.zoom = 3.0}, amplified{.gain = 1.3};
  amplified.dgc = {0.5, 0.7, 1.0, 1.4, 1.8, 2.0, 0.6, 0.3};
  Probe linear;
  linear.width_mm = 50.0;
  linear.defaultDepth_mm = 80.0;
  Knobs markerRight{.quality = Quality::linear, .markerLeft = false};
  std::vector<Kept> kept{{"convex_linear", convexProbe(), {}, 0.2},          {"convex_weave", convexProbe(), weave, 0.2},
                         {"convex_gain_dgc", convexProbe(), amplified, 0.2}, {"convex_zoom_weave", convexProbe(), zoomedWeave, 0.2},
                         {"convex_zoom_linear", convexProbe(), zoomed, 0.2}, {"linear_turned", linear, {}, 0.9},
                         {"linear_marker_right", linear, markerRight, 0.9}};
  const auto keepEffect = [&](const char* name, const Probe& probe, const Knobs& knobs, auto enable, bool isLifted = false) {
    Scene scene;
    enable(scene);
    kept.push_back({name, probe, knobs, 0.2, scene, isLifted});
  };
  Knobs rows{.focus_mm = 40.0, .focusMethod = FocusMethod::rowStretch}, kernel{.focus_mm = 40.0};
  Knobs toned{.dynamicRange_db = 45.0, .greyMap = GreyMap::contrast, .edgeEnhancement = 0.6};
  keepEffect("effect_focus", convexProbe(), kernel, [](Scene& scene) { scene.focus.emplace(); });
  keepEffect("effect_focus_rows", convexProbe(), rows, [](Scene& scene) { scene.focus.emplace(); });
  keepEffect("effect_slice_thickness", convexProbe(), {}, [](Scene& scene) { scene.sliceThickness.emplace(); });
  keepEffect("effect_shadow", convexProbe(), {}, [](Scene& scene) { scene.attenuation.emplace(); });
  keepEffect("effect_reverberation", convexProbe(), {}, [](Scene& scene) { scene.reverberation.emplace(); });
  keepEffect("effect_noise", convexProbe(), {}, [](Scene& scene) { scene.noise.emplace(); });
  keepEffect(
      "effect_contact", linear, {}, [](Scene& scene) { scene.contact.emplace(); }, true);
  keepEffect("effect_tone_and_edges", convexProbe(), toned, [](Scene&) {});
  keepEffect(
      "effect_everything", convexProbe(), toned, [](Scene& scene) { scene = sceneWithEverything(); }, true);
  return kept;
}

class GoldenFrame : public ::testing::TestWithParam<Kept> {};

/// At most one grey level apart, but for one pixel in a thousand: another compiler may round a position to the voxel beside.
TEST_P(GoldenFrame, IsTheKeptImage) {
  const Kept& kept = GetParam();
  const fs::path golden = fs::path(EW_SOURCE_DIR) / "tests" / "golden" / "frames" / (std::string(kept.name) + ".png");
  const Volume volume = body();
  FrameMaker maker;
  maker.configure(kept.probe, kept.knobs, kept.scene, volume.grid, 160, 160);
  std::vector<float> gaps_mm(33, 0.0F);
  std::fill(gaps_mm.begin() + 25, gaps_mm.end(), 30.0F);
  FrameInput input;
  input.echo = volume.view();
  input.pose = poseFor(kept.rotation_rad);
  if (kept.isLifted) input.gaps_mm = gaps_mm;
  const auto actual = maker.make(input).grey;
  if (std::getenv("EW_RENEW_GOLDEN") != nullptr) {
    ASSERT_TRUE(writeImage(actual, maker.geometry().pixel_mm, golden));
    GTEST_SKIP() << "Renewed " << golden;
  }
  const auto expected = readImage(golden);
  ASSERT_TRUE(expected) << expected.error();
  ASSERT_EQ(expected->width, actual.width);
  ASSERT_EQ(expected->height, actual.height);
  GreyImage difference(actual.width, actual.height);
  int apart = 0;
  for (int y = 0; y < actual.height; ++y)
    for (int x = 0; x < actual.width; ++x) {
      const int off = std::abs(actual.at(x, y) - viewOf(*expected).at(x, y));
      viewOf(difference).at(x, y) = static_cast<std::uint8_t>(std::min(255, 8 * off));
      apart += off > 1;
    }
  EXPECT_LE(apart, actual.width * actual.height / 1000);
  if (HasFailure()) {
    const fs::path left(EW_GOLDEN_LEFT);
    fs::create_directories(left);
    ASSERT_TRUE(writeImage(actual, 1.0, left / (std::string(kept.name) + ".actual.png")));
    ASSERT_TRUE(writeImage(viewOf(difference), 1.0, left / (std::string(kept.name) + ".difference.png")));
    ADD_FAILURE() << "The image and its difference (8 times) are in " << left;
  }
}

INSTANTIATE_TEST_SUITE_P(Kept, GoldenFrame, ::testing::ValuesIn(keptFrames()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ew::frames_test
