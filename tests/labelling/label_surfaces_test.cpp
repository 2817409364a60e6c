#include "ew/labelling/label_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "counted_stop.h"
#include "ew/core/simd.h"
#include "labelling/mesh_checks.h"
#include "labelling/support.h"
#include "memory_in_use.h"

namespace ew::labelling::label_surfaces_test {
namespace {

using test::Crossings;
using test::emptyLabels;
using test::openEdgesOf;
using test::volumeOf;

constexpr LabelSurfaceOptions kStairs{.shortestWave_voxel = 0.0};

LabelSurfaces surfacesOf(const Volume& labels, const LabelSurfaceOptions& options = {}) {
  auto made = labelSurfaces(labels.view(), options, noProgress());
  EXPECT_TRUE(made) << made.error();
  return made ? *std::move(made) : LabelSurfaces{};
}

/// On the grid whose voxel (0, 0, 0) lies at (16, 16, 16), where Crossings is exact.
Volume exactLabels(const glm::ivec3& dims) {
  Volume labels = emptyLabels(dims, glm::dvec3(1.0));
  labels.grid.origin_mm = glm::dvec3(16.0);
  return labels;
}

void put(Volume& labels, const glm::ivec3& ijk, std::uint8_t label) { labels.echo[labels.grid.indexOf(ijk.x, ijk.y, ijk.z)] = label; }

Volume randomLabels(const glm::ivec3& dims, unsigned most, unsigned seed) {
  Volume labels = exactLabels(dims);
  std::mt19937 random(seed);
  for (auto& each : labels.echo) each = static_cast<std::uint8_t>(random() % (most + 1));
  return labels;
}

std::size_t trianglesBetween(const LabelSurfaces& surfaces, int a, int b) {
  return static_cast<std::size_t>(std::count_if(surfaces.sides.begin(), surfaces.sides.end(), [&](const LabelSides& each) {
    return std::minmax<int>(each.front, each.back) == std::minmax(a, b);
  }));
}

/// What every mesh promises.
void expectSound(const Volume& labels, const LabelSurfaces& surfaces) {
  ASSERT_EQ(surfaces.sides.size(), surfaces.triangles.size());
  for (const std::uint8_t label : surfaces.labels) {
    const SurfaceMesh mesh = meshOf(surfaces, label);
    EXPECT_EQ(openEdgesOf(mesh), 0) << int{label};
    EXPECT_GT(volumeOf(mesh), 0.0) << int{label};
  }
  const Crossings crossings(surfaces);
  ASSERT_TRUE(crossings.isExact());
  EXPECT_EQ(crossings.count(), 0) << labels.grid;
}

TEST(LabelSurfaces, OfOneVoxelAreABoxOfSixFaces) {
  Volume labels = exactLabels({3, 3, 3});
  put(labels, {1, 1, 1}, 5);
  const LabelSurfaces stairs = surfacesOf(labels, kStairs);
  EXPECT_EQ(stairs.points_mm.size(), 8u);
  EXPECT_EQ(stairs.triangles.size(), 12u);
  EXPECT_EQ(stairs.labels, std::vector<std::uint8_t>{5});
  for (const glm::vec3& p : stairs.points_mm)
    for (int n = 0; n < 3; ++n) EXPECT_EQ(std::abs(p[n] - 17.0F), 0.5F);
  EXPECT_EQ(volumeOf(meshOf(stairs, 5)), 1.0);
  const LabelSurfaces smooth = surfacesOf(labels);
  EXPECT_EQ(smooth.triangles.size(), 12u);
  EXPECT_LT(volumeOf(meshOf(smooth, 5)), 1.0);
  expectSound(labels, smooth);
}

TEST(LabelSurfaces, OfTwoTouchingBoxesShareOneSheet) {
  Volume labels = exactLabels({8, 6, 6});
  for (int k = 1; k < 5; ++k)
    for (int j = 1; j < 5; ++j)
      for (int i = 1; i < 7; ++i) put(labels, {i, j, k}, i < 4 ? 1 : 2);
  for (const LabelSurfaceOptions& options : {kStairs, LabelSurfaceOptions{}}) {
    const LabelSurfaces surfaces = surfacesOf(labels, options);
    EXPECT_EQ(trianglesBetween(surfaces, 1, 2), 2u * 16u);
    EXPECT_EQ(trianglesBetween(surfaces, 0, 1), 2u * (16u + 4u * 12u));
    EXPECT_EQ(trianglesBetween(surfaces, 0, 2), 2u * (16u + 4u * 12u));
    expectSound(labels, surfaces);
  }
  const LabelSurfaces stairs = surfacesOf(labels, kStairs);
  EXPECT_EQ(volumeOf(meshOf(stairs, 1)), 48.0);
  EXPECT_EQ(volumeOf(meshOf(stairs, 2)), 48.0);
}

TEST(LabelSurfaces, OfThreeLabelsMeetInALineAndOfFourInAPoint) {
  Volume line = exactLabels({6, 6, 6}), point = line;
  for (int k = 1; k < 5; ++k)
    for (int j = 1; j < 5; ++j)
      for (int i = 1; i < 5; ++i) {
        put(line, {i, j, k}, j < 3 ? 1 : i < 3 ? 2 : 3);
        put(point, {i, j, k}, k < 3 ? 4 : j < 3 ? 1 : i < 3 ? 2 : 3);
      }
  for (const Volume* labels : {&line, &point}) {
    const LabelSurfaces surfaces = surfacesOf(*labels);
    expectSound(*labels, surfaces);
    // The parts fill the whole.
    double sum = 0.0;
    const LabelSurfaces stairs = surfacesOf(*labels, kStairs);
    for (const std::uint8_t label : stairs.labels) sum += volumeOf(meshOf(stairs, label));
    EXPECT_EQ(sum, 64.0);
  }
  const LabelSurfaces surfaces = surfacesOf(line, kStairs);
  EXPECT_EQ(trianglesBetween(surfaces, 1, 2), 16u);
  EXPECT_EQ(trianglesBetween(surfaces, 1, 3), 16u);
  EXPECT_EQ(trianglesBetween(surfaces, 2, 3), 16u);
}

TEST(LabelSurfaces, HoldWhatTheVoxelsHoldWhereNothingIsSmoothed) {
  const Volume labels = randomLabels({9, 8, 7}, 3, 2);
  const LabelSurfaces surfaces = surfacesOf(labels, kStairs);
  for (const std::uint8_t label : surfaces.labels)
    EXPECT_NEAR(volumeOf(meshOf(surfaces, label)), static_cast<double>(voxelsOf(labels, label)), 1e-3);
}

TEST(LabelSurfaces, OfRandomLabelsAreClosedAndCrossNowhere) {
  bool someAreFanned = false;
  for (const unsigned most : {1u, 2u, 3u, 12u, 255u})
    for (const double wave : {0.0, 4.0, 8.0, 32.0}) {
      const Volume labels = randomLabels({11, 10, 9}, most, most + static_cast<unsigned>(wave));
      const LabelSurfaces surfaces = surfacesOf(labels, {.shortestWave_voxel = wave});
      expectSound(labels, surfaces);
      std::size_t faces = 0;
      const glm::ivec3 dims = labels.grid.dims;
      const auto at = [&](const glm::ivec3& p) { return labels.grid.contains(p) ? labels.echo[labels.grid.indexOf(p.x, p.y, p.z)] : 0; };
      for (int k = 0; k <= dims.z; ++k)
        for (int j = 0; j <= dims.y; ++j)
          for (int i = 0; i <= dims.x; ++i)
            for (int axis = 0; axis < 3; ++axis) {
              glm::ivec3 before(i, j, k);
              --before[axis];
              faces += at({i, j, k}) != at(before) ? 1 : 0;
            }
      EXPECT_GE(surfaces.triangles.size(), 2 * faces);
      someAreFanned = someAreFanned || surfaces.triangles.size() > 2 * faces;
    }
  EXPECT_TRUE(someAreFanned) << "faces that no diagonal cuts well must occur here";
}

/// Balls, a ring and nested ellipsoids that touch and cut one another: the first that holds a voxel has it.
Volume organs() {
  Volume labels = exactLabels({40, 38, 36});
  for (int k = 0; k < 36; ++k)
    for (int j = 0; j < 38; ++j)
      for (int i = 0; i < 40; ++i) {
        const glm::dvec3 p(i, j, k);
        const auto inside = [&](const glm::dvec3& at, const glm::dvec3& radii) { return glm::length((p - at) / radii) < 1.0; };
        const glm::dvec3 ring = p - glm::dvec3(22, 17, 15);
        std::uint8_t label = 0;
        if (std::hypot(std::hypot(ring.x, ring.y) - 9.0, ring.z) < 2.6)
          label = 1;
        else if (inside({14, 14, 18}, {3, 4, 5}))
          label = 2;
        else if (inside({14, 15, 18}, {9, 8, 9}))
          label = 3;
        else if (inside({25, 18, 20}, {6, 7, 8}))
          label = 4;
        else if (inside({20, 18, 18}, {19, 17, 16}))
          label = 5;
        put(labels, {i, j, k}, label);
      }
  return labels;
}

TEST(LabelSurfaces, OfOrgansAreClosedAndCrossNowhere) {
  const Volume labels = organs();
  for (const double wave : {4.0, 8.0, 20.0}) expectSound(labels, surfacesOf(labels, {.shortestWave_voxel = wave}));
}

TEST(LabelSurfaces, OfLabelsAtTheBorderCloseThere) {
  Volume labels = exactLabels({4, 5, 6});
  std::fill(labels.echo.begin(), labels.echo.end(), std::uint8_t{255});
  const LabelSurfaces surfaces = surfacesOf(labels);
  expectSound(labels, surfaces);
  EXPECT_EQ(surfaces.triangles.size(), 2u * 2u * (20u + 24u + 30u));
  EXPECT_EQ(volumeOf(meshOf(surfacesOf(labels, kStairs), 255)), 120.0);
  Volume one = exactLabels({1, 1, 1});
  one.echo[0] = 7;
  EXPECT_EQ(surfacesOf(one).triangles.size(), 12u);
}

TEST(LabelSurfaces, OfNothingAreNone) {
  Volume labels = exactLabels({5, 4, 3});
  const LabelSurfaces surfaces = surfacesOf(labels);
  EXPECT_EQ(surfaces, LabelSurfaces{});
  EXPECT_TRUE(meshOf(surfaces, 1).triangles.empty());
  EXPECT_TRUE(meshesOf(surfaces, 0, noProgress())->empty());
  labels.grid.dims = glm::ivec3(0, 4, 3);
  EXPECT_EQ(labelSurfaces(labels.view(), {}, noProgress()).error().code, ErrorCode::emptyVolume);
}

TEST(LabelSurfaces, AreTheSameOnEveryNumberOfThreads) {
  const Volume labels = organs();
  const LabelSurfaces one = surfacesOf(labels, {.threads = 1});
  for (const int threads : {2, 3, 7}) EXPECT_EQ(surfacesOf(labels, {.threads = threads}), one);
}

TEST(LabelSurfaces, AreTheSameOnEveryInstructionSet) {
  // Rows from shorter than a vector to longer than several words.
  for (const int width : {1, 2, 9, 17, 40, 64, 65, 66, 129, 200}) {
    const Volume labels = randomLabels({width, 3, 4}, 1, static_cast<unsigned>(width));
    ASSERT_TRUE(useSimd("scalar"));
    const LabelSurfaces plain = surfacesOf(labels);
    for (const char* word : {"sse4", "avx2", "avx3"}) {
      if (!useSimd(word)) continue;  // not on this processor
      EXPECT_EQ(surfacesOf(labels), plain) << word << " " << width;
    }
    ASSERT_TRUE(useSimd("best"));
    EXPECT_EQ(surfacesOf(labels), plain) << width;
  }
}

TEST(LabelSurfaces, LieTheSameInEveryGrid) {
  const Volume unit = organs();
  const LabelSurfaces plain = surfacesOf(unit);
  Volume oblique = unit;
  oblique.grid.spacing_mm = {0.4, 0.9, 1.7};
  oblique.grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.3, -0.5, 0.8)));
  Volume mirrored = oblique;
  mirrored.grid.directions[1] = -mirrored.grid.directions[1];
  const double voxel_mm3 = 0.4 * 0.9 * 1.7;
  for (const Volume* labels : {&oblique, &mirrored}) {
    const LabelSurfaces surfaces = surfacesOf(*labels);
    const auto toVoxel = labels->grid.worldToVoxel();
    const std::size_t shared = std::min(plain.points_mm.size(), surfaces.points_mm.size());  // fans come last
    ASSERT_GT(shared, 5000u);
    for (std::size_t n = 0; n < shared - 20; ++n)
      ASSERT_LT(glm::distance(carried(toVoxel, glm::dvec3(surfaces.points_mm[n])) + 16.0, glm::dvec3(plain.points_mm[n])), 1e-4);
    for (const std::uint8_t label : surfaces.labels) {
      const SurfaceMesh mesh = meshOf(surfaces, label);
      EXPECT_EQ(openEdgesOf(mesh), 0);
      const double whole = voxel_mm3 * volumeOf(meshOf(plain, label));
      EXPECT_NEAR(volumeOf(mesh), whole, 0.01 * whole);
    }
  }
}

