#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"
#include "ew/measurement/expression.h"
#include "ew/measurement/package.h"
#include "ew/measurement/quantity.h"
#include "ew/measurement/worksheet.h"

namespace ew::measurement {

inline constexpr int kCriteriaFormat = 1;  ///< `format` of criteria; a file with a larger one is refused with newerFormat

/// What a parameter is for: primary ones decide the grade, additional ones agree with it or do not, parts only enter formulas.
enum class CriteriaRole { primary, additional, part };
[[nodiscard]] std::string_view wordOf(CriteriaRole role);  ///< in files: "primary"

/// Something that criteria ask for: a measured value, or what was seen.
struct CriteriaInput {
  std::string name;  ///< "PSV"
  Words title;
  CriteriaRole role = CriteriaRole::primary;
  std::string of;  ///< the item or formula of a package that gives it, "vascular.ICA_PSV"; or empty
  Unit unit = Unit::one;
  Limits valid;                                        ///< a value outside is refused; not of what is seen
  std::vector<std::pair<std::string, Words>> choices;  ///< of what is seen: word and text; empty: a value
  std::string assumed;                                 ///< the choice that counts until another one is given; empty: none does
  bool operator==(const CriteriaInput&) const = default;
};

/// A parameter that follows from values.
struct CriteriaFormula {
  std::string name;  ///< "RATIO"
  Words title;
  CriteriaRole role = CriteriaRole::primary;
  Expression expression;  ///< of inputs by their names, in their units
  Unit unit = Unit::one;
  std::vector<TestVector> tests;  ///< at least one
  bool operator==(const CriteriaFormula&) const = default;
};

/// An end of a range: a number, or one that depends on another input, with straight lines between the rows of its table.
struct CriteriaLimit {
  double value = 0.0;                            ///< without a table
  std::string by;                                ///< input that the table goes by: "GA"; empty: no table
  std::vector<std::pair<double, double>> table;  ///< two or more rows, rising by the input, over all its valid values
  [[nodiscard]] double at(double x) const;       ///< @param x value of the input `by`, of no effect without a table
  bool operator==(const CriteriaLimit&) const = default;
};

/// That a value lies in a range, or that something was seen.
struct Condition {
  std::string of;  ///< name of an input or formula
  std::optional<CriteriaLimit> low, high;
  bool holdsLow = true;            ///< at the low end itself
  bool holdsHigh = true;           ///< at the high end itself
  Unit unit = Unit::one;           ///< of the ends: that of the input or formula
  std::vector<std::string> words;  ///< of what is seen: one of these
  bool operator==(const Condition&) const = default;
};

struct CriteriaGrade {
  std::string word;  ///< "from_50_to_69": the same in all criteria of a vessel that mean the same
  Words title;
  std::vector<std::vector<Condition>> when;  ///< any of these, each with all its conditions; of primary parameters
  std::vector<Condition> expects;            ///< what the other parameters are then; they do not decide
  bool operator==(const CriteriaGrade&) const = default;
};

struct CriteriaValue {
  Quantity quantity;   ///< of a value, in any unit that the input's can be converted to
  std::string choice;  ///< of what was seen: one of the words
  bool operator==(const CriteriaValue&) const = default;
};
using CriteriaValues = std::map<std::string, CriteriaValue>;  ///< by the names of inputs

/// Values whose grade is known apart from this program.
struct CriteriaTest {
  CriteriaValues values;
  std::string grade;  ///< its word; empty: none
  bool operator==(const CriteriaTest&) const = default;
};

/// How a laboratory grades by measured values: resources/criteria/*.json, resources/schemas/criteria.schema.json. Everything in it is data.
struct Criteria {
  std::string id;      ///< file name without ending: "carotid-sru-2003"
  int version = 1;     ///< rises when a number in it changes
  Words name;          ///< "SRU consensus"
  int year = 0;        ///< 0: its sources state none
  std::string vessel;  ///< "internal_carotid": criteria of one vessel are compared
  Words vesselTitle;
  std::string source;  ///< name, year, DOI or where it was read
  std::string status;  ///< how its numbers were checked
  std::vector<CriteriaInput> inputs;
  std::vector<CriteriaFormula> formulas;
  std::vector<CriteriaGrade> grades;  ///< from healthy to ill; no two hold at once
  std::vector<CriteriaTest> tests;    ///< at least one
  bool operator==(const Criteria&) const = default;

