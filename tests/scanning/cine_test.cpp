#include "ew/scanning/cine.h"

#include <gtest/gtest.h>

#include <set>

#include "io/files.h"
#include "scanning/small_scan.h"

namespace ew::cine_test {
namespace {

constexpr glm::ivec2 kSize_px{120, 90};

void mix(std::uint64_t& hash, ImageView<const std::uint8_t> image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) hash = (hash ^ image.row(y)[x]) * 1099511628211U;
}

/// Of an image and of the strip beside it.
std::uint64_t hashOf(const DisplayImage& image, const Scanner& scanner) {
  std::uint64_t hash = 1469598103934665603U;
  mix(hash, image.grey);
  mix(hash, scanner.strip());
  return hash;
}

FrameMemory noMemory() { return {}; }

/// A probe that stands still at a time.
ScanState stateAt(double time_s) {
  ScanState state = test::movingState(60);
  state.time_s = time_s;
  return state;
}

CineRing filledWith(int frames, const CineLimits& limits, double period_s = 0.04) {
  CineRing ring(limits);
  for (int n = 0; n < frames; ++n) ring.add(stateAt(n * period_s), kSize_px, noMemory);
  return ring;
}

/// A scan that is seen live and kept in a ring.
struct Live {
  ScanSubject subject;
  CineRing ring;
  Scanner scanner{2};
  std::vector<std::uint64_t> seen;
  std::vector<ScanState> states;

  explicit Live(ScanSubject of, const CineLimits& limits = {}) : subject(std::move(of)), ring(limits) { scanner.show(subject); }
  void scan(const ScanState& state, glm::ivec2 size_px = kSize_px) {
    const DisplayImage image = scanner.make(state, size_px.x, size_px.y);
    seen.push_back(hashOf(image, scanner));
    states.push_back(state);
    ring.add(state, size_px, [this] { return scanner.memory(); });
  }
  [[nodiscard]] std::uint64_t seenAt(std::size_t n) const { return seen[seen.size() - ring.frameCount() + n]; }
  /// @return images that had to be formed
  std::size_t expectAgain(CineForming& forming, std::size_t n, glm::ivec2 size_px = kSize_px) const {
    const std::size_t left = forming.aim(ring, n, size_px);
    while (forming.left() > 0) forming.makeNext(ring);
    EXPECT_EQ(hashOf(forming.image(), forming.scanner()), seenAt(n)) << "image " << n << " of " << ring.frameCount();
    return left;
  }
};

/// The n-th state of a scan with noise and motion at 25 images a second; in turns without memory, with persistence, with M-mode.
ScanState restlessState(int n) {
  ScanState state = test::movingState(n);
  state.time_s = 50.0 + n / 25.0;
  state.knobs.persistence = n / 80 % 3 == 1 ? 0.8 : 0.0;
  state.knobs.mode = n / 80 % 3 == 2 ? DisplayMode::both : DisplayMode::bMode;
  state.knobs.mSweep_s = 2.0;
  return state;
}

}  // namespace

TEST(CineRing, HoldsTheLastSecondsAndWhatTheyWereMadeWith) {
  CineRing ring({.length_s = 3.0});
  for (int n = 0; n < 500; ++n) ring.add(restlessState(n), kSize_px, noMemory);
  ASSERT_EQ(ring.frameCount(), 76U) << "3 s of 25 a second, both ends";
  EXPECT_NEAR(ring.length_s(), 3.0, 1e-9);
  for (std::size_t n = 0; n < ring.frameCount(); ++n) {
    ASSERT_EQ(ring.frame(n), restlessState(static_cast<int>(424 + n))) << n;
    ASSERT_EQ(ring.frameAt(ring.frameTime_s(n) + 0.01), n);
  }
  EXPECT_EQ(ring.frameAt(0.0), 0U);
  EXPECT_EQ(ring.size_px(0), kSize_px);
}

TEST(CineRing, TakesAtMostThirtyMebibytesForThirtySecondsAtTwentyFiveImages) {
  // The dearest there is: persistence and M-mode in a large window, and settings that change with every image.
  constexpr glm::ivec2 kLarge_px{1400, 1000};
  CineRing ring;
  std::size_t most = 0, asked = 0;
  for (int n = 0; n < 1500; ++n) {
    ScanState state = stateAt(n / 25.0);
    state.knobs.persistence = 0.9;
    state.knobs.mode = DisplayMode::both;
    state.knobs.gain = 1.0 + 0.001 * n;
    state.gaps_mm.assign(17, 0.5F);
    ring.add(state, kLarge_px, [&] {
      ++asked;
      FrameMemory memory;
      memory.persistence.empty = false;
      memory.persistence.levels.resize(std::size_t{1400} * 1000);
      memory.strip.configure(kLarge_px.x, kLarge_px.y, 4.0);
      return memory;
    });
    most = std::max(most, ring.bytes());
  }
  EXPECT_LE(most, std::size_t{30} << 20);
  EXPECT_GT(most, std::size_t{10} << 20) << "memories count";
  EXPECT_NEAR(ring.length_s(), 30.0, 1e-9) << "and all of it is offered";
  EXPECT_LE(asked, 20U);
  RecordProperty("dearest_bytes", std::to_string(most));
  const CineRing plain = filledWith(1500, {});
  EXPECT_EQ(plain.frameCount(), 751U);
  EXPECT_LE(plain.bytes(), std::size_t{1} << 20) << "without persistence and M-mode there is nothing to remember";
  RecordProperty("plain_bytes", std::to_string(plain.bytes()));
  std::printf("30 s at 25 images a second: %zu bytes; with persistence, M-mode and a changed setting each, 1400 x 1000: %zu bytes\n",
              plain.bytes(), most);
}

