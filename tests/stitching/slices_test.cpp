#include "logic/slices.h"

#include <gtest/gtest.h>
#include <cmath>
#include <optional>
#include <random>

#include "ew/stitching/places.h"

namespace ew::stitching::slices_test {
namespace {

/// echo = 2 i + 3 j + 5 k: linear, without symmetry, so every mistake of an axis shows.
Volume ramp() {
  Volume volume;
  volume.grid.dims = {12, 10, 8};
  volume.grid.spacing_mm = {1.0, 2.0, 0.5};
  volume.grid.origin_mm = {-5.0, 4.0, 7.0};
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) volume.echo.push_back(static_cast<std::uint8_t>(2 * i + 3 * j + 5 * k));
  return volume;
}

GreySlice two(std::uint8_t a, std::uint8_t b, bool aSeen = true, bool bSeen = true) {
  return {{2, 1}, {a, b}, {static_cast<std::uint8_t>(aSeen), static_cast<std::uint8_t>(bSeen)}};
}

/// Speckle with gaps, as a fan leaves them, and oblique.
Volume speckledFan(unsigned seed) {
  Volume volume;
  volume.grid.dims = {40, 35, 30};
  volume.grid.spacing_mm = {0.8, 1.0, 1.3};
  volume.grid.origin_mm = {-16.0, -17.0, -19.0};
  const Plane axes = turned(planeOf(Cut::axial, {}, 1.0), {}, {10, -20, 30});
  volume.grid.directions = glm::dmat3(axes.right, axes.down, axes.normal());
  std::mt19937 random(seed);
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 35; ++j)
      for (int i = 0; i < 40; ++i) {
        volume.coverage.push_back(std::abs(i - 20) > 8 + j / 2 || random() % 40 == 0 ? 0 : 1 + random() % 2);
        volume.echo.push_back(volume.coverage.back() == 0 ? 0 : static_cast<std::uint8_t>(random()));
      }
  return volume;
}

registration::ControlGrid wave() {
  registration::ControlGrid warp;
  warp.nodes.dims = {6, 5, 7};
  warp.nodes.spacing_mm = glm::dvec3(9.0);
  warp.nodes.origin_mm = {-20.0, -15.0, -30.0};
  for (std::size_t n = 0; n < warp.nodes.voxelCount(); ++n) {
    const auto at = static_cast<float>(n);
    warp.displacement_mm.emplace_back(3.0F * std::sin(at), 2.0F * std::cos(2.0F * at), 2.5F * std::sin(3.0F * at));
  }
  return warp;
}

/// One frame against another, shifted and rotated about the origin.
template <class To, class From>
Transform<To, From> moved(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  return renamed<To, From>(motionOf<frame::World>(shift_mm, rotation_deg, {}));
}

/// What the plane shows by the definition, point by point in double precision; none where nothing is seen.
std::optional<double> levelBehind(const Volume& volume, const glm::dvec3& p_mm) {
  const glm::dvec3 voxel = carried(volume.grid.worldToVoxel(), p_mm);
  const glm::dvec3 last(volume.grid.dims - 1);
  if (glm::any(glm::lessThan(voxel, glm::dvec3(0.0))) || glm::any(glm::greaterThan(voxel, last))) return {};
  const auto indexOf = [&](const glm::ivec3& ijk) { return volume.grid.indexOf(ijk.x, ijk.y, ijk.z); };
  if (volume.coverageAt(indexOf(glm::ivec3(glm::floor(voxel + 0.5)))) == Coverage::absent) return {};
  double sum = 0.0, present = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 at = glm::ivec3(glm::floor(voxel)) + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 near = 1.0 - glm::abs(voxel - glm::dvec3(at));
    const double share = near.x * near.y * near.z;
    if (share == 0.0 || volume.coverageAt(indexOf(at)) == Coverage::absent) continue;
    sum += share * volume.echo[indexOf(at)];
    present += share;
  }
  return sum / present;
}

