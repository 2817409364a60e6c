#include "ew/imaging/scan_conversion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "imaging/support/every_target.h"
#include "imaging/support/probes_at_random.h"

namespace ew::scan_conversion_test {
namespace {

/// An image of a fan: random probe, knobs and size.
struct Setting {
  Probe probe;
  Knobs knobs;
  DisplayGeometry geometry;
};

Setting settingAtRandom() {
  Setting setting;
  std::tie(setting.probe, setting.knobs) = *testing::probeAtRandom();
  setting.knobs.zoom = testing::numberBetween(1.0, 8.0);
  setting.knobs.markerLeft = *rc::gen::arbitrary<bool>();
  setting.knobs.upsideDown = *rc::gen::arbitrary<bool>();
  setting.geometry = fitDisplay(setting.probe, setting.knobs, *rc::gen::inRange(1, 160), *rc::gen::inRange(1, 160));
  return setting;
}

BeamImage beamsOf(int lines, int samples, unsigned seed) {
  BeamImage beams(lines, samples);
  std::mt19937 random(seed);
  for (float& level : beams.pixels) level = static_cast<float>(random() % 65536) / 257.0F;
  return beams;
}

/// Levels within a few steps of a half: the slightest difference in rounding changes the pixel.
BeamImage beamsNearHalves(int lines, int samples, unsigned seed) {
  BeamImage beams(lines, samples);
  std::mt19937 random(seed);
  for (float& level : beams.pixels) level = 100.5F + 7.6e-6F * (static_cast<float>(random() % 5) - 2.0F);
  return beams;
}

GreyImage converted(const ScanConversionTable& table, const BeamImage& beams) {
  GreyImage image(table.width, table.height);
  scanConvert(table, viewOf(beams), 0, table.height, viewOf(image));
  return image;
}

RC_GTEST_PROP(FanSpans, HoldExactlyThePixelsWhoseCentresTheBeamsReach, ()) {
  const Setting at = settingAtRandom();
  const BeamGrid grid = makeBeamGrid(at.probe, at.knobs, at.geometry.depth_mm, 0.4);
  const Spans spans = fanSpans(at.probe, at.knobs, at.geometry);
  RC_ASSERT(spans.size() == static_cast<std::size_t>(at.geometry.height));
  for (int y = 0; y < at.geometry.height; ++y) {
    std::vector<bool> spanned(static_cast<std::size_t>(at.geometry.width), false);
    int after = 0;
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
      RC_ASSERT(span.begin >= after && span.begin < span.end && span.end <= at.geometry.width);
      after = span.end;
      for (int x = span.begin; x < span.end; ++x) spanned[static_cast<std::size_t>(x)] = true;
    }
    for (int x = 0; x < at.geometry.width; ++x) {
      const glm::dvec2 place = lineAndSampleAt(at.probe, at.knobs, grid, at.geometry.probePoint_mm(x, y));
      const double slack = spanned[static_cast<std::size_t>(x)] ? 1e-7 : -1e-7;
      const bool inside =
          place.x >= -slack && place.x <= at.probe.lines - 1 + slack && place.y >= -slack && place.y <= grid.samples - 1 + slack;
      RC_ASSERT(inside == spanned[static_cast<std::size_t>(x)]);
    }
  }
}

RC_GTEST_PROP(ScanConversion, FindsEachPixelsLineAndSample, ()) {
  const Setting at = settingAtRandom();
  const BeamGrid grid = makeBeamGrid(at.probe, at.knobs, at.geometry.depth_mm, 0.4);
  const ScanConversionTable table = makeScanConversion(at.probe, at.knobs, grid, at.geometry);
  RC_ASSERT(table.spans == fanSpans(at.probe, at.knobs, at.geometry));
  RC_ASSERT(table.firstTapOfRow.size() == static_cast<std::size_t>(table.height) + 1);
  RC_ASSERT(table.firstTapOfRow.back() == table.taps.size());
  std::size_t n = 0;
  for (int y = 0; y < table.height; ++y) {
    RC_ASSERT(table.firstTapOfRow[static_cast<std::size_t>(y)] == n);
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)])
      for (int x = span.begin; x < span.end; ++x, ++n) {
        const auto& tap = table.taps[n];
        const auto line = tap.first % static_cast<std::uint32_t>(table.lines), sample = tap.first / static_cast<std::uint32_t>(table.lines);
        // The last of the four neighbours exists too.
        RC_ASSERT(line + 2 <= static_cast<std::uint32_t>(table.lines) && sample + 2 <= static_cast<std::uint32_t>(table.samples));
        const glm::dvec2 place = lineAndSampleAt(at.probe, at.knobs, grid, at.geometry.probePoint_mm(x, y));
        RC_ASSERT(std::abs(line + tap.lineWeight / 32768.0 - place.x) < 1.6e-5);
        RC_ASSERT(std::abs(sample + tap.sampleWeight / 32768.0 - place.y) < 1.6e-5);
      }
  }
}

RC_GTEST_PROP(ScanConversion, OfMirroredBeamsIsTheMirroredImageToTheBit, ()) {
  Setting at = settingAtRandom();
  const BeamGrid grid = makeBeamGrid(at.probe, at.knobs, at.geometry.depth_mm, 0.7);
  const ScanConversionTable table = makeScanConversion(at.probe, at.knobs, grid, at.geometry);
  at.knobs.steering_rad = -at.knobs.steering_rad;
  const ScanConversionTable other = makeScanConversion(at.probe, at.knobs, grid, at.geometry);
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const BeamImage beams =
      *rc::gen::arbitrary<bool>() ? beamsNearHalves(table.lines, table.samples, seed) : beamsOf(table.lines, table.samples, seed);
  BeamImage turned = beams;
  for (int s = 0; s < turned.height; ++s) std::reverse(viewOf(turned).row(s), viewOf(turned).row(s) + turned.width);
  GreyImage mirrored = converted(other, turned);
  for (int y = 0; y < mirrored.height; ++y) std::reverse(viewOf(mirrored).row(y), viewOf(mirrored).row(y) + mirrored.width);
  RC_ASSERT(converted(table, beams) == mirrored);
}

