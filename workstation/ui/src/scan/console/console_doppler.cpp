// The console's page of Doppler, which shows either colour (console_colour.cpp) or the spectrum (console_spectrum.cpp).
#include "scan/console/console_doppler.h"

#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/widgets/figures.h"

namespace ew::ui {
namespace {

constexpr double kStepsPerDecade = 20.0;
constexpr double kFirstScale_mmPerS = 400.0;  // along the line: 80 cm/s along a vessel at 60 degrees

}  // namespace

double prfAt_hz(int step) { return std::round(kLowestPrf_hz * std::pow(10.0, step / kStepsPerDecade)); }
double stepsToPrf(double prf_hz) { return kStepsPerDecade * std::log10(prf_hz / kLowestPrf_hz); }
QString speedText(double velocity_mmPerS) { return ConsolePanel::tr("%1 cm/s").arg(figure(velocity_mmPerS / 10.0, 1)); }

SpectralDoppler firstSpectrum(const Probe& probe, const Knobs& knobs) {
  SpectralDoppler spectral;
  if (knobs.colour) {
    const ColourBox box = colourBoxOf(probe, knobs);
    spectral.line = 0.5 * (box.left + box.right);
    spectral.depth_mm = 0.5 * (box.top_mm + box.bottom_mm);
    spectral.steering_rad = box.steering_rad;
  }
  Knobs first = knobs;
  first.spectral = spectral;
  const SpectralGate gate = spectralGateOf(probe, first);
  spectral.prf_hz = prfAt_hz(static_cast<int>(std::lround(stepsToPrf(gate.prf_hz * kFirstScale_mmPerS / gate.nyquist_mmPerS))));
  return spectral;
}

QSlider* ConsolePanel::DopplerPart::addSlider(QBoxLayout* rows, SliderParts parts, const QString& wholeName) {
  parts.isOn = [this, may = std::move(parts.isOn)] { return isOn() && may(); };
  parts.isThere = [this, may = std::move(parts.isThere)] { return isKnown() && may(); };
  QSlider* slider = panel_.addSlider(rows, std::move(parts));
  slider->setAccessibleName(wholeName);
  return slider;
}

int ConsolePanel::DopplerPart::mostSteering_deg() const {
  return static_cast<int>(std::floor(glm::degrees(std::min(session_.console().probe().maxSteering_rad, kMostColourSteering_rad)) + 1e-9));
}

void ConsolePanel::addDopplerPage(QVBoxLayout* rows) {
  QLabel* nothing = quietLabel(tr("This case does not say how blood flows, so there is nothing to colour and nothing to listen to."));
  nothing->setObjectName(QStringLiteral("noColour"));
  nothing->setWordWrap(true);
  rows->addWidget(nothing);
  const auto isKnown = [this] { return session_.subject() && session_.subject()->showsColour(); };
  const auto addPart = [rows] {
    auto* part = new QWidget;
    auto* inside = new QVBoxLayout(part);
    inside->setContentsMargins(0, 4, 0, 0);
    inside->setSpacing(0);
    rows->addWidget(part);
    return inside;
  };
  // What is switched on is what its user wants to turn.
  shows_.emplace_back([this, wasSpectrum = false, wasColoured = false]() mutable {
    const Knobs& knobs = session_.console().knobs();
    const bool isSpectrum = knobs.mode == DisplayMode::spectrum, isColoured = knobs.colour.has_value();
    if (isSpectrum != wasSpectrum) showsSpectrumPart_ = isSpectrum;
    if (isColoured && !wasColoured && !isSpectrum) showsSpectrumPart_ = false;
    wasSpectrum = isSpectrum;
    wasColoured = isColoured;
  });
  addSegments(rows, {{},
                     QStringLiteral("dopplerPart"),
                     {{tr("Colour"), QStringLiteral("partColour"), tr("The controls of colour Doppler")},
                      {tr("PW", "spectral Doppler"), QStringLiteral("partPw"), tr("The controls of spectral Doppler")}},
                     [this] { return showsSpectrumPart_ ? 1 : 0; },
                     [this](int i) {
                       showsSpectrumPart_ = i == 1;
                       showAll();
                     },
                     [] { return true; },
                     isKnown});
  QVBoxLayout* colour = addPart();
  QVBoxLayout* spectrum = addPart();
  addColourPart(colour);
  addSpectrumPart(spectrum);
  shows_.emplace_back([this, nothing, isKnown, colour = colour->parentWidget(), spectrum = spectrum->parentWidget()] {
    nothing->setVisible(!isKnown());
    colour->setVisible(isKnown() && !showsSpectrumPart_);
    spectrum->setVisible(isKnown() && showsSpectrumPart_);
  });
}

}  // namespace ew::ui
