// The console's controls of spectral Doppler.
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "ew/widgets/figures.h"
#include "keys/key_tips.h"
#include "scan/console/console_doppler.h"
#include "scan/doppler/doppler_speaker.h"
#include "scan/spectrum_on_image.h"

namespace ew::ui {
namespace {

constexpr double kMostPrf_hz = 52000.0;
constexpr std::array kFilters_hz{20.0,  30.0,  40.0,  50.0,  60.0,  80.0,  100.0,  125.0,  150.0, 200.0,
                                 250.0, 300.0, 400.0, 500.0, 600.0, 800.0, 1000.0, 1300.0, 1600.0};

/// The next of what is offered.
int stepOfFilter(double hz) {
  const auto at = std::lower_bound(kFilters_hz.begin(), kFilters_hz.end(), hz - 1e-9);
  return static_cast<int>(std::min(at, kFilters_hz.end() - 1) - kFilters_hz.begin());
}

}  // namespace

/// The controls, and what they keep.
class ConsolePanel::SpectrumPart final : public DopplerPart {
 public:
  explicit SpectrumPart(ConsolePanel& panel) : DopplerPart(panel), speaker_(panel.session_, &panel) {}
  void fill(QVBoxLayout* rows);

 private:
  void addAngle(QVBoxLayout* rows);
  void addLevels(QVBoxLayout* rows);
  void addScale(QVBoxLayout* rows);
  void addFilter(QVBoxLayout* rows);
  void addSound(QVBoxLayout* rows);
  void addAdvanced(QVBoxLayout* rows);
  QCheckBox* addSwitch(QVBoxLayout* rows, const QString& name, const char* objectName, const QString& tip, bool SpectralDoppler::*which);
  [[nodiscard]] bool isOn() const override { return isKnown() && session_.console().knobs().mode == DisplayMode::spectrum; }
  /// Those of the console, also before a spectrum was asked for.
  [[nodiscard]] Knobs knobs() const;
  [[nodiscard]] SpectralDoppler spectral() const { return *knobs().spectral; }
  [[nodiscard]] SpectralGate gate() const { return spectralGateOf(session_.console().probe(), knobs()); }
  [[nodiscard]] double mostPrf_hz() const;
  void change(const std::function<void(SpectralDoppler&)>& apply);

