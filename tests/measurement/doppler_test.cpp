#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ew/measurement/worksheet.h"
#include "measurement/packages.h"

namespace ew::measurement::doppler_test {
namespace {

using nlohmann::json;
using test::shipped;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

WorksheetEntry velocity(const std::string& label, double value_cmPerS, const std::string& side = {}, double angle_deg = -1.0) {
  WorksheetEntry entry{label, side, {value_cmPerS, 0.0, Unit::cmPerS}, {}, false};
  if (angle_deg >= 0.0) entry.angle_rad = radians(angle_deg);
  return entry;
}

Worksheet filled(const char* package, const WorksheetInput& input) {
  auto sheet = fillWorksheet(shipped(package), input);
  EXPECT_TRUE(sheet) << sheet.error();
  return sheet ? std::move(*sheet) : Worksheet{};
}

double valueOf(const Worksheet& sheet, const char* label, const char* side = "") {
  const WorksheetRow* row = sheet.row(label, side);
  return row != nullptr && row->value ? row->value->value : std::nan("");
}

// The numbers stand in the project's collection of facts, section 10.
TEST(Vascular, GivesTheIndicesOfOneSpectrum) {
  const auto sheet =
      filled("vascular", {{velocity("ICA_PSV", 80, "left"), velocity("ICA_EDV", 20, "left"), velocity("ICA_TAMX", 40, "left")}});
  EXPECT_DOUBLE_EQ(valueOf(sheet, "ICA_RI", "left"), 0.75);
  EXPECT_DOUBLE_EQ(valueOf(sheet, "ICA_SD", "left"), 4.0);
  EXPECT_DOUBLE_EQ(valueOf(sheet, "ICA_PI", "left"), 1.5);
  EXPECT_EQ(sheet.row("ICA_RI", "right"), nullptr);
}

TEST(Vascular, TellsReversedFlowByAnIndexAboveOneAndNoRatio) {
  const auto sheet = filled("vascular", {{velocity("CCA_PSV", 80, "left"), velocity("CCA_EDV", -10, "left")}});
  EXPECT_DOUBLE_EQ(valueOf(sheet, "CCA_RI", "left"), 1.125);
  EXPECT_TRUE(std::isnan(valueOf(sheet, "CCA_SD", "left")));
  EXPECT_FALSE(sheet.row("CCA_SD", "left")->remarks.empty());
}

TEST(Vascular, ComputesVolumeFlowOfARoundAndOfAnEllipticLumen) {
  const WorksheetEntry wide{"CCA_D", "left", {6.2, 0.0, Unit::mm}, {}, false}, narrow{"CCA_D2", "left", {5.0, 0.0, Unit::mm}, {}, false};
  const auto sheet = filled("vascular", {{velocity("CCA_TAMEAN", 22.9, "left"), wide, narrow}});
  EXPECT_NEAR(valueOf(sheet, "CCA_FLOW", "left"), 415.0, 0.5);
  EXPECT_NEAR(valueOf(sheet, "CCA_FLOW_ELLIPSE", "left"), valueOf(sheet, "CCA_FLOW", "left") * 5.0 / 6.2, 1e-9);
  EXPECT_EQ(sheet.row("CCA_FLOW", "left")->value->unit, Unit::mlPerMinute);
  ASSERT_EQ(sheet.row("CCA_FLOW", "left")->ranges.size(), 2u);
}

TEST(Vascular, ComparesKidneysWithTheAortaAndWithEachOther) {
  const auto sheet =
      filled("vascular", {{velocity("RENAL_PSV", 280, "right"), velocity("AORTA_PSV", 80), velocity("SEG_PSV", 100, "right"),
                           velocity("SEG_EDV", 30, "right"), velocity("SEG_PSV", 100, "left"), velocity("SEG_EDV", 38, "left")}});
  EXPECT_DOUBLE_EQ(valueOf(sheet, "RENAL_AORTA", "right"), 3.5);
  EXPECT_NEAR(valueOf(sheet, "SEG_RI_DIFFERENCE"), 0.08, 1e-12);
  EXPECT_EQ(sheet.row("SEG_RI_DIFFERENCE")->ranges.front().verdict, RangeVerdict::above);
}

TEST(Vascular, ReadsAccelerationAndPressureInTheirUnits) {
  const WorksheetEntry time{"SEG_AT", "left", {0.1, 0.0, Unit::s}, {}, false};
  const auto sheet = filled("vascular", {{time, velocity("SEG_FIRST", 45, "left"), velocity("SEG_FOOT", 15, "left"),
                                          velocity("STENOSIS_PSV", 300, "left"), velocity("PROXIMAL_PSV", 100, "left")}});
  EXPECT_NEAR(valueOf(sheet, "SEG_AI", "left"), 300.0, 1e-9);
  EXPECT_NEAR(valueOf(sheet, "PRESSURE_DROP", "left"), 36.0, 1e-9);
  EXPECT_NEAR(valueOf(sheet, "PRESSURE_DROP_FULL", "left"), 32.0, 1e-9);
  EXPECT_NEAR(valueOf(sheet, "LEG_RATIO", "left"), 3.0, 1e-12);
}

TEST(AngleCorrection, MakesAVelocityAsUncertainAsTheTangentSays) {
  EXPECT_NEAR(relativeErrorOfAngle(radians(60), radians(3)), 0.0907, 5e-5);
  EXPECT_EQ(relativeErrorOfAngle(0.0, radians(3)), 0.0);
  // By hand: v(theta + d) / v(theta) - 1 for a small d.
  const double small = 1e-6, there = radians(50);
  EXPECT_NEAR(relativeErrorOfAngle(there, small), std::cos(there) / std::cos(there + small) - 1.0, 1e-11);
  const auto sheet = filled("vascular", {{velocity("ICA_PSV", 200, "left", 60)}});
  EXPECT_NEAR(sheet.row("ICA_PSV", "left")->value->uncertainty, 200 * 0.0907, 0.01);
  const auto careful = filled("vascular", {{velocity("ICA_PSV", 200, "left", 60)}, Several::mean, {}, radians(1)});
  EXPECT_NEAR(careful.row("ICA_PSV", "left")->value->uncertainty, 200 * 0.0907 / 3.0, 0.01);
}

TEST(AngleCorrection, LeavesIndicesOfOneSpectrumAloneButNotRatiosOfTwo) {
  const auto sheet = filled("vascular", {{velocity("ICA_PSV", 200, "left", 60), velocity("ICA_EDV", 50, "left", 60),
                                          velocity("ICA_TAMX", 80, "left", 60), velocity("CCA_PSV", 80, "left", 45)}});
  for (const char* index : {"ICA_RI", "ICA_PI", "ICA_SD"}) EXPECT_EQ(sheet.row(index, "left")->value->uncertainty, 0.0) << index;
  const double expected = 2.5 * std::hypot(relativeErrorOfAngle(radians(60), radians(3)), relativeErrorOfAngle(radians(45), radians(3)));
  EXPECT_NEAR(sheet.row("ICA_CCA", "left")->value->uncertainty, expected, 1e-6);
}

TEST(AngleCorrection, OfReversedFlowIsWrongTheOtherWay) {
  const auto sheet = filled("vascular", {{velocity("CCA_PSV", 80, "left", 60), velocity("CCA_EDV", -10, "left", 60)}});
  EXPECT_NEAR(sheet.row("CCA_RI", "left")->value->uncertainty, 0.0, 1e-8);
}

TEST(AngleCorrection, BeyondSixtyDegreesIsRemarkedOn) {
  EXPECT_TRUE(filled("vascular", {{velocity("ICA_PSV", 92, "left", 60)}}).row("ICA_PSV", "left")->remarks.empty());
  const auto steep = filled("vascular", {{velocity("ICA_PSV", 92, "left", 67)}});
  ASSERT_EQ(steep.row("ICA_PSV", "left")->remarks.size(), 1u);
  EXPECT_EQ(steep.row("ICA_PSV", "left")->remarks.front().english(),
            "ICA_PSV was read at 67 degrees; beyond 60 degrees a small error of the angle is a large one of the velocity.");
  EXPECT_TRUE(steep.row("ICA_PSV", "left")->value);
}

TEST(AngleCorrection, IsOfVelocitiesAloneAndBelowARightAngle) {
  WorksheetEntry width{"CCA_D", "left", {6.2, 0.0, Unit::mm}, {}, false};
  width.angle_rad = 0.5;
  const auto diameter = fillWorksheet(shipped("vascular"), {{width}});
  ASSERT_FALSE(diameter);
  EXPECT_EQ(diameter.error().sentence(), "CCA_D is no velocity; leave its angle out.");
  for (const double wrong_deg : {90.0, 120.0}) {
    const auto right = fillWorksheet(shipped("vascular"), {{velocity("ICA_PSV", 90, "left", wrong_deg)}});
    ASSERT_FALSE(right);
    EXPECT_EQ(right.error().sentence(), "The angle of ICA_PSV has to lie from 0 to below 90 degrees.");
  }
}

TEST(FetalDoppler, ReadsTheUmbilicalArteryByThePercentilesOfItsWeek) {
  for (const auto& [psv, percentile] : {std::pair{50.3, 50.0}, std::pair{53.2, 95.0}, std::pair{47.8, 5.0}}) {
    // PSV - EDV over a mean of 10 cm/s: 1.03, 1.32, 0.78 with 40 cm/s at the end of diastole.
    const auto sheet =
        filled("fetal_doppler", {{velocity("UA_PSV", psv), velocity("UA_EDV", 40), velocity("UA_TAMX", 10)}, Several::mean, 28.0});
    ASSERT_EQ(sheet.row("UA_PI")->charts.size(), 1u);
    EXPECT_NEAR(sheet.row("UA_PI")->charts.front().percentile, percentile, 1e-6);
  }
  const auto chart = shipped("fetal_doppler").charts.front();
  EXPECT_NEAR(valueAt(chart, 30.0, 0.0), 0.5 * (1.03 + 0.96), 1e-12);
  EXPECT_NEAR(valueAt(chart, 40.0, zOfPercentile(95.0)), 1.12, 1e-9);
  for (const double percentile : {1.0, 20.0, 50.0, 80.0, 99.0})
    EXPECT_NEAR(percentileOf(zScore(chart, 33.3, valueAt(chart, 33.3, zOfPercentile(percentile)))), percentile, 1e-6);
}

TEST(FetalDoppler, TakesTheMedianOfTheWeekByDates) {
  const auto sheet = filled("fetal_doppler", {{velocity("MCA_PSV", 36.5)}, Several::mean, 28.0});
  EXPECT_NEAR(valueOf(sheet, "MCA_MOM"), 1.0, 0.001);
  EXPECT_NEAR(valueOf(filled("fetal_doppler", {{velocity("MCA_PSV", 1.5 * std::exp(2.31 + 0.046 * 28))}, Several::mean, 28.0}), "MCA_MOM"),
              1.5, 1e-12);
  const auto undated = filled("fetal_doppler", {{velocity("MCA_PSV", 36.5)}});
  ASSERT_NE(undated.row("MCA_MOM"), nullptr);
  EXPECT_FALSE(undated.row("MCA_MOM")->value);
  EXPECT_EQ(undated.row("MCA_MOM")->remarks.front().english(), "MCA_MOM needs the gestational age by dates.");
  const auto early = filled("fetal_doppler", {{velocity("MCA_PSV", 20)}, Several::mean, 12.0});
  EXPECT_FALSE(early.row("MCA_MOM")->value);
}

TEST(FetalDoppler, DividesTheIndicesOfBrainAndCord) {
  const auto sheet = filled("fetal_doppler", {{velocity("MCA_PSV", 50), velocity("MCA_EDV", 14), velocity("MCA_TAMX", 20),
                                               velocity("UA_PSV", 50), velocity("UA_EDV", 40), velocity("UA_TAMX", 10)}});
  EXPECT_NEAR(valueOf(sheet, "CPR"), 1.8, 1e-12);
}

TEST(Tables, ThatDoNotRiseOrDoNotCoverTheirWeeksAreRefused) {
  const json whole = test::document("fetal_doppler");
  const auto sentence = [&](const char* change) {
    const auto read = packageFromJson(whole.patch(json::parse(change)), "x", verbatim("x.json"));
    return read ? std::string("read") : read.error().sentence();
  };
  EXPECT_NE(sentence(R"([{"op": "replace", "path": "/charts/0/table/rows/1/weeks", "value": 23}])").find("it must be weeks that rise"),
            std::string::npos);
  EXPECT_NE(sentence(R"([{"op": "replace", "path": "/charts/0/table/rows/1/low", "value": 1.2}])").find("it must be weeks that rise"),
            std::string::npos);
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/charts/0/valid_weeks", "value": [20, 40]}])"),
            "'charts[0].valid_weeks' in x.json is [20,40]; it must be within the weeks of the table.");
  EXPECT_EQ(sentence(R"([{"op": "add", "path": "/charts/0/median", "value": "GA"}])"),
            "'charts[0].median' in x.json is \"GA\"; it must be left out of a chart with \"table\".");
  EXPECT_NE(sentence(R"([{"op": "replace", "path": "/charts/0/table/rows/1/high", "value": 1.33}])").find("which the chart gives"),
            std::string::npos);
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/items/0/label", "value": "GA"}])"),
            "'items[0].label' in x.json is \"GA\"; it must be a label that no other entry has.");
  EXPECT_EQ(sentence(R"([{"op": "replace", "path": "/items/0/unit", "value": "mm"}])"),
            "'items[0].unit' in x.json is \"mm\"; it must be mm/s or cm/s.");
}

}  // namespace
}  // namespace ew::measurement::doppler_test