struct Truth {
  std::function<double(const glm::dvec3&)> distance_mm;
  std::vector<glm::dvec3> points;  ///< on the surface
  double volume_mm3 = 0.0;
};

/// Points on the whole of a sphere, even enough.
std::vector<glm::dvec3> directions(int count) {
  std::vector<glm::dvec3> all;
  for (int n = 0; n < count; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / count, angle = n * test::kPi * (3.0 - std::sqrt(5.0)), r = std::sqrt(1.0 - z * z);
    all.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return all;
}

Truth sphere(const glm::dvec3& at, double radius) {
  Truth truth{[=](const glm::dvec3& p) { return glm::distance(p, at) - radius; }, {}, 4.0 / 3.0 * test::kPi * std::pow(radius, 3)};
  for (const glm::dvec3& d : directions(1500)) truth.points.push_back(at + radius * d);
  return truth;
}

Truth torus(const glm::dvec3& at, double ring, double tube) {
  Truth truth{[=](const glm::dvec3& p) { return std::hypot(std::hypot(p.x - at.x, p.y - at.y) - ring, p.z - at.z) - tube; },
              {},
              2.0 * test::kPi * test::kPi * ring * tube * tube};
  for (int a = 0; a < 60; ++a)
    for (int b = 0; b < 25; ++b) {
      const double u = 2.0 * test::kPi * a / 60.0, v = 2.0 * test::kPi * b / 25.0, r = ring + tube * std::cos(v);
      truth.points.push_back(at + glm::dvec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v)));
    }
  return truth;
}

