#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "ew/acquisition/confidence.h"
#include "ew/io/sequence.h"
#include "ew/io/sweep.h"
#include "recordings.h"

namespace ew::confidence_data_test {
namespace {

namespace fs = std::filesystem;

struct View {
  Sequence sequence;
  SweepPoses poses;
  std::vector<TrackedFrame> frames;
};

View viewOfFile(const fs::path& file) {
  View view;
  auto sequence = readSequence(file);
  if (!sequence) {
    ADD_FAILURE() << sequence.error();
    return view;
  }
  auto poses = sweepPoses(*sequence);
  if (!poses) {
    ADD_FAILURE() << poses.error();
    return view;
  }
  view.sequence = std::move(*sequence);
  view.poses = std::move(*poses);
  for (std::size_t n = 0; n < view.sequence.frames.size(); ++n)
    view.frames.push_back({{view.sequence.framePixels(n).data(), view.sequence.width, view.sequence.height, view.sequence.width},
                           *view.poses.imageToWorld[n]});
  return view;
}

/// Mean level of 9 x 17 pixels about one; -1 near the border.
double meanAround(const ImageView<const std::uint8_t>& image, int x, int y) {
  if (x < 4 || y < 8 || x >= image.width - 4 || y >= image.height - 16) return -1.0;
  double sum = 0.0;
  for (int v = y - 8; v <= y + 8; ++v)
    for (int u = x - 4; u <= x + 4; ++u) sum += image.row(v)[u];
  return sum / 153.0;
}

/// Share of pairs (seen, shadowed) that the confidence puts in the right order.
double areaUnderCurve(std::vector<float> seen, std::vector<float> shadowed) {
  std::sort(seen.begin(), seen.end());
  double pairs = 0.0;
  for (const float c : shadowed) {
    const auto [from, to] = std::equal_range(seen.begin(), seen.end(), c);
    pairs += static_cast<double>(seen.end() - to) + 0.5 * static_cast<double>(to - from);
  }
  return pairs / (static_cast<double>(seen.size()) * static_cast<double>(shadowed.size()));
}

double medianOf(std::vector<float> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return static_cast<double>(values[values.size() / 2]);
}

/// Truth comes from the second sweep, whose beams run 12.8 degrees apart: what is bright there and dark here lies in shadow here, what is
/// bright in both does not. (The sweeps are simulated from computed tomography.)
TEST(ConfidenceOfSimulatedLiver, TellsWhatTheOtherViewSawFromWhatBothSee) {
  EW_NEEDS_RECORDING("simulated-liver-pair");
  const fs::path data = test::recording("simulated-liver-pair");
  const View here = viewOfFile(data / "liver_sim_r2.igs.mha"), there = viewOfFile(data / "liver_sim_l2.igs.mha");
  for (const auto method : {ConfidenceMethod::beamwise, ConfidenceMethod::randomWalk}) {
    std::vector<float> seen, shadowed;
    ConfidenceScratch scratch;
    double seconds = 0.0;
    int maps = 0;
    for (std::size_t n = 0; n < here.frames.size(); n += 9, ++maps) {
      const auto started = std::chrono::steady_clock::now();
      Image<float> confidence;
      auto image = here.frames[n].pixels;
      image.height -= 6;  // the last rows of every frame are black
      ConfidenceOptions options;
      options.method = method;
      ASSERT_TRUE(confidenceOfLines(image, options, scratch, confidence).has_value());
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
      for (int y = 8; y < image.height; y += 6)
        for (int x = 4; x < image.width; x += 4) {
          const double mine = meanAround(image, x, y);
          if (mine < 0.0) continue;
          // The frame of the other sweep that passes nearest to this pixel.
          const glm::dvec3 p_mm = (here.frames[n].imageToWorld * Point<frame::Image>{{x, y, 0}}).at;
          double nearest_mm = 0.4, other = -1.0;
          for (const TrackedFrame& frame : there.frames) {
            const glm::dvec3 at = (inverse(frame.imageToWorld) * Point<frame::World>{p_mm}).at;
            const double off_mm = std::abs(at.z) * glm::length(glm::dvec3(frame.imageToWorld.matrix[2]));
            if (off_mm >= nearest_mm) continue;
            const double level = meanAround(frame.pixels, static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)));
            if (level < 0.0) continue;
            nearest_mm = off_mm;
            other = level;
          }
          if (other < 36.0) continue;
          const float found =
              confidence.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
          if (mine < 16.0) shadowed.push_back(found);
          if (mine > 36.0) seen.push_back(found);
        }
    }
    ASSERT_GT(shadowed.size(), 100u);
    ASSERT_GT(seen.size(), 1000u);
    const double area = areaUnderCurve(seen, shadowed);
    std::printf("%s: area under the curve %.4f, median in shadow %.3f, in sight %.3f (%zu and %zu places), %.1f ms a frame\n",
                method == ConfidenceMethod::beamwise ? "beam-wise" : "random walk", area, medianOf(shadowed), medianOf(seen),
                shadowed.size(), seen.size(), 1000.0 * seconds / maps);
    EXPECT_GE(area, method == ConfidenceMethod::beamwise ? 0.99 : 0.97);
    EXPECT_LT(medianOf(shadowed), 0.2);
    EXPECT_GT(medianOf(seen), 0.8);
  }
}

}  // namespace
}  // namespace ew::confidence_data_test
