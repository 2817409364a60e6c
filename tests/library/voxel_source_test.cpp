#include "ew/library/voxel_source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "ew/imaging/display.h"

namespace ew::voxel_source_test {
namespace {

namespace fs = std::filesystem;

/// A recording as the window takes it, in one go.
Result<SweepReconstruction> tracedFile(const fs::path& file, const SweepImportOptions& options) {
  auto opened = openSweep(file, options, noProgress());
  if (!opened) return passOn(opened.error());
  return importTracedSweep(std::move(*opened), file, options, noProgress());
}

class VoxelSourceOfASweep : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("echoweave_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Twelve 20 x 10 frames, 1 mm a pixel, 2 mm apart along z; frame 3 has no pose.
  [[nodiscard]] fs::path sweep(int frames = 12) const {
    Sequence sequence;
    sequence.width = 20;
    sequence.height = 10;
    sequence.orientation = "MF";
    sequence.imageType = "BRIGHTNESS";
    for (int n = 0; n < frames; ++n) {
      SequenceFrame frame;
      frame.time_s = 10.0 + 0.25 * n;
      FrameTransform image{"Image", "Reference", glm::dmat4(1.0), n == 3 ? PoseStatus::invalid : PoseStatus::ok};
      image.matrix[3] = glm::dvec4(100.0, 200.0, 2.0 * n, 1.0);
      frame.transforms.push_back(image);
      sequence.frames.push_back(frame);
      sequence.pixels.insert(sequence.pixels.end(), 200, static_cast<std::uint8_t>(20 + 10 * n));
    }
    const fs::path file = folder_ / "sweep.igs.mha";
    EXPECT_TRUE(writeSequence(sequence, file).has_value());
    return file;
  }

  [[nodiscard]] static SweepImportOptions filledTo(double reach_mm) {
    SweepImportOptions options;
    options.reconstruct.spacing_mm = 1.0;
    options.reconstruct.interpolation = Interpolation::nearest;
    options.reconstruct.fillReach_mm = reach_mm;
    options.reconstruct.threads = 1;
    options.reconstruct.keepSource = true;
    return options;
  }

  fs::path folder_;
};

/// An image of 200 x 200 pixels whose plane is the world's x-y plane at z.
Pose poseAt(double z_mm) {
  Pose pose;
  pose.probeToWorld.matrix[3] = glm::dvec4(110.0, 200.0, z_mm, 1.0);
  return pose;
}

DisplayGeometry geometryOf(bool markerLeft, bool upsideDown, double pixel_mm) {
  return {200, 200, pixel_mm, {100.0, upsideDown ? 190.0 : 10.0}, markerLeft, upsideDown, 50.0};
}

TEST_F(VoxelSourceOfASweep, APixelLeadsToTheFrameAndItsPixelHoweverTheImageIsTurned) {
  const auto traced = tracedFile(sweep(), filledTo(0.0));
  ASSERT_TRUE(traced.has_value()) << traced.error();
  const Provenance& from = traced->provenance;
  const Volume& volume = traced->imported.reconstruction.volume;
  ASSERT_EQ(from.frames.size(), 11U);
  EXPECT_EQ(from.recordedFrames, 12U);
  EXPECT_TRUE(traced->imported.reconstruction.source.empty());
  // The volume lies elsewhere in the body, and turned.
  Transform<frame::World, frame::World> place;
  place.matrix[0] = {0.0, 1.0, 0.0, 0.0};
  place.matrix[1] = {-1.0, 0.0, 0.0, 0.0};
  place.matrix[3] = {7.0, -40.0, 11.0, 1.0};
  const Grid moved = placed(volume.grid, place);
  for (const bool markerLeft : {false, true}) {
    for (const bool upsideDown : {false, true}) {
      for (const double pixel_mm : {0.1, 0.25}) {
        const DisplayGeometry geometry = geometryOf(markerLeft, upsideDown, pixel_mm);
        Pose pose = poseAt(14.2);  // beside frame 7, which is the seventh with a pose
        pose.probeToWorld = place * pose.probeToWorld;
        // 4 mm along +x and 3.3 mm deep of the face: pixel (14, 3.3) of the frame.
        const glm::dvec2 pixel = geometry.face_px + glm::dvec2((markerLeft ? -4.0 : 4.0), (upsideDown ? -3.3 : 3.3)) / pixel_mm;
        const VoxelSource found = voxelSourceAt(from, volume, moved, pointShownAt(geometry, pose, pixel));
        ASSERT_EQ(found.found, VoxelSource::Found::frame);
        EXPECT_EQ(from.frames[found.frame].number, 7U);
        EXPECT_EQ(from.frames[found.frame].time_s, 11.75);
        EXPECT_NEAR(found.at_px.x, 14.0, 1e-9);
        EXPECT_NEAR(found.at_px.y, 3.3, 1e-9);
        EXPECT_NEAR(found.distance_mm, 0.2, 1e-9);
        EXPECT_EQ(found.voxel, glm::ivec3(14, 3, 14));
        EXPECT_EQ(found.coverage, Coverage::measured);
      }
    }
  }
}

TEST_F(VoxelSourceOfASweep, SaysWhatWasFilledWhatIsAbsentAndWhatLiesOutside) {
  const auto traced = tracedFile(sweep(), filledTo(2.5));
  ASSERT_TRUE(traced.has_value()) << traced.error();
  const Volume& volume = traced->imported.reconstruction.volume;
  const auto at = [&](double z_mm) { return voxelSourceAt(traced->provenance, volume, volume.grid, {{110.0, 205.0, z_mm}}); };
  const VoxelSource filled = at(10.8);  // voxel 11 between frames 5 and 6
  ASSERT_EQ(filled.found, VoxelSource::Found::frame);
  EXPECT_EQ(filled.coverage, Coverage::interpolated);
  const std::size_t number = traced->provenance.frames[filled.frame].number;
  EXPECT_TRUE(number == 5 || number == 6) << number;
  EXPECT_EQ(at(6.0).found, VoxelSource::Found::absent);  // frame 3 has no pose, and from 4 to 8 is farther than the reach
  EXPECT_EQ(at(6.0).coverage, Coverage::absent);
  EXPECT_EQ(at(23.0).found, VoxelSource::Found::outside);
  EXPECT_EQ(at(std::nan("")).found, VoxelSource::Found::outside);
}

TEST_F(VoxelSourceOfASweep, ReadsTheFramesAgainUnlessTheRecordingIsGoneOrAnother) {
  const fs::path file = sweep();
  const auto traced = tracedFile(file, filledTo(0.0));
  ASSERT_TRUE(traced.has_value()) << traced.error();
  const auto images = readTracedImages(traced->provenance, noProgress());
  ASSERT_TRUE(images.has_value()) << images.error();
  for (const FrameProvenance& frame : traced->provenance.frames) EXPECT_EQ(images->framePixels(frame.number)[57], 20 + 10 * frame.number);
  static_cast<void>(sweep(11));
  EXPECT_EQ(readTracedImages(traced->provenance, noProgress()).error().code, ErrorCode::badField);
  fs::remove(file);
  EXPECT_EQ(readTracedImages(traced->provenance, noProgress()).error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::voxel_source_test
