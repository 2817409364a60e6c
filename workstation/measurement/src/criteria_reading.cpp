#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/find_entry.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/measurement/criteria.h"
#include "reading_fields.h"

namespace ew::measurement {
namespace {

using nlohmann::json;

constexpr std::size_t kMostCriteriaEntries = 50;

constexpr WordTable<CriteriaRole, 3> kRoles{
    {{"primary", CriteriaRole::primary}, {"additional", CriteriaRole::additional}, {"part", CriteriaRole::part}}};

/// Whether no value fulfils both. @param x of the input that tables go by
bool exclude(const Condition& a, const Condition& b, double x) {
  if (a.of != b.of) return false;
  if (!a.words.empty())
    return std::none_of(a.words.begin(), a.words.end(),
                        [&](const auto& word) { return std::find(b.words.begin(), b.words.end(), word) != b.words.end(); });
  const auto below = [x](const Condition& lower, const Condition& upper) {
    if (!lower.high || !upper.low) return false;
    const double high = lower.high->at(x), low = upper.low->at(x);
    return high < low || (high == low && !(lower.holdsHigh && upper.holdsLow));
  };
  return below(a, b) || below(b, a);
}

/// Reads one file; what stands later in it refers to what was read before.
struct CriteriaReader {
  Criteria criteria;

  [[nodiscard]] bool knows(const std::string& name) const { return criteria.input(name) != nullptr || criteria.formula(name) != nullptr; }
  [[nodiscard]] bool isSeen(const std::string& name) const {
    return criteria.input(name) != nullptr && !criteria.input(name)->choices.empty();
  }
  [[nodiscard]] CriteriaRole roleOf(const std::string& name) const {
    const auto* input = criteria.input(name);
    return input != nullptr ? input->role : criteria.formula(name)->role;
  }
  [[nodiscard]] Unit unitOfName(const std::string& name) const {
    const auto* input = criteria.input(name);
    return input != nullptr ? input->unit : criteria.formula(name)->unit;
  }

  static void readChoices(const JsonFields& fields, CriteriaInput& input) {
    for (const char* other : {"unit", "valid"})
      if (fields.has(other)) fields.refuse(other, say<"left out of a choice">());
    for (const JsonFields& choice : fields.objects("choices", 2, 20)) {
      choice.only({"word", "title"});
      input.choices.emplace_back(labelIn(choice, "word"), wordsIn(choice, "title"));
    }
    if (!fields.has("assumed")) return;
    input.assumed = fields.text("assumed");
    if (std::none_of(input.choices.begin(), input.choices.end(), [&](const auto& each) { return each.first == input.assumed; }))
      fields.refuse("assumed", say<"a word of the choices">());
  }

  void readInputs(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("inputs", 1, kMostCriteriaEntries)) {
      CriteriaInput input;
      each.only({"name", "title", "role", "of", "unit", "valid", "choices", "assumed"});
      input.name = labelIn(each, "name");
      if (knows(input.name)) each.refuse("name", say<"a name that no other entry has">());
      input.title = wordsIn(each, "title");
      input.role = each.word("role", kRoles);
      input.of = each.text("of", "");
      if (each.has("choices")) {
        readChoices(each, input);
      } else {
        if (each.has("assumed")) each.refuse("assumed", say<"left out of a value">());
        input.unit = unitIn(each, "unit");
        input.valid = limitsIn(each, "valid");
      }
      criteria.inputs.push_back(std::move(input));
    }
  }

  void readFormulas(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("formulas", 0, kMostCriteriaEntries)) {
      CriteriaFormula formula;
      each.only({"name", "title", "role", "expression", "inputs", "unit", "tests"});
      formula.name = labelIn(each, "name");
      if (knows(formula.name)) each.refuse("name", say<"a name that no other entry has">());
      formula.title = wordsIn(each, "title");
      formula.role = each.word("role", kRoles);
      formula.unit = unitIn(each, "unit");
      std::vector<std::string> inputs = each.texts("inputs", 1, 12);
      for (const std::string& name : inputs)
        if (criteria.input(name) == nullptr || isSeen(name)) each.refuse("inputs", say<"names of inputs with a unit">());
      const std::string text = each.text("expression", {}, 1, 500);
      if (!each.good()) return;
      auto expression = Expression::of(text, std::move(inputs));
      if (!expression) {
        each.refuse("expression", verbatim('"' + text + '"'), expression.error().message);
        return;
      }
      formula.expression = std::move(*expression);
      readTestVectors(each, formula.expression, formula.tests);
      criteria.formulas.push_back(std::move(formula));
    }
  }

