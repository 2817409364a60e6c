#pragma once

#include <QColor>
#include <QFont>

class QWidget;

namespace ew {

/// The colours of the window: two neutral greys, one accent, red for danger alone. The scan stays on black in both themes.
struct Theme {
  bool dark = true;
  QColor panel;     ///< bars, console, cards
  QColor ground;    ///< behind the 3D view, fields, the start page
  QColor raised;    ///< buttons, the chosen workspace
  QColor line;      ///< hairlines between parts, which nobody needs to tell them apart
  QColor edge;      ///< of what can be written into or moved: fields, boxes, empty tracks
  QColor text;      ///< what is to be read
  QColor quiet;     ///< labels, hints, secondary words
  QColor accent;    ///< what is on, where the hand is
  QColor onAccent;  ///< words on the accent
  QColor danger;    ///< red, for what went wrong
};

[[nodiscard]] Theme darkTheme();
[[nodiscard]] Theme lightTheme();
/// The one that was applied last (apply_theme.h); the dark one before. Program and plugins see the same: it is kept by the application.
[[nodiscard]] const Theme& currentTheme();

/// Colours of the scan view: the same in both themes, because the scan is read against black.
[[nodiscard]] Theme scanTheme();

inline constexpr int kGrid_px = 8;        ///< every distance is a multiple of it, or its half
inline constexpr int kTextSize_px = 13;   ///< the larger of the two text sizes, at 100 %
inline constexpr int kSmallSize_px = 12;  ///< the smaller one
[[nodiscard]] QFont textFont();
[[nodiscard]] QFont smallFont();
[[nodiscard]] QFont bold(QFont font);  ///< in the weight of headings

[[nodiscard]] int textSize_percent();
/// A size that holds text: so many pixels at 100 %.
[[nodiscard]] int scaled(int px);
[[nodiscard]] double scaled(double px);

/// A fixed or least size that holds text and follows its size, also when that changes while the widget is there.
void holdFixedWidth(QWidget& widget, int px);
void holdFixedHeight(QWidget& widget, int px);
void holdLeastWidth(QWidget& widget, int px);
void holdLeastHeight(QWidget& widget, int px);

/// While one lives fonts and sizes are those of 100 %: for images that leave the program, which are the same for every reader.
class UsualTextSize {
 public:
  UsualTextSize();
  ~UsualTextSize();
  UsualTextSize(const UsualTextSize&) = delete;
  UsualTextSize& operator=(const UsualTextSize&) = delete;

 private:
  int before_percent_;
};

}  // namespace ew
