#include "ew/imaging/panorama.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ew/imaging/frame.h"

namespace ew {
namespace {

/// 220 x 12 x 90 mm around the origin (x across, y out of the plane, z downwards): waves, and small round targets in the plane y = 0.
const Volume& phantom() {
  static const Volume made = [] {
    Volume volume;
    volume.grid.dims = {440, 25, 180};
    volume.grid.spacing_mm = glm::dvec3(0.5);
    volume.grid.origin_mm = {-110.0, -6.0, 0.0};
    volume.echo.resize(volume.grid.voxelCount());
    for (int k = 0; k < 180; ++k)
      for (int j = 0; j < 25; ++j)
        for (int i = 0; i < 440; ++i) {
          double waves = 20.0 * std::sin(0.31 * i + 0.11 * k) + 15.0 * std::cos(0.23 * k - 0.07 * i), level = 60.0;
          for (const double x_mm : {-75.0, 0.0, 75.0}) {
            const glm::dvec3 from(-110.0 + 0.5 * i - x_mm, -6.0 + 0.5 * j, 0.5 * k - 40.0);
            level += 160.0 * std::exp(-0.5 * glm::dot(from, from) / (1.2 * 1.2));
            if (glm::length(from) < 6.0) waves = 0.0;  // so that their middles are those that are seen
          }
          level += waves;
          volume.echo[volume.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::min(255.0, level));
        }
    return volume;
  }();
  return made;
}

/// The face at (x, 0, z), turned in its plane by `turned_rad`, which moves its far end towards -x.
Pose poseAt(double x_mm, double z_mm = 0.0, double turned_rad = 0.0, double y_mm = 0.0, double tilt_rad = 0.0) {
  Pose pose;
  glm::dmat4& matrix = pose.probeToWorld.matrix;
  const double c = std::cos(turned_rad), s = std::sin(turned_rad);
  const glm::dvec3 lateral(c, 0.0, s);
  const glm::dvec3 straight(-s, 0.0, c), out = glm::cross(lateral, straight);
  const glm::dvec3 axial = std::cos(tilt_rad) * straight + std::sin(tilt_rad) * out;
  matrix[0] = glm::dvec4(lateral, 0.0);
  matrix[1] = glm::dvec4(axial, 0.0);
  matrix[2] = glm::dvec4(glm::cross(lateral, axial), 0.0);
  matrix[3] = glm::dvec4(x_mm, y_mm, z_mm, 1.0);
  return pose;
}

struct Scan {
  Probe probe;
  Knobs knobs;
  FrameMaker maker;
  int width = 260, height = 300;
  Scan() {
    probe.id = "linear";
    probe.width_mm = 50.0;
    probe.lines = 128;
    probe.minDepth_mm = 20.0;
    probe.maxDepth_mm = 120.0;
    probe.defaultDepth_mm = 70.0;
  }
  DisplayImage image(const Pose& pose) {
    maker.configure(probe, knobs, {}, phantom().grid, width, height);
    return maker.make(VolumeView<const std::uint8_t>{phantom().echo.data(), phantom().grid}, pose);
  }
  Woven weave(Panorama& wide, const Pose& pose) {
    const DisplayImage display = image(pose);
    return wide.add(display.grey, maker.geometry(), probe, knobs, pose);
  }
};

/// Where a bright round thing near `about_mm` (plane of the wide image) is, in mm of that plane.
glm::dvec2 brightNear(const GreyImage& display, const DisplayGeometry& geometry, const glm::dvec2& about_mm) {
  double sum = 0.0;
  glm::dvec2 at(0.0);
  for (int y = 0; y < display.height; ++y)
    for (int x = 0; x < display.width; ++x) {
      const glm::dvec2 p_mm = geometry.probePoint_mm(x, y);
      if (glm::distance(p_mm, about_mm) > 4.0) continue;
      const double over = std::max(0.0, viewOf(display).at(x, y) - 130.0);
      sum += over;
      at += over * p_mm;
    }
  return at / sum;
}

int largestDifference(const GreyImage& a, const GreyImage& b) {
  int largest = a.width == b.width && a.height == b.height ? 0 : 1000;
  for (std::size_t n = 0; largest < 1000 && n < a.pixels.size(); ++n) largest = std::max(largest, std::abs(a.pixels[n] - b.pixels[n]));
  return largest;
}

TEST(Panorama, OfAProbeAtRestIsItsImage) {
  Scan scan;
  for (const bool flipped : {false, true}) {
    scan.knobs.markerLeft = !flipped;
    scan.knobs.upsideDown = flipped;
    const Pose pose = poseAt(3.3, 1.7, 0.21);
    Panorama wide;
    for (int n = 0; n < 9; ++n) ASSERT_EQ(scan.weave(wide, pose), Woven::woven);
    const GreyImage image = copyOf(scan.image(pose).grey);
    const DisplayGeometry whole = wide.geometry();
    const GreyImage seen = wide.render(whole);
    const glm::ivec2 corner(glm::round(scan.maker.geometry().face_px - whole.face_px));
    EXPECT_EQ(whole.pixel_mm, scan.maker.geometry().pixel_mm);
    std::size_t compared = 0;
    for (int y = 0; y < image.height; ++y)
      for (const RowSpan& run : scan.maker.spans()[static_cast<std::size_t>(y)])
        for (int x = run.begin; x < run.end; ++x, ++compared)
          ASSERT_EQ(viewOf(seen).at(x - corner.x, y - corner.y), viewOf(image).at(x, y)) << x << ' ' << y;
    EXPECT_GT(compared, 30000U);
    EXPECT_EQ(static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height), compared)
        << "a linear probe's is a rectangle";
  }
}

TEST(Panorama, MeasuresDistancesOver150mmWithinAPixel) {
  Scan scan;
  for (const bool flipped : {false, true}) {
    scan.knobs.markerLeft = !flipped;
    scan.knobs.upsideDown = flipped;
    Panorama wide;
    // From the middle to one side, and over it to the other: it grows in both directions.
    for (double x = 0.0; x <= 82.0; x += 2.9) ASSERT_EQ(scan.weave(wide, poseAt(x)), Woven::woven) << x;
    for (double x = 80.0; x >= -82.0; x -= 3.1) ASSERT_EQ(scan.weave(wide, poseAt(x)), Woven::woven) << x;
    const DisplayGeometry whole = wide.geometry();
    const GreyImage display = wide.render(whole);
    const glm::dvec2 left = brightNear(display, whole, {-75.0, 40.0}), middle = brightNear(display, whole, {0.0, 40.0}),
                     right = brightNear(display, whole, {75.0, 40.0});
    EXPECT_NEAR(glm::distance(left, right), 150.0, whole.pixel_mm);
    EXPECT_NEAR(glm::distance(left, middle), 75.0, whole.pixel_mm);
    for (const auto& [seen, truth] : {std::pair{left, glm::dvec2(-75.0, 40.0)}, {middle, {0.0, 40.0}}, {right, {75.0, 40.0}}})
      EXPECT_LT(glm::distance(seen, truth), whole.pixel_mm);
    EXPECT_NEAR(whole.width * whole.pixel_mm, 164.0 + 50.0, 3.0);
  }
}

TEST(Panorama, OfACurvedSlideShowsWhatLiesBelow) {
  Scan scan;
  Panorama wide;
  // Along an arc of 180 mm radius about a point below: as over a belly.
  constexpr double kRadius_mm = 180.0;
  for (double angle = 0.0; angle <= 0.47; angle += 0.02)
    ASSERT_EQ(scan.weave(wide, poseAt(kRadius_mm * std::sin(angle), kRadius_mm * (1.0 - std::cos(angle)), angle)), Woven::woven) << angle;
  for (double angle = 0.45; angle >= -0.47; angle -= 0.02)
    ASSERT_EQ(scan.weave(wide, poseAt(kRadius_mm * std::sin(angle), kRadius_mm * (1.0 - std::cos(angle)), angle)), Woven::woven) << angle;
  const DisplayGeometry whole = wide.geometry();
  const GreyImage display = wide.render(whole);
  const glm::dvec2 left = brightNear(display, whole, {-75.0, 40.0}), right = brightNear(display, whole, {75.0, 40.0});
  EXPECT_NEAR(glm::distance(left, right), 150.0, whole.pixel_mm);
  // And everywhere what a single image from above would show.
  Scan large;
  large.probe.width_mm = 190.0;
  large.width = 700;
  large.height = 300;
  const GreyImage truth = copyOf(large.image(poseAt(0.0)).grey);
  double squares = 0.0;
  std::size_t count = 0;
  const DisplayGeometry& above = large.maker.geometry();
  const GreyImage same = wide.render([&] {
    DisplayGeometry shown = above;
    shown.depth_mm = whole.depth_mm;
    return shown;
  }());
  for (int y = 0; y < truth.height; ++y)
    for (int x = 0; x < truth.width; ++x) {
      const glm::dvec2 p_mm = above.probePoint_mm(x, y);
      if (std::abs(p_mm.x) > 85.0 || p_mm.y < 32.0 || p_mm.y > 60.0) continue;
      const double by = viewOf(truth).at(x, y) - viewOf(same).at(x, y);
      squares += by * by;
      ++count;
    }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 3.0);
}

