#include "ew/measurement/tracing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measurement/calipers.h"

namespace ew::measurement::tracing_test {
namespace {

constexpr ImageGeometry kGeometry{{0.4, 0.4}, {-90.0, 0.0}};

/// Speckle: the envelope of a complex Gaussian field of about 0.6 mm (axial) by 1.2 mm (lateral), log compressed over 60 dB. Inside of the
/// ellipse `inside_db` below the tissue around it, and a bright wall of 1.5 mm, as of a skull or of skin; `wall_db` above.
GreyImage speckled(const Ellipse& truth, double inside_db, double wall_db, std::uint64_t seed) {
  constexpr int kWidth = 450, kHeight = 400;
  test::Scatter scatter(seed);
  const auto size = static_cast<std::size_t>(kWidth * kHeight);
  std::vector<double> re(size), im(size);
  for (std::size_t n = 0; n < size; ++n) {
    re[n] = scatter.normal(1.0);
    im[n] = scatter.normal(1.0);
  }
  const auto blurred = [&](std::vector<double> field, double sigma, int dx, int dy) {
    std::vector<double> made(field.size(), 0.0);
    const int reach = static_cast<int>(3.0 * sigma) + 1;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        double sum = 0.0;
        for (int m = -reach; m <= reach; ++m) {
          const int u = std::clamp(x + m * dx, 0, kWidth - 1), v = std::clamp(y + m * dy, 0, kHeight - 1);
          sum += std::exp(-0.5 * m * m / (sigma * sigma)) * field[static_cast<std::size_t>(v * kWidth + u)];
        }
        made[static_cast<std::size_t>(y * kWidth + x)] = sum / std::sqrt(sigma * std::sqrt(std::numbers::pi));
      }
    return made;
  };
  re = blurred(blurred(re, 1.5, 1, 0), 0.8, 0, 1);
  im = blurred(blurred(im, 1.5, 1, 0), 0.8, 0, 1);
  GreyImage image(kWidth, kHeight);
  const double c = std::cos(truth.angle_rad), s = std::sin(truth.angle_rad);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t n = static_cast<std::size_t>(y * kWidth + x);
      const glm::dvec2 d = kGeometry.toMm({x, y}) - truth.centre_mm;
      const double u = (c * d.x + s * d.y) / truth.semiMajor_mm, v = (-s * d.x + c * d.y) / truth.semiMinor_mm;
      const double outside_mm = (std::hypot(u, v) - 1.0) * 0.5 * (truth.semiMajor_mm + truth.semiMinor_mm);
      double level_db = outside_mm < 0.0 ? inside_db : 0.0;
      if (wall_db > 0.0 && outside_mm > -1.5 && outside_mm < 0.0) level_db = wall_db;
      const double envelope_db = 10.0 * std::log10(re[n] * re[n] + im[n] * im[n] + 1e-9) + level_db;
      image.pixels[n] = static_cast<std::uint8_t>(std::clamp(140.0 + envelope_db * 255.0 / 60.0, 0.0, 255.0));
    }
  return image;
}

std::vector<glm::dvec2> roughClicks(const Ellipse& truth, int count, double deviation_mm, std::uint64_t seed) {
  test::Scatter scatter(seed);
  auto clicks = pointsOn(truth, count);
  for (glm::dvec2& click : clicks) click += glm::dvec2(scatter.normal(deviation_mm), scatter.normal(deviation_mm));
  return clicks;
}

double circumferenceOf(const std::vector<glm::dvec2>& outline) {
  return measure(test::caliper(CaliperKind::trace, outline))->figure(FigureKind::circumference)->quantity.value;
}

TEST(Snapping, FindsAStepToAFractionOfAPixel) {
  // A step smoothed over the pixel it lies in: at x = 10.3 pixels.
  GreyImage image(40, 40, 20);
  for (int y = 0; y < 40; ++y)
    for (int x = 10; x < 40; ++x)
      image.pixels[static_cast<std::size_t>(y * 40 + x)] = x == 10 ? static_cast<std::uint8_t>(20 + 0.2 * 200) : 220;
  const ImageGeometry geometry{{0.5, 0.5}, {0.0, 0.0}};
  const auto snapped = snapToEdge(viewOf(image), geometry, {7.0, 10.0}, {1, 0}, {.reach_mm = 4.0});
  ASSERT_TRUE(snapped.isFound);
  EXPECT_NEAR(snapped.at_mm.x, 0.5 * 10.3, 0.05);
  EXPECT_DOUBLE_EQ(snapped.at_mm.y, 10.0);
  EXPECT_EQ(snapped.side, EdgeSide::darkToBright);
  const auto other = snapToEdge(viewOf(image), geometry, {7.0, 10.0}, {-1, 0}, {.reach_mm = 4.0});
  EXPECT_EQ(other.side, EdgeSide::brightToDark);
  EXPECT_NEAR(other.at_mm.x, snapped.at_mm.x, 1e-9);
}

