#include "ew/imaging/effects/focus.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <span>

#include "imaging/support/every_target.h"

namespace ew::focus_test {
namespace {

BeamGrid parallelGrid(int lines, double pitch_mm, int samples, double sampleSpacing_mm) {
  BeamGrid grid;
  for (int n = 0; n < lines; ++n) grid.lines.push_back({{(n - 0.5 * (lines - 1)) * pitch_mm, 0.0}, {0.0, 1.0}});
  grid.samples = samples;
  grid.sampleSpacing_mm = sampleSpacing_mm;
  return grid;
}

/// Depth (mm) of the narrowest place in [from, to].
double narrowest_mm(const BeamModel& model, double from_mm, double to_mm) {
  double best_mm = from_mm;
  for (double z = from_mm; z <= to_mm; z += 0.05)
    if (lateralWidth_mm(model, z) < lateralWidth_mm(model, best_mm)) best_mm = z;
  return best_mm;
}

enum class Drive { gaussian, even };

/// Amplitude at x, depth z, of an aperture focused at `focus`, by Fresnel's integral over the face.
double fresnelAmplitude(Drive drive, double aperture_mm, double wavelength_mm, double focus_mm, double x_mm, double z_mm) {
  const double k = 2.0 * std::numbers::pi / wavelength_mm;
  const double faceWidth_mm = 4.0 * std::numbers::ln2 / (std::numbers::pi * 1.2067) * aperture_mm;
  const double half_mm = drive == Drive::even ? 0.5 * aperture_mm : 2.5 * faceWidth_mm;
  constexpr int kSteps = 1200;
  std::complex<double> sum = 0.0;
  for (int n = 0; n < kSteps; ++n) {
    const double u = (2.0 * (n + 0.5) / kSteps - 1.0) * half_mm;
    const double weight = drive == Drive::even ? 1.0 : std::exp(-4.0 * std::numbers::ln2 * u * u / (faceWidth_mm * faceWidth_mm));
    sum += weight * std::polar(1.0, k * (0.5 * u * u * (1.0 / z_mm - 1.0 / focus_mm) - u * x_mm / z_mm));
  }
  return std::abs(sum);
}

/// Full width at half maximum of the two-way beam with dynamic receive focusing.
double fresnelWidth_mm(Drive drive, const BeamModel& model, double z_mm) {
  const double focus_mm = model.foci_mm[0];
  const auto amplitude = [&](double x_mm) {
    return fresnelAmplitude(drive, std::min(model.aperture_mm, focus_mm / 3.0), model.wavelength_mm, focus_mm, x_mm, z_mm) *
           fresnelAmplitude(drive, std::min(model.aperture_mm, z_mm / 3.0), model.wavelength_mm, z_mm, x_mm, z_mm);
  };
  const double middle = amplitude(0.0);
  double low = 0.0, high = 10.0;
  for (int n = 0; n < 40; ++n) (amplitude(0.5 * (low + high)) > 0.5 * middle ? low : high) = 0.5 * (low + high);
  return low + high;
}

TEST(LateralWidth, IsTheWidthOfAGaussianAperturesFresnelField) {
  BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 20.0, .foci_mm = {60.0}};
  for (const double z : {20.0, 40.0, 55.0, 60.0, 70.0, 100.0, 150.0})
    EXPECT_NEAR(lateralWidth_mm(model, z) / fresnelWidth_mm(Drive::gaussian, model, z), 1.0, 2e-3) << "at " << z << " mm";
}

TEST(LateralWidth, IsWithinFivePercentOfAnEvenlyDrivenApertureAtTheFocus) {
  for (const double focus : {30.0, 60.0, 120.0}) {
    const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 20.0, .foci_mm = {focus}};
    EXPECT_NEAR(lateralWidth_mm(model, focus) / fresnelWidth_mm(Drive::even, model, focus), 1.0, 0.05) << "focus " << focus << " mm";
  }
}