/// To the nearest point q of an ellipsoid, q = r^2 p / (t + r^2), whose t is found by bisection.
double toEllipsoid(const glm::dvec3& p, const glm::dvec3& radii) {
  const glm::dvec3 r2 = radii * radii;
  double low = -std::min({r2.x, r2.y, r2.z}) + 1e-9, high = glm::length(radii * p) + 1.0;
  for (int n = 0; n < 60; ++n) {
    const double t = 0.5 * (low + high);
    (glm::length(radii * p / (t + r2)) > 1.0 ? low : high) = t;
  }
  const double away = glm::distance(p, r2 * p / (low + r2));
  return glm::length(p / radii) < 1.0 ? -away : away;
}

Truth ellipsoid(const glm::dvec3& at, const glm::dvec3& radii) {
  Truth truth{[=](const glm::dvec3& p) { return toEllipsoid(p - at, radii); }, {}, 4.0 / 3.0 * test::kPi * radii.x * radii.y * radii.z};
  for (const glm::dvec3& d : directions(1500)) truth.points.push_back(at + radii * d);
  return truth;
}

/// Both ways, points and middles of triangles standing for the mesh.
void expectNear(const SurfaceMesh& mesh, const Truth& truth, const std::string& name) {
  std::vector<glm::dvec3> ofMesh(mesh.points_mm.begin(), mesh.points_mm.end());
  for (const glm::ivec3& t : mesh.triangles)
    ofMesh.push_back((ofMesh[std::size_t(t.x)] + ofMesh[std::size_t(t.y)] + ofMesh[std::size_t(t.z)]) / 3.0);
  double farthest = 0.0, sum = 0.0, back = 0.0;
  for (const glm::dvec3& p : ofMesh) {
    const double away = std::abs(truth.distance_mm(p));
    farthest = std::max(farthest, away);
    sum += away;
  }
  for (const glm::dvec3& q : truth.points) {
    double nearest = 1e9;
    for (const glm::dvec3& p : ofMesh) nearest = std::min(nearest, glm::distance(p, q));
    back = std::max(back, nearest);
  }
  EXPECT_LT(farthest, 0.6) << name;
  EXPECT_LT(back, 0.8) << name;  // the distance to points is a little more than to triangles
  EXPECT_LT(sum / static_cast<double>(ofMesh.size()), 0.1) << name;
  EXPECT_NEAR(volumeOf(mesh), truth.volume_mm3, 0.02 * truth.volume_mm3) << name;
}

