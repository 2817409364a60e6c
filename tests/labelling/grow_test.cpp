#include "ew/labelling/grow.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "counted_stop.h"
#include "ew/phantom/patient.h"
#include "labelling/support.h"
#include "places.h"

namespace ew::labelling {
namespace {

using test::emptyLabels;

/// Dark where `isIn`, bright elsewhere, with speckle: the amplitude of a complex normal scatter, log compressed to 60 dB.
template <class IsIn>
Volume speckled(const Grid& grid, double dark_db, const IsIn& isIn) {
  Volume echo;
  echo.grid = grid;
  echo.echo.resize(grid.voxelCount());
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const auto toFile = grid.voxelTo<frame::File>();
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double amplitude = std::hypot(normal(random), normal(random));
        const double level_db = 20.0 * std::log10(amplitude + 1e-6) + (isIn(carried(toFile, {i, j, k})) ? dark_db : 0.0);
        echo.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::clamp(140.0 + level_db * 255.0 / 60.0, 0.0, 255.0));
      }
  return echo;
}

GrowResult grown(Volume& labels, const Volume& echo, const glm::dvec3& seed_mm, const GrowOptions& options = {}) {
  const auto result = growFrom(labels, echo, echo.grid, seed_mm, options, {.label = 1}, noProgress());
  EXPECT_TRUE(result);
  return result ? *result : GrowResult{};
}

TEST(Grow, FindsADarkBallInSpeckle) {
  Volume labels = emptyLabels({80, 80, 80}, glm::dvec3(0.6), 0.3);
  const auto isIn = [](const glm::dvec3& p) { return glm::length(p) < 12.0; };
  const Volume echo = speckled(labels.grid, -14.0, isIn);
  const GrowResult result = grown(labels, echo, {2.0, -1.0, 0.5});
  ASSERT_EQ(result.stop, GrowStop::done);
  EXPECT_FALSE(result.touchesReach);
  EXPECT_NEAR(result.volume_ml, volume_ml(labels, 1), 1e-9);
  Volume truth = emptyLabels({80, 80, 80}, glm::dvec3(0.6), 0.3);
  const glm::dvec3 middle(0.0);
  paintBall(truth, {&middle, 1}, 12.0, {});
  const double overlap = test::dice(labels, 1, truth.echo, 1);
  std::cout << "[ figures  ] speckled ball: Dice " << overlap << "\n";
  EXPECT_GT(overlap, 0.9);
}

TEST(Grow, KeepsToAThinVesselBetweenBrightWalls) {
  // 5 mm wide, black, with walls of 0.9 mm, in muscle; on the other side of the muscle it is black again.
  const Volume empty = emptyLabels({100, 100, 80}, glm::dvec3(0.3));
  Volume labels = empty, echo = empty, truth = empty;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto toFile = empty.grid.voxelTo<frame::File>();
  for (std::size_t n = 0; n < echo.echo.size(); ++n) {
    const int i = static_cast<int>(n);
    const glm::dvec3 p = carried(toFile, {i % 100, i / 100 % 100, i / 10000});
    const double off_mm = std::hypot(p.x, p.y);
    truth.echo[n] = off_mm < 2.5 ? 1 : 0;
    const double level_db = off_mm < 2.5 ? -45.0 : off_mm < 3.4 ? 8.0 : off_mm < 11.0 ? -8.0 : -45.0;
    const double amplitude = std::hypot(normal(random), normal(random));
    echo.echo[n] =
        static_cast<std::uint8_t>(std::clamp(140.0 + (20.0 * std::log10(amplitude + 1e-6) + level_db) * 255.0 / 60.0, 0.0, 255.0));
  }
  for (const glm::dvec3& seed : {glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(0.8, -0.5, 4.0)}) {
    Volume own = labels;
    const GrowResult result = grown(own, echo, seed);
    ASSERT_EQ(result.stop, GrowStop::done);
    const double overlap = test::dice(own, 1, truth.echo, 1);
    std::cout << "[ figures  ] thin vessel: Dice " << overlap << ", " << result.volume_ml << " ml of " << volume_ml(truth, 1) << "\n";
    EXPECT_GT(overlap, 0.85);
  }
}

