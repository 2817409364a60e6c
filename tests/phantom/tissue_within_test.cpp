// A part of a patient's tissue is what the whole has there.
#include "ew/phantom/tissue_within.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "recipes.h"

namespace ew::tissue_within_test {
namespace {

using testing::Folder;
using testing::patientOf;

constexpr double kSpacing_mm = 0.8;
constexpr int kBlock = 4;  // voxels along each side of what is painted at once

std::string ball(const std::string& name, const glm::dvec3& centre_mm, const glm::dvec3& radii_mm, const std::string& more) {
  const auto three = [](const glm::dvec3& v) {
    return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
  };
  return R"({"name": ")" + name + R"(", )" + more + R"("shape": {"ellipsoid": {"centre_mm": )" + three(centre_mm) + R"(, "radii_mm": )" +
         three(radii_mm) + "}}}";
}

/// Organs of all sizes at random places: sheets, threads, grains smaller than a voxel, and some whose surface lies on the border of blocks.
std::string sceneOf(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() % 10001) / 10000.0; };
  const auto place = [&] { return glm::dvec3(between(-26, 26), between(-26, 26), between(-26, 26)); };
  const std::string tissues[] = {R"("tissue": "bright", )", R"("tissue": "dark", )", R"("tissue": "fat", )", R"("tissue": "grained", )"};
  const std::string borders[] = {"", R"("border": {"echo_level": 210, "width_mm": 1.2, "shine": "front"}, )",
                                 R"("border": {"echo_level": 190, "width_mm": 0.6}, )"};
  std::string organs;
  const auto add = [&](const std::string& organ) { organs += (organs.empty() ? "" : ", ") + organ; };
  int number = 0;
  const auto more = [&] { return tissues[random() % 4] + borders[random() % 3]; };
  const auto named = [&](const char* what) { return what + std::to_string(number++); };
  for (int n = 0; n < 4; ++n) add(ball(named("solid "), place(), {between(4, 12), between(4, 12), between(4, 12)}, more()));
  for (int n = 0; n < 3; ++n) add(ball(named("sheet "), place(), {between(8, 14), between(8, 14), 0.3}, more()));
  for (int n = 0; n < 3; ++n) add(ball(named("thread "), place(), {0.4, between(10, 20), 0.4}, more()));
  for (int n = 0; n < 4; ++n) add(ball(named("grain "), place(), glm::dvec3(0.05), more()));
  // Blocks begin at the lowest corner of the box.
  const double border_mm = -30.0 + kBlock * kSpacing_mm * 4.0;
  add(ball(named("touching "), {border_mm + 6.0, between(-10, 10), between(-10, 10)}, {6.0, 6.0, 6.0}, more()));
  add(ball(named("touching "), {border_mm - 0.5 * kSpacing_mm - 3.0, between(-20, 20), 0.0}, {3.0, 5.0, 5.0}, more()));
  return R"({"format": 1, "name": "test", "mannequin": "ball.json", "box": {"lowest_mm": [-30, -30, -30], "highest_mm": [30, 30, 30]},
    "tissues": [{"name": "even", "echo_level": 100, "speckle": 1, "impedance_mrayl": 1.63},
                {"name": "bright", "echo_level": 180, "speckle": 0.6, "impedance_mrayl": 1.7},
                {"name": "dark", "echo_level": 0, "speckle": 0, "impedance_mrayl": 1.52},
                {"name": "fat", "echo_level": 80, "speckle": 0.6, "impedance_mrayl": 1.38},
                {"name": "grained", "echo_level": 120, "speckle": 1, "texture": {"level": 20, "scale_mm": [4, 3, 5], "follows_the_skin": true}}],
    "background": "grained", "organs": [)" +
         organs + "]}";
}

std::shared_ptr<const Patient> patientIn(unsigned seed) {
  const Folder folder;
  // A body smaller than the box, so that its skin is seen.
  folder.write("ball.json", testing::bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [29, 27, 40]}})"));
  const auto patient = readPatient(folder.write("patient.json", sceneOf(seed)));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

VoxelPatient wholeOf(const Patient& patient) {
  auto made = voxelise(patient, {.spacing_mm = kSpacing_mm, .maps = true}, noProgress());
  if (!made) {
    ADD_FAILURE() << made.error();
    std::abort();
  }
  return std::move(*made);
}

