// Hard cases of focus and slice thickness; each test's name is the documented outcome.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ew/imaging/effects/focus.h"
#include "ew/imaging/effects/slice_thickness.h"

namespace ew::imaging_focus_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

BeamGrid fan(int lines, int samples, double sampleSpacing_mm, double faceHalfWidth_mm) {
  BeamGrid grid;
  for (int n = 0; n < lines; ++n) {
    const double across = 2.0 * n / (lines - 1) - 1.0;
    grid.lines.push_back({{faceHalfWidth_mm * across, 0.0}, {std::sin(0.5 * across), std::cos(0.5 * across)}});
  }
  grid.samples = samples;
  grid.sampleSpacing_mm = sampleSpacing_mm;
  return grid;
}

BeamModel modelWith(std::array<double, kMostFoci> foci_mm) { return {.wavelength_mm = 0.4, .aperture_mm = 25.0, .foci_mm = foci_mm}; }

TEST(FocusHardCases, FociThatAreNoneDoNotCountAndTwiceTheSameIsOnce) {
  for (double z = 0.0; z <= 150.0; z += 5.0) {
    const double expected = lateralWidth_mm(modelWith({40.0}), z);
    EXPECT_EQ(lateralWidth_mm(modelWith({40.0, 0.0, -3.0, kNan}), z), expected);
    EXPECT_EQ(lateralWidth_mm(modelWith({kNan, kInfinity, 40.0, 40.0}), z), expected);
  }
}

TEST(FocusHardCases, AFocusDeeperThanTheImageSharpensWhatLiesAboveItAndNoFocusIsAnUnfocusedBeam) {
  EXPECT_LT(lateralWidth_mm(modelWith({300.0}), 150.0), lateralWidth_mm(modelWith({50.0}), 150.0));
  const BeamModel none = modelWith({});
  for (double z = 0.0; z <= 150.0; z += 5.0)
    EXPECT_NEAR(lateralWidth_mm(none, z), lateralWidth_mm(modelWith({1e9}), z), 1e-6 * lateralWidth_mm(none, z));
}

TEST(FocusHardCases, LinesThatMeetAtTheFaceAreBlurredOverHalfOfThem) {
  const BeamGrid phased = fan(64, 50, 2.0, 0.0);
  const LateralKernels kernels = makeLateralKernels(modelWith({50.0}), phased);
  EXPECT_EQ(kernels.rows[0].radius, 32);
  std::vector<int> samplesOfRow;
  rowResolutions(modelWith({50.0}), phased, samplesOfRow);
  EXPECT_EQ(samplesOfRow[0], 2);
  EXPECT_GT(samplesOfRow[25], 10);
}

TEST(FocusHardCases, StrengthZeroOrNoNumberBlursNothingAndInfiniteStrengthTakesTheWidestKernel) {
  const BeamGrid grid = fan(64, 50, 2.0, 20.0);
  for (const double strength : {0.0, -1.0, kNan}) {
    BeamModel model = modelWith({50.0});
    model.strength = strength;
    EXPECT_TRUE(makeLateralKernels(model, grid).weights.empty());
  }
  BeamModel model = modelWith({50.0});
  model.strength = kInfinity;
  const LateralKernels kernels = makeLateralKernels(model, grid);
  for (const auto& row : kernels.rows) EXPECT_EQ(row.radius, 32);
  BeamImage flat(64, 50, 77.0F);
  std::vector<float> scratch;
  blurLaterally(kernels, 0, viewOf(flat), scratch);
  EXPECT_EQ(flat, BeamImage(64, 50, 77.0F));
}

