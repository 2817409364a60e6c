#include "ew/scanning/contact.h"

#include <gtest/gtest.h>

#include "scanning/small_scan.h"
#include "tracking/skins.h"

namespace ew::contact_test {

TEST(SkinContact, GapsAreDistancesAlongTheSkinsNormal) {
  // The plane's outside is +z, so the probe looks along -z; one end is lifted by the lean.
  Pose pose;
  pose.probeToWorld.matrix[1] = {0.0, 0.0, -1.0, 0.0};
  pose.probeToWorld.matrix[2] = {0.0, 1.0, 0.0, 0.0};
  pose.probeToWorld.matrix[3] = {5.0, -3.0, 2.5, 1.0};
  const auto gaps_mm = gapsToSkin_mm(test::smallProbe(), pose, test::PlaneSkin());
  ASSERT_EQ(gaps_mm.size(), 17U);
  for (const float gap_mm : gaps_mm) EXPECT_FLOAT_EQ(gap_mm, 2.5F);
  EXPECT_EQ(contactShare(gaps_mm), 1.0) << "gel fills 3 mm";
  pose.probeToWorld.matrix[3].z = -1.0;
  for (const float gap_mm : gapsToSkin_mm(test::smallProbe(), pose, test::PlaneSkin())) EXPECT_FLOAT_EQ(gap_mm, -1.0F);
}

TEST(SkinContact, TheShareCountsWhatGelDoesNotFill) {
  EXPECT_EQ(contactShare({}), 1.0);
  EXPECT_EQ(contactShare({0.0F, 3.0F, 3.1F, 50.0F}), 0.5);
}

TEST(SkinContact, ACurvedFaceIsPressedOnAsFarAsItsEndsLieBack) {
  EXPECT_EQ(usualPress_mm(test::smallProbe()), 1.0);
  Probe convex;
  convex.kind = ProbeKind::convex;
  convex.radius_mm = 60.0;
  convex.halfAngle_rad = 31.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(usualPress_mm(convex), 1.0 + 0.8 * 60.0 * (1.0 - std::cos(convex.halfAngle_rad)), 1e-9);
  convex.radius_mm = 300.0;
  EXPECT_EQ(usualPress_mm(convex), kMaxPress_mm);
}

}  // namespace ew::contact_test