TEST(Grow, DoesNotLeakThroughAPassageNarrowerThanItsNeck) {
  Volume labels = emptyLabels({80, 50, 50}, glm::dvec3(0.6));
  const auto isDark = [](const glm::dvec3& p) {
    return glm::distance(p, {-11.0, 0.0, 0.0}) < 9.0 || glm::distance(p, {12.0, 0.0, 0.0}) < 10.0 ||
           (std::abs(p.x) < 12.0 && std::hypot(p.y, p.z) < 2.0);  // 4 mm wide
  };
  Volume echo = emptyLabels({80, 50, 50}, glm::dvec3(0.6));
  const auto toFile = echo.grid.voxelTo<frame::File>();
  for (std::size_t n = 0; n < echo.echo.size(); ++n) {
    const int i = static_cast<int>(n);
    echo.echo[n] = isDark(carried(toFile, {i % 80, i / 80 % 50, i / 4000})) ? 40 : 130;
  }
  Volume both = labels;
  const GrowOptions narrow{.smoothing_mm = 0.0, .edge_levelsPerMm = 0.0, .neck_mm = 4.5};
  GrowOptions wide = narrow;
  wide.neck_mm = 0.0;
  ASSERT_EQ(grown(labels, echo, {-11.0, 0.0, 0.0}, narrow).stop, GrowStop::done);
  ASSERT_EQ(grown(both, echo, {-11.0, 0.0, 0.0}, wide).stop, GrowStop::done);
  const double one_ml = 4.0 / 3.0 * std::numbers::pi * 0.729, other_ml = 4.0 / 3.0 * std::numbers::pi;
  EXPECT_NEAR(volume_ml(labels, 1), one_ml, 0.06 * one_ml);
  EXPECT_GT(volume_ml(both, 1), one_ml + 0.9 * other_ml);
}

TEST(Grow, KeepsToItsBandOnASlopeThatIsNoEdge) {
  Volume labels = emptyLabels({60, 20, 20}, glm::dvec3(1.0));
  Volume echo = labels;
  const auto toFile = echo.grid.voxelTo<frame::File>();
  const auto xOf = [&](std::size_t n) { return carried(toFile, {static_cast<int>(n) % 60, 0, 0}).x; };
  for (std::size_t n = 0; n < echo.echo.size(); ++n) echo.echo[n] = static_cast<std::uint8_t>(std::lround(100.0 + xOf(n)));
  const GrowResult result = grown(labels, echo, {0.5, 0.5, 0.5}, {.smoothing_mm = 0.0, .neck_mm = 0.0});
  ASSERT_EQ(result.stop, GrowStop::done);
  EXPECT_NEAR(result.lowest_level, 92.5, 1.0);  // 8 levels about the seed's
  EXPECT_NEAR(result.highest_level, 108.5, 1.0);
  double lowest_mm = 0.0, highest_mm = 0.0;
  for (std::size_t n = 0; n < labels.echo.size(); ++n) {
    if (labels.echo[n] == 0) continue;
    lowest_mm = std::min(lowest_mm, xOf(n));
    highest_mm = std::max(highest_mm, xOf(n));
  }
  EXPECT_NEAR(lowest_mm, -7.5, 1.5);
  EXPECT_NEAR(highest_mm, 8.5, 1.5);
}

TEST(Grow, SaysThatItWasALeakAndLabelsNothing) {
  Volume labels = emptyLabels({60, 60, 60}, glm::dvec3(1.0));
  Volume echo = labels;
  std::fill(echo.echo.begin(), echo.echo.end(), std::uint8_t{90});
  const GrowResult result = grown(labels, echo, {0.0, 0.0, 0.0}, {.largest_ml = 20.0});
  EXPECT_EQ(result.stop, GrowStop::tooLarge);
  EXPECT_GE(result.volume_ml, 20.0);
  EXPECT_EQ(voxelsOf(labels, 1), 0u);
  EXPECT_TRUE(result.changed.empty());
}