TEST(Snapping, StaysWhereItIsWithoutAnEdgeOrOfTheOtherSide) {
  GreyImage even(40, 40, 90);
  const auto nothing = snapToEdge(viewOf(even), {{0.5, 0.5}, {0, 0}}, {7.0, 10.0}, {1, 0});
  EXPECT_FALSE(nothing.isFound);
  EXPECT_EQ(nothing.at_mm, glm::dvec2(7.0, 10.0));
  for (int y = 0; y < 40; ++y)
    for (int x = 16; x < 40; ++x) even.pixels[static_cast<std::size_t>(y * 40 + x)] = 200;
  EXPECT_FALSE(snapToEdge(viewOf(even), {{0.5, 0.5}, {0, 0}}, {7.0, 10.0}, {1, 0}, {.side = EdgeSide::brightToDark}).isFound);
  EXPECT_TRUE(snapToEdge(viewOf(even), {{0.5, 0.5}, {0, 0}}, {7.0, 10.0}, {1, 0}, {.side = EdgeSide::darkToBright}).isFound);
  EXPECT_FALSE(snapToEdge(viewOf(even), {{0.5, 0.5}, {0, 0}}, {700.0, 10.0}, {1, 0}).isFound);
  EXPECT_FALSE(snapToEdge(viewOf(even), {{0.5, 0.5}, {0, 0}}, {7.0, 10.0}, {0, 0}).isFound);
}

TEST(EdgeTracing, ReadsAnImageWithPaddedRowsAsWithout) {
  const Ellipse truth{{0.0, 75.0}, 50.0, 40.0, 0.0};
  const GreyImage image = speckled(truth, -20.0, 0.0, 3);
  Image<std::uint8_t> padded(image.width + 13, image.height, 255);
  for (int y = 0; y < image.height; ++y) std::copy_n(viewOf(image).row(y), image.width, viewOf(padded).row(y));
  const ImageView<const std::uint8_t> view{padded.pixels.data(), image.width, image.height, padded.width};
  EdgeTracer a, b;
  ASSERT_TRUE(a.setImage(viewOf(image), kGeometry));
  ASSERT_TRUE(b.setImage(view, kGeometry));
  const auto clicks = roughClicks(truth, 4, 2.0, 7);  // too few for an ellipse: far ones are joined along the edge
  EXPECT_EQ(*a.traceAround(clicks), *b.traceAround(clicks));
}

/// Error of the circumference traced about eight rough clicks.
double tracedError_percent(const Ellipse& truth, double inside_db, double wall_db, std::uint64_t seed, const TracingOptions& options = {}) {
  const GreyImage image = speckled(truth, inside_db, wall_db, seed);
  EdgeTracer tracer;
  if (!tracer.setImage(viewOf(image), kGeometry, options)) return 100.0;
  const auto outline = tracer.traceAround(roughClicks(truth, 8, 2.0, seed + 100));
  if (!outline) return 100.0;
  return 100.0 * (circumferenceOf(*outline) / ellipseCircumference_mm(truth.semiMajor_mm, truth.semiMinor_mm) - 1.0);
}

TEST(AssistedMeasurement, OfEightRoughClicksIsWithinTwoPercentOfTheCircumference) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Ellipse truth{{4.0, 78.0}, 50.0 + 0.5 * static_cast<double>(seed), 38.0, 0.3 * static_cast<double>(seed)};
    EXPECT_NEAR(tracedError_percent(truth, -14.0, 0.0, seed), 0.0, 2.0) << "seed " << seed;
  }
}

TEST(AssistedMeasurement, OfAHeadFindsTheOuterBorderOfItsBrightSkull) {
  TracingOptions outerBorder;
  outerBorder.snap.side = EdgeSide::brightToDark;
  outerBorder.snap.blur_mm = 0.6;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Ellipse truth{{-3.0, 80.0}, 48.0 + static_cast<double>(seed), 39.0, 0.5 * static_cast<double>(seed)};
    EXPECT_NEAR(tracedError_percent(truth, -6.0, 18.0, seed, outerBorder), 0.0, 2.0) << "seed " << seed;
  }
}

TEST(EdgeTracing, RefusesAnImageThatIsNone) {
  EdgeTracer tracer;
  const GreyImage tiny(4, 4);
  EXPECT_EQ(tracer.setImage(viewOf(tiny), kGeometry).error().sentence(), "The image is too small to trace in: 4 x 4 pixels.");
  EXPECT_FALSE(tracer.hasImage());
  EXPECT_EQ(tracer.traceAround(std::vector<glm::dvec2>{{0, 0}, {1, 1}, {2, 0}}).error().sentence(),
            "There is no image to trace in; freeze one first.");
}

}  // namespace
}  // namespace ew::measurement::tracing_test
