#include "ew/imaging/effects/persistence.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "ew/imaging/frame.h"
#include "imaging/support/support.h"

namespace ew::persistence_test {
namespace {

Spans wholeSpans(int width, int height) { return Spans(static_cast<std::size_t>(height), {{0, width}}); }

GreyImage shownAfter(const GreyImage& next, double share, PersistenceMemory& memory) {
  GreyImage image = next;
  beginPersistence(next.width, next.height, memory);
  persist(share, wholeSpans(next.width, next.height), 0, next.height, viewOf(image), memory);
  return image;
}

GreyImage noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  GreyImage image(width, height);
  for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random() % 3 ? random() : 255 * (random() % 2));
  return image;
}

TEST(Persistence, ShowsTheFirstImageAsItIs) {
  PersistenceMemory memory;
  const GreyImage first = noise(67, 5, 1);
  EXPECT_EQ(shownAfter(first, 0.9, memory), first);
}

TEST(Persistence, ReachesAStillImageToTheLastBitAndStays) {
  for (const double share : {0.0, 1e-6, 0.1, 0.5, 0.77, 0.9, 0.95}) {
    PersistenceMemory memory;
    shownAfter(noise(67, 5, 1), share, memory);
    const GreyImage still = noise(67, 5, 2);
    const auto isReached = [&] {
      for (std::size_t n = 0; n < still.pixels.size(); ++n)
        if (memory.levels[n] != still.pixels[n] * 128) return false;
      return true;
    };
    int frames = 0;
    while (frames < 1000) {
      ++frames;
      const GreyImage shown = shownAfter(still, share, memory);
      if (isReached()) {
        EXPECT_EQ(shown, still);
        break;
      }
    }
    EXPECT_LE(frames, 200) << "share " << share;
    EXPECT_EQ(shownAfter(still, share, memory), still);
    EXPECT_TRUE(isReached());
  }
}

TEST(Persistence, LeavesOfAStepItsShareToThePowerOfTheFrames) {
  EXPECT_TRUE(rc::check("step", [] {
    const double share = *rc::gen::inRange(0, 951) / 1000.0;
    const auto from = static_cast<std::uint8_t>(*rc::gen::inRange(0, 256)), to = static_cast<std::uint8_t>(*rc::gen::inRange(0, 256));
    PersistenceMemory memory;
    shownAfter(GreyImage(3, 2, from), share, memory);
    int before = from;
    for (int frame = 1; frame <= 120; ++frame) {
      const int shown = shownAfter(GreyImage(3, 2, to), share, memory).pixels.front();
      RC_ASSERT(std::abs(shown - (to + (from - to) * std::pow(share, frame))) <= 0.7);
      const bool isOnItsWay = to >= from ? shown >= before && shown <= to : shown <= before && shown >= to;
      RC_ASSERT(isOnItsWay);
      before = shown;
    }
  }));
}

TEST(Persistence, StartsAfreshAfterAChangeOfSizeOrWhenForgotten) {
  PersistenceMemory memory;
  shownAfter(noise(20, 10, 1), 0.9, memory);
  EXPECT_EQ(shownAfter(noise(10, 20, 2), 0.9, memory), noise(10, 20, 2)) << "as many pixels, but another shape";
  EXPECT_NE(shownAfter(noise(10, 20, 3), 0.9, memory), noise(10, 20, 3));
  EXPECT_EQ(shownAfter(noise(10, 21, 4), 0.9, memory), noise(10, 21, 4)) << "the height alone";
  EXPECT_EQ(shownAfter(noise(9, 21, 5), 0.9, memory), noise(9, 21, 5)) << "the width alone";
  shownAfter(noise(10, 20, 3), 0.9, memory);
  memory.empty = true;
  EXPECT_EQ(shownAfter(noise(10, 20, 4), 0.9, memory), noise(10, 20, 4));
  EXPECT_NE(shownAfter(noise(10, 20, 5), 0.9, memory), noise(10, 20, 5));
}

TEST(Persistence, TouchesThePixelsOfTheSpansAloneAndGivesTheSameInBands) {
  const Spans spans = {{{3, 40}}, {}, {{0, 1}, {5, 66}}, {{0, 67}}};
  const GreyImage first = noise(67, 4, 1), second = noise(67, 4, 2);
  PersistenceMemory whole, banded;
  GreyImage a, b;
  for (const GreyImage& next : {first, second}) {
    a = b = next;
    beginPersistence(67, 4, whole);
    persist(0.6, spans, 0, 4, viewOf(a), whole);
    beginPersistence(67, 4, banded);
    for (const auto& [row, rows] : {std::pair{3, 1}, std::pair{0, 2}, std::pair{2, 1}}) persist(0.6, spans, row, rows, viewOf(b), banded);
    EXPECT_EQ(a, b);
  }
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 67; ++x) {
      bool inside = false;
      for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) inside = inside || (x >= span.begin && x < span.end);
      const double mean = 0.6 * viewOf(first).at(x, y) + 0.4 * viewOf(second).at(x, y);
      if (inside)
        ASSERT_NEAR(viewOf(a).at(x, y), mean, 0.52);
      else
        ASSERT_EQ(viewOf(a).at(x, y), viewOf(second).at(x, y));
    }
}

TEST(Persistence, OfAShareThatIsNoneShowsEachImageAsItIs) {
  for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    PersistenceMemory memory;
    shownAfter(noise(67, 5, 1), none, memory);
    EXPECT_EQ(shownAfter(noise(67, 5, 2), none, memory), noise(67, 5, 2));
  }
  PersistenceMemory memory, largest;
  shownAfter(noise(67, 5, 1), 7.0, memory);
  shownAfter(noise(67, 5, 1), 0.95, largest);
  EXPECT_EQ(shownAfter(noise(67, 5, 2), 7.0, memory), shownAfter(noise(67, 5, 2), 0.95, largest));
}

TEST(Persistence, OfAFrameForgetsWhatCameBeforeItWasTurnedOffOrThePoseWasLost) {
  const auto volumeOf = [](double grey) {
    return testing::volumeOf(
        {40, 40, 40}, [grey](int, int, int) { return grey; }, glm::dvec3(4.0));
  };
  const Volume dark = volumeOf(20.0), bright = volumeOf(200.0);
  Pose pose, lost;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(80.0));
  lost.status = PoseStatus::missing;
  FrameMaker maker;
  const auto shown = [&](const Volume& volume, double persistence, const Pose& at) {
    maker.configure(Probe{}, {.persistence = persistence}, {}, volume.grid, 60, 60);
    return static_cast<int>(maker.make(volume.view(), at).grey.at(30, 30));
  };
  EXPECT_EQ(shown(bright, 0.5, pose), 200);
  EXPECT_EQ(shown(dark, 0.5, pose), 110) << "what came before stays";
  EXPECT_EQ(shown(dark, 0.0, pose), 20);
  EXPECT_EQ(shown(bright, 0.0, pose), 200);
  EXPECT_EQ(shown(bright, 0.5, pose), 200) << "and nothing from before it was turned off";
  EXPECT_EQ(shown(bright, 0.5, lost), 0);
  EXPECT_EQ(shown(dark, 0.5, pose), 20) << "nor from before the pose was lost";
}

}  // namespace
}  // namespace ew::persistence_test
