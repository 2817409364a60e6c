#pragma once

#include <QWidget>
#include <cstddef>
#include <vector>

#include "logic/review_tracks.h"
#include "panel/session/review_scan.h"

namespace ew::review {

class AttemptComments;
class Playback;
class ScanPair;

/// Both scans along the review's clock: a row for each kind of track, the expert's above the trainee's, with a loop's ends and where the
/// clock stands. A click or a drag looks there; a tooltip says what happened.
class TrackView final : public QWidget {
  Q_OBJECT

 public:
  TrackView(Playback& playback, const ScanPair& scans, const AttemptComments& comments, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// Where a moment of the clock is, in pixels of the widget.
  [[nodiscard]] double xOf(double clock_s) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] std::vector<TrackKind> shownKinds() const;
  [[nodiscard]] int labelWidth() const;
  [[nodiscard]] int rowHeight() const;
  [[nodiscard]] int rulerHeight() const;
  [[nodiscard]] QRectF laneOf(std::size_t row, Side side) const;
  [[nodiscard]] double timeAt(double x_px) const;
  void paintRuler(QPainter& painter) const;
  void paintTrack(QPainter& painter, const Track& track, Side side, const QRectF& lane) const;
  void paintLoop(QPainter& painter) const;
  [[nodiscard]] QString wordsAt(const QPoint& at) const;

  Playback& playback_;
};

}  // namespace ew::review
