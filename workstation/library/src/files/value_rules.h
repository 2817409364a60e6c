#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// What a schema says a value must be, in its own words, is a text as those of say() are: entered once, and kept as long as the program
/// runs, for whatever language a window has. A plugin brings the words of its schema with its own.
[[nodiscard]] Message expectation(const std::string& description);

/// The schema of case.json, as it is written.
[[nodiscard]] const nlohmann::json& caseRules();

/// Holds values against what the schema of case.json says of the fields they are written as, and says what is wrong as schemaProblems says
/// it: limits and expectations stand in the schema and nowhere else. Types are not asked for: a value has its own.
class ValueRules {
 public:
  /// Of the whole document. @param problems what is wrong is appended; outlives this
  explicit ValueRules(std::vector<Error>& problems) : ValueRules(caseRules(), {}, problems) {}

  /// The rules of an object in this one.
  [[nodiscard]] ValueRules in(const char* field) const;

  void text(const char* field, const std::string& value) const;
  void textIfAny(const char* field, const std::string& value) const;  ///< an empty one is not written
  void number(const char* field, double value) const;
  void number(const char* field, const std::optional<double>& value) const;
  void number(const char* field, const std::optional<int>& value) const;
  void texts(const char* field, const std::vector<std::string>& values) const;
  /// A list of objects; `each` holds one against its rules.
  void list(const char* field, std::size_t size, const std::function<void(const ValueRules& rules, std::size_t number)>& each) const;
  /// Says of this object that it is not what the schema expects.
  void refuse(const Message& found) const;

 private:
  ValueRules(const nlohmann::json& rule, std::string place, std::vector<Error>& problems)
      : rule_(&rule), place_(std::move(place)), problems_(&problems) {}
  [[nodiscard]] ValueRules item(const char* field, std::size_t number) const;
  void checkText(const std::string& value) const;
  void checkNumber(double value, const nlohmann::json& asWritten) const;
  void checkSize(std::size_t size) const;

  const nlohmann::json* rule_;
  std::string place_;
  std::vector<Error>* problems_;
};

}  // namespace ew
