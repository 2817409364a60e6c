#include "ew/phantom/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "recipes.h"

namespace ew::flow_test {
namespace {

constexpr double kOfMlPerMin = 1000.0 / 60.0;  // mm^3/s

constexpr const char* kTubes =
    R"({"name": "trunk", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, -30, 3], [0, 0, -10, 3], [0, 0, 0, 3]]}}},
       {"name": "left branch", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, 0, 2.4], [6, 0, 10, 2.4], [10, 0, 30, 2.4]]}}},
       {"name": "right branch", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, 0, 1.9], [-6, 0, 10, 1.9], [-10, 0, 30, 1.9]]}}},
       {"name": "stone", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 20, 0], "radii_mm": [3, 3, 3]}}})";
constexpr const char* kPulse =
    R"("motion": {"pulse": {"beats_per_minute": 60, "vessels": [{"of": "trunk", "diameter_growth_mm": 0}]}, "breathing": {"displacement_mm": [0, 0, -5]}},)";
constexpr const char* kWaves =
    R"("waves": [{"name": "calm", "samples": [0.8, 1.6, 1.2, 0.8, 0.6]}, {"name": "steep", "samples": [0.2, 3, 1, 0.4, 0.4]}],)";

Result<std::shared_ptr<const Patient>> patientWith(const std::string& flow, const std::string& motion = kPulse) {
  return testing::patientOf(testing::patientRecipe(kTubes, motion + R"("flow": {)" + flow + "},"));
}

std::shared_ptr<const Patient> forked(const std::string& ofTrunk = "", const std::string& ofLeft = "") {
  auto patient = patientWith(std::string(kWaves) + R"("streams": [
      {"name": "trunk", "of": "trunk", "feeds": ["left", "right"], "pulse_wave_m_per_s": 6, "delay_s": 0.05)" +
                             ofTrunk + R"(},
      {"name": "left", "of": "left branch", "flow_ml_per_min": 240, "wave": "calm", "pulse_wave_m_per_s": 8)" +
                             ofLeft + R"(},
      {"name": "right", "of": "right branch", "flow_ml_per_min": 120, "wave": "steep"}])");
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

std::string fieldOf(const std::string& flow, const std::string& motion = kPulse) {
  const auto patient = patientWith(flow, motion);
  if (patient) return "read";
  const auto& context = patient.error().context;
  const auto found = std::find_if(context.begin(), context.end(), [](const auto& each) { return each.first == "field"; });
  return found == context.end() ? patient.error().sentence() : found->second;
}

TEST(Flow, IsNoneWhereTheRecipeSaysNothing) {
  const auto patient = testing::patientOf(testing::patientRecipe(kTubes));
  ASSERT_TRUE(patient) << patient.error();
  EXPECT_TRUE(flowOf(**patient).streams.empty());
}

TEST(Flow, CarriesThroughAForkWhatGoesOnInItsBranchesAtEveryMoment) {
  const auto patient = forked();
  const FlowTruth truth(flowOf(*patient));
  ASSERT_EQ(truth.field().streams.size(), 3u);
  for (const double time_s : {0.0, 0.13, 0.31, 0.77, 5.2}) {
    const double trunk = truth.flowThrough_mm3PerS(0, 30.0, time_s);
    EXPECT_NEAR(trunk, truth.flowThrough_mm3PerS(1, 0.0, time_s) + truth.flowThrough_mm3PerS(2, 0.0, time_s), 1e-6);
  }
  EXPECT_NEAR(truth.field().streams[1].delay_s, 0.05 + 0.030 / 6.0, 1e-6) << "the wave has run along the trunk";
  const auto waveform = waveformNear(truth, 0, {0.0, 0.0, -15.0});
  ASSERT_TRUE(waveform);
  EXPECT_NEAR(waveform->flow_mm3PerS / kOfMlPerMin, 360.0, 0.01);
  EXPECT_NEAR(waveform->timeAverageMean_mmPerS * std::numbers::pi * 9.0, waveform->flow_mm3PerS, 0.1);
  EXPECT_GT(waveform->resistiveIndex(), 0.5);
  EXPECT_GT(waveform->pulsatilityIndex().value_or(0.0), waveform->resistiveIndex());
}

TEST(Flow, CarriesTheBreathOfWhatItFeedsThroughSeveralForks) {
  const auto patient = patientWith(R"("streams": [
      {"name": "trunk", "of": "trunk", "to_mm": [0, 0, -10], "feeds": ["middle"]},
      {"name": "middle", "of": "trunk", "from_mm": [0, 0, -10], "feeds": ["left", "right"]},
      {"name": "left", "of": "left branch", "flow_ml_per_min": 240, "breath": 0.3},
      {"name": "right", "of": "right branch", "flow_ml_per_min": 120, "breath": 0.3}])");
  ASSERT_TRUE(patient) << patient.error();
  const FlowTruth truth(flowOf(**patient));
  for (const double time_s : {0.0, 0.7, 1.4, 3.0})
    EXPECT_NEAR(truth.flowThrough_mm3PerS(0, 0.0, time_s),
                truth.flowThrough_mm3PerS(2, 0.0, time_s) + truth.flowThrough_mm3PerS(3, 0.0, time_s), 1e-6);
  EXPECT_GT(truth.flowThrough_mm3PerS(0, 0.0, 1.4), 1.2 * truth.flowThrough_mm3PerS(0, 0.0, 0.0));
}

