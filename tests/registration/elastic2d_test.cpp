#include <gtest/gtest.h>

#include <cstring>

#include "elastic/planar_equations.h"
#include "elastic/planar_registration.h"
#include "ew/registration/elastic.h"
#include "registration/planar_pairs.h"
#include "registration/rising_progress.h"

namespace elastic2d_test {
namespace {

using namespace ew;
using namespace ew::registration;
using namespace ew::test;

constexpr int kSide = 160;
constexpr double kPixel_mm = 0.5;
constexpr double kExtent_mm = kSide * kPixel_mm;

Result<Elastic2dResult> registered(const Pair2d& pair, const Elastic2dOptions& options = {}) {
  return registerElastic2d(viewOf(pair.fixed), viewOf(pair.moving), glm::dvec2(kPixel_mm), options, noProgress());
}

TEST(PlanarSpline, ShowsALineWhenItsCoefficientsLieOnOne) {
  const SplineAxis x = splineAxis(30.0, 7.0, 0.5, 60), y = splineAxis(20.0, 6.0, 0.5, 40);
  Coefficients c;
  for (int j = 0; j < y.nodes(); ++j)
    for (int i = 0; i < x.nodes(); ++i) c.push_back(static_cast<float>(2.0 + 0.3 * (i - 1) * x.node_mm - 0.2 * (j - 1) * y.node_mm));
  std::vector<float> values;
  evaluate(x, y, c, values);
  for (int b = 0; b < 40; ++b)
    for (int a = 0; a < 60; ++a)
      ASSERT_NEAR(values[static_cast<std::size_t>(b * 60 + a)], 2.0 + 0.3 * (a + 0.5) * 0.5 - 0.2 * (b + 0.5) * 0.5, 1e-4);
}

TEST(PlanarSpline, IsCarriedOverExactlyWhenNodesAreHalved) {
  const SplineAxis x = splineAxis(32.0, 8.0, 0.5, 64), y = splineAxis(24.0, 8.0, 0.5, 48);
  const SplineAxis finerX = splineAxis(32.0, 4.0, 0.5, 64), finerY = splineAxis(24.0, 4.0, 0.5, 48);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  Coefficients c(static_cast<std::size_t>(x.nodes() * y.nodes()));
  for (float& v : c) v = normal(random);
  std::vector<float> before, after;
  evaluate(x, y, c, before);
  evaluate(finerX, finerY, carriedOver(x, y, c, finerX, finerY), after);
  for (std::size_t n = 0; n < before.size(); ++n) ASSERT_NEAR(before[n], after[n], 1e-5);
}

/// The energy whose derivatives the equations hold, summed from its definition in double.
double energyOf(const SplineAxis& x, const SplineAxis& y, const Linearised& data, const Regulariser& weights, const PlanarField& field,
                const PlanarField& step) {
  double sum = 0.0;
  std::array<std::vector<float>, 3> s;
  for (std::size_t k = 0; k < 3; ++k) evaluate(x, y, step.part[k], s[k]);
  const double area = x.sample_mm * y.sample_mm;
  for (std::size_t n = 0; n < data.residual.size(); ++n) {
    const double r = double{data.residual[n]} - double{data.gradientX[n]} * double{s[0][n]} - double{data.gradientY[n]} * double{s[1][n]} -
                     double{s[2][n]};
    sum += 0.5 * area * double{data.weight[n]} * r * r;
  }
  // Slopes and curvatures by differences on samples ten times as fine.
  const int nx = 10 * x.cells * 4, ny = 10 * y.cells * 4;
  const double hx = x.extent_mm / nx, hy = y.extent_mm / ny;
  const SplineAxis fineX = splineAxis(x.extent_mm, x.node_mm, hx, nx), fineY = splineAxis(y.extent_mm, y.node_mm, hy, ny);
  for (std::size_t k = 0; k < 3; ++k) {
    Coefficients whole = field.part[k];
    for (std::size_t n = 0; n < whole.size(); ++n) whole[n] += step.part[k][n];
    std::vector<float> v;
    evaluate(fineX, fineY, whole, v);
    const auto at = [&](int a, int b) { return static_cast<double>(v[static_cast<std::size_t>(b * nx + a)]); };
    for (int b = 1; b + 1 < ny; ++b) {
      for (int a = 1; a + 1 < nx; ++a) {
        const double dx = (at(a + 1, b) - at(a - 1, b)) / (2.0 * hx), dy = (at(a, b + 1) - at(a, b - 1)) / (2.0 * hy);
        const double slope = dx * dx + dy * dy;
        sum += 0.5 * hx * hy * (k < 2 ? weights.membrane * slope : weights.brightness * slope + weights.ridge * at(a, b) * at(a, b));
      }
    }
  }
  return sum;
}

TEST(PlanarEquations, AreTheDerivativesOfTheEnergyAgainstDifferences) {
  const SplineAxis x = splineAxis(24.0, 8.0, 1.0, 24), y = splineAxis(20.0, 7.0, 1.0, 20);
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  const std::size_t count = 24 * 20, nodes = static_cast<std::size_t>(x.nodes() * y.nodes());
  Linearised data;
  for (auto* list : {&data.gradientX, &data.gradientY, &data.residual, &data.weight}) {
    list->resize(count);
    for (float& v : *list) v = normal(random);
  }
  for (float& w : data.weight) w = std::abs(w);
  PlanarField field, none;
  for (std::size_t k = 0; k < 3; ++k) {
    none.part[k].assign(nodes, 0.0F);
    field.part[k].resize(nodes);
    for (float& v : field.part[k]) v = normal(random);
  }
  const Regulariser weights{2.0, 0.0, 1.5, 0.3};  // curvature has its own test
  PlanarEquations equations(x, y, true);
  ASSERT_TRUE(equations.assemble(data, 1, noProgress()));
  equations.regularise(weights, field);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const std::size_t node : {std::size_t{0}, nodes / 2, nodes / 2 + 3, nodes - 1}) {
      PlanarField up = none, down = none;
      const float h = 0.05F;
      up.part[k][node] = h;
      down.part[k][node] = -h;
      const double slope = (energyOf(x, y, data, weights, field, up) - energyOf(x, y, data, weights, field, down)) / (2.0 * double{h});
      const double right = static_cast<double>(equations.rightSide()[node * 3 + k]);
      EXPECT_NEAR(-slope, right, 0.02 * std::abs(right) + 0.05) << "node " << node << " part " << k;
      // Curvature of the energy along this unknown and another one: the coupling.
      std::vector<float> in(nodes * 3, 0.0F), out;
      in[node * 3 + k] = 1.0F;
      equations.multiply(in, out);
      const double middle = energyOf(x, y, data, weights, field, none);
      const double curvature =
          (energyOf(x, y, data, weights, field, up) - 2.0 * middle + energyOf(x, y, data, weights, field, down)) / (double{h} * double{h});
      EXPECT_NEAR(curvature, static_cast<double>(out[node * 3 + k]), 0.03 * std::abs(curvature) + 0.05) << "node " << node << " part " << k;
    }
  }
}

