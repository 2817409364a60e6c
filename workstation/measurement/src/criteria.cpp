#include "ew/measurement/criteria.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ew/core/contract.h"
#include "ew/core/find_entry.h"
#include "ew/core/numbers.h"
#include "value_text.h"

namespace ew::measurement {
namespace {

enum class Truth { holds, fails, unknown };

/// 36.5 cm/s times 1.5, divided by 36.5 cm/s, is 1.5 but for its last digit.
bool isAt(double value, double end) { return std::abs(value - end) <= 1e-9 * std::abs(end); }

const Words& titleOfChoice(const CriteriaInput& input, std::string_view word) {
  return std::find_if(input.choices.begin(), input.choices.end(), [&](const auto& each) { return each.first == word; })->second;
}

/// Grades values by one criterion.
class Grading {
 public:
  explicit Grading(const Criteria& criteria) : criteria_(criteria) {}

  Result<void> take(const CriteriaValues& values) {
    for (const CriteriaInput& input : criteria_.inputs) {
      const auto found = values.find(input.name);
      if (found != values.end()) {
        if (auto taken = takeOne(input, found->second); !taken) return taken;
      } else if (!input.assumed.empty()) {
        seen_[input.name] = input.assumed;
        assumed_.insert(input.name);
      }
    }
    for (const CriteriaFormula& formula : criteria_.formulas) compute(formula);
    return {};
  }

  Grade graded() const {
    Grade grade;
    grade.criteria = criteria_.id;
    grade.name = criteria_.name;
    grade.year = criteria_.year;
    grade.vessel = criteria_.vessel;
    grade.source = criteria_.source;
    for (const CriteriaInput& input : criteria_.inputs)
      if (input.role == CriteriaRole::primary) grade.primaries.push_back(input.title);
    for (const CriteriaFormula& formula : criteria_.formulas)
      if (formula.role == CriteriaRole::primary) grade.primaries.push_back(formula.title);
    for (const std::string& name : assumed_) {
      const CriteriaInput& input = *criteria_.input(name);
      grade.assumed.emplace_back(input.title, titleOfChoice(input, input.assumed));
    }
    for (const CriteriaGrade& each : criteria_.grades)
      for (const auto& way : each.when)
        if (grade.word.empty() && truthOf(way) == Truth::holds) decide(each, way, grade);
    if (grade.word.empty()) tellWhatIsMissing(grade);
    return grade;
  }

 private:
  Result<void> takeOne(const CriteriaInput& input, const CriteriaValue& value) {
    if (!input.choices.empty()) {
      if (std::none_of(input.choices.begin(), input.choices.end(), [&](const auto& each) { return each.first == value.choice; }))
        return failure(ErrorCode::badField, say<"%1 is answered by one of %2.">(input.name, choiceList(input.choices)),
                       {{"field", input.name}});
      seen_[input.name] = value.choice;
      return {};
    }
    if (!areComparable(value.quantity.unit, input.unit))
      return failure(ErrorCode::badField,
                     say<"%1 is measured in %2, not in '%3'.">(input.name, std::string(symbolOf(input.unit)),
                                                               std::string(symbolOf(value.quantity.unit))),
                     {{"field", input.name}});
    const Quantity here = converted(value.quantity, input.unit);
    if (!input.valid.hold(here.value) || !(here.uncertainty >= 0.0) || !std::isfinite(here.uncertainty))
      return failure(ErrorCode::badField,
                     say<"%1 of %2 cannot be graded by %3: it lies from %4 to %5; check the value and its unit.">(
                         input.name, inUnit(here.value, input.unit), criteriaName(criteria_.name, criteria_.year),
                         inUnit(input.valid.low, input.unit), inUnit(input.valid.high, input.unit)),
                     {{"field", input.name}, {"found", textOf(here.value)}});
    values_[input.name] = here;
    return {};
  }