TEST(Panorama, DoesNotDependOnTheOrderOfItsImagesBehindTheFirst) {
  Scan scan;
  std::vector<Pose> poses;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> about(-1.0, 1.0);
  for (int n = 0; n < 24; ++n) poses.push_back(poseAt(12.0 * about(random), 2.0 * about(random), 0.1 * about(random)));
  const auto woven = [&] {
    Panorama wide;
    EXPECT_EQ(scan.weave(wide, poseAt(0.0)), Woven::woven);
    for (const Pose& pose : poses) EXPECT_EQ(scan.weave(wide, pose), Woven::woven);
    return wide.render(wide.geometry());
  };
  const GreyImage before = woven();
  std::shuffle(poses.begin(), poses.end(), random);
  EXPECT_EQ(woven(), before);
}

TEST(Panorama, IsTheSameWhereverTheBodyLies) {
  Scan scan;
  std::vector<std::pair<Pose, GreyImage>> images;
  for (double x = 0.0; x < 60.0; x += 4.0) {
    const Pose pose = poseAt(x, 0.002 * x * x, 0.003 * x);
    images.emplace_back(pose, copyOf(scan.image(pose).grey));
  }
  const auto woven = [&](const Transform<frame::World, frame::World>& moved) {
    Panorama wide;
    for (auto [pose, image] : images) {
      pose.probeToWorld = moved * pose.probeToWorld;
      EXPECT_EQ(wide.add(viewOf(std::as_const(image)), scan.maker.geometry(), scan.probe, scan.knobs, pose), Woven::woven);
    }
    return wide.render(wide.geometry());
  };
  Transform<frame::World, frame::World> elsewhere{poseAt(40.0, -300.0, 1.1, 77.0, 0.9).probeToWorld.matrix};
  EXPECT_LE(largestDifference(woven({}), woven(elsewhere)), 1);
}