TEST(Slices, PixelsAndPointsAreEachOthersInverse) {
  const Plane plane = turned(planeOf(Cut::coronal, {1, 2, 3}, 0.7), {4, 5, 6}, {20, -35, 50});
  const glm::ivec2 size{31, 20};
  const glm::dvec3 p = pointAt(plane, size, {3.5, 17.25});
  const glm::dvec2 back = pixelOf(plane, size, p);
  EXPECT_NEAR(back.x, 3.5, 1e-12);
  EXPECT_NEAR(back.y, 17.25, 1e-12);
  EXPECT_NEAR(distanceTo(plane, p + 2.5 * plane.normal()), 2.5, 1e-12);
}

TEST(Slices, APlaneTurnedAboutAPointOfItStillHoldsThatPoint) {
  Plane plane = planeOf(Cut::axial, {0, 0, 0}, 0.5);
  const glm::dvec3 pivot{3, -2, 0};
  for (int n = 0; n < 500; ++n) plane = turned(plane, pivot, {1.1, 0.7, 0.3});
  EXPECT_NEAR(distanceTo(plane, pivot), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(plane.right, plane.down), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(plane.right), 1.0, 1e-12);
}

TEST(Slices, VoxelCentresGiveTheirVoxelsAndNothingIsSeenOutside) {
  const Volume volume = ramp();
  // Pixels of 1 mm in the axial plane of layer 3: columns are voxels along i, every second row is a voxel along j.
  const Plane plane = planeOf(Cut::axial, {0.5, 13.0, 8.5}, 1.0);
  const GreySlice image = sliced(volume, plane, {14, 19}, {});
  for (int y = 0; y < 19; y += 2)
    for (int x = 0; x < 14; ++x) {
      const std::size_t at = static_cast<std::size_t>(y * 14 + x);
      const int i = x - 1;
      const bool inside = i >= 0 && i < 12;
      EXPECT_EQ(image.seen[at], inside ? 1 : 0) << x << ", " << y;
      EXPECT_EQ(image.grey[at], inside ? 2 * i + 3 * (y / 2) + 15 : 0) << x << ", " << y;
    }
}

TEST(Slices, ARampStaysARampInAnObliquePlane) {
  const Volume volume = ramp();
  const Plane plane = turned(planeOf(Cut::sagittal, {0.5, 13.0, 8.7}, 0.3), {0.5, 13.0, 8.7}, {25, 40, -15});
  const glm::ivec2 size{40, 40};
  const GreySlice image = sliced(volume, plane, size, {});
  int seen = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const std::size_t at = static_cast<std::size_t>(y * 40 + x);
      if (image.seen[at] == 0) continue;
      ++seen;
      const glm::dvec3 v = glm::dvec3(volume.grid.worldToVoxel().matrix * glm::dvec4(pointAt(plane, size, {x, y}), 1.0));
      EXPECT_EQ(image.grey[at], std::lround(2 * v.x + 3 * v.y + 5 * v.z));
    }
  EXPECT_GT(seen, 200);
}

TEST(Slices, AbsentVoxelsAreNotSeenAndDoNotDarkenTheirNeighbours) {
  Volume volume = ramp();
  std::fill(volume.echo.begin(), volume.echo.end(), std::uint8_t{100});
  volume.coverage.assign(volume.echo.size(), 2);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 6; ++i) {
        volume.coverage[volume.grid.indexOf(i, j, k)] = 0;
        volume.echo[volume.grid.indexOf(i, j, k)] = 0;
      }
  const GreySlice image = sliced(volume, planeOf(Cut::axial, {0.5, 13.0, 8.5}, 0.25), {48, 1}, {});
  for (std::size_t x = 0; x < 48; ++x) {
    if (image.seen[x] != 0) {
      EXPECT_EQ(image.grey[x], 100) << x;
    }
  }
  EXPECT_EQ(image.seen[5], 0);
  EXPECT_EQ(image.seen[40], 1);
}

TEST(Slices, AVolumeOfOneLayerIsSeenInItsLayer) {
  Volume volume;
  volume.grid.dims = {4, 4, 1};
  volume.echo.assign(16, 80);
  const GreySlice image = sliced(volume, planeOf(Cut::axial, {1.5, 1.5, 0.0}, 1.0), {4, 4}, {});
  EXPECT_EQ(image.grey, std::vector<std::uint8_t>(16, 80));
}

