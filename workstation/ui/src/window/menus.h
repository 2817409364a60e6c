#pragma once

namespace ew::ui {

struct WindowParts;

/// Fills the bar of menus: which entry stands where. What an entry does stands with its feature.
void fillMenus(WindowParts& parts);

}  // namespace ew::ui