TEST(FocusHardCases, ALevelThatIsNoNumberStaysWithinThreeIntervalsOfItsRow) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int lines = 101;
  for (const int samples : {2, 3, 11, 40, 100}) {
    const double interval = static_cast<double>(lines - 1) / (samples - 1);
    for (int spoiled = 0; spoiled < lines; ++spoiled) {
      BeamImage image(lines, 3, 10.0F);
      viewOf(image).at(spoiled, 1) = nan;
      const std::vector<int> samplesOfRow(3, samples);
      std::vector<float> scratch;
      stretchRows(samplesOfRow, 0, viewOf(image), scratch);
      int first = lines, last = -1;
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < lines; ++x) {
          if (!std::isnan(viewOf(image).at(x, y))) continue;
          EXPECT_EQ(y, 1);
          first = std::min(first, x);
          last = std::max(last, x);
        }
      EXPECT_LE(last - first, 3.0 * interval + 1e-9) << samples << " samples, line " << spoiled;
    }
  }
}

TEST(FocusHardCases, RowsOfOneSampleRepeatTheFirstLineTwoMakeARampAndManyStayAsTheyAre) {
  BeamImage image(9, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 9; ++x) viewOf(image).at(x, y) = static_cast<float>(x == 8 ? 80 : 16 * (x % 2));
  const BeamImage before = image;
  std::vector<float> scratch;
  stretchRows(std::vector<int>{1, 2, 9, 1000}, 0, viewOf(image), scratch);
  for (int x = 0; x < 9; ++x) {
    EXPECT_EQ(viewOf(image).at(x, 0), 0.0F);
    EXPECT_EQ(viewOf(image).at(x, 1), 10.0F * static_cast<float>(x));
    EXPECT_EQ(viewOf(image).at(x, 2), viewOf(before).at(x, 2));
    EXPECT_EQ(viewOf(image).at(x, 3), viewOf(before).at(x, 3));
  }
  for (const int width : {0, 1, 2}) {
    BeamImage narrow(width, 3, 5.0F);
    stretchRows(std::vector<int>{1, 2, 3}, 0, viewOf(narrow), scratch);
    blurLaterally({{{1, 0}, {1, 0}, {1, 0}}, {0.5F, 0.25F}}, 0, viewOf(narrow), scratch);
    EXPECT_EQ(narrow, BeamImage(width, 3, 5.0F));
  }
}

TEST(SliceThicknessHardCases, AThicknessThatIsNoneMakesEveryPlaneTheImagePlane) {
  for (const double scale : {0.0, -2.0, kNan})
    for (const ElevationPlane& plane : makeElevationPlanes({}, 0.0, {.scale = scale}, fan(8, 100, 1.0, 10.0), 5)) {
      ASSERT_EQ(plane.pieces.size(), 1U);
      EXPECT_EQ(plane.pieces[0].offsetAtFirst_mm, 0.0);
      EXPECT_EQ(plane.pieces[0].offsetAtLast_mm, 0.0);
    }
}

TEST(SliceThicknessHardCases, TwoSamplesMakeOneStraightPieceAndAnyLensFocusIsFollowed) {
  for (const double focus_mm : {0.1, 1.0, 99.0, 100.0, 1e6}) {
    Probe probe;
    probe.elevationalFocus_mm = focus_mm;
    EXPECT_EQ(makeElevationPlanes(probe, 0.0, {}, fan(8, 2, 99.0, 10.0), 3)[1].pieces.size(), 1U);
    const BeamGrid grid = fan(8, 100, 1.0, 10.0);
    const ElevationPlane plane = makeElevationPlanes(probe, 0.0, {}, grid, 3)[1];
    const double sigmas = elevationRule(3).offset_sigmas[1] / std::sqrt(8.0 * std::log(2.0));
    for (const ElevationPlane::Piece& piece : plane.pieces)
      for (int s = piece.firstSample; s <= piece.lastSample; ++s) {
        const double along = piece.lastSample > piece.firstSample
                                 ? static_cast<double>(s - piece.firstSample) / (piece.lastSample - piece.firstSample)
                                 : 0.0;
        const double offset_mm = piece.offsetAtFirst_mm + along * (piece.offsetAtLast_mm - piece.offsetAtFirst_mm);
        EXPECT_NEAR(offset_mm / (sigmas * elevationalWidth_mm(probe, 0.0, {}, grid.depth_mm(s))), 1.015, 0.0151);
      }
  }
}

}  // namespace
}  // namespace ew::imaging_focus_test
