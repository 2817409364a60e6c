#include "ew/bridge/convert.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <numeric>

namespace ew::bridge::convert_test {
namespace {

glm::dmat4 withoutSymmetry() { return matrixFromRows({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}); }

Volume oblique() {
  Volume volume;
  volume.grid.dims = {3, 4, 5};
  volume.grid.spacing_mm = {0.5, 1.5, 2.5};
  volume.grid.origin_mm = {-7.0, 11.0, 13.0};
  volume.grid.directions = glm::dmat3(glm::dvec3(0.6, 0.8, 0.0), glm::dvec3(-0.8, 0.6, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  volume.echo.resize(60);
  std::iota(volume.echo.begin(), volume.echo.end(), std::uint8_t{1});
  return volume;
}

TEST(Convert, AMatrixWithoutSymmetrySurvivesTheRoundTrip) {
  const auto matrix = toVtk(withoutSymmetry());
  EXPECT_EQ(matrix->GetElement(0, 1), 2.0) << "row 0, column 1";
  EXPECT_EQ(matrix->GetElement(1, 0), 5.0);
  EXPECT_EQ(toGlm(*matrix), withoutSymmetry());
}

TEST(Convert, BothLibrariesMoveAPointAlike) {
  const glm::dvec4 p(0.5, -1.5, 2.5, 1.0);
  const auto matrix = toVtk(withoutSymmetry());
  double moved[4];
  matrix->MultiplyPoint(&p.x, moved);
  const glm::dvec4 expected = withoutSymmetry() * p;
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(moved[i], expected[i]);
}

TEST(Convert, AVolumeIsSharedWithVtkAndLiesWhereItLay) {
  const auto volume = std::make_shared<const Volume>(oblique());
  const auto image = toVtk(volume);
  EXPECT_EQ(image->GetScalarPointer(), static_cast<const void*>(volume->echo.data())) << "no copy";
  int ijk[3] = {2, 1, 3};
  EXPECT_EQ(image->GetScalarComponentAsDouble(2, 1, 3, 0), volume->echo[volume->grid.indexOf(2, 1, 3)]);
  glm::dvec3 at;
  image->TransformIndexToPhysicalPoint(ijk, &at.x);
  const glm::dvec3 expected = (volume->grid.voxelToWorld() * Point<frame::Voxel>{{2, 1, 3}}).at;
  EXPECT_LT(glm::distance(at, expected), 1e-12);
}

TEST(Convert, TheImageKeepsItsVolumeAlive) {
  auto volume = std::make_shared<const Volume>(oblique());
  const std::weak_ptr<const Volume> watched = volume;
  auto image = toVtk(std::move(volume));
  EXPECT_FALSE(watched.expired());
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 0, 0, 0), 1.0);
  image = nullptr;
  EXPECT_TRUE(watched.expired());
}

TEST(Convert, AVolumeSurvivesTheRoundTrip) {
  const Volume volume = oblique();
  const auto back = toVolume(*toVtk(volume.view()));
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(*back, volume);
}

TEST(Convert, AnExtentThatDoesNotStartAtZeroMovesTheOrigin) {
  const Volume volume = oblique();
  auto image = toVtk(volume.view());
  image->SetExtent(10, 12, -3, 0, 5, 9);
  const auto back = toVolume(*image);
  ASSERT_TRUE(back) << back.error();
  const glm::dvec3 expected = (volume.grid.voxelToWorld() * Point<frame::Voxel>{{10, -3, 5}}).at;
  EXPECT_LT(glm::distance(back->grid.origin_mm, expected), 1e-12);
}

TEST(Convert, AnImageOfOtherScalarsIsRefusedWithAReason) {
  vtkNew<vtkImageData> image;
  EXPECT_EQ(toVolume(*image).error().code, ErrorCode::emptyVolume);
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_EQ(toVolume(*image).error().code, ErrorCode::unsupported);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  EXPECT_EQ(toVolume(*image).error().code, ErrorCode::unsupported);
}

}  // namespace
}  // namespace ew::bridge::convert_test
