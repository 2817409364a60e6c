#pragma once

#include <QDateTime>
#include <QImage>
#include <QRect>
#include <QString>
#include <filesystem>
#include <vector>

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
  QString person = {};  ///< who scans, as they call themselves; empty: nobody has said so
};

/// The present picture as it is handed on: as it is on the screen, pixel for pixel, with the orientation marker at its side, a depth scale
/// beside it, and above it what it shows: the title of what is scanned, the probe, depth, gain and zoom, when it was made and by whom.
/// White on black, whatever the theme. Room for the words that the door for pictures adds is kept along the lower edge. The strip of the
/// M-mode stands below it, or in its place where it alone is shown. Calipers, texts and arrows are drawn over both, what was measured
/// stands below, results over several measurements with it, and the body mark in its lower left corner where there is room.
/// @return Format_Grayscale8, or Format_RGB888 when the picture has colours; null when there is no picture
/// @param name which picture it is, before its settings; empty: the only one
[[nodiscard]] QImage savedPicture(const Session& session, const QDateTime& at, const OnPicture& on = {}, const QString& name = {});

/// One of several pictures that are saved together.
struct SavedPart {
  const Session* session = nullptr;
  OnPicture on = {};
  QString name;  ///< which it is, above it; empty: the only one
  bool isInHand = true;
};
/// Where on a saved picture a part of it lies.
struct SavedPlace {
  const Session* session = nullptr;
  QRect picture, strip;  ///< of the M-mode; empty: not shown
};
struct SavedTogether {
  QImage image;
  std::vector<SavedPlace> places;
};
/// All of them, each as savedPicture has it and in its own scale, in rows; empty ones are left out.
/// @param columns >= 1
[[nodiscard]] SavedTogether savedPictures(const std::vector<SavedPart>& parts, int columns, const QDateTime& at);
/// Writes what is shown: a .png to be looked at, as savedPictures has it and with the words it must carry; a .mha to be measured, the bare
/// picture that is in hand. Expects a picture in hand. @error as writePicture
[[nodiscard]] Result<void> writeShownPictures(const std::vector<SavedPart>& parts, int columns, const QDateTime& at,
                                              const std::filesystem::path& file);

}  // namespace ew::ui
