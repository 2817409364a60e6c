#include "ew/registration/deformation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <atomic>
#include <random>

#include "registration/fields.h"

namespace ew::deformation_test {
namespace {

using namespace registration;
using test::affineField;
using test::obliqueGrid;
using test::uprightGrid;
using test::wavyField;

class Cancelled final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

Transform<frame::Moving, frame::Fixed> turned(double angle_rad, const glm::dvec3& shift_mm) {
  glm::dmat4 m(1.0);
  m[0] = glm::dvec4(std::cos(angle_rad), std::sin(angle_rad), 0.0, 0.0);
  m[1] = glm::dvec4(-std::sin(angle_rad), std::cos(angle_rad), 0.0, 0.0);
  m[3] = glm::dvec4(shift_mm, 1.0);
  return {m};
}

const glm::dmat3 kShear(glm::dvec3(0.10, 0.02, -0.03), glm::dvec3(-0.05, 0.08, 0.01), glm::dvec3(0.04, -0.02, -0.06));

TEST(DisplacementAt, IsExactForAffineFieldsOnObliqueLattices) {
  const Grid nodes = obliqueGrid({5, 4, 6}, 9.0);
  const ControlGrid control = affineField(nodes, kShear, {1.0, -2.0, 3.0});
  const auto toWorld = nodes.voxelToWorld();
  rc::check("inside the lattice", [&] {
    const auto share = [](int last) { return last * (*rc::gen::inRange(0, 10001)) / 10000.0; };
    const glm::dvec3 p = (toWorld * Point<frame::Voxel>{glm::dvec3(share(4), share(3), share(5))}).at;
    RC_ASSERT(glm::distance(displacementAt(control, p), kShear * p + glm::dvec3(1.0, -2.0, 3.0)) < 1e-5);
  });
}

TEST(DisplacementAt, IsThatOfTheNearestPointOutsideTheLattice) {
  const ControlGrid control = wavyField(uprightGrid({4, 4, 4}, 10.0), 3.0, 35.0);
  const glm::dvec3 beyond = displacementAt(control, {-50.0, 12.0, 90.0});
  EXPECT_LT(glm::distance(beyond, displacementAt(control, {0.0, 12.0, 30.0})), 1e-12);
}

TEST(DisplacementAt, IsNothingWithoutNodesAndConstantAlongAnAxisWithOneNode) {
  EXPECT_EQ(displacementAt(ControlGrid{}, {1.0, 2.0, 3.0}), glm::dvec3(0.0));
  const ControlGrid flat = wavyField(uprightGrid({4, 4, 1}, 10.0), 3.0, 35.0);
  EXPECT_EQ(displacementAt(flat, {11.0, 12.0, -8.0}), displacementAt(flat, {11.0, 12.0, 500.0}));
}

TEST(Displace, MovesEachPointByItsDisplacement) {
  const ControlGrid control = wavyField(uprightGrid({4, 4, 4}, 10.0), 3.0, 35.0);
  std::vector<glm::dvec3> points;
  for (int n = 0; n < 50; ++n) points.emplace_back(n, 40.0 - n, 0.5 * n);
  std::vector<glm::dvec3> moved = points;
  displace(control, moved);
  for (std::size_t n = 0; n < points.size(); ++n) EXPECT_EQ(moved[n], points[n] + displacementAt(control, points[n]));
  moved = points;
  displace(ControlGrid{}, moved);
  EXPECT_EQ(moved, points);
}

TEST(MovingPoint, WarpsFirstAndTurnsThen) {
  const Deformation deformation{turned(0.5, {10.0, 0.0, -4.0}),
                                affineField(uprightGrid({3, 3, 3}, 20.0), glm::dmat3(0.0), {1.0, 2.0, 3.0})};
  const glm::dvec3 expected = carried(deformation.rigid, {6.0, 8.0, 10.0});
  EXPECT_LT(glm::distance(movingPoint(deformation, {5.0, 6.0, 7.0}), expected), 1e-12);
}

TEST(FieldOf, EqualsMovingPointAtEveryVoxelWhetherTheAxesMatchOrNot) {
  const Deformation deformation{turned(-0.3, {4.0, 5.0, 6.0}), wavyField(uprightGrid({5, 4, 3}, 11.0), 2.5, 30.0)};
  Grid matching = uprightGrid({17, 13, 11}, 3.1);
  matching.origin_mm = glm::dvec3(-4.0, 2.0, 1.0);  // reaches beyond the lattice on both sides
  for (const Grid& grid : {matching, obliqueGrid({17, 13, 11}, 2.0)}) {
    const auto field = fieldOf(deformation, grid, 2, noProgress());
    ASSERT_TRUE(field);
    const auto toWorld = grid.voxelToWorld();
    double worst = 0.0;
    for (int k = 0; k < grid.dims.z; ++k) {
      for (int j = 0; j < grid.dims.y; ++j) {
        for (int i = 0; i < grid.dims.x; ++i) {
          const glm::dvec3 p = (toWorld * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
          worst =
              std::max(worst, glm::distance(p + glm::dvec3(field->displacement_mm[grid.indexOf(i, j, k)]), movingPoint(deformation, p)));
        }
      }
    }
    EXPECT_LT(worst, 2e-5);
  }
}

TEST(FieldOf, IsTheSameWithOneTwoAndEightThreadsAndStopsWhenAsked) {
  const Deformation deformation{turned(0.1, {}), wavyField(uprightGrid({5, 4, 3}, 11.0), 2.5, 30.0)};
  const Grid grid = uprightGrid({20, 20, 20}, 2.0);
  const auto one = fieldOf(deformation, grid, 1, noProgress());
  ASSERT_TRUE(one);
  for (int threads : {2, 8}) EXPECT_EQ(fieldOf(deformation, grid, threads, noProgress())->displacement_mm, one->displacement_mm);
  Cancelled cancelled;
  const auto stopped = fieldOf(deformation, grid, 2, cancelled);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(JacobianOf, IsTheDeterminantOfAnAffineFieldEverywhere) {
  const ControlGrid control = affineField(obliqueGrid({4, 3, 5}, 8.0), kShear, {});
  const JacobianSummary jacobian = jacobianOf(control);
  const double expected = glm::determinant(glm::dmat3(1.0) + kShear);
  EXPECT_NEAR(jacobian.smallest, expected, 1e-5);
  EXPECT_NEAR(jacobian.largest, expected, 1e-5);
  EXPECT_EQ(jacobian.folded, 0U);
}

TEST(JacobianOf, FindsNoSmallerValueByLookingDensely) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-3.0F, 3.0F);
  for (int round = 0; round < 20; ++round) {
    ControlGrid control{uprightGrid({2, 2, 2}, 8.0), std::vector<glm::vec3>(8)};
    for (glm::vec3& u : control.displacement_mm) u = {any(random), any(random), any(random)};
    const JacobianSummary jacobian = jacobianOf(control);
    double smallest = 1e9, largest = -1e9;
    constexpr int kLooks = 40;
    const auto cornerAt = [&](int i, int j, int k) { return glm::dvec3(control.displacement_mm[control.nodes.indexOf(i, j, k)]); };
    for (int n = 0; n < (kLooks + 1) * (kLooks + 1) * (kLooks + 1); ++n) {
      const double x = n % (kLooks + 1) / double{kLooks}, y = n / (kLooks + 1) % (kLooks + 1) / double{kLooks},
                   z = n / ((kLooks + 1) * (kLooks + 1)) / double{kLooks};
      glm::dmat3 j(1.0);
      for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
          const double wx = (a ? y : 1 - y) * (b ? z : 1 - z), wy = (a ? x : 1 - x) * (b ? z : 1 - z),
                       wz = (a ? x : 1 - x) * (b ? y : 1 - y);
          j[0] += wx * (cornerAt(1, a, b) - cornerAt(0, a, b)) / 8.0;
          j[1] += wy * (cornerAt(a, 1, b) - cornerAt(a, 0, b)) / 8.0;
          j[2] += wz * (cornerAt(a, b, 1) - cornerAt(a, b, 0)) / 8.0;
        }
      }
      smallest = std::min(smallest, glm::determinant(j));
      largest = std::max(largest, glm::determinant(j));
    }
    EXPECT_LE(jacobian.smallest, smallest + 1e-6);
    EXPECT_GE(jacobian.largest, largest - 1e-6);
    EXPECT_NEAR(jacobian.smallest, smallest, 2e-3);
    EXPECT_NEAR(jacobian.largest, largest, 2e-3);
  }
}