TEST(LateralWidth, HasItsMinimumAtAFocusInReachAndTwoMinimaAtTwoFoci) {
  const BeamModel one{.wavelength_mm = 0.3, .aperture_mm = 30.0, .foci_mm = {50.0}};
  EXPECT_NEAR(narrowest_mm(one, 0.0, 150.0), 50.0, 2.5);
  EXPECT_NEAR(lateralWidth_mm(one, 50.0), 1.2067 / std::numbers::sqrt2 * 0.3 * 3.0, 1e-3);
  const BeamModel two{.wavelength_mm = 0.3, .aperture_mm = 30.0, .foci_mm = {30.0, 80.0}};
  EXPECT_NEAR(narrowest_mm(two, 5.0, 50.0), 30.0, 1.5);
  EXPECT_NEAR(narrowest_mm(two, 50.0, 150.0), 80.0, 4.0);
  EXPECT_GT(lateralWidth_mm(two, 50.0), 1.2 * lateralWidth_mm(two, 80.0));
  for (double z = 0.0; z < 200.0; z += 1.0)
    EXPECT_LE(lateralWidth_mm(two, z), lateralWidth_mm({.wavelength_mm = 0.3, .aperture_mm = 30.0, .foci_mm = {30.0}}, z));
}

TEST(LateralWidth, ADeepFocusMakesItsDepthSharperThanAShallowOneWould) {
  for (double focus = 100.0; focus <= 200.0; focus += 20.0) {
    const BeamModel deep{.wavelength_mm = 0.44, .aperture_mm = 20.0, .foci_mm = {focus}};
    const BeamModel shallow{.wavelength_mm = 0.44, .aperture_mm = 20.0, .foci_mm = {0.6 * focus}};
    EXPECT_LT(lateralWidth_mm(deep, focus), 0.8 * lateralWidth_mm(shallow, focus));
    EXPECT_GT(lateralWidth_mm(deep, 0.6 * focus), lateralWidth_mm(shallow, 0.6 * focus));
  }
}

RC_GTEST_PROP(LateralWidth, IsFiniteAndPositiveAtAnyDepthWithAnyFoci, ()) {
  const auto anyDepth = rc::gen::element(0.0, -5.0, 1e-9, 3.0, 80.0, 500.0, 1e6, std::numeric_limits<double>::quiet_NaN());
  const auto anyFocus =
      rc::gen::element(0.0, -1.0, 1e-3, 40.0, 1e5, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
  BeamModel model;
  for (double& focus : model.foci_mm) focus = *anyFocus;
  const double width = lateralWidth_mm(model, *anyDepth);
  RC_ASSERT(std::isfinite(width));
  RC_ASSERT(width > 0.0);
}

TEST(BlurWidth, IsWhatTheRecordingLacksAndFollowsTheStrength) {
  BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 20.0, .foci_mm = {50.0}, .recordedWidth_mm = 1.2};
  const double wide = lateralWidth_mm(model, 120.0);
  EXPECT_NEAR(std::hypot(blurWidth_mm(model, 120.0), 1.2), wide, 1e-12);
  EXPECT_EQ(blurWidth_mm(model, 50.0), 0.0);
  model.strength = 2.0;
  EXPECT_NEAR(blurWidth_mm(model, 120.0), 2.0 * std::sqrt(wide * wide - 1.44), 1e-12);
  model.strength = 0.0;
  EXPECT_EQ(blurWidth_mm(model, 120.0), 0.0);
}

TEST(BeamModel, AtTheProbesOwnFrequencyLeavesRowsAtAFocusInReachAsRecorded) {
  Probe probe;
  probe.carrier_hz = 5e6;
  probe.aperture_mm = 20.0;
  Knobs knobs;
  BeamModel model = beamModelOf(probe, knobs, {}, 80.0);
  EXPECT_EQ(model.foci_mm[0], 40.0);
  EXPECT_NEAR(model.wavelength_mm, 0.308, 1e-12);
  EXPECT_LT(blurWidth_mm(model, 40.0), 0.01);
  EXPECT_GT(blurWidth_mm(model, 70.0), 0.5);
  knobs.focus_mm = 55.0;
  knobs.moreFoci_mm = {20.0, 0.0, 0.0};
  knobs.carrier_hz = 2.5e6;
  model = beamModelOf(probe, knobs, {.strength = 2.0}, 80.0);
  EXPECT_EQ(model.foci_mm, (std::array<double, kMostFoci>{55.0, 20.0, 0.0, 0.0}));
  EXPECT_GT(blurWidth_mm(model, 55.0), 0.5) << "a lower frequency cannot be as sharp as the recording";
  EXPECT_EQ(model.strength, 2.0);
}

/// Place where a rising row crosses a level, by linear interpolation.
double crossing(std::span<const float> row, double level) {
  for (std::size_t x = 1; x < row.size(); ++x) {
    const double before = row[x - 1], here = row[x];
    if (here >= level) return static_cast<double>(x) - 1.0 + (level - before) / (here - before);
  }
  return static_cast<double>(row.size());
}
double edgeWidth(std::span<const float> row, double height) { return crossing(row, 0.9 * height) - crossing(row, 0.1 * height); }