  void compute(const CriteriaFormula& formula) {
    std::vector<double> inputs;
    for (const std::string& name : formula.expression.inputs()) {
      const auto found = values_.find(name);
      if (found == values_.end()) return;
      inputs.push_back(found->second.value);
    }
    const double result = formula.expression.evaluate(inputs);
    if (std::isnan(result)) return;
    const auto slopes = formula.expression.derivatives(inputs);
    double variance = 0.0;
    for (std::size_t n = 0; n < inputs.size(); ++n)
      variance += std::pow(slopes[n] * values_.at(formula.expression.inputs()[n]).uncertainty, 2);
    values_[formula.name] = {result, std::sqrt(variance), formula.unit};
  }

  /// The end for these values; empty: what its table goes by is not known.
  [[nodiscard]] std::optional<double> endOf(const std::optional<CriteriaLimit>& limit) const {
    if (!limit) return std::nullopt;
    if (limit->by.empty()) return limit->value;
    const auto by = values_.find(limit->by);
    return by == values_.end() ? std::nullopt : std::optional(limit->at(by->second.value));
  }

  [[nodiscard]] Truth truthOf(const Condition& condition) const {
    if (!condition.words.empty()) {
      const auto seen = seen_.find(condition.of);
      if (seen == seen_.end()) return Truth::unknown;
      return std::find(condition.words.begin(), condition.words.end(), seen->second) != condition.words.end() ? Truth::holds : Truth::fails;
    }
    const auto found = values_.find(condition.of);
    if (found == values_.end()) return Truth::unknown;
    const double value = found->second.value;
    const auto low = endOf(condition.low), high = endOf(condition.high);
    if (low && (isAt(value, *low) ? !condition.holdsLow : value < *low)) return Truth::fails;
    if (high && (isAt(value, *high) ? !condition.holdsHigh : value > *high)) return Truth::fails;
    return low.has_value() == condition.low.has_value() && high.has_value() == condition.high.has_value() ? Truth::holds : Truth::unknown;
  }

  [[nodiscard]] Truth truthOf(const std::vector<Condition>& way) const {
    Truth all = Truth::holds;
    for (const Condition& condition : way) {
      const Truth one = truthOf(condition);
      if (one == Truth::fails) return one;
      if (one == Truth::unknown) all = one;
    }
    return all;
  }

  [[nodiscard]] ConditionReading readingOf(const Condition& condition) const {
    ConditionReading made;
    made.condition = condition;
    made.title = criteria_.titleOf(condition.of);
    made.isAssumed = assumed_.contains(condition.of);
    if (const auto seen = seen_.find(condition.of); seen != seen_.end())
      made.seen = titleOfChoice(*criteria_.input(condition.of), seen->second);
    for (const std::string& word : condition.words) made.asked.push_back(titleOfChoice(*criteria_.input(condition.of), word));
    const auto found = values_.find(condition.of);
    if (found == values_.end()) return made;
    made.value = found->second;
    made.low = endOf(condition.low);
    made.high = endOf(condition.high);
    for (const auto& end : {made.low, made.high})
      if (end && std::abs(*end - made.value->value) < made.value->uncertainty) made.isWithinUncertainty = true;
    return made;
  }

  void decide(const CriteriaGrade& found, const std::vector<Condition>& way, Grade& grade) const {
    grade.word = found.word;
    grade.title = found.title;
    for (const Condition& condition : way) grade.decided.push_back(readingOf(condition));
    for (const Condition& condition : found.expects)
      if (truthOf(condition) == Truth::fails) grade.disagreements.push_back({readingOf(condition), spokenForBy(condition.of, found)});
  }

  /// Titles of the other grades that a parameter belongs to by itself.
  [[nodiscard]] std::vector<Words> spokenForBy(const std::string& name, const CriteriaGrade& found) const {
    std::vector<Words> titles;
    for (const CriteriaGrade& each : criteria_.grades) {
      if (each.word == found.word) continue;
      const auto speaks = [&](const Condition& condition) { return condition.of == name && truthOf(condition) == Truth::holds; };
      const bool byOthers = std::any_of(each.expects.begin(), each.expects.end(), speaks);
      const bool byWay =
          std::any_of(each.when.begin(), each.when.end(), [&](const auto& way) { return std::any_of(way.begin(), way.end(), speaks); });
      if (byOthers || byWay) titles.push_back(each.title);
    }
    return titles;
  }

