#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <vector>

#include "ew/core/order_statistics.h"
#include "ew/imaging/cost_of_accuracy.h"
#include "ew/imaging/frame.h"

// What the two measurements of cost share: of slices (cost_of_accuracy.cpp) and of live echoes (cost_of_echoes.cpp).
namespace ew::detail {

inline constexpr std::size_t kFewestCompared = 256;  ///< pixels that make a figure worth showing

/// Sums of squared differences on the way to a point's figures.
struct Difference {
  double squares = 0.0;
  double worst = 0.0;
  std::size_t count = 0;
  void add(double by) {
    squares += by * by;
    worst = std::max(worst, std::abs(by));
    ++count;
  }
  void putInto(CostPoint& point) const {
    point.rms_grey = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
    point.worst_grey = worst;
    point.psnr_db =
        point.rms_grey > 0.0 ? std::min(20.0 * std::log10(255.0 / point.rms_grey), CostOfAccuracy::kExact_db) : CostOfAccuracy::kExact_db;
  }
};

/// Poses around the given one, spread evenly over turns and tips; the first is the given one.
inline std::vector<Pose> posesAround(const Pose& pose, int count) {
  std::vector<Pose> poses{pose};
  constexpr double kFarthest_rad = 0.21;
  for (int n = 1; n < count; ++n) {
    // Fractions of the golden ratio and of its square fill the square of angles evenly for any count.
    const double turn = std::fmod(n * 0.6180339887498949, 1.0) * 2.0 - 1.0;
    const double tip = std::fmod(n * 0.7548776662466927, 1.0) * 2.0 - 1.0;
    Pose next = pose;
    next.probeToWorld.matrix = glm::rotate(next.probeToWorld.matrix, turn * kFarthest_rad, glm::dvec3(0.0, 1.0, 0.0));
    next.probeToWorld.matrix = glm::rotate(next.probeToWorld.matrix, tip * kFarthest_rad, glm::dvec3(1.0, 0.0, 0.0));
    poses.push_back(next);
  }
  return poses;
}

inline double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return upperMedianOf(std::span(values));
}

/// What is measured with: one setting at a time, so that they do not share a warm cache of tables.
struct CostBench {
  const FrameInput& subject;  ///< its pose is each of `poses` in turn
  const Probe& probe;
  const Scene& scene;
  const std::vector<Pose>& poses;
  int width, height;
  const CostOptions& options;

  /// Median time of a frame, ms; `seen` gets the image of each pose. @return negative when cancelled or no image was made
  template <class Seen>
  double time_ms(const Knobs& knobs, Progress& progress, const Seen& seen) const {
    FrameMaker maker(options.threads);
    maker.configure(probe, knobs, scene, subject.echo.grid, width, height,
                    {.labels = !subject.labels.empty(), .tissue = subject.tissue != nullptr});
    std::vector<double> times_ms;
    for (const Pose& pose : poses) {
      FrameInput input = subject;
      input.pose = pose;
      for (int n = 0; n <= options.repeats; ++n) {
        if (progress.cancelRequested()) return -1.0;
        const auto begin = std::chrono::steady_clock::now();
        const ImageView<const std::uint8_t> image = maker.make(input).grey;
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        if (maker.lastStatus() != PoseStatus::ok) return -1.0;
        if (n > 0) times_ms.push_back(took.count());
        if (n == 0) seen(pose, image, maker);
      }
    }
    return median(times_ms);
  }
};

/// Without what makes two frames of one pose differ.
inline Knobs neutralOf(Knobs knobs) {
  knobs.persistence = 0.0;
  knobs.mode = DisplayMode::bMode;
  return knobs;
}
inline Scene quietOf(Scene scene) {
  scene.noise.reset();
  return scene;
}

/// @error badField, notRigid for a pose that gives no image
inline Result<void> checkUsable(const Pose& pose) {
  if (pose.status != PoseStatus::ok)
    return failure(ErrorCode::badField, say<"The probe has no place; hold it on the body and measure again.">());
  return checkRigid(pose.probeToWorld.matrix);
}

}  // namespace ew::detail
