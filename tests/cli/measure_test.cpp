#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "places.h"

namespace ew::test::measure_test {
namespace {

using nlohmann::json;

class MeasureCommand : public ::testing::Test {
 protected:
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};
  const TemporaryFolder folder_;
  const std::vector<std::string> biometry_{"measure",        "--package", "obstetric",     "--value", "BPD=82mm", "--value",
                                           "HC=30.0+-0.2cm", "--value",   "AC=280 ± 3 mm", "--value", "FL=62mm"};
  std::vector<std::string> with(std::vector<std::string> more) const {
    auto words = biometry_;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST_F(MeasureCommand, ListsThePackagesWithTheirItems) {
  const auto outcome = run({"measure", "--packages"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* id :
       {"abdomen (version ", "bladder (version ", "obstetric (version ", "thyroid (version ", "trauma (version ", "vessel (version "})
    EXPECT_NE(outcome.out.find(id), std::string::npos) << id;
  EXPECT_NE(outcome.out.find("KIDNEY_L/right|left, cm: Kidney, length"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("RUQ = seen|not_seen|not_adequate"), std::string::npos);
  EXPECT_NE(run({"measure", "--packages", "--language", "de"}).out.find("Fetale Biometrie"), std::string::npos);
}

TEST_F(MeasureCommand, PrintsAWorksheet) {
  const auto outcome = run(with({"--gestation", "32w1d"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("training only"), std::string::npos);
  EXPECT_NE(outcome.out.find("EFW_HADLOCK_BPD_HC_AC_FL"), std::string::npos);
  EXPECT_NE(outcome.out.find("1939"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("percentile"), std::string::npos);
  EXPECT_NE(outcome.out.find("so the dates stay."), std::string::npos);
}

TEST_F(MeasureCommand, WritesPagesToPrint) {
  const auto outcome = run(with({"--gestation", "32w1d", "--pdf", folder_ / "w.pdf", "--quiet"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(readText(folder_ / "w.pdf").starts_with("%PDF-"));
  const auto other = run(with({"--pdf", folder_ / "w.txt"}));
  EXPECT_NE(other.status, 0);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"w.pdf"});
}

TEST_F(MeasureCommand, WritesJsonCsvAndAReport) {
  const auto outcome = run(
      with({"--gestation", "32w1d", "--json", folder_ / "w.json", "--csv", folder_ / "w.csv", "--report", folder_ / "r.json", "--quiet"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"r.json", "w.csv", "w.json"}));
  const json sheet = readJson(folder_ / "w.json");
  EXPECT_EQ(sheet["package"], "obstetric");
  EXPECT_EQ(sheet["gestation_by_dates"], "32w1d");
  EXPECT_TRUE(readText(folder_ / "w.csv").starts_with("section,label,"));
  const json report = readJson(folder_ / "r.json");
  EXPECT_EQ(report["command"], "measure");
  EXPECT_EQ(report["quality"]["measurements"], 4);
  EXPECT_GE(report["quality"]["results"].get<int>(), 20);
  EXPECT_EQ(report["outputs"], (json{folder_ / "w.json", folder_ / "w.csv"}));
}

TEST_F(MeasureCommand, RefusesAUnitMixUpAndLeavesNothingBehind) {
  const auto outcome = run({"measure", "--package", "obstetric", "--value", "BPD=82cm", "--json", folder_ / "w.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "echoweave: BPD of 82 cm cannot be right: it lies from 1 cm to 12 cm; check the value and its unit.\n");
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(MeasureCommand, SaysWhatIsWrongWithTheLine) {
  const auto error = [](const std::vector<std::string>& words) {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(error({"measure", "--value", "BPD=82mm"}),
            "echoweave: Name a package with --package; 'echoweave measure --packages' lists those there are.\n");
  EXPECT_EQ(error({"measure", "--packages", "--package", "obstetric"}),
            "echoweave: --packages excludes --package; 'echoweave measure --help' shows how.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetric"}), "echoweave: Give at least one measurement, as in --value BPD=82mm.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetrics", "--value", "BPD=82mm"}),
            "echoweave: There is no measurement package 'obstetrics'; 'echoweave measure --packages' lists those there are.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetric", "--value", "BPD"}),
            "echoweave: --value BPD has no label; write it as in BPD=82mm.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetric", "--value", "BPD=82"}),
            "echoweave: --value BPD=82 has no unit; write it as in BPD=82mm.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetric", "--value", "BPD=about 82mm"}),
            "echoweave: --value BPD=about 82mm is not a number with its unit; write it as in BPD=82mm or BPD=82+-0.8mm.\n");
  EXPECT_EQ(error({"measure", "--package", "obstetric", "--value", "BPD=82mm", "--gestation", "32"}),
            "echoweave: --gestation '32' is no gestational age; write it as in 32w1d or 32+1, up to 45 weeks.\n");
  EXPECT_EQ(error({"measure", "--package", "trauma", "--value", "RUQ=maybe"}),
            "echoweave: RUQ is answered by one of seen, not_seen, not_adequate.\n");
}

TEST_F(MeasureCommand, TakesTheAngleOfAVelocity) {
  const auto outcome = run({"measure", "--package", "vascular", "--value", "ICA_PSV/left=200cm/s@67deg", "--value", "CCA_PSV/left=80cm/s"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("200 ± 25 cm/s"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("ICA_PSV was read at 67 degrees; beyond 60 degrees"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("2.50 ± 0.31"), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"measure", "--package", "vascular", "--value", "ICA_PSV/left=200cm/s@60"}).err,
            "echoweave: --value ICA_PSV/left=200cm/s@60 has no angle behind its @; write it as in ICA_PSV/left=200cm/s@60deg.\n");
}

TEST_F(MeasureCommand, TakesSidesSelectionsAndPackagesOfOnesOwn) {
  const auto stenosis = run({"measure", "--package", "vessel", "--value", "D_MIN/left=1.5+-0.2mm", "--value", "D_DISTAL/left=5mm"});
  EXPECT_EQ(stenosis.status, 0) << stenosis.err;
  EXPECT_NE(stenosis.out.find("NASCET/left"), std::string::npos);
  EXPECT_NE(stenosis.out.find("70.0 ± 4.0 %"), std::string::npos) << stenosis.out;
  EXPECT_NE(stenosis.out.find("; above the usual range, up to 50 % (less than moderate"), std::string::npos) << stenosis.out;
  const auto selected = run({"measure", "--package", std::string(EW_SOURCE_DIR) + "/resources/measurements/obstetric.json", "--several",
                             "selected", "--value", "*BPD=82mm", "--value", "BPD=90mm", "--csv", folder_ / "w.csv"});
  EXPECT_EQ(selected.status, 0) << selected.err;
  EXPECT_NE(readText(folder_ / "w.csv").find(",BPD,,Biparietal diameter,8.2,"), std::string::npos);
}

}  // namespace
}  // namespace ew::test::measure_test
