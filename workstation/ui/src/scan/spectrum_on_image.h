#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/spectral_trace.h"

class QPainter;

namespace ew::ui {

class ScanView;
class Session;
struct SpectrumReading;

// What spectral Doppler puts on an image and on its strip besides their pixels.

/// The settings of an image with a sample volume, `spectral` filled in; empty: none is shown, because the mode is another one, nobody knows
/// how blood flows, or the image is a wide one.
[[nodiscard]] std::optional<Knobs> knobsWithGate(const Session& session);

/// Line, sample volume and flow line, in pixels.
struct GateOutline {
  QPointF face, end;  ///< of the Doppler line
  QPointF middle;     ///< of the volume
  QPointF along;      ///< of the line, of length 1
  double length_px = 0.0;
  std::vector<QPointF> alsoAt;  ///< middles of volumes that answer as well
  QPointF flowFrom, flowTo;
};
/// @param knobs with spectral @param placeOf a point of the image plane in mm
[[nodiscard]] GateOutline outlineOfGate(const Probe& probe, const Knobs& knobs, const std::function<QPointF(const glm::dvec2&)>& placeOf);
[[nodiscard]] GateOutline outlineOfGate(const ScanView& scan, const Probe& probe, const Knobs& knobs);
/// The angle of a flow line, which has no direction, through a point off the volume's middle: whole degrees, as far as an angle goes.
/// @param across towards +x from the Doppler line, @param along it
[[nodiscard]] double angleOfLine_rad(double across, double along);
[[nodiscard]] QString angleText(double angle_rad);  ///< "−60°"
/// With the angle beside it. @param knobs with spectral @param within what is seen of it
void paintGate(QPainter& painter, const GateOutline& outline, const Knobs& knobs, const QRect& within);
/// What an angle does that nobody should measure with; empty: it can be measured with.
[[nodiscard]] QString angleWarning(double angle_rad);

/// Ticks and numbers in cm/s right of a strip. @param right x where the ticks end
void paintVelocityScale(QPainter& painter, const QRect& strip, int right, const Probe& probe, const Knobs& knobs);
/// The line of no flow across a strip.
void paintBaseline(QPainter& painter, const QRect& strip, const Knobs& knobs);
/// The greatest velocities over a strip. @param pixelRatio columns to a pixel of the painter
void paintEnvelope(QPainter& painter, const QRect& strip, double pixelRatio, const MModeStrip& columns, const Knobs& knobs,
                   const SpectrumReading& reading);

/// PSV, EDV, RI, TAMX, PI, heart rate, each with what it is measured in; of velocities also what 3 degrees of the angle make of them.
/// @param values as shares of the Nyquist velocity (SpectrumReading) @param knobs with spectral
[[nodiscard]] QStringList spectralValues(const WaveformValues& values, const Probe& probe, const Knobs& knobs);
/// Height of the rows that values and a warning take in a view; the same whatever they are. In a low one the last of them have none.
[[nodiscard]] int heightOfValues_px(const QSize& view);
void paintValues(QPainter& painter, const QRect& room, const QStringList& values, const QString& warning);

/// All of it over what a view shows of a spectrum: on the image, on the strip and around it.
void paintSpectrum(QPainter& painter, const ScanView& scan, Session& session);
[[nodiscard]] inline bool isStripBelow(DisplayMode mode) { return mode == DisplayMode::both || mode == DisplayMode::spectrum; }
/// Room below a strip: for time ticks, and for the values of a spectrum.
[[nodiscard]] int belowStrip_px(const ScanView& scan, DisplayMode mode);

/// Angle, sample volume, PRF and filter, each as it stands behind other figures of a line.
[[nodiscard]] QStringList spectralFigures(const Probe& probe, const Knobs& knobs);

}  // namespace ew::ui