TEST(PlanarEquations, SolveToTheStepThatMultipliesBackToTheRightSide) {
  const SplineAxis x = splineAxis(40.0, 8.0, 1.0, 40), y = splineAxis(40.0, 8.0, 1.0, 40);
  std::mt19937 random(9);
  std::normal_distribution<float> normal;
  Linearised data;
  for (auto* list : {&data.gradientX, &data.gradientY, &data.residual, &data.weight}) {
    list->resize(1600);
    for (float& v : *list) v = normal(random);
  }
  for (float& w : data.weight) w = std::abs(w);
  PlanarField field;
  for (auto& part : field.part) part.assign(static_cast<std::size_t>(x.nodes() * y.nodes()), 0.0F);
  PlanarEquations equations(x, y, true);
  ASSERT_TRUE(equations.assemble(data, 1, noProgress()));
  equations.regularise({1.0, 4.0, 1.0, 0.1}, field);
  const PlanarField step = equations.solve(500, 1e-7);
  std::vector<float> flat(equations.rightSide().size()), back;
  for (std::size_t n = 0; n < flat.size(); ++n) flat[n] = step.part[n % 3][n / 3];
  equations.multiply(flat, back);
  double error = 0.0, size = 0.0;
  for (std::size_t n = 0; n < back.size(); ++n) {
    error += std::pow(static_cast<double>(back[n] - equations.rightSide()[n]), 2.0);
    size += std::pow(static_cast<double>(equations.rightSide()[n]), 2.0);
  }
  EXPECT_LT(std::sqrt(error / size), 1e-4);
}

