#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew::detail {

/// What a result would be different in if a field of a foreign header were used.
enum class FieldTouches { geometry, levels, time, count, nobodyKnows, nothing };

/// What states the fields, for sentences.
enum class FieldsOf { header, deviceSet };

/// One line of a format's table of fields.
struct FieldTableRow {
  std::string_view name;
  FieldTouches touches = FieldTouches::nothing;
};

/// The fields that a header states, and which of them a reader used. A reader meets every field it comes across and marks what it uses;
/// what is left is classified by the format's table, so that nothing that changes geometry, levels, time or count is passed over in
/// silence.
class HeaderFields {
 public:
  /// @param table   of the format; it must outlive this
  /// @param unknown what a field touches that the table does not have
  explicit HeaderFields(std::span<const FieldTableRow> table, FieldTouches unknown = FieldTouches::nothing, FieldsOf of = FieldsOf::header)
      : table_(table), unknown_(unknown), of_(of) {}

  /// The header states `name`. A value of blanks states nothing.
  void meet(std::string_view name, std::string_view value);
  /// The value, which counts as used from now on; empty where the header states none.
  [[nodiscard]] std::optional<std::string> take(std::string_view name);
  /// The value, without using it.
  [[nodiscard]] std::optional<std::string> stated(std::string_view name) const;
  void use(std::string_view name);

  /// One sentence for each of geometry, levels, time and count that an unused field touches, with the fields and their values; one more for
  /// those of which nobody knows.
  [[nodiscard]] std::vector<Message> unused() const;

 private:
  struct Stated {
    std::string name;
    std::string value;
    bool used = false;
  };
  [[nodiscard]] FieldTouches touchedBy(std::string_view name) const;

  std::span<const FieldTableRow> table_;
  FieldTouches unknown_;
  FieldsOf of_;
  std::vector<Stated> stated_;
};

/// What a field amounts to. `notSet`: blanks, NaN for every number, or values that mean or amount to nothing.
enum class FieldState { absent, notSet, unusable, value };

/// Which finite numbers are a value of a field, and which only say that it is not set.
enum class NumbersKind {
  place,      ///< any
  lengths,    ///< each above 0; none above 0: not set; some: unusable
  rectangle,  ///< two sides; one that is not above 0 leaves no area: not set
  interval,   ///< two ends; the same twice: not set
  distance,   ///< 0 or above; else not set
  reach,      ///< above 0; else not set
};

struct FieldNumbers {
  FieldState state = FieldState::absent;
  std::vector<double> values = {};  ///< where the state is value
};
/// The one answer to whether a field of numbers is there, set, usable.
/// @param found nothing: there is no such field
/// @param count of numbers that belong there
[[nodiscard]] FieldNumbers statedNumbers(const std::optional<std::string>& found, std::size_t count, NumbersKind kind);

}  // namespace ew::detail
