#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/result.h"

namespace ew {

// The one way from a JSON document of a user to values: every field of every file is asked for here, so that all of them are refused in
// the same words, "'FIELD' in WHERE is FOUND; it must be EXPECTED.", and none can hold a number that is not finite.
//
//   JsonReading reading(verbatim("probe.json"));
//   const JsonFields probe(document, reading);
//   probe.only({"name", "width_mm", "kind", "focus"});
//   made.name = probe.text("name");
//   made.width_mm = probe.number("width_mm", 5.0, 300.0, made.width_mm);   // absent: as it was
//   made.kind = probe.word("kind", kKinds);
//   made.depth_mm = probe.object("focus").number("depth_mm", 0.0, 1000.0, 0.0);
//   if (reading.problem()) return passOn(*reading.problem());

/// A value as a person recognises it, on one line and of at most 62 bytes: as it stands in a file when it is short, else what it is
/// ("a list of 300", "a text of 5000 bytes"). Text that is not UTF-8 has replacement characters.
[[nodiscard]] Message shown(const nlohmann::json& value);

/// "'FIELD' in WHERE is FOUND; it must be EXPECTED.", of the whole document when `field` is empty. Code badField, with the context
/// "field", "found", "expected" and "in".
[[nodiscard]] Error fieldError(const Message& where, const std::string& field, const Message& found, const Message& expected);

/// What keeps a matrix from being a placement (checkRigid), said of a field: "'FIELD' in WHERE cannot be used. …"; empty: nothing does.
[[nodiscard]] std::optional<Error> rigidProblem(const glm::dmat4& matrix, const std::string& field, const Message& where);

/// Parses JSON from an untrusted file. Nesting beyond kDeepestNesting is refused: writing out or destroying a value recurses.
/// @param where how sentences name the document: verbatim("case.json")
/// @error badHeader with line and column
[[nodiscard]] Result<nlohmann::json> parseJson(std::string_view text, const Message& where);

/// parseJson() of a document that is one object. @error badHeader
[[nodiscard]] Result<nlohmann::json> parseJsonObject(std::string_view text, const Message& where);

/// What reading one document has met so far: the first field that cannot be used. A reader reads on to its end and asks once, since after
/// a problem every field gives its fallback.
class JsonReading {
 public:
  /// @param where   how sentences name the document: verbatim("case.json"), say<"the stitch project">()
  /// @param welcome names of texts that every object of the document may have and nobody reads: "note"
  explicit JsonReading(Message where, std::vector<std::string> welcome = {}) : where_(std::move(where)), welcome_(std::move(welcome)) {}

  [[nodiscard]] const Message& where() const { return where_; }
  [[nodiscard]] const std::vector<std::string>& welcome() const { return welcome_; }
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  [[nodiscard]] bool good() const { return !problem_; }
  /// Keeps the problem, unless there is an earlier one. @param field by its place in the document: "stations[2].near_mm"
  void refuse(const std::string& field, const Message& found, const Message& expected);
  void refuse(Error problem);

 private:
  Message where_;
  std::vector<std::string> welcome_;
  std::optional<Error> problem_;
};

/// One object of a document and its place in it. Cheap to copy; lives no longer than the document and its reading.
/// A field without a fallback has to be there. All limits are inclusive and finite.
class JsonFields {
 public:
  /// @param value refused unless it is an object; then every field is absent
  /// @param place in the document: "stations[2]"; empty for the document itself
  JsonFields(const nlohmann::json& value, JsonReading& reading, std::string place = {});

  [[nodiscard]] JsonReading& reading() const { return *reading_; }
  [[nodiscard]] bool good() const { return reading_->good(); }
  [[nodiscard]] const nlohmann::json& value() const { return *object_; }
  [[nodiscard]] const std::string& place() const { return place_; }
  /// The same object by another place, which says more about it: "organs[2] (liver)".
  [[nodiscard]] JsonFields called(std::string place) const { return {*object_, *reading_, std::move(place)}; }
  /// The place of a field, as sentences name it.
  [[nodiscard]] std::string placeOf(std::string_view key) const;
  /// Null when it is not there.
  [[nodiscard]] const nlohmann::json* find(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }

