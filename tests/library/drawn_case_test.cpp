#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/library/case.h"
#include "ew/library/preparation.h"
#include "library/pipeline_fixture.h"

/// Cases with a recipe and no sweeps: maps of tissue and their motion, beside the volume.
namespace ew::drawn_case_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::opened;
using test::textOf;
using test::writeText;
using DrawnCase = test::CasePipeline;

/// The small case as a recipe without sweeps.
Case unswept(const fs::path& folder) {
  json manifest = json::parse(textOf(folder / "case.json"));
  manifest["volume"] = {{"recipe", "patient.json"}, {"recipe_spacing_mm", 2.0}};
  writeText(folder / "case.json", manifest.dump());
  return opened(folder);
}

TEST_F(DrawnCase, KeepsMapsOfTissueOfARecipeWithoutSweeps) {
  const auto swept = loadCaseVolume(opened(folder / "case"), noProgress());
  ASSERT_TRUE(swept && swept->tissue);
  EXPECT_TRUE(swept->tissue->isRecorded && swept->tissue->surfaces.empty()) << "of sweeps nothing is known but the level they show";
  const Case drawn = unswept(folder / "case");
  EXPECT_TRUE(caseNeedsPreparation(drawn));
  const auto made = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(made) << made.error();
  ASSERT_TRUE(made->tissue);
  EXPECT_FALSE(made->tissue->isRecorded);
  EXPECT_EQ(made->tissue->grid, made->volume.grid);
  const auto levelAt = [&](const glm::dvec3& p_mm) {
    const auto p = glm::ivec3(glm::round((made->tissue->grid.worldToVoxel() * Point<frame::World>{p_mm}).at));
    return static_cast<int>(made->tissue->level[made->tissue->grid.indexOf(p.x, p.y, p.z)]);
  };
  EXPECT_EQ(levelAt({0, -20, 0}), 20);
  EXPECT_EQ(levelAt({20, -20, 0}), 110);
  EXPECT_EQ(levelAt({66, 0, 0}), 0);
  EXPECT_FALSE(caseNeedsPreparation(drawn));
  const auto again = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(again) << again.error();
  EXPECT_TRUE(again->notes.empty());
  ASSERT_TRUE(again->tissue);
  EXPECT_EQ(*again->tissue, *made->tissue);
}

TEST_F(DrawnCase, KeepsHowTissueMovesAndMakesItAloneWhenItAloneIsMissing) {
  json patient = json::parse(textOf(folder / "case" / "patient.json"));
  patient["shapes"] = {{{"name", "vessel"}, {"tube", {{"points", {{0, 10, -40, 5}, {0, 12, 40, 6}}}}}}};
  patient["motion"] = {{"breathing", {{"displacement_mm", {0, 0, -5}}, {"held_depth_mm", 5}, {"free_depth_mm", 30}, {"tidal", 0.3}}},
                       {"pulse", {{"vessels", {{{"of", "vessel"}, {"diameter_growth_mm", 1}}}}}}};
  writeText(folder / "case" / "patient.json", patient.dump());
  Case drawn = unswept(folder / "case");
  drawn.volume.fileToWorld = {glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1})};
  const auto made = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(made) << made.error();
  ASSERT_TRUE(made->motion);
  ASSERT_EQ(made->motion->modes.size(), 2U);
  EXPECT_EQ(made->motion->rhythms.breathing->tidal, 0.3);
  EXPECT_EQ(made->motion->modes.front().grid.directions, made->volume.grid.directions) << "placed with the volume";
  const auto volumes = fs::last_write_time(folder / "cache/steps/volumes");
  for (const bool isRemoved : {false, true}) {
    if (isRemoved) fs::remove_all(folder / "cache/steps/motions");
    EXPECT_EQ(caseNeedsPreparation(drawn), isRemoved);
    const auto again = loadCaseVolume(drawn, noProgress());
    ASSERT_TRUE(again) << again.error();
    EXPECT_TRUE(again->notes.empty());
    ASSERT_TRUE(again->motion);
    EXPECT_EQ(*again->motion, *made->motion);
    EXPECT_EQ(*again->tissue, *made->tissue);
  }
  EXPECT_EQ(fs::last_write_time(folder / "cache/steps/volumes"), volumes) << "the volume was not made again";
  EXPECT_EQ(loadCaseVolume(unswept(folder / "case"), noProgress())->motion->modes.front().grid.directions, glm::dmat3(1.0));
}

/// The small case with a vessel through which blood flows.
void addBlood(const fs::path& folder, double flow_mlPerMin) {
  json patient = json::parse(textOf(folder / "patient.json"));
  patient["shapes"] = {{{"name", "vessel"}, {"tube", {{"points", {{0, 10, -40, 5}, {0, 12, 40, 6}}}}}}};
  patient["motion"] = {{"pulse", {{"vessels", {{{"of", "vessel"}, {"diameter_growth_mm", 1}}}}}}};
  patient["flow"] = {{"waves", {{{"name", "calm"}, {"samples", {1, 1.4, 1, 0.6}}}}},
                     {"streams",
                      {{{"name", "artery"},
                        {"of", "vessel"},
                        {"flow_ml_per_min", flow_mlPerMin},
                        {"wave", "calm"},
                        {"pulse_wave_m_per_s", 6},
                        {"stenosis", {{"at_mm", {0, 11, 0}}, {"diameter_lost", 0.5}}}}}}};
  writeText(folder / "patient.json", patient.dump());
}

