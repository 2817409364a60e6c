#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>
#include <QWidget>
#include <array>
#include <cstdint>

#include "logic/slices.h"
#include "panel/stitch_session.h"

/// Colours and words that list, graph, views and inspector share. Verdicts are told by colour, by a sign, and by a word: never colour
/// alone.
namespace ew::stitching {

inline QColor colourOf(const std::array<std::uint8_t, 3>& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

/// A size that holds text, so many pixels at the window's usual 13: what is painted grows with the words around it.
[[nodiscard]] inline int withText(int px, const QFont& font) { return font.pixelSize() > 0 ? px * font.pixelSize() / 13 : px; }

[[nodiscard]] inline QColor colourOfMark(StitchSession::Mark mark, const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  switch (mark) {
    case StitchSession::Mark::aligned:
      return dark ? QColor(0x5f, 0xb8, 0x6e) : QColor(0x2a, 0x80, 0x3c);
    case StitchSession::Mark::landmarks:
    case StitchSession::Mark::byHand:
      return palette.color(QPalette::WindowText);
    case StitchSession::Mark::cannotTell:
      return dark ? QColor(0xd9, 0xb1, 0x4a) : QColor(0x8f, 0x66, 0x00);
    case StitchSession::Mark::notAligned:
      return palette.color(QPalette::BrightText);
    case StitchSession::Mark::rejected:
    case StitchSession::Mark::unknown:
      return palette.color(QPalette::PlaceholderText);
  }
  return {};
}

[[nodiscard]] inline QString wordsOfMark(StitchSession::Mark mark) {
  switch (mark) {
    case StitchSession::Mark::aligned:
      return StitchSession::tr("aligned");
    case StitchSession::Mark::landmarks:
      return StitchSession::tr("by landmarks");
    case StitchSession::Mark::byHand:
      return StitchSession::tr("manual, not checked");
    case StitchSession::Mark::cannotTell:
      return StitchSession::tr("cannot tell");
    case StitchSession::Mark::notAligned:
      return StitchSession::tr("not aligned");
    case StitchSession::Mark::rejected:
      return StitchSession::tr("rejected");
    case StitchSession::Mark::unknown:
      return StitchSession::tr("not matched yet");
  }
  return {};
}

/// "141 × 247 × 127"
[[nodiscard]] inline QString sizeOf(const Grid& grid) {
  return QStringLiteral("%1 × %2 × %3").arg(grid.dims.x).arg(grid.dims.y).arg(grid.dims.z);
}

/// A sign per verdict, so that it reads without colour: tick, plus, dot, question mark, cross, bar, ring.
void drawMark(QPainter& painter, const QRectF& box, StitchSession::Mark mark, const QPalette& palette);

}  // namespace ew::stitching
