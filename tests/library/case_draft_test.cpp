// A case of a recipe is shown at once, from coarser voxels, and nothing of that is kept or taken for the volume itself.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ew/library/preparation.h"
#include "library/pipeline_fixture.h"
#include "library/small_case.h"

namespace ew::case_draft_test {
namespace {

using nlohmann::json;
using test::CasePipeline;
using test::opened;
using test::textOf;
using test::writeText;

/// The ball with a shining cyst, drawn without sweeps.
class CaseDraft : public CasePipeline {
 protected:
  void SetUp() override {
    CasePipeline::SetUp();
    json patient = json::parse(textOf(folder / "case/patient.json"));
    patient["organs"][0]["border"] = {{"echo_level", 200}, {"width_mm", 0.8}};
    writeText(folder / "case/patient.json", patient.dump());
    setSpacing(1.2);
    writeText(folder / "cache/speed.json", R"({"voxels": 5.0})");  // a machine so slow that even this is worth a draft
  }
  void setSpacing(double spacing_mm) {
    json manifest = json::parse(textOf(folder / "case/case.json"));
    manifest["volume"] = {{"recipe", "patient.json"}, {"recipe_spacing_mm", spacing_mm}};
    writeText(folder / "case/case.json", manifest.dump());
  }
};

TEST_F(CaseDraft, HasTheMapsOfTheWholeOnTheirGridWithinWhatCoarserVoxelsCanTell) {
  const Case drawn = opened(folder / "case");
  ASSERT_TRUE(mayBeDrafted(drawn));
  const auto draft = loadCaseVolume(drawn, noProgress(), {.draft = true});
  ASSERT_TRUE(draft) << draft.error();
  EXPECT_TRUE(draft->isDraft);
  EXPECT_TRUE(caseNeedsPreparation(drawn)) << "nothing is kept";
  const auto whole = loadCaseVolume(drawn, noProgress(), {.draft = false});
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_FALSE(whole->isDraft);

  ASSERT_TRUE(draft->tissue && whole->tissue && draft->labels && whole->labels);
  EXPECT_EQ(draft->tissue->grid, whole->tissue->grid) << "so that a place keeps its speckle";
  EXPECT_EQ(draft->tissue->surfaces, whole->tissue->surfaces);
  EXPECT_EQ(draft->tissues, whole->tissues);
  EXPECT_NEAR(draft->volume.grid.spacing_mm.x, kDraftCoarseness * 1.2, 1e-12);
  EXPECT_EQ(draft->labels->grid, draft->volume.grid);

  const Grid& grid = whole->tissue->grid;
  const glm::dvec3 middle_mm(0.0, -20.0, 0.0);
  constexpr double kCyst_mm = 12.0, kBody_mm = 60.0, kCoarse_mm = kDraftCoarseness * 1.2 * 1.733;
  std::size_t compared = 0, onSurface = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 p_mm = grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k);
        const double cyst_mm = glm::length(p_mm - middle_mm) - kCyst_mm, body_mm = glm::length(p_mm) - kBody_mm;
        const std::size_t at = grid.indexOf(i, j, k);
        if (std::abs(cyst_mm) > kCoarse_mm && std::abs(body_mm) > kCoarse_mm) {
          ++compared;
          ASSERT_EQ(draft->tissue->level[at], whole->tissue->level[at]) << i << " " << j << " " << k;
        }
        if (std::abs(cyst_mm) < 1.0) {
          ++onSurface;
          // Between coarse voxels a ball of 12 mm is a facet: h^2 / 4 R is 0.27 mm.
          ASSERT_EQ(draft->tissue->surfaceKind[at], whole->tissue->surfaceKind[at]) << i << " " << j << " " << k;
          const double found_mm = (draft->tissue->surfaceDistance[at] - 128.0) / TissueMaps::kDistanceStepsPerMm;
          ASSERT_NEAR(found_mm, cyst_mm, 0.5) << "a line, not stairs of " << kDraftCoarseness * 1.2 << " mm";
        }
      }
  EXPECT_GT(compared, 100000u);
  EXPECT_GT(onSurface, 1000u);
}

TEST_F(CaseDraft, IsLeftOutWhereTheVolumeIsThereOrAsQuick) {
  const Case drawn = opened(folder / "case");
  const auto whole = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_FALSE(mayBeDrafted(drawn));
  const auto again = loadCaseVolume(drawn, noProgress(), {.draft = true});
  ASSERT_TRUE(again) << again.error();
  EXPECT_FALSE(again->isDraft);
  EXPECT_EQ(again->volume.echo, whole->volume.echo);

  setSpacing(6.0);
  const Case quick = opened(folder / "case");
  EXPECT_TRUE(caseNeedsPreparation(quick));
  EXPECT_FALSE(mayBeDrafted(quick)) << "it is there before a draft would be";
  const auto made = loadCaseVolume(quick, noProgress(), {.draft = true});
  ASSERT_TRUE(made) << made.error();
  EXPECT_FALSE(made->isDraft);
}

TEST_F(CaseDraft, IsStopped) {
  class Stop final : public Progress {
   public:
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } stop;
  const auto made = loadCaseVolume(opened(folder / "case"), stop, {.draft = true});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::case_draft_test
