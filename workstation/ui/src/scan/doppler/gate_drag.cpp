#include "scan/doppler/gate_drag.h"

#include <algorithm>
#include <cmath>

#include "ew/widgets/theme.h"
#include "scan/scan_view.h"
#include "scan/session.h"
#include "scan/spectrum_on_image.h"

namespace ew::ui {
namespace {

constexpr double kBesideReach_px = 12.0, kTipReach_px = 10.0;
constexpr double kLengthStep_mm = 0.5, kLeastGate_mm = 0.5, kMostGate_mm = 20.0;

double lengthOf(const QPointF& each) { return std::hypot(each.x(), each.y()); }

}  // namespace

bool GateDrag::hasAny() const { return knobsWithGate(session_).has_value(); }

glm::dvec2 GateDrag::placeAt(const QPointF& at) const {
  const Point<frame::Probe> point = scan_.pointAt(at);
  return {point.at.x, point.at.y};
}

std::optional<DragOnImage::Grip> GateDrag::gripAt(const QPointF& at) const {
  const GateOutline outline = outlineOfGate(scan_, session_.imageProbe(), *knobsWithGate(session_));
  const QPointF from = at - outline.middle;
  const double along_px = QPointF::dotProduct(from, outline.along), aside_px = lengthOf(from - along_px * outline.along);
  const double half_px = 0.5 * outline.length_px;
  // In a short volume there is still something to move it by.
  const double inner_px = std::min(scaled(kReach_px), 0.5 * half_px);
  if (aside_px <= scaled(kBesideReach_px) && std::abs(along_px) <= half_px + scaled(kReach_px)) {
    if (std::abs(along_px) < half_px - inner_px) return Grip{gate, Qt::OpenHandCursor, ScanView::tr("drag: move the sample volume")};
    const bool isUpright = std::abs(outline.along.y()) >= std::abs(outline.along.x());
    return Grip{length, isUpright ? Qt::SizeVerCursor : Qt::SizeHorCursor, ScanView::tr("drag: lengthen the sample volume")};
  }
  for (const QPointF& tip : {outline.flowFrom, outline.flowTo})
    if (lengthOf(at - tip) <= scaled(kTipReach_px))
      return Grip{angle, Qt::PointingHandCursor, ScanView::tr("drag or wheel: turn the angle")};
  return std::nullopt;
}

void GateDrag::begin(int /*part*/, const QPointF& at) {
  from_ = spectralGateOf(session_.imageProbe(), *knobsWithGate(session_)).middle_mm - placeAt(at);
}

void GateDrag::moveTo(int part, const QPointF& at) {
  Knobs knobs = *knobsWithGate(session_);
  const Probe& probe = session_.console().probe();
  const glm::dvec2 place_mm = placeAt(at);
  if (part == gate) return session_.console().setKnobs(withSpectralGateAt(probe, knobs, place_mm + from_));
  const SpectralGate now = spectralGateOf(probe, knobs);
  const glm::dvec2 off_mm = place_mm - now.middle_mm;
  if (part == length) {
    const double steps = std::round(2.0 * std::abs(glm::dot(off_mm, now.direction)) / kLengthStep_mm);
    knobs.spectral->gate_mm = std::clamp(steps * kLengthStep_mm, kLeastGate_mm, kMostGate_mm);
  } else {
    const double across = off_mm.x * now.direction.y - off_mm.y * now.direction.x;
    knobs.spectral->angle_rad = angleOfLine_rad(across, glm::dot(off_mm, now.direction));
  }
  session_.console().setKnobs(knobs);
}

bool GateDrag::turn(int steps) {
  Knobs knobs = *knobsWithGate(session_);
  const double degrees = std::round(glm::degrees(knobs.spectral->angle_rad)) + steps;
  knobs.spectral->angle_rad = std::clamp(glm::radians(degrees), -kMostDopplerAngle_rad, kMostDopplerAngle_rad);
  session_.console().setKnobs(knobs);
  return true;
}

}  // namespace ew::ui
