#include "import/opened_film.h"

#include <cstring>

namespace ew::ui {

QImage greyImageOf(const GreyImage& picture) {
  QImage image(picture.width, picture.height, QImage::Format_Grayscale8);
  for (int y = 0; y < picture.height; ++y) std::memcpy(image.scanLine(y), viewOf(picture).row(y), static_cast<std::size_t>(picture.width));
  return image;
}

Result<void> OpenedFilm::read(FilmFrame& shown, const std::optional<ScreenGeometry>& geometry, Progress& progress) {
  const std::lock_guard<std::mutex> alone(mutex);
  const auto frame = frames.at(screen.reader, static_cast<std::size_t>(shown.frame), progress);
  if (!frame) return passOn(frame.error());
  if (!geometry) {
    shown.picture = greyImageOf(**frame);
    return {};
  }
  if (cleanerOf != shown.changes) {
    cleaner.emplace(*geometry, CleaningOptions());
    cleanerOf = shown.changes;
  }
  GreyImage clean;
  cleaner->clean(**frame, clean);
  shown.picture = greyImageOf(clean);
  shown.at = {cleaner->kept().x, cleaner->kept().y};
  return {};
}

}  // namespace ew::ui