TEST(LabelSurfaces, LieWithinAVoxelOfTheShapesThatWereLabelled) {
  const glm::dvec3 at(20.3, 19.6, 20.1);
  const std::vector<std::pair<std::string, std::vector<Truth>>> scenes = {
      {"a ball", {sphere(at, 13.7)}},
      {"a small ball", {sphere(at, 5.2)}},
      {"a ring", {torus(at, 12.0, 4.6)}},
      {"nested ellipsoids", {ellipsoid(at, {6.1, 5.0, 8.2}), ellipsoid(at + 1.0, {11.0, 9.7, 12.4}), ellipsoid(at, {17.5, 16.0, 18.0})}}};
  for (const auto& [name, shapes] : scenes) {
    Volume labels = emptyLabels(glm::ivec3(41), glm::dvec3(1.0));
    labels.grid.origin_mm = glm::dvec3(0.0);
    for (int k = 0; k < 41; ++k)
      for (int j = 0; j < 41; ++j)
        for (int i = 0; i < 41; ++i)
          for (std::size_t n = shapes.size(); n-- > 0;)
            if (shapes[n].distance_mm({i, j, k}) < 0.0) put(labels, {i, j, k}, static_cast<std::uint8_t>(n + 1));
    LabelSurfaces surfaces = surfacesOf(labels);
    for (std::size_t n = 0; n < shapes.size(); ++n) {
      // A shape's own surface is the outer one: what lies in it belongs to it.
      LabelSurfaces outer = surfaces;
      for (LabelSides& each : outer.sides)
        for (std::uint8_t* side : {&each.front, &each.back})
          if (*side != 0) *side = *side <= n + 1 ? 1 : 2;
      std::size_t kept = 0;
      for (std::size_t t = 0; t < outer.sides.size(); ++t)
        if (outer.sides[t].front != outer.sides[t].back) {
          outer.triangles[kept] = outer.triangles[t];
          outer.sides[kept++] = outer.sides[t];
        }
      outer.triangles.resize(kept);
      outer.sides.resize(kept);
      expectNear(meshOf(outer, 1), shapes[n], name + " " + std::to_string(n));
    }
  }
}

