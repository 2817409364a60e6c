#include "files/value_rules.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "ew/core/json_fields.h"

namespace ew {
namespace {

/// As the schema counts them: letters, and not their bytes.
std::size_t lettersOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool fitsPattern(const std::string& text, const nlohmann::json& rule) {
  // std::regex recurses once per character: a text that is longer than its rule allows must never reach it.
  if (rule.contains("maxLength") && text.size() > rule["maxLength"].get<std::size_t>()) return false;
  return std::regex_search(text, std::regex(rule["pattern"].get<std::string>()));
}

bool fitsText(const std::string& text, const nlohmann::json& rule) {
  const std::size_t letters = lettersOf(text);
  if (rule.contains("minLength") && letters < rule["minLength"].get<std::size_t>()) return false;
  if (rule.contains("maxLength") && letters > rule["maxLength"].get<std::size_t>()) return false;
  if (rule.contains("enum") && std::find(rule["enum"].begin(), rule["enum"].end(), text) == rule["enum"].end()) return false;
  return !rule.contains("pattern") || fitsPattern(text, rule);
}

bool fitsNumber(double value, const nlohmann::json& rule) {
  if (!std::isfinite(value)) return false;
  if (rule.contains("minimum") && value < rule["minimum"].get<double>()) return false;
  if (rule.contains("exclusiveMinimum") && value <= rule["exclusiveMinimum"].get<double>()) return false;
  return !rule.contains("maximum") || value <= rule["maximum"].get<double>();
}

}  // namespace

ValueRules ValueRules::in(const char* field) const {
  return {rule_->at("properties").at(field), place_.empty() ? std::string(field) : place_ + "." + field, *problems_};
}

ValueRules ValueRules::item(const char* field, std::size_t number) const {
  const ValueRules list = in(field);
  return {list.rule_->at("items"), list.place_ + "[" + std::to_string(number) + "]", *problems_};
}

void ValueRules::refuse(const Message& found) const {
  problems_->push_back(fieldError(verbatim("case.json"), place_, found, expectation(rule_->at("description").get<std::string>())));
}

void ValueRules::checkText(const std::string& value) const {
  if (!fitsText(value, *rule_)) refuse(shown(value));
}

void ValueRules::checkNumber(double value, const nlohmann::json& asWritten) const {
  if (!fitsNumber(value, *rule_)) refuse(std::isfinite(value) ? shown(asWritten) : say<"not a number">());
}

void ValueRules::checkSize(std::size_t size) const {
  if (!rule_->contains("maxItems") || size <= (*rule_)["maxItems"].get<std::size_t>()) return;
  refuse(say<"a list of %1">(size));
}

void ValueRules::text(const char* field, const std::string& value) const { in(field).checkText(value); }

void ValueRules::textIfAny(const char* field, const std::string& value) const {
  if (!value.empty()) text(field, value);
}

void ValueRules::number(const char* field, double value) const { in(field).checkNumber(value, value); }

void ValueRules::number(const char* field, const std::optional<double>& value) const {
  if (value) number(field, *value);
}

void ValueRules::number(const char* field, const std::optional<int>& value) const {
  if (value) in(field).checkNumber(*value, *value);
}

void ValueRules::texts(const char* field, const std::vector<std::string>& values) const {
  in(field).checkSize(values.size());
  for (std::size_t n = 0; n < values.size(); ++n) item(field, n).checkText(values[n]);
}

void ValueRules::list(const char* field, std::size_t size,
                      const std::function<void(const ValueRules& rules, std::size_t number)>& each) const {
  in(field).checkSize(size);
  for (std::size_t n = 0; n < size; ++n) each(item(field, n), n);
}

}  // namespace ew
