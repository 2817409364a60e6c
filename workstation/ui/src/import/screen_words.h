#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "ew/acquisition/screen_edit.h"

namespace ew::ui {

/// How many boxes of text over the scan are filled, and how many may be text.
[[nodiscard]] QString wordsOfBoxes(const std::vector<TextBox>& boxes);
/// What was found of the depth scale and how large a pixel is by it, or what to type.
[[nodiscard]] QString wordsOfScale(const std::optional<DepthTicks>& ticks, const Result<ScreenGeometry>& geometry);

}  // namespace ew::ui
