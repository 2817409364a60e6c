#pragma once

#include <QString>
#include <array>

#include "ew/widgets/theme.h"

// What the program says about colours and sizes of text; panels of plugins follow (theme.h).

namespace ew {

/// Looks whether the system shows light on dark or dark on light; to be called before the first theme is applied, later calls do nothing.
void rememberSystemTheme();
/// @param choice "light", "system" or anything else, which is dark
[[nodiscard]] Theme themeCalled(const QString& choice);

/// Sets style, palette, style sheet and font of the whole application. @param theme darkTheme() or lightTheme()
void applyTheme(const Theme& theme);

inline constexpr std::array<int, 5> kTextSizes_percent{100, 125, 150, 175, 200};
/// @param percent is brought to the nearest of kTextSizes_percent; the next applyTheme shows it
void setTextSize(int percent);

}  // namespace ew
