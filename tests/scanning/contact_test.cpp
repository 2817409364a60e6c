#include "ew/scanning/contact.h"

#include <gtest/gtest.h>

#include "ew/library/voxel_source.h"
#include "ew/scanning/recorded.h"
#include "ew/scanning/scanner.h"
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

TEST(SkinContact, CountsOnlyWhereThereIsSkinAndData) {
  EXPECT_EQ(contactShare({0.0F, 0.0F, 50.0F, 50.0F}, {true, false, true, false}), 0.25);
  EXPECT_EQ(contactShare({}, {}), 1.0);
  // The waves reach from -30 to 30 mm; the probe looks along y from their front, 40 mm wide, half of it beside them.
  const Recorded recorded(test::waveSubject());
  Pose pose;
  pose.probeToWorld.matrix[3] = {30.1, -30.0, 0.0, 1.0};
  const std::vector<bool> data = dataInFrontOf(recorded, test::smallProbe(), pose);
  ASSERT_EQ(data.size(), 17U);
  for (std::size_t n = 0; n < data.size(); ++n) EXPECT_EQ(data[n], n < 8) << n;
  EXPECT_NEAR(contactShare(std::vector<float>(17, 0.0F), data), 8.0 / 17.0, 1e-12);
  pose.probeToWorld.matrix[3].y = 31.0;
  for (const bool here : dataInFrontOf(recorded, test::smallProbe(), pose)) EXPECT_FALSE(here) << "the data lie behind it";
}

TEST(Recorded, IsWhereTheCoverageSaysSoWhereverTheVoxelsArePlaced) {
  auto volume = std::make_shared<Volume>(*test::waves());
  volume->coverage.assign(volume->echo.size(), static_cast<std::uint8_t>(Coverage::measured));
  for (int j = 20; j < 40; ++j)
    for (int i = 0; i < 40; ++i) volume->coverage[volume->grid.indexOf(i, j, 7)] = static_cast<std::uint8_t>(Coverage::absent);
  volume->echo.assign(volume->echo.size(), 0);  // black is data all the same
  ScanSubject subject = subjectOf(ScanVoxels::asStored(volume), "black");
  const auto centre = [&](int i, int j, int k) {
    return (subject.placedGrid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
  };
  EXPECT_TRUE(Recorded(subject).at(centre(3, 19, 7)));
  EXPECT_FALSE(Recorded(subject).at(centre(3, 20, 7)));
  EXPECT_TRUE(Recorded(subject).at(centre(3, 20, 8)));
  EXPECT_TRUE(Recorded(subject).at(centre(0, 0, 0)));
  EXPECT_FALSE(Recorded(subject).at(centre(-1, 0, 0)));
  EXPECT_FALSE(Recorded().at({0.0, 0.0, 0.0}));
  Transform<frame::World, frame::World> aside;
  aside.matrix[3] = {500.0, 0.0, 0.0, 1.0};
  subject.place(aside);
  EXPECT_FALSE(Recorded(subject).at(centre(3, 20, 7)));
  EXPECT_TRUE(Recorded(subject).at(centre(3, 19, 7)));
  EXPECT_FALSE(Recorded(subject).at({0.0, 0.0, 0.0}));

  // Nobody recorded a drawn patient: a face that is pressed into the skin brings tissue where none rests.
  auto maps = std::make_shared<TissueMaps>();
  maps->grid = volume->grid;
  maps->level.assign(volume->echo.size(), 100);
  subject.tissue = maps;
  EXPECT_TRUE(Recorded(subject).at(centre(3, 20, 7)));
  EXPECT_FALSE(Recorded(subject).at(centre(-1, 0, 0))) << "beyond the box nothing was drawn";
  auto recorded = std::make_shared<TissueMaps>(*maps);
  recorded->isRecorded = true;
  subject.tissue = recorded;
  EXPECT_FALSE(Recorded(subject).at(centre(3, 20, 7)));
}

TEST(Recorded, SkinIsCoveredAsFarAsThereAreDataInTheFirst40MmBelowIt) {
  const Recorded recorded(test::waveSubject());  // from -30 to 30 mm
  const std::vector<glm::vec3> points{{0, -30, 0}, {0, -50, 0}, {0, -31, 0}, {40, -30, 0}, {0, -29, 0}, {0, 200, 0}};
  const std::vector<glm::vec3> outward{{0, -1, 0}, {0, -1, 0}, {0, 1, 0}, {0, -1, 0}, {0, -1, 0}, {0, 1, 0}};
  const std::vector<float> shares = coverageOfSkin(recorded, points, outward);
  EXPECT_EQ(shares, (std::vector<float>{1.0F, 0.5F, 0.0F, 0.0F, 1.0F, 0.0F}));
}

TEST(Recorded, WhatAnImageDoesNotShowIsKnownPixelByPixelAndInDepth) {
  Scanner scanner(0);
  scanner.show(test::waveSubject());
  ScanState state;
  state.probe = test::smallProbe();
  state.knobs.depth_mm = 50.0;
  state.pose.probeToWorld.matrix[3] = {0.0, -10.0, 0.0, 1.0};
  static_cast<void>(scanner.make(state, 300, 240));
  const Recorded recorded(*scanner.subject());
  const RecordingGap part = unrecordedPart(recorded, scanner.geometry(), scanner.spans(), state.pose, 50.0, 2);
  ASSERT_EQ(part.columns, 150);
  ASSERT_EQ(part.rows, 120);
  ASSERT_TRUE(part.end_mm);
  EXPECT_NEAR(*part.end_mm, 40.0, 1.3) << "the far side of the voxels, half a voxel beyond their centres";
  EXPECT_NEAR(part.share, 0.2, 0.03);
  for (int row = 0; row < part.rows; ++row)
    for (int column = 0; column < part.columns; ++column) {
      const glm::dvec3 at = pointShownAt(scanner.geometry(), state.pose, {2.0 * column, 2.0 * row}).at;
      EXPECT_TRUE(part.outside[static_cast<std::size_t>(row * part.columns + column)] == 0 || at.y > 28.0) << row << ' ' << column;
    }
  state.pose.probeToWorld.matrix[3].y = -28.0;
  EXPECT_FALSE(unrecordedPart(recorded, scanner.geometry(), scanner.spans(), state.pose, 50.0, 2).end_mm);
  EXPECT_EQ(unrecordedPart(recorded, scanner.geometry(), scanner.spans(), state.pose, 50.0, 2).share, 0.0);
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
