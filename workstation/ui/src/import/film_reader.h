#pragma once

#include <QImage>
#include <QPoint>
#include <mutex>
#include <optional>
#include <vector>

#include "ew/acquisition/screen_frames.h"
#include "ew/acquisition/screen_recording.h"

namespace ew::ui {

/// A frame as it is to be shown.
struct FilmFrame {
  QImage image;
  QPoint at;        ///< where it lies in the images of the recording
  int frame = 0;    ///< which one is asked for
  int changes = 0;  ///< state of the corrections that it is asked with
};

/// What jobs read. One of them at a time has the reader: whoever comes second waits for the lock.
struct FilmReader {
  explicit FilmReader(ScreenSurvey read) : screen(std::move(read)), notes(screen.reader.info().notes) {}

  /// Fills in the image of the frame that is asked for, cleaned with the geometry or as it was recorded. @error as ScreenFrames::at
  Result<void> read(FilmFrame& shown, const std::optional<ScreenGeometry>& geometry, Progress& progress);

  std::mutex mutex;
  ScreenSurvey screen;  ///< its reader belongs to whoever has the lock
  std::vector<Message> notes;
  ScreenFrames frames;
  std::optional<ScreenCleaner> cleaner;  ///< for the state of the corrections below
  int cleanerOf = -1;
};

}  // namespace ew::ui