TEST(Slices, AMappingGoesThroughTheBendInItsOwnFrame) {
  registration::ControlGrid warp;
  warp.nodes.dims = {2, 2, 2};
  warp.nodes.spacing_mm = glm::dvec3(100.0);
  warp.nodes.origin_mm = glm::dvec3(-50.0);
  warp.displacement_mm.assign(8, glm::vec3(1.0F, 2.0F, 3.0F));
  Mapping mapping;
  mapping.toWarp.matrix[3] = {10, 0, 0, 1};
  mapping.toGrid.matrix[3] = {0, 0, -5, 1};
  mapping.warp = &warp;
  const glm::dvec3 p = mapping({1, 1, 1});
  EXPECT_NEAR(p.x, 12.0, 1e-6);
  EXPECT_NEAR(p.y, 3.0, 1e-6);
  EXPECT_NEAR(p.z, -1.0, 1e-6);
}

TEST(Slices, EveryPixelIsThatOfTheDefinitionRigidAndDeformed) {
  const Volume volume = speckledFan(3);
  const registration::ControlGrid warp = wave();
  const glm::ivec2 size{73, 61};
  for (const bool deformed : {false, true}) {
    const Mapping mapping{moved<frame::World, frame::Fixed>({2, -1, 3}, {5, 10, -8}), deformed ? &warp : nullptr,
                          moved<frame::View, frame::World>({-3, 1, 0}, {0, -12, 4})};
    for (int trial = 0; trial < 6; ++trial) {
      const Plane plane = turned(planeOf(Cut::coronal, {1.0 * trial, -2.0, 1.0}, 0.55), {}, {13.0 * trial, 29.0 * trial, 7.0});
      const GreySlice image = sliced(volume, plane, size, mapping);
      int seen = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const auto expected = levelBehind(volume, mapping(pointAt(plane, size, {x, y})));
          const std::size_t at = static_cast<std::size_t>(y * size.x + x);
          ASSERT_EQ(image.seen[at] != 0, expected.has_value()) << x << ", " << y;
          if (!expected) continue;
          ++seen;
          ASSERT_NEAR(image.grey[at], *expected, 0.5 + 2e-3) << x << ", " << y;
        }
      EXPECT_GT(seen, 500);
    }
  }
}

TEST(Slices, OverlaysOfOnePixelEachAreExact) {
  const GreySlice a = two(40, 200);
  const GreySlice b = two(60, 100);
  using Colours = std::vector<std::array<std::uint8_t, 3>>;
  EXPECT_EQ(overlaid(a, b, {Overlay::checkerboard, 1, false}).rgb, (Colours{{40, 40, 40}, {100, 100, 100}}));
  EXPECT_EQ(overlaid(a, b, {Overlay::difference, 48, false}).rgb, (Colours{{138, 138, 138}, {78, 78, 78}}));
  EXPECT_EQ(overlaid(a, b, {Overlay::flicker, 48, false}).rgb, (Colours{{40, 40, 40}, {200, 200, 200}}));
  EXPECT_EQ(overlaid(a, b, {Overlay::flicker, 48, true}).rgb, (Colours{{60, 60, 60}, {100, 100, 100}}));
  EXPECT_EQ(overlaid(a, b, {Overlay::colours, 48, false}).rgb, (Colours{{60, 40, 60}, {100, 200, 100}}));
  EXPECT_EQ(overlaid(a, a, {Overlay::colours, 48, false}).rgb, (Colours{{40, 40, 40}, {200, 200, 200}})) << "agreement is grey";
  EXPECT_EQ(overlaid(a, a, {Overlay::difference, 48, false}).rgb, (Colours{{128, 128, 128}, {128, 128, 128}}));
}