VoxelBlocks blocksAt(const Patient& patient, const std::vector<Capsule>& capsules,
                     const std::vector<glm::dmat4>& places = {glm::dmat4(1.0)}) {
  auto blocks = voxelBlocksAt({capsules, places}, boxOf(patient), kSpacing_mm, 1.0, noProgress());
  if (!blocks || !*blocks) {
    ADD_FAILURE() << (blocks ? Error{} : blocks.error());
    std::abort();
  }
  return std::move(**blocks);
}

VoxelPatient partOf(const Patient& patient, const std::vector<Capsule>& capsules, int threads = 0) {
  auto made = tissueWithin(patient, blocksAt(patient, capsules), {.threads = threads}, noProgress());
  if (!made) {
    ADD_FAILURE() << made.error();
    std::abort();
  }
  return std::move(*made);
}

std::string surfaceAt(const TissueMaps& maps, std::size_t at) {
  return maps.surfaceKind[at] == 0 ? "" : maps.surfaces[maps.surfaceKind[at] - 1u].name;
}

class TissueWithin : public ::testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(RandomScenes, TissueWithin, ::testing::Range(1u, 7u));

TEST_P(TissueWithin, IsThatOfTheWholeInsideTheCapsulesAndNothingFarBesideThem) {
  const auto patient = patientIn(GetParam());
  const VoxelPatient whole = wholeOf(*patient);
  const std::vector<Capsule> capsules{{{-20.0, 3.0, -8.0}, {18.0, -6.0, 9.0}, 2.5}, {{4.0, 22.0, 4.0}, {4.0, 22.0, 4.0}, 3.0}};
  const VoxelPatient part = partOf(*patient, capsules);
  ASSERT_EQ(part.volume.grid, whole.maps->grid);
  const Grid& grid = part.volume.grid;
  std::size_t inside = 0, surfaces = 0, leftOut = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 p_mm = grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k);
        const std::size_t at = grid.indexOf(i, j, k);
        double beyond_mm = 1e9;
        for (const Capsule& each : capsules) beyond_mm = std::min(beyond_mm, distanceToLine_mm(each, p_mm) - each.radius_mm);
        if (beyond_mm <= 0.0) {
          ++inside;
          ASSERT_EQ(part.labels[at], whole.labels[at]) << i << " " << j << " " << k;
          ASSERT_EQ(part.maps->level[at], whole.maps->level[at]) << i << " " << j << " " << k;
          ASSERT_EQ(part.maps->surfaceDistance[at], whole.maps->surfaceDistance[at]) << i << " " << j << " " << k;
          ASSERT_EQ(surfaceAt(*part.maps, at), surfaceAt(*whole.maps, at)) << i << " " << j << " " << k;
          surfaces += part.maps->surfaceKind[at] != 0 ? 1 : 0;
        } else if (beyond_mm > TissueMaps::kSurfaceReach_mm + 2.0 * kSpacing_mm + 2.0 * kBlock * kSpacing_mm) {
          leftOut += whole.maps->level[at] != 0 ? 1 : 0;
          ASSERT_EQ(part.maps->level[at], 0) << i << " " << j << " " << k;
          ASSERT_EQ(part.labels[at], 0) << i << " " << j << " " << k;
        }
      }
  EXPECT_GT(inside, 1000u);
  EXPECT_GT(surfaces, 100u);
  EXPECT_GT(leftOut, 1000u);
}

TEST_P(TissueWithin, IsTheWholeWhereACapsuleHoldsAllOfIt) {
  const auto patient = patientIn(GetParam());
  const VoxelPatient whole = wholeOf(*patient);
  const VoxelPatient all = partOf(*patient, {{glm::dvec3(0.0), glm::dvec3(1.0), 100.0}});
  EXPECT_EQ(all.labels, whole.labels);
  EXPECT_TRUE(*all.maps == *whole.maps);
}

TEST(TissuePart, IsTheSameOnAnyNumberOfThreads) {
  const auto patient = patientIn(11);
  const std::vector<Capsule> capsules{{{-20.0, 3.0, -8.0}, {18.0, -6.0, 9.0}, 3.0}};
  const VoxelPatient one = partOf(*patient, capsules, 1);
  for (const int threads : {2, 5}) {
    const VoxelPatient several = partOf(*patient, capsules, threads);
    EXPECT_EQ(several.labels, one.labels) << threads;
    EXPECT_TRUE(*several.maps == *one.maps) << threads;
  }
}

