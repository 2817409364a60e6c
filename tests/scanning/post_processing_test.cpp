#include "ew/scanning/post_processing.h"

#include <gtest/gtest.h>

#include <vector>

#include "ew/scanning/cine.h"
#include "small_scan.h"

namespace ew {
namespace {

constexpr glm::ivec2 kSize_px{160, 120};

using Pixels = std::vector<std::uint8_t>;

Pixels pixelsOf(const DisplayImage& image) {
  Pixels pixels;
  for (int y = 0; y < image.height(); ++y) pixels.insert(pixels.end(), image.grey.row(y), image.grey.row(y) + image.width());
  return pixels;
}

/// A ring of images without persistence, or with it.
CineRing ringOf(double persistence, int images = 12) {
  CineRing ring;
  Scanner scanner;
  scanner.show(test::waveSubject());
  for (int n = 0; n < images; ++n) {
    ScanState state = test::movingState(n);
    state.knobs.persistence = persistence;
    static_cast<void>(scanner.make(state, kSize_px.x, kSize_px.y));
    ring.add(state, kSize_px, [&] { return scanner.memory(); });
  }
  return ring;
}

Pixels formed(CineForming& forming, const CineRing& ring, std::size_t frame, const PostProcessing& by) {
  static_cast<void>(forming.aim(ring, frame, kSize_px, by));
  while (forming.left() > 0) forming.makeNext(ring);
  return pixelsOf(forming.image());
}

PostProcessing manyChanges() {
  PostProcessing by;
  by.greyMap = GreyMap::contrast;
  by.dynamicRange_db = 45.0;
  by.markerLeft = false;
  by.detail = Detail{2.0, {5.0, -3.0}};
  return by;
}

TEST(PostProcessing, IsWhatNeedsNoNewEchoes) {
  const Knobs before;
  const auto only = [&](auto&& change) {
    Knobs after = before;
    change(after);
    return differInProcessingOnly(before, after);
  };
  EXPECT_TRUE(only([](Knobs&) {}));
  EXPECT_TRUE(only([](Knobs& k) { k.greyMap = GreyMap::soft; }));
  EXPECT_TRUE(only([](Knobs& k) { k.dynamicRange_db = 50.0; }));
  EXPECT_TRUE(only([](Knobs& k) { k.zoom = 3.0; }));
  EXPECT_TRUE(only([](Knobs& k) { k.markerLeft = false; }));
  EXPECT_TRUE(only([](Knobs& k) { k.upsideDown = true; }));
  EXPECT_FALSE(only([](Knobs& k) { k.gain = 1.1; }));
  EXPECT_FALSE(only([](Knobs& k) { k.gain_db = 1.0; }));
  EXPECT_FALSE(only([](Knobs& k) { k.dgc[3] = 1.2; }));
  EXPECT_FALSE(only([](Knobs& k) { k.tgc_db[3] = 2.0; }));
  EXPECT_FALSE(only([](Knobs& k) { k.depth_mm = 90.0; }));
  EXPECT_FALSE(only([](Knobs& k) { k.focus_mm = 20.0; }));
  EXPECT_FALSE(only([](Knobs& k) { k.carrier_hz = 5e6; }));
  EXPECT_FALSE(only([](Knobs& k) { k.persistence = 0.5; }));
  EXPECT_FALSE(only([](Knobs& k) { k.mode = DisplayMode::both; }));
  EXPECT_FALSE(only([](Knobs& k) { k.greyMap = GreyMap::soft, k.gain = 1.1; }));
}

TEST(PostProcessing, KeepsWhatNobodyChangedAsEachImageHasIt) {
  ScanState shown = test::movingState(3);
  Knobs asked = shown.knobs;
  asked.greyMap = GreyMap::bright;
  asked.zoom = 2.0;
  const PostProcessing by = withChange({}, shown, asked, {1.0, 2.0});
  EXPECT_FALSE(by.dynamicRange_db || by.markerLeft || by.upsideDown);
  ScanState other = test::movingState(9);
  other.knobs.markerLeft = false;
  const ScanState seen = processed(other, by);
  EXPECT_EQ(seen.knobs.greyMap, GreyMap::bright);
  EXPECT_EQ(seen.knobs.zoom, 2.0);
  EXPECT_TRUE((seen.pan == Pan{1.0, 2.0}));
  EXPECT_FALSE(seen.knobs.markerLeft);
  EXPECT_EQ(seen.knobs.gain, other.knobs.gain);
  EXPECT_TRUE(processed(other, {}) == other);
}

TEST(PostProcessing, OfACineImageIsTheImageThatTheseSettingsWouldHaveMade) {
  const CineRing ring = ringOf(0.0);
  CineForming forming(test::waveSubject());
  const PostProcessing by = manyChanges();
  Scanner scanner;
  scanner.show(test::waveSubject());
  for (const std::size_t n : {std::size_t{2}, std::size_t{9}, std::size_t{4}}) {
    const ScanState before = ring.frame(n);
    EXPECT_EQ(formed(forming, ring, n, by), pixelsOf(scanner.make(processed(before, by), kSize_px.x, kSize_px.y)));
    EXPECT_TRUE(ring.frame(n) == before) << "the ring keeps what was scanned";
  }
}

TEST(PostProcessing, TakenBackLeavesTheSamePixels) {
  for (const double persistence : {0.0, 0.6}) {
    const CineRing ring = ringOf(persistence, 60);
    CineForming forming(test::waveSubject());
    for (const std::size_t n : {std::size_t{58}, std::size_t{40}, std::size_t{41}}) {
      const Pixels before = formed(forming, ring, n, {});
      EXPECT_NE(formed(forming, ring, n, manyChanges()), before);
      PostProcessing map;
      map.greyMap = GreyMap::contrast;
      EXPECT_NE(formed(forming, ring, n, map), before);
      EXPECT_EQ(formed(forming, ring, n, {}), before);
    }
  }
}

TEST(PostProcessing, OfTheGreyMapAloneKeepsThePersistenceToTheLastBit) {
  const CineRing ring = ringOf(0.6, 60);
  PostProcessing map;
  map.greyMap = GreyMap::contrast;
  // As if the whole scan had been made with that map.
  Scanner scanner;
  scanner.show(test::waveSubject());
  Pixels last;
  for (int n = 0; n < 60; ++n) {
    ScanState state = test::movingState(n);
    state.knobs.persistence = 0.6;
    state.knobs.greyMap = GreyMap::contrast;
    last = pixelsOf(scanner.make(state, kSize_px.x, kSize_px.y));
  }
  CineForming forming(test::waveSubject());
  EXPECT_EQ(formed(forming, ring, 59, map), last);
}

}  // namespace
}  // namespace ew
