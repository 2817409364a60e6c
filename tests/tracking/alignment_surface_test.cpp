#include <gtest/gtest.h>

#include <algorithm>

#include "ew/library/body_skin.h"
#include "ew/tracking/alignment.h"
#include "made_hands.h"
#include "places.h"
#include "skins.h"

namespace ew::alignment_surface_test {
namespace {

using test::Dice;

const Skin& adultSkin() {
  static const std::shared_ptr<const Skin> skin = [] {
    auto read = readBodySkin(std::filesystem::path(EW_SOURCE_DIR) / "resources" / "mannequin" / "adult.json");
    if (!read) throw std::runtime_error(read.error().sentence());
    return *read;
  }();
  return *skin;
}

/// The face's places while a probe goes up and down over the front and both flanks.
std::vector<glm::dvec3> tracedOver(const Skin& skin, Dice& dice, int count, double halfAngle_rad, double noise_mm) {
  std::vector<glm::dvec3> traced;
  for (int n = 0; n < count; ++n) {
    const double share = static_cast<double>(n) / count, angle = halfAngle_rad * std::sin(40.0 * share);
    const glm::dvec3 from(400.0 * std::sin(angle), -400.0 * std::cos(angle), 180.0 - 480.0 * share);
    traced.push_back(skin.nearest({0.35 * from.x, 0.25 * from.y, from.z}).point_mm + dice.normal3(noise_mm));
  }
  return traced;
}

std::vector<glm::dvec3> seenBy(const Transform<frame::World, frame::Tracker>& truth, const std::vector<glm::dvec3>& world) {
  std::vector<glm::dvec3> tracker;
  for (const glm::dvec3& p : world) tracker.push_back(carried(rigidInverse(truth), p));
  return tracker;
}

/// How far an alignment is off at the xiphoid.
double offAt(const Transform<frame::World, frame::Tracker>& found, const Transform<frame::World, frame::Tracker>& truth) {
  const glm::dvec3 target(0.0, -108.0, 4.0);
  return glm::distance(carried(found * rigidInverse(truth), target), target);
}

Transform<frame::World, frame::Tracker> beside(const Transform<frame::World, frame::Tracker>& truth, Dice& dice, double shift_mm,
                                               double turn_rad) {
  Transform<frame::World, frame::World> by{glm::mat4_cast(glm::angleAxis(turn_rad, dice.direction()))};
  by.matrix[3] = glm::dvec4(shift_mm * dice.direction(), 1.0);
  return by * truth;
}

TEST(SurfaceAlignment, ARoughStartBecomesExactOverATracedTrunk) {
  std::vector<double> before, after;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Dice dice(seed);
    const auto truth = test::anywhere<frame::World, frame::Tracker>(dice);
    const auto traced = seenBy(truth, tracedOver(adultSkin(), dice, 400, 1.5, 1.0));
    const auto start = beside(truth, dice, dice.between(5.0, 25.0), dice.between(0.02, 0.15));
    const auto found = alignBySurface(traced, adultSkin(), start);
    ASSERT_TRUE(found) << found.error();
    EXPECT_EQ(found->verdict, AlignmentVerdict::aligned) << found->sentence;
    before.push_back(offAt(start, truth));
    after.push_back(offAt(found->trackerToWorld, truth));
    EXPECT_LT(after.back(), 6.0) << "seed " << seed << " from " << before.back() << ": " << found->sentence;
    EXPECT_LT(found->rms_mm, 1.6);
  }
  std::sort(after.begin(), after.end());
  EXPECT_LT(after[after.size() / 2], 2.5);
  RecordProperty("median_um", static_cast<int>(1000.0 * after[after.size() / 2]));
  RecordProperty("worst_um", static_cast<int>(1000.0 * after.back()));
}

TEST(SurfaceAlignment, PointsInTheAirDoNotPullIt) {
  Dice dice(7);
  const auto truth = test::anywhere<frame::World, frame::Tracker>(dice);
  auto world = tracedOver(adultSkin(), dice, 400, 1.5, 0.5);
  for (std::size_t n = 0; n < world.size(); n += 8) world[n] += 40.0 * adultSkin().nearest(world[n]).outward;
  const auto found = alignBySurface(seenBy(truth, world), adultSkin(), beside(truth, dice, 10.0, 0.05));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, AlignmentVerdict::aligned) << found->sentence;
  EXPECT_LT(offAt(found->trackerToWorld, truth), 4.0);
}

TEST(SurfaceAlignment, NamesTheFreedomsThatThePointsLeaveAndKeepsThemAsTheyWere) {
  Dice dice(11);
  const test::CylinderSkin trunk(120.0);
  std::vector<glm::dvec3> world;
  for (int n = 0; n < 300; ++n) {
    const double angle = dice.between(-1.5, 1.5);
    world.emplace_back(120.0 * std::sin(angle), -120.0 * std::cos(angle), dice.between(-200.0, 200.0));
  }
  const auto truth = test::anywhere<frame::World, frame::Tracker>(dice);
  Transform<frame::World, frame::World> by;
  by.matrix[3] = {6.0, -5.0, 15.0, 1.0};
  const auto found = alignBySurface(seenBy(truth, world), trunk, by * truth);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->open.size(), 2u) << found->sentence;
  std::string open = found->open[0].english() + "; " + found->open[1].english();
  EXPECT_NE(open.find("towards the feet or the head"), std::string::npos) << open;
  EXPECT_NE(open.find("rolling onto one side"), std::string::npos) << open;
  // Across the trunk it was put right, along it the start stays.
  const glm::dvec3 left = carried(found->trackerToWorld * rigidInverse(truth), glm::dvec3(0.0));
  EXPECT_NEAR(left.x, 0.0, 0.1);
  EXPECT_NEAR(left.y, 0.0, 0.1);
  EXPECT_NEAR(left.z, 15.0, 0.1);
}

TEST(SurfaceAlignment, AnotherBodyIsRefused) {
  Dice dice(13);
  const auto truth = test::anywhere<frame::World, frame::Tracker>(dice);
  std::vector<glm::dvec3> world;
  for (int n = 0; n < 300; ++n) world.emplace_back(dice.between(-200.0, 200.0), dice.between(-200.0, 0.0), dice.between(-300.0, 200.0));
  const auto found = alignBySurface(seenBy(truth, world), adultSkin(), truth);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, AlignmentVerdict::notAligned) << found->sentence;
  EXPECT_FALSE(alignBySurface(std::span(world).first(10), adultSkin(), truth));
  world[3].x = std::nan("");
  EXPECT_FALSE(alignBySurface(world, adultSkin(), truth));
}

}  // namespace
}  // namespace ew::alignment_surface_test