TEST(LabelSurfaces, HaveNormalsThatLookOutOfTheirLabel) {
  Volume labels = emptyLabels(glm::ivec3(41), glm::dvec3(1.0));
  const glm::dvec3 middle(0.0);
  paintBall(labels, {&middle, 1}, 17.6, {.label = 2});
  paintBall(labels, {&middle, 1}, 11.7, {.label = 1});
  const LabelSurfaces surfaces = surfacesOf(labels);
  const auto meshes = meshesOf(surfaces, 0, noProgress());
  ASSERT_TRUE(meshes && meshes->size() == 2);
  for (std::size_t n = 0; n < meshes->front().normals.size(); ++n)
    EXPECT_GT(glm::dot(meshes->front().normals[n], glm::normalize(meshes->front().points_mm[n])), 0.97F);
  const SurfaceMesh& shell = meshes->back();
  for (std::size_t n = 0; n < shell.normals.size(); ++n) {
    const float outwards = glm::length(shell.points_mm[n]) > 15.0F ? 1.0F : -1.0F;
    EXPECT_GT(outwards * glm::dot(shell.normals[n], glm::normalize(shell.points_mm[n])), 0.97F);
  }
}

TEST(LabelSurfaces, StopSoonWhenCancelledAndSaySo) {
  const Volume labels = organs();
  auto counting = ew::test::CountedStop::never();
  ASSERT_TRUE(labelSurfaces(labels.view(), {}, counting));
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.99}) {
    auto stop = ew::test::CountedStop::atQuestion(std::max(1L, static_cast<long>(share * static_cast<double>(counting.questions()))));
    const auto made = labelSurfaces(labels.view(), {}, stop);
    ASSERT_FALSE(made) << share;
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
    EXPECT_LE(stop.questionsAfter(), ew::test::kMostQuestionsAfter);
    EXPECT_LE(stop.reportsAfter(), ew::test::kMostReportsAfter);
  }
  auto atOnce = ew::test::CountedStop::atQuestion(1);
  EXPECT_EQ(meshesOf(surfacesOf(labels), 0, atOnce).error().code, ErrorCode::cancelled);
}

