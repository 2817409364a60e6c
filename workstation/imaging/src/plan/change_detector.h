#pragma once

#include <optional>
#include <tuple>

namespace ew::detail {

/// Remembers what a table was made from, so that it is made again only when that changes.
template <class... Values>
class ChangeDetector {
 public:
  /// Whether the table must be made again; from then on it counts as made from `values`.
  bool changesTo(const Values&... values) {
    if (last_ && *last_ == std::tie(values...)) return false;
    last_.emplace(values...);
    return true;
  }

 private:
  std::optional<std::tuple<Values...>> last_;
};

}  // namespace ew::detail
