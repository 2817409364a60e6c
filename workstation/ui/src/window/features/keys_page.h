#pragma once

#include <vector>

#include "keys/shortcuts_overlay.h"

namespace ew::ui {

struct WindowParts;

/// What the page of keys (F1) says: only what acts where one is, for a trainee has no panels, and a stage takes the keys of the scan.
[[nodiscard]] std::vector<ShortcutsOverlay::Group> keysPage(const WindowParts& parts);

}  // namespace ew::ui
