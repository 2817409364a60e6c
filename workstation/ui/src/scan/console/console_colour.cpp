// The console's controls of colour Doppler.
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/widgets/figures.h"
#include "keys/key_tips.h"
#include "scan/console/console_doppler.h"

namespace ew::ui {
namespace {

constexpr double kHighestPrf_hz = 20000.0;

QString shareText(double share) {
  const auto percent = static_cast<int>(std::lround(share * 100.0));
  return percent == 0 ? ConsolePanel::tr("off") : ConsolePanel::tr("%1 %").arg(percent);
}

}  // namespace

/// The controls, and what they keep.
class ConsolePanel::ColourPart final : public DopplerPart {
 public:
  using DopplerPart::DopplerPart;
  void fill(QVBoxLayout* rows);

 private:
  void addMaps(QVBoxLayout* rows);
  void addScale(QVBoxLayout* rows);
  void addFilter(QVBoxLayout* rows);
  void addSteering(QVBoxLayout* rows);
  void addFacts(QVBoxLayout* rows);
  void addAdvanced(QVBoxLayout* rows);
  void addFrequency(QVBoxLayout* rows);
  [[nodiscard]] bool isOn() const override { return session_.console().knobs().colour.has_value(); }
  /// Those of the console, also while colour is off.
  [[nodiscard]] Knobs knobs() const;
  [[nodiscard]] ColourDoppler colour() const { return *knobs().colour; }
  [[nodiscard]] ColourBox box() const { return colourBoxOf(session_.console().probe(), knobs()); }
  void change(const std::function<void(ColourDoppler&)>& apply);