std::span<const float> rowOf(const BeamImage& image, int y) {
  return std::span(image.pixels).subspan(static_cast<std::size_t>(y * image.width), static_cast<std::size_t>(image.width));
}

BeamImage edgeAt(int line, int lines, int samples) {
  BeamImage image(lines, samples);
  for (int s = 0; s < samples; ++s)
    for (int n = line; n < lines; ++n) viewOf(image).at(n, s) = 200.0F;
  return image;
}

/// From 10 to 90 % of a Gaussian of full width 1 at half maximum.
constexpr double kEdgeOfWidth = 2.0 * 1.281552 / 2.354820;

TEST(LateralKernel, GivesAnEdgeTheWidthOfTheModelAtEveryDepthSharpestAtTheFoci) {
  const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {30.0, 70.0}};
  const BeamGrid grid = parallelGrid(256, 0.25, 300, 0.4);
  BeamImage image = edgeAt(128, 256, 300);
  std::vector<float> scratch;
  blurLaterally(makeLateralKernels(model, grid), 0, viewOf(image), scratch);
  std::vector<double> edge_mm;
  for (int s = 0; s < 300; ++s) {
    edge_mm.push_back(edgeWidth(rowOf(image, s), 200.0) * 0.25);
    EXPECT_NEAR(edge_mm.back() / (kEdgeOfWidth * lateralWidth_mm(model, grid.depth_mm(s))), 1.0, 0.02) << "sample " << s;
    EXPECT_NEAR(crossing(rowOf(image, s), 100.0), 127.5, 1e-3);
  }
  const auto narrowest = [&](int from, int to) { return std::min_element(edge_mm.begin() + from, edge_mm.begin() + to) - edge_mm.begin(); };
  EXPECT_NEAR(grid.depth_mm(static_cast<double>(narrowest(10, 120))), 30.0, 2.0);
  EXPECT_NEAR(grid.depth_mm(static_cast<double>(narrowest(120, 300))), 70.0, 5.0);
}

TEST(LateralKernel, SpreadsALineToTheModelsWidthAndKeepsItsSumExactly) {
  const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {50.0}};
  const BeamGrid grid = parallelGrid(256, 0.25, 200, 0.5);
  BeamImage image(256, 200);
  for (int s = 0; s < 200; ++s) viewOf(image).at(128, s) = 255.0F;
  std::vector<float> scratch;
  blurLaterally(makeLateralKernels(model, grid), 0, viewOf(image), scratch);
  for (int s = 0; s < 200; ++s) {
    double sum = 0.0, squares = 0.0;
    for (int n = 0; n < 256; ++n) {
      const double level = viewOf(image).at(n, s);
      sum += level;
      squares += level * (n - 128.0) * (n - 128.0);
    }
    EXPECT_EQ(sum, 255.0);
    const double width_mm = std::sqrt(8.0 * std::numbers::ln2 * squares / sum) * 0.25;
    EXPECT_NEAR(width_mm / lateralWidth_mm(model, grid.depth_mm(s)), 1.0, 0.02) << "sample " << s;
  }
}

LateralKernels kernelOf(int radius, unsigned seed) {
  std::mt19937 random(seed);
  LateralKernels kernels{{{radius, 0}}, {1.0F}};
  for (int k = 1; k <= radius; ++k) {
    kernels.weights.push_back(static_cast<float>(random() % (32768 / static_cast<unsigned>(radius + 1))) / 65536.0F);
    kernels.weights.front() -= 2.0F * kernels.weights.back();
  }
  return kernels;
}

RC_GTEST_PROP(LateralKernel, EqualsThePlainSumForAnyWidthAndRadiusAndMirrorsExactly, ()) {
  const int width = *rc::gen::inRange(1, 300), radius = *rc::gen::inRange(1, 40);
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const LateralKernels kernels = kernelOf(radius, seed);
  std::mt19937 random(seed);
  BeamImage image(width, 1), mirrored(width, 1);
  for (float& level : image.pixels) level = static_cast<float>(random() % 256);
  std::reverse_copy(image.pixels.begin(), image.pixels.end(), mirrored.pixels.begin());
  const BeamImage before = image;
  std::vector<float> scratch;
  blurLaterally(kernels, 0, viewOf(image), scratch);
  blurLaterally(kernels, 0, viewOf(mirrored), scratch);
  for (int x = 0; x < width; ++x) {
    const auto at = [&](int n) { return before.pixels[static_cast<std::size_t>(std::clamp(n, 0, width - 1))]; };
    float sum = kernels.weights[0] * at(x);
    for (int k = 1; k <= radius; ++k) sum += kernels.weights[static_cast<std::size_t>(k)] * (at(x - k) + at(x + k));
    RC_ASSERT(image.pixels[static_cast<std::size_t>(x)] == sum);
    RC_ASSERT(mirrored.pixels[static_cast<std::size_t>(width - 1 - x)] == sum);
  }
}

