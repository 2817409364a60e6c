#include "ew/measurement/package.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <set>

#include "measurement/packages.h"

namespace ew::measurement::package_test {
namespace {

using nlohmann::json;
using test::document;
using test::shipped;

double resultOf(const Package& package, const std::string& formula, const std::vector<double>& inputs) {
  const PackageFormula* found = package.formula(formula);
  if (found == nullptr) return std::nan("");
  return found->expression.evaluate(inputs);
}

// The numbers below stand in the project's collection of facts, apart from the packages.
TEST(Obstetrics, GivesTheTestVectorsOfTheFactsToTheirPrintedDigits) {
  const Package package = shipped("obstetric");
  const double BPD = 8.2, HC = 30.0, AC = 28.0, FL = 6.2;
  EXPECT_NEAR(resultOf(package, "EFW_HADLOCK_AC_FL", {AC, FL}), 1949.126, 5e-4);
  EXPECT_NEAR(resultOf(package, "EFW_HADLOCK_BPD_AC_FL", {BPD, AC, FL}), 1948.678, 5e-4);
  EXPECT_NEAR(resultOf(package, "EFW_HADLOCK_HC_AC_FL", {HC, AC, FL}), 1936.707, 5e-4);
  EXPECT_NEAR(resultOf(package, "EFW_HADLOCK_BPD_HC_AC_FL", {BPD, HC, AC, FL}), 1938.920, 5e-4);
  EXPECT_NEAR(resultOf(package, "EFW_INTERGROWTH", {HC, AC}), 1837.088, 5e-4);
  EXPECT_NEAR(std::log(resultOf(package, "EFW_INTERGROWTH", {29.0, 26.0})), 7.312292, 5e-7);
  EXPECT_NEAR(resultOf(package, "GA_BPD", {BPD}), 32.962, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_HC", {HC}), 33.260, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_AC", {AC}), 32.046, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_FL", {FL}), 32.137, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_BPD_HC_AC_FL", {BPD, HC, AC, FL}), 32.208, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_CRL_HADLOCK", {4.5}), 11.327, 5e-4);
  EXPECT_NEAR(resultOf(package, "GA_CRL_ROBINSON", {45.0}), 78.73, 5e-3);
  EXPECT_NEAR(resultOf(package, "GA_CRL_INTERGROWTH", {45.0}), 78.18, 5e-3);
  const std::array<std::pair<double, double>, 6> medians{
      {{20, 331.0}, {24, 669.8}, {28, 1210.3}, {32, 1952.8}, {36, 2813.4}, {40, 3619.2}}};
  ASSERT_EQ(package.charts.size(), 3u);
  for (const auto& [weeks, grams] : medians)
    for (const std::size_t chart : {0u, 1u}) EXPECT_NEAR(valueAt(package.charts[chart], weeks, 0.0), grams, 0.05) << weeks;
  EXPECT_EQ(package.charts[0].spread_percent, 12.7);
  EXPECT_EQ(package.charts[1].spread_percent, 13.3);
}

// Every row of Hadlock 1984, written once more in C++.
TEST(Obstetrics, HasAllFifteenRowsOfHadlock1984) {
  const Package package = shipped("obstetric");
  const double B = 5.3, H = 19.4, A = 16.7, F = 3.7;
  const std::vector<std::tuple<std::string, std::vector<double>, double>> rows{
      {"GA_BPD", {B}, 9.54 + 1.482 * B + 0.1676 * B * B},
      {"GA_HC", {H}, 8.96 + 0.540 * H + 0.0003 * H * H * H},
      {"GA_AC", {A}, 8.14 + 0.753 * A + 0.0036 * A * A},
      {"GA_FL", {F}, 10.35 + 2.460 * F + 0.170 * F * F},
      {"GA_BPD_HC", {B, H}, 10.32 + 0.009 * H * H + 1.32 * B + 0.00012 * H * H * H},
      {"GA_BPD_AC", {B, A}, 9.57 + 0.524 * A + 0.122 * B * B},
      {"GA_BPD_FL", {B, F}, 10.50 + 0.197 * B * F + 0.95 * F + 0.73 * B},
      {"GA_HC_AC", {H, A}, 10.31 + 0.012 * H * H + 0.385 * A},
      {"GA_HC_FL", {H, F}, 11.19 + 0.07 * H * F + 0.263 * H},
      {"GA_AC_FL", {A, F}, 10.47 + 0.442 * A + 0.314 * F * F - 0.0121 * F * F * F},
      {"GA_BPD_HC_AC", {B, H, A}, 10.58 + 0.005 * H * H + 0.3635 * A + 0.02864 * B * A},
      {"GA_BPD_HC_FL", {B, H, F}, 11.38 + 0.07 * H * F + 0.98 * B},
      {"GA_BPD_AC_FL", {B, A, F}, 10.61 + 0.175 * B * F + 0.297 * A + 0.71 * F},
      {"GA_HC_AC_FL", {H, A, F}, 10.33 + 0.031 * H * F + 0.361 * H + 0.0298 * A * F},
      {"GA_BPD_HC_AC_FL", {B, H, A, F}, 10.85 + 0.06 * H * F + 0.67 * B + 0.168 * A}};
  EXPECT_EQ(rows.size(), 15u);
  for (const auto& [label, inputs, result] : rows) EXPECT_NEAR(resultOf(package, label, inputs), result, 1e-10) << label;
}

TEST(Obstetrics, ConvertsConventionsAndDiameters) {
  const Package package = shipped("obstetric");
  EXPECT_NEAR(resultOf(package, "HC_DIAMETERS", {8.5, 10.5}), 1.5707963267948966 * 19.0, 1e-12);
  EXPECT_NEAR(resultOf(package, "AC_DIAMETERS", {8.8, 9.0}), 1.5707963267948966 * 17.8, 1e-12);
  EXPECT_NEAR(resultOf(package, "HC_BPD_OFD", {8.2, 10.3}), 1.62 * 18.5, 1e-12);
  EXPECT_NEAR(resultOf(package, "BPD_OUTER", {82.0}), 0.555934 + 1.027318 * 82.0, 1e-12);
  EXPECT_NEAR(resultOf(package, "CI", {8.2, 10.5}), 820.0 / 10.5, 1e-12);
}

TEST(Charts, FollowTheDefinitionOfCentilesBothWays) {
  const Package package = shipped("obstetric");
  for (const PackageChart& chart : package.charts)
    for (const double percentile : {3.0, 10.0, 50.0, 90.0, 97.0}) {
      const double value = valueAt(chart, 32.0, zOfPercentile(percentile));
      EXPECT_NEAR(percentileOf(zScore(chart, 32.0, value)), percentile, 1e-6) << chart.label;
    }
  EXPECT_NEAR(percentileOf(0.0), 50.0, 1e-12);
  EXPECT_NEAR(percentileOf(1.6448536269514722), 95.0, 1e-9);
  EXPECT_NEAR(zOfPercentile(10.0), -1.2815515655446004, 1e-12);
}

TEST(Packages, OfTheProgramAreAllReadAndComplete) {
  const auto packages = readPackages(test::kPackages);
  ASSERT_TRUE(packages) << packages.error();
  std::vector<std::string> ids;
  for (const Package& package : *packages) {
    ids.push_back(package.id);
    std::set<std::string> shown;
    for (const WorksheetSection& section : package.worksheet)
      for (const std::string& label : section.rows) EXPECT_TRUE(shown.insert(label).second) << package.id << ": " << label << " twice";
    for (const PackageItem& item : package.items) {
      EXPECT_TRUE(shown.contains(item.label)) << package.id << " does not show " << item.label;
      EXPECT_FALSE(item.convention.english.empty() || item.convention.german.empty()) << item.label;
      EXPECT_FALSE(item.plane.english.empty() || item.plane.german.empty()) << item.label;
    }
    for (const PackageFormula& formula : package.formulas) {
      EXPECT_TRUE(shown.contains(formula.label)) << package.id << " does not show " << formula.label;
      EXPECT_FALSE(formula.tests.empty());
    }
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"abdomen", "bladder", "fetal_doppler", "obstetric", "thyroid", "trauma", "vascular", "vessel"}));
}