RC_GTEST_PROP(ScanConversion, BlendsFourNeighboursWithinOneRounding, ()) {
  const Setting at = settingAtRandom();
  const BeamGrid grid = makeBeamGrid(at.probe, at.knobs, at.geometry.depth_mm, 0.7);
  const ScanConversionTable table = makeScanConversion(at.probe, at.knobs, grid, at.geometry);
  const BeamImage beams = beamsOf(table.lines, table.samples, 3);
  GreyImage image(table.width, table.height, 7);
  scanConvert(table, viewOf(beams), 0, table.height, viewOf(image));
  std::size_t n = 0;
  for (int y = 0; y < table.height; ++y) {
    int after = 0;
    const auto untouched = [&](int to) {
      for (; after < to; ++after) RC_ASSERT(viewOf(image).at(after, y) == 7);
    };
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)]) {
      untouched(span.begin);
      for (int x = span.begin; x < span.end; ++x, ++n) {
        const auto& tap = table.taps[n];
        const auto echo = [&](std::size_t offset) { return static_cast<double>(beams.pixels[tap.first + offset]); };
        const double u = tap.lineWeight / 32768.0, v = tap.sampleWeight / 32768.0;
        const auto lines = static_cast<std::size_t>(table.lines);
        const double level = (1 - v) * ((1 - u) * echo(0) + u * echo(1)) + v * ((1 - u) * echo(lines) + u * echo(lines + 1));
        RC_ASSERT(std::abs(viewOf(image).at(x, y) - level) <= 0.5 + 1e-4);
      }
      after = span.end;
    }
    untouched(table.width);
  }
}

TEST(ScanConversion, OfConstantsAndRampsIsExact) {
  for (const ProbeKind kind : {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector}) {
    const Probe probe = testing::probeOf(kind);
    const DisplayGeometry geometry = fitDisplay(probe, {}, 300, 260);
    const BeamGrid grid = makeBeamGrid(probe, {}, geometry.depth_mm, 0.5);
    const ScanConversionTable table = makeScanConversion(probe, {}, grid, geometry);
    BeamImage depth(table.lines, table.samples);
    for (int s = 0; s < depth.height; ++s)
      std::fill_n(viewOf(depth).row(s), depth.width, static_cast<float>(200.0 * grid.depth_mm(s) / geometry.depth_mm));
    const GreyImage image = converted(table, depth);
    for (int y = 0; y < table.height; ++y)
      for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x) {
          const double level = 200.0 * grid.depth_mm(lineAndSampleAt(probe, {}, grid, geometry.probePoint_mm(x, y)).y) / geometry.depth_mm;
          ASSERT_NEAR(viewOf(image).at(x, y), level, 0.501) << x << ' ' << y;
        }
  }
}

TEST(ScanConversion, ClampsLevelsBeyondWhiteAndBelowBlack) {
  const Probe probe = testing::probeOf(ProbeKind::linear);
  const DisplayGeometry geometry = fitDisplay(probe, {}, 60, 60);
  const ScanConversionTable table = makeScanConversion(probe, {}, makeBeamGrid(probe, {}, geometry.depth_mm, 1.0), geometry);
  for (const auto& [level, shown] : {std::pair{-1e30F, 0}, std::pair{1e30F, 255}, std::pair{255.4F, 255}, std::pair{std::nanf(""), 0}})
    testing::onEveryTarget([&](const char* name) {
      const GreyImage image = converted(table, BeamImage(table.lines, table.samples, level));
      EXPECT_EQ(image.pixels[30 * 60 + 30], shown) << level << ' ' << name;
    });
}

TEST(ScanConversion, GivesTheSamePixelsOnEveryVectorUnit) {
  const Probe probe = testing::probeOf(ProbeKind::endocavity);
  const DisplayGeometry geometry = fitDisplay(probe, {}, 331, 287);
  const ScanConversionTable table = makeScanConversion(probe, {}, makeBeamGrid(probe, {}, geometry.depth_mm, 0.3), geometry);
  const BeamImage beams = beamsNearHalves(table.lines, table.samples, 9);
  GreyImage first;
  testing::onEveryTarget([&](const char* name) {
    const GreyImage image = converted(table, beams);
    if (first.pixels.empty()) first = image;
    EXPECT_EQ(image, first) << name;
  });
}

TEST(ScanConversion, InBandsOfRowsGivesTheSameImage) {
  const Probe probe = testing::probeOf(ProbeKind::convex);
  const DisplayGeometry geometry = fitDisplay(probe, {}, 211, 187);
  const ScanConversionTable table = makeScanConversion(probe, {}, makeBeamGrid(probe, {}, geometry.depth_mm, 0.3), geometry);
  const BeamImage beams = beamsOf(table.lines, table.samples, 5);
  GreyImage image(table.width, table.height);
  for (int row = 0; row < table.height; row += 13) scanConvert(table, viewOf(beams), row, std::min(13, table.height - row), viewOf(image));
  EXPECT_EQ(image, converted(table, beams));
}

}  // namespace
}  // namespace ew::scan_conversion_test
