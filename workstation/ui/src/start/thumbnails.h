#pragma once

#include <QImage>
#include <QSize>
#include <vector>

namespace ew {
struct Beginnings;
struct Case;
struct ScanSubject;
}  // namespace ew

namespace ew::ui {

/// Images of cases for the start page, kept in the cache between starts under what shaped them: the files of the case's folder, by name,
/// size and time, and the image's size. Whatever cannot be read is painted again; whatever cannot be written is painted at every start.

/// @return null when there is none for the case as it is now
[[nodiscard]] QImage keptThumbnail(const Case& shown, const QSize& size);
/// Replaces what is kept of the case.
void keepThumbnail(const Case& shown, const QImage& image);

/// The first image of a subject's scan. Null when its probe is not there.
[[nodiscard]] QImage thumbnailOf(const ScanSubject& subject, const Beginnings& there, const QSize& size);

/// The image that the case brings with it (kCardName), for as long as none of its own can be made. Null when there is none, or it is no
/// PNG of the size such images have.
[[nodiscard]] QImage broughtThumbnail(const Case& shown);

}  // namespace ew::ui
