#pragma once

#include <QPointF>
#include <Qt>
#include <optional>

#include "ew/imaging/colour_doppler.h"

class QEvent;

namespace ew::ui {

class ScanView;
class Session;

/// The colour box under the mouse: a drag within it moves it, one at an edge or a corner makes it smaller or larger. Only while the image
/// runs: one that stands still or is played keeps its box.
class ColourBoxDrag {
 public:
  ColourBoxDrag(Session& session, ScanView& scan) : session_(session), scan_(scan) {}

  /// What the mouse does in the view. @return whether it was the box's, and nobody else's
  bool handle(const QEvent& event);
  /// What the pointer looks like where it is now; empty: it is not at the box.
  [[nodiscard]] std::optional<Qt::CursorShape> cursor() const;
  [[nodiscard]] bool isDragging() const { return from_.has_value(); }
  void end();

 private:
  /// What of the box is at a place.
  struct Grip {
    ColourEdges edges;  ///< none: all of it is moved
    Qt::CursorShape cursor = Qt::OpenHandCursor;
  };
  [[nodiscard]] bool isThere() const;
  [[nodiscard]] std::optional<Grip> gripAt(const QPointF& at) const;
  [[nodiscard]] ColourPlace placeAt(const QPointF& at) const;
  void begin(const QPointF& at);
  void moveTo(const QPointF& at);
  void tellHint();

  Session& session_;
  ScanView& scan_;
  std::optional<Grip> grip_;         ///< under the pointer, or held
  std::optional<ColourPlace> from_;  ///< of what is held, from the pointer
};

}  // namespace ew::ui
