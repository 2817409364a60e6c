#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vtkCubeSource.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <limits>
#include <thread>

#include "bridge/meshes.h"
#include "ew/bridge/mesh_skin.h"

namespace ew::bridge::skin_test {
namespace {

constexpr double kRadius_mm = 120.0;

std::shared_ptr<const Skin> sphere() {
  static const auto skin = makeMeshSkin(test::sphereMesh(kRadius_mm));
  return skin;
}

double between(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) / 1e6; }

RC_GTEST_PROP(MeshSkin, NearestOnASphereIsTheRadialPoint, ()) {
  const glm::dvec3 direction(between(-1, 1), between(-1, 1), between(-1, 1));
  RC_PRE(glm::length(direction) > 0.1);
  const glm::dvec3 outward = glm::normalize(direction);
  const auto contact = sphere()->nearest(between(0.5, 20.0) * kRadius_mm * outward);
  // 96 x 96 facets leave the sphere by at most R (1 - cos(pi / 96)) = 0.07 mm.
  RC_ASSERT(std::abs(glm::length(contact.point_mm) - kRadius_mm) < 0.15);
  RC_ASSERT(glm::distance(contact.point_mm, kRadius_mm * outward) < 5.0);
  RC_ASSERT(std::abs(glm::length(contact.outward) - 1.0) < 1e-9);
  RC_ASSERT(glm::dot(contact.outward, glm::normalize(contact.point_mm)) > std::cos(0.02));
}

RC_GTEST_PROP(MeshSkin, NearestIsTheLeastDistanceToAnyTriangle, ()) {
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(200.0);
  cube->SetYLength(100.0);
  cube->SetZLength(60.0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  static const auto skin = makeMeshSkin(triangles->GetOutput());
  const glm::dvec3 half(100.0, 50.0, 30.0);
  const glm::dvec3 p(between(-400, 400), between(-400, 400), between(-400, 400));
  glm::dvec3 expected = glm::clamp(p, -half, half);
  if (expected == p) {
    const glm::dvec3 toFace = half - glm::abs(p);
    const int axis = toFace.x <= toFace.y && toFace.x <= toFace.z ? 0 : toFace.y <= toFace.z ? 1 : 2;
    expected[axis] = std::copysign(half[axis], p[axis]);
  }
  const auto contact = skin->nearest(p);
  RC_ASSERT(std::abs(glm::distance(contact.point_mm, p) - glm::distance(expected, p)) < 1e-3);
}

TEST(MeshSkin, ARayHitsTheNearSideAndMissesBesideTheBody) {
  const auto hit = sphere()->hit({0.0, -5000.0, 0.0}, {0.0, 7.0, 0.0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point_mm.y, -kRadius_mm, 0.1);
  EXPECT_LT(hit->outward.y, -0.999);
  EXPECT_FALSE(sphere()->hit({0.0, -5000.0, 0.0}, {0.0, -1.0, 0.0})) << "the other way";
  EXPECT_FALSE(sphere()->hit({kRadius_mm + 1.0, -5000.0, 0.0}, {0.0, 1.0, 0.0})) << "beside";
  const auto fromInside = sphere()->hit({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  ASSERT_TRUE(fromInside);
  EXPECT_NEAR(fromInside->point_mm.y, kRadius_mm, 0.1);
}

TEST(MeshSkin, SlidingAlongAMeshedSphereFollowsItsArcAndKeepsContact) {
  Hold hold;
  hold.contact = *sphere()->hit({20.0, -5000.0, 10.0}, {0.0, 1.0, 0.0});
  const Hold moved = slid(hold, *sphere(), 10.0, 0.0);
  const double arc_mm = kRadius_mm * std::acos(glm::dot(glm::normalize(hold.contact.point_mm), glm::normalize(moved.contact.point_mm)));
  EXPECT_NEAR(arc_mm, 10.0, 0.2);
  EXPECT_LT(glm::distance(sphere()->nearest(moved.contact.point_mm).point_mm, moved.contact.point_mm), 1e-6);
}

TEST(MeshSkin, NormalsTurnSmoothlyOverTheEdgeOfACube) {
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(200.0);
  cube->SetYLength(200.0);
  cube->SetZLength(200.0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  const auto skin = makeMeshSkin(triangles->GetOutput());
  Hold hold;
  hold.contact = skin->nearest({60.0, -150.0, 0.0});
  hold.lateralHint = {1.0, 0.0, 0.0};
  double largest_rad = 0.0;
  for (int i = 0; i < 80; ++i) {
    const Hold next = slid(hold, *skin, 1.0, 0.0);
    largest_rad = std::max(largest_rad, std::acos(std::clamp(glm::dot(hold.contact.outward, next.contact.outward), -1.0, 1.0)));
    hold = next;
  }
  EXPECT_GT(hold.contact.outward.x, 0.99) << "now on the side";
  EXPECT_LT(largest_rad, glm::radians(15.0)) << "a face normal would jump by 90 degrees";
}

TEST(MeshSkin, SeveralThreadsReadTheSameAnswers) {
  const auto ask = [](std::vector<glm::dvec3>& answers) {
    for (int i = 0; i < 400; ++i) {
      const double angle = 0.05 * i;
      const auto contact = sphere()->nearest({200.0 * std::cos(angle), 180.0 * std::sin(angle), 3.0 * i - 400.0});
      answers.push_back(contact.point_mm);
      answers.push_back(contact.outward);
    }
  };
  std::vector<std::vector<glm::dvec3>> all(4);
  std::vector<std::thread> threads;
  for (auto& answers : all) threads.emplace_back([&answers, &ask] { ask(answers); });
  for (auto& thread : threads) thread.join();
  for (const auto& answers : all) EXPECT_EQ(answers, all.front());
}

}  // namespace
}  // namespace ew::bridge::skin_test