  void tellWhatIsMissing(Grade& grade) const {
    std::set<std::string> names;
    const auto add = [&](const std::string& name) {
      if (const CriteriaFormula* formula = criteria_.formula(name))
        names.insert(formula->expression.inputs().begin(), formula->expression.inputs().end());
      else
        names.insert(name);
    };
    for (const CriteriaGrade& each : criteria_.grades) {
      bool isPossible = false;
      for (const auto& way : each.when) {
        if (truthOf(way) != Truth::unknown) continue;
        isPossible = true;
        for (const Condition& condition : way) {
          if (truthOf(condition) != Truth::unknown) continue;
          add(condition.of);
          for (const auto& end : {condition.low, condition.high})
            if (end && !end->by.empty()) names.insert(end->by);
        }
      }
      if (isPossible) grade.possible.push_back(each.title);
    }
    for (const CriteriaInput& input : criteria_.inputs)
      if (names.contains(input.name) && !values_.contains(input.name) && !seen_.contains(input.name))
        grade.missing.emplace_back(input.name, input.title);
  }

  const Criteria& criteria_;
  std::map<std::string, Quantity> values_;  // of inputs and formulas
  std::map<std::string, std::string> seen_;
  std::set<std::string> assumed_;
};

}  // namespace

double CriteriaLimit::at(double x) const {
  if (table.empty()) return value;
  EW_EXPECTS(table.size() >= 2);
  const auto next = std::find_if(table.begin() + 1, table.end() - 1, [&](const auto& row) { return row.first >= x; });
  const auto before = next - 1;
  return std::lerp(before->second, next->second, (x - before->first) / (next->first - before->first));
}

const CriteriaInput* Criteria::input(std::string_view wanted) const { return entryWith(inputs, &CriteriaInput::name, wanted); }
const CriteriaFormula* Criteria::formula(std::string_view wanted) const { return entryWith(formulas, &CriteriaFormula::name, wanted); }

const Words& Criteria::titleOf(std::string_view of) const {
  static const Words kNothing;
  if (const CriteriaInput* found = input(of)) return found->title;
  const CriteriaFormula* found = formula(of);
  EW_EXPECTS(found != nullptr);
  return found == nullptr ? kNothing : found->title;
}

Result<Grade> gradeOf(const Criteria& criteria, const CriteriaValues& values) {
  Grading grading(criteria);
  if (auto taken = grading.take(values); !taken) return passOn(taken.error());
  return grading.graded();
}

Result<std::vector<Grade>> gradesOf(const std::vector<Criteria>& all, const CriteriaValues& values) {
  std::vector<Grade> grades;
  for (const Criteria& criteria : all) {
    auto grade = gradeOf(criteria, values);
    if (!grade) return passOn(grade.error());
    grades.push_back(std::move(*grade));
  }
  return grades;
}

CriteriaValues valuesFrom(const Worksheet& worksheet, const Criteria& criteria, std::string_view side) {
  CriteriaValues values;
  for (const CriteriaInput& input : criteria.inputs) {
    if (!input.of.starts_with(worksheet.package + ".")) continue;
    const std::string_view label = std::string_view(input.of).substr(worksheet.package.size() + 1);
    if (label == kByDates && worksheet.gestation_weeks) values[input.name].quantity = {*worksheet.gestation_weeks, 0.0, Unit::weeks};
    const WorksheetRow* row = worksheet.row(label, side);
    if (row == nullptr) row = worksheet.row(label);  // of no side: the aorta
    if (row == nullptr) continue;
    if (row->value && input.choices.empty()) values[input.name].quantity = *row->value;
    if (!row->choice.empty() && !input.choices.empty()) values[input.name].choice = row->choice;
  }
  return values;
}

}  // namespace ew::measurement