TEST(LateralKernel, LeavesConstantsAsTheyAreAndWorksOnAnyBandOfRows) {
  const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {50.0}, .strength = 3.0};
  const BeamGrid grid = parallelGrid(100, 0.3, 64, 2.0);
  const LateralKernels kernels = makeLateralKernels(model, grid);
  std::vector<float> scratch;
  BeamImage flat(100, 64, 201.0F);
  blurLaterally(kernels, 0, viewOf(flat), scratch);
  EXPECT_EQ(flat, BeamImage(100, 64, 201.0F));

  std::mt19937 random(3);
  BeamImage whole(100, 64);
  for (float& level : whole.pixels) level = static_cast<float>(random() % 256);
  BeamImage inBands = whole;
  blurLaterally(kernels, 0, viewOf(whole), scratch);
  for (const auto& [first, rows] : {std::pair{0, 10}, {10, 1}, {11, 53}})
    blurLaterally(kernels, first, {viewOf(inBands).row(first), 100, rows, 100}, scratch);
  EXPECT_EQ(inBands, whole);
}

TEST(LateralKernel, IsCappedAtHalfOfTheLinesAndMissingWhereNothingWouldBeSeen) {
  BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {50.0}, .strength = 3.0};
  const LateralKernels wide = makeLateralKernels(model, parallelGrid(12, 0.1, 20, 5.0));
  for (const auto& row : wide.rows) EXPECT_EQ(row.radius, 6);
  model.strength = 0.0;
  const LateralKernels none = makeLateralKernels(model, parallelGrid(12, 0.1, 20, 5.0));
  EXPECT_TRUE(none.weights.empty());
  for (const auto& row : none.rows) EXPECT_EQ(row.radius, 0);
}

TEST(LateralKernel, ALevelThatIsNoNumberSpoilsItsRadiusInItsRowAlone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  LateralKernels kernels = kernelOf(5, 1);
  kernels.rows.assign(3, kernels.rows[0]);
  BeamImage image(64, 3, 10.0F);
  viewOf(image).at(30, 1) = nan;
  std::vector<float> scratch;
  blurLaterally(kernels, 0, viewOf(image), scratch);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(std::isnan(viewOf(image).at(x, y)), y == 1 && std::abs(x - 30) <= 5) << x << ", " << y;
}

TEST(RowStretch, GivesAnEdgeTheWidthItsDocumentationStates) {
  const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {50.0}, .strength = 2.0};
  const BeamGrid grid = parallelGrid(256, 0.25, 100, 1.2);
  std::vector<int> samplesOfRow;
  rowResolutions(model, grid, samplesOfRow);
  std::vector<float> scratch;
  BeamImage meanEdge(128, 100);
  double widest = 0.0, narrowest = 10.0, furthest = 0.0;
  for (int edge = 96; edge < 160; ++edge) {
    BeamImage image = edgeAt(edge, 256, 100);
    stretchRows(samplesOfRow, 0, viewOf(image), scratch);
    for (int s = 0; s < 100; ++s) {
      const std::span<const float> row = rowOf(image, s);
      const double width_lines = 255.0 / (samplesOfRow[static_cast<std::size_t>(s)] - 1);
      const double measured = edgeWidth(row, 200.0) / width_lines;
      widest = std::max(widest, measured);
      narrowest = std::min(narrowest, measured);
      furthest = std::max(furthest, std::abs(crossing(row, 100.0) - (edge - 0.5)) / width_lines);
      for (int x = 0; x < 128; ++x) viewOf(meanEdge).at(x, s) += row[static_cast<std::size_t>(edge - 64 + x)];
    }
  }
  EXPECT_NEAR(narrowest, 0.8, 0.01);
  EXPECT_NEAR(widest, 1.6, 0.01) << "a sample in the middle of the edge";
  EXPECT_LT(furthest, 0.5);
  double worst = 0.0;
  for (int s = 0; s < 100; ++s) {
    const double edge_mm = edgeWidth(rowOf(meanEdge, s), 64.0 * 200.0) * 0.25;
    worst = std::max(worst, std::abs(edge_mm / (kEdgeOfWidth * blurWidth_mm(model, grid.depth_mm(s))) - 1.0));
  }
  EXPECT_LT(worst, 0.1);
}