/// One more in the last digit of the n-th number of an expression; empty when there is none.
std::string withOneNumberWrong(const std::string& expression, int n) {
  const std::regex number(R"((^|[^A-Za-z0-9_.])([0-9]+(\.[0-9]+)?))");
  auto at = std::sregex_iterator(expression.begin(), expression.end(), number);
  std::advance(at, std::min<std::ptrdiff_t>(n, std::distance(at, std::sregex_iterator())));
  if (at == std::sregex_iterator()) return {};
  std::string changed = expression;
  const auto last = static_cast<std::size_t>(at->position(2) + at->length(2)) - 1;
  // By five in the last but one digit where there is one: what a slip of a finger does, and what any table would show.
  char& digit = changed[last];
  digit = static_cast<char>('0' + (digit - '0' + 5) % 10);
  return changed;
}

TEST(Packages, AreRefusedWithAnyCoefficientWrong) {
  int broken = 0;
  std::vector<std::string> unnoticed;
  for (const char* id : {"obstetric", "abdomen", "vessel", "thyroid", "bladder", "vascular", "fetal_doppler"}) {
    const json whole = document(id);
    for (std::size_t f = 0; f < whole["formulas"].size(); ++f)
      for (int n = 0;; ++n) {
        json other = whole;
        const std::string changed = withOneNumberWrong(whole["formulas"][f]["expression"].get<std::string>(), n);
        if (changed.empty()) break;
        other["formulas"][f]["expression"] = changed;
        ++broken;
        if (packageFromJson(other, id, verbatim("x.json"))) unnoticed.push_back(changed);
      }
  }
  EXPECT_GT(broken, 100);
  EXPECT_TRUE(unnoticed.empty()) << unnoticed.size() << " of " << broken << ", as " << unnoticed.front();
}

