#include "ew/phantom/contact_pressure.h"
#include "places.h"

#include <gtest/gtest.h>
// gtest before rapidcheck: its header relies on it
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace ew::contact_pressure_test {
namespace {

Probe probeNamed(const std::string& id) { return readProbe(std::string(EW_SOURCE_DIR) + "/resources/probes/" + id + ".json").value(); }

const std::vector<Probe>& shippedProbes() {
  static const auto probes = readProbes(std::string(EW_SOURCE_DIR) + "/resources/probes").value();
  return probes;
}

Transform<frame::World, frame::Probe> somePose() {
  Transform<frame::World, frame::Probe> pose;
  pose.matrix = glm::dmat4({0.36, 0.48, -0.8, 0}, {-0.8, 0.6, 0, 0}, {0.48, 0.64, 0.6, 0}, {10, -20, 30, 1});
  return pose;
}

double number(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 100001) / 100000.0); }

struct Press {
  Probe probe;
  double indentation_mm;
  glm::dvec3 p_probe_mm;
};
Press anyPress() {
  const Probe& probe = shippedProbes()[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(shippedProbes().size())))];
  const double indentation_mm = number(0.01, 1.0) * deepestIndentation_mm(probe);
  return {probe, indentation_mm, {number(-60, 60), number(-40, 150), number(-40, 40)}};
}

RC_GTEST_PROP(ContactPressure, IsOneToOneWithAnInverse, ()) {
  const Press press = anyPress();
  // Over a plane, or over skin that falls away somewhere, as under a leaning face.
  std::vector<double> gaps_mm;
  if (*rc::gen::arbitrary<bool>()) {
    const double slope = number(-2, 2), sag_mm = number(0, 20);
    for (int n = 0; n < 33; ++n) gaps_mm.push_back(std::max(0.0, slope * n + sag_mm * (n / 16.0 - 1.0) * (n / 16.0 - 1.0)));
  }
  const ContactPressure pressure(press.probe, somePose(), press.indentation_mm, gaps_mm);
  const glm::dvec3 rest = (somePose() * Point<frame::Probe>{press.p_probe_mm}).at;
  const glm::dvec3 moved = pressure.moved(rest);
  RC_ASSERT(glm::distance(pressure.rest(moved), rest) < 0.01);
  RC_ASSERT(glm::distance(pressure.moved(pressure.rest(rest)), rest) < 0.01);
  RC_ASSERT(glm::distance(moved, rest) <= pressure.reach_mm() + 1e-9);
  glm::dmat3 jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = 1e-3;
    jacobian[axis] = (pressure.moved(rest + step) - pressure.moved(rest - step)) / 2e-3;
  }
  RC_ASSERT(glm::determinant(jacobian) > 0.19);
}

TEST(ContactPressure, TakesTheSkinUnderTheFaceWithIt) {
  for (const Probe& probe : shippedProbes()) {
    const double indentation_mm = std::min(4.0, deepestIndentation_mm(probe));
    const ContactPressure pressure(probe, somePose(), indentation_mm);
    const auto movedTo = [&](double x_mm, double z_mm) {
      const auto rest = somePose() * Point<frame::Probe>{{x_mm, -indentation_mm, z_mm}};
      return (inverse(somePose()) * Point<frame::World>{pressure.moved(rest.at)}).at;
    };
    EXPECT_NEAR(glm::length(movedTo(0, 0)), 0.0, 1e-9) << probe.id;
    const bool straight = faceSagitta_mm(probe) == 0.0;
    if (straight) {
      EXPECT_NEAR(movedTo(0.45 * probe.width_mm, 0).y, 0.0, 1e-9) << probe.id;
    } else {
      // A curved face: half way to where it leaves the skin, the skin lies on it.
      const double half_mm = 0.5 * std::sqrt(2.0 * probe.radius_mm * indentation_mm);
      if (half_mm > faceHalfWidth_mm(probe)) continue;
      const double face_y = std::sqrt(probe.radius_mm * probe.radius_mm - half_mm * half_mm) - probe.radius_mm;
      EXPECT_NEAR(movedTo(half_mm, 0).y, face_y, 0.02 * indentation_mm) << probe.id;
    }
    EXPECT_NEAR(movedTo(faceHalfWidth_mm(probe) + 30, 0).y, -indentation_mm, 0.01) << probe.id;
  }
}

TEST(ContactPressure, OverSkinThatFallsAwayTheFacePushesWhereItTouches) {
  // A straight face that leans: its -x end touches first, and at +x the skin stays 12 mm away.
  const Probe probe = probeNamed("linear-12");
  std::vector<double> gaps_mm;
  for (int n = 0; n < 33; ++n) gaps_mm.push_back(12.0 * n / 32.0);
  const ContactPressure pressure(probe, {}, 6.0, gaps_mm);
  const auto movedSkin = [&](double x_mm) {
    const double rest_y = -6.0 + 12.0 * (x_mm / probe.width_mm + 0.5);
    return pressure.moved({x_mm, rest_y, 0}).y - rest_y;
  };
  EXPECT_NEAR(movedSkin(-0.5 * probe.width_mm), 6.0, 1e-6);
  EXPECT_NEAR(movedSkin(-0.25 * probe.width_mm), 3.0, 0.05);
  EXPECT_NEAR(movedSkin(0.25 * probe.width_mm), 0.0, 0.05);
}

TEST(ContactPressure, FadesWithDepthAsUnderAPunch) {
  const Probe probe = probeNamed("linear-12");
  const ContactPressure pressure(probe, {}, 3.0);
  const double a = std::sqrt(0.5 * probe.width_mm * (0.5 * probe.elevationalAperture_mm + 2.0));
  double before = 3.0;
  for (double depth = 1.0; depth < 60.0; depth += 1.0) {
    const double push = pressure.moved({0, depth - 3.0, 0}).y - (depth - 3.0);
    // Boussinesq's solution under the pressure P / (2 pi a sqrt(a^2 - r^2)), Poisson's ratio 1/2, integrated by the midpoint rule in the
    // angle t with r = a sin t, against the same at the surface.
    double sum = 0.0, whole = 0.0;
    constexpr int kSteps = 20000;
    for (int n = 0; n < kSteps; ++n) {
      const double r = a * std::sin((n + 0.5) / kSteps * std::numbers::pi / 2.0);
      const double rho = std::hypot(r, depth);
      sum += r * (1.0 / rho + depth * depth / (rho * rho * rho));
      whole += 1.0;  // at the surface: r (1 / r)
    }
    EXPECT_NEAR(push, 3.0 * sum / whole, 1e-3) << depth;
    EXPECT_LT(push, before);
    before = push;
  }
}

TEST(ContactPressure, WithoutIndentationLeavesTheBodyAtRest) {
  const ContactPressure pressure(probeNamed("convex-3.5"), somePose(), 0.0);
  EXPECT_EQ(pressure.moved({1, 2, 3}), glm::dvec3(1, 2, 3));
  EXPECT_EQ(pressure.rest({1, 2, 3}), glm::dvec3(1, 2, 3));
  EXPECT_EQ(pressure.reach_mm(), 0.0);
}

TEST(ContactPressure, GoesNoDeeperThanTissueCanBeSqueezed) {
  for (const Probe& probe : shippedProbes()) {
    EXPECT_GT(deepestIndentation_mm(probe), 5.0) << probe.id;
    EXPECT_LT(deepestIndentation_mm(probe), 80.0) << probe.id;
  }
}

}  // namespace
}  // namespace ew::contact_pressure_test