TEST(Slices, WhereOneSideAloneSeesItIsShownAloneAtHalf) {
  const GreySlice a = two(40, 0, true, false);
  const GreySlice b = two(0, 0, false, false);
  for (const Overlay kind : {Overlay::checkerboard, Overlay::difference, Overlay::colours}) {
    const auto image = overlaid(a, b, {kind, 1, false});
    EXPECT_EQ(image.rgb[0], (std::array<std::uint8_t, 3>{20, 20, 20}));
    EXPECT_EQ(image.rgb[1], (std::array<std::uint8_t, 3>{0, 0, 0}));
  }
}

TEST(Slices, ColoursOfLengthsBrightenAllTheWay) {
  double before = -1.0;
  for (int n = 0; n <= 50; ++n) {
    const auto c = colourOfLength(0.1 * n, 5.0);
    const double luma = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    EXPECT_GT(luma, before);
    before = luma;
  }
  EXPECT_EQ(colourOfLength(99.0, 5.0), colourOfLength(5.0, 5.0));
  EXPECT_EQ(colourOfLength(std::nan(""), 5.0), colourOfLength(0.0, 5.0));
}

TEST(Slices, ALatticeWithoutDisplacementIsSquareAndAShiftShiftsIt) {
  const Plane plane = planeOf(Cut::axial, {0, 0, 0}, 0.5);
  const glm::ivec2 size{81, 61};
  const auto still = deformedLattice(plane, size, 10.0, [](const glm::dvec3& p) { return p; });
  const auto shifted = deformedLattice(plane, size, 10.0, [](const glm::dvec3& p) { return p + glm::dvec3(2.0, -1.0, 5.0); });
  ASSERT_EQ(still.size(), 12u);  // 2 x 3 + 1 upright at +-20.25 mm, 2 x 2 + 1 level at +-15.25 mm
  ASSERT_EQ(shifted.size(), still.size());
  for (std::size_t line = 0; line < still.size(); ++line)
    for (std::size_t n = 0; n < still[line].size(); ++n) {
      EXPECT_NEAR(shifted[line][n].x - still[line][n].x, 4.0, 1e-9);
      EXPECT_NEAR(shifted[line][n].y - still[line][n].y, -2.0, 1e-9);
    }
  EXPECT_NEAR(still[1][0].x - still[0][0].x, 20.0, 1e-9);
  EXPECT_TRUE(deformedLattice(plane, size, 0.0, [](const glm::dvec3& p) { return p; }).empty());
}

Transform<frame::Moving, frame::Fixed> movedBy(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  return renamed<frame::Moving, frame::Fixed>(motionOf<frame::Fixed>(shift_mm, rotation_deg, {}));
}

TEST(Slices, ANudgeMovesWhatTheMovingVolumeShowsByThatMuch) {
  const auto fixedToMoving = movedBy({3, 1, -2}, {10, 20, -5});
  const glm::dvec3 seen{4, 5, 6};  // a place of the moving volume
  const auto shownAt = [&](const Transform<frame::Moving, frame::Fixed>& t) { return carried(inverse(t), seen); };
  const glm::dvec3 before = shownAt(fixedToMoving);
  const glm::dvec3 after = shownAt(nudged(fixedToMoving, {2, 0, -1}, {}, {}));
  EXPECT_NEAR(glm::length(after - before - glm::dvec3(2, 0, -1)), 0.0, 1e-9);
  const glm::dvec3 turned90 = shownAt(nudged(fixedToMoving, {}, {0, 0, 90}, before - glm::dvec3(1, 0, 0)));
  EXPECT_NEAR(glm::length(turned90 - before - glm::dvec3(-1, 1, 0)), 0.0, 1e-9);
}

TEST(Slices, QuickAgreementIsOneAtTheTruthAndLessBesideIt) {
  Volume volume;
  volume.grid.dims = {30, 30, 30};
  std::uint32_t state = 7;
  for (int n = 0; n < 27000; ++n) volume.echo.push_back(static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24));
  const QuickAgreement same = quickAgreement(volume, volume, {}, 1.0);
  EXPECT_NEAR(same.correlation, 1.0, 1e-9);
  EXPECT_EQ(same.overlapShare, 1.0);
  EXPECT_LT(quickAgreement(volume, volume, movedBy({3, 0, 0}, {}), 1.0).correlation, 0.1);
  const QuickAgreement apart = quickAgreement(volume, volume, movedBy({300, 0, 0}, {}), 1.0);
  EXPECT_EQ(apart.points, 0u);
  EXPECT_EQ(apart.correlation, 0.0);
}

