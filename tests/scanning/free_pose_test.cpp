#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>

#include "ew/scanning/contact.h"
#include "ew/scanning/scanner.h"
#include "scanning/small_scan.h"
#include "tracking/skins.h"

namespace ew::free_pose_test {
namespace {

constexpr double kGrazing = 0.17364817766693033;  // cos 80 degrees
constexpr double kTurnedAway = -0.3420201433256687;

double rad(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Above the plane z = 0: looks along -z, tipped by `tip` towards +y, its lateral axis along x rolled by `roll` about the beam.
Pose above(double height_mm, double tip_deg, double rock_deg = 0.0) {
  const glm::dvec3 down(0.0, 0.0, -1.0), along(0.0, 1.0, 0.0), across(1.0, 0.0, 0.0);
  glm::dvec3 y = std::cos(rad(tip_deg)) * down + std::sin(rad(tip_deg)) * along;
  glm::dvec3 x = across;
  const glm::dvec3 rocked = std::cos(rad(rock_deg)) * x + std::sin(rad(rock_deg)) * y;
  y = std::cos(rad(rock_deg)) * y - std::sin(rad(rock_deg)) * x;
  x = rocked;
  const glm::dvec3 z = glm::cross(x, y);
  Pose pose;
  pose.probeToWorld.matrix = {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(0.0, 0.0, height_mm, 1.0)};
  return pose;
}

std::vector<float> onPlane(double height_mm, double tip_deg) {
  return gapsToSkin_mm(test::smallProbe(), above(height_mm, tip_deg), test::PlaneSkin());
}

/// The rule for a hand: along the normal at the nearest point.
std::vector<float> alongNormals_mm(const Probe& probe, const Pose& pose, const Skin& skin) {
  std::vector<float> gaps_mm;
  for (const glm::dvec3& p_probe : facePoints_mm(probe, kPointsOfFace)) {
    const glm::dvec3 p(pose.probeToWorld.matrix * glm::dvec4(p_probe, 1.0));
    const Skin::Contact nearest = skin.nearest(p);
    gaps_mm.push_back(static_cast<float>(glm::dot(p - nearest.point_mm, nearest.outward)));
  }
  return gaps_mm;
}

Probe smallConvex() {
  Probe convex = test::smallProbe();
  convex.kind = ProbeKind::convex;
  convex.radius_mm = 40.0;
  convex.halfAngle_rad = rad(33.0);
  return convex;
}

}  // namespace

TEST(FreePose, AHandsHoldHasTheGapsItAlwaysHad) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const test::PlaneSkin plane;
  const test::SphereSkin sphere(110.0);
  for (int n = 0; n < 2000; ++n) {
    Hold hold;
    hold.rotation_rad = between(-3.0, 3.0);
    hold.rock_rad = between(-1.3, 1.3);
    hold.tilt_rad = between(-1.3, 1.3);
    hold.press_mm = between(0.0, kMaxPress_mm);
    for (const Probe& probe : {test::smallProbe(), smallConvex()}) {
      hold.contact = {{between(-50.0, 50.0), between(-50.0, 50.0), 0.0}, {0.0, 0.0, 1.0}};
      EXPECT_EQ(gapsToSkin_mm(probe, poseOf(hold), plane), alongNormals_mm(probe, poseOf(hold), plane));
      hold.contact = sphere.nearest({between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)});
      const auto found = gapsToSkin_mm(probe, poseOf(hold), sphere), before = alongNormals_mm(probe, poseOf(hold), sphere);
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_TRUE(found[i] == before[i] || (found[i] > 4.0F && before[i] > 4.0F)) << found[i] << " was " << before[i];
    }
  }
}

TEST(FreePose, UpsideDownIsInAirHoweverNearTheSkinIs) {
  for (const double height_mm : {0.0, 0.5, 2.0, 40.0, -1.0, -8.0, -60.0})
    for (const double tip_deg : {115.0, 150.0, 180.0})
      for (const float gap_mm : onPlane(height_mm, tip_deg)) EXPECT_EQ(gap_mm, kOpenAir_mm) << height_mm << ' ' << tip_deg;
}

TEST(FreePose, OnItsSideNothingTouchesAndNothingIsEndless) {
  for (const double tip_deg : {90.0, 89.99, 90.01})
    for (const float gap_mm : onPlane(2.0, tip_deg)) EXPECT_EQ(gap_mm, kOpenAir_mm);
  for (const float gap_mm : onPlane(-1.0, 90.0)) EXPECT_GT(gap_mm, 4.0F) << "a touch of the skin beside the face is no contact";
}

