#include "ew/measurement/worksheet.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "ew/measurement/worksheet_line.h"
#include "measurement/packages.h"

namespace ew::measurement::worksheet_test {
namespace {

using nlohmann::json;
using test::shipped;

WorksheetEntry mm(const std::string& label, double value, double uncertainty = 0.0, const std::string& side = {}) {
  return {label, side, {value, uncertainty, Unit::mm}, {}, false};
}

WorksheetInput biometry(std::optional<double> weeks = 32.0 + 1.0 / 7.0) {
  return {{mm("BPD", 82, 0.8), mm("HC", 300, 2.0), mm("AC", 280, 3.0), mm("FL", 62, 0.6)}, Several::mean, weeks};
}

TEST(Worksheet, ComputesWhatItsMeasurementsAllowInTheUnitsOfTheFormulas) {
  const auto sheet = fillWorksheet(shipped("obstetric"), biometry());
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_NEAR(sheet->row("EFW_HADLOCK_BPD_HC_AC_FL")->value->value, 1938.920, 5e-4);
  EXPECT_NEAR(sheet->row("GA_BPD_HC_AC_FL")->value->value, 32.208, 5e-4);
  EXPECT_DOUBLE_EQ(sheet->row("BPD")->value->value, 8.2);
  EXPECT_EQ(sheet->row("GA_CRL_HADLOCK"), nullptr);
  EXPECT_EQ(sheet->row("CI"), nullptr);
  EXPECT_NEAR(sheet->row("EFW_HADLOCK_BPD_HC_AC_FL")->predictionError, 0.074 * 1938.920, 1e-3);
}

TEST(Worksheet, PropagatesUncertaintiesThroughTheFormula) {
  const auto sheet = fillWorksheet(shipped("obstetric"), biometry());
  ASSERT_TRUE(sheet);
  // 10.85 + 0.06 HC FL + 0.67 BPD + 0.168 AC, by hand.
  const double byHc = 0.06 * 6.2, byFl = 0.06 * 30.0, byBpd = 0.67, byAc = 0.168;
  const double expected =
      std::sqrt(std::pow(byHc * 0.2, 2) + std::pow(byFl * 0.06, 2) + std::pow(byBpd * 0.08, 2) + std::pow(byAc * 0.3, 2));
  EXPECT_NEAR(sheet->row("GA_BPD_HC_AC_FL")->value->uncertainty, expected, 1e-7);
}

TEST(Worksheet, ReadsTheSameInEveryPlaceThatShowsIt) {
  WorksheetInput input{{mm("KIDNEY_L", 100, 0.0, "right"), mm("KIDNEY_L", 104, 0.0, "right"), mm("AORTA", 33, 0.4)}, Several::mean, {}};
  const auto sheet = fillWorksheet(shipped("abdomen"), input);
  ASSERT_TRUE(sheet) << sheet.error();
  const auto kidney = lineOf(*sheet->row("KIDNEY_L", "right")), aorta = lineOf(*sheet->row("AORTA"));
  EXPECT_EQ(kidney.title.english(), "Kidney, length, right");
  EXPECT_EQ(lineOf(*sheet->row("KIDNEY_L", "right"), "de").title.arguments().front().english(),
            sheet->row("KIDNEY_L", "right")->title.german);
  EXPECT_EQ(kidney.value.english(), "10.20 cm");
  ASSERT_EQ(kidney.origin.size(), 1u);
  EXPECT_EQ(kidney.origin.front().english(), "mean of 10.00; 10.40");
  EXPECT_EQ(aorta.value.english(), "3.300 ± 0.040 cm");
  EXPECT_TRUE(aorta.origin.empty());
  ASSERT_EQ(aorta.against.size(), 1u);
  EXPECT_EQ(aorta.against.front().english(), "high (usual: up to 2.9 cm; an aneurysm from 3.0 cm on)");
  EXPECT_EQ(lineOf({}).value.english(), "–");
}

TEST(Worksheet, CountsAMeasurementOnceThatEntersTwice) {
  // Voided volume: full less residual, of different measurements; thyroid: the same side twice would double, two sides add in squares.
  WorksheetInput input;
  for (const char* side : {"right", "left"}) {
    input.entries.push_back(mm("LOBE_L", 50, 1.0, side));
    input.entries.push_back(mm("LOBE_W", 20, 0.0, side));
    input.entries.push_back(mm("LOBE_D", 18, 0.0, side));
  }
  const auto sheet = fillWorksheet(shipped("thyroid"), input);
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_NEAR(sheet->row("LOBE_VOLUME", "left")->value->value, 8.622, 1e-9);
  EXPECT_NEAR(sheet->row("LOBE_VOLUME", "left")->value->uncertainty, 8.622 / 50.0, 1e-7);
  EXPECT_NEAR(sheet->row("THYROID_VOLUME")->value->value, 17.244, 1e-9);
  EXPECT_NEAR(sheet->row("THYROID_VOLUME")->value->uncertainty, std::sqrt(2.0) * 8.622 / 50.0, 1e-7);
  EXPECT_NEAR(sheet->row("LOBE_VOLUME_ELLIPSOID", "right")->value->value, 3.141592653589793 / 6.0 * 18.0, 1e-9);

  // A formula of a formula of the same item: HC from BPD and OFD, GA by BPD and HC. Its slope by BPD goes both ways.
  const auto chained = fillWorksheet(shipped("obstetric"), {{mm("BPD", 82, 1.0), mm("OFD", 103)}, Several::mean, {}});
  ASSERT_TRUE(chained);
  const double HC = 1.62 * 18.5;
  EXPECT_NEAR(chained->row("GA_BPD_HC")->value->uncertainty, 0.1 * (1.32 + (0.018 * HC + 0.00036 * HC * HC) * 1.62), 1e-6);
  EXPECT_EQ(chained->row("HC")->from, "HC_BPD_OFD");
  EXPECT_EQ(howItCameAbout(*chained->row("GA_BPD_HC")), "from BPD 8.20 ± 0.10 cm, HC 29.97 ± 0.16 cm (by HC_BPD_OFD)");
}

TEST(Worksheet, PrefersWhatWasMeasuredToWhatFollows) {
  auto input = biometry();
  input.entries.push_back(mm("BPDO", 85));
  input.entries.push_back(mm("OFDO", 105));
  const auto sheet = fillWorksheet(shipped("obstetric"), input);
  ASSERT_TRUE(sheet);
  EXPECT_DOUBLE_EQ(sheet->row("HC")->value->value, 30.0);
  EXPECT_TRUE(sheet->row("HC")->from.empty());
  EXPECT_NEAR(sheet->row("HC_DIAMETERS")->value->value, 29.845, 1e-3);
}

TEST(Worksheet, TakesTheMeanTheLastOrTheSelectedOfSeveral) {
  WorksheetInput input{{mm("BPD", 80, 1.0), mm("BPD", 82, 1.0), mm("BPD", 87, 1.0)}, Several::mean, {}};
  input.entries[1].isSelected = true;
  const Package package = shipped("obstetric");
  const auto valueBy = [&](Several several) {
    input.several = several;
    return *fillWorksheet(package, input)->row("BPD")->value;
  };
  EXPECT_NEAR(valueBy(Several::mean).value, 8.3, 1e-12);
  EXPECT_NEAR(valueBy(Several::mean).uncertainty, 0.1 / std::sqrt(3.0), 1e-12);
  EXPECT_DOUBLE_EQ(valueBy(Several::last).value, 8.7);
  EXPECT_DOUBLE_EQ(valueBy(Several::selected).value, 8.2);
  EXPECT_EQ(fillWorksheet(package, input)->row("BPD")->measured.size(), 3u);
}

TEST(Worksheet, RefusesMillimetresTakenForCentimetres) {
  const Package package = shipped("obstetric");
  const auto cm = fillWorksheet(package, {{{"BPD", "", {82.0, 0.0, Unit::cm}, {}, false}}, Several::mean, {}});
  ASSERT_FALSE(cm);
  EXPECT_EQ(cm.error().sentence(), "BPD of 82 cm cannot be right: it lies from 1 cm to 12 cm; check the value and its unit.");
  const auto tooSmall = fillWorksheet(package, {{mm("BPD", 8.2)}, Several::mean, {}});
  ASSERT_FALSE(tooSmall);
  EXPECT_EQ(tooSmall.error().code, ErrorCode::badField);
  // Every length of every package, ten times too long or too short, is refused where it stands for a usual value.
  for (const auto& [label, usual_mm] : {std::pair{"BPD", 82.0}, {"HC", 300.0}, {"AC", 280.0}, {"FL", 62.0}, {"CRL", 45.0}})
    EXPECT_FALSE(fillWorksheet(package, {{mm(label, 10.0 * usual_mm)}, Several::mean, {}})) << label;
}

TEST(Worksheet, SaysWhenAFormulaIsOutsideOfItsRangeAndGivesNoNumber) {
  const auto sheet = fillWorksheet(shipped("obstetric"), {{mm("CRL", 9), mm("BPD", 18)}, Several::mean, {}});
  ASSERT_TRUE(sheet) << sheet.error();
  const WorksheetRow* intergrowth = sheet->row("GA_CRL_INTERGROWTH");
  ASSERT_NE(intergrowth, nullptr);
  EXPECT_FALSE(intergrowth->value);
  EXPECT_EQ(intergrowth->remarks.front().english(),
            "GA_CRL_INTERGROWTH is valid for CRL from 15 mm to 95 mm; 9 mm lies outside, so nothing is computed.");
  EXPECT_TRUE(sheet->row("GA_CRL_ROBINSON")->value);
  const WorksheetRow* bpd = sheet->row("GA_BPD");
  EXPECT_FALSE(bpd->value);
  EXPECT_EQ(bpd->remarks.front().english(),
            "GA_BPD is valid for results from 14 weeks to 42 weeks; these values give 12.75 weeks, so it says nothing.");
}

TEST(Worksheet, OffersAChartOnlyWithTheFormulaItWasBuiltOn) {
  const auto sheet = fillWorksheet(shipped("obstetric"), biometry());
  ASSERT_TRUE(sheet);
  EXPECT_TRUE(sheet->row("EFW_HADLOCK_AC_FL")->charts.empty());
  EXPECT_TRUE(sheet->row("EFW_HADLOCK_HC_AC_FL")->charts.empty());
  const auto& hadlock = sheet->row("EFW_HADLOCK_BPD_HC_AC_FL")->charts;
  ASSERT_EQ(hadlock.size(), 2u);
  const double median = std::exp(0.578 + 0.332 * (225.0 / 7.0) - 0.00354 * std::pow(225.0 / 7.0, 2));
  EXPECT_NEAR(hadlock[0].z, (1938.920 / median - 1.0) / 0.127, 1e-5);
  EXPECT_NEAR(hadlock[1].z, (1938.920 / median - 1.0) / 0.133, 1e-5);
  EXPECT_LT(hadlock[0].lowPercentile, hadlock[0].percentile);
  EXPECT_GT(hadlock[0].highPercentile, hadlock[0].percentile);
  ASSERT_EQ(sheet->row("EFW_INTERGROWTH")->charts.size(), 1u);
  EXPECT_EQ(sheet->row("EFW_INTERGROWTH")->charts[0].label, "INTERGROWTH_2017");

  const auto undated = fillWorksheet(shipped("obstetric"), biometry(std::nullopt));
  EXPECT_EQ(undated->row("EFW_INTERGROWTH")->remarks.front().english(), "The chart INTERGROWTH_2017 needs the gestational age by dates.");
  const auto early = fillWorksheet(shipped("obstetric"), biometry(20.0));
  EXPECT_EQ(early->row("EFW_INTERGROWTH")->remarks.front().english(),
            "The chart INTERGROWTH_2017 is valid from 22 to 40 weeks; 20w0d lies outside.");
}

TEST(Worksheet, ReplacesDatesByTheScanOnlyBeyondTheThresholdOfTheAge) {
  const Package package = shipped("obstetric");
  const auto redating = [&](const std::string& dates, std::vector<WorksheetEntry> entries) {
    return *fillWorksheet(package, {std::move(entries), Several::mean, gestationOf(dates)})->redating;
  };
  // CRL 45 mm: 11.327 weeks, 79 days, 11w2d by Hadlock.
  EXPECT_FALSE(redating("10w2d", {mm("CRL", 45)}).redate);  // 7 days
  EXPECT_TRUE(redating("10w1d", {mm("CRL", 45)}).redate);   // 8 days
  EXPECT_TRUE(redating("12w3d", {mm("CRL", 45)}).redate);
  EXPECT_TRUE(redating("8w6d", {mm("CRL", 30)}).redate);  // 9w6d against 8w6d: more than 5 days
  // All four: 32.208 weeks, 225 days.
  const auto late = biometry().entries;
  EXPECT_FALSE(redating("29w1d", late).redate);  // 21 days
  EXPECT_TRUE(redating("29w0d", late).redate);   // 22 days
  EXPECT_EQ(redating("29w0d", late).formula, "GA_BPD_HC_AC_FL");
  EXPECT_EQ(sentenceOf(redating("29w0d", late)).english(),
            "The scan says 32w1d, dates say 29w0d: 22 days apart, more than 21, so the dates are to be replaced by the scan.");
  EXPECT_EQ(sentenceOf(redating("32w0d", late)).english(),
            "The scan says 32w1d, dates say 32w0d: one day apart, not more than 21, so the dates stay.");
  EXPECT_EQ(redating("27w6d", late).moreThan_days, 14.0);
  EXPECT_EQ(redating("21w6d", late).moreThan_days, 10.0);
  EXPECT_EQ(redating("15w6d", late).moreThan_days, 7.0);
  EXPECT_FALSE(fillWorksheet(package, {{mm("CRL", 45)}, Several::mean, 20.0})->redating);  // no CRL so late
}

TEST(Worksheet, ComparesWithUsualRanges) {
  const auto sheet =
      fillWorksheet(shipped("abdomen"),
                    {{{"AORTA", "", {3.4, 0.1, Unit::cm}, {}, false}, mm("CBD", 5), mm("KIDNEY_L", 104, 0, "right")}, Several::mean, {}});
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_EQ(sheet->row("AORTA")->ranges[0].verdict, RangeVerdict::above);
  EXPECT_EQ(sheet->row("CBD")->ranges[0].verdict, RangeVerdict::within);
  EXPECT_EQ(sheet->row("KIDNEY_L", "right")->ranges[0].verdict, RangeVerdict::within);
}

TEST(UsualRanges, AreWrittenWithBothEndsOrTheOneThatIsStated) {
  EXPECT_EQ(rangeText({"A", Unit::cm, 9.0, 13.0, {}, {}}).english(), "9 to 13 cm");
  EXPECT_EQ(rangeText({"A", Unit::mm, {}, 6.5, {}, {}}).english(), "up to 6.5 mm");
  EXPECT_EQ(rangeText({"A", Unit::one, 3.0, {}, {}, {}}).english(), "from 3");
}

TEST(UsualRanges, AreWordsThatTheWindowTranslates) {
  for (const ReferenceRange& range :
       {ReferenceRange{"A", Unit::cm, 9.0, 13.0, {}, {}}, {"A", Unit::mm, {}, 6.5, {}, {}}, {"A", Unit::one, 3.0, {}, {}, {}}})
    EXPECT_NE(rangeText(range).text(), nullptr) << rangeText(range).english();
}

TEST(Worksheet, GradesAStenosisPerSide) {
  const auto sheet = fillWorksheet(shipped("vessel"), {{mm("D_MIN", 1.5, 0.2, "left"), mm("D_DISTAL", 5.0, 0.2, "left"),
                                                        mm("D_ORIGINAL", 7.5, 0.2, "left"), mm("D_MIN", 4.0, 0.2, "right")},
                                                       Several::mean,
                                                       {}});
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_NEAR(sheet->row("NASCET", "left")->value->value, 70.0, 1e-9);
  EXPECT_NEAR(sheet->row("ECST", "left")->value->value, 80.0, 1e-9);
  EXPECT_NEAR(sheet->row("NASCET", "left")->value->uncertainty, 100.0 * std::hypot(0.2 / 5.0, 1.5 * 0.2 / 25.0), 1e-6);
  EXPECT_EQ(sheet->row("NASCET", "right"), nullptr);
}

TEST(Worksheet, SumsUpTheWindowsOfATraumaScan) {
  const Package package = shipped("trauma");
  const auto saysOf = [&](std::vector<std::pair<std::string, std::string>> answers) {
    WorksheetInput input;
    for (const auto& [label, word] : answers) input.entries.push_back({label, "", {}, word, false});
    return fillWorksheet(package, input)->summaries.front().says.english;
  };
  EXPECT_EQ(saysOf({{"RUQ", "seen"}}), "Free fluid was seen.");
  EXPECT_EQ(saysOf({{"RUQ", "not_seen"}}), "Incomplete: not every window was adequate.");
  EXPECT_EQ(saysOf({{"RUQ", "not_seen"}, {"LUQ", "not_seen"}, {"PELVIS", "not_adequate"}, {"HEART", "not_seen"}}),
            "Incomplete: not every window was adequate.");
  EXPECT_TRUE(saysOf({{"RUQ", "not_seen"}, {"LUQ", "not_seen"}, {"PELVIS", "not_seen"}, {"HEART", "not_seen"}})
                  .starts_with("No free fluid was seen"));
  EXPECT_TRUE(fillWorksheet(package, {})->summaries.empty());
}

TEST(Worksheet, RefusesWhatThePackageDoesNotKnow) {
  const auto sentence = [](const std::string& id, WorksheetEntry entry) {
    const auto sheet = fillWorksheet(shipped(id), {{std::move(entry)}, Several::mean, {}});
    return sheet ? std::string("filled") : sheet.error().sentence();
  };
  EXPECT_EQ(sentence("bladder", mm("BPD", 82)),
            "The package bladder has no item 'BPD'; it has BLADDER_L, BLADDER_D, BLADDER_W, RESIDUAL_L, RESIDUAL_D, RESIDUAL_W.");
  EXPECT_EQ(sentence("thyroid", mm("LOBE_L", 50)), "LOBE_L is measured on the right and on the left; say which, as in LOBE_L/right.");
  EXPECT_EQ(sentence("obstetric", mm("BPD", 82, 0, "left")), "BPD has no sides; leave 'left' out.");
  EXPECT_EQ(sentence("obstetric", {"BPD", "", {82, 0, Unit::ml}, {}, false}), "BPD is measured in cm, not in 'ml'.");
  EXPECT_EQ(sentence("trauma", {"RUQ", "", {}, "maybe", false}), "RUQ is answered by one of seen, not_seen, not_adequate.");
}

TEST(WorksheetOutput, CarriesValuesOriginsAndTheWarning) {
  const auto sheet = fillWorksheet(shipped("obstetric"), biometry());
  const auto document = toJson(*sheet, "de");
  EXPECT_EQ(document["format"], 1);
  EXPECT_EQ(document["notice"], kTrainingOnly);
  EXPECT_EQ(document["gestation_by_dates"], "32w1d");
  EXPECT_EQ(document["title"], "Fetale Biometrie");
  bool found = false;
  for (const auto& section : document["sections"])
    for (const auto& row : section["rows"])
      if (row["label"] == "EFW_HADLOCK_BPD_HC_AC_FL") {
        found = true;
        EXPECT_NEAR(row["value"].get<double>(), 1938.920, 5e-4);
        EXPECT_EQ(row["unit"], "g");
        EXPECT_EQ(row["charts"].size(), 2u);
        EXPECT_TRUE(row["source"].get<std::string>().find("1985") != std::string::npos);
        EXPECT_TRUE(row["how"].get<std::string>().starts_with("from BPD 8.20"));
      }
  EXPECT_TRUE(found);
  EXPECT_EQ(document["redating"]["redate"], false);

  const std::string csv = toCsv(*sheet);
  std::istringstream lines(csv);
  std::string line;
  std::size_t rows = 0;
  while (std::getline(lines, line)) {
    std::size_t cells = 1;
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++cells;
    }
    EXPECT_EQ(cells, 15u) << line;
    if (rows++ > 0) {
      EXPECT_NE(line.find("training only"), std::string::npos) << line;
    }
  }
  EXPECT_GT(rows, 20u);
}

}  // namespace
}  // namespace ew::measurement::worksheet_test