TEST(PlanarEquations, CountNoCurvatureInAPlaneAndKnowThatOfAParabola) {
  const SplineAxis x = splineAxis(32.0, 8.0, 1.0, 32), y = splineAxis(32.0, 8.0, 1.0, 32);
  // Coefficients of x^2 / 2: at node i the square of its place less a third of the spacing's square, halved.
  PlanarField field;
  for (auto& part : field.part) part.assign(static_cast<std::size_t>(x.nodes() * y.nodes()), 0.0F);
  PlanarField plane = field;
  for (int j = 0; j < y.nodes(); ++j) {
    for (int i = 0; i < x.nodes(); ++i) {
      const double place = (i - 1) * x.node_mm;
      field.part[0][static_cast<std::size_t>(j * x.nodes() + i)] = static_cast<float>(0.5 * (place * place - x.node_mm * x.node_mm / 3.0));
      plane.part[0][static_cast<std::size_t>(j * x.nodes() + i)] = static_cast<float>(place);
    }
  }
  const auto bendingOf = [&](const PlanarField& of) {
    PlanarEquations equations(x, y, false);
    equations.regularise({0.0, 1.0, 0.0, 0.0}, of);
    double energy = 0.0;  // the energy is half of - step . right side for the field itself
    for (std::size_t n = 0; n < of.part[0].size(); ++n)
      energy -= static_cast<double>(of.part[0][n]) * static_cast<double>(equations.rightSide()[n * 3]);
    return energy;
  };
  EXPECT_NEAR(bendingOf(field), 32.0 * 32.0, 2.0);  // |curvature|^2 is 1 everywhere
  EXPECT_NEAR(bendingOf(plane), 0.0, 0.05);
}

TEST(PlanarJacobian, IsExactForABilinearFieldAtItsWorstCorner) {
  // u_x = 0.5 x y / 16 per pixel of 1 mm: du_x/dx = y / 32 smallest at y = 0, and -0.9 y in y folds nothing but squeezes to 0.1.
  std::vector<float> ux, uy;
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 17; ++x) {
      ux.push_back(static_cast<float>(x * y / 32.0));
      uy.push_back(static_cast<float>(-0.9 * y));
    }
  }
  EXPECT_NEAR(smallestJacobian(ux, uy, 17, 17, 1.0, 1.0), 0.1, 1e-5);
}

TEST(RegisterElastic2d, FindsABendOfSharedSpeckleToAFifthOfAPixel) {
  const Pattern pattern(11, 1.1, 30.0, 30.0);
  const Motion truth = warp(4.0, kExtent_mm);
  const auto found = registered(pairOf(kSide, kPixel_mm, pattern, pattern, truth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(meanError_mm(found->displacement_mm, kSide, kPixel_mm, truth), 0.1);
  EXPECT_GT(found->smallestJacobian, 0.1);
  EXPECT_GT(found->speckleCorrelation, 0.8);
  EXPECT_GT(found->correlationAfter, found->correlationBefore + 0.2);
}

TEST(RegisterElastic2d, IsIndifferentToGainAndDepthGain) {
  const Pattern pattern(12, 1.1, 24.0, 24.0);
  const Motion truth = warp(3.0, kExtent_mm);
  const auto changed = [](double v, glm::dvec2 p) { return 0.7 * v + 30.0 + 0.5 * p.y; };
  const auto found = registered(pairOf(kSide, kPixel_mm, pattern, pattern, truth, changed));
  ASSERT_TRUE(found);
  EXPECT_LT(meanError_mm(found->displacement_mm, kSide, kPixel_mm, truth), 0.08);
}

TEST(RegisterElastic2d, FailsOnALargeBendInOneResolutionWhereThePyramidSucceeds) {
  const Pattern pattern(13, 1.1, 30.0, 30.0);
  const Motion truth = warp(6.0, kExtent_mm);
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, truth);
  const auto pyramid = registered(pair);
  const auto single = registered(pair, {.singleResolution = true});
  ASSERT_TRUE(pyramid && single);
  EXPECT_LT(meanError_mm(pyramid->displacement_mm, kSide, kPixel_mm, truth), 0.15);
  EXPECT_GT(meanError_mm(single->displacement_mm, kSide, kPixel_mm, truth), 0.5);
  EXPECT_GT(pyramid->correlationAfter, single->correlationAfter + 0.1);
}

TEST(RegisterElastic2d, ReportsTheCorrelationAfterEachFactorOfThePaper) {
  const Pattern pattern(14, 1.1, 30.0, 30.0);
  std::vector<Level> seen;
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, warp(4.0, kExtent_mm));
  const auto found = registerElastic2d(viewOf(pair.fixed), viewOf(pair.moving), glm::dvec2(kPixel_mm), {.factors = {48.0, 24.0, 6.0}},
                                       noProgress(), [&](const Level& level) { seen.push_back(level); });
  ASSERT_TRUE(found);
  ASSERT_EQ(found->levels.size(), 3U);
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_NEAR(found->levels[0].node_mm, 24.0, 4.1);  // made to fill 80 mm
  EXPECT_NEAR(found->levels[2].node_mm, 3.0, 0.1);
  EXPECT_EQ(found->levels[0].correlationBefore, found->correlationBefore);
  EXPECT_EQ(found->levels[2].correlationAfter, found->correlationAfter);
  EXPECT_LT(found->levels[0].correlationAfter, found->levels[2].correlationAfter);
}