TEST(JacobianOf, FindsAFoldThatNoCornerShows) {
  // Two opposite edges are turned against each other by half a turn: upright at the corners, flat in the middle of the cell.
  ControlGrid control{uprightGrid({2, 2, 2}, 10.0), std::vector<glm::vec3>(8, glm::vec3(0.0F))};
  const auto place = [&](int i, int j, int k, const glm::dvec3& p) {
    control.displacement_mm[control.nodes.indexOf(i, j, k)] = glm::vec3(p - 10.0 * glm::dvec3(i, j, k));
  };
  for (int k = 0; k < 2; ++k) {
    const double angle = (k == 0 ? -1.0 : 1.0) * 1.15 * 3.14159265358979 / 2.0;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const double x = 10.0 * i - 5.0, y = 10.0 * j - 5.0;
        place(i, j, k, {5.0 + std::cos(angle) * x - std::sin(angle) * y, 5.0 + std::sin(angle) * x + std::cos(angle) * y, 10.0 * k});
      }
    }
  }
  const JacobianSummary jacobian = jacobianOf(control);
  EXPECT_NEAR(jacobian.largest, 1.0, 1e-6);  // at the corners
  EXPECT_LT(jacobian.smallest, 0.06);        // (cos 103.5 degrees)^2
  EXPECT_GE(jacobian.smallest, 0.0);
}

