#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <QWidget>

#include "logic/review_tracks.h"
#include "logic/scan_shelf.h"

/// Colours, icons and words that stage and column share. Expert and trainee are told by colour, by place, by a shape and by a word: never
/// by colour alone.
namespace ew::review {

/// Blue and orange stay apart for those who do not tell red from green; a dark ground wants them lighter.
[[nodiscard]] QColor colourOf(Who who, bool onDark);
[[nodiscard]] inline bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

/// A size that holds text, so many pixels at the window's usual 13.
[[nodiscard]] inline int withText(int px, const QFont& font) { return font.pixelSize() > 0 ? px * font.pixelSize() / 13 : px; }
[[nodiscard]] QFont smaller(const QWidget& of);

/// One of the program's line icons (play, pause, step-on …), or of an SVG whose strokes are "currentColor".
[[nodiscard]] QIcon lineIcon(const QString& name, const QColor& colour);
[[nodiscard]] QIcon lineIconOf(const QByteArray& svg, const QColor& colour);
[[nodiscard]] const char* workspaceIcon();

/// A time as "1:05.2"; before the beginning "-0:01.0".
[[nodiscard]] QString clockText(double time_s);
/// A share of 0.67 as "67 %".
[[nodiscard]] QString percent(double share);
/// The same beside a level: with a decimal where whole numbers would hide on which side of it the share lies.
[[nodiscard]] QString percentBeside(double share, double level);
[[nodiscard]] QString titleOf(TrackKind kind);
[[nodiscard]] QString wordOf(Who who);

/// A diamond for the expert, a dot for the trainee, about a point.
void drawMarkOf(QPainter& painter, Who who, const QPointF& at, double radius_px);

}  // namespace ew::review
