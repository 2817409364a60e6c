// Makes ten frames of the neutral plan, or what they amount to without any plan, for callgrind to count their instructions.
// neutral_frames <plan|slice> <weave|linear|cubic>

#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <string_view>

#include "ew/imaging/frame.h"

namespace ew {
namespace {

constexpr int kWidth = 320, kHeight = 240;

Volume bodyVolume() {
  Volume volume;
  volume.grid.dims = {96, 128, 80};
  volume.grid.spacing_mm = {1.5, 1.2, 1.8};
  volume.grid.origin_mm = {-71.0, -60.0, -71.0};
  volume.echo.resize(volume.grid.voxelCount());
  unsigned state = 1;
  for (std::uint8_t& voxel : volume.echo) voxel = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24);
  return volume;
}

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 55.0;
  probe.halfAngle_rad = 32.0 * std::numbers::pi / 180.0;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 240.0;
  probe.defaultDepth_mm = 120.0;
  return probe;
}

/// The same pose again and again, so that every frame does the same work.
Pose posed() {
  Pose pose;
  pose.probeToWorld.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), {1.0, -55.0, 2.0}), 0.3, {0.2, 1.0, 0.1});
  return pose;
}

/// Of the last image: both ways must show the same.
unsigned sumOf(ImageView<const std::uint8_t> image) {
  unsigned sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum = 31 * sum + image.at(x, y);
  return sum;
}

/// The first frame binds functions and fills scratch memory; the others are counted.
template <class Make>
void count(const Make& make) {
  make();
  CALLGRIND_TOGGLE_COLLECT;
  for (int n = 0; n < 10; ++n) make();
  CALLGRIND_TOGGLE_COLLECT;
}

void countPlan(const Volume& volume, const Knobs& knobs) {
  FrameMaker maker;
  maker.configure(convexProbe(), knobs, {}, volume.grid, kWidth, kHeight);
  const Pose pose = posed();
  count([&] { maker.make(volume.view(), pose); });
  std::printf("image %u\n", sumOf(maker.make(volume.view(), pose).grey));
}

void countSlice(const Volume& volume, const Knobs& knobs) {
  const DisplayGeometry geometry = fitDisplay(convexProbe(), knobs, kWidth, kHeight);
  const Spans spans = fanSpans(convexProbe(), knobs, geometry);
  GreyImage image(kWidth, kHeight);
  SliceScratch scratch;
  const Pose pose = posed();
  count([&] {
    const auto imageToVoxel = volume.grid.worldToVoxel() * pose.probeToWorld * geometry.imageToProbe();
    slice(knobs.quality, volume.view(), imageToVoxel, spans, viewOf(image), scratch);
  });
  std::printf("image %u\n", sumOf(viewOf(image)));
}

}  // namespace
}  // namespace ew

int main(int count, char** words) {
  if (count != 3) return EXIT_FAILURE;
  const std::string_view way = words[1], name = words[2];
  ew::Knobs knobs;
  knobs.quality = name == "weave" ? ew::Quality::weave : name == "linear" ? ew::Quality::linear : ew::Quality::cubic;
  const ew::Volume volume = ew::bodyVolume();
  if (way == "plan")
    ew::countPlan(volume, knobs);
  else
    ew::countSlice(volume, knobs);
  return EXIT_SUCCESS;
}
