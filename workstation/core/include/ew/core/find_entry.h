#pragma once

#include <algorithm>
#include <string_view>

namespace ew {

/// The first entry of a list whose `member` is `value`; null: there is none.
/// @param member of the entries: entryWith(steps, &LessonStep::id, id)
template <class List, class Member, class Value>
[[nodiscard]] auto entryWith(List& list, Member member, const Value& value) {
  const auto found = std::ranges::find(list, value, member);
  return found == list.end() ? nullptr : &*found;
}

/// ... whose name is `name`.
template <class List>
[[nodiscard]] auto entryNamed(List& list, std::string_view name) {
  return entryWith(
      list, [](const auto& each) -> const auto& { return each.name; }, name);
}

}  // namespace ew
