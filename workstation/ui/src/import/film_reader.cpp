#include "import/film_reader.h"

#include "ew/widgets/qt_image.h"

namespace ew::ui {

Result<void> FilmReader::read(FilmFrame& shown, const std::optional<ScreenGeometry>& geometry, Progress& progress) {
  const std::lock_guard<std::mutex> alone(mutex);
  const auto frame = frames.at(screen.reader, static_cast<std::size_t>(shown.frame), progress);
  if (!frame) return passOn(frame.error());
  if (!geometry) {
    shown.image = imageOf(viewOf(**frame)).copy();
    return {};
  }
  if (cleanerOf != shown.changes) {
    cleaner.emplace(*geometry, CleaningOptions());
    cleanerOf = shown.changes;
  }
  GreyImage clean;
  cleaner->clean(**frame, clean);
  shown.image = imageOf(viewOf(clean)).copy();
  shown.at = {cleaner->kept().x, cleaner->kept().y};
  return {};
}

}  // namespace ew::ui