  DopplerSpeaker speaker_;
};

void ConsolePanel::addSpectrumPart(QVBoxLayout* rows) {
  auto part = std::make_shared<SpectrumPart>(*this);
  part->fill(rows);
  spectrumPart_ = std::move(part);
}

Knobs ConsolePanel::SpectrumPart::knobs() const {
  Knobs knobs = session_.console().knobs();
  if (!knobs.spectral) knobs.spectral.emplace();
  return knobs;
}

void ConsolePanel::SpectrumPart::change(const std::function<void(SpectralDoppler&)>& apply) {
  panel_.change([&apply](Knobs& k) {
    if (!k.spectral) k.spectral.emplace();
    apply(*k.spectral);
  });
}

void ConsolePanel::SpectrumPart::fill(QVBoxLayout* rows) {
  addAngle(rows);
  addScale(rows);
  addLevels(rows);
  addFilter(rows);
  addSound(rows);
  addAdvanced(
      panel_.addFold(rows, tr("Advanced"), QStringLiteral("spectralAdvanced"), tr("How pulses are sent, and what of blood is shown")));
}

void ConsolePanel::SpectrumPart::addAngle(QVBoxLayout* rows) {
  SliderParts angle;
  angle.name = tr("Angle");
  angle.objectName = QStringLiteral("spectralAngle");
  angle.widest = QStringLiteral("−88°");
  angle.tip =
      tipWithKeys(tr("Between the Doppler line and the way blood flows: lay the flow line along the vessel, by the wheel over it or by "
                     "its ends (%1)"),
                  "spectral.angleMore | spectral.angleLess");
  angle.lowest = -80;
  angle.highest = 80;
  angle.page = 1;
  angle.get = [this] { return rounded(glm::degrees(spectral().angle_rad)); };
  angle.set = [this](int v) { change([v](SpectralDoppler& s) { s.angle_rad = glm::radians(static_cast<double>(v)); }); };
  angle.text = [this] { return angleText(spectral().angle_rad); };
  angle.neutral = [] { return 0; };
  addSlider(rows, std::move(angle), tr("Doppler angle"));
  panel_.addSegments(rows, {{},
                            QStringLiteral("spectralAngles"),
                            {{QStringLiteral("−60°"), QStringLiteral("angleMinus60"), tr("Sets the angle to −60°")},
                             {QStringLiteral("0°"), QStringLiteral("angle0"), tr("Sets the angle to 0°")},
                             {QStringLiteral("60°"), QStringLiteral("angle60"), tr("Sets the angle to 60°")}},
                            [this] {
                              const int degrees = rounded(glm::degrees(spectral().angle_rad));
                              return degrees == -60 ? 0 : degrees == 0 ? 1 : degrees == 60 ? 2 : -1;
                            },
                            [this](int i) { change([i](SpectralDoppler& s) { s.angle_rad = glm::radians(60.0 * (i - 1)); }); },
                            [this] { return isOn(); }});
  SliderParts steering;
  steering.name = tr("Steering");
  steering.objectName = QStringLiteral("spectralSteering");
  steering.widest = QStringLiteral("−20°");
  steering.tip = tr("Tilts the Doppler line, so that it meets a vessel along the skin at less than a right angle");
  steering.page = 5;
  steering.range = [this] { return std::pair{-mostSteering_deg(), mostSteering_deg()}; };
  steering.get = [this] { return rounded(glm::degrees(spectral().steering_rad)); };
  steering.set = [this](int v) { change([v](SpectralDoppler& s) { s.steering_rad = glm::radians(static_cast<double>(v)); }); };
  steering.text = [this] { return angleText(spectral().steering_rad); };
  steering.isOn = [this] { return !session_.console().knobs().trapezoid; };
  steering.isThere = [this] { return session_.console().probe().kind == ProbeKind::linear && mostSteering_deg() > 0; };
  steering.neutral = [] { return 0; };
  addSlider(rows, std::move(steering), tr("Steering of the Doppler line"));
  SliderParts length;
  length.name = tr("Sample volume");
  length.objectName = QStringLiteral("spectralGate");
  length.widest = QStringLiteral("20.0 mm");
  length.tip = tr("Length of the sample volume: longer sees the whole vessel, shorter only its fast middle; drag its ends in the image");
  length.lowest = 1;
  length.highest = 40;
  length.page = 1;
  length.get = [this] { return rounded(2.0 * spectral().gate_mm); };
  length.set = [this](int v) { change([v](SpectralDoppler& s) { s.gate_mm = 0.5 * v; }); };
  length.text = [this] { return tr("%1 mm").arg(figure(spectral().gate_mm, 1)); };
  addSlider(rows, std::move(length), tr("Length of the sample volume"));
}

double ConsolePanel::SpectrumPart::mostPrf_hz() const {
  Knobs fastest = knobs();
  fastest.spectral->prf_hz = kMostPrf_hz;
  return spectralGateOf(session_.console().probe(), fastest).prf_hz;
}

/// The Nyquist velocity along the flow, by the PRF: no more than the depth of the sample volume lets come back, unless high PRF.
void ConsolePanel::SpectrumPart::addScale(QVBoxLayout* rows) {
  const auto lastStep = [this] { return static_cast<int>(std::ceil(stepsToPrf(mostPrf_hz()) - 1e-9)); };
  SliderParts scale;
  scale.name = tr("Scale");
  scale.objectName = QStringLiteral("spectralScale");
  scale.widest = QStringLiteral("888.8 cm/s");
  scale.tip =
      tipWithKeys(tr("The fastest velocity along the flow line that is told from its opposite; faster blood comes back at the other "
                     "end. It ends where echoes from the sample volume would come too late (%1)"),
                  "spectral.scaleMore | spectral.scaleLess");
  scale.page = 2;
  scale.range = [lastStep] { return std::pair{0, lastStep()}; };
  scale.get = [this, lastStep] {
    const double prf_hz = gate().prf_hz;
    return prf_hz >= mostPrf_hz() ? lastStep() : std::min(rounded(stepsToPrf(prf_hz)), lastStep());
  };
  scale.set = [this](int v) { change([prf_hz = std::min(prfAt_hz(v), mostPrf_hz())](SpectralDoppler& s) { s.prf_hz = prf_hz; }); };
  scale.text = [this] {
    const SpectralGate now = gate();
    return speedText(now.nyquist_mmPerS * now.corrected);
  };
  addSlider(rows, std::move(scale), tr("Scale of the spectrum"));
  SliderParts baseline;
  baseline.name = tr("Baseline");
  baseline.objectName = QStringLiteral("spectralBaseline");
  baseline.widest = QStringLiteral("−100 %");
  baseline.tip = tr("Gives one direction more of the strip, and the other less; double-click for the middle");
  baseline.lowest = -9;
  baseline.highest = 9;
  baseline.page = 1;
  baseline.get = [this] { return rounded(spectral().baseline * 10.0); };
  baseline.set = [this](int v) { change([v](SpectralDoppler& s) { s.baseline = v / 10.0; }); };
  baseline.text = [this] { return tr("%1 %").arg(signedFigure(100.0 * spectral().baseline, 0)); };
  baseline.neutral = [] { return 0; };
  addSlider(rows, std::move(baseline), tr("Baseline of the spectrum"));
  addSwitch(rows, tr("Invert spectrum"), "spectralInvert", tr("Blood towards the probe is below the baseline"), &SpectralDoppler::invert);
}

QCheckBox* ConsolePanel::SpectrumPart::addSwitch(QVBoxLayout* rows, const QString& name, const char* objectName, const QString& tip,
                                                 bool SpectralDoppler::*which) {
  QCheckBox* made = panel_.addSwitch(rows, name, QLatin1String(objectName), tip);
  QObject::connect(made, &QCheckBox::toggled, &panel_,
                   [this, which](bool on) { change([which, on](SpectralDoppler& s) { s.*which = on; }); });
  panel_.shows_.emplace_back([this, made, which] {
    made->setChecked(spectral().*which);
    made->setEnabled(isOn());
  });
  return made;
}

void ConsolePanel::SpectrumPart::addLevels(QVBoxLayout* rows) {
  SliderParts gain;
  gain.name = tr("Gain");
  gain.objectName = QStringLiteral("spectralGain");
  gain.widest = QStringLiteral("−30.0 dB");
  gain.tip = tr("Gain of the spectrum and of its sound; double-click for neutral");
  gain.lowest = -60;
  gain.highest = 60;
  gain.page = 4;
  gain.get = [this] { return rounded(spectral().gain_db * 2.0); };
  gain.set = [this](int v) { change([v](SpectralDoppler& s) { s.gain_db = v / 2.0; }); };
  gain.text = [this] { return tr("%1 dB").arg(signedFigure(spectral().gain_db, 1)); };
  gain.neutral = [] { return 0; };
  addSlider(rows, std::move(gain), tr("Gain of the spectrum"));
  addSlider(rows,
            {tr("Dynamic range"), QStringLiteral("spectralRange"), QStringLiteral("88 dB"),
             tr("How many decibels of the spectrum lie between black and white"), 20, 80, 5,
             [this] { return rounded(spectral().dynamicRange_db); },
             [this](int v) { change([v](SpectralDoppler& s) { s.dynamicRange_db = v; }); },
             [this] { return tr("%1 dB").arg(rounded(spectral().dynamicRange_db)); }},
            tr("Dynamic range of the spectrum"));
}

void ConsolePanel::SpectrumPart::addFilter(QVBoxLayout* rows) {
  addSlider(rows,
            {tr("Wall filter"), QStringLiteral("spectralFilter"), tr("%1 Hz").arg(8888),
             tr("Doppler shifts below are taken out, with the walls that move so slowly"), 0, static_cast<int>(kFilters_hz.size()) - 1, 1,
             [this] { return stepOfFilter(spectral().wallFilter_hz); },
             [this](int v) { change([v](SpectralDoppler& s) { s.wallFilter_hz = kFilters_hz[static_cast<std::size_t>(v)]; }); },
             [this] { return tr("%1 Hz").arg(rounded(spectral().wallFilter_hz)); }},
            tr("Wall filter of the spectrum"));
  QCheckBox* envelope = panel_.addSwitch(rows, tr("Envelope"), QStringLiteral("spectralEnvelope"),
                                         tr("Draws the greatest velocity of every moment over the spectrum"));
  QObject::connect(envelope, &QCheckBox::toggled, &panel_, [this](bool on) {
    if (!panel_.showing_) session_.spectrumTrace().setShown(on);
  });
  panel_.shows_.emplace_back([this, envelope] {
    envelope->setChecked(session_.spectrumTrace().isShown());
    envelope->setEnabled(isOn());
  });
}

void ConsolePanel::SpectrumPart::addSound(QVBoxLayout* rows) {
  SliderParts loudness;
  loudness.name = tr("Volume");
  loudness.objectName = QStringLiteral("spectralLoudness");
  loudness.widest = QStringLiteral("100 %");
  loudness.tip = tr("How loud blood is: towards the probe on the left, away from it on the right");
  loudness.page = 10;
  loudness.get = [this] { return rounded(100.0 * speaker_.volume()); };
  loudness.set = [this](int v) { speaker_.setVolume(v / 100.0); };
  loudness.text = [this] { return tr("%1 %").arg(rounded(100.0 * speaker_.volume())); };
  loudness.isOn = [this] { return speaker_.hasOutput() && !speaker_.isMuted(); };
  addSlider(rows, std::move(loudness), tr("Volume of the Doppler sound"));
  QCheckBox* muted = panel_.addSwitch(rows, tr("Mute"), QStringLiteral("spectralMute"), tr("No sound of blood"));
  QLabel* silent = quietLabel(tr("This computer has no sound output that EchoWeave can use."));
  silent->setObjectName(QStringLiteral("noSound"));
  silent->setWordWrap(true);
  rows->addWidget(silent);
  QObject::connect(muted, &QCheckBox::toggled, &panel_, [this](bool on) {
    if (!panel_.showing_) speaker_.setMuted(on);
  });
  QObject::connect(&speaker_, &DopplerSpeaker::changed, &panel_, &ConsolePanel::showAll);
  panel_.shows_.emplace_back([this, muted, silent] {
    muted->setChecked(speaker_.isMuted());
    muted->setEnabled(isOn() && speaker_.hasOutput());
    silent->setVisible(!speaker_.hasOutput());
  });
}

void ConsolePanel::SpectrumPart::addAdvanced(QVBoxLayout* rows) {
  addSwitch(rows, tr("High PRF"), "spectralHighPrf",
            tr("Sends before the last echo is back: a larger scale, and other depths that answer as well, which the image shows"),
            &SpectralDoppler::highPrf);
  addSwitch(
      rows, tr("Intrinsic broadening"), "spectralBroadens",
      tr("Blood crosses beam and pulse in a time, which widens its line and reads too fast, as on a machine; without it velocities are "
         "those of the blood"),
      &SpectralDoppler::broadens);
  panel_.addFact(rows, tr("PRF"), QStringLiteral("88.88 kHz"), [this] { return tr("%1 kHz").arg(figure(gate().prf_hz / 1000.0, 2)); });
  panel_.addFact(rows, tr("Doppler frequency"), QStringLiteral("88.8 MHz"),
                 [this] { return tr("%1 MHz").arg(figure(gate().carrier_hz / 1e6, 1)); });
}

}  // namespace ew::ui
