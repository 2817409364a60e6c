#include "ew/phantom/label_grid.h"

#include <gtest/gtest.h>

#include "phantom/recipes.h"

namespace ew::label_grid_test {
namespace {

std::shared_ptr<const Patient> shipped() {
  auto patient = readPatient(testing::shippedPatient());
  EXPECT_TRUE(patient) << patient.error();
  return patient ? *patient : nullptr;
}

/// An oblique grid with three different spacings through the gall bladder, partly outside the skin.
Grid obliqueGrid() {
  Grid grid;
  grid.dims = {37, 41, 29};
  grid.spacing_mm = {2.5, 3.0, 3.5};
  grid.origin_mm = {-110.0, -120.0, -120.0};
  const double c = std::cos(0.3), s = std::sin(0.3);
  grid.directions = glm::dmat3({c, s, 0}, {-s, c, 0}, {0, 0, 1});
  return grid;
}

TEST(LabelsOn, AreWhatLabelAtSaysOfEveryVoxelCentre) {
  const auto patient = shipped();
  ASSERT_TRUE(patient);
  const Grid grid = obliqueGrid();
  const auto labels = labelsOn(*patient, grid, 2, noProgress());
  ASSERT_TRUE(labels) << labels.error();
  ASSERT_EQ(labels->size(), grid.voxelCount());
  std::size_t different = 0, labelled = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const int expected = labelAt(*patient, (grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at);
        const int found = (*labels)[grid.indexOf(i, j, k)];
        if (found != expected) ++different;
        if (expected != 0) ++labelled;
      }
  EXPECT_EQ(different, 0u);
  EXPECT_GT(labelled, grid.voxelCount() / 10) << "the grid lies in the body";
}

TEST(LabelsOn, DoNotDependOnTheNumberOfThreads) {
  const auto patient = shipped();
  ASSERT_TRUE(patient);
  const auto one = labelsOn(*patient, obliqueGrid(), 1, noProgress());
  const auto eight = labelsOn(*patient, obliqueGrid(), 8, noProgress());
  ASSERT_TRUE(one && eight);
  EXPECT_EQ(*one, *eight);
}

TEST(LabelsOn, RefusesWhatDoesNotFitAndStopsWhenAsked) {
  const auto patient = shipped();
  ASSERT_TRUE(patient);
  const auto tooLarge = labelsOn(*patient, obliqueGrid(), 1, noProgress(), 1000);
  ASSERT_FALSE(tooLarge);
  EXPECT_EQ(tooLarge.error().code, ErrorCode::tooLarge);
  EXPECT_FALSE(labelsOn(*patient, Grid{}, 1, noProgress())) << "a grid without voxels";
  class Cancel final : public Progress {
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } cancel;
  const auto stopped = labelsOn(*patient, obliqueGrid(), 2, cancel);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::label_grid_test
