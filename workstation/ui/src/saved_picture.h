#pragma once

#include <QDateTime>
#include <QImage>
#include <filesystem>

#include "ew/core/result.h"

namespace ew::ui {

class AnnotatedPictures;
class Calipers;
class Session;
class ShownMark;

/// What lies on a picture besides its echoes; null: nothing of that kind.
struct OnPicture {
  OnPicture(const Calipers* measured = nullptr, const AnnotatedPictures* written = nullptr, const ShownMark* marked = nullptr)  // NOLINT
      : calipers(measured), annotations(written), mark(marked) {}
  const Calipers* calipers;
  const AnnotatedPictures* annotations;
  const ShownMark* mark;
};

/// The present picture as it is handed on: as it is on the screen, pixel for pixel, with a depth scale beside it, and above it what it
/// shows: the title of what is scanned, the probe, depth, gain and zoom, and when it was made. White on black, whatever the theme. Room for
/// the words that the door for pictures adds is kept along the lower edge. Calipers, texts and arrows are drawn over it, what was measured
/// stands below it, and the body mark in its lower left corner where there is room.
/// @return Format_Grayscale8, or Format_RGB888 when the picture has colours; null when there is no picture
[[nodiscard]] QImage savedPicture(const Session& session, const QDateTime& at, const OnPicture& on = {});

/// Writes the present picture: a .png to be looked at, as savedPicture has it and with the words it must carry; a .mha to be measured, the
/// bare picture. Expects a picture. @error as writePicture
[[nodiscard]] Result<void> writeShownPicture(const Session& session, const QDateTime& at, const std::filesystem::path& file,
                                             const OnPicture& on = {});

}  // namespace ew::ui
