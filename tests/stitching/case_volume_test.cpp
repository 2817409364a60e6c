#include "logic/case_volume.h"

#include <gtest/gtest.h>

namespace ew::stitching::case_volume_test {
namespace {

using nlohmann::json;

Error about(const std::string& field) { return {ErrorCode::badField, verbatim("'" + field + "' is wrong."), {{"field", field}}}; }

/// As the host checks: targets without a place and measurements need a recipe.
std::vector<Error> check(const json& manifest) {
  std::vector<Error> problems;
  if (manifest["title"] == "") problems.push_back(about("title"));
  if (manifest["volume"].contains("recipe")) return problems;
  problems.push_back(about("volume.file"));
  const json none = json::array();
  const json& targets = manifest.contains("targets") ? manifest["targets"] : none;
  for (std::size_t n = 0; n < targets.size(); ++n)
    if (!targets[n].contains("at_mm")) problems.push_back(about("targets[" + std::to_string(n) + "]"));
  if (manifest.contains("measurements")) problems.push_back(about("measurements"));
  return problems;
}

json recipeCase() {
  return {{"title", "aorta"},
          {"volume", {{"recipe", "patient.json"}, {"file_to_world", {1, 2, 3}}, {"sweeps", {"a.json"}}}},
          {"targets", {{{"name", "plane"}}, {{"name", "point"}, {"at_mm", {1, 2, 3}}}, {{"name", "organ"}}}},
          {"measurements", {{{"name", "width"}}, {{"name", "height"}}}}};
}

TEST(CaseVolume, LeavesOutWhatOnlyTheRecipesPatientKnewAndCountsIt) {
  const auto made = caseWithVolume(recipeCase(), {"volumes/stitched.mha", "volumes/stitched-level.mha"}, check);
  EXPECT_TRUE(made.problems.empty()) << made.problems.front();
  EXPECT_EQ(made.targets, 2u);
  EXPECT_EQ(made.measurements, 2u);
  EXPECT_EQ(made.manifest["targets"], json({{{"name", "point"}, {"at_mm", {1, 2, 3}}}}));
  EXPECT_FALSE(made.manifest.contains("measurements"));
  EXPECT_EQ(made.manifest["volume"],
            json({{"file", "volumes/stitched.mha"}, {"level", "volumes/stitched-level.mha"}, {"file_to_world", {1, 2, 3}}}));
  EXPECT_EQ(made.manifest["title"], "aorta");
}

TEST(CaseVolume, LeavesACaseOfAFileAsItIsButForTheVolume) {
  json manifest = recipeCase();
  manifest.erase("measurements");
  manifest["volume"] = {{"file", "old.mha"}};
  manifest["targets"] = json::array({manifest["targets"][1]});
  const auto made = caseWithVolume(manifest, {"new.mha", ""}, check);
  EXPECT_TRUE(made.problems.empty());
  EXPECT_EQ(made.targets + made.measurements, 0u);
  manifest["volume"] = {{"file", "new.mha"}};
  EXPECT_EQ(made.manifest, manifest);
}

/// A box of 10 mm, its first voxel at `at_mm`.
Grid gridAt(double at_mm) {
  Grid grid;
  grid.dims = {11, 11, 11};
  grid.spacing_mm = {1.0, 1.0, 1.0};
  grid.origin_mm = {at_mm, 0.0, 0.0};
  return grid;
}

json fileCase() {
  return {{"title", "my knee"},
          {"volume",
           {{"file", "old.mha"},
            {"labels", "labels.mha"},
            {"level", "old-level.mha"},
            {"attribution", "Example University"},
            {"licence", "CC BY 4.0"},
            {"depth_direction", {0, 1, 0}},
            {"file_to_world", {1, 0, 0, 7, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}},
          {"targets", {{{"name", "structure"}}}}};
}

TEST(CaseVolume, KeepsWhomToNameAndTheLicenceOfACaseOfAFileAndSaysWhatItsVolumeHad) {
  const auto made = caseWithVolume(fileCase(), {"new.mha", "new-level.mha", std::pair(gridAt(0.0), gridAt(2.0))}, check);
  EXPECT_FALSE(made.hadRecipe);
  EXPECT_TRUE(made.hadLabels);
  EXPECT_EQ(made.targets, 1u);
  EXPECT_FALSE(made.isMoved);
  json expected = fileCase()["volume"];
  expected.erase("labels");
  expected["file"] = "new.mha";
  expected["level"] = "new-level.mha";
  EXPECT_EQ(made.manifest["volume"], expected);
  EXPECT_TRUE(caseWithVolume(recipeCase(), {"new.mha", ""}, check).hadRecipe);
}

TEST(CaseVolume, PutsAVolumeOfAnotherRecordingWhereTheOneBeforeLay) {
  const auto made = caseWithVolume(fileCase(), {"new.mha", "", std::pair(gridAt(0.0), gridAt(500.0))}, check);
  EXPECT_TRUE(made.isMoved);
  EXPECT_EQ(made.manifest["volume"]["file_to_world"], json({1, 0, 0, -493.0, 0, 1, 0, 0.0, 0, 0, 1, 0.0, 0, 0, 0, 1}));
  // Without a place it lies at its own coordinates, and so did the one before.
  json manifest = fileCase();
  manifest["volume"].erase("file_to_world");
  EXPECT_EQ(caseWithVolume(manifest, {"new.mha", "", std::pair(gridAt(0.0), gridAt(-500.0))}, check).manifest["volume"]["file_to_world"][3],
            json(500.0));
}

TEST(CaseVolume, TellsWhatStaysWrong) {
  json manifest = recipeCase();
  manifest["title"] = "";
  const auto made = caseWithVolume(manifest, {"new.mha", ""}, check);
  ASSERT_EQ(made.problems.size(), 1u);
  EXPECT_EQ(made.problems[0].context[0].second, "title");
}

}  // namespace
}  // namespace ew::stitching::case_volume_test
