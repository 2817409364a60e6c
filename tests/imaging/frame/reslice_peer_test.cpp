// The same planes through vtkImageReslice: an independent implementation of nearest neighbour and trilinear sampling.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "ew/imaging/slicing.h"
#include "imaging/support/support.h"
#ifdef EW_WITH_IO
#include "ew/io/volume_file.h"
#include "recordings.h"
#endif

namespace ew::reslice_peer_test {
namespace {

using testing::ImageToVoxel;

class Peer {
 public:
  Peer(const Volume& volume, Quality quality, int side) {
    voxels_->SetArray(const_cast<unsigned char*>(volume.echo.data()), static_cast<vtkIdType>(volume.echo.size()), 1);
    image_->SetDimensions(volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.z);
    image_->GetPointData()->SetScalars(voxels_);
    reslice_->SetInputData(image_);
    reslice_->SetOutputDimensionality(2);
    reslice_->SetOutputExtent(0, side - 1, 0, side - 1, 0, 0);
    reslice_->SetOutputOrigin(0, 0, 0);
    reslice_->SetOutputSpacing(1, 1, 1);
    reslice_->SetBorder(1);
    reslice_->SetBackgroundLevel(0);
    quality == Quality::weave ? reslice_->SetInterpolationModeToNearestNeighbor() : reslice_->SetInterpolationModeToLinear();
    reslice_->SetResliceAxes(axes_);
  }
  const std::uint8_t* slice(const ImageToVoxel& plane) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) axes_->SetElement(row, column, plane.matrix[column][row]);
    reslice_->Update();
    return static_cast<const std::uint8_t*>(reslice_->GetOutput()->GetScalarPointer());
  }

 private:
  vtkNew<vtkUnsignedCharArray> voxels_;
  vtkNew<vtkImageData> image_;
  vtkNew<vtkImageReslice> reslice_;
  vtkNew<vtkMatrix4x4> axes_;
};

/// A millionth of a voxel from a face the two may disagree about which side a pixel is on.
bool isDecidable(const Grid& grid, const glm::dvec3& p, bool nearest) {
  for (int a = 0; a < 3; ++a) {
    if (std::abs(p[a] + 0.5) < 1e-5 || std::abs(p[a] - (grid.dims[a] - 0.5)) < 1e-5) return false;
    if (nearest && testing::distanceFromTie(p[a]) < 1e-5) return false;
  }
  return true;
}

void compare(const Volume& volume, const SliceSource& source, Quality quality, int poses, int allowed) {
  constexpr int kSide = 160;
  Peer peer(volume, quality, kSide);
  SliceScratch scratch;
  GreyImage own(kSide, kSide);
  std::mt19937 random(31);
  std::size_t compared = 0, lit = 0;
  for (int n = 0; n < poses; ++n) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, kSide, kSide, n % 2 ? 1.0 : 0.6);
    quality == Quality::weave ? sliceWeave(source, plane, viewOf(own), scratch) : sliceLinear(source, plane, viewOf(own), scratch);
    const std::uint8_t* theirs = peer.slice(plane);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        if (!isDecidable(volume.grid, testing::voxelAt(plane, x, y), quality == Quality::weave)) continue;
        const int mine = viewOf(own).at(x, y), other = theirs[y * kSide + x];
        ASSERT_LE(std::abs(mine - other), allowed) << "pose " << n << " pixel " << x << "," << y << ": " << mine << " against " << other;
        ++compared;
        lit += mine > 0;
      }
  }
  EXPECT_GT(compared, static_cast<std::size_t>(poses) * kSide * kSide * 9 / 10);
  EXPECT_GT(lit, compared / 50);
}

void compareBothLayouts(const Volume& volume, Quality quality, int poses, int allowed) {
  compare(volume, volume.view(), quality, poses, allowed);
  const auto bricks = bricksOf(volume.view(), 1, 1, noProgress());
  ASSERT_TRUE(bricks);
  compare(volume, bricks->source(volume.grid), quality, poses, allowed);
}

TEST(ReslicePeer, LinearDiffersByOneGreyLevelAtMostOnTwoHundredRandomPoses) {
  compareBothLayouts(testing::noiseVolume({90, 110, 70}, 41), Quality::linear, 200, 1);
}

TEST(ReslicePeer, WeaveIsTheirNearestNeighbourOnTwoHundredRandomPoses) {
  compareBothLayouts(testing::noiseVolume({90, 110, 70}, 42), Quality::weave, 200, 0);
}

#ifdef EW_WITH_IO
TEST(ReslicePeer, AgreesOnTheLiverVolume) {
  EW_NEEDS_RECORDING("liver-sweep/liver_volume_1mm.mha");
  const auto volume = readVolume(test::recording("liver-sweep/liver_volume_1mm.mha"), noProgress());
  ASSERT_TRUE(volume) << volume.error();
  compareBothLayouts(volume->volume, Quality::linear, 200, 1);
  compareBothLayouts(volume->volume, Quality::weave, 200, 0);
}
#endif

}  // namespace
}  // namespace ew::reslice_peer_test
