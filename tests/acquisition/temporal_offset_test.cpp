#include "ew/acquisition/temporal_offset.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "acquisition/pulse.h"

namespace ew::temporal_offset_test {
namespace {

constexpr double kPixel_mm = 0.5;

/// Image to world of a probe at `face_mm`, turned about the beam.
glm::dmat4 poseOf(const glm::dvec3& face_mm, double rotation_rad = 0.0) {
  return glm::translate(glm::dmat4(1.0), face_mm) * glm::rotate(glm::dmat4(1.0), rotation_rad, glm::dvec3(0.0, 1.0, 0.0)) *
         sweeps::matrixOf({kPixel_mm, 0, 0}, {0, kPixel_mm, 0}, {0, 0, kPixel_mm}, {-12.0, 0.0, 0.0});
}

struct Recording {
  std::deque<GreyImage> images;
  std::vector<ImageView<const std::uint8_t>> views;
  std::vector<double> times_s;
  FramePoses poses;
};

/// A probe carried along `wayAt`, whose poses arrive `latency_s` late: what is written beside an image is where the probe was before.
Recording record(const std::function<glm::dvec3(double)>& wayAt, double latency_s, int frames, double fps) {
  Recording recording;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  for (int n = 0; n < frames; ++n) {
    const double t_s = 100.0 + (n + jitter(random)) / fps;
    const glm::dmat4 imageToWorld = poseOf(wayAt(t_s));
    recording.images.push_back(sweeps::imageOf(48, 48, [&](int x, int y) {
      const glm::dvec3 p_mm = glm::dvec3(imageToWorld * glm::dvec4(x, y, 0.0, 1.0));
      return static_cast<int>(std::lround(120.0 + 60.0 * pulse::texture(0.6 * p_mm) + 40.0 * pulse::texture(0.15 * p_mm)));
    }));
    recording.views.push_back(viewOf(std::as_const(recording.images.back())));
    recording.times_s.push_back(t_s);
    recording.poses.push_back(Transform<frame::World, frame::Image>{poseOf(wayAt(t_s - latency_s))});
  }
  return recording;
}

/// To and fro, never twice alike.
double unevenly(double t) { return std::sin(2.1 * t) + 0.6 * std::sin(3.7 * t + 1.0) + 0.3 * std::sin(6.1 * t + 2.0); }

TEST(PoseDelay, IsFoundToAFractionOfAFrameFromMovementInAnyDirection) {
  const std::vector<std::pair<const char*, std::function<glm::dvec3(double)>>> ways = {
      {"along", [](double t) { return glm::dvec3(0.0, 3.0 * unevenly(t), 0.0); }},
      {"across", [](double t) { return glm::dvec3(3.0 * unevenly(t), 0.0, 0.0); }},
      {"change", [](double t) { return glm::dvec3(0.0, 0.0, 6.0 * t + 2.0 * unevenly(t)); }}};
  for (const auto& [name, way] : ways)
    for (const double latency_s : {0.087, -0.13, 0.0}) {
      const Recording recording = record(way, latency_s, 160, 20.0);
      const auto delay = estimatePoseDelay(recording.views, recording.times_s, recording.poses, {}, noProgress());
      ASSERT_TRUE(delay.has_value()) << delay.error();
      ASSERT_EQ(delay->verdict, DelayVerdict::found) << name << ": " << delay->why;
      EXPECT_NEAR(delay->delay_s, latency_s, 0.0125) << name << ", a quarter of a frame";
      EXPECT_LT(std::abs(delay->delay_s - latency_s), 4.0 * delay->uncertainty_s + 0.002) << name;
      EXPECT_NE(delay->seenBy.english().find(name), std::string::npos) << delay->seenBy;
      EXPECT_GT(delay->correlation, 0.7) << name;
    }
}

TEST(PoseDelay, TakenAwayPutsTheImagesWhereTheyWereTaken) {
  const auto way = [](double t) { return glm::dvec3(0.0, 3.0 * unevenly(t), 1.0 * t); };
  const Recording recording = record(way, 0.1, 160, 20.0);
  const auto delay = estimatePoseDelay(recording.views, recording.times_s, recording.poses, {}, noProgress());
  ASSERT_TRUE(delay.has_value() && delay->verdict == DelayVerdict::found);
  EXPECT_NEAR(delay->delay_s, 0.1, 0.0125) << "+- " << delay->uncertainty_s << " by " << delay->seenBy << ", " << delay->correlation;
  const auto poses = posesDelayedBy(delay->delay_s, recording.times_s, recording.poses, {23.5, 23.5});
  ASSERT_TRUE(poses.has_value()) << poses.error();
  double before_mm = 0.0, after_mm = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < poses->size(); ++n) {
    if (!(*poses)[n]) continue;
    const glm::dvec3 truth_mm(poseOf(way(recording.times_s[n]))[3]);
    before_mm += glm::distance(glm::dvec3(recording.poses[n]->matrix[3]), truth_mm);
    after_mm += glm::distance(glm::dvec3((*poses)[n]->matrix[3]), truth_mm);
    ++count;
  }
  EXPECT_GE(count, 155);
  EXPECT_LT(after_mm, 0.15 * before_mm);
}

TEST(PoseDelay, DoesNotDependOnTheNumberOfThreads) {
  const Recording recording = record([](double t) { return glm::dvec3(0.0, 3.0 * unevenly(t), 0.0); }, 0.05, 60, 20.0);
  PoseDelayOptions options;
  std::vector<double> found;
  for (const int threads : {1, 2, 8}) {
    options.threads = threads;
    found.push_back(estimatePoseDelay(recording.views, recording.times_s, recording.poses, options, noProgress())->delay_s);
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

RC_GTEST_PROP(DelayedPoses, OfAnEvenMovementLieExactlyOnIt, ()) {
  const double delay_s = *rc::gen::inRange(-200, 200) / 1000.0;
  const double turn_radPerS = *rc::gen::inRange(-20, 20) / 10.0;
  const glm::dvec3 speed_mmPerS(*rc::gen::inRange(-30, 30), *rc::gen::inRange(-30, 30), *rc::gen::inRange(-30, 30));
  const glm::dvec2 centre_px(24.0, 0.0);  // the face's middle, about which the probe turns
  std::vector<double> times_s;
  FramePoses poses;
  const auto poseAt = [&](double t) { return poseOf(speed_mmPerS * t, turn_radPerS * t); };
  for (int n = 0; n < 30; ++n) {
    times_s.push_back(0.05 * n + 0.01 * (n % 3));
    poses.push_back(Transform<frame::World, frame::Image>{poseAt(times_s.back())});
  }
  const auto delayed = posesDelayedBy(delay_s, times_s, poses, centre_px);
  RC_ASSERT(delayed.has_value());
  for (std::size_t n = 0; n < times_s.size(); ++n) {
    const double t_s = times_s[n] + delay_s;
    if (t_s < times_s.front() || t_s > times_s.back()) {
      RC_ASSERT(!(*delayed)[n]);
      continue;
    }
    RC_ASSERT((*delayed)[n].has_value());
    for (const glm::dvec4 corner : {glm::dvec4(0, 0, 0, 1), glm::dvec4(47, 47, 0, 1)})
      RC_ASSERT(glm::distance(glm::dvec3((*delayed)[n]->matrix * corner), glm::dvec3(poseAt(t_s) * corner)) < 1e-9);
  }
}

}  // namespace
}  // namespace ew::temporal_offset_test
