#pragma once

#include <QColor>
#include <QString>

#include "logic/review_tracks.h"
#include "logic/scan_shelf.h"

class QPainter;
class QPointF;

/// Colours, words and marks that stage and column share. Expert and trainee are told by colour, by place, by a shape and by a word: never
/// by colour alone.
namespace ew::review {

/// Blue and orange stay apart for those who do not tell red from green; a dark ground wants them lighter.
[[nodiscard]] QColor colourOf(Who who, bool onDark);
[[nodiscard]] const char* workspaceIcon();

/// A share beside a level: as percent() says it, or with a decimal where whole numbers would hide on which side of it the share lies.
[[nodiscard]] QString percentBeside(double share, double level);
[[nodiscard]] QString titleOf(TrackKind kind);
[[nodiscard]] QString wordOf(Who who);

/// A diamond for the expert, a dot for the trainee, about a point.
void drawMarkOf(QPainter& painter, Who who, const QPointF& at, double radius_px);

}  // namespace ew::review