TEST(LabelSurfaces, ReportWhatNeverMovesBackwards) {
  struct Rising final : Progress {
    double last = 0.0;
    bool rises = true;
    void report(const Message&, double fraction) override {
      rises = rises && fraction >= last && fraction <= 1.0 + 1e-9;
      last = fraction;
    }
    [[nodiscard]] bool cancelRequested() const override { return false; }
  } progress;
  ASSERT_TRUE(labelSurfaces(organs().view(), {.threads = 1}, progress));
  EXPECT_TRUE(progress.rises);
  EXPECT_NEAR(progress.last, 1.0, 1e-9);
}

TEST(LabelSurfaces, RefuseWhatTheyCannotDo) {
  const Volume labels = organs();
  const std::uint64_t forecast = labelSurfacesForecast_bytes(labels.view());
  EXPECT_EQ(labelSurfaces(labels.view(), {.maxBytes = forecast - 1}, noProgress()).error().code, ErrorCode::tooLarge);
  EXPECT_TRUE(labelSurfaces(labels.view(), {.maxBytes = forecast}, noProgress()));
  for (const double wave : {-1.0, 3.9, 33.0, std::nan("")})
    EXPECT_EQ(labelSurfaces(labels.view(), {.shortestWave_voxel = wave}, noProgress()).error().code, ErrorCode::badField);
}

TEST(LabelSurfaces, TakeNoMoreMemoryThanWasForecast) {
  struct Watching final : Progress {
    std::atomic<std::uint64_t> most{0};
    void report(const Message&, double) override { look(); }
    [[nodiscard]] bool cancelRequested() const override { return const_cast<Watching*>(this)->look(); }
    bool look() {
      most = std::max(most.load(), ew::test::memoryInUse_bytes());
      return false;
    }
  };
  Volume ball = emptyLabels(glm::ivec3(160), glm::dvec3(1.0));
  const glm::dvec3 middle(0.0);
  paintBall(ball, {&middle, 1}, 70.0, {.label = 2});
  const Volume noise = randomLabels(glm::ivec3(70), 3, 5);
  for (const Volume* labels : std::initializer_list<const Volume*>{&ball, &noise}) {
    Watching watching;
    const std::uint64_t before = ew::test::memoryInUse_bytes(), forecast = labelSurfacesForecast_bytes(labels->view());
    ASSERT_TRUE(labelSurfaces(labels->view(), {.threads = 1}, watching));
    EXPECT_LE(watching.most.load() - before, forecast + (1u << 20));
    EXPECT_GE(watching.most.load() - before, forecast / 3);
  }
}

}  // namespace
}  // namespace ew::labelling::label_surfaces_test