TEST(FreePose, TippedFurtherItNeverTouchesBetterAndNothingJumpsWhereTheRulesMeet) {
  for (const double height_mm : {0.5, 2.0, -3.0, -12.0}) {
    float before_mm = static_cast<float>(height_mm);
    for (double tip_deg = 0.0; tip_deg <= 180.0; tip_deg += 0.05) {
      const float gap_mm = onPlane(height_mm, tip_deg).front();
      if (tip_deg <= 80.0) {
        EXPECT_EQ(gap_mm, static_cast<float>(height_mm)) << tip_deg;
      }
      EXPECT_GE(gap_mm, before_mm) << height_mm << ' ' << tip_deg;
      if (std::abs(tip_deg - 80.0) < 0.2) {
        EXPECT_LT(gap_mm - before_mm, 0.2F) << height_mm << ' ' << tip_deg;
      }
      before_mm = gap_mm;
    }
    EXPECT_EQ(before_mm, kOpenAir_mm);
  }
}

TEST(FreePose, TheWayThroughAirIsThatOfEachPointsOwnLine) {
  const double tip = rad(85.0);
  for (const float gap_mm : onPlane(2.0, 85.0)) EXPECT_NEAR(gap_mm, kGrazing * 2.0 / std::cos(tip), 1e-5);
  for (const float gap_mm : onPlane(-5.0, 95.0))
    EXPECT_NEAR(gap_mm, -5.0 + kMaxPress_mm * (kGrazing + std::sin(rad(5.0))) / (kGrazing - kTurnedAway), 1e-5);

  constexpr double kRadius_mm = 1000.0;
  const test::SphereSkin sphere(kRadius_mm);
  const Pose pose = above(kRadius_mm + 2.0, 84.0);
  const auto gaps_mm = gapsToSkin_mm(test::smallProbe(), pose, sphere);
  const auto points = facePoints_mm(test::smallProbe(), kPointsOfFace);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const glm::dvec3 p(pose.probeToWorld.matrix * glm::dvec4(points[n], 1.0)), along(pose.probeToWorld.matrix[1]);
    const double b = glm::dot(p, along), way_mm = -b - std::sqrt(b * b - glm::dot(p, p) + kRadius_mm * kRadius_mm);
    EXPECT_NEAR(gaps_mm[n], std::max(glm::length(p) - kRadius_mm, kGrazing * way_mm), 1e-4) << n;
  }

  // Of a curved face lying on its side the half that looks down still meets skin, the other half the sky.
  const auto curved_mm = gapsToSkin_mm(smallConvex(), above(30.0, 0.0, -90.0), test::PlaneSkin());
  const auto onArc = facePoints_mm(smallConvex(), kPointsOfFace);
  for (std::size_t n = 0; n < onArc.size(); ++n) {
    const double angle = rad(33.0) * (2.0 * static_cast<double>(n) / (kPointsOfFace - 1) - 1.0), height_mm = 30.0 + onArc[n].x;
    const double down = -std::sin(angle), way_mm = height_mm / down;
    const bool meets = down > 0.0 && way_mm < 1000.0;
    EXPECT_NEAR(curved_mm[n], meets ? std::max(height_mm, kGrazing * way_mm) : 1000.0, 1e-3) << n;
  }
}

TEST(FreePose, SaysHowTheFaceLies) {
  EXPECT_EQ(faceOnSkin({}), FaceReport{});
  EXPECT_EQ(faceOnSkin({-1.0F, 0.0F, 9.0F}).how, FaceOnSkin::touches);
  EXPECT_TRUE(faceSentence(faceOnSkin({-1.0F, 0.0F, 9.0F})).empty());
  EXPECT_EQ(faceOnSkin({-1.0F, 5.0F, 9.0F}).how, FaceOnSkin::partly);
  EXPECT_EQ(faceOnSkin(onPlane(23.4, 10.0)), (FaceReport{FaceOnSkin::inAir, static_cast<double>(23.4F)}));
  EXPECT_EQ(faceSentence(faceOnSkin(onPlane(23.4, 10.0))).english(), "The probe is 23 mm above the skin.");
  EXPECT_EQ(faceOnSkin(onPlane(2.0, 180.0)).how, FaceOnSkin::looksAway);
  EXPECT_EQ(faceOnSkin(onPlane(-20.0, 0.0)).how, FaceOnSkin::touches) << "a firm hand on a soft belly";
  EXPECT_EQ(faceSentence(faceOnSkin(onPlane(-45.2, 0.0))).english(),
            "The probe is 45 mm inside the body: check the alignment of the tracker.");
}

