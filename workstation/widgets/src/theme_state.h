#pragma once

namespace ew {

/// Lets currentTheme() be the dark or the light one, and texts be of a size. Nothing while there is no application.
void keepTheme(bool isDark);
void keepTextSize(int percent);

/// Sizes that are held (holdFixedWidth ...) follow the size of text, whoever holds them.
void setHeldSizes();

}  // namespace ew