  CriteriaLimit tableIn(const JsonFields& fields, std::string_view key) const {
    CriteriaLimit limit;
    const JsonFields object = fields.object(key);
    object.only({"by", "table"});
    limit.by = object.text("by");
    const CriteriaInput* by = criteria.input(limit.by);
    if (by == nullptr || !by->choices.empty()) object.refuse("by", say<"the name of an input with a unit">());
    const Message expected = say<"pairs of rising numbers of the input with their limits, over all its valid values">();
    for (const json& row : object.list("table", 2, kMostCriteriaEntries, expected)) {
      const bool isPair =
          row.is_array() && row.size() == 2 && numberWithin(row[0], -kFarthest, kFarthest) && numberWithin(row[1], -kFarthest, kFarthest);
      if (!isPair || (!limit.table.empty() && !(*numberWithin(row[0], -kFarthest, kFarthest) > limit.table.back().first))) {
        object.refuse("table", expected);
        return limit;
      }
      limit.table.emplace_back(*numberWithin(row[0], -kFarthest, kFarthest), *numberWithin(row[1], -kFarthest, kFarthest));
    }
    if (object.good() && (by->valid.low < limit.table.front().first || by->valid.high > limit.table.back().first))
      object.refuse("table", expected);
    return limit;
  }

  /// An end under one of two names. Nothing when neither is there.
  std::optional<CriteriaLimit> endIn(const JsonFields& fields, std::string_view with, std::string_view without, bool& holds) const {
    if (fields.has(with) && fields.has(without)) fields.refuse(without, say<"left out, when the other kind of end is there">());
    holds = !fields.has(without);
    const std::string_view key = holds ? with : without;
    const json* value = fields.find(key);
    if (value == nullptr) return std::nullopt;
    if (value->is_object()) return tableIn(fields, key);
    return CriteriaLimit{fields.number(key, -kFarthest, kFarthest), {}, {}};
  }

  Condition conditionIn(const JsonFields& fields) const {
    Condition made;
    fields.only({"of", "from", "above", "to", "below", "unit", "is"});
    made.of = fields.text("of");
    if (!knows(made.of)) fields.refuse("of", say<"the name of an input or formula">());
    if (!fields.good()) return made;
    if (isSeen(made.of)) {
      for (const char* other : {"from", "above", "to", "below", "unit"})
        if (fields.has(other)) fields.refuse(other, say<"left out, since %1 is seen and not measured">(made.of));
      made.words = fields.texts("is", 1, 20);
      const auto& choices = criteria.input(made.of)->choices;
      for (const std::string& word : made.words)
        if (std::none_of(choices.begin(), choices.end(), [&](const auto& each) { return each.first == word; }))
          fields.refuse("is", say<"words of the choices">());
      return made;
    }
    if (fields.has("is")) fields.refuse("is", say<"left out, since %1 is measured">(made.of));
    made.unit = unitIn(fields, "unit");
    if (fields.good() && made.unit != unitOfName(made.of)) fields.refuse("unit", say<"the unit of %1">(made.of));
    made.low = endIn(fields, "from", "above", made.holdsLow);
    made.high = endIn(fields, "to", "below", made.holdsHigh);
    if (!made.low && !made.high) fields.refuse("from", say<"a limit, or one of above, to and below">());
    if (fields.good() && made.low && made.high && exclude(made, made, 0.0) && made.low->by.empty() && made.high->by.empty())
      fields.refuseWhole(verbatim(made.of), say<"a range with at least one value">());
    return made;
  }

  std::vector<Condition> conditionsIn(const JsonFields& fields, std::string_view key, std::size_t atLeast, bool decides) const {
    std::vector<Condition> made;
    for (const JsonFields& each : fields.objects(key, atLeast, kMostCriteriaEntries)) {
      made.push_back(conditionIn(each));
      if (!each.good()) return made;
      const CriteriaRole role = roleOf(made.back().of);
      if (decides && role != CriteriaRole::primary) each.refuse("of", say<"a primary parameter, since it decides">());
      if (role == CriteriaRole::part) each.refuse("of", say<"a parameter that is more than a part of a formula">());
    }
    return made;
  }