TEST(Grow, StopsAtItsReachAndSaysSo) {
  Volume labels = emptyLabels({60, 60, 60}, glm::dvec3(1.0));
  Volume echo = labels;
  std::fill(echo.echo.begin(), echo.echo.end(), std::uint8_t{90});
  const GrowResult result = grown(labels, echo, {0.0, 0.0, 0.0}, {.reach_mm = 10.0});
  EXPECT_EQ(result.stop, GrowStop::done);
  EXPECT_TRUE(result.touchesReach);
  EXPECT_NEAR(result.volume_ml, 4.0 / 3.0 * std::numbers::pi, 0.35);
}

TEST(Grow, HasNothingToBeginWithOutsideOfTheEchoes) {
  Volume labels = emptyLabels({30, 30, 30}, glm::dvec3(1.0));
  Volume echo = labels;
  echo.coverage.assign(echo.echo.size(), static_cast<std::uint8_t>(Coverage::absent));
  EXPECT_EQ(grown(labels, echo, {0.0, 0.0, 0.0}).stop, GrowStop::nothing);
  EXPECT_EQ(grown(labels, echo, {500.0, 0.0, 0.0}).stop, GrowStop::nothing);
}

TEST(Grow, ChangesNothingWhenItIsCancelledAtAnyMoment) {
  Volume labels = emptyLabels({40, 40, 40}, glm::dvec3(1.0));
  Volume echo = labels;
  std::fill(echo.echo.begin(), echo.echo.end(), std::uint8_t{90});
  auto counted = ew::test::CountedStop::never();
  Volume whole = labels;
  ASSERT_TRUE(growFrom(whole, echo, echo.grid, {0.0, 0.0, 0.0}, {}, {.label = 1}, counted));
  ASSERT_GT(counted.questions(), 100) << "a large step without a question would keep the user waiting";
  for (long question = 1; question < counted.questions(); question += 17) {
    auto stop = ew::test::CountedStop::atQuestion(question);
    const auto result = growFrom(labels, echo, echo.grid, {0.0, 0.0, 0.0}, {}, {.label = 1}, stop);
    ASSERT_FALSE(result) << question;
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_EQ(voxelsOf(labels, 1), 0u) << question;
  }
}

/// A virtual patient of a shipped case as voxels with speckle; the labels are the truth.
struct Truth {
  Volume echo, labels;
  std::vector<OrganName> organs;
};
Truth truthOf(const std::string& id, double spacing_mm) {
  const auto patient = readPatient(std::filesystem::path(EW_SOURCE_DIR) / "cases" / id / "patient.json");
  EXPECT_TRUE(patient) << id;
  auto made = voxelise(**patient, {.spacing_mm = spacing_mm}, noProgress());
  EXPECT_TRUE(made) << id;
  Truth truth{std::move(made->volume), {}, organsOf(**patient)};
  truth.labels = {truth.echo.grid, std::move(made->labels), {}};
  return truth;
}

/// The voxel of a label that lies deepest in it, of the labels' grid: where a person would point.
glm::dvec3 deepIn(const Volume& labels, std::uint8_t label) {
  Volume left = labels;
  const VoxelBox box = boxOf(labels, label);
  glm::ivec3 last = box.first;
  for (bool any = true; any;) {
    any = false;
    const std::vector<std::uint8_t> now = left.echo;
    for (int k = box.first.z; k < box.end.z; ++k)
      for (int j = box.first.y; j < box.end.y; ++j)
        for (int i = box.first.x; i < box.end.x; ++i) {
          const std::size_t at = labels.grid.indexOf(i, j, k);
          if (now[at] != label) continue;
          bool isInner = true;
          for (const glm::ivec3& to : {glm::ivec3(i - 1, j, k), glm::ivec3(i + 1, j, k), glm::ivec3(i, j - 1, k), glm::ivec3(i, j + 1, k),
                                       glm::ivec3(i, j, k - 1), glm::ivec3(i, j, k + 1)})
            isInner = isInner && labels.grid.contains(to) && now[labels.grid.indexOf(to.x, to.y, to.z)] == label;
          last = {i, j, k};
          if (isInner)
            any = true;
          else
            left.echo[at] = 0;
        }
  }
  return carried(labels.grid.voxelToWorld(), glm::dvec3(last));
}