TEST(Slices, TheSeamImageShowsEachViewWhereTheMapSaysSo) {
  SeamMap seams;
  seams.cells.dims = {2, 1, 1};
  seams.cells.spacing_mm = glm::dvec3(10.0);
  seams.view = {1, 2};
  EXPECT_EQ(viewAt(seams, {1, 0, 0}), 0);
  EXPECT_EQ(viewAt(seams, {9, 0, 0}), 1);
  EXPECT_EQ(viewAt(seams, {40, 0, 0}), -1);
  Volume dark;
  dark.grid.dims = {40, 40, 40};
  dark.grid.origin_mm = glm::dvec3(-10.0);
  Volume bright = dark;
  dark.echo.assign(64000, 10);
  bright.echo.assign(64000, 240);
  const std::vector<WorldView> views = {{&dark, {}}, {&bright, {}}};
  const auto image = seamImage(seams, views, planeOf(Cut::axial, {5, 0, 0}, 1.0), {9, 1}, {});
  EXPECT_LT(image.rgb[0][1], 60);
  EXPECT_GT(image.rgb[8][1], 140);
}

TEST(Slices, EveryPixelOfTheSeamImageIsThatOfItsView) {
  const Volume one = speckledFan(5);
  const Volume other = speckledFan(6);
  const registration::ControlGrid warp = wave();
  SeamMap seams;
  seams.cells.dims = {8, 8, 8};
  seams.cells.spacing_mm = glm::dvec3(5.0);
  seams.cells.origin_mm = glm::dvec3(-17.0);
  for (int n = 0; n < 512; ++n) seams.view.push_back(static_cast<std::uint8_t>(n / 3 % 5));  // 4: a view that is not there
  const auto toWorld = moved<frame::World, frame::Fixed>({1, 2, 3}, {3, -4, 5});
  const std::vector<WorldView> views = {
      {&one, {toWorld, &warp, moved<frame::View, frame::World>({-1, 0, 0}, {})}}, {&other, {toWorld, nullptr, {}}}, {}};
  const Plane plane = turned(planeOf(Cut::axial, {0, 0, 1}, 0.6), {}, {20, 15, -10});
  const glm::ivec2 size{64, 57};
  const auto image = seamImage(seams, views, plane, size, toWorld);
  const auto ownerAt = [&](int x, int y) {
    const int view = viewAt(seams, carried(toWorld, pointAt(plane, size, {x, y})));
    return view < 3 ? view : -1;
  };
  int compared = 0;
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const int view = ownerAt(x, y), right = ownerAt(x + 1, y), below = ownerAt(x, y + 1);
      const auto& colour = image.rgb[static_cast<std::size_t>(y * size.x + x)];
      std::array<double, 3> expected{0.0, 0.0, 0.0};
      if (view >= 0 && ((right >= 0 && right != view) || (below >= 0 && below != view))) {
        expected = {235.0, 240.0, 242.0};
      } else if (view >= 0) {
        const WorldView& shown = views[static_cast<std::size_t>(view)];
        const glm::dvec3 p = pointAt(plane, size, {x, y});
        const double grey = shown.volume != nullptr ? levelBehind(*shown.volume, shown.fromPlane(p)).value_or(0.0) : 0.0;
        const auto tint = colourOfView(static_cast<std::size_t>(view));
        for (std::size_t c = 0; c < 3; ++c) expected[c] = 0.62 * grey + 0.22 * tint[c] * (0.35 + 0.65 * grey / 255.0);
        compared += grey > 0.0 ? 1 : 0;
      }
      for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(colour[c], expected[c], 0.5 + 2e-3) << x << ", " << y;
    }
  EXPECT_GT(compared, 250);
}

}  // namespace
}  // namespace ew::stitching::slices_test
