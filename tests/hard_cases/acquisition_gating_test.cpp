#include <gtest/gtest.h>

#include <atomic>

#include "acquisition/pulse.h"
#include "ew/acquisition/gating.h"

namespace ew::acquisition_gating_test {
namespace {

using pulse::beats;
using pulse::ecg;
using pulse::Tube;

template <class T>
void expectRefused(const Result<T>& result, ErrorCode code, const std::string& words) {
  ASSERT_FALSE(result.has_value()) << "expected: " << words;
  EXPECT_EQ(result.error().code, code) << result.error();
  EXPECT_NE(result.error().sentence().find(words), std::string::npos) << result.error();
  EXPECT_EQ(result.error().sentence().back(), '.');
}

BodySignal noise(double duration_s, double rate_hz, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  BodySignal signal;
  for (int n = 0; n / rate_hz < duration_s; ++n) {
    signal.time_s.push_back(n / rate_hz);
    signal.value.push_back(normal(random));
  }
  return signal;
}

TEST(HardGating, NoiseInPlaceOfAnEcgIsRefusedWithEverySeed) {
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const double rate_hz : {50.0, 250.0}) expectRefused(findHeartBeats(noise(20.0, rate_hz, seed)), ErrorCode::unsupported, "The ECG");
}

TEST(HardGating, NoiseInPlaceOfABreathIsRefusedWithEverySeed) {
  for (unsigned seed = 0; seed < 40; ++seed)
    expectRefused(findBreaths(noise(60.0, 10.0, seed)), ErrorCode::unsupported, "nothing in it repeats");
}

TEST(HardGating, AnEcgThatIsConstantShortSparseOrOfOneBeatIsRefusedWithItsReason) {
  BodySignal flat = ecg({}, 10.0, 250.0);
  expectRefused(findHeartBeats(flat), ErrorCode::unsupported, "the same throughout");
  expectRefused(findHeartBeats(ecg({1.5}, 3.0, 250.0)), ErrorCode::unsupported, "single R peak");
  expectRefused(findHeartBeats(ecg(beats(10.0, 0.8, 0.0, 1), 10.0, 20.0)), ErrorCode::unsupported, "20 samples a second");
  expectRefused(findHeartBeats({{0.0, 0.1}, {1.0, 2.0}}), ErrorCode::unsupported, "fewer than four samples");
  expectRefused(findHeartBeats({{0.0, 0.1}, {1.0}}), ErrorCode::badField, "2 times and 1 values");
  expectRefused(findHeartBeats({}), ErrorCode::unsupported, "fewer than four");
}

TEST(HardGating, OneWrongTimeIsNamedBeforeMemoryIsTakenForTheTimeItSpans) {
  for (const double wrong_s : {1e12, 1e18, 1e300, 2e5}) {
    BodySignal signal = ecg(beats(20.0, 0.8, 0.0, 1), 20.0, 250.0);
    signal.time_s.back() = wrong_s;
    expectRefused(findHeartBeats(signal), ErrorCode::badField, "longer than a day");
    expectRefused(findBreaths(signal), ErrorCode::badField, "longer than a day");
  }
}

TEST(HardGating, ASaturatedEcgGatesAndSaysSo) {
  const auto truth_s = beats(20.0, 0.8, 0.05, 5);
  BodySignal signal = ecg(truth_s, 20.0, 250.0);
  for (double& value : signal.value) value = std::clamp(value, -0.05, 0.25);
  const auto found = findHeartBeats(signal);
  ASSERT_TRUE(found.has_value()) << found.error();
  ASSERT_EQ(found->starts_s.size(), truth_s.size());
  for (std::size_t n = 0; n < truth_s.size(); ++n) EXPECT_NEAR(found->starts_s[n], truth_s[n], 0.015);
  EXPECT_TRUE(std::any_of(found->notes.begin(), found->notes.end(),
                          [](const auto& note) { return note.english().find("saturated") != std::string::npos; }));
}

TEST(HardGating, TimeThatRunsBackwardsIsRefusedAndEqualTimesCountOnce) {
  const auto truth_s = beats(10.0, 0.8, 0.05, 5);
  BodySignal signal = ecg(truth_s, 10.0, 250.0);
  const auto plain = findHeartBeats(signal);
  BodySignal doubled;
  for (std::size_t n = 0; n < signal.time_s.size(); ++n)
    for (int time = 0; time < 2; ++time) {
      doubled.time_s.push_back(signal.time_s[n]);
      doubled.value.push_back(time == 0 ? signal.value[n] : 100.0);
    }
  const auto once = findHeartBeats(doubled);
  ASSERT_TRUE(plain.has_value() && once.has_value());
  EXPECT_EQ(plain->starts_s, once->starts_s);
  std::swap(signal.time_s[100], signal.time_s[300]);
  expectRefused(findHeartBeats(signal), ErrorCode::badField, "Time runs backwards in the ECG");
  const BodySignal still{std::vector<double>(50, 3.0), std::vector<double>(50, 1.0)};
  expectRefused(findHeartBeats(still), ErrorCode::unsupported, "at different times");
}

TEST(HardGating, SamplesThatAreNoNumbersAndAGapLeaveTheOtherBeatsAlone) {
  const auto truth_s = beats(30.0, 0.8, 0.03, 5);
  BodySignal signal = ecg(truth_s, 30.0, 250.0), kept;
  for (std::size_t n = 0; n < signal.time_s.size(); ++n) {
    if (signal.time_s[n] > 12.1 && signal.time_s[n] < 17.0) continue;
    kept.time_s.push_back(signal.time_s[n]);
    kept.value.push_back(n % 97 == 0 ? std::nan("") : signal.value[n]);
  }
  const auto found = findHeartBeats(kept);
  ASSERT_TRUE(found.has_value()) << found.error();
  EXPECT_EQ(found->irregular, 1u) << "the gap is longer than four beats and not bridged";
  const std::vector<double> inTheGap{14.5};
  EXPECT_EQ(phasesOf(*found, inTheGap).front().verdict, FrameVerdict::irregular);
}

TEST(HardGating, ImagesThatAreConstantFewSlowOrOutOfOrderAreRefused) {
  Tube tube;
  tube.pixel_mm = 2.0;
  const auto sweep = pulse::imaged(tube, 80);
  std::vector<ImageView<const std::uint8_t>> images;
  std::vector<double> times_s;
  for (std::size_t n = 0; n < 80; ++n) {
    images.push_back(sweep.frames[n].pixels);
    times_s.push_back(static_cast<double>(n) / 25.0);
  }
  const std::vector<ImageView<const std::uint8_t>> same(80, images.front());
  const auto find = [](const auto& frames, const auto& times) { return findCyclesInImages(frames, times, {}, noProgress()); };
  expectRefused(find(same, times_s), ErrorCode::unsupported, "they do not change");
  expectRefused(find(std::span(images).first(5), std::span<const double>(times_s).first(5)), ErrorCode::unsupported, "fewer than eight");
  expectRefused(find(images, std::vector<double>(80, 1.0)), ErrorCode::unsupported, "fewer than eight");
  expectRefused(find(images, std::span<const double>(times_s).first(5)), ErrorCode::badField, "80 frames and 5 times");
  auto slow_s = times_s;
  for (double& t : slow_s) t *= 25.0;
  expectRefused(find(images, slow_s), ErrorCode::unsupported, "frames a second");
  auto backwards_s = times_s;
  std::swap(backwards_s[10], backwards_s[40]);
  expectRefused(find(images, backwards_s), ErrorCode::badField, "Time runs backwards");
  backwards_s = times_s;
  backwards_s[7] = std::nan("");
  expectRefused(find(images, backwards_s), ErrorCode::badField, "Frame 7 has no time");
}

TEST(HardGating, MorePhasesThanFramesAndAnEmptyPhaseAreRefused) {
  const std::vector<FramePhase> frames{
      {0.1, 0, FrameVerdict::accepted}, {0.2, 0, FrameVerdict::accepted}, {0.9, 0, FrameVerdict::irregular}};
  expectRefused(framesOfPhase(frames, 3), ErrorCode::badField, "3 phases cannot be made of 2 gated frames");
  expectRefused(framesOfPhase(frames, 0), ErrorCode::badField, "0 phases");
  expectRefused(framesOfPhase(frames, 2), ErrorCode::badField, "Phase 2 of 2 has no frame");
  expectRefused(framesOfPhase({}, 1), ErrorCode::badField, "1 phases cannot be made of 0");
}

class CancelAtOnce final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

TEST(HardGating, IsCancelledAndWhatKeepsAVolumeMayStopTheRest) {
  Tube tube;
  tube.pixel_mm = 2.0;
  const auto sweep = pulse::imaged(tube, 20);
  std::vector<ImageView<const std::uint8_t>> images;
  std::vector<double> times_s;
  for (std::size_t n = 0; n < 20; ++n) {
    images.push_back(sweep.frames[n].pixels);
    times_s.push_back(static_cast<double>(n) / 8.0);
  }
  CancelAtOnce cancel;
  EXPECT_EQ(findCyclesInImages(images, times_s, {}, cancel).error().code, ErrorCode::cancelled);
  const std::vector<std::vector<std::size_t>> lists{{0, 1, 2}, {3, 4, 5}};
  int kept = 0;
  const auto made = reconstructPhases(
      sweep.frames, lists, {.spacing_mm = 2.0},
      [&](std::size_t, ReconstructResult) -> Result<void> {
        ++kept;
        return failure(ErrorCode::notWritable, verbatim("The disk is full."));
      },
      noProgress());
  expectRefused(made, ErrorCode::notWritable, "disk is full");
  EXPECT_EQ(kept, 1);
  EXPECT_EQ(reconstructPhases(
                sweep.frames, lists, {.spacing_mm = 2.0}, [](std::size_t, ReconstructResult) { return Result<void>(); }, cancel)
                .error()
                .code,
            ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::acquisition_gating_test