  void readGrades(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("grades", 2, kMostCriteriaEntries)) {
      CriteriaGrade grade;
      each.only({"word", "title", "when", "expects"});
      grade.word = labelIn(each, "word");
      if (entryWith(criteria.grades, &CriteriaGrade::word, grade.word) != nullptr)
        each.refuse("word", say<"a word that no other grade has">());
      grade.title = wordsIn(each, "title");
      const JsonFields when = each.object("when");
      when.only({"all", "any"});
      if (when.has("all") == when.has("any")) each.refuse("when", say<"an object with either \"all\" or \"any\"">());
      if (when.has("all")) grade.when.push_back(conditionsIn(when, "all", 1, true));
      for (const JsonFields& way : when.objects("any", when.has("any") ? 1 : 0, kMostCriteriaEntries)) {
        way.only({"all"});
        grade.when.push_back(conditionsIn(way, "all", 1, true));
      }
      grade.expects = conditionsIn(each, "expects", 0, false);
      if (!each.good()) return;
      for (const CriteriaGrade& other : criteria.grades)
        if (overlap(grade, other))
          each.refuse("when", verbatim(grade.word), say<"conditions that never hold together with those of %1">(other.word));
      criteria.grades.push_back(std::move(grade));
    }
  }

  /// Where ends go by a table, at each of its rows; formulas count as if they did not depend on what they are made of.
  static bool overlap(const CriteriaGrade& a, const CriteriaGrade& b) {
    std::set<double> places;
    for (const auto* grade : {&a, &b})
      for (const auto& way : grade->when)
        for (const Condition& condition : way)
          for (const auto& end : {condition.low, condition.high})
            if (end)
              for (const auto& row : end->table) places.insert(row.first);
    if (places.empty()) places.insert(0.0);
    for (const double x : places)
      for (const auto& one : a.when)
        for (const auto& other : b.when) {
          const bool apart = std::any_of(one.begin(), one.end(), [&](const Condition& c) {
            return std::any_of(other.begin(), other.end(), [&](const Condition& d) { return exclude(c, d, x); });
          });
          if (!apart) return true;
        }
    return false;
  }

  void readTests(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("tests", 1, 200)) {
      each.only({"values", "grade"});
      const JsonFields values = each.object("values");
      CriteriaTest test;
      std::vector<std::string> names;
      for (const CriteriaInput& input : criteria.inputs) {
        names.push_back(input.name);
        if (!values.has(input.name)) continue;
        if (input.choices.empty())
          test.values[input.name].quantity = {values.number(input.name, -kFarthest, kFarthest), 0.0, input.unit};
        else
          test.values[input.name].choice = values.text(input.name);
      }
      values.only(names);
      test.grade = each.text("grade", "");
      if (!each.good()) return;
      const auto found = gradeOf(criteria, test.values);
      if (!found) {
        each.reading().refuse(found.error());
        return;
      }
      if (found->word != test.grade)
        each.refuse("grade", verbatim(test.grade.empty() ? "none" : test.grade),
                    say<"%1, which the conditions give; correct the one that is wrong">(found->word.empty() ? "none" : found->word));
      criteria.tests.push_back(std::move(test));
    }
  }
};

}  // namespace

std::string_view wordOf(CriteriaRole role) { return wordIn(kRoles, role); }

Result<Criteria> criteriaFromJson(const json& document, const std::string& id, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kCriteriaFormat);
  fields.only({"format", "version", "name", "year", "vessel", "vessel_title", "source", "status", "inputs", "formulas", "grades", "tests"});
  CriteriaReader reader;
  reader.criteria.id = id;
  reader.criteria.version = static_cast<int>(fields.whole("version", 1, 1000000));
  reader.criteria.name = wordsIn(fields, "name");
  reader.criteria.year = static_cast<int>(fields.whole("year", 1950, 2100, 0));
  reader.criteria.vessel = labelIn(fields, "vessel");
  reader.criteria.vesselTitle = wordsIn(fields, "vessel_title");
  reader.criteria.source = fields.text("source", {}, 1, kLongestText);
  reader.criteria.status = fields.text("status", {}, 1, kLongestText);
  reader.readInputs(fields);
  reader.readFormulas(fields);
  if (reading.good()) reader.readGrades(fields);
  if (reading.good()) reader.readTests(fields);
  if (reading.problem()) return passOn(*reading.problem());
  return std::move(reader.criteria);
}

Result<Criteria> readCriteria(const std::filesystem::path& file) {
  const Message where = say<"the criteria %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return criteriaFromJson(*document, file.stem().string(), where);
}

Result<std::vector<Criteria>> readAllCriteria(const std::filesystem::path& folder) {
  return readEvery<Criteria>(folder, say<"criteria">(), readCriteria);
}

}  // namespace ew::measurement