  ColourDoppler remembered_;  ///< colour that is switched on again is as it was
};

void ConsolePanel::addColourPart(QVBoxLayout* rows) {
  auto part = std::make_shared<ColourPart>(*this);
  part->fill(rows);
  colourPart_ = std::move(part);
}

Knobs ConsolePanel::ColourPart::knobs() const {
  Knobs knobs = session_.console().knobs();
  if (!knobs.colour) knobs.colour = remembered_;
  return knobs;
}

void ConsolePanel::ColourPart::change(const std::function<void(ColourDoppler&)>& apply) {
  panel_.change([&apply](Knobs& k) {
    if (k.colour) apply(*k.colour);
  });
}

void ConsolePanel::ColourPart::fill(QVBoxLayout* rows) {
  QCheckBox* on = panel_.addSwitch(
      rows, tr("Colour Doppler"), QStringLiteral("colour"),
      tipWithKeys(tr("Colours blood that moves within the box; drag the box, its edges and corners in the image (%1)"), "colour"));
  connect(on, &QCheckBox::toggled, &panel_,
          [this](bool now) { panel_.change([this, now](Knobs& k) { k.colour = now ? std::optional(remembered_) : std::nullopt; }); });
  auto* body = new QWidget;
  auto* inside = new QVBoxLayout(body);
  inside->setContentsMargins(0, 4, 0, 0);
  inside->setSpacing(0);
  rows->addWidget(body);
  panel_.shows_.emplace_back([this, on, body] {
    if (isOn() && !session_.isPlaying()) remembered_ = colour();
    on->setVisible(isKnown());
    body->setVisible(isKnown());
    on->setChecked(isOn());
  });
  addMaps(inside);
  addScale(inside);
  addFilter(inside);
  addSteering(inside);
  addFacts(inside);
  addAdvanced(panel_.addFold(inside, tr("Advanced"), QStringLiteral("colourAdvanced"),
                             tr("How many pulses and lines an image of colour is made of, and what of it is shown")));
}

void ConsolePanel::ColourPart::addMaps(QVBoxLayout* rows) {
  ChoiceParts shows{
      {},
      QStringLiteral("colourShows"),
      {{tr("Velocity"), QStringLiteral("colourVelocity"), tr("How fast blood moves along the beam, towards the probe or away from it")},
       {tr("Variance"), QStringLiteral("colourVariance"), tr("Velocity, and green where it spreads, as in turbulence")},
       {tr("Power"), QStringLiteral("colourPower"), tr("How much blood moves, whatever its direction and speed: sees slow flow best")},
       {tr("Directional"), QStringLiteral("colourDirectional"), tr("Directional power: how much blood moves, in two hues")}},
      [this] { return static_cast<int>(colour().shows); },
      [this](int i) { change([i](ColourDoppler& c) { c.shows = static_cast<ColourShows>(i); }); },
      [this] { return isOn(); }};
  shows.perLine = 2;
  panel_.addSegments(rows, std::move(shows));
  SliderParts gain;
  gain.name = tr("Gain");
  gain.objectName = QStringLiteral("colourGain");
  gain.widest = QStringLiteral("−30.0 dB");
  gain.tip = tipWithKeys(tr("Gain of colour: turn it up until the box fills with specks, then down until they go (%1); double-click for "
                            "neutral"),
                         "colour.gainMore | colour.gainLess");
  gain.lowest = -60;
  gain.highest = 60;
  gain.page = 4;
  gain.get = [this] { return rounded(colour().gain_db * 2.0); };
  gain.set = [this](int v) { change([v](ColourDoppler& c) { c.gain_db = v / 2.0; }); };
  gain.text = [this] { return tr("%1 dB").arg(signedFigure(colour().gain_db, 1)); };
  gain.neutral = [] { return 0; };
  addSlider(rows, std::move(gain), tr("Colour gain"));
}

/// The Nyquist velocity, by the PRF: no more than the lower edge of the box lets come back.
void ConsolePanel::ColourPart::addScale(QVBoxLayout* rows) {
  const auto most_hz = [this] {
    Knobs fastest = knobs();
    fastest.colour->prf_hz = kHighestPrf_hz;
    return colourBoxOf(session_.console().probe(), fastest).prf_hz;
  };
  const auto lastStep = [most_hz] { return static_cast<int>(std::ceil(stepsToPrf(most_hz()) - 1e-9)); };
  SliderParts scale;
  scale.name = tr("Scale");
  scale.objectName = QStringLiteral("colourScale");
  scale.widest = QStringLiteral("888.8 cm/s");
  scale.tip =
      tipWithKeys(tr("The fastest velocity along the beam that is told from its opposite; faster blood takes the colours of the other "
                     "direction. It ends where echoes from the lower edge of the box would come too late (%1)"),
                  "colour.scaleMore | colour.scaleLess");
  scale.page = 2;
  scale.range = [lastStep] { return std::pair{0, lastStep()}; };
  scale.get = [this, most_hz, lastStep] {
    const double prf_hz = box().prf_hz;
    return prf_hz >= most_hz() ? lastStep() : std::min(rounded(stepsToPrf(prf_hz)), lastStep());
  };
  scale.set = [this, most_hz](int v) { change([prf_hz = std::min(prfAt_hz(v), most_hz())](ColourDoppler& c) { c.prf_hz = prf_hz; }); };
  scale.text = [this] { return speedText(box().nyquist_mmPerS); };
  addSlider(rows, std::move(scale), tr("Colour scale"));
  SliderParts baseline;
  baseline.name = tr("Baseline");
  baseline.objectName = QStringLiteral("colourBaseline");
  baseline.widest = QStringLiteral("+888.8 cm/s");
  baseline.tip = tr("Gives one direction more of the range that is shown, and the other less; double-click for the middle");
  baseline.lowest = -9;
  baseline.highest = 9;
  baseline.page = 1;
  baseline.get = [this] { return rounded(colour().baseline * 10.0); };
  baseline.set = [this](int v) { change([v](ColourDoppler& c) { c.baseline = v / 10.0; }); };
  baseline.text = [this] {
    const auto [lowest_mmPerS, highest_mmPerS] = box().shown_mmPerS;
    return tr("%1 cm/s").arg(signedFigure(0.05 * (lowest_mmPerS + highest_mmPerS), 1));
  };
  baseline.isOn = [this] {
    const ColourShows shows = colour().shows;
    return shows == ColourShows::velocity || shows == ColourShows::variance;
  };
  baseline.neutral = [] { return 0; };
  addSlider(rows, std::move(baseline), tr("Colour baseline"));
}

void ConsolePanel::ColourPart::addFilter(QVBoxLayout* rows) {
  panel_.addSegments(rows, {tr("Wall filter"),
                            QStringLiteral("wallFilter"),
                            {{tr("Low"), QStringLiteral("wallLow"), tr("Keeps slow blood, and flashes where tissue moves")},
                             {tr("Medium"), QStringLiteral("wallMedium"), tr("For arteries")},
                             {tr("High"), QStringLiteral("wallHigh"), tr("Keeps fast blood alone, where walls and hearts move")}},
                            [this] { return static_cast<int>(colour().wallFilter); },
                            [this](int i) { change([i](ColourDoppler& c) { c.wallFilter = static_cast<WallFilterSetting>(i); }); },
                            [this] { return isOn(); }});
}

void ConsolePanel::ColourPart::addSteering(QVBoxLayout* rows) {
  SliderParts steering;
  steering.name = tr("Steering");
  steering.objectName = QStringLiteral("colourSteering");
  steering.widest = QStringLiteral("−20°");
  steering.tip = tr("Tilts the box, so that its beams meet a vessel along the skin at less than a right angle");
  steering.page = 5;
  steering.range = [this] { return std::pair{-mostSteering_deg(), mostSteering_deg()}; };
  steering.get = [this] { return rounded(glm::degrees(box().steering_rad)); };
  steering.set = [this](int v) { change([v](ColourDoppler& c) { c.steering_rad = glm::radians(static_cast<double>(v)); }); };
  steering.text = [this] { return tr("%1°").arg(rounded(glm::degrees(box().steering_rad))); };
  steering.isOn = [this] { return !session_.console().knobs().trapezoid; };
  steering.isThere = [this] { return session_.console().probe().kind == ProbeKind::linear && mostSteering_deg() > 0; };
  steering.neutral = [] { return 0; };
  addSlider(rows, std::move(steering), tr("Colour steering"));
  QCheckBox* invert = panel_.addSwitch(rows, tr("Invert colours"), QStringLiteral("colourInvert"),
                                       tr("Blood towards the probe is blue and blood away from it red"));
  connect(invert, &QCheckBox::toggled, &panel_, [this](bool on) { change([on](ColourDoppler& c) { c.invert = on; }); });
  panel_.shows_.emplace_back([this, invert] {
    invert->setChecked(colour().invert);
    invert->setEnabled(isOn() && colour().shows != ColourShows::power);
  });
}

void ConsolePanel::ColourPart::addFacts(QVBoxLayout* rows) {
  rows->addSpacing(4);
  panel_.addFact(rows, tr("Filter edge"), QStringLiteral("888.8 cm/s"), [this] { return speedText(box().wallEdge_mmPerS); });
  panel_.addFact(rows, tr("PRF"), QStringLiteral("88.88 kHz"), [this] { return tr("%1 kHz").arg(figure(box().prf_hz / 1000.0, 2)); });
  panel_.addFact(rows, tr("Images per second"), QStringLiteral("888.8"), [this] { return figure(1.0 / box().frame_s, 1); });
}

void ConsolePanel::ColourPart::addAdvanced(QVBoxLayout* rows) {
  addSlider(rows,
            {tr("Packet"), QStringLiteral("colourPacket"), tr("%1 pulses").arg(88),
             tr("Pulses along each line: more of them are surer of velocities and of slow blood, and take longer"), 2, kMostPacket, 2,
             [this] { return colour().packet; }, [this](int v) { change([v](ColourDoppler& c) { c.packet = v; }); },
             [this] { return tr("%1 pulses").arg(colour().packet); }},
            tr("Colour packet"));
  ChoiceParts lines{tr("Lines"),
                    QStringLiteral("colourLines"),
                    {{QStringLiteral("1"), QStringLiteral("colourLines1"), tr("A line of colour along every line of the image")}},
                    [this] { return colour().everyLine - 1; },
                    [this](int i) { change([i](ColourDoppler& c) { c.everyLine = i + 1; }); },
                    [this] { return isOn(); }};
  ChoiceParts smoothing{tr("Smoothing"),
                        QStringLiteral("colourSmoothing"),
                        {{tr("Off"), QStringLiteral("colourSmoothing0"), tr("Every place by itself")}},
                        [this] { return colour().smoothing; },
                        [this](int i) { change([i](ColourDoppler& c) { c.smoothing = i; }); },
                        [this] { return isOn(); }};
  for (int n = 1; n <= 3; ++n) {
    lines.choices.push_back({QStringLiteral("1/%1").arg(n + 1), QStringLiteral("colourLines%1").arg(n + 1),
                             tr("A line of colour for %1 lines of the image: faster, and coarser").arg(n + 1)});
    smoothing.choices.push_back({QString::number(n), QStringLiteral("colourSmoothing%1").arg(n),
                                 tr("Averaged over so many neighbours on either side: smoother, and less sharp")});
  }
  lines.isInline = smoothing.isInline = true;
  panel_.addSegments(rows, std::move(lines));
  panel_.addSegments(rows, std::move(smoothing));
  const auto addShare = [&](const QString& name, const char* objectName, const QString& wholeName, const QString& tip, int most,
                            double ColourDoppler::*share) {
    addSlider(rows,
              {name, QLatin1String(objectName), QStringLiteral("100 %"), tip, 0, most, 5,
               [this, share] { return rounded(colour().*share * 100.0); },
               [this, share](int v) { change([v, share](ColourDoppler& c) { c.*share = v / 100.0; }); },
               [this, share] { return shareText(colour().*share); }},
              wholeName);
  };
  addShare(tr("Persistence"), "colourPersistence", tr("Colour persistence"), tr("How much of the last colours stays"), 95,
           &ColourDoppler::persistence);
  addShare(tr("Priority"), "colourPriority", tr("Colour priority"), tr("Echoes of this grey and brighter are tissue and stay grey"), 100,
           &ColourDoppler::priority);
  addShare(tr("Reject"), "colourReject", tr("Colour reject"), tr("Blood slower than this share of the scale has no colour"), 50,
           &ColourDoppler::reject);
  addFrequency(rows);
}

void ConsolePanel::ColourPart::addFrequency(QVBoxLayout* rows) {
  const auto tenths = [](double carrier_hz) { return rounded(carrier_hz / 1e5); };
  const auto usual = [this, tenths] {
    Knobs usualKnobs = knobs();
    usualKnobs.colour->carrier_hz = 0.0;
    return tenths(colourBoxOf(session_.console().probe(), usualKnobs).carrier_hz);
  };
  SliderParts frequency;
  frequency.name = tr("Doppler frequency");
  frequency.objectName = QStringLiteral("colourFrequency");
  frequency.widest = QStringLiteral("88.8 MHz");
  frequency.tip = tr("What is sent for colour: lower reaches deeper and has a larger scale; double-click for the usual one");
  frequency.page = 5;
  frequency.range = [usual] { return std::pair{std::max(10, usual() / 2), std::min(200, usual() * 2)}; };
  frequency.get = [this, tenths] { return tenths(box().carrier_hz); };
  frequency.set = [this, usual](int v) {
    change([carrier_hz = v == usual() ? 0.0 : v * 1e5](ColourDoppler& c) { c.carrier_hz = carrier_hz; });
  };
  frequency.text = [this] { return tr("%1 MHz").arg(figure(box().carrier_hz / 1e6, 1)); };
  frequency.neutral = usual;
  addSlider(rows, std::move(frequency), tr("Doppler frequency"));
}

}  // namespace ew::ui