TEST(Flow, RunsFromTheOnePlaceToTheOther) {
  const auto patient = patientWith(R"("streams": [
      {"name": "down", "of": "trunk", "from_mm": [0, 1, -5], "to_mm": [0, 0, -25], "flow_ml_per_min": 300}])");
  ASSERT_TRUE(patient) << patient.error();
  const FlowTruth truth(flowOf(**patient));
  EXPECT_LT(truth.at({0.0, 0.0, -15.0}, 0.0).mean_mmPerS.z, 0.0);
  EXPECT_EQ(truth.at({0.0, 0.0, -3.0}, 0.0).stream, -1) << "before its beginning";
  EXPECT_EQ(truth.at({0.0, 0.0, -27.0}, 0.0).stream, -1);
}

TEST(Flow, StenosisIsAsFastAsContinuityMakesIt) {
  const auto patient = forked("", R"(, "stenosis": {"at_mm": [8.6, 0, 20], "length_mm": 6, "diameter_lost": 0.5})");
  ASSERT_EQ(stenosesOf(*patient).size(), 1u);
  const TrueStenosis& stenosis = stenosesOf(*patient).front();
  EXPECT_EQ(stenosis.stream, 1);
  EXPECT_EQ(stenosis.diameterLost, 0.5);
  EXPECT_EQ(stenosis.diameterLostToFlow, 0.5);
  const FlowTruth truth(flowOf(*patient));
  const auto throat = waveformNear(truth, 1, stenosis.at_mm), before = waveformNear(truth, 1, {2.0, 0.0, 4.0});
  ASSERT_TRUE(throat && before);
  EXPECT_NEAR(throat->radius_mm, 1.2, 0.01);
  EXPECT_NEAR(throat->timeAverageMean_mmPerS / before->timeAverageMean_mmPerS, 4.0, 0.06);
  EXPECT_NEAR(throat->peakSystolic_mmPerS, stenosis.peak_mmPerS, 0.02 * stenosis.peak_mmPerS);
}

TEST(Flow, StenosisHasTheVelocityThatIsGivenAndNamesBothDiameters) {
  const auto patient = forked("", R"(, "stenosis": {"at_mm": [8.6, 0, 20], "length_mm": 6, "diameter_lost": 0.6, "peak_cm_per_s": 150})");
  const TrueStenosis& stenosis = stenosesOf(*patient).front();
  EXPECT_EQ(stenosis.diameterLost, 0.6);
  EXPECT_NE(stenosis.diameterLostToFlow, 0.6);
  EXPECT_NEAR(stenosis.peak_mmPerS, 1500.0, 1e-6);
  const auto throat = waveformNear(FlowTruth(flowOf(*patient)), 1, stenosis.at_mm);
  ASSERT_TRUE(throat);
  EXPECT_NEAR(throat->peakSystolic_mmPerS, 1500.0, 30.0);
  EXPECT_NEAR(throat->radius_mm / 2.4, 1.0 - stenosis.diameterLostToFlow, 0.005);
}

TEST(Flow, StenosisKeepsItsWordWhenItIsSlightAndWhenItIsSevere) {
  for (const double lost : {0.0, 0.05, 0.3, 0.95}) {
    const auto patient =
        forked("", R"(, "stenosis": {"at_mm": [8.6, 0, 20], "length_mm": 9, "diameter_lost": )" + std::to_string(lost) + "}");
    const TrueStenosis& stenosis = stenosesOf(*patient).front();
    const auto throat = waveformNear(FlowTruth(flowOf(*patient)), 1, stenosis.at_mm);
    ASSERT_TRUE(throat);
    EXPECT_NEAR(throat->radius_mm, 2.4 * (1.0 - lost), 1e-3) << lost;
    EXPECT_NEAR(throat->peakSystolic_mmPerS, stenosis.peak_mmPerS, 0.005 * stenosis.peak_mmPerS) << lost;
  }
}

TEST(Flow, LetsTheJetGoTheWayTheBloodGoes) {
  const std::string narrow = R"(, "stenosis": {"at_mm": [0, 0, -15], "length_mm": 4, "diameter_lost": 0.6}})";
  for (const double flow : {300.0, -300.0}) {
    const auto patient =
        patientWith(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": )" + std::to_string(flow) + narrow + "]");
    ASSERT_TRUE(patient) << patient.error();
    const FlowTruth truth(flowOf(**patient));
    const double sign = flow < 0.0 ? -1.0 : 1.0;
    const auto axisAt = [&](double past_mm) { return std::abs(truth.at({0.0, 0.0, -15.0 + sign * past_mm}, 0.0).mean_mmPerS.z); };
    EXPECT_GT(axisAt(5.0), 1.5 * axisAt(-5.0)) << "fast behind the throat";
  }
}