namespace {

/// Volume on both sides of the skin, so that whatever is dark is dark for want of contact.
ScanState inHand(const Pose& pose) {
  ScanState state;
  state.probe = test::smallProbe();
  state.knobs.depth_mm = 50.0;
  state.scene.gainAndDgc = true;
  state.scene.contact.emplace();
  state.pose = pose;
  state.gaps_mm = gapsToSkin_mm(state.probe, pose, test::PlaneSkin());
  return state;
}

struct Seen {
  std::vector<std::uint8_t> pixels;
  double deep = 0.0;               ///< mean grey of the fan below the ring-down
  double left = 0.0, right = 0.0;  ///< the same of both halves of it, as the probe's x goes
};

Seen seen(Scanner& scanner, const ScanState& state) {
  const DisplayImage image = scanner.make(state, 200, 160);
  Seen found;
  double sums[2] = {}, counts[2] = {};
  const double below_mm = state.scene.contact->ringDown_mm + 1.0;
  for (int y = 0; y < image.height(); ++y) {
    found.pixels.insert(found.pixels.end(), image.grey.row(y), image.grey.row(y) + image.width());
    for (int x = 0; x < image.width(); ++x) {
      const glm::dvec2 at_mm = scanner.geometry().probePoint_mm(x, y);
      if (at_mm.y < below_mm || at_mm.y > 28.0 || std::abs(at_mm.x) > 18.0 || std::abs(at_mm.x) < 4.0) continue;
      const int side = at_mm.x > 0.0 ? 1 : 0;
      sums[side] += image.grey.row(y)[x];
      counts[side] += 1.0;
    }
  }
  found.left = sums[0] / counts[0];
  found.right = sums[1] / counts[1];
  found.deep = (sums[0] + sums[1]) / (counts[0] + counts[1]);
  return found;
}

}  // namespace

TEST(FreePose, LiftedTheImageGoesDarkBelowTheNearFieldAndNeverBrighterWithTheGap) {
  Scanner scanner(1);
  scanner.show(test::waveSubject());
  ScanState touching = inHand(above(-1.0, 0.0));
  double before = 256.0;
  for (const double height_mm : {-1.0, 0.0, 2.9, 3.2, 3.4, 3.6, 3.8, 3.95, 4.1, 6.0, 20.0, 200.0}) {
    touching.pose = above(height_mm, 0.0);
    const Seen here = seen(scanner, inHand(touching.pose));
    if (height_mm < 3.0) {
      touching.gaps_mm.clear();
      EXPECT_EQ(here.pixels, seen(scanner, touching).pixels) << "gel fills it: nothing changes at " << height_mm;
      EXPECT_GT(here.deep, 40.0);
    } else {
      EXPECT_LE(here.deep, before) << height_mm;
      before = here.deep;
    }
    if (height_mm > 4.0) {
      EXPECT_EQ(here.deep, 0.0) << height_mm;
      EXPECT_TRUE(std::any_of(here.pixels.begin(), here.pixels.end(), [](std::uint8_t grey) { return grey > 100; })) << "it rings down";
    }
  }
}

TEST(FreePose, UpsideDownOnTheSkinLooksAsItDoesFarFromIt) {
  Scanner scanner(1);
  scanner.show(test::waveSubject());
  const auto far = seen(scanner, inHand(above(300.0, 0.0))).pixels;
  EXPECT_EQ(seen(scanner, inHand(above(1.0, 180.0))).pixels, far);
  EXPECT_EQ(seen(scanner, inHand(above(-4.0, 180.0))).pixels, far);
  EXPECT_EQ(seen(scanner, inHand(above(1.5, 90.0))).pixels, far);
}

TEST(FreePose, OfASlantedFaceOnlyTheLinesUnderWhatTouchesShow) {
  Scanner scanner(1);
  scanner.show(test::waveSubject());
  // About an end of the face: the other one is 40 mm * sin(20 degrees) off the skin.
  const Seen right = seen(scanner, inHand(above(20.0 * std::sin(rad(20.0)), 0.0, 20.0)));
  EXPECT_GT(right.right, 30.0);
  EXPECT_LT(right.left, 1.0);
  const Seen left = seen(scanner, inHand(above(20.0 * std::sin(rad(20.0)), 0.0, -20.0)));
  EXPECT_GT(left.left, 30.0);
  EXPECT_LT(left.right, 1.0);
}

TEST(FreePose, BehindAGapTheImageBeginsAnew) {
  ScanState state = inHand(above(-1.0, 0.0));
  state.knobs.persistence = 0.6;
  Scanner through(1), fresh(1);
  through.show(test::waveSubject());
  fresh.show(test::waveSubject());
  for (int n = 0; n < 4; ++n) static_cast<void>(seen(through, state));
  ScanState missed = state;
  missed.pose.status = PoseStatus::missing;
  const auto dark = seen(through, missed).pixels;
  EXPECT_TRUE(std::all_of(dark.begin(), dark.end(), [](std::uint8_t grey) { return grey == 0; }));
  state.pose = above(-1.0, 0.0, 15.0);
  EXPECT_EQ(seen(through, state).pixels, seen(fresh, state).pixels);
}

}  // namespace ew::free_pose_test