/// A package that is as small as a package can be.
json small() {
  return json::parse(R"({"format": 1, "version": 1, "title": {"en": "Small", "de": "Klein"}, "source": "a book",
    "items": [{"label": "A", "title": {"en": "a", "de": "a"}, "measure": "distance", "unit": "cm", "valid": [1, 20],
               "convention": {"en": "c", "de": "c"}, "plane": {"en": "p", "de": "p"}},
              {"label": "C", "title": {"en": "c", "de": "c"}, "measure": "choice", "convention": {"en": "c", "de": "c"}, "plane": {"en": "p", "de": "p"},
               "choices": [{"word": "yes", "title": {"en": "y", "de": "j"}}, {"word": "no", "title": {"en": "n", "de": "n"}}]}],
    "formulas": [{"label": "F", "title": {"en": "f", "de": "f"}, "expression": "2*A", "inputs": [{"name": "A", "unit": "mm", "valid": [10, 100]}], "unit": "mm",
                  "valid": [20, 180], "source": "a book", "error": {"percent": 5}, "tests": [{"inputs": {"A": 20}, "result": 40, "digits": 1}]}],
    "charts": [{"label": "K", "title": {"en": "k", "de": "k"}, "of": ["F"], "unit": "mm", "valid_weeks": [10, 40], "median": "2*GA", "spread_percent": 10, "source": "a book",
                "tests": [{"weeks": 20, "value": 40, "digits": 1}]}],
    "ranges": [{"of": "A", "unit": "mm", "low": 20, "high": 50, "source": "a book"}],
    "redating": {"source": "a book", "steps": []},
    "summaries": [{"title": {"en": "s", "de": "s"}, "items": ["C"], "unanswered": "no", "rules": [{"choice": "yes", "says": {"en": "y", "de": "j"}}]}],
    "worksheet": [{"title": {"en": "w", "de": "w"}, "rows": ["A", "F", "C"]}]})");
}