TEST(Flow, GoesThroughATreeByMurray) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "liver", "tissue": "dark", "shape": {"of": "outline"}})",
      R"("shapes": [{"name": "outline", "ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [35, 30, 35]}}, {"name": "veins", "vessel_tree": {"within": "outline", "trunks": [{"points": [[0, 0, -30], [0, 0, 5]]}],
        "ends": 40, "end_radius_mm": 0.8}}], "flow": {"streams": [{"name": "veins", "of": "veins", "way": "to the roots", "flow_ml_per_min": 900}]},)"));
  if (!patient) GTEST_FAIL() << patient.error();
  const FlowField& field = flowOf(**patient);
  ASSERT_GT(field.streams.size(), 40u);
  double ends = 0.0;
  for (const FlowStream& stream : field.streams) {
    EXPECT_LT(stream.flow_mm3PerS, 0.0) << "towards the roots";
    const bool goesOn = std::any_of(field.streams.begin(), field.streams.end(), [&](const FlowStream& other) {
      return glm::distance(other.line.front().place_mm, stream.line.back().place_mm) < 1e-9;
    });
    if (!goesOn) ends += stream.flow_mm3PerS;
  }
  EXPECT_NEAR(ends / kOfMlPerMin, -900.0, 1e-6) << "what enters at the ends leaves at the root";
  // By the cubes of the radii at every fork.
  int forks = 0;
  for (const FlowStream& parent : field.streams) {
    std::vector<const FlowStream*> branches;
    for (const FlowStream& other : field.streams)
      if (glm::distance(other.line.front().place_mm, parent.line.back().place_mm) < 1e-9) branches.push_back(&other);
    if (branches.size() != 2) continue;
    ++forks;
    const auto cube = [](const FlowStream& stream) { return std::pow(stream.line.back().radius_mm, 3.0); };
    EXPECT_NEAR(branches[0]->flow_mm3PerS / branches[1]->flow_mm3PerS, cube(*branches[0]) / cube(*branches[1]), 1e-9);
  }
  EXPECT_GT(forks, 20);
}

TEST(Flow, SaysWhichFieldIsWrong) {
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "stone", "flow_ml_per_min": 1}])"), "flow.streams[0] (a).of");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "nothing", "flow_ml_per_min": 1}])"), "flow.streams[0] (a).of");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk"}])"), "flow.streams[0] (a).flow_ml_per_min");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 1, "wave": "none"}])"), "flow.streams[0] (a).wave");
  EXPECT_EQ(fieldOf(std::string(kWaves) + R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 1, "wave": "calm"}])", ""),
            "flow.streams[0] (a).wave")
      << "there is no pulse";
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 1, "from_mm": [9, 0, 0]}])"),
            "flow.streams[0] (a).from_mm");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "feeds": ["b"]}, {"name": "b", "of": "left branch", "feeds": ["a"]}])"),
            "flow.streams[0] (a).feeds");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "feeds": ["c"]}])"), "flow.streams[0] (a).feeds");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "feeds": ["b"], "flow_ml_per_min": 3},
                                   {"name": "b", "of": "left branch", "flow_ml_per_min": 3}])"),
            "flow.streams[0] (a).flow_ml_per_min");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 400,
                                    "stenosis": {"at_mm": [0, 0, -10], "diameter_lost": 0.5, "peak_cm_per_s": 3}}])"),
            "flow.streams[0] (a).stenosis.peak_cm_per_s")
      << "slower than the open vessel";
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "right branch", "feeds": ["b"]},
                                   {"name": "b", "of": "left branch", "flow_ml_per_min": 3}])"),
            "flow.streams[0] (a).feeds")
      << "they do not meet";
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "feeds": ["b", "c"]},
                                   {"name": "b", "of": "left branch", "flow_ml_per_min": 3, "breath": 0.2},
                                   {"name": "c", "of": "right branch", "flow_ml_per_min": 3}])"),
            "flow.streams[2] (c).breath");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 3, "pulse_wave_m_per_s": 0.001}])"),
            "flow.streams[0] (a).pulse_wave_m_per_s");
  EXPECT_EQ(fieldOf(R"("streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 400,
                                    "stenosis": {"at_mm": [0, 0, -10], "diameter_lost": 0.5, "shift_mm": [0, 2, 0]}}])"),
            "flow.streams[0] (a).stenosis.shift_mm");
  EXPECT_EQ(
      fieldOf(R"("waves": [{"name": "w", "samples": [1, -1, 1, -1]}], "streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 1}])"),
      "flow.waves[0] (w)");
  EXPECT_EQ(
      fieldOf(R"("waves": [{"name": "w", "harmonics": [[1, 0, 3]]}], "streams": [{"name": "a", "of": "trunk", "flow_ml_per_min": 1}])"),
      "flow.waves[0] (w).harmonics[0]");
}

}  // namespace
}  // namespace ew::flow_test
