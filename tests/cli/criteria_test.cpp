#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "ew/measurement/criteria.h"
#include "places.h"

namespace ew::test::criteria_command_test {
namespace {

using nlohmann::json;

class CriteriaCommand : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};

  static std::string error(std::vector<std::string> words) {
    words.insert(words.begin(), "criteria");
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    return outcome.err;
  }
};

TEST_F(CriteriaCommand, ListsCriteriaWithNameYearSourceAndWhatTheyTake) {
  const auto outcome = run({"criteria"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* part : {"carotid-sru-2003: SRU consensus (2003), Internal carotid artery (internal_carotid)\n", "Radiology 229:340",
                           "carotid-iac-2021: IAC (2021)", "10.1177/15443167241249241",
                           "  checked: ", "  --cca-psv, cm/s: ", "  --plaque, none|seen: Plaque\n", "  --gestation, weeks: "})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << outcome.out;
  EXPECT_EQ(outcome.out.find("--value"), std::string::npos) << "a shipped input has no option of its own";
  const auto german = run({"criteria", "--vessel", "leg_artery", "--language", "de"});
  EXPECT_NE(german.out.find("Beinarterien, Quotient"), std::string::npos) << german.out;
  EXPECT_EQ(german.out.find("carotid"), std::string::npos);
}

TEST_F(CriteriaCommand, GradesSideBySideAndSaysWhereTheyDiffer) {
  const auto outcome = run({"criteria", "--psv", "150", "--cca-psv", "90"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* part : {"Simulation, training only",
                           "IAC (2021): less than 50 %. Decisive: ", "SRU consensus (2003): 50 to 69 %. Decisive: ", "They differ: "})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << outcome.out;
  EXPECT_EQ(run({"criteria", "--psv", "200", "--cca-psv", "80"}).out.find("They differ"), std::string::npos);
  const auto german = run({"criteria", "--psv", "150", "--cca-psv", "90", "--language", "de"});
  EXPECT_NE(german.out.find("IAC (2021): unter 50 %. Ausschlaggebend: Systolische Spitzengeschwindigkeit 150,0 cm/s"), std::string::npos)
      << german.out;
  EXPECT_NE(german.out.find("Sie unterscheiden sich: "), std::string::npos) << german.out;
  const auto metres = run({"criteria", "--psv", "1500mm/s", "--cca-psv", "90+-5cm/s"});
  EXPECT_NE(metres.out.find("Ratio ICA/CCA 1.667 ± 0.093 (below 2)"), std::string::npos) << metres.out;
}

TEST_F(CriteriaCommand, WritesGradesAsJson) {
  const auto outcome = run({"criteria", "--pi", "1.4", "--gestation", "28+0", "--end-flow", "present", "--json", folder_ / "g.json",
                            "--report", folder_ / "r.json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json written = readJson(folder_ / "g.json");
  EXPECT_EQ(written["grades"][0]["grade"], "raised");
  EXPECT_EQ(written["grades"][0]["criteria"], "umbilical-pi");
  EXPECT_EQ(written["notice"], measurement::kTrainingOnly);
  EXPECT_EQ(readJson(folder_ / "r.json")["quality"]["graded"], 1);
}

TEST_F(CriteriaCommand, SaysWhatIsMissingAndTakesCriteriaOfOnesOwn) {
  const auto lonely = run({"criteria", "--vessel", "internal_carotid", "--psv", "100"});
  EXPECT_EQ(lonely.status, 0);
  EXPECT_NE(lonely.out.find("SRU consensus (2003) gives no grade: missing is Plaque; "), std::string::npos) << lonely.out;
  json own = readJson(std::string(EW_SOURCE_DIR) + "/resources/criteria/leg-ratio.json");
  own["inputs"][0]["name"] = own["formulas"][0]["inputs"][0] = "PEAK";
  own["formulas"][0]["expression"] = "PEAK/PROXIMAL_PSV";
  own["formulas"][0]["tests"][0]["inputs"] = {{"PEAK", 300}, {"PROXIMAL_PSV", 75}};
  own["tests"] = json::parse(R"([{"values": {"PEAK": 320, "PROXIMAL_PSV": 80}, "grade": "from_75_to_99"}])");
  writeText(folder_ / "own.json", own.dump());
  const auto graded = run({"criteria", "--criteria", folder_ / "own.json", "--value", "PEAK=300", "--proximal-psv", "80"});
  EXPECT_EQ(graded.status, 0) << graded.err;
  EXPECT_NE(graded.out.find("50 to 74 %"), std::string::npos) << graded.out;
}

TEST_F(CriteriaCommand, SaysWhatItCannotGrade) {
  EXPECT_EQ(error({"--psv", "100"}),
            "echoweave: These values fit criteria of several vessels; name one of internal_carotid, leg_artery, middle_cerebral_artery, "
            "renal_artery "
            "with --vessel.\n");
  EXPECT_EQ(error({"--psv", "100", "--pi", "1"}),
            "echoweave: No criteria take all these values together; 'echoweave criteria' lists what each takes.\n");
  EXPECT_EQ(error({"--psv", "fast", "--cca-psv", "90"}),
            "echoweave: --psv 'fast' cannot be read; write it as in 150, 150+-10cm/s or, of a gestational age, 28w0d.\n");
  EXPECT_EQ(error({"--criteria", "nobodys", "--psv", "100"}),
            "echoweave: There are no criteria 'nobodys'; 'echoweave criteria' lists those there are.\n");
  EXPECT_EQ(error({"--vessel", "tail"}),
            "echoweave: There are no criteria of 'tail'; 'echoweave criteria' lists the vessels in brackets.\n");
  EXPECT_EQ(error({"--value", "PSV"}), "echoweave: --value PSV has no name; write it as in PSV=150.\n");
  EXPECT_EQ(error({"--json", folder_ / "g.json"}), "echoweave: --json writes grades; give the values to grade, too.\n");
  const auto weeks = run({"criteria", "--pi", "1", "--gestation", "12w0d"});
  EXPECT_EQ(weeks.status, 1);
  EXPECT_NE(weeks.err.find("GA of 12 weeks cannot be graded"), std::string::npos) << weeks.err;
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace ew::test::criteria_command_test
