#include "listed.h"

#include <utility>

namespace ew::registration {

Message listed(std::vector<Message> names, std::size_t most) {
  if (names.size() > most) {
    const std::size_t more = names.size() - most;
    names.resize(most);
    return say<"%1 and %2 more">(joined(std::move(names), ", "), more);
  }
  if (names.size() < 2) return joined(std::move(names));
  Message last = std::move(names.back());
  names.pop_back();
  return say<"%1 and %2">(joined(std::move(names), ", "), std::move(last));
}

}  // namespace ew::registration