  void refuse(std::string_view key, const Message& found, const Message& expected) const;
  /// What was found is what stands in the document, or "missing".
  void refuse(std::string_view key, const Message& expected) const;

  /// The object as a whole.
  void refuseWhole(const Message& found, const Message& expected) const { reading_->refuse(place_, found, expected); }

  /// Refuses names that are none of these.
  void only(std::span<const std::string> known) const;
  void only(std::initializer_list<std::string_view> known) const;

  /// A finite number. @param expected what the sentence asks for instead of "a number from LOWEST to HIGHEST"
  double number(std::string_view key, double lowest, double highest, std::optional<double> fallback = {},
                const Message& expected = {}) const;
  /// A whole number, also one written as 3.0; within the 53 bits that a double counts by ones.
  long long whole(std::string_view key, long long lowest, long long highest, std::optional<long long> fallback = {},
                  const Message& expected = {}) const;
  /// Between `atLeast` and `atMost` numbers. Empty after a problem and when an optional list is not there.
  std::vector<double> numbers(std::string_view key, std::size_t atLeast, std::size_t atMost, double lowest, double highest,
                              bool needed = true, const Message& expected = {}) const;
  /// Three numbers of at most `farthest` either way.
  glm::dvec3 point(std::string_view key, double farthest, std::optional<glm::dvec3> fallback = {}, const Message& expected = {}) const;
  /// A rotation and a translation: 16 numbers, row by row. Empty after a problem and when it is not there. @error also notRigid
  std::optional<glm::dmat4> rigid(std::string_view key, const Message& expected = {}) const;
  bool flag(std::string_view key, std::optional<bool> fallback = {}) const;
  /// A text of `atLeast` to `atMost` bytes.
  std::string text(std::string_view key, std::optional<std::string> fallback = {}, std::size_t atLeast = 1, std::size_t atMost = 200,
                   const Message& expected = {}) const;
  /// Several texts of 1 to 200 bytes. Empty after a problem and when an optional list (`atLeast` 0) is not there.
  std::vector<std::string> texts(std::string_view key, std::size_t atLeast, std::size_t atMost, const Message& expected = {}) const;

  /// The value that a word of the file stands for. @param words pairs of a word and its value
  template <class Word, class E, std::size_t N>
  E word(std::string_view key, const std::array<std::pair<Word, E>, N>& words, std::optional<E> fallback = {}) const {
    std::array<std::string_view, N> names;
    for (std::size_t n = 0; n < N; ++n) names[n] = words[n].first;
    const auto found = wordAmong(key, names, !fallback);
    return found ? words[*found].second : fallback.value_or(words[0].second);
  }

  /// The object of a field; without fields when it is not there.
  [[nodiscard]] JsonFields object(std::string_view key) const;
  /// The objects of a list, each with its place; none when an optional list (`atLeast` 0) is not there.
  [[nodiscard]] std::vector<JsonFields> objects(std::string_view key, std::size_t atLeast, std::size_t atMost,
                                                const Message& expected = {}) const;
  /// Any values in a list: its elements are read with their own rules. An empty list after a problem and when an optional one is not there.
  [[nodiscard]] const nlohmann::json& list(std::string_view key, std::size_t atLeast, std::size_t atMost,
                                           const Message& expected = {}) const;

 private:
  [[nodiscard]] std::optional<std::size_t> wordAmong(std::string_view key, std::span<const std::string_view> words, bool needed) const;

  const nlohmann::json* object_;
  JsonReading* reading_;
  std::string place_;
};

/// The number at `value` if it is one from `lowest` to `highest`.
[[nodiscard]] std::optional<double> numberWithin(const nlohmann::json& value, double lowest, double highest);

/// How sentences and manuals ask for a number: "a number from 0 to 1", "a whole number from 1 to 8".
[[nodiscard]] Message rangeText(double lowest, double highest);
[[nodiscard]] Message wholeRangeText(long long lowest, long long highest);
/// ... and for a word: "\"a\", \"b\" or \"c\"".
[[nodiscard]] Message wordsText(std::span<const std::string_view> words);

}  // namespace ew
