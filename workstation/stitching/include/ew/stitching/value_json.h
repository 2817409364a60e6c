#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/volume.h"

/// Numbers, points, matrices and grids as JSON, to the last bit. The ...From functions throw nlohmann's exceptions when a file was damaged.
namespace ew::stitching {

/// JSON has no infinity: "inf", "-inf" and "nan" are words.
[[nodiscard]] nlohmann::ordered_json number(double value);
[[nodiscard]] double numberFrom(const nlohmann::json& value);

template <class Numbers>
[[nodiscard]] nlohmann::ordered_json numbers(const Numbers& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto value : values) list.push_back(number(value));
  return list;
}
[[nodiscard]] std::vector<double> numbersFrom(const nlohmann::json& list);

/// One of these words by its name.
template <class Word>
[[nodiscard]] Word wordFrom(const nlohmann::json& value, std::initializer_list<Word> words) {
  for (const Word word : words)
    if (value == nameOf(word)) return word;
  throw nlohmann::json::other_error::create(501, "a word that is not known", &value);
}

/// Sixteen numbers, row by row.
template <class To, class From>
[[nodiscard]] nlohmann::ordered_json jsonOf(const Transform<To, From>& t) {
  return numbers(rowsOf(t));
}
[[nodiscard]] std::array<double, 16> rowsFrom(const nlohmann::json& json);
template <class To, class From>
[[nodiscard]] Transform<To, From> transformFrom(const nlohmann::json& json) {
  return {matrixFromRows(rowsFrom(json))};
}
[[nodiscard]] nlohmann::ordered_json jsonOf(const glm::dvec3& v);
[[nodiscard]] glm::dvec3 vectorFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const Grid& grid);
[[nodiscard]] Grid gridFrom(const nlohmann::json& json);

}  // namespace ew::stitching