  [[nodiscard]] const CriteriaInput* input(std::string_view name) const;      ///< null when there is none
  [[nodiscard]] const CriteriaFormula* formula(std::string_view name) const;  ///< null when there is none
  [[nodiscard]] const Words& titleOf(std::string_view name) const;            ///< of an input or formula that there is
};

/// "SRU consensus (2003)". @param language of the name: "en", "de"
[[nodiscard]] Message criteriaName(const Words& name, int year, std::string_view language = "en");

/// @param where how sentences name the document: verbatim("carotid-sru-2003.json")
/// Criteria without a source, with grades that may hold at once, or that do not give the grades of their own tests, are refused.
/// @error badField, newerFormat
[[nodiscard]] Result<Criteria> criteriaFromJson(const nlohmann::json& document, const std::string& id, const Message& where);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as criteriaFromJson
[[nodiscard]] Result<Criteria> readCriteria(const std::filesystem::path& file);
/// All criteria of a folder, by id; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<Criteria>> readAllCriteria(const std::filesystem::path& folder);

/// A parameter with its value, held against a condition.
struct ConditionReading {
  Condition condition;
  Words title;  ///< of the parameter
  std::optional<Quantity> value;
  Words seen;                        ///< of what was seen
  std::vector<Words> asked;          ///< titles of the condition's words
  std::optional<double> low, high;   ///< the ends for these values
  bool isAssumed = false;            ///< nobody said what was seen
  bool isWithinUncertainty = false;  ///< of an end: the condition might as well be decided the other way
  bool operator==(const ConditionReading&) const = default;
};

/// A parameter that does not fit the grade.
struct Disagreement {
  ConditionReading expected;
  std::vector<Words> speaksFor;  ///< titles of the other grades that its value belongs to; may be empty
  bool operator==(const Disagreement&) const = default;
};

/// What criteria say of values.
struct Grade {
  std::string criteria;  ///< id
  Words name;
  int year = 0;
  std::string vessel;
  std::string source;
  std::string word;                                    ///< of the grade; empty: there is none
  Words title;                                         ///< of the grade
  std::vector<ConditionReading> decided;               ///< what it rests on
  std::vector<std::pair<std::string, Words>> missing;  ///< without a grade: inputs that would tell, name and title; empty: no grade fits
  std::vector<Words> possible;                         ///< without a grade: titles of those that may still hold
  std::vector<std::pair<Words, Words>> assumed;        ///< titles of inputs and of the choices they were given
  std::vector<Disagreement> disagreements;
  std::vector<Words> primaries;  ///< titles of the parameters that decide
  bool operator==(const Grade&) const = default;
};

/// Grades by one criterion. A condition whose values are not all there is not known; a grade is given when its conditions are known to
/// hold. A value that differs from an end by less than 1e-9 of it lies at the end, since formulas round. Uncertainties of values that a
/// formula takes are held independent of each other.
/// @param values those of other names are not looked at
/// @error badField (a unit that is none of the input's, a value outside of what can be true, no word of the input)
[[nodiscard]] Result<Grade> gradeOf(const Criteria& criteria, const CriteriaValues& values);

/// Grades by several. @error as gradeOf
[[nodiscard]] Result<std::vector<Grade>> gradesOf(const std::vector<Criteria>& all, const CriteriaValues& values);

/// What a worksheet holds for the inputs of criteria: those whose `of` names its package. @param side of sided items
[[nodiscard]] CriteriaValues valuesFrom(const Worksheet& worksheet, const Criteria& criteria, std::string_view side = {});

/// "125 to 230 cm/s", "above 4", "seen or unclear". @param language of titles: "en", "de"
[[nodiscard]] Message conditionText(const ConditionReading& reading, std::string_view language = "en");
/// The grade and what it rests on, or what is missing; then what was assumed, what lies at a limit, and what disagrees: a sentence each.
[[nodiscard]] std::vector<Message> sentencesOf(const Grade& grade, std::string_view language = "en");
/// Where grades of one vessel differ: a sentence for each two that do; empty: they agree, or there are fewer than two.
[[nodiscard]] std::vector<Message> differencesOf(const std::vector<Grade>& grades, std::string_view language = "en");
/// @param language of titles; sentences are English, as in reports of commands
[[nodiscard]] nlohmann::ordered_json toJson(const Grade& grade, std::string_view language = "en");

}  // namespace ew::measurement
