#include "ew/scanning/replay.h"

#include <gtest/gtest.h>

#include <set>

#include "io/files.h"
#include "scanning/small_scan.h"

namespace ew::replay_test {
namespace {

constexpr glm::ivec2 kSize_px{120, 90};

std::uint64_t hashOf(const DisplayImage& image) {
  std::uint64_t hash = 1469598103934665603U;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) hash = (hash ^ image.grey.row(y)[x]) * 1099511628211U;
  return hash;
}

/// Of every 30th image, made one after another.
std::vector<std::uint64_t> hashesOf(const ScanLog& log, int threads) {
  Replay replay(log, test::waveSubject(), threads);
  std::vector<std::uint64_t> hashes;
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const DisplayImage image = replay.make(n, kSize_px.x, kSize_px.y);
    if (n % 30 == 0) hashes.push_back(hashOf(image));
  }
  return hashes;
}

}  // namespace

/// 60 s at 30 images a second with 500 changes of settings and more: what was seen, three replays and two numbers of threads.
TEST(Replay, GivesThePixelsThatWereSeenEveryTimeAndWithEveryNumberOfThreads) {
  constexpr int kFrames = 1800;
  ScanRecording recording;
  Scanner live(2);
  live.show(test::waveSubject());
  std::vector<std::uint64_t> seen;
  for (int n = 0; n < kFrames; ++n) {
    const ScanState state = test::movingState(n);
    const DisplayImage image = live.make(state, kSize_px.x, kSize_px.y);
    if (n % 30 == 0) seen.push_back(hashOf(image));
    recording.log.addFrame(state);
  }
  const auto& events = recording.log.events();
  const auto settings =
      std::count_if(events.begin(), events.end(), [](const ScanEvent& event) { return !std::holds_alternative<FrameMade>(event.what); });
  ASSERT_GE(settings, 450) << "as many as a restless hand makes";
  ASSERT_GT(std::set(seen.begin(), seen.end()).size(), 55U) << "the images differ";
  test::TempFolder folder;
  ASSERT_TRUE(writeRecording(recording, folder / "r.seq.mha"));
  const auto read = readRecording(folder / "r.seq.mha");
  ASSERT_TRUE(read) << read.error();
  for (const int threads : {1, 2, 1}) EXPECT_EQ(hashesOf(read->log, threads), seen) << threads << " threads";
}

TEST(Replay, ShowsABodyAsItStoodWhenItWasRecorded) {
  constexpr int kFrames = 40;
  const ScanSubject subject = test::livingSubject();
  ScanRecording recording;
  Scanner live(2);
  live.show(subject);
  std::vector<std::uint64_t> seen;
  for (int n = 0; n < kFrames; ++n) {
    ScanState state = test::movingState(3);  // the probe stands still
    state.scene.noise.reset();
    state.scene.liveEchoes.emplace();
    state.scene.motion.emplace();
    state.time_s = n / 30.0;
    state.body = bodyAt(subject.motion->rhythms, state.time_s);
    seen.push_back(hashOf(live.make(state, kSize_px.x, kSize_px.y)));
    recording.log.addFrame(state);
  }
  EXPECT_GT(std::set(seen.begin(), seen.end()).size(), 30U) << "the images differ";
  test::TempFolder folder;
  ASSERT_TRUE(writeRecording(recording, folder / "r.seq.mha"));
  const auto read = readRecording(folder / "r.seq.mha");
  ASSERT_TRUE(read) << read.error();
  Replay replay(read->log, subject, 1);
  for (std::size_t n = 0; n < kFrames; ++n) ASSERT_EQ(hashOf(replay.make(n, kSize_px.x, kSize_px.y)), seen[n]) << n;
}