TEST(Panorama, OfEqualImagesIsEqualEverywhere) {
  Scan scan;
  scan.probe.kind = ProbeKind::convex;
  scan.probe.radius_mm = 50.0;
  scan.probe.halfAngle_rad = 0.5;
  static_cast<void>(scan.image(poseAt(0.0)));
  const GreyImage even(scan.width, scan.height, 93);
  Panorama wide;
  for (double x = 0.0; x < 100.0; x += 5.0)
    ASSERT_EQ(wide.add(viewOf(even), scan.maker.geometry(), scan.probe, scan.knobs, poseAt(x, 0.001 * x * x, 0.002 * x)), Woven::woven);
  for (const std::uint8_t level : wide.render(wide.geometry()).pixels) ASSERT_TRUE(level == 0 || level == 93) << int{level};
  for (const std::uint8_t level : wide.render(wide.fit(300, 200)).pixels) ASSERT_TRUE(level == 0 || level == 93) << int{level};
  for (const std::uint8_t level : wide.render(wide.fit(300, 200, 7.0, {20.0, 5.0})).pixels) ASSERT_TRUE(level == 0 || level == 93);
}

TEST(Panorama, SaysWhyAnImageIsNotWovenAndStaysAsItWas) {
  Scan scan;
  Panorama wide;
  EXPECT_TRUE(wide.empty());
  Pose lost = poseAt(0.0);
  lost.status = PoseStatus::missing;
  EXPECT_EQ(scan.weave(wide, lost), Woven::noPose);
  EXPECT_TRUE(wide.empty());
  ASSERT_EQ(scan.weave(wide, poseAt(0.0)), Woven::woven);
  const GreyImage before = wide.render(wide.geometry());
  const double degree = std::numbers::pi / 180.0;
  EXPECT_EQ(scan.weave(wide, poseAt(4.0, 0.0, 0.0, 0.0, 12.5 * degree)), Woven::tilted);
  EXPECT_EQ(scan.weave(wide, poseAt(4.0, 0.0, 0.0, 0.0, -12.5 * degree)), Woven::tilted);
  EXPECT_EQ(scan.weave(wide, poseAt(4.0, 0.0, 0.0, 8.2)), Woven::offPlane);
  EXPECT_EQ(scan.weave(wide, poseAt(26.0)), Woven::tooFast);
  EXPECT_EQ(scan.weave(wide, poseAt(0.0, 0.0, 1.0)), Woven::tooFast) << "turned about its face";
  EXPECT_EQ(scan.weave(wide, lost), Woven::noPose);
  Pose mirrored = poseAt(0.0);
  mirrored.probeToWorld.matrix[2] *= -1.0;
  EXPECT_EQ(scan.weave(wide, mirrored), Woven::noPose);
  EXPECT_EQ(wide.imageCount(), 1U);
  EXPECT_EQ(wide.render(wide.geometry()), before);
  EXPECT_EQ(scan.weave(wide, poseAt(4.0, 0.0, 0.0, 7.8, 11.5 * degree)), Woven::woven);
  EXPECT_EQ(scan.weave(wide, poseAt(24.0)), Woven::woven);
  EXPECT_EQ(scan.weave(wide, poseAt(48.0)), Woven::woven) << "near the latest";
}

