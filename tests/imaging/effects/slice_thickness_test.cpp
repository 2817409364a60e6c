#include "ew/imaging/effects/slice_thickness.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "imaging/support/support.h"

namespace ew::slice_thickness_test {
namespace {

Probe probeWithLens() {
  Probe probe;
  probe.elevationalThickness_mm = 2.5;
  probe.elevationalFocus_mm = 60.0;
  probe.elevationalAperture_mm = 12.0;
  return probe;
}

/// Lines that fan out evenly and mirror onto each other exactly.
BeamGrid fanGrid(int lines, int samples, double sampleSpacing_mm) {
  BeamGrid grid;
  grid.lines.resize(static_cast<std::size_t>(lines));
  for (int n = 0; n < lines; ++n) {
    const double across = (2.0 * n - (lines - 1)) / (lines - 1);
    grid.lines[static_cast<std::size_t>(n)] = {{20.0 * across, 0.0}, {std::sin(0.3 * across), std::cos(0.3 * across)}};
  }
  grid.samples = samples;
  grid.sampleSpacing_mm = sampleSpacing_mm;
  return grid;
}

TEST(ElevationalWidth, IsTheElementsHeightAtTheFaceAndTheThicknessAtTheLensFocus) {
  const Probe probe = probeWithLens();
  EXPECT_EQ(elevationalWidth_mm(probe, 0.0, {}, 0.0), 12.0);
  EXPECT_NEAR(elevationalWidth_mm(probe, probe.carrier_hz, {}, 60.0), 2.5, 1e-12);
  EXPECT_NEAR(elevationalWidth_mm(probe, 2.0 * probe.carrier_hz, {}, 60.0), 1.25, 1e-12);
  EXPECT_NEAR(elevationalWidth_mm(probe, 0.0, {.scale = 3.0}, 60.0), 7.5, 1e-12);
  EXPECT_NEAR(elevationalWidth_mm(probe, 0.0, {}, 120.0), 13.0, 1e-12);
  EXPECT_EQ(elevationalWidth_mm(probe, 0.0, {}, std::nan("")), 12.0);
}

TEST(ElevationRule, HasTheMeanAndTheWidthOfTheNormalDistributionAndWeightsThatFallOff) {
  for (const int planes : {3, 5, 7, 9}) {
    const ElevationRule rule = elevationRule(planes);
    ASSERT_EQ(rule.weights.size(), static_cast<std::size_t>(planes));
    ASSERT_EQ(rule.offset_sigmas.size(), static_cast<std::size_t>(planes));
    double sum = 0.0, mean = 0.0, variance = 0.0;
    for (std::size_t p = 0; p < rule.weights.size(); ++p) {
      sum += rule.weights[p];
      mean += rule.weights[p] * rule.offset_sigmas[p];
      variance += rule.weights[p] * rule.offset_sigmas[p] * rule.offset_sigmas[p];
      EXPECT_LE(rule.weights[p], p > 0 ? rule.weights[p - 1] : 1.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_EQ(mean, 0.0);
    EXPECT_NEAR(variance, 1.0, 1e-9) << planes << " planes";
    EXPECT_GT(rule.weights.back(), 0.01);
  }
}

/// Root mean square difference between the rule's mean and the exact mean of a random field of unit variance, whose correlation is a
/// Gaussian of standard deviation `ratio` times the beam's: all three expectations in closed form.
double errorOnSpeckle(const ElevationRule& rule, double ratio) {
  const auto correlation = [&](double distance, double spread) {
    const double variance = ratio * ratio + spread;
    return ratio / std::sqrt(variance) * std::exp(-0.5 * distance * distance / variance);
  };
  double squared = correlation(0.0, 2.0);
  for (std::size_t p = 0; p < rule.weights.size(); ++p) {
    squared -= 2.0 * rule.weights[p] * correlation(rule.offset_sigmas[p], 1.0);
    for (std::size_t q = 0; q < rule.weights.size(); ++q)
      squared += rule.weights[p] * rule.weights[q] * correlation(rule.offset_sigmas[p] - rule.offset_sigmas[q], 0.0);
  }
  return std::sqrt(std::max(squared, 0.0));
}

TEST(ElevationRule, IsAsAccurateOnSpeckleAsItsDocumentationStates) {
  EXPECT_NEAR(errorOnSpeckle(elevationRule(3), 0.4), 0.34, 0.01);
  EXPECT_NEAR(errorOnSpeckle(elevationRule(5), 0.4), 0.11, 0.01);
  EXPECT_NEAR(errorOnSpeckle(elevationRule(7), 0.4), 0.045, 0.001);
  EXPECT_NEAR(errorOnSpeckle(elevationRule(9), 0.4), 0.024, 0.001);
  for (const double ratio : {0.1, 0.2, 0.4, 0.8, 1.6})
    for (const int planes : {3, 5, 7})
      EXPECT_LT(errorOnSpeckle(elevationRule(planes + 2), ratio), errorOnSpeckle(elevationRule(planes), ratio));
  for (const int planes : {3, 5, 7, 9}) EXPECT_LT(errorOnSpeckle(elevationRule(planes), 1.0), 0.06);
}

TEST(ElevationPlanes, FollowTheCurveWithinThreePercentAndStayNear) {
  const Probe probe = probeWithLens();
  const BeamGrid grid = fanGrid(16, 750, 0.2);
  for (const int planes : {3, 5, 7, 9}) {
    const auto found = makeElevationPlanes(probe, 0.0, {}, grid, planes);
    const ElevationRule rule = elevationRule(planes);
    ASSERT_EQ(found.size(), rule.weights.size());
    double weights = 0.0;
    for (std::size_t p = 0; p < found.size(); ++p) {
      const double weight = found[p].weight;
      weights += weight;
      EXPECT_NEAR(weight, rule.weights[p], 4.0 / 65536.0);
      EXPECT_LE(found[p].pieces.size(), 6U);
      int next = 0;
      for (const ElevationPlane::Piece& piece : found[p].pieces) {
        EXPECT_EQ(piece.firstSample, next);
        EXPECT_GE(piece.lastSample, piece.firstSample);
        next = piece.lastSample + 1;
        for (int s = piece.firstSample; s <= piece.lastSample; ++s) {
          const double along = piece.lastSample > piece.firstSample
                                   ? static_cast<double>(s - piece.firstSample) / (piece.lastSample - piece.firstSample)
                                   : 0.0;
          const double offset_mm = piece.offsetAtFirst_mm + along * (piece.offsetAtLast_mm - piece.offsetAtFirst_mm);
          const double exact_mm =
              rule.offset_sigmas[p] * elevationalWidth_mm(probe, 0.0, {}, grid.depth_mm(s)) / std::sqrt(8.0 * std::numbers::ln2);
          EXPECT_LE(std::abs(offset_mm), 1.0301 * std::abs(exact_mm) + 1e-12);
          EXPECT_GE(std::abs(offset_mm), 0.9999 * std::abs(exact_mm));
          EXPECT_GE(offset_mm * exact_mm, 0.0);
        }
      }
      EXPECT_EQ(next, grid.samples);
    }
    EXPECT_EQ(weights, 1.0);
  }
}

TEST(ElevationPlanes, AnyNumberOfPlanesIsTakenAsTheNextOddOneWithinThreeAndNine) {
  const Probe probe = probeWithLens();
  const BeamGrid grid = fanGrid(4, 2, 30.0);
  const auto count = [&](int planes) { return makeElevationPlanes(probe, 0.0, {}, grid, planes).size(); };
  EXPECT_EQ(count(-7), 3U);
  EXPECT_EQ(count(1), 3U);
  EXPECT_EQ(count(4), 5U);
  EXPECT_EQ(count(8), 9U);
  EXPECT_EQ(count(1000), 9U);
}

TEST(ElevationPlanes, RowsLieOnThePlaneAtEverySampleAndCoverEachLineOnce) {
  const BeamGrid grid = fanGrid(7, 300, 0.5);
  const ElevationPlane plane = makeElevationPlanes(probeWithLens(), 0.0, {}, grid, 5).back();
  ASSERT_GT(plane.pieces.size(), 2U);
  std::mt19937 random(2);
  Transform<frame::Voxel, frame::Probe> probeToVoxel;
  probeToVoxel.matrix = glm::dmat4(testing::randomRotation(random));
  probeToVoxel.matrix[3] = glm::dvec4(3.0, -4.0, 5.0, 1.0);
  std::vector<SampleRow> rows;
  rowsOf(grid, plane, probeToVoxel, rows);
  ASSERT_EQ(rows.size(), 7 * plane.pieces.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const ElevationPlane::Piece& piece = plane.pieces[r % plane.pieces.size()];
    const std::size_t line = r / plane.pieces.size();
    EXPECT_EQ(rows[r].row, static_cast<int>(line));
    EXPECT_EQ(rows[r].span, (RowSpan{piece.firstSample, piece.lastSample + 1}));
    for (int s = piece.firstSample; s <= piece.lastSample; ++s) {
      const double along = static_cast<double>(s - piece.firstSample) / std::max(1, piece.lastSample - piece.firstSample);
      const double offset_mm = piece.offsetAtFirst_mm + along * (piece.offsetAtLast_mm - piece.offsetAtFirst_mm);
      const glm::dvec2 inPlane_mm = grid.lines[line].origin_mm + grid.depth_mm(s) * grid.lines[line].direction;
      const glm::dvec3 expected_voxel(probeToVoxel.matrix * glm::dvec4(inPlane_mm, offset_mm, 1.0));
      EXPECT_LT(glm::distance(rows[r].start_voxel + static_cast<double>(s) * rows[r].step_voxel, expected_voxel), 1e-9);
    }
  }
}

/// The mean over the planes of a volume seen from a probe.
BeamImage averaged(const Volume& volume, const BeamGrid& grid, const std::vector<ElevationPlane>& planes,
                   const Transform<frame::Voxel, frame::Probe>& probeToVoxel) {
  const int lines = static_cast<int>(grid.lines.size());
  GreyImage sampled(grid.samples, lines);
  BeamImage echoes(lines, grid.samples, 1e9F);
  std::vector<SampleRow> rows;
  SliceScratch scratch;
  bool first = true;
  for (const ElevationPlane& plane : planes) {
    rowsOf(grid, plane, probeToVoxel, rows);
    sampleRows(Quality::linear, volume.view(), rows, viewOf(sampled), scratch);
    accumulatePlane(viewOf(sampled), plane.weight, first, viewOf(echoes));
    first = false;
  }
  return echoes;
}

Transform<frame::Voxel, frame::Probe> lookingDown(glm::dvec3 face_voxel) {
  Transform<frame::Voxel, frame::Probe> probeToVoxel;
  probeToVoxel.matrix[3] = glm::dvec4(face_voxel, 1.0);
  return probeToVoxel;
}

TEST(SliceThickness, ASheetBesideTheImagePlaneShowsWithTheWeightOfThePlaneThatMeetsIt) {
  // Thickness and aperture such that the beam is equally wide at the face and at the last sample, and nearly so between.
  Probe probe = probeWithLens();
  probe.elevationalFocus_mm = 1e9;
  probe.elevationalAperture_mm = 8.0 * std::sqrt(8.0 * std::numbers::ln2);
  const BeamGrid grid = fanGrid(20, 40, 1.0);
  const auto planes = makeElevationPlanes(probe, 0.0, {}, grid, 5);
  for (const ElevationPlane& plane : planes) {
    const double sheet_mm = plane.pieces.front().offsetAtFirst_mm;
    // Three voxels thick, so that the plane lies inside whatever the fraction of its place.
    const int middle = static_cast<int>(std::lround(40.0 + sheet_mm));
    const Volume volume = testing::volumeOf({90, 60, 80}, [&](int, int, int k) { return std::abs(k - middle) <= 1 ? 200.0 : 0.0; });
    const BeamImage echoes = averaged(volume, grid, planes, lookingDown({45.0, 2.0, 40.0}));
    for (const float level : echoes.pixels) EXPECT_EQ(level, plane.weight * 200.0F);
  }
}

TEST(SliceThickness, AVolumeThatIsTheSameAlongElevationStaysTheSame) {
  std::mt19937 random(5);
  std::vector<int> levels(90 * 60);
  for (int& level : levels) level = static_cast<int>(random() % 256);
  const Volume volume = testing::volumeOf({90, 60, 81}, [&](int i, int j, int) { return levels[static_cast<std::size_t>(i + 90 * j)]; });
  const BeamGrid grid = fanGrid(33, 50, 1.0);
  for (const int planes : {3, 5, 7, 9}) {
    const auto thick = makeElevationPlanes(probeWithLens(), 0.0, {}, grid, planes);
    const BeamImage mean = averaged(volume, grid, thick, lookingDown({45.0, 2.0, 40.0}));
    const BeamImage middle = averaged(volume, grid, {{thick[0].pieces, 1.0F}}, lookingDown({45.0, 2.0, 40.0}));
    EXPECT_EQ(mean, middle) << planes << " planes";
  }
}

TEST(SliceThickness, TurningTheProbeBy180DegreesMirrorsTheImage) {
  const Volume volume = testing::noiseVolume({90, 60, 81}, 11);
  const BeamGrid grid = fanGrid(34, 50, 1.0);
  const auto planes = makeElevationPlanes(probeWithLens(), 0.0, {}, grid, 7);
  const auto ahead = lookingDown({44.5, 2.0, 40.0});
  auto turned = ahead;
  turned.matrix[0][0] = turned.matrix[2][2] = -1.0;
  const BeamImage seen = averaged(volume, grid, planes, ahead);
  const BeamImage seenTurned = averaged(volume, grid, planes, turned);
  float worst = 0.0F;
  for (int s = 0; s < grid.samples; ++s)
    for (int n = 0; n < 34; ++n) worst = std::max(worst, std::abs(viewOf(seen).at(n, s) - viewOf(seenTurned).at(33 - n, s)));
  EXPECT_EQ(worst, 0.0F);
}

RC_GTEST_PROP(AccumulatePlane, TransposesAndAddsForAnySize, ()) {
  const int lines = *rc::gen::inRange(1, 70), samples = *rc::gen::inRange(1, 70);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  GreyImage one(samples, lines), two(samples, lines);
  for (auto& level : one.pixels) level = static_cast<std::uint8_t>(random());
  for (auto& level : two.pixels) level = static_cast<std::uint8_t>(random());
  BeamImage echoes(lines + 3, samples, -5.0F);
  const ImageView<float> part{echoes.pixels.data() + 1, lines, samples, lines + 3};
  accumulatePlane(viewOf(one), 0.25F, true, part);
  accumulatePlane(viewOf(two), 0.75F, false, part);
  for (int s = 0; s < samples; ++s)
    for (int n = -1; n < lines + 2; ++n) {
      const float level = echoes.pixels[static_cast<std::size_t>((lines + 3) * s + n + 1)];
      const bool inside = n >= 0 && n < lines;
      RC_ASSERT(level == (inside ? 0.25F * viewOf(one).at(s, n) + 0.75F * viewOf(two).at(s, n) : -5.0F));
    }
}

}  // namespace
}  // namespace ew::slice_thickness_test