TEST_F(DrawnCase, SaysHowBloodFlowsWhereTheVolumeLies) {
  addBlood(folder / "case", 300.0);
  Case drawn = unswept(folder / "case");
  const auto made = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(made) << made.error();
  ASSERT_TRUE(made->flow);
  ASSERT_EQ(made->flow->streams.size(), 1U);
  EXPECT_TRUE(made->flow->rhythms.pulse.has_value());
  drawn.volume.fileToWorld = {glm::dmat4({0, 0.6, 0.8, 0}, {-1, 0, 0, 0}, {0, -0.8, 0.6, 0}, {10, 20, 30, 1})};
  const auto moved = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(moved && moved->flow);
  const FlowTruth own(*made->flow), placed(*moved->flow);
  double fastest_mmPerS = 0.0;
  for (const glm::dvec3& p_mm : {glm::dvec3(1, 10, -30), glm::dvec3(0, 12, 3), glm::dvec3(2, 11, 20), glm::dvec3(0, 40, 0)})
    for (const double time_s : {0.0, 0.3, 1.7}) {
      const BloodVelocity here = own.at(p_mm, time_s);
      const BloodVelocity there = placed.at((drawn.volume.fileToWorld * Point<frame::File>{p_mm}).at, time_s);
      const glm::dvec3 turned_mmPerS = (drawn.volume.fileToWorld * Direction<frame::File>{here.mean_mmPerS}).along;
      EXPECT_LT(glm::distance(there.mean_mmPerS, turned_mmPerS), 1e-9 * (1.0 + glm::length(turned_mmPerS)));
      EXPECT_EQ(there.stream, here.stream);
      fastest_mmPerS = std::max(fastest_mmPerS, glm::length(here.mean_mmPerS));
    }
  EXPECT_GT(fastest_mmPerS, 100.0);
}

TEST_F(DrawnCase, TakesBloodFromTheRecipeAndMakesNothingForIt) {
  addBlood(folder / "case", 300.0);
  const Case drawn = unswept(folder / "case");
  const auto made = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(made && made->flow) << made.error();
  const auto again = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(again && again->flow);
  EXPECT_EQ(*again->flow, *made->flow);
  addBlood(folder / "case", 600.0);
  EXPECT_FALSE(caseNeedsPreparation(drawn));
  const auto faster = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(faster && faster->flow);
  EXPECT_EQ(faster->flow->streams.front().flow_mm3PerS, 2.0 * made->flow->streams.front().flow_mm3PerS);
  json patient = json::parse(textOf(folder / "case" / "patient.json"));
  patient["flow"]["streams"][0]["of"] = "nothing";
  writeText(folder / "case" / "patient.json", patient.dump());
  EXPECT_FALSE(loadCaseVolume(drawn, noProgress()));
  patient.erase("flow");
  writeText(folder / "case" / "patient.json", patient.dump());
  const auto without = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(without) << without.error();
  EXPECT_EQ(without->flow, nullptr);
}

TEST_F(DrawnCase, OfSweepsKnowsNoBlood) {
  addBlood(folder / "case", 300.0);
  const auto swept = loadCaseVolume(opened(folder / "case"), noProgress());
  ASSERT_TRUE(swept) << swept.error();
  EXPECT_EQ(swept->flow, nullptr);
}

TEST_F(DrawnCase, EstimatesTheTimeOfARecipeWithoutSweepsFromTheLast) {
  const Case drawn = unswept(folder / "case");
  EXPECT_FALSE(estimatePreparation(drawn)->measured);
  EXPECT_GT(estimatePreparation(drawn)->seconds, 0.0);
  ASSERT_TRUE(prepareCase(drawn, {}, noProgress()));
  EXPECT_EQ(estimatePreparation(drawn)->seconds, 0.0);
  Case finer = drawn;
  finer.volume.recipeSpacing_mm = 1.5;
  EXPECT_TRUE(estimatePreparation(finer)->measured);
}

TEST_F(DrawnCase, PlacesMapsOfTissueWithTheVolume) {
  Case drawn = unswept(folder / "case");
  drawn.volume.fileToWorld = {glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1})};
  const auto made = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(made) << made.error();
  ASSERT_TRUE(made->tissue);
  EXPECT_FALSE(made->tissue->isRecorded);
  EXPECT_EQ(made->tissue->grid, made->volume.grid);
}

TEST_F(DrawnCase, MakesDamagedMapsOfTissueAgain) {
  const Case drawn = unswept(folder / "case");
  const auto first = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(first) << first.error();
  int damaged = 0;
  for (const auto& entry : fs::directory_iterator(folder / "cache/steps/maps")) {
    if (!entry.is_regular_file() || fs::file_size(entry) == 0 || entry.path().extension() == ".lock") continue;
    const std::string kept = textOf(entry.path());
    std::string flipped = kept;
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
    writeText(entry.path(), flipped);
    const auto again = loadCaseVolume(drawn, noProgress());
    ASSERT_TRUE(again) << entry.path() << again.error();
    EXPECT_EQ(*again->tissue, *first->tissue) << entry.path();
    EXPECT_FALSE(again->notes.empty()) << entry.path();
    writeText(entry.path(), kept);
    ++damaged;
  }
  EXPECT_GE(damaged, 4) << "level, distance, kind and the surfaces";
  fs::remove_all(folder / "cache/steps/maps");
  EXPECT_TRUE(caseNeedsPreparation(drawn)) << "the volume alone is not enough: a cache of an earlier version";
  const auto again = loadCaseVolume(drawn, noProgress());
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again->tissue, *first->tissue);
  EXPECT_TRUE(again->notes.empty()) << "nothing was damaged";
}

}  // namespace
}  // namespace ew::drawn_case_test