TEST(CineRing, OffersLessWhereBytesAreShort) {
  constexpr std::size_t kBytes = 40000;
  const CineRing ring = filledWith(2000, {.length_s = 30.0, .bytes = kBytes});
  EXPECT_LE(ring.bytes(), kBytes);
  EXPECT_GT(ring.frameCount(), 20U);
  EXPECT_LT(ring.frameCount(), 200U);
  EXPECT_EQ(ring.frameTime_s(ring.frameCount() - 1), 1999 * 0.04);
  EXPECT_EQ(filledWith(50, {.length_s = 30.0, .bytes = 10}).frameCount(), 1U) << "the newest stays whatever it costs";
}

TEST(CineRing, FreesAllThatItCounts) {
  CineRing ring = filledWith(300, {.length_s = 2.0});
  const std::size_t full = ring.bytes();
  for (int n = 300; n < 900; ++n) ring.add(stateAt(n * 0.04), kSize_px, noMemory);
  EXPECT_EQ(ring.bytes(), full) << "a full ring does not grow";
  ring.clear();
  EXPECT_TRUE(ring.empty());
  EXPECT_EQ(ring.bytes(), 0U);
}

TEST(CineRing, LeavesOutImagesThatComeBeforeTheNewest) {
  CineRing ring = filledWith(3, {});
  ring.add(stateAt(0.01), kSize_px, noMemory);
  EXPECT_EQ(ring.frameCount(), 3U);
}

TEST(CineForming, GivesThePixelsThatWereSeenForwardsBackwardsAndAfterEveryJump) {
  Live live(test::waveSubject(), {.length_s = 12.0, .memoryEvery_s = 0.4});
  for (int n = 0; n < 480; ++n) live.scan(restlessState(n));
  ASSERT_GT(std::set(live.seen.begin(), live.seen.end()).size(), 470U) << "the images differ";
  ASSERT_EQ(live.ring.frameCount(), 301U);
  CineForming forming(live.subject, 1);
  std::size_t most = 0;
  for (std::size_t n = live.ring.frameCount(); n-- > 0;) most = std::max(most, live.expectAgain(forming, n));
  EXPECT_LE(most, 12U) << "0.4 s of images, the wanted one, and one more for times that are rounded";
  for (std::size_t n = 0; n < live.ring.frameCount(); ++n) EXPECT_LE(live.expectAgain(forming, n), n == 0 ? 12U : 1U);
  for (const std::size_t n : {150U, 20U, 151U, 300U, 0U, 77U, 76U, 299U, 298U}) live.expectAgain(forming, n);
  EXPECT_EQ(forming.aim(live.ring, 298, kSize_px), 0U) << "it is there";
}

TEST(CineForming, StepsBackThroughABodyThatMoves) {
  Live live(test::livingSubject());
  for (int n = 0; n < 60; ++n) {
    ScanState state = test::movingState(3);
    state.knobs.persistence = 0.0;
    state.scene.liveEchoes.emplace();
    state.scene.motion.emplace();
    state.scene.noise.emplace();
    state.time_s = n / 25.0;
    state.number = static_cast<std::uint64_t>(n);
    state.body = bodyAt(live.subject.motion->rhythms, state.time_s);
    live.scan(state);
  }
  ASSERT_GT(std::set(live.seen.begin(), live.seen.end()).size(), 55U) << "the images differ";
  CineForming forming(live.subject, 2);
  for (std::size_t n = live.ring.frameCount(); n-- > 0;) EXPECT_EQ(live.expectAgain(forming, n), 1U) << "nothing before it is needed";
}