TEST(Packages, WithOneBadFieldAreRefusedInItsSentence) {
  json good = small();
  good.erase("redating");
  ASSERT_TRUE(packageFromJson(good, "small", verbatim("x.json"))) << packageFromJson(good, "small", verbatim("x.json")).error();
  const std::vector<std::pair<const char*, const char*>> bad{
      {R"({"path": "/format", "value": 2})", "x.json has format 2, this program reads up to 1; update EchoWeave."},
      {R"({"path": "/version", "value": 0})", "'version' in x.json is 0; it must be a whole number from 1 to 1000000."},
      {R"({"path": "/title/de"})", "'title.de' in x.json is missing; it must be a text of 1 to 600 bytes."},
      {R"({"path": "/colour", "value": 1})",
       "'colour' in x.json is not known here; it must be one of format, version, title, source, items, formulas, charts, ranges, redating, "
       "summaries, worksheet."},
      {R"({"path": "/items/0/label", "value": "1A"})",
       "'items[0].label' in x.json is \"1A\"; it must be a letter, then letters, digits and _."},
      {R"({"path": "/items/1/label", "value": "A"})", "'items[1].label' in x.json is \"A\"; it must be a label that no other entry has."},
      {R"({"path": "/items/0/unit", "value": "inch"})",
       "'items[0].unit' in x.json is \"inch\"; it must be a unit: 1, %, mm, cm, mm2, cm2, ml, g, kg, deg, s, ms, /min, mm/s, cm/s, "
       "cm/s2, ml/min, mmHg, weeks or days."},
      {R"({"path": "/items/0/valid", "value": [20, 1]})",
       "'items[0].valid' in x.json is [20,1]; it must be two rising numbers, the smallest and the largest value."},
      {R"({"path": "/items/1/unit", "value": "mm"})", "'items[1].unit' in x.json is \"mm\"; it must be left out of a choice."},
      {R"({"path": "/items/0/choices", "value": []})",
       "'items[0].choices' in x.json is []; it must be left out, unless the measure is \"choice\"."},
      {R"({"path": "/formulas/0/expression", "value": "2*B"})",
       "'formulas[0].expression' in x.json cannot be used. The expression uses 'B', which is neither an input nor a function known here."},
      {R"({"path": "/formulas/0/inputs/0/of", "value": "Q"})",
       "'formulas[0].inputs[0].of' in x.json is \"Q\"; it must be the label of an item with a unit or of an earlier formula."},
      {R"({"path": "/formulas/0/inputs/0/unit", "value": "ml"})",
       "'formulas[0].inputs[0].unit' in x.json is \"ml\"; it must be a unit that A can be converted to."},
      {R"({"path": "/formulas/0/provides", "value": "C"})",
       "'formulas[0].provides' in x.json is \"C\"; it must be the label of an item whose unit the result can be converted to."},
      {R"({"path": "/formulas/0/error", "value": {}})",
       "'formulas[0].error' in x.json is {}; it must be an object with either \"percent\" or \"absolute\"."},
      {R"({"path": "/formulas/0/tests", "value": []})",
       "'formulas[0].tests' in x.json is a list of 0; it must be a list of 1 to 200 entries."},
      {R"({"path": "/formulas/0/tests/0/result", "value": 41})",
       "'formulas[0].tests[0].result' in x.json is 41; it must be 40, which the expression gives; correct the one that is wrong."},
      {R"({"path": "/formulas/0/tests/0/inputs/B", "value": 41})",
       "'formulas[0].tests[0].inputs.B' in x.json is not known here; it must be one of A."},
      {R"({"path": "/charts/0/of", "value": ["A"]})",
       "'charts[0].of' in x.json is [\"A\"]; it must be labels of formulas whose results can be converted to the chart's unit."},
      {R"({"path": "/charts/0/lms", "value": {}})",
       "'charts[0].median' in x.json is \"2*GA\"; it must be left out of a chart with \"lms\"."},
      {R"({"path": "/charts/0/tests/0/value", "value": 39})",
       "'charts[0].tests[0].value' in x.json is 39; it must be 40, which the chart gives; correct the one that is wrong."},
      {R"({"path": "/ranges/0/of", "value": "C"})",
       "'ranges[0].of' in x.json is \"C\"; it must be the label of an item with a unit or of a formula."},
      {R"({"path": "/ranges/0/high", "value": 3})", "'ranges[0].high' in x.json is 3; it must be a number from 20 to 1e+09."},
      {R"({"path": "/redating", "value": {"source": "s", "steps": [{"below_weeks": 9, "more_than_days": 5, "by": ["F"]}]}})",
       "'redating.steps[0].by' in x.json is [\"F\"]; it must be labels of formulas that give a gestational age."},
      {R"({"path": "/summaries/0/items", "value": ["A"]})", "'summaries[0].items' in x.json is [\"A\"]; it must be labels of choices."},
      {R"({"path": "/summaries/0/unanswered", "value": "maybe"})",
       "'summaries[0].unanswered' in x.json is \"maybe\"; it must be a word of the choices."},
      {R"({"path": "/summaries/0/rules/0/choice", "value": "maybe"})",
       "'summaries[0].rules[0].choice' in x.json is \"maybe\"; it must be a word of the choices."},
      {R"({"path": "/worksheet/0/rows/1", "value": "Q"})",
       "'worksheet[0].rows[1]' in x.json is \"Q\"; it must be the label of an item or a formula."},
      {R"({"path": "/formulas/0/source"})", "'formulas[0].source' in x.json is missing; it must be a text of 1 to 600 bytes."},
  };
  for (const auto& [change, sentence] : bad) {
    json step = json::parse(change);
    const bool removes = !step.contains("value");
    const json::json_pointer at(step["path"].get<std::string>());
    step["op"] = removes ? "remove" : good.contains(at) ? "replace" : "add";
    const auto read = packageFromJson(good.patch(json::array({step})), "small", verbatim("x.json"));
    EXPECT_FALSE(read) << change;
    if (!read) {
      EXPECT_EQ(read.error().sentence(), sentence) << change;
    }
  }
}

TEST(Packages, ThatAreNotThereOrNoJsonAreSaidSo) {
  EXPECT_EQ(readPackage("/nowhere/x.json").error().code, ErrorCode::notFound);
  const auto file = std::filesystem::path(::testing::TempDir()) / "ew_package_test.json";
  std::ofstream(file) << "{";
  EXPECT_EQ(readPackage(file).error().code, ErrorCode::badHeader);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace ew::measurement::package_test
