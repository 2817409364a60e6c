#pragma once

class QPainter;
class QString;

namespace ew::ui {

[[nodiscard]] int badgeHeight_px();
/// In the upper right corner of an image `width` pixels wide: that it stands still.
void paintFrozenBadge(QPainter& painter, int width, const QString& word);
/// A red dot and how long the recording is by now. @param right,top of the line, in pixels
void paintRecordingTime(QPainter& painter, int right, int top, double length_s);

}  // namespace ew::ui
