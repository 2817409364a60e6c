#include "bench/images/bench_echoes.h"

#include <cmath>

#include "bench/images/echo_subject.h"
#include "cli/bench_run.h"

namespace ew::test::bench_echoes_test {
namespace {

using nlohmann::json;

/// A block of tissue of one known level, with a brighter and a sparser part, below the plane y = 0.
void writeBlock(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const json everything = {{"ellipsoid", {{"centre_mm", {0, 2000, 0}}, {"radii_mm", {2000, 2000, 2000}}}}};
  writeText((folder / "block.json").string(), json{{"format", 1}, {"name", "block"}, {"body", everything}}.dump());
  const auto ball = [](const char* name, const char* tissue, std::array<double, 3> centre_mm, double radius_mm) {
    return json{{"name", name},
                {"tissue", tissue},
                {"shape", {{"ellipsoid", {{"centre_mm", centre_mm}, {"radii_mm", {radius_mm, radius_mm, 20.0}}}}}}};
  };
  const json recipe = {{"format", 1},
                       {"name", "block"},
                       {"mannequin", "block.json"},
                       {"box", {{"lowest_mm", {-34, -4, -12}}, {"highest_mm", {34, 60, 12}}}},
                       {"tissues",
                        {{{"name", "even"}, {"echo_level", 150}, {"speckle", 1}},
                         {{"name", "brighter"}, {"echo_level", 175.5}, {"speckle", 1}},
                         {{"name", "sparse"}, {"echo_level", 150}, {"speckle", 1}, {"scatterers_per_mm3", 0.5}}}},
                       {"background", "even"},
                       {"organs", {ball("ball", "brighter", {-14.0, 20.0, 0.0}, 5.0), ball("grit", "sparse", {14.0, 30.0, 0.0}, 5.0)}}};
  writeText((folder / "patient.json").string(), recipe.dump());
  const json manifest = {
      {"format", 1},
      {"id", "block"},
      {"title", "Block"},
      {"region", "none"},
      {"patient", {{"name", "A. Block"}, {"sex", "female"}, {"age_years", 40}}},
      {"history", "None."},
      {"indication", "None."},
      {"diagnosis", "Even."},
      {"volume",
       {{"recipe", "patient.json"}, {"recipe_spacing_mm", 1.0}, {"file_to_world", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}},
      {"probes", {"linear-7.5"}},
      {"scene", {{"live_echoes", true}, {"attenuation", {{"expected_db_per_cm_mhz", 0.5}}}}},
      {"start_pose", {1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1}}};
  writeText((folder / "case.json").string(), manifest.dump());
}

class BenchEchoes : public BenchRun<BenchEchoes> {
 public:
  static std::vector<std::string> command() {
    static const TemporaryFolder folder;
    static const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
    writeBlock(folder.path() / "block");
    return {"bench", "echoes", "--case", folder / "block", "--poses", "3", "--timed", "5", "--frame", "160x128"};
  }
};

TEST_F(BenchEchoes, ComparesEveryQualityAndPrintsItsColumns) {
  ASSERT_EQ(quality()["results"].size(), 3u);
  ASSERT_EQ(quality()["totals"].size(), 3u);
  for (const char* name : {"fast", "default", "fine"}) {
    const json found = row({{"quality", name}});
    EXPECT_GT(found["patches"].get<int>(), 20) << name;
    EXPECT_LT(found["even_patches"].get<int>(), found["patches"].get<int>()) << "sparse tissue is no developed speckle";
    for (const char* figure : {"level_db", "level_p95_db", "level_floor_p95_db", "snr_live", "snr_forward", "axial_off_percent",
                               "lateral_off_percent", "decorrelation_off", "one_thread_ms", "two_threads_ms", "two_p99_ms", "forward_ms"})
      EXPECT_TRUE(found[figure].is_number()) << name << " " << figure;
    EXPECT_EQ(found["decorrelation"].size(), 10u) << "four rotations, three shifts, three slides";
    EXPECT_TRUE(found["shadow_db"].is_null()) << "nothing reflects";
  }
  for (const char* column : {"block/fast", "the worst, default", "by chance", "SNR", "axial", "lateral", "views", "shadow", "two threads"})
    EXPECT_NE(said().find(column), std::string::npos) << column << "\n" << said();
  EXPECT_NE(page().find("Live echoes against the forward model"), std::string::npos);
  expectOnItsOwn(page());
}

TEST_F(BenchEchoes, FindsTheLevelOfAKnownTissueAtEveryDepthAndPrice) {
  for (const json& found : quality()["results"]) {
    EXPECT_NEAR(found["level_db"].get<double>(), 0.0, 0.6) << found["name"];
    for (const json& band : found["level_bands_db"]) {
      if (!band.is_number()) continue;
      EXPECT_NEAR(band.get<double>(), 0.0, 1.0) << found["name"];
    }
  }
}

TEST_F(BenchEchoes, FindsTheGrainAndTheViewsOfTheForwardModel) {
  const json found = row({{"quality", "default"}});
  EXPECT_NEAR(found["snr_off_percent"].get<double>(), 0.0, 5.0);
  EXPECT_NEAR(found["axial_off_percent"].get<double>(), 0.0, 15.0);
  EXPECT_NEAR(found["lateral_off_percent"].get<double>(), 0.0, 15.0);
  double last = 1.0;
  for (const json& view : found["decorrelation"]) {
    EXPECT_NEAR(view["live"].get<double>(), view["forward"].get<double>(), 0.08) << view;
    if (view["motion"] != "elevation, mm") continue;
    EXPECT_LT(view["live"].get<double>(), last);
    last = view["live"].get<double>();
  }
}

TEST(BenchEchoesOptions, AreRefusedOutsideTheirRangeAndForCasesThatAreNotDrawn) {
  EXPECT_EQ(runBench({"bench", "echoes", "--poses", "0"}).status, 2);
  EXPECT_EQ(runBench({"bench", "echoes", "--timed", "4"}).status, 2);
  const auto recorded = runBench({"bench", "echoes", "--case", "liver-sweep-recorded"});
  EXPECT_EQ(recorded.status, 2);
  EXPECT_NE(recorded.err.find("is not drawn"), std::string::npos) << recorded.err;
}

}  // namespace
}  // namespace ew::test::bench_echoes_test