/// One organ of a shipped case, grown from one click in its middle.
struct Organ {
  const char* name;
  double least;  ///< Dice
  GrowOptions options = {};
};
void expectGrown(const Truth& truth, const Organ& organ) {
  const auto found = std::find_if(truth.organs.begin(), truth.organs.end(), [&](const OrganName& each) { return each.name == organ.name; });
  ASSERT_NE(found, truth.organs.end()) << organ.name;
  const auto label = static_cast<std::uint8_t>(found->label);
  Volume labels{truth.labels.grid, std::vector<std::uint8_t>(truth.labels.echo.size(), 0), {}};
  const glm::dvec3 seed_mm = deepIn(truth.labels, label);
  const GrowResult result = grown(labels, truth.echo, seed_mm, organ.options);
  // What lies beyond the reach cannot be found, and is not asked for.
  std::vector<std::uint8_t> within = truth.labels.echo;
  const auto toFile = truth.labels.grid.voxelTo<frame::File>();
  const glm::ivec3 dims = truth.labels.grid.dims;
  for (std::size_t n = 0; n < within.size(); ++n) {
    const int at = static_cast<int>(n);
    if (within[n] == label &&
        glm::distance(carried(toFile, {at % dims.x, at / dims.x % dims.y, at / dims.x / dims.y}), seed_mm) > organ.options.reach_mm)
      within[n] = 0;
  }
  const double overlap = test::dice(labels, 1, within, label);
  std::cout << "[ figures  ] " << organ.name << ": Dice " << overlap << ", " << result.volume_ml << " ml of "
            << volume_ml(truth.labels, label) << " ml, band " << result.lowest_level << ".." << result.highest_level
            << (result.touchesReach ? ", goes on" : "") << "\n";
  EXPECT_EQ(result.stop, GrowStop::done) << organ.name;
  EXPECT_GT(overlap, organ.least) << organ.name;
}

TEST(Grow, FindsOrgansOfAVirtualPatientWhoseLabelsAreTheTruth) {
  const Truth abdomen = truthOf("upper-abdomen-gall-stone", 1.2);
  // The gall bladder is 8 cm long and is pointed at where it is widest.
  expectGrown(abdomen, {"gall bladder lumen", 0.9, {.reach_mm = 80.0}});
  expectGrown(abdomen, {"inferior vena cava", 0.8, {.reach_mm = 40.0}});
  expectGrown(abdomen, {"aorta", 0.8, {.reach_mm = 40.0}});
  expectGrown(abdomen, {"gall stone", 0.85});
  // A kidney's border to the liver has hardly any contrast: that it would run out is said, and nothing is labelled.
  Volume labels{abdomen.labels.grid, std::vector<std::uint8_t>(abdomen.labels.echo.size(), 0), {}};
  const auto kidney =
      std::find_if(abdomen.organs.begin(), abdomen.organs.end(), [](const OrganName& each) { return each.name == "right kidney"; });
  ASSERT_NE(kidney, abdomen.organs.end());
  const glm::dvec3 seed_mm = deepIn(abdomen.labels, static_cast<std::uint8_t>(kidney->label));
  EXPECT_EQ(grown(labels, abdomen.echo, seed_mm, {.reach_mm = 80.0, .largest_ml = 150.0}).stop, GrowStop::tooLarge);
  EXPECT_EQ(voxelsOf(labels, 1), 0u);
}

}  // namespace
}  // namespace ew::labelling
