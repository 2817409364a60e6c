#include <gtest/gtest.h>

#include "acquisition/pulse.h"
#include "ew/acquisition/temporal_offset.h"

namespace ew::acquisition_time_test {
namespace {

struct Recording {
  std::deque<GreyImage> images;
  std::vector<ImageView<const std::uint8_t>> views;
  std::vector<double> times_s;
  FramePoses poses;
};

/// A texture seen by a probe at `depthAt`; poses lag by a tenth of a second.
template <class Way>
Recording record(const Way& depthAt, int frames) {
  Recording recording;
  for (int n = 0; n < frames; ++n) {
    const double t_s = 0.05 * n;
    recording.images.push_back(sweeps::imageOf(24, 40, [&](int x, int y) {
      return static_cast<int>(std::lround(120.0 + 80.0 * pulse::texture(0.5 * glm::dvec3(x, y + depthAt(t_s), 0.0))));
    }));
    recording.views.push_back(viewOf(std::as_const(recording.images.back())));
    recording.times_s.push_back(t_s);
    recording.poses.push_back(
        Transform<frame::World, frame::Image>{sweeps::matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.0, depthAt(t_s - 0.1), 0.0})});
  }
  return recording;
}

PoseDelay estimated(const Recording& recording, const PoseDelayOptions& options = {}) {
  const auto delay = estimatePoseDelay(recording.views, recording.times_s, recording.poses, options, noProgress());
  EXPECT_TRUE(delay.has_value()) << delay.error();
  return delay.value_or(PoseDelay{});
}

void expectCannotTell(const PoseDelay& delay, const std::string& words) {
  EXPECT_EQ(delay.verdict, DelayVerdict::cannotTell) << delay.delay_s << " s by " << delay.seenBy;
  EXPECT_NE(delay.why.english().find(words), std::string::npos) << delay.why;
}

double uneven(double t) { return 3.0 * std::sin(2.1 * t) + 2.0 * std::sin(3.7 * t + 1.0); }

TEST(HardPoseDelay, OfAnEvenMovementARegularToAndFroOrAStillImageCannotBeTold) {
  expectCannotTell(estimated(record([](double t) { return 7.0 * t; }, 80)), "too evenly");
  expectCannotTell(estimated(record([](double) { return 0.0; }, 80)), "too evenly");
  expectCannotTell(estimated(record([](double t) { return 1.5 * std::sin(14.0 * t); }, 120)), "several delays fit");
  Recording constant = record(uneven, 80);
  std::fill(constant.views.begin(), constant.views.end(), constant.views.front());
  expectCannotTell(estimated(constant), "do not agree");
  expectCannotTell(estimated(record(uneven, 10)), "too few frames");
}

TEST(HardPoseDelay, BeyondTheRangeIsNotTakenForItsEnd) {
  PoseDelayOptions options;
  options.largest_s = 0.06;
  const PoseDelay delay = estimated(record(uneven, 160), options);
  EXPECT_EQ(delay.verdict, DelayVerdict::cannotTell) << delay.delay_s;
}

TEST(HardPoseDelay, WithoutPosesCannotBeToldAndWithHalfOfThemIsStillFound) {
  Recording recording = record(uneven, 160);
  EXPECT_NEAR(estimated(recording).delay_s, 0.1, 0.0125);
  for (std::size_t n = 40; n < 80; ++n) recording.poses[n].reset();
  EXPECT_NEAR(estimated(recording).delay_s, 0.1, 0.0125);
  for (auto& pose : recording.poses) pose.reset();
  expectCannotTell(estimated(recording), "too few poses");
}

TEST(HardPoseDelay, TimesThatRunBackwardsOrAreNoneAreRefusedAndEqualOnesLivedWith) {
  Recording recording = record(uneven, 100);
  auto times_s = recording.times_s;
  times_s[31] = times_s[30];
  recording.times_s = times_s;
  EXPECT_NEAR(estimated(recording).delay_s, 0.1, 0.02);
  times_s[31] = times_s[29];
  EXPECT_EQ(posesDelayedBy(0.1, times_s, recording.poses, {0, 0}).error().code, ErrorCode::badField);
  times_s[31] = std::nan("");
  EXPECT_EQ(posesDelayedBy(0.1, times_s, recording.poses, {0, 0}).error().code, ErrorCode::badField);
  times_s.pop_back();
  EXPECT_EQ(posesDelayedBy(0.1, times_s, recording.poses, {0, 0}).error().code, ErrorCode::badField);
  EXPECT_EQ(posesDelayedBy(std::nan(""), recording.times_s, recording.poses, {0, 0}).error().code, ErrorCode::badField);
  expectCannotTell(estimated({recording.images, recording.views, std::vector<double>(100, 1.0), recording.poses}), "too few frames");
}

TEST(HardPoseDelay, IsNeverAppliedAcrossAGapOrAFrameWithoutAPose) {
  Recording recording = record(uneven, 20);
  recording.poses[8].reset();
  for (std::size_t n = 14; n < 20; ++n) recording.times_s[n] += 1.0;
  const auto delayed = posesDelayedBy(0.02, recording.times_s, recording.poses, {12, 20});
  ASSERT_TRUE(delayed.has_value());
  for (std::size_t n = 0; n < 20; ++n) EXPECT_EQ((*delayed)[n].has_value(), n != 7 && n != 8 && n != 13 && n != 19) << n;
  EXPECT_EQ(*posesDelayedBy(0.0, recording.times_s, recording.poses, {12, 20}), recording.poses);
}

}  // namespace
}  // namespace ew::acquisition_time_test
