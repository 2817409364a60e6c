#pragma once

#include <QPolygonF>
#include <QRect>
#include <QStringList>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

class QPainter;

namespace ew::ui {

class ScanView;
class Session;

// What colour Doppler puts on and beside an image besides its pixels.

/// The settings of an image with a colour box; empty: none is shown, because none is set, nobody knows how blood flows, or the image is the
/// strip of the M-mode or a wide one.
[[nodiscard]] std::optional<Knobs> knobsWithBox(const Session& session);

/// Of a box, in pixels, with as many points on every edge as it takes.
struct BoxOutline {
  QPolygonF left, bottom, right, top;
  [[nodiscard]] QPolygonF all() const { return left + bottom + right + top; }
};
/// @param knobs with colour @param placeOf a point of the image plane in mm
[[nodiscard]] BoxOutline outlineOfBox(const Probe& probe, const Knobs& knobs, const std::function<QPointF(const glm::dvec2&)>& placeOf);
[[nodiscard]] BoxOutline outlineOfBox(const ScanView& scan, const Probe& probe, const Knobs& knobs);
void paintColourBox(QPainter& painter, const BoxOutline& outline);

/// The bar of colours with its numbers. @param imageHeight_px of the image beside it
[[nodiscard]] QSize sizeOfColourBar(int imageHeight_px, bool hasNumbers);
/// In a corner of the room where it covers nothing of what is taken, the upper right one first; null: there is none.
[[nodiscard]] QRect placeOfColourBar(const QRect& room, const std::vector<QRect>& taken, const QSize& size);
/// @param knobs with colour @param isOverImage a veil keeps its numbers legible
void paintColourBar(QPainter& painter, const QRect& place, const Probe& probe, const Knobs& knobs, bool hasNumbers, bool isOverImage);

/// Scale, filter and images a second, each as it stands behind other figures of a line.
[[nodiscard]] QStringList colourFigures(const Probe& probe, const Knobs& knobs);
/// As many of such figures as there is room for in the present font.
[[nodiscard]] QString figuresThatFit(const QPainter& painter, QStringList figures, int room_px);

}  // namespace ew::ui
