#include "ew/measurement/criteria.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ew/core/message.h"
#include "measurement/packages.h"

namespace ew::measurement::criteria_test {
namespace {

using nlohmann::json;

const std::filesystem::path kCriteria = std::filesystem::path(EW_SOURCE_DIR) / "resources" / "criteria";

Criteria shipped(const std::string& id) {
  auto criteria = readCriteria(kCriteria / (id + ".json"));
  EXPECT_TRUE(criteria) << criteria.error();
  return criteria ? std::move(*criteria) : Criteria{};
}

/// Numbers in the units of the inputs, and words.
CriteriaValues values(const Criteria& criteria, const std::vector<std::pair<std::string, double>>& numbers,
                      const std::vector<std::pair<std::string, std::string>>& words = {}) {
  CriteriaValues made;
  for (const auto& [name, number] : numbers)
    if (const CriteriaInput* input = criteria.input(name)) made[name].quantity = {number, 0.0, input->unit};
  for (const auto& [name, word] : words) made[name].choice = word;
  return made;
}

Grade graded(const char* id, const std::vector<std::pair<std::string, double>>& numbers,
             const std::vector<std::pair<std::string, std::string>>& words = {}) {
  const Criteria criteria = shipped(id);
  auto grade = gradeOf(criteria, values(criteria, numbers, words));
  EXPECT_TRUE(grade) << grade.error();
  return grade ? std::move(*grade) : Grade{};
}

std::string firstSentence(const Grade& grade, std::string_view language = "en") { return sentencesOf(grade, language).front().english(); }

// The vectors of the project's collection of facts, section 10.
TEST(CarotidCriteria, AgreeOnTwoHundredOverEighty) {
  for (const char* id : {"carotid-sru-2003", "carotid-iac-2021"})
    EXPECT_EQ(graded(id, {{"PSV", 200}, {"CCA_PSV", 80}}).word, "from_50_to_69") << id;
}

TEST(CarotidCriteria, DifferOnAHundredAndFiftyOverNinety) {
  const auto all =
      std::vector{graded("carotid-sru-2003", {{"PSV", 150}, {"CCA_PSV", 90}}), graded("carotid-iac-2021", {{"PSV", 150}, {"CCA_PSV", 90}})};
  EXPECT_EQ(all[0].word, "from_50_to_69");
  EXPECT_EQ(all[1].word, "lt_50");
  ASSERT_EQ(differencesOf(all).size(), 1u);
  EXPECT_EQ(differencesOf(all).front().english(),
            "They differ: 50 to 69 % by SRU consensus (2003), from Peak systolic velocity 150.0 cm/s (125 to 230 cm/s); less than 50 % by "
            "IAC (2021), from Peak systolic velocity 150.0 cm/s (from 125 to below 180 cm/s); Ratio ICA/CCA 1.667 (below 2).");
}

TEST(CarotidCriteria, TakeTheirLimitsAtTheLastDigit) {
  const auto sru = [](double psv) { return graded("carotid-sru-2003", {{"PSV", psv}}, {{"PLAQUE", "seen"}}).word; };
  EXPECT_EQ(sru(124.99), "lt_50");
  EXPECT_EQ(sru(125), "from_50_to_69");
  EXPECT_EQ(sru(230), "from_50_to_69");
  EXPECT_EQ(sru(230.01), "ge_70");
  const auto iac = [](double psv, double common) {
    return graded("carotid-iac-2021", {{"PSV", psv}, {"CCA_PSV", common}}, {{"PLAQUE", "seen"}}).word;
  };
  EXPECT_EQ(iac(124.99, 20), "lt_50");
  EXPECT_EQ(iac(125, 62.5), "from_50_to_69");
  EXPECT_EQ(iac(125, 62.6), "lt_50");
  EXPECT_EQ(iac(179.99, 100), "lt_50");
  EXPECT_EQ(iac(180, 100), "from_50_to_69");
  EXPECT_EQ(iac(230, 100), "from_50_to_69");
  EXPECT_EQ(iac(230.01, 100), "ge_70");
}

TEST(CarotidCriteria, HoldRatioAndDiastoleAgainstTheGradeAtTheirLimits) {
  const auto doubts = [](double psv, double common, double edv) {
    std::vector<std::string> names;
    for (const Disagreement& each : graded("carotid-sru-2003", {{"PSV", psv}, {"CCA_PSV", common}, {"EDV", edv}}).disagreements)
      names.push_back(each.expected.condition.of);
    return names;
  };
  const std::vector<std::string> none, ratio{"RATIO"}, diastole{"EDV"};
  EXPECT_EQ(doubts(160, 80, 40), none);  // ratio 2.0
  EXPECT_EQ(doubts(160, 80.1, 40), ratio);
  EXPECT_EQ(doubts(200, 50, 100), none);  // ratio 4.0
  EXPECT_EQ(doubts(200, 49.9, 100), ratio);
  EXPECT_EQ(doubts(160, 80, 39.9), diastole);
  EXPECT_EQ(doubts(160, 80, 100.1), diastole);
  EXPECT_EQ(doubts(300, 75, 100.1), ratio);  // 4.0 is not above 4.0
  EXPECT_EQ(doubts(300, 74.9, 100), diastole);
}

TEST(CarotidCriteria, SayWhichParameterSpeaksForAnotherGradeAndWhichDecides) {
  const Grade grade = graded("carotid-sru-2003", {{"PSV", 200}, {"CCA_PSV", 40}}, {{"PLAQUE", "seen"}});
  EXPECT_EQ(grade.word, "from_50_to_69");
  ASSERT_EQ(grade.disagreements.size(), 1u);
  const auto sentences = sentencesOf(grade);
  EXPECT_EQ(
      sentences.back().english(),
      "Ratio ICA/CCA 5.000 speaks for 70 % or more (not near occlusion), not for 50 to 69 %; SRU consensus (2003) decides by Peak systolic "
      "velocity, Plaque, Lumen in colour.");
  const Grade both = graded("carotid-iac-2021", {{"PSV", 200}, {"CCA_PSV", 40}});
  ASSERT_EQ(both.disagreements.size(), 1u);
  ASSERT_EQ(both.disagreements.front().speaksFor.size(), 1u);  // not for the grade itself, whose other way its ratio would go
  EXPECT_EQ(both.disagreements.front().speaksFor.front().english, "70 % or more (not near occlusion)");
  const Grade bare = graded("carotid-sru-2003", {{"PSV", 200}}, {{"PLAQUE", "none"}});
  EXPECT_EQ(bare.word, "from_50_to_69");
  ASSERT_EQ(bare.disagreements.size(), 1u);
  ASSERT_EQ(bare.disagreements.front().speaksFor.size(), 1u);
  EXPECT_EQ(bare.disagreements.front().speaksFor.front().english, "normal");
}

TEST(CarotidCriteria, GradeOcclusionsByWhatIsSeenAlone) {
  for (const char* id : {"carotid-sru-2003", "carotid-iac-2021"}) {
    EXPECT_EQ(graded(id, {}, {{"LUMEN", "none"}}).word, "occlusion") << id;
    const Grade near = graded(id, {{"PSV", 300}}, {{"LUMEN", "trickle"}});
    EXPECT_EQ(near.word, "near_occlusion") << id;
    EXPECT_TRUE(near.assumed.empty()) << id;
  }
}

TEST(Criteria, GiveNoGradeButSayWhatIsMissing) {
  const Grade plaque = graded("carotid-sru-2003", {{"PSV", 100}});
  EXPECT_EQ(plaque.word, "");
  ASSERT_EQ(plaque.missing.size(), 1u);
  EXPECT_EQ(plaque.missing.front().first, "PLAQUE");
  EXPECT_EQ(firstSentence(plaque), "SRU consensus (2003) gives no grade: missing is Plaque; possible are normal, less than 50 %.");
  EXPECT_EQ(firstSentence(graded("carotid-iac-2021", {{"PSV", 150}})),
            "IAC (2021) gives no grade: missing is Peak systolic velocity of the common carotid; possible are less than 50 %, 50 to 69 %.");
  const Grade undated = graded("umbilical-pi", {{"PI", 1.03}}, {{"END_FLOW", "present"}});
  ASSERT_EQ(undated.missing.size(), 1u);
  EXPECT_EQ(undated.missing.front().first, "GA");
  EXPECT_EQ(graded("leg-ratio", {}).missing.size(), 2u);
  EXPECT_EQ(graded("carotid-sru-2003", {{"EDV", 50}}).word, "");  // an additional parameter decides nothing
}

TEST(Criteria, SayWhatTheyAssume) {
  const auto sentences = english(sentencesOf(graded("carotid-sru-2003", {{"PSV", 200}})));
  EXPECT_EQ(sentences.front(), "SRU consensus (2003): 50 to 69 %. Decisive: Peak systolic velocity 200.0 cm/s (125 to 230 cm/s).");
  EXPECT_NE(std::find(sentences.begin(), sentences.end(), "Assumed: Lumen in colour, open."), sentences.end());
}

TEST(Criteria, TellThatAValueLiesWithinItsUncertaintyOfALimit) {
  const Criteria criteria = shipped("carotid-sru-2003");
  CriteriaValues measured;
  for (const auto& [psv, isNear] : {std::pair{126.0, true}, std::pair{140.0, false}, std::pair{226.0, true}}) {
    measured["PSV"].quantity = {psv, 11.0, Unit::cmPerS};
    const auto sentences = english(sentencesOf(*gradeOf(criteria, measured)));
    EXPECT_EQ(std::any_of(sentences.begin(), sentences.end(),
                          [](const auto& each) { return each.ends_with("lies within its uncertainty of a limit."); }),
              isNear)
        << psv;
  }
}

TEST(Criteria, OfTheKidneyKeepBothLimitsInUseApart) {
  const auto word = [](double psv) { return graded("renal-60", {{"PSV", psv}}).word; };
  EXPECT_EQ(word(180), "lt_60");
  EXPECT_EQ(word(180.01), "between_limits");
  EXPECT_EQ(word(200), "between_limits");
  EXPECT_EQ(word(200.01), "ge_60");
  const auto doubts = [](double ratioOf, double at_ms, double ai, double difference) {
    return graded("renal-60", {{"PSV", 280}, {"AORTA_PSV", 280 / ratioOf}, {"AT", at_ms}, {"AI", ai}, {"RI_DIFFERENCE", difference}})
        .disagreements.size();
  };
  EXPECT_EQ(doubts(3.6, 71, 299, 0.05), 0u);
  EXPECT_EQ(doubts(3.5, 70, 300, 0.049), 4u);
}

TEST(Criteria, OfTheLegGoByTheRatio) {
  const auto word = [](double psv) { return graded("leg-ratio", {{"PSV", psv}, {"PROXIMAL_PSV", 80}}).word; };
  EXPECT_EQ(word(159.9), "lt_50");
  EXPECT_EQ(word(160), "from_50_to_74");
  EXPECT_EQ(word(319.9), "from_50_to_74");
  EXPECT_EQ(word(320), "from_75_to_99");
  EXPECT_EQ(graded("leg-ratio", {}, {{"FLOW", "none"}}).word, "occlusion");
}

TEST(Criteria, OfTheCordGoByTheWeek) {
  const auto word = [](double index, double weeks) {
    return graded("umbilical-pi", {{"PI", index}, {"GA", weeks}}, {{"END_FLOW", "present"}}).word;
  };
  EXPECT_EQ(word(1.03, 28), "usual");  // the median
  for (const auto& [weeks, high] :
       {std::pair{24.0, 1.38}, std::pair{28.0, 1.32}, std::pair{32.0, 1.25}, std::pair{36.0, 1.19}, std::pair{40.0, 1.12}}) {
    EXPECT_EQ(word(high, weeks), "usual") << weeks;
    EXPECT_EQ(word(high + 0.001, weeks), "raised") << weeks;
  }
  EXPECT_EQ(word(1.285, 30), "usual");  // halfway from 1.32 to 1.25
  EXPECT_EQ(word(1.286, 30), "raised");
  EXPECT_EQ(graded("umbilical-pi", {{"PI", 2.0}, {"GA", 28}}, {{"END_FLOW", "reversed"}}).word, "reversed");
}

TEST(Criteria, OfFetalAnaemiaTakeTheMultipleOfTheMedian) {
  const auto word = [](double multiple, double weeks) {
    return graded("mca-anaemia", {{"PSV", multiple * std::exp(2.31 + 0.046 * weeks)}, {"GA", weeks}}).word;
  };
  EXPECT_EQ(graded("mca-anaemia", {{"PSV", 36.5}, {"GA", 28}}).word, "usual");
  for (const double weeks : {20.0, 23.7, 28.0, 33.3, 40.0}) {
    EXPECT_EQ(word(1.5, weeks), "anaemia_suspected") << weeks;
    EXPECT_EQ(word(1.4999, weeks), "usual") << weeks;
  }
}

TEST(Criteria, RefuseValuesThatCannotBe) {
  const Criteria criteria = shipped("umbilical-pi");
  const auto sentence = [&](const CriteriaValues& given) { return gradeOf(criteria, given).error().sentence(); };
  EXPECT_EQ(
      sentence({{"GA", {{22.0, 0.0, Unit::weeks}, {}}}}),
      "GA of 22 weeks cannot be graded by Umbilical artery, INTERGROWTH-21st (2020): it lies from 24 weeks to 40 weeks; check the value "
      "and its unit.");
  EXPECT_EQ(sentence({{"GA", {{22.0, 0.0, Unit::mm}, {}}}}), "GA is measured in weeks, not in 'mm'.");
  EXPECT_EQ(sentence({{"END_FLOW", {{}, "maybe"}}}), "END_FLOW is answered by one of present, absent, reversed.");
  EXPECT_FALSE(gradeOf(criteria, {{"PI", {{std::nan(""), 0.0, Unit::one}, {}}}}));
  EXPECT_TRUE(gradeOf(criteria, {{"GA", {{28.0 * 7.0, 0.0, Unit::days}, {}}}}));
}

TEST(Criteria, TakeTheirValuesFromAWorksheet) {
  const auto item = [](const char* label, double value, const char* side) {
    return WorksheetEntry{label, side, {value, 0.0, Unit::cmPerS}, {}, false};
  };
  WorksheetInput input;
  input.entries = {item("ICA_PSV", 150, "left"), item("CCA_PSV", 90, "left"), item("RENAL_PSV", 280, "right"), item("AORTA_PSV", 70, "")};
  const auto sheet = fillWorksheet(test::shipped("vascular"), input);
  ASSERT_TRUE(sheet) << sheet.error();
  const Criteria iac = shipped("carotid-iac-2021"), renal = shipped("renal-60");
  EXPECT_EQ(gradeOf(iac, valuesFrom(*sheet, iac, "left"))->word, "lt_50");
  EXPECT_TRUE(valuesFrom(*sheet, iac, "right").empty());
  const auto kidney = gradeOf(renal, valuesFrom(*sheet, renal, "right"));
  EXPECT_EQ(kidney->word, "ge_60");
  EXPECT_TRUE(kidney->disagreements.empty());
  WorksheetInput cord;
  cord.gestation_weeks = 28.0;
  cord.entries = {item("UA_PSV", 50.3, ""), item("UA_EDV", 40, ""), item("UA_TAMX", 10, ""), {"UA_FLOW_AT_END", "", {}, "present", false}};
  const auto fetal = fillWorksheet(test::shipped("fetal_doppler"), cord);
  ASSERT_TRUE(fetal) << fetal.error();
  const Criteria umbilical = shipped("umbilical-pi");
  EXPECT_EQ(gradeOf(umbilical, valuesFrom(*fetal, umbilical))->word, "usual");
}

TEST(Criteria, OfTheProgramAreAllReadWithSourcesAndInBothLanguages) {
  const auto all = readAllCriteria(kCriteria);
  ASSERT_TRUE(all) << all.error();
  std::vector<std::string> ids;
  for (const Criteria& criteria : *all) {
    ids.push_back(criteria.id);
    EXPECT_FALSE(criteria.source.empty() || criteria.status.empty()) << criteria.id;
    for (const CriteriaGrade& grade : criteria.grades) {
      EXPECT_FALSE(grade.title.german.empty()) << grade.word;
      EXPECT_TRUE(std::any_of(criteria.tests.begin(), criteria.tests.end(), [&](const auto& each) { return each.grade == grade.word; }))
          << criteria.id << " does not test " << grade.word;
    }
    const auto package = criteria.inputs.front().of.substr(0, criteria.inputs.front().of.find('.'));
    const Package known = test::shipped(package);
    for (const CriteriaInput& input : criteria.inputs) {
      EXPECT_FALSE(input.title.german.empty()) << input.name;
      if (input.of.empty()) continue;
      const std::string label = input.of.substr(package.size() + 1);
      EXPECT_TRUE(known.item(label) != nullptr || known.formula(label) != nullptr || label == kByDates) << input.of;
    }
  }
  EXPECT_EQ(ids,
            (std::vector<std::string>{"carotid-iac-2021", "carotid-sru-2003", "leg-ratio", "mca-anaemia", "renal-60", "umbilical-pi"}));
  const Grade grade = graded("carotid-sru-2003", {{"PSV", 200}});
  EXPECT_EQ(sentencesOf(grade, "de").front().arguments()[1].english(), "50 bis 69 %");
  EXPECT_EQ(sentencesOf(grade, "de").front().arguments()[0].arguments()[0].english(), "SRU-Konsens");
}

TEST(Criteria, AreComparedVesselByVessel) {
  const auto kidney = graded("renal-60", {{"PSV", 300}}), carotid = graded("carotid-sru-2003", {{"PSV", 150}});
  EXPECT_TRUE(differencesOf({kidney, carotid}).empty());
  EXPECT_TRUE(differencesOf({carotid, carotid}).empty());
  const auto undecided = graded("carotid-iac-2021", {{"PSV", 150}});
  ASSERT_EQ(differencesOf({carotid, undecided}).size(), 1u);
  EXPECT_TRUE(differencesOf({carotid, undecided}).front().english().ends_with("no grade by IAC (2021)."))
      << differencesOf({carotid, undecided}).front();
  const auto both = gradesOf({shipped("carotid-sru-2003"), shipped("carotid-iac-2021")}, {{"PSV", {{300.0, 0.0, Unit::cmPerS}, {}}}});
  ASSERT_TRUE(both);
  EXPECT_EQ(both->size(), 2u);
}

TEST(Criteria, AreWrittenWithGradeReasonsAndTheWarning) {
  const auto written = toJson(graded("carotid-sru-2003", {{"PSV", 200}, {"CCA_PSV", 40}}));
  EXPECT_EQ(written["grade"], "from_50_to_69");
  EXPECT_EQ(written["year"], 2003);
  EXPECT_EQ(written["notice"], kTrainingOnly);
  EXPECT_EQ(written["decided"][0]["value"], 200.0);
  EXPECT_EQ(written["disagreements"][0]["of"], "RATIO");
  EXPECT_EQ(toJson(graded("carotid-sru-2003", {{"PSV", 100}}))["missing"].dump(), R"(["PLAQUE"])");
}

/// Criteria that are as small as criteria can be.
json small() {
  return json::parse(
      R"({"format": 1, "version": 1, "name": {"en": "Small", "de": "Klein"}, "year": 2000, "vessel": "pipe", "vessel_title": {"en": "pipe", "de": "Rohr"},
    "source": "a book", "status": "made up",
    "inputs": [{"name": "A", "title": {"en": "a", "de": "a"}, "role": "primary", "unit": "cm/s", "valid": [0, 500]},
               {"name": "B", "title": {"en": "b", "de": "b"}, "role": "part", "unit": "cm/s", "valid": [1, 500]},
               {"name": "S", "title": {"en": "s", "de": "s"}, "role": "primary", "choices": [{"word": "yes", "title": {"en": "y", "de": "j"}}, {"word": "no", "title": {"en": "n", "de": "n"}}], "assumed": "yes"}],
    "formulas": [{"name": "R", "title": {"en": "r", "de": "r"}, "role": "additional", "expression": "A/B", "inputs": ["A", "B"], "unit": "1",
                  "tests": [{"inputs": {"A": 4, "B": 2}, "result": 2, "digits": 3}]}],
    "grades": [{"word": "low", "title": {"en": "l", "de": "n"}, "when": {"all": [{"of": "A", "below": 100, "unit": "cm/s"}, {"of": "S", "is": ["yes"]}]},
                "expects": [{"of": "R", "below": 2, "unit": "1"}]},
               {"word": "high", "title": {"en": "h", "de": "h"}, "when": {"any": [{"all": [{"of": "A", "from": 100, "unit": "cm/s"}]}]}}],
    "tests": [{"values": {"A": 99}, "grade": "low"}, {"values": {"A": 100}, "grade": "high"}, {"values": {"B": 3}}]})");
}

TEST(Criteria, WithOneBadFieldAreRefusedInItsSentence) {
  const json good = small();
  ASSERT_TRUE(criteriaFromJson(good, "small", verbatim("x.json"))) << criteriaFromJson(good, "small", verbatim("x.json")).error();
  const std::vector<std::pair<const char*, const char*>> bad{
      {R"({"path": "/format", "value": 2})", "x.json has format 2, this program reads up to 1; update EchoWeave."},
      {R"({"path": "/source"})", "'source' in x.json is missing; it must be a text of 1 to 600 bytes."},
      {R"({"path": "/status"})", "'status' in x.json is missing; it must be a text of 1 to 600 bytes."},
      {R"({"path": "/name/de"})", "'name.de' in x.json is missing; it must be a text of 1 to 600 bytes."},
      {R"({"path": "/year", "value": 203})", "'year' in x.json is 203; it must be a whole number from 1950 to 2100."},
      {R"({"path": "/inputs/1/name", "value": "A"})", "'inputs[1].name' in x.json is \"A\"; it must be a name that no other entry has."},
      {R"({"path": "/inputs/0/valid", "value": [5, 1]})",
       "'inputs[0].valid' in x.json is [5,1]; it must be two rising numbers, the smallest and the largest value."},
      {R"({"path": "/inputs/2/assumed", "value": "maybe"})",
       "'inputs[2].assumed' in x.json is \"maybe\"; it must be a word of the choices."},
      {R"({"path": "/inputs/2/unit", "value": "mm"})", "'inputs[2].unit' in x.json is \"mm\"; it must be left out of a choice."},
      {R"({"path": "/inputs/0/role", "value": "chief"})",
       "'inputs[0].role' in x.json is \"chief\"; it must be \"primary\", \"additional\" or \"part\"."},
      {R"({"path": "/formulas/0/inputs", "value": ["A", "Q"]})",
       "'formulas[0].inputs' in x.json is [\"A\",\"Q\"]; it must be names of inputs with a unit."},
      {R"({"path": "/formulas/0/tests/0/result", "value": 3})",
       "'formulas[0].tests[0].result' in x.json is 3; it must be 2, which the expression gives; correct the one that is wrong."},
      {R"({"path": "/grades/0/when/all/0/of", "value": "Q"})",
       "'grades[0].when.all[0].of' in x.json is \"Q\"; it must be the name of an input or formula."},
      {R"({"path": "/grades/0/when/all/0/of", "value": "R"})",
       "'grades[0].when.all[0].unit' in x.json is \"cm/s\"; it must be the unit of R."},
      {R"({"path": "/grades/0/when/all/0", "value": {"of": "R", "below": 2, "unit": "1"}})",
       "'grades[0].when.all[0].of' in x.json is \"R\"; it must be a primary parameter, since it decides."},
      {R"({"path": "/grades/0/expects/0", "value": {"of": "B", "below": 2, "unit": "cm/s"}})",
       "'grades[0].expects[0].of' in x.json is \"B\"; it must be a parameter that is more than a part of a formula."},
      {R"({"path": "/grades/0/when/all/0/unit", "value": "mm/s"})",
       "'grades[0].when.all[0].unit' in x.json is \"mm/s\"; it must be the unit of A."},
      {R"({"path": "/grades/0/when/all/0/to", "value": 90})",
       "'grades[0].when.all[0].below' in x.json is 100; it must be left out, when the other kind of end is there."},
      {R"({"path": "/grades/0/when/all/0/from", "value": 100})",
       "'grades[0].when.all[0]' in x.json is A; it must be a range with at least one value."},
      {R"({"path": "/grades/0/when/all/1/is", "value": ["maybe"]})",
       "'grades[0].when.all[1].is' in x.json is [\"maybe\"]; it must be words of the choices."},
      {R"({"path": "/grades/0/when/any", "value": []})",
       "'grades[0].when' in x.json is an object with 2 fields; it must be an object with either \"all\" or \"any\"."},
      {R"({"path": "/grades/1/word", "value": "low"})",
       "'grades[1].word' in x.json is \"low\"; it must be a word that no other grade has."},
      {R"({"path": "/grades/1/when/any/0/all/0/from", "value": 99})",
       "'grades[1].when' in x.json is high; it must be conditions that never hold together with those of low."},
      {R"({"path": "/grades/0/when/all/0", "value": {"of": "A", "to": 100, "unit": "cm/s"}})",
       "'grades[1].when' in x.json is high; it must be conditions that never hold together with those of low."},
      {R"({"path": "/grades/1/when/any/0/all/0", "value": {"of": "S", "is": ["yes", "no"]}})",
       "'grades[1].when' in x.json is high; it must be conditions that never hold together with those of low."},
      {R"({"path": "/grades/0/when/all/0/below", "value": {"by": "S", "table": [[0, 1], [500, 2]]}})",
       "'grades[0].when.all[0].below.by' in x.json is \"S\"; it must be the name of an input with a unit."},
      {R"({"path": "/grades/0/when/all/0/below", "value": {"by": "B", "table": [[20, 1], [500, 2]]}})",
       "'grades[0].when.all[0].below.table' in x.json is [[20,1],[500,2]]; it must be pairs of rising numbers of the input with their "
       "limits, over all its valid values."},
      {R"({"path": "/grades/0/when/all/0/below", "value": {"by": "B", "table": [[1, 1], [1, 2], [500, 3]]}})",
       "'grades[0].when.all[0].below.table' in x.json is [[1,1],[1,2],[500,3]]; it must be pairs of rising numbers of the input with their "
       "limits, over all its valid values."},
      {R"({"path": "/tests/0/grade", "value": "high"})",
       "'tests[0].grade' in x.json is high; it must be low, which the conditions give; correct the one that is wrong."},
      {R"({"path": "/tests/2/grade", "value": "high"})",
       "'tests[2].grade' in x.json is high; it must be none, which the conditions give; correct the one that is wrong."},
      {R"({"path": "/tests/0/values/Q", "value": 1})", "'tests[0].values.Q' in x.json is not known here; it must be one of A, B, S."},
      {R"({"path": "/tests", "value": []})", "'tests' in x.json is a list of 0; it must be a list of 1 to 200 entries."},
  };
  for (const auto& [change, sentence] : bad) {
    json step = json::parse(change);
    const json::json_pointer at(step["path"].get<std::string>());
    step["op"] = !step.contains("value") ? "remove" : good.contains(at) ? "replace" : "add";
    const auto read = criteriaFromJson(good.patch(json::array({step})), "small", verbatim("x.json"));
    EXPECT_FALSE(read) << change;
    if (!read) {
      EXPECT_EQ(read.error().sentence(), sentence) << change;
    }
  }
}

TEST(Criteria, WithOverlappingTablesAreRefusedWhereTheyMeetInOneWeek) {
  json document = json::parse(std::ifstream(kCriteria / "umbilical-pi.json"));
  ASSERT_TRUE(criteriaFromJson(document, "x", verbatim("x.json")));
  document["grades"][1]["when"]["all"][0]["above"]["table"][2][1] = 1.24;  // 1.24 to 1.25 at 32 weeks are both
  const auto read = criteriaFromJson(document, "x", verbatim("x.json"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().sentence(),
            "'grades[1].when' in x.json is raised; it must be conditions that never hold together with those of usual.");
}

TEST(Criteria, AreRefusedWithAnyLimitThatDecidesWrong) {
  for (const auto& entry : std::filesystem::directory_iterator(kCriteria)) {
    const json whole = json::parse(std::ifstream(entry.path()));
    const json flat = whole["grades"].flatten();
    int changed = 0;
    for (const auto& field : flat.items()) {
      if (!field.value().is_number() || field.key().find("/when/") == std::string::npos) continue;
      if (field.key().find("/table/") != std::string::npos && field.key().ends_with("/0")) continue;  // a week
      for (const double factor : {0.99, 1.01}) {
        // Between two ways to one grade: what one leaves to the other is the same grade.
        if (entry.path().stem() == "carotid-iac-2021" && field.key() == "/2/when/any/1/all/0/below" && factor > 1.0) continue;
        json other = whole;
        other["grades"][json::json_pointer(field.key())] = field.value().get<double>() * factor;
        EXPECT_FALSE(criteriaFromJson(other, "x", verbatim("x.json"))) << entry.path() << field.key() << " times " << factor;
        ++changed;
      }
    }
    EXPECT_GT(changed, 0) << entry.path();
  }
}

TEST(Criteria, ThatAreNotThereOrNoJsonAreSaidSo) {
  EXPECT_EQ(readCriteria("/nowhere/x.json").error().code, ErrorCode::notFound);
  const auto file = std::filesystem::path(::testing::TempDir()) / "ew_criteria_test.json";
  std::ofstream(file) << "{";
  EXPECT_EQ(readCriteria(file).error().code, ErrorCode::badHeader);
  std::filesystem::remove(file);
  EXPECT_EQ(readAllCriteria("/nowhere").error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::measurement::criteria_test
