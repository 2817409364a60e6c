#include "files/header_fields.h"

#include <algorithm>
#include <cmath>

#include "ew/core/numbers.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {

Message whoIs(FieldsOf of) {
  switch (of) {
    case FieldsOf::header:
      return say<"The header">();
    case FieldsOf::deviceSet:
      return say<"The device set">();
  }
  return {};
}

Message unusedBecause(FieldTouches touches, const Message& who, const Message& fields) {
  switch (touches) {
    case FieldTouches::geometry:
      return say<"%1 also states %2, which touches sizes and places and is not used.">(who, fields);
    case FieldTouches::levels:
      return say<"%1 also states %2, which touches the grey levels and is not used.">(who, fields);
    case FieldTouches::time:
      return say<"%1 also states %2, which touches the times and is not used.">(who, fields);
    case FieldTouches::count:
      return say<"%1 also states %2, which touches how many images there are and is not used.">(who, fields);
    case FieldTouches::nobodyKnows:
      return say<"%1 also states %2, which is not known here and not used.">(who, fields);
    case FieldTouches::nothing:
      break;
  }
  return {};
}

FieldState stateOf(std::span<const double> numbers, NumbersKind kind) {
  const auto above = static_cast<std::size_t>(std::count_if(numbers.begin(), numbers.end(), [](double value) { return value > 0.0; }));
  const auto setIf = [](bool isSet) { return isSet ? FieldState::value : FieldState::notSet; };
  switch (kind) {
    case NumbersKind::place:
      return FieldState::value;
    case NumbersKind::lengths:
      return above == 0 || above == numbers.size() ? setIf(above > 0) : FieldState::unusable;
    case NumbersKind::rectangle:
    case NumbersKind::reach:
      return setIf(above == numbers.size());
    case NumbersKind::interval:
      return setIf(numbers.front() != numbers.back());
    case NumbersKind::distance:
      return setIf(std::all_of(numbers.begin(), numbers.end(), [](double value) { return value >= 0.0; }));
  }
  return FieldState::unusable;
}

}  // namespace

void HeaderFields::meet(std::string_view name, std::string_view value) {
  if (trimmed(value).empty()) return;
  const auto known = std::find_if(stated_.begin(), stated_.end(), [&](const Stated& each) { return each.name == name; });
  if (known == stated_.end()) stated_.push_back({std::string(name), std::string(trimmed(value)), false});
}

std::optional<std::string> HeaderFields::take(std::string_view name) {
  for (Stated& each : stated_)
    if (each.name == name) {
      each.used = true;
      return each.value;
    }
  return std::nullopt;
}

std::optional<std::string> HeaderFields::stated(std::string_view name) const {
  for (const Stated& each : stated_)
    if (each.name == name) return each.value;
  return std::nullopt;
}

void HeaderFields::use(std::string_view name) { static_cast<void>(take(name)); }

FieldTouches HeaderFields::touchedBy(std::string_view name) const {
  const auto known = std::find_if(table_.begin(), table_.end(), [&](const FieldTableRow& each) { return each.name == name; });
  return known == table_.end() ? unknown_ : known->touches;
}

std::vector<Message> HeaderFields::unused() const {
  constexpr std::size_t most = 6;  // more would be a wall that nobody reads
  std::vector<Message> notes;
  for (const FieldTouches touches :
       {FieldTouches::geometry, FieldTouches::levels, FieldTouches::time, FieldTouches::count, FieldTouches::nobodyKnows}) {
    std::vector<Message> fields;
    std::size_t further = 0;
    for (const Stated& each : stated_) {
      if (each.used || touchedBy(each.name) != touches) continue;
      if (fields.size() == most)
        ++further;
      else
        fields.push_back(each.value.find('"') == std::string::npos
                             ? say<"%1 \"%2\"">(shortened(each.name), shortened(each.value))
                             : verbatim(shortened(each.name) + " " + shortened(each.value)));  // it has quotes of its own
    }
    if (fields.empty()) continue;
    const Message list = joined(std::move(fields), ", ");
    notes.push_back(unusedBecause(touches, whoIs(of_), further == 0 ? list : say<"%1 and %2 more">(list, further)));
  }
  return notes;
}

FieldNumbers statedNumbers(const std::optional<std::string>& found, std::size_t count, NumbersKind kind) {
  if (!found) return {.state = FieldState::absent};
  if (trimmed(*found).empty()) return {.state = FieldState::notSet};
  auto numbers = parseNumbers(*found);
  if (!numbers || numbers->size() != count) return {.state = FieldState::unusable};
  if (std::all_of(numbers->begin(), numbers->end(), [](double value) { return std::isnan(value); })) return {.state = FieldState::notSet};
  if (std::any_of(numbers->begin(), numbers->end(), [](double value) { return !std::isfinite(value); }))
    return {.state = FieldState::unusable};
  const FieldState state = stateOf(*numbers, kind);
  if (state != FieldState::value) return {.state = state};
  return {.state = state, .values = *std::move(numbers)};
}

}  // namespace ew::detail
