#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "ew/io/sweep.h"
#include "files.h"
#include "recordings.h"

namespace ew::real_files_test {
namespace {
using namespace test;
namespace fs = std::filesystem;

class RealFiles : public ::testing::Test {
 protected:
  void SetUp() override { EW_NEEDS_RECORDING(""); }
  const fs::path data = test::recording("");

  /// Smallest corner, per axis, of all usable frames.
  static glm::dvec3 smallestCorner(const Sequence& sequence, const SweepPoses& poses) {
    glm::dvec3 smallest(std::numeric_limits<double>::infinity());
    for (const auto& pose : poses.imageToWorld)
      for (int corner = 0; pose && corner < 4; ++corner)
        smallest = glm::min(
            smallest, (*pose * Point<frame::Image>{{(corner & 1) * (sequence.width - 1), (corner >> 1) * (sequence.height - 1), 0}}).at);
    return smallest;
  }
};

TEST_F(RealFiles, TheSpineSweepsSmallestCornerIsTheReferencesOrigin) {
  const auto folder = data / "spine-phantom-sweep";
  const auto sequence = readSequence(folder / "SpinePhantomFreehand.igs.mha");
  ASSERT_TRUE(succeeded(sequence));
  EXPECT_EQ(sequence->width, 820);
  EXPECT_EQ(sequence->height, 616);
  EXPECT_EQ(sequence->frames.size(), 21u);
  EXPECT_EQ(sequence->orientation, "MFA");
  EXPECT_EQ(sequence->frames[0].time_s, 215.102186);
  ASSERT_EQ(sequence->frames[0].transforms.size(), 3u);
  EXPECT_EQ(sequence->frames[0].transforms[0].matrix[3][0], 172.641);
  EXPECT_TRUE(sequence->notes.empty());
  const auto set = readDeviceSet(folder / "PlusDeviceSet_VolumeReconstructionOnly_SpinePhantom_NN_MEAN.xml");
  ASSERT_TRUE(succeeded(set));
  EXPECT_EQ(set->interpolation, "NEAREST_NEIGHBOR");
  EXPECT_EQ(set->clipSize_px, glm::dvec2(820, 616));
  const auto poses = sweepPoses(*sequence, &*set);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->toFrame, "Reference");
  EXPECT_EQ(poses->usable, 21u);
  EXPECT_TRUE(contains(poses->notes, "4.8 % off the right angle"));
  for (const char* name : {"vtkVolumeReconstructorTestNNMEANvolumeRef.mha", "SpinePhantomFreehandReconstructed.mha"}) {
    const auto reference = readVolume(folder / name);
    ASSERT_TRUE(succeeded(reference)) << name;
    const glm::dvec3 off = glm::abs(smallestCorner(*sequence, *poses) - reference->volume.grid.origin_mm);
    EXPECT_LT(std::max({off.x, off.y, off.z}), 0.001) << name;
    EXPECT_EQ(reference->volume.grid.spacing_mm, glm::dvec3(0.5)) << name;
  }
}

TEST_F(RealFiles, ReferencesAreVolumesWhateverTheirKindsSay) {
  const auto folder = data / "spine-phantom-sweep";
  struct Known {
    const char* name;
    glm::ivec3 dims;
  };
  for (const auto& [name, dims] : {Known{"vtkVolumeReconstructorTestNNMEANvolumeRef.mha", {147, 106, 105}},
                                   Known{"vtkVolumeReconstructorTestLNMEANvolumeRef.mha", {80, 93, 98}},
                                   Known{"SpinePhantomFreehandReconstructed.mha", {147, 106, 104}}}) {
    EXPECT_EQ(isSequence(folder / name), false) << name;
    const auto loaded = readVolume(folder / name);
    ASSERT_TRUE(succeeded(loaded)) << name;
    EXPECT_EQ(loaded->volume.grid.dims, dims) << name;
  }
}

TEST_F(RealFiles, TheLiverSweepHasItsPosesPerFrame) {
  const auto folder = data / "liver-sweep";
  const auto sequence = readSequence(folder / "liver_sweep.igs.mha");
  ASSERT_TRUE(succeeded(sequence));
  EXPECT_EQ(sequence->width, 739);
  EXPECT_EQ(sequence->height, 593);
  EXPECT_EQ(sequence->frames.size(), 140u);
  EXPECT_EQ(sequence->frames[1].time_s, 0.033);
  const auto poses = sweepPoses(*sequence);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->toFrame, "Reference");
  EXPECT_EQ(poses->usable, 140u);
  EXPECT_NEAR(glm::length(glm::dvec3(poses->imageToWorld[0]->matrix[0])), 0.314818, 1e-5);
  const auto volume = readVolume(folder / "liver_volume_1mm.mha");
  ASSERT_TRUE(succeeded(volume));
  EXPECT_EQ(volume->volume.grid.dims, glm::ivec3(244, 197, 123));
  EXPECT_EQ(volume->volume.grid.origin_mm, glm::dvec3(-123, -102, -46));
}

TEST_F(RealFiles, EveryRecordingComesBackFromOurOwnFile) {
  const TempFolder folder;
  for (const char* name :
       {"spine-phantom-sweep/SpinePhantomFreehand.igs.mha", "curvilinear-scanlines/UltrasonixCurvilinearBrightnessData.igs.mha",
        "wire-phantom-pair/fCal_Test_Validation_3NWires_fCal2.0.igs.mha"}) {
    const auto first = readSequence(data / name);
    ASSERT_TRUE(succeeded(first)) << name;
    ASSERT_TRUE(succeeded(writeSequence(*first, folder / "copy.igs.mha"))) << name;
    const auto second = readSequence(folder / "copy.igs.mha");
    ASSERT_TRUE(succeeded(second)) << name;
    EXPECT_EQ(second->frames, first->frames) << name;
    EXPECT_EQ(second->pixels, first->pixels) << name;
    EXPECT_EQ(second->otherFields, first->otherFields) << name;
  }
}

TEST_F(RealFiles, TheWirePhantomHasItsCalibrationInTheResultsFile) {
  const auto folder = data / "wire-phantom-pair";
  const auto sequence = readSequence(folder / "fCal_Test_Validation_3NWires_fCal2.0.igs.mha");
  ASSERT_TRUE(succeeded(sequence));
  EXPECT_EQ(sequence->frames.size(), 103u);
  const auto set = readDeviceSet(folder / "PlusDeviceSet_fCal_Sim_SpatialCalibration_2.0.xml");
  ASSERT_TRUE(succeeded(set));
  EXPECT_FALSE(set->transforms.empty());
  const auto poses = sweepPoses(*sequence, &*set);
  EXPECT_TRUE(failedWith(poses, ErrorCode::missingCalibration)) << "this device set has no Image to Probe";
  const auto result = readDeviceSet(folder / "FreehandCalibration3NWires_fCal2.0.results.xml");
  ASSERT_TRUE(succeeded(result));
  const auto found = sweepPoses(*sequence, &*result);
  ASSERT_TRUE(succeeded(found));
  EXPECT_EQ(found->toFrame, "Reference");
  EXPECT_EQ(found->usable, 103u);
}

}  // namespace
}  // namespace ew::real_files_test
