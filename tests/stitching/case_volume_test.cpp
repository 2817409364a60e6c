#include "logic/case_volume.h"

#include <gtest/gtest.h>

namespace ew::stitching::case_volume_test {
namespace {

Error about(const std::string& field) { return {ErrorCode::badField, verbatim("'" + field + "' is wrong."), {{"field", field}}}; }

/// As the host checks: targets without a place and measurements need a recipe.
std::vector<Error> check(const Case& edited) {
  std::vector<Error> problems;
  if (edited.title.empty()) problems.push_back(about("title"));
  if (!edited.volume.recipe.empty()) return problems;
  problems.push_back(about("volume.file"));
  for (std::size_t n = 0; n < edited.targets.size(); ++n)
    if (!edited.targets[n].at_mm) problems.push_back(about("targets[" + std::to_string(n) + "]"));
  if (!edited.measurements.empty()) problems.push_back(about("measurements"));
  return problems;
}

CaseTarget target(const std::string& name, std::optional<glm::dvec3> at_mm = {}) {
  CaseTarget made;
  made.kind = at_mm ? CaseTarget::Kind::point : CaseTarget::Kind::structure;
  made.name = name;
  made.at_mm = at_mm;
  return made;
}

Case recipeCase() {
  Case made;
  made.title = "aorta";
  made.volume.recipe = "patient.json";
  made.volume.recipeSpacing_mm = 0.8;
  made.volume.sweeps = {"a.json"};
  made.volume.fileToWorld.matrix[3] = glm::dvec4(1.0, 2.0, 3.0, 1.0);
  made.targets = {target("plane"), target("point", glm::dvec3(1.0, 2.0, 3.0)), target("organ")};
  made.measurements.resize(2);
  return made;
}

TEST(CaseVolume, LeavesOutWhatOnlyTheRecipesPatientKnewAndCountsIt) {
  const auto made = caseWithVolume(recipeCase(), {"volumes/stitched.mha", "volumes/stitched-level.mha"}, check);
  EXPECT_TRUE(made.problems.empty()) << made.problems.front();
  EXPECT_EQ(made.targets, 2u);
  EXPECT_EQ(made.measurements, 2u);
  Case expected = recipeCase();
  expected.targets = {target("point", glm::dvec3(1.0, 2.0, 3.0))};
  expected.measurements.clear();
  expected.volume = {};
  expected.volume.file = "volumes/stitched.mha";
  expected.volume.level = "volumes/stitched-level.mha";
  expected.volume.fileToWorld = recipeCase().volume.fileToWorld;
  EXPECT_EQ(made.edited, expected);
}

TEST(CaseVolume, LeavesACaseOfAFileAsItIsButForTheVolume) {
  Case opened = recipeCase();
  opened.measurements.clear();
  opened.volume = {};
  opened.volume.file = "old.mha";
  opened.targets = {recipeCase().targets[1]};
  const auto made = caseWithVolume(opened, {"new.mha", ""}, check);
  EXPECT_TRUE(made.problems.empty());
  EXPECT_EQ(made.targets + made.measurements, 0u);
  opened.volume.file = "new.mha";
  EXPECT_EQ(made.edited, opened);
}

/// A box of 10 mm, its first voxel at `at_mm`.
Grid gridAt(double at_mm) {
  Grid grid;
  grid.dims = {11, 11, 11};
  grid.spacing_mm = {1.0, 1.0, 1.0};
  grid.origin_mm = {at_mm, 0.0, 0.0};
  return grid;
}

Case fileCase() {
  Case made;
  made.title = "my knee";
  made.volume.file = "old.mha";
  made.volume.labels = "labels.mha";
  made.volume.frames = "old-frames.mha";
  made.volume.level = "old-level.mha";
  made.volume.fileToWorld.matrix[3] = glm::dvec4(7.0, 0.0, 0.0, 1.0);
  made.otherFields["volume"] = {{"attribution", "Example University"}, {"licence", "CC BY 4.0"}, {"depth_direction", {0, 1, 0}}};
  made.targets = {target("structure")};
  return made;
}

TEST(CaseVolume, KeepsWhomToNameAndTheLicenceOfACaseOfAFileAndSaysWhatItsVolumeHad) {
  const auto made = caseWithVolume(fileCase(), {"new.mha", "new-level.mha", std::pair(gridAt(0.0), gridAt(2.0))}, check);
  EXPECT_FALSE(made.hadRecipe);
  EXPECT_TRUE(made.hadLabels);
  EXPECT_TRUE(made.hadFrames);
  EXPECT_EQ(made.targets, 1u);
  EXPECT_FALSE(made.isMoved);
  CaseVolume expected = fileCase().volume;
  expected.labels.clear();
  expected.frames.clear();  // else slices would show the images of the volume before
  expected.file = "new.mha";
  expected.level = "new-level.mha";
  EXPECT_EQ(made.edited.volume, expected);
  EXPECT_EQ(made.edited.otherFields, fileCase().otherFields);
  EXPECT_TRUE(caseWithVolume(recipeCase(), {"new.mha", ""}, check).hadRecipe);
  Case formed = fileCase();
  formed.otherFields["echoes"] = {{"motion", {{"file", "echoes/motion.bin"}}}};
  EXPECT_EQ(caseWithVolume(formed, {"new.mha", "new-level.mha"}, check).edited.otherFields, fileCase().otherFields)
      << "they lie on the grid of the volume before";
}

TEST(CaseVolume, PutsAVolumeOfAnotherRecordingWhereTheOneBeforeLay) {
  const auto made = caseWithVolume(fileCase(), {"new.mha", "", std::pair(gridAt(0.0), gridAt(500.0))}, check);
  EXPECT_TRUE(made.isMoved);
  EXPECT_EQ(made.edited.volume.fileToWorld.matrix[3], glm::dvec4(-493.0, 0.0, 0.0, 1.0));
  // Without a place it lies at its own coordinates, and so did the one before.
  Case unplaced = fileCase();
  unplaced.volume.fileToWorld = {};
  EXPECT_EQ(caseWithVolume(unplaced, {"new.mha", "", std::pair(gridAt(0.0), gridAt(-500.0))}, check).edited.volume.fileToWorld.matrix[3],
            glm::dvec4(500.0, 0.0, 0.0, 1.0));
}

TEST(CaseVolume, TellsWhatStaysWrong) {
  Case untitled = recipeCase();
  untitled.title.clear();
  const auto made = caseWithVolume(untitled, {"new.mha", ""}, check);
  ASSERT_EQ(made.problems.size(), 1u);
  EXPECT_EQ(made.problems[0].context[0].second, "title");
}

}  // namespace
}  // namespace ew::stitching::case_volume_test
