#pragma once

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QString>

namespace ew::ui {

/// The colours of the window: two neutral greys, one accent, red for danger alone. The scan stays on black in both themes.
struct Theme {
  bool dark = true;
  QColor panel;     ///< bars, console, cards
  QColor ground;    ///< behind the 3D view, fields, the start page
  QColor raised;    ///< buttons, the chosen workspace
  QColor line;      ///< hairlines and empty tracks
  QColor text;      ///< what is to be read
  QColor quiet;     ///< labels, hints, secondary words
  QColor accent;    ///< what is on, where the hand is
  QColor onAccent;  ///< words on the accent
  QColor danger;    ///< red, for what went wrong
};

[[nodiscard]] Theme darkTheme();
[[nodiscard]] Theme lightTheme();
[[nodiscard]] const Theme& currentTheme();

/// Looks whether the system shows light on dark or dark on light; to be called before the first theme is applied, later calls do nothing.
void rememberSystemTheme();
/// @param choice "light", "system" or anything else, which is dark
[[nodiscard]] Theme themeCalled(const QString& choice);

/// Colours of the scan view: the same in both themes, because the scan is read against black.
[[nodiscard]] Theme scanTheme();

/// Sets style, palette, style sheet and font of the whole application.
void applyTheme(const Theme& theme);

inline constexpr int kGrid_px = 8;        ///< every distance is a multiple of it, or its half
inline constexpr int kTextSize_px = 13;   ///< the larger of the two text sizes
inline constexpr int kSmallSize_px = 12;  ///< the smaller one
[[nodiscard]] QFont textFont();
[[nodiscard]] QFont smallFont();

}  // namespace ew::ui
