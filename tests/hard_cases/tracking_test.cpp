#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/constants.hpp>
#include <limits>

#include "ew/tracking/hand.h"
#include "tracking/skins.h"

namespace ew::tracking_test {
namespace {

glm::dvec3 axisOf(const Pose& pose, int axis) { return glm::dvec3(pose.probeToWorld.matrix[axis]); }

bool rigid(const Hold& hold) { return checkRigid(poseOf(hold).probeToWorld.matrix, 1e-9).has_value(); }

Hold held(const glm::dvec3& outward, const glm::dvec3& hint) {
  Hold hold;
  hold.contact = {100.0 * outward, outward};
  hold.lateralHint = hint;
  return hold;
}

TEST(TrackingHardCases, AHintAlongTheNormalGivesTheDirectionAroundTheBody) {
  const Hold hold = held({-1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  EXPECT_TRUE(rigid(hold));
  EXPECT_LT(glm::length(axisOf(poseOf(hold), 0) - glm::dvec3(0.0, 1.0, 0.0)), 1e-12);
}

TEST(TrackingHardCases, OnTopOfTheHeadWithAHintUpwardsTheMarkerPointsRight) {
  const Hold hold = held({0.0, 0.0, 1.0}, {0.0, 0.0, 3.0});
  EXPECT_TRUE(rigid(hold));
  EXPECT_LT(glm::length(axisOf(poseOf(hold), 0) - glm::dvec3(-1.0, 0.0, 0.0)), 1e-12);
}

TEST(TrackingHardCases, AGrazingHintStillGivesARigidPose) {
  for (const double sine : {1e-3, 1e-6, 1e-8, 1e-12, 1e-300}) {
    const Hold hold = held({-1.0, 0.0, 0.0}, glm::dvec3(-1.0, sine, 0.0));
    EXPECT_TRUE(rigid(hold)) << sine;
  }
}

TEST(TrackingHardCases, OppositeNormalsInEveryDirectionKeepThePoseRigid) {
  for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, 2, 3))}) {
    const glm::dvec3 hint = std::abs(n.x) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(-1, 0, 0);
    for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
      const glm::dvec3 opposite = glm::normalize(-n + off * glm::dvec3(0.3, -0.7, 0.2));
      const Hold moved = movedTo(held(n, hint), {100.0 * opposite, opposite});
      EXPECT_TRUE(rigid(moved)) << off;
    }
  }
}

TEST(TrackingHardCases, AHundredThousandSmallSlidesStayOnTheSkinAndRigid) {
  const test::SphereSkin skin(100.0);
  Hold hold = held({0.0, -1.0, 0.0}, {-1.0, 0.0, 0.0});
  for (int i = 0; i < 100000; ++i) hold = slid(hold, skin, 0.03, 0.01 * ((i / 100) % 3 - 1));
  EXPECT_NEAR(glm::length(hold.contact.point_mm), 100.0, 1e-6);
  EXPECT_NEAR(glm::length(hold.lateralHint), 1.0, 1e-9);
  EXPECT_TRUE(rigid(hold));
}

TEST(TrackingHardCases, ATinySlideIsNotLostAndAHugeOneEnds) {
  const test::SphereSkin skin(100.0);
  const Hold hold = held({0.0, -1.0, 0.0}, {-1.0, 0.0, 0.0});
  EXPECT_NEAR(glm::distance(slid(hold, skin, 1e-6, 0.0).contact.point_mm, hold.contact.point_mm), 1e-6, 1e-10);
  EXPECT_TRUE(rigid(slid(hold, skin, 1e12, -1e12)));
}

TEST(TrackingHardCases, CornersOfACubeAreCrossedInEveryDirectionWithoutAJump) {
  const test::CubeSkin skin(40.0);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    Hold hold;
    hold.contact = skin.nearest({35.0, -50.0, 35.0});
    hold.rotation_rad = glm::radians(static_cast<double>(degrees));
    for (int i = 0; i < 200; ++i) {
      const Hold next = slid(hold, skin, 1.0, 0.0);
      ASSERT_LT(skin.distance_mm(next.contact.point_mm), 1e-6) << degrees << " degrees, step " << i;
      ASSERT_LT(glm::distance(next.contact.point_mm, hold.contact.point_mm), 3.0 + 1e-9) << degrees << " degrees, step " << i;
      ASSERT_TRUE(rigid(next)) << degrees << " degrees, step " << i;
      hold = next;
    }
  }
}

TEST(TrackingHardCases, APoseWithItsPlaneInTheSkinIsTippedBackToTheLimit) {
  const test::SphereSkin skin(100.0);
  Pose pose;  // lateral along the normal: rock of 90 degrees
  pose.probeToWorld.matrix =
      glm::dmat4(glm::dvec4(0, -1, 0, 0), glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, -100, 0, 1));
  const Hold rocked = holdFor(pose, skin);
  EXPECT_TRUE(rigid(rocked));
  EXPECT_NEAR(std::abs(rocked.rock_rad), kMaxTip_rad, 1e-9);
  // Elevational along the normal: tilt of 90 degrees, where rotation and rock turn about the same line.
  pose.probeToWorld.matrix =
      glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, -100, 0, 1));
  ASSERT_TRUE(checkRigid(pose.probeToWorld.matrix).has_value());
  const Hold tilted = holdFor(pose, skin);
  EXPECT_TRUE(rigid(tilted));
  EXPECT_NEAR(std::abs(tilted.tilt_rad), kMaxTip_rad, 1e-9);
  EXPECT_LT(glm::length(axisOf(poseOf(tilted), 0) - glm::dvec3(-1, 0, 0)), 1e-9) << "the lateral axis is kept";
}

class FarSphere final : public Skin {
 public:
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3&, const glm::dvec3&) const override { return std::nullopt; }
  [[nodiscard]] Contact nearest(const glm::dvec3& p) const override {
    const glm::dvec3 n = glm::normalize(p - kCentre_mm);
    return {kCentre_mm + 100.0 * n, n};
  }
  static constexpr glm::dvec3 kCentre_mm{1e6, -1e6, 1e6};
};

TEST(TrackingHardCases, FarFromTheOriginTheContactStaysOnTheSkin) {
  const FarSphere skin;
  Hold hold;
  hold.contact = skin.nearest(FarSphere::kCentre_mm + glm::dvec3(0.0, -1.0, 0.0));
  hold = slid(hold, skin, 50.0, 20.0);
  EXPECT_NEAR(glm::distance(hold.contact.point_mm, FarSphere::kCentre_mm), 100.0, 1e-6);
  EXPECT_TRUE(rigid(hold));
}

}  // namespace
}  // namespace ew::tracking_test