TEST(JacobianOf, CountsTheCellsThatFold) {
  ControlGrid control{uprightGrid({4, 3, 3}, 5.0), std::vector<glm::vec3>(36, glm::vec3(0.0F))};
  EXPECT_EQ(jacobianOf(control).folded, 0U);
  control.displacement_mm[control.nodes.indexOf(0, 1, 1)] = {6.0F, 0.0F, 0.0F};  // beyond its neighbour at 5 mm
  const JacobianSummary jacobian = jacobianOf(control);
  EXPECT_EQ(jacobian.folded, 4U);
  EXPECT_NEAR(jacobian.smallest, -0.2, 1e-6);
}

TEST(JacobianOf, AgreesBetweenNodesAndVoxelsOfASmoothField) {
  const Deformation deformation{turned(0.7, {3.0, 2.0, 1.0}), wavyField(uprightGrid({11, 11, 11}, 4.0), 2.0, 40.0)};
  const JacobianSummary nodes = jacobianOf(deformation.control);
  const auto field = fieldOf(deformation, uprightGrid({81, 81, 81}, 0.5), 0, noProgress());
  ASSERT_TRUE(field);
  const JacobianSummary voxels = jacobianOf(*field);
  EXPECT_NEAR(voxels.smallest, nodes.smallest, 0.01);  // the rigid part does not change it
  EXPECT_NEAR(voxels.largest, nodes.largest, 0.01);
  EXPECT_EQ(voxels.folded, 0U);
}

Volume ramp(const Grid& grid) {
  Volume volume{grid, {}, {}};
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      for (int i = 0; i < grid.dims.x; ++i) volume.echo.push_back(static_cast<std::uint8_t>(10 + 2 * i + 4 * j + 6 * k));
    }
  }
  return volume;
}

TEST(Warped, ReturnsTheVolumeItselfWhenNothingMoves) {
  Volume volume = ramp(obliqueGrid({12, 9, 7}, 1.5));
  volume.coverage.assign(volume.echo.size(), 2);
  volume.coverage[100] = 0;
  volume.echo[100] = 0;
  volume.coverage[300] = 1;
  const auto same = warped(volume, {}, volume.grid, 2, noProgress());
  ASSERT_TRUE(same);
  EXPECT_EQ(*same, volume);
}

TEST(Warped, KeepsARampExactAndMarksWhatLiesOutside) {
  const Volume volume = ramp(uprightGrid({12, 9, 7}, 2.0));
  const Deformation deformation{{},
                                affineField(uprightGrid({2, 2, 2}, 100.0), glm::dmat3(0.0), {1.0, 2.0, 0.0})};  // half a voxel, one voxel
  const auto moved = warped(volume, deformation, volume.grid, 1, noProgress());
  ASSERT_TRUE(moved);
  for (int k = 0; k < 7; ++k) {
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < 12; ++i) {
        const std::size_t index = volume.grid.indexOf(i, j, k);
        const bool inside = i + 0.5 <= 11 && j + 1 <= 8;
        ASSERT_EQ(moved->coverage[index], inside ? 2 : 0);
        ASSERT_EQ(moved->echo[index], inside ? volume.echo[index] + 1 + 4 : 0);
      }
    }
  }
}

TEST(Warped, AcceptsASingleLayerOfVoxelsAndRefusesVolumesThatContradictThemselves) {
  const Volume layer = ramp(uprightGrid({8, 8, 1}, 2.0));
  const auto same = warped(layer, {}, layer.grid, 1, noProgress());
  ASSERT_TRUE(same);
  EXPECT_EQ(same->echo, layer.echo);
  Volume broken = layer;
  broken.echo.pop_back();
  EXPECT_EQ(warped(broken, {}, layer.grid, 1, noProgress()).error().code, ErrorCode::badField);
  Grid empty = layer.grid;
  empty.dims.x = 0;
  EXPECT_EQ(warped(layer, {}, empty, 1, noProgress()).error().code, ErrorCode::emptyVolume);
}

}  // namespace
}  // namespace ew::deformation_test
