#include "logic/case_at_hand.h"

#include <nlohmann/json.hpp>

namespace ew::lessons {

std::optional<Case> caseAtHand(sdk::Host& host) {
  const auto manifest = host.cases().current();
  if (!manifest) return std::nullopt;
  const auto folder = host.cases().currentFolder();
  auto opened = host.cases().isLocked() ? loadCase(folder) : caseFromManifest(*manifest, folder);
  if (!opened) return std::nullopt;
  return std::move(*opened);
}

}  // namespace ew::lessons
