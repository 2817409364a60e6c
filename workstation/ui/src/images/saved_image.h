#pragma once

#include <QDateTime>
#include <QImage>
#include <QRect>
#include <QString>
#include <filesystem>
#include <vector>

#include "ew/core/result.h"

namespace ew::ui {

class ImageAnnotations;
class Calipers;
class Session;
class ImageBodyMark;

/// What lies on an image besides its echoes; null: nothing of that kind.
struct OnImage {
  OnImage(const Calipers* measured = nullptr, const ImageAnnotations* written = nullptr, const ImageBodyMark* marked = nullptr)  // NOLINT
      : calipers(measured), annotations(written), mark(marked) {}
  const Calipers* calipers;
  const ImageAnnotations* annotations;
  const ImageBodyMark* mark;
  QString person = {};  ///< who scans, as they call themselves; empty: nobody has said so
};

/// The present image as it is handed on: as it is on the screen, pixel for pixel, with the orientation marker at its side, a depth scale
/// beside it, and above it what it shows: the title of what is scanned, the probe, depth, gain and zoom, when it was made and by whom.
/// White on black, whatever the theme. Room for the words that the door for images adds is kept along the lower edge. The strip of the
/// M-mode stands below it, or in its place where it alone is shown. Calipers, texts and arrows are drawn over both, what was measured
/// stands below, results over several measurements with it, and the body mark in its lower left corner where there is room.
/// @return Format_Grayscale8, or Format_RGB888 when the image has colours; null when there is no image
/// @param name which image it is, before its settings; empty: the only one
[[nodiscard]] QImage savedImage(const Session& session, const QDateTime& at, const OnImage& on = {}, const QString& name = {});

/// One of several images that are saved together.
struct SnapshotPart {
  const Session* session = nullptr;
  OnImage on = {};
  QString name;  ///< which it is, above it; empty: the only one
  bool isInHand = true;
};
/// Where on a saved image a part of it lies.
struct SnapshotPlace {
  const Session* session = nullptr;
  QRect image, strip;  ///< of the M-mode; empty: not shown
};
struct Snapshot {
  QImage image;
  std::vector<SnapshotPlace> places;
};
/// All of them, each as savedImage has it and in its own scale, in rows; empty ones are left out.
/// @param columns >= 1
[[nodiscard]] Snapshot savedImages(const std::vector<SnapshotPart>& parts, int columns, const QDateTime& at);
/// Writes what is shown: a .png to be looked at, as savedImages has it and with the words it must carry; a .mha to be measured, the bare
/// image that is in hand. Expects an image in hand. @error as writeDisplayImage
[[nodiscard]] Result<void> writeShownImages(const std::vector<SnapshotPart>& parts, int columns, const QDateTime& at,
                                            const std::filesystem::path& file);

}  // namespace ew::ui