TEST(RegisterElastic2d, FindsACommonShiftBeyondWhatGradientsReach) {
  const Pattern pattern(15, 1.1, 30.0, 30.0);
  const Motion truth = [](glm::dvec2) { return glm::dvec2(9.0, -6.5); };
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, truth);
  const auto found = registered(pair);
  ASSERT_TRUE(found);
  EXPECT_LT(meanError_mm(found->displacement_mm, kSide, kPixel_mm, truth), 0.05);
}

TEST(RegisterElastic2d, GivesTheSameBitsForEveryNumberOfThreads) {
  const Pattern pattern(16, 1.1, 30.0, 30.0);
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, warp(4.0, kExtent_mm));
  const auto one = registered(pair, {.threads = 1});
  ASSERT_TRUE(one);
  for (const int threads : {2, 8}) {
    const auto more = registered(pair, {.threads = threads});
    ASSERT_TRUE(more);
    ASSERT_EQ(one->displacement_mm.size(), more->displacement_mm.size());
    EXPECT_EQ(0, std::memcmp(one->displacement_mm.data(), more->displacement_mm.data(), one->displacement_mm.size() * sizeof(glm::vec2)));
  }
}

class Impatient final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

TEST(RegisterElastic2d, StopsWhenAskedTo) {
  const Pattern pattern(17, 1.1, 30.0, 30.0);
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, warp(2.0, kExtent_mm));
  Impatient impatient;
  const auto found = registerElastic2d(viewOf(pair.fixed), viewOf(pair.moving), glm::dvec2(kPixel_mm), {}, impatient);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST(RegisterElastic2d, ReportsProgressThatNeverMovesBackwardsAndEndsAtTheWhole) {
  const Pattern pattern(17, 1.1, 30.0, 30.0), other(18, 1.1, 30.0, 30.0);
  for (const Pattern* seen : {&pattern, &other}) {
    const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, *seen, warp(2.0, kExtent_mm));
    RisingProgress progress;
    ASSERT_TRUE(registerElastic2d(viewOf(pair.fixed), viewOf(pair.moving), glm::dvec2(kPixel_mm), {}, progress));
    EXPECT_EQ(progress.backwards(), 0);
    EXPECT_GT(progress.reports(), 3);
    EXPECT_EQ(progress.last(), 1.0);
  }
}

TEST(RegisterElastic2d, RefusesWhatCannotBeAnImageOrAnOption) {
  const GreyImage image(8, 8, 100), empty;
  const auto code = [&](const GreyImage& a, glm::dvec2 pixel, const Elastic2dOptions& options) {
    const auto found = registerElastic2d(viewOf(a), viewOf(image), pixel, options, noProgress());
    return found ? ErrorCode::internal : found.error().code;
  };
  EXPECT_EQ(code(empty, glm::dvec2(0.4), {}), ErrorCode::emptyVolume);
  EXPECT_EQ(code(image, glm::dvec2(0.0, 0.4), {}), ErrorCode::badField);
  EXPECT_EQ(code(image, glm::dvec2(0.4), {.factors = {48.0, 1.0}}), ErrorCode::badField);
  EXPECT_EQ(code(image, glm::dvec2(0.4), {.stiffness = -1.0}), ErrorCode::badField);
  EXPECT_EQ(code(image, glm::dvec2(0.4), {.iterations = 0}), ErrorCode::badField);
}

}  // namespace
}  // namespace elastic2d_test