TEST(Replay, FormsWhatWasRecordedWithoutTissuesWithThoseOfItsSubject) {
  ScanSubject subject = test::waveSubject();
  auto labels = std::make_shared<Volume>(*test::waves());
  for (std::size_t n = 0; n < labels->echo.size(); ++n) labels->echo[n] = n % 40 < 20 ? 1 : 0;
  subject.labels = labels;
  subject.scene.attenuation.emplace();
  subject.scene.tissues = {{.label = 1, .name = "hard", .attenuation_dbPerCmMhz = 4.0}};
  subject.place({});
  ScanState state = test::movingState(3);
  state.scene = subject.scene;
  Scanner live(1);
  live.show(subject);
  const std::uint64_t seen = hashOf(live.make(state, kSize_px.x, kSize_px.y));
  state.scene.tissues.clear();
  live.forget();
  EXPECT_EQ(hashOf(live.make(state, kSize_px.x, kSize_px.y)), seen) << "a scene without tissues has the subject's";
  ScanSubject unknown = subject;
  unknown.scene.tissues.clear();
  Scanner without(1);
  without.show(unknown);
  ASSERT_NE(hashOf(without.make(state, kSize_px.x, kSize_px.y)), seen) << "the tissues are seen";
  ScanLog log;
  log.addFrame(state);
  Replay replay(log, subject);
  EXPECT_EQ(hashOf(replay.make(0, kSize_px.x, kSize_px.y)), seen);
}

TEST(Replay, AfterAJumpDiffersByAGreyLevelAtMost) {
  ScanLog log;
  for (int n = 0; n < 260; ++n) log.addFrame(test::movingState(n));
  Replay straight(log, test::waveSubject()), jumping(log, test::waveSubject());
  std::vector<GreyImage> expected;
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const DisplayImage image = straight.make(n, kSize_px.x, kSize_px.y);
    expected.emplace_back(kSize_px.x, kSize_px.y);
    for (int y = 0; y < kSize_px.y; ++y) std::copy_n(image.grey.row(y), kSize_px.x, viewOf(expected.back()).row(y));
  }
  for (const std::size_t n : {40U, 10U, 41U, 120U, 119U, 240U, 0U, 259U}) {
    const DisplayImage image = jumping.make(n, kSize_px.x, kSize_px.y);
    int worst = 0;
    for (int y = 0; y < kSize_px.y; ++y)
      for (int x = 0; x < kSize_px.x; ++x)
        worst = std::max(worst, std::abs(int{image.grey.row(y)[x]} - int{viewOf(expected[n]).row(y)[x]}));
    EXPECT_LE(worst, 1) << n;
    if (test::movingState(static_cast<int>(n)).knobs.persistence == 0.0) {
      EXPECT_EQ(worst, 0) << n;
    }
  }
}

TEST(Replay, KnowsHowManyImagesStillShow) {
  ScanLog log;
  for (int n = 0; n < 260; ++n) log.addFrame(test::movingState(n));
  EXPECT_EQ(Replay::history(log, 120), 8U) << "0.4 to the 7th is less than half of a grey level of 255, and one more";
  EXPECT_EQ(Replay::history(log, 3), 3U);
  EXPECT_EQ(Replay::history(log, 70), 0U);
  EXPECT_EQ(Replay::history(log, 240), 120U) << "four seconds of M-mode";
}

TEST(FramesToSettle, AreThoseOfTheSlowestPersistenceAndOfTheImageBefore) {
  Knobs knobs;
  EXPECT_EQ(framesToSettle(knobs), 0U);
  knobs.persistence = 0.5;
  EXPECT_EQ(framesToSettle(knobs), 10U) << "0.5^9 of 255 grey levels is less than half of one";
  knobs.colour.emplace();
  knobs.colour->persistence = 0.0;
  EXPECT_EQ(framesToSettle(knobs), 10U);
  knobs.persistence = 0.0;
  EXPECT_EQ(framesToSettle(knobs), 1U) << "what moved since the image before shows in colour";
  knobs.colour->persistence = 0.5;
  EXPECT_EQ(framesToSettle(knobs), 11U);
  knobs.persistence = 0.9;
  EXPECT_EQ(framesToSettle(knobs), 61U);
}

TEST(Replay, GoesAsFarBackAsColourRemembers) {
  ScanLog log;
  for (int n = 0; n < 40; ++n) {
    ScanState state = test::movingState(3);
    state.knobs = {};
    state.time_s = n / 30.0;
    if (n >= 20) state.knobs.colour = ColourDoppler{.persistence = 0.5};
    log.addFrame(state);
  }
  EXPECT_EQ(Replay::history(log, 15), 0U);
  EXPECT_EQ(Replay::history(log, 35), 11U);
}

}  // namespace ew::replay_test
