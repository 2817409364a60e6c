#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "ew/io/volume_file.h"
#include "ew/registration/elastic.h"
#include "ew/registration/quality.h"
#include "recordings.h"

/// Two overlapping halves of a real liver, one warped by a field that is known. The speckle is the same in both, so this is the easy half
/// of reality: real anatomy, real sector, changed gain and depth gain.
namespace real_liver_test {
namespace {

using namespace ew;
using namespace ew::registration;

constexpr const char* kLiver = "liver-sweep/liver_volume_1mm.mha";

/// Columns [first, last) along i.
Volume columns(const Volume& whole, int first, int last) {
  Volume part;
  part.grid = whole.grid;
  part.grid.dims.x = last - first;
  part.grid.origin_mm += whole.grid.directions[0] * (whole.grid.spacing_mm.x * first);
  for (int k = 0; k < whole.grid.dims.z; ++k)
    for (int j = 0; j < whole.grid.dims.y; ++j)
      for (int i = first; i < last; ++i) part.echo.push_back(whole.echo[whole.grid.indexOf(i, j, k)]);
  return part;
}

ControlGrid warpOf(const Grid& grid, double peak_mm) {
  ControlGrid control;
  control.nodes = grid;
  control.nodes.dims = grid.dims / 4 + 2;
  control.nodes.spacing_mm = 4.0 * grid.spacing_mm;
  const auto toWorld = control.nodes.voxelToWorld();
  const double k = 2.0 * std::numbers::pi / 110.0;
  for (int c = 0; c < control.nodes.dims.z; ++c)
    for (int b = 0; b < control.nodes.dims.y; ++b)
      for (int a = 0; a < control.nodes.dims.x; ++a) {
        const glm::dvec3 p = (toWorld * Point<frame::Voxel>{glm::dvec3(a, b, c)}).at;
        control.displacement_mm.push_back(
            glm::vec3(0.6 * peak_mm *
                      glm::dvec3(std::sin(k * p.y + 0.3) * std::cos(0.7 * k * p.z), std::cos(k * p.x - 0.8) * std::sin(0.6 * k * p.y + 1.0),
                                 std::sin(0.8 * k * p.x + 0.5) * std::cos(0.9 * k * p.y))));
      }
  return control;
}

TEST(RealLiver, HalvesBentByAKnownFieldAreBroughtTogetherAndBack) {
  EW_NEEDS_RECORDING(kLiver);
  const auto loaded = readVolume(ew::test::recording(kLiver));
  ASSERT_TRUE(loaded) << loaded.error().sentence();
  const Volume& whole = loaded->volume;
  for (const double peak_mm : {3.0, 5.0}) {
    const ControlGrid warp = warpOf(whole.grid, peak_mm);
    auto pressed = warped(whole, {{}, warp}, whole.grid, 1, noProgress());
    ASSERT_TRUE(pressed);
    Volume fixed = columns(*pressed, 0, 160), moving = columns(whole, 80, whole.grid.dims.x);
    fixed.coverage.clear();
    for (int k = 0; k < moving.grid.dims.z; ++k)
      for (int j = 0; j < moving.grid.dims.y; ++j)
        for (int i = 0; i < moving.grid.dims.x; ++i) {
          std::uint8_t& e = moving.echo[moving.grid.indexOf(i, j, k)];
          if (e != 0) e = static_cast<std::uint8_t>(std::clamp(1.15 * e + 12.0 - 0.15 * j, 1.0, 255.0));
        }
    ElasticOptions options;
    options.threads = 1;
    const auto there = registerElastic({&fixed, {}}, {&moving, {}}, {}, options, noProgress());
    const auto back = registerElastic({&moving, {}}, {&fixed, {}}, {}, options, noProgress());
    ASSERT_TRUE(there) << there.error().sentence();
    ASSERT_TRUE(back) << back.error().sentence();
    const auto quality = assessQuality({&fixed, {}}, {&moving, {}}, {}, there->fixedToMoving, &back->fixedToMoving, {}, noProgress());
    ASSERT_TRUE(quality) << quality.error().sentence();
    std::vector<double> errors, before;
    for (int k = 2; k < fixed.grid.dims.z; k += 3)
      for (int j = 2; j < fixed.grid.dims.y; j += 3)
        for (int i = 82; i < fixed.grid.dims.x; i += 3) {  // the overlap, where both show something
          if (fixed.echo[fixed.grid.indexOf(i, j, k)] == 0 || moving.echo[moving.grid.indexOf(i - 80, j, k)] == 0) continue;
          const glm::dvec3 p = (fixed.grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
          const glm::dvec3 truth = displacementAt(warp, p);
          errors.push_back(glm::length(movingPoint(there->fixedToMoving, p) - p - truth));
          before.push_back(glm::length(truth));
        }
    ASSERT_GT(errors.size(), 1000U);
    const auto mean = [](const std::vector<double>& v) {
      double sum = 0.0;
      for (const double e : v) sum += e;
      return sum / static_cast<double>(v.size());
    };
    std::sort(errors.begin(), errors.end());
    std::printf(
        "peak %.0f mm: undone %.2f, error %.2f / %.2f mm, forth and back %.2f / %.2f mm, correlation %.2f -> %.2f, Jacobian %.2f, %.1f s\n",
        peak_mm, mean(before), mean(errors), errors[errors.size() * 95 / 100], quality->inverseConsistencyMedian_mm.value_or(-1.0),
        quality->inverseConsistency95_mm.value_or(-1.0), quality->before.correlation, quality->after.correlation,
        quality->jacobian.smallest, there->seconds);
    EXPECT_EQ(there->verdict, Verdict::aligned) << there->reason;
    EXPECT_LT(mean(errors), 0.35 * mean(before));
    ASSERT_TRUE(quality->inverseConsistencyMedian_mm.has_value());
    EXPECT_LE(*quality->inverseConsistencyMedian_mm, 0.5);
    EXPECT_GT(quality->jacobian.smallest, 0.1);
    EXPECT_GT(quality->after.correlation, quality->before.correlation);
  }
}

}  // namespace
}  // namespace real_liver_test