TEST(Panorama, HoldsNoMoreThanItMay) {
  Scan scan;
  WideOptions options;
  options.bytes = std::size_t{4} << 20;
  Panorama wide(options);
  Woven last = Woven::woven;
  double x = 0.0;
  for (; last == Woven::woven && x < 2000.0; x += 20.0) last = scan.weave(wide, poseAt(x));
  EXPECT_EQ(last, Woven::full);
  EXPECT_GT(x, 150.0);
  EXPECT_LE(wide.bytes(), options.bytes + (std::size_t{1} << 20));
  const GreyImage before = wide.render(wide.geometry());
  EXPECT_EQ(scan.weave(wide, poseAt(x)), Woven::tooFast);
  EXPECT_EQ(wide.render(wide.geometry()), before);
  EXPECT_EQ(scan.weave(wide, poseAt(10.0)), Woven::woven) << "where there is room already";
}

TEST(Panorama, IsShownWholeAndInDetailAtItsScale) {
  Scan scan;
  Panorama wide;
  for (double x = 0.0; x <= 82.0; x += 4.0) ASSERT_EQ(scan.weave(wide, poseAt(x)), Woven::woven);
  for (double x = 78.0; x >= -82.0; x -= 4.0) ASSERT_EQ(scan.weave(wide, poseAt(x)), Woven::woven);
  const DisplayGeometry shown = wide.fit(640, 400);
  const GreyImage whole = wide.render(shown);
  const glm::dvec2 left = brightNear(whole, shown, {-75.0, 40.0}), right = brightNear(whole, shown, {75.0, 40.0});
  EXPECT_NEAR(glm::distance(left, right), 150.0, shown.pixel_mm);
  EXPECT_EQ(viewOf(whole).at(0, 200), 0);
  // A detail, as far to one side as it goes, and no farther.
  const Pan far = wide.panWithin(4.0, {1e9, 0.0});
  EXPECT_EQ(wide.fit(640, 400, 4.0, {1e9, 0.0}), wide.fit(640, 400, 4.0, far));
  const DisplayGeometry near = wide.fit(640, 400, 4.0, {75.0, 5.0});
  EXPECT_NEAR(near.pixel_mm, shown.pixel_mm / 4.0, 1e-12);
  EXPECT_LT(glm::distance(brightNear(wide.render(near), near, {75.0, 40.0}), glm::dvec2(75.0, 40.0)), shown.pixel_mm);
}

}  // namespace
}  // namespace ew
