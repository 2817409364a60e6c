#pragma once

#include <QColor>
#include <QPalette>
#include <QString>
#include <array>
#include <cstdint>

#include "ew/widgets/theme.h"
#include "logic/slices.h"
#include "panel/stitch_results.h"

/// Colours and words that list, graph, views and inspector share. Verdicts are told by colour, by a sign, and by a word: never colour
/// alone.
namespace ew::stitching {

inline QColor colourOf(const std::array<std::uint8_t, 3>& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

[[nodiscard]] inline QColor colourOfMark(StitchResults::Mark mark, const QPalette& palette) {
  const bool dark = currentTheme().dark;
  switch (mark) {
    case StitchResults::Mark::aligned:
      return dark ? QColor(0x5f, 0xb8, 0x6e) : QColor(0x2a, 0x80, 0x3c);
    case StitchResults::Mark::landmarks:
    case StitchResults::Mark::byHand:
      return palette.color(QPalette::WindowText);
    case StitchResults::Mark::cannotTell:
      return dark ? QColor(0xd9, 0xb1, 0x4a) : QColor(0x8f, 0x66, 0x00);
    case StitchResults::Mark::notAligned:
      return palette.color(QPalette::BrightText);
    case StitchResults::Mark::rejected:
    case StitchResults::Mark::unknown:
      return palette.color(QPalette::PlaceholderText);
  }
  return {};
}

[[nodiscard]] inline QString wordsOfMark(StitchResults::Mark mark) {
  switch (mark) {
    case StitchResults::Mark::aligned:
      return StitchResults::tr("aligned");
    case StitchResults::Mark::landmarks:
      return StitchResults::tr("by landmarks");
    case StitchResults::Mark::byHand:
      return StitchResults::tr("manual, not checked");
    case StitchResults::Mark::cannotTell:
      return StitchResults::tr("cannot tell");
    case StitchResults::Mark::notAligned:
      return StitchResults::tr("not aligned");
    case StitchResults::Mark::rejected:
      return StitchResults::tr("rejected");
    case StitchResults::Mark::unknown:
      return StitchResults::tr("not matched yet");
  }
  return {};
}

/// "141 × 247 × 127"
[[nodiscard]] inline QString sizeOf(const Grid& grid) {
  return QStringLiteral("%1 × %2 × %3").arg(grid.dims.x).arg(grid.dims.y).arg(grid.dims.z);
}

/// A sign per verdict, so that it reads without colour: tick, plus, dot, question mark, cross, bar, ring.
void drawMark(QPainter& painter, const QRectF& box, StitchResults::Mark mark, const QPalette& palette);

}  // namespace ew::stitching
