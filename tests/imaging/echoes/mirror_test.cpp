// A probe that is turned by 180 degrees about its axis sees the mirror image.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/frame.h"
#include "imaging/support/probes_at_random.h"
#include "imaging/support/support.h"

namespace ew::mirror_test {
namespace {

TEST(TurnedProbe, SeesTheMirroredImageToThePixel) {
  Volume volume = testing::noiseVolume({120, 140, 100}, 11);
  volume.grid.spacing_mm = {1.3, 1.1, 1.7};
  volume.grid.origin_mm = {-78.0, -20.0, -85.0};
  for (const ProbeKind kind : {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector})
    for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic})
      for (const int width : {301, 300})
        for (int n = 0; n < 4; ++n) {
          const Probe probe = testing::probeOf(kind);
          Knobs knobs;
          knobs.quality = quality;
          FrameMaker maker;
          maker.configure(probe, knobs, {}, volume.grid, width, 240);
          Pose pose;
          pose.probeToWorld.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3.1 * n, -9.7, 1.9 * n)), 0.41 * n,
                                                 glm::normalize(glm::dvec3(0.3, 1.0, -0.2 * n)));
          Pose turned = pose;
          turned.probeToWorld.matrix[0] = -pose.probeToWorld.matrix[0];
          turned.probeToWorld.matrix[2] = -pose.probeToWorld.matrix[2];
          const auto copied = [&](const Pose& at) {
            const ImageView<const std::uint8_t> seen = maker.make(volume.view(), at).grey;
            GreyImage copy(seen.width, seen.height);
            for (int y = 0; y < seen.height; ++y) std::copy_n(seen.row(y), seen.width, viewOf(copy).row(y));
            return copy;
          };
          const GreyImage straight = copied(pose);
          GreyImage mirrored = copied(turned);
          for (int y = 0; y < mirrored.height; ++y) std::reverse(viewOf(mirrored).row(y), viewOf(mirrored).row(y) + mirrored.width);
          int largest = 0;
          for (std::size_t i = 0; i < straight.pixels.size(); ++i)
            largest = std::max(largest, std::abs(straight.pixels[i] - mirrored.pixels[i]));
          // The paper's stretches run from left to right and round each weight down: that is one grey level at most.
          const auto& steps = maker.plan().steps;
          const bool stretched = std::any_of(steps.begin(), steps.end(), [](const Step& s) { return s.kind == StepKind::zoomStretch; });
          EXPECT_LE(largest, stretched ? 1 : 0)
              << "kind " << static_cast<int>(kind) << " quality " << static_cast<int>(quality) << " pose " << n;
          EXPECT_GT(std::count_if(straight.pixels.begin(), straight.pixels.end(), [](std::uint8_t level) { return level > 0; }), 2000);
        }
}

TEST(TurnedProbe, SeesTheMirroredImageAlsoThroughItsBeams) {
  Volume volume = testing::noiseVolume({120, 140, 100}, 17);
  volume.grid.spacing_mm = {1.3, 1.1, 1.7};
  volume.grid.origin_mm = {-78.0, -20.0, -85.0};
  Scene scene;
  scene.focus = FocusEffect{};
  scene.sliceThickness = SliceThicknessEffect{};
  scene.attenuation = AttenuationEffect{};
  for (const ProbeKind kind : {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector}) {
    FrameMaker maker;
    maker.configure(testing::probeOf(kind), {}, scene, volume.grid, 300, 240);
    ASSERT_TRUE(maker.plan().onBeams);
    const auto copied = [&](const Pose& at) {
      const ImageView<const std::uint8_t> seen = maker.make(volume.view(), at).grey;
      GreyImage copy(seen.width, seen.height);
      for (int y = 0; y < seen.height; ++y) std::copy_n(seen.row(y), seen.width, viewOf(copy).row(y));
      return copy;
    };
    Pose pose;
    pose.probeToWorld.matrix =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3.1, -9.7, 1.9)), 0.41, glm::normalize(glm::dvec3(0.3, 1.0, -0.2)));
    Pose turned = pose;
    turned.probeToWorld.matrix[0] = -pose.probeToWorld.matrix[0];
    turned.probeToWorld.matrix[2] = -pose.probeToWorld.matrix[2];
    const GreyImage straight = copied(pose);
    GreyImage mirrored = copied(turned);
    for (int y = 0; y < mirrored.height; ++y) std::reverse(viewOf(mirrored).row(y), viewOf(mirrored).row(y) + mirrored.width);
    int different = 0, largest = 0;
    for (std::size_t i = 0; i < straight.pixels.size(); ++i) {
      different += straight.pixels[i] != mirrored.pixels[i];
      largest = std::max(largest, std::abs(straight.pixels[i] - mirrored.pixels[i]));
    }
    EXPECT_EQ(different, 0) << "kind " << static_cast<int>(kind) << ", largest " << largest;
  }
}

TEST(TurnedProbe, SampledAlongItsLinesSeesTheMirroredLines) {
  const Volume volume = testing::noiseVolume({90, 90, 80}, 5);
  for (const ProbeKind kind : {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector}) {
    const Probe probe = testing::probeOf(kind);
    const BeamGrid grid = makeBeamGrid(probe, {}, 70.0, 0.4);
    Transform<frame::Voxel, frame::Probe> probeToVoxel;
    probeToVoxel.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(44.3, 12.7, 39.1)), 0.3, glm::dvec3(0.3, 0.9, 0.1));
    auto turned = probeToVoxel;
    turned.matrix[0] = -probeToVoxel.matrix[0];
    turned.matrix[2] = -probeToVoxel.matrix[2];
    const auto sampled = [&](const Transform<frame::Voxel, frame::Probe>& toVoxel, glm::dvec2 elevation_mm) {
      std::vector<SampleRow> rows;
      rowsOf(grid, toVoxel, elevation_mm, rows);
      GreyImage lines(grid.samples, static_cast<int>(grid.lines.size()));
      SliceScratch scratch;
      sampleRows(Quality::linear, volume.view(), rows, viewOf(lines), scratch);
      return lines;
    };
    const GreyImage straight = sampled(probeToVoxel, {1.0, 3.0});
    const GreyImage other = sampled(turned, {-1.0, -3.0});
    for (int line = 0; line < straight.height; ++line)
      ASSERT_TRUE(std::equal(viewOf(straight).row(line), viewOf(straight).row(line) + straight.width,
                             viewOf(other).row(straight.height - 1 - line)))
          << line;
  }
}

}  // namespace
}  // namespace ew::mirror_test