TEST(CineForming, KnowsThatTheMakerForgotAndThatTheWindowWasAnotherSize) {
  Live live(test::waveSubject());
  const auto persistent = [](int n) {
    ScanState state = restlessState(n);
    state.knobs.persistence = 0.9;
    state.knobs.mode = DisplayMode::both;
    return state;
  };
  for (int n = 0; n < 40; ++n) live.scan(persistent(n), {100, 70});
  for (int n = 40; n < 90; ++n) live.scan(persistent(n));
  live.scanner.forget();
  live.ring.forget();
  for (int n = 90; n < 130; ++n) live.scan(persistent(n));
  CineForming forming(live.subject, 1);
  for (const std::size_t n : {129U, 91U, 90U, 89U, 60U, 40U}) live.expectAgain(forming, n);
  for (const std::size_t n : {39U, 10U}) live.expectAgain(forming, n, {100, 70});
  live.expectAgain(forming, 41);
  // In a size that the image never had there is nothing to compare it with; it is formed from what still shows.
  const std::size_t left = forming.aim(live.ring, 129, {60, 40});
  EXPECT_EQ(left, 40U) << "since the maker forgot";
}

TEST(CineForming, ShowsWhatCameBeforeARingThatBeganAnew) {
  Live live(test::waveSubject());
  for (int n = 0; n < 120; ++n) {
    if (n == 100) live.ring.beginAnew();
    ScanState state = restlessState(n);
    state.knobs.persistence = 0.95;
    live.scan(state);
  }
  ASSERT_EQ(live.ring.frameCount(), 20U);
  CineForming forming(live.subject, 1);
  for (const std::size_t n : {0U, 19U, 5U}) live.expectAgain(forming, n);
}

TEST(CineForming, OffersNothingInWhichSomethingShowsThatIsGone) {
  Live live(test::waveSubject());
  for (int n = 0; n < 60; ++n) {
    if (n == 30) live.ring.clear();
    ScanState state = restlessState(n);
    state.knobs.persistence = 0.9;
    live.scan(state);
  }
  ASSERT_EQ(live.ring.frameCount(), 29U);
  CineForming forming(live.subject, 1);
  for (const std::size_t n : {0U, 28U, 3U}) live.expectAgain(forming, n);
}

TEST(CineReview, MarksWhatRunsAndRunsItInALoop) {
  const CineRing ring = filledWith(100, {});
  CineReview review(ring);
  EXPECT_EQ(review.frame(), 99U) << "where it was frozen";
  review.step(-10);
  EXPECT_EQ(review.frame(), 89U);
  review.step(1000);
  EXPECT_EQ(review.frame(), 99U);
  review.goTo(60);
  review.markOut();
  review.goTo(40);
  review.markIn();
  EXPECT_EQ(review.in(), 40U);
  EXPECT_EQ(review.out(), 60U);
  std::set<std::size_t> shown;
  for (int n = 0; n < 200; ++n) {
    review.advance(0.02);
    shown.insert(review.frame());
  }
  EXPECT_EQ(shown.size(), 21U) << "both marks run";
  EXPECT_EQ(*shown.begin(), 40U);
  EXPECT_EQ(*shown.rbegin(), 60U);

  review.goTo(60);
  review.advance(0.05);
  EXPECT_EQ(review.frame(), 40U) << "the last one is seen as long as the others, then it begins again";
  review.goTo(80);
  review.advance(0.02);
  EXPECT_EQ(review.frame(), 40U) << "from beside the marks into them";

  review.goTo(70);
  review.markIn();
  EXPECT_FALSE(review.isOutMarked()) << "an end before the beginning is none";
  EXPECT_EQ(review.out(), 99U);
  review.markIn();
  EXPECT_FALSE(review.isInMarked()) << "the same again takes it away";
  review.markIn();
  review.markOut();
  review.advance(0.5);
  EXPECT_EQ(review.frame(), 70U) << "one image stands";
}

TEST(CineReview, RunsAtAnySpeed) {
  const CineRing ring = filledWith(101, {});
  for (const double speed : {0.25, 0.5, 1.0, 2.0}) {
    CineReview review(ring);
    review.goTo(0);
    review.advance(0.01);  // times that are sums lie at no image's border
    for (int n = 0; n < 50; ++n) review.advance(0.02 * speed);
    EXPECT_EQ(review.frame(), static_cast<std::size_t>(25.0 * speed + 0.25)) << "after a second";
  }
}

TEST(CineClip, IsARecordingOfTheMarkedImages) {
  Live live(test::waveSubject());
  for (int n = 0; n < 80; ++n) live.scan(restlessState(n));
  test::TempFolder folder;
  ASSERT_TRUE(writeRecording(clipOf(live.ring, 20, 60, "a-case", "A case"), folder / "clip.seq.mha"));
  const auto read = readRecording(folder / "clip.seq.mha");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->caseId, "a-case");
  EXPECT_EQ(read->size_px, kSize_px);
  ASSERT_EQ(read->log.frameCount(), 41U);
  Replay replay(read->log, live.subject, 1);
  for (std::size_t n = 0; n < 41; ++n) {
    const DisplayImage again = replay.make(n, kSize_px.x, kSize_px.y);
    ASSERT_EQ(hashOf(again, replay.scanner()), live.seen[20 + n]) << n;
  }
}

}  // namespace ew::cine_test