RC_GTEST_PROP(RowStretch, InterpolatesBetweenItsSamplesForAnyLengthsAndMirrorsExactly, ()) {
  const int width = *rc::gen::inRange(1, 300), samples = *rc::gen::inRange(1, 320);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  BeamImage image(width, 1);
  for (float& level : image.pixels) level = static_cast<float>(random() % 256000) * 0.001F;
  const std::vector<float> before = image.pixels;
  BeamImage mirrored = image;
  std::reverse(mirrored.pixels.begin(), mirrored.pixels.end());
  const auto interpolated = [](const std::vector<double>& values, double position) {
    const auto left = std::min(static_cast<std::size_t>(position), values.size() - 2);
    return values[left] + (position - static_cast<double>(left)) * (values[left + 1] - values[left]);
  };
  std::vector<double> expected(before.begin(), before.end());
  if (samples == 1) std::fill(expected.begin(), expected.end(), before.front());
  if (samples > 1 && samples < width) {
    std::vector<double> few;
    for (int k = 0; k < samples; ++k) few.push_back(interpolated(expected, static_cast<double>(k) * (width - 1) / (samples - 1)));
    for (int x = 0; x < width; ++x)
      expected[static_cast<std::size_t>(x)] = interpolated(few, static_cast<double>(x) * (samples - 1) / (width - 1));
  }
  std::vector<float> scratch;
  const std::vector<int> samplesOfRow{samples};
  stretchRows(samplesOfRow, 0, viewOf(image), scratch);
  for (std::size_t x = 0; x < expected.size(); ++x) RC_ASSERT(std::abs(static_cast<double>(image.pixels[x]) - expected[x]) < 0.08);
  RC_ASSERT(image.pixels.front() == before.front());
  if (samples > 1) RC_ASSERT(image.pixels.back() == before.back());
  if (samples == 1) return;
  stretchRows(samplesOfRow, 0, viewOf(mirrored), scratch);
  std::reverse(mirrored.pixels.begin(), mirrored.pixels.end());
  RC_ASSERT(mirrored == image);
}

TEST(RowStretch, KeepsWholeLevelsThatAreConstantToTheLastBit) {
  std::vector<float> scratch;
  std::vector<int> samplesOfRow;
  for (int samples = 1; samples <= 192; ++samples) samplesOfRow.push_back(samples);
  BeamImage flat(192, 192, 97.0F);
  stretchRows(samplesOfRow, 0, viewOf(flat), scratch);
  EXPECT_EQ(flat, BeamImage(192, 192, 97.0F));
}

TEST(RowStretch, TakesFewestSamplesWhereTheBeamIsWidestAndAllAtTheFocus) {
  const BeamModel model{.wavelength_mm = 0.44, .aperture_mm = 25.0, .foci_mm = {50.0}, .recordedWidth_mm = 1.1};
  std::vector<int> samplesOfRow;
  rowResolutions(model, parallelGrid(192, 0.3, 300, 0.4), samplesOfRow);
  EXPECT_EQ(samplesOfRow[122], 192);
  EXPECT_LT(samplesOfRow[299], 60);
  EXPECT_GE(*std::min_element(samplesOfRow.begin(), samplesOfRow.end()), 2);
}

TEST(Focus, EveryVectorTargetGivesTheSameBits) {
  std::mt19937 random(7);
  BeamImage image(181, 60);
  for (float& level : image.pixels) level = std::uniform_real_distribution<float>(0.0F, 255.0F)(random);
  LateralKernels kernels;
  std::vector<int> samplesOfRow;
  for (int radius = 1; radius <= 60; ++radius) {
    const LateralKernels one = kernelOf(radius, 3);
    kernels.rows.push_back({radius, kernels.weights.size()});
    kernels.weights.insert(kernels.weights.end(), one.weights.begin(), one.weights.end());
    samplesOfRow.push_back(3 * radius + 2);
  }
  const auto made = [&] {
    BeamImage blurred = image, stretched = image;
    std::vector<float> scratch;
    blurLaterally(kernels, 0, viewOf(blurred), scratch);
    stretchRows(samplesOfRow, 0, viewOf(stretched), scratch);
    return std::pair(blurred, stretched);
  };
  const auto expected = made();
  testing::onEveryTarget([&](const char* name) { EXPECT_EQ(made(), expected) << name; });
}

}  // namespace
}  // namespace ew::focus_test
