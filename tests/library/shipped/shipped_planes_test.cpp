// Every shipped case whose echoes are formed live: its planes at the settings it begins with, as bright as a console would show them.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "ew/imaging/display.h"
#include "ew/library/case_truth.h"
#include "ew/library/preparation.h"
#include "ew/scanning/first_image.h"
#include "library/coarse_case.h"

namespace ew::shipped_planes_test {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;

constexpr int kWidth_px = 544, kHeight_px = 320;
constexpr int kBlack = 16;  ///< up to this grey level a pixel says nothing

/// What a person takes in of an image first: how bright it is, and how much of it shows anything. Of the fan alone.
struct Light {
  double mean = 0.0;   ///< grey level, 0 to 255
  double share = 0.0;  ///< of pixels above kBlack
};

Light lightOf(const DisplayImage& image, const Spans& fan) {
  double sum = 0.0;
  std::size_t pixels = 0, lit = 0;
  for (int y = 0; y < image.height(); ++y)
    for (const RowSpan& run : fan[static_cast<std::size_t>(y)])
      for (int x = run.begin; x < run.end; ++x) {
        const int grey = image.grey.row(y)[x];
        sum += grey;
        lit += grey > kBlack ? 1 : 0;
        ++pixels;
      }
  if (pixels == 0) return {};
  return {sum / static_cast<double>(pixels), static_cast<double>(lit) / static_cast<double>(pixels)};
}

/// Folders of the shipped cases that are drawn from a recipe. What was recorded keeps the light of its machine.
std::vector<std::string> drawnIds() {
  std::vector<std::string> ids;
  for (const Case& each : listCases(*shippedCasesFolder()).cases)
    if (!each.volume.recipe.empty()) ids.push_back(each.folder.filename().string());
  return ids;
}

class ShippedPlanes : public ::testing::TestWithParam<std::string> {};

/// At 0 dB a case once had a mean of 15 to 29 over its planes and two thirds of some fans black, so that a trainee took six steps of gain
/// to see anything. Now cases have 36 to 69, and the darkest plane shows something in 56 % of its fan (resources/docs/science/realism.md,
/// "Every target plane"). The draft is looked at, which is as bright as the case and made in seconds.
TEST_P(ShippedPlanes, CanBeReadAtTheSettingsTheCaseBeginsWith) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const auto opened = loadCase(*shippedCasesFolder() / GetParam());
  ASSERT_TRUE(opened) << opened.error();
  const auto truth = loadCaseTruth(*opened, noProgress());
  ASSERT_TRUE(truth) << truth.error();
  ASSERT_FALSE(truth->planes.empty());
  const auto there = beginningsThere();
  ASSERT_TRUE(there) << there.error();
  const auto contents = readContents(*opened, noProgress(), {.draft = true});
  ASSERT_TRUE(contents) << contents.error();
  const ScanSubject subject = subjectOf(*opened, *contents);
  const auto first = firstState(subject, there->probes, there->presets);
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->scene.liveEchoes);
  EXPECT_EQ(first->knobs.gain_db, 0.0) << "nobody turned the gain";

  Scanner scanner;
  scanner.show(subject);
  double sum = 0.0;
  for (const ReferencePlane& plane : truth->planes) {
    ScanState state = *first;
    state.pose = {.probeToWorld = plane.probeToWorld};
    const DisplayImage image = scanner.make(state, kWidth_px, kHeight_px);
    const Light light = lightOf(image, fanSpans(state.probe, state.knobs, scanner.geometry()));
    std::printf("%s, %s: mean grey %.0f, lit %.0f %%\n", GetParam().c_str(), plane.name.c_str(), light.mean, 100.0 * light.share);
    EXPECT_GT(light.share, 0.45) << plane.name;
    sum += light.mean;
  }
  const double mean = sum / static_cast<double>(truth->planes.size());
  EXPECT_GT(mean, 30.0);
  EXPECT_LT(mean, 80.0);
}

INSTANTIATE_TEST_SUITE_P(Cases, ShippedPlanes, ::testing::ValuesIn(drawnIds()), test::nameOfCase);

}  // namespace
}  // namespace ew::shipped_planes_test