TEST(TissuePart, SaysHowMuchOfThePatientItIs) {
  const auto patient = patientIn(12);
  const auto shareOf = [&](const std::vector<Capsule>& capsules) { return blocksAt(*patient, capsules).share; };
  EXPECT_EQ(shareOf({}), 0.0);
  EXPECT_EQ(shareOf({{glm::dvec3(0.0), glm::dvec3(0.0), 100.0}}), 1.0);
  // A ball of 1 mm, the reach of surfaces, and blocks that are met by half.
  const double ball_mm = 1.0 + TissueMaps::kSurfaceReach_mm + 2.0 * kSpacing_mm, met_mm = std::sqrt(3.0) * kBlock * kSpacing_mm;
  const auto ballShare = [](double radius_mm) { return 4.0 / 3.0 * std::numbers::pi * std::pow(radius_mm / 60.0, 3); };
  const double small = shareOf({{glm::dvec3(0.0), glm::dvec3(0.0), 1.0}});
  EXPECT_GT(small, ballShare(ball_mm));
  EXPECT_LT(small, ballShare(ball_mm + met_mm));
  const std::vector<Capsule> elsewhere{{glm::dvec3(500.0), glm::dvec3(600.0), 10.0}};
  EXPECT_EQ(shareOf(elsewhere), 0.0);
  const VoxelPatient nothing = partOf(*patient, elsewhere);
  EXPECT_EQ(nothing.labels, std::vector<std::uint8_t>(nothing.volume.grid.voxelCount(), 0));
}

TEST(TissuePart, IsLookedForFromEveryPlaceAndNoFurtherThanItIsWorth) {
  const auto patient = patientIn(12);
  const std::vector<Capsule> capsule{{glm::dvec3(0.0), {2.0, 0.0, 0.0}, 1.0}};
  const auto movedBy = [](const glm::dvec3& by_mm) {
    glm::dmat4 move(1.0);
    move[3] = glm::dvec4(by_mm, 1.0);
    return move;
  };
  const VoxelBlocks here = blocksAt(*patient, capsule), there = blocksAt(*patient, {{{0.0, 20.0, 0.0}, {2.0, 20.0, 0.0}, 1.0}});
  const VoxelBlocks both = blocksAt(*patient, capsule, {movedBy({0.0, 0.0, 0.0}), movedBy({0.0, 20.0, 0.0}), movedBy({0.0, 20.0, 0.0})});
  EXPECT_DOUBLE_EQ(both.share, here.share + there.share);
  const auto asNumbers = [](const std::vector<glm::ivec3>& first) {
    std::set<std::array<int, 3>> numbers;
    for (const glm::ivec3& each : first) numbers.insert({each.x, each.y, each.z});
    return numbers;
  };
  auto expected = asNumbers(here.first);
  expected.merge(asNumbers(there.first));
  EXPECT_EQ(asNumbers(both.first), expected);
  const auto tooMany = voxelBlocksAt({capsule, {glm::dmat4(1.0)}}, boxOf(*patient), kSpacing_mm, 0.5 * here.share, noProgress());
  ASSERT_TRUE(tooMany) << tooMany.error();
  EXPECT_FALSE(*tooMany);
}

TEST(TissuePart, IsRefusedAndStoppedAsTheWholeIs) {
  const auto patient = patientIn(13);
  const std::vector<Capsule> capsules{{glm::dvec3(0.0), glm::dvec3(0.0), 10.0}};
  const ViewPlaces seen{capsules, {glm::dmat4(1.0)}};
  const auto bad = voxelBlocksAt(seen, boxOf(*patient), 0.0, 1.0, noProgress());
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, ErrorCode::badField);
  const auto large = tissueWithin(*patient, blocksAt(*patient, capsules), {.maxBytes = 1000}, noProgress());
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::tooLarge);
  class Stop final : public Progress {
   public:
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } stop;
  const auto notLookedFor = voxelBlocksAt(seen, boxOf(*patient), kSpacing_mm, 1.0, stop);
  ASSERT_FALSE(notLookedFor);
  EXPECT_EQ(notLookedFor.error().code, ErrorCode::cancelled);
  const auto stopped = tissueWithin(*patient, blocksAt(*patient, capsules), {}, stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::tissue_within_test
