// The console's pages of the image and of the probe; console_colour.cpp and console_effects.cpp have the others.
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>

#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/words.h"
#include "keys/key_tips.h"
#include "scan/console/console_panel.h"

namespace ew::ui {
namespace {

constexpr int kZoomSteps = 10;  // of the slider per factor 1

/// Where a further focus helps most: in the middle of the widest part of the depth without one.
double placeForFocus_mm(std::vector<double> foci_mm, double depth_mm) {
  foci_mm.push_back(0.0);
  foci_mm.push_back(depth_mm);
  std::sort(foci_mm.begin(), foci_mm.end());
  double best_mm = depth_mm / 2.0;
  double widest_mm = 0.0;
  for (std::size_t i = 1; i < foci_mm.size(); ++i) {
    if (foci_mm[i] - foci_mm[i - 1] <= widest_mm) continue;
    widest_mm = foci_mm[i] - foci_mm[i - 1];
    best_mm = foci_mm[i - 1] + widest_mm / 2.0;
  }
  return std::round(best_mm);
}

}  // namespace

void ConsolePanel::setFoci(int count) {
  change([this, count](Knobs& k) {
    std::vector<double> foci_mm{session_.console().focus_mm()};
    for (const double more_mm : k.moreFoci_mm) {
      if (more_mm > 0.0) foci_mm.push_back(more_mm);
    }
    while (static_cast<int>(foci_mm.size()) < count) foci_mm.push_back(placeForFocus_mm(foci_mm, session_.console().depth_mm()));
    if (count > 1) k.focus_mm = foci_mm.front();
    k.moreFoci_mm = {};
    for (int i = 1; i < count; ++i) k.moreFoci_mm[static_cast<std::size_t>(i - 1)] = foci_mm[static_cast<std::size_t>(i)];
  });
}

void ConsolePanel::addImagePage(QVBoxLayout* rows) {
  const auto hasFocus = [this] { return session_.console().scene().focus.has_value(); };
  addPresets(rows);
  SliderParts focus{tr("Focus"),
                    QStringLiteral("focus"),
                    QStringLiteral("30.0 cm"),
                    tr("Depth of the first focal zone (comma, full stop); drag the marks beside the image for the others"),
                    5,
                    300,
                    5,
                    [this] { return rounded(session_.console().focus_mm()); },
                    [this](int v) { change([v](Knobs& k) { k.focus_mm = v; }); },
                    [this] { return tr("%1 cm").arg(figure(session_.console().focus_mm() / 10.0, 1)); },
                    hasFocus};
  focus.range = [this] { return std::pair{5, rounded(session_.console().depth_mm())}; };
  addSlider(rows, std::move(focus));
  ChoiceParts foci{tr("Focal zones"),
                   QStringLiteral("foci"),
                   {},
                   [this] {
                     const auto& more = session_.console().knobs().moreFoci_mm;
                     return static_cast<int>(std::count_if(more.begin(), more.end(), [](double mm) { return mm > 0.0; }));
                   },
                   [this](int index) { setFoci(index + 1); },
                   hasFocus};
  for (int i = 1; i <= kMostFoci; ++i) {
    foci.choices.push_back({QString::number(i), QStringLiteral("foci%1").arg(i), tr("Number of focal zones (N for the next)")});
  }
  foci.isInline = true;
  addSegments(rows, std::move(foci));
  const auto shownRange_db = [this] {
    const double asked_db = session_.console().knobs().dynamicRange_db;
    return rounded(asked_db > 0.0 ? asked_db : session_.console().scene().recordedDynamicRange_db);
  };
  addSlider(rows, {tr("Dynamic range"), QStringLiteral("dynamicRange"), QStringLiteral("120 dB"),
                   tipWithKeys(tr("How many decibels lie between black and white: fewer give more contrast about the middle greys (%1)"),
                               "range.wider | range.narrower"),
                   20, 120, 5, shownRange_db,
                   [this](int v) {
                     change([this, v](Knobs& k) {
                       k.dynamicRange_db = v == rounded(session_.console().scene().recordedDynamicRange_db) ? 0.0 : v;
                     });
                   },
                   [shownRange_db] { return tr("%1 dB").arg(shownRange_db()); }});
  addGreyMaps(rows);
  addSlider(rows, {tr("Edge enhancement"), QStringLiteral("edges"), QStringLiteral("100 %"),
                   tipWithKeys(tr("Makes borders sharper (%1)"), "edges.more | edges.less"), 0, 100, 10,
                   [this] { return rounded(session_.console().knobs().edgeEnhancement * 100.0); },
                   [this](int v) { change([v](Knobs& k) { k.edgeEnhancement = v / 100.0; }); },
                   [this] {
                     const int percent = rounded(session_.console().knobs().edgeEnhancement * 100.0);
                     return percent == 0 ? tr("off") : tr("%1 %").arg(percent);
                   }});
  addSlider(rows, {tr("Persistence"), QStringLiteral("persistence"), QStringLiteral("95 %"),
                   tipWithKeys(tr("How much of the last image stays (%1)"), "persistence.more | persistence.less"), 0, 95, 10,
                   [this] { return rounded(session_.console().knobs().persistence * 100.0); },
                   [this](int v) { change([v](Knobs& k) { k.persistence = v / 100.0; }); },
                   [this] {
                     const int percent = rounded(session_.console().knobs().persistence * 100.0);
                     return percent == 0 ? tr("off") : tr("%1 %").arg(percent);
                   }});
  addCompounding(rows);
  addSlider(rows, {tr("Zoom"), QStringLiteral("zoom"), QStringLiteral("8.0 x"),
                   tipWithKeys(tr("Magnify; drag in the image to move the detail (%1)"), "zoom.in | zoom.out"), kZoomSteps, 8 * kZoomSteps,
                   kZoomSteps / 2, [this] { return rounded(session_.console().knobs().zoom * kZoomSteps); },
                   [this](int v) { change([v](Knobs& k) { k.zoom = static_cast<double>(v) / kZoomSteps; }); },
                   [this] { return tr("%1 x").arg(figure(session_.console().knobs().zoom, 1)); }});
  addZoomButtons(rows);
  ChoiceParts speed{tr("Quality"),
                    QStringLiteral("speed"),
                    {{tr("Fast"), QStringLiteral("qualityFast"), tr("For a slow computer: the image follows the hand, and is coarser (1)")},
                     {tr("Fine"), QStringLiteral("qualityFine"), tr("Smooth images (2)")}},
                    [this] { return session_.console().knobs().quality == Quality::weave ? 0 : 1; },
                    [this](int i) { chooseQuality(i == 0 ? Quality::weave : Quality::linear); }};
  speed.isInline = true;
  addSegments(rows, std::move(speed));
  addAdvanced(addFold(rows, tr("Advanced"), QStringLiteral("advanced"), tr("How the image is computed, and what that costs")));
}

/// Whether the image is of echoes formed anew: a recorded volume's grain was made by one machine with one setting.
bool ConsolePanel::formsAnew() const {
  const std::optional<LiveEchoesEffect>& echoes = session_.console().scene().liveEchoes;
  if (!echoes || !session_.subject() || !session_.subject()->tissue) return false;
  return !session_.subject()->tissue->isRecorded || !(echoes->ownGrain > 0.0);
}

void ConsolePanel::addCompounding(QVBoxLayout* rows) {
  const auto tip = [](const QString& text) { return tipWithKeys(text, "compound.next"); };
  ChoiceParts angles{
      tr("Compounding"),
      QStringLiteral("compound"),
      {{tr("Off"), QStringLiteral("compound1"), tip(tr("Every line is looked along once (%1)"))},
       {QStringLiteral("3"), QStringLiteral("compound3"),
        tip(tr("The mean of three directions: less grain, fuller borders, shorter shadows; an image takes three times as long (%1)"))},
       {QStringLiteral("5"), QStringLiteral("compound5"), tip(tr("The mean of five directions, five times as long (%1)"))}},
      [this] { return (session_.console().knobs().compoundAngles - 1) / 2; },
      [this](int i) { change([i](Knobs& k) { k.compoundAngles = 1 + 2 * i; }); },
      [this] { return formsAnew() && session_.console().knobs().quality != Quality::weave && !session_.console().knobs().trapezoid; },
      [this] { return session_.console().probe().kind == ProbeKind::linear || session_.console().probe().kind == ProbeKind::convex; }};
  angles.isInline = true;
  addSegments(rows, std::move(angles));
}

void ConsolePanel::addHarmonics(QVBoxLayout* rows) {
  QCheckBox* harmonic = addSwitch(
      rows, tr("Harmonics"), QStringLiteral("harmonic"),
      tipWithKeys(tr("Sends half of the frequency and receives all of it: fluid becomes clearer and layers near the face fainter, "
                     "depth is lost in noise sooner (%1)"),
                  "harmonic"));
  connect(harmonic, &QCheckBox::toggled, this, [this](bool on) { change([on](Knobs& k) { k.harmonic = on; }); });
  shows_.emplace_back([this, harmonic] {
    harmonic->setChecked(session_.console().knobs().harmonic);
    harmonic->setEnabled(formsAnew());
  });
}

void ConsolePanel::addGreyMaps(QVBoxLayout* rows) {
  constexpr std::array kMaps{GreyMap::linear, GreyMap::soft, GreyMap::contrast, GreyMap::bright, GreyMap::clinical};
  ChoiceParts maps{tr("Grey map"),
                   QStringLiteral("greyMap"),
                   {{tr("Linear"), QStringLiteral("greyLinear"), tr("Grey levels as they are (G for the next)")},
                    {tr("Soft"), QStringLiteral("greySoft"), tr("Lifts dark tissue (G for the next)")},
                    {tr("Contrast"), QStringLiteral("greyContrast"), tr("Steep in the middle: more contrast (G for the next)")},
                    {tr("Bright"), QStringLiteral("greyBright"), tr("Brightens everything (G for the next)")},
                    {tr("Clinical"), QStringLiteral("greyClinical"),
                     tr("As a machine shows the abdomen: black background, dark tissue, bright borders (G for the next)")}},
                   [this, kMaps] {
                     const GreyMap shown = resolvedGreyMap(session_.console().knobs(), session_.console().scene());
                     return static_cast<int>(std::find(kMaps.begin(), kMaps.end(), shown) - kMaps.begin());
                   },
                   [this, kMaps](int i) {
                     const GreyMap chosen = kMaps[static_cast<std::size_t>(i)];
                     const bool isUsual = chosen == usualGreyMap(formsEchoes(session_.console().scene()));
                     change([=](Knobs& k) { k.greyMap = isUsual ? GreyMap::automatic : chosen; });
                   }};
  maps.perLine = 3;  // five words side by side are wider than the console
  addSegments(rows, std::move(maps));
}

void ConsolePanel::addGainLaws(QVBoxLayout* rows) {
  addSegments(
      rows, {tr("Gain and TGC"),
             QStringLiteral("gainLaw"),
             {{tr("Decibels"), QStringLiteral("gainDecibels"), tr("As on a machine: along the beam, noise is amplified with the echoes")},
              {tr("Factors"), QStringLiteral("gainFactors"), tr("As in the paper of 1998: factors on grey levels, by rows of the image")}},
             [this] { return session_.console().gainLaw() == GainLaw::decibel ? 0 : 1; },
             [this](int i) {
               const GainLaw chosen = i == 0 ? GainLaw::decibel : GainLaw::paper;
               const bool isUsual = chosen == usualGainLaw(formsEchoes(session_.console().scene()));
               change([=](Knobs& k) { k.gainLaw = isUsual ? GainLaw::automatic : chosen; });
             },
             [this] { return session_.console().scene().gainAndDgc; }});
}

/// What an engineer asks about: how an image is computed, and what that costs.
void ConsolePanel::addAdvanced(QVBoxLayout* rows) {
  addSegments(rows, {tr("Sampling"),
                     QStringLiteral("quality"),
                     {{tr("Nearest"), QStringLiteral("qualityWeave"), tr("The nearest voxels, fastest (1)")},
                      {tr("Linear"), QStringLiteral("qualityLinear"), tr("Interpolated between eight voxels (2)")},
                      {tr("Cubic"), QStringLiteral("qualityCubic"), tr("Interpolated between 64 voxels, sharpest (3)")}},
                     [this] { return static_cast<int>(session_.console().knobs().quality); },
                     [this](int i) { chooseQuality(static_cast<Quality>(i)); }});
  addSegments(rows,
              {tr("Focus model"),
               QStringLiteral("focusMethod"),
               {{tr("Beam width"), QStringLiteral("focusKernel"),
                 tipWithKeys(tr("Every depth is blurred by the width its beam has there (%1)"), "focus.model")},
                {tr("Coarse rows"), QStringLiteral("focusStretch"),
                 tipWithKeys(tr("Rows out of focus are undersampled and stretched back (%1)"), "focus.model")}},
               [this] { return session_.console().knobs().focusMethod == FocusMethod::lateralKernel ? 0 : 1; },
               [this](int i) { change([i](Knobs& k) { k.focusMethod = i == 0 ? FocusMethod::lateralKernel : FocusMethod::rowStretch; }); },
               [this] { return session_.console().scene().focus.has_value(); }});
  ChoiceParts planes{tr("Slice planes"),
                     QStringLiteral("planes"),
                     {},
                     [this] { return (session_.console().knobs().elevationPlanes - 3) / 2; },
                     [this](int i) { change([i](Knobs& k) { k.elevationPlanes = 3 + 2 * i; }); },
                     [this] { return session_.console().scene().sliceThickness.has_value(); }};
  for (int n = 3; n <= 9; n += 2) {
    planes.choices.push_back(
        {QString::number(n), QStringLiteral("planes%1").arg(n),
         tipWithKeys(tr("The thickness is averaged over %1 planes").arg(n) + QStringLiteral(" (%1)"), "effect.planes")});
  }
  planes.isInline = true;
  addSegments(rows, std::move(planes));
  addGainLaws(rows);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  QCheckBox* adaptive =
      addSwitch(line, tr("Adaptive"), QStringLiteral("adaptive"),
                tipWithKeys(tr("Quality may fall while the probe moves fast, and refines at rest (%1)"), "quality.adaptive"));
  auto* cost = new QPushButton(tr("Performance…"));
  cost->setObjectName(QStringLiteral("cost"));
  cost->setAccessibleName(tr("Performance"));
  cost->setToolTip(tipWithKeys(tr("Measure what accuracy costs on this computer (%1)"), "cost"));
  setLook(cost, Look::flat);
  cost->setFocusPolicy(Qt::TabFocus);
  line->addStretch(1);
  line->addWidget(cost);
  rows->addLayout(line);
  connect(cost, &QPushButton::clicked, this, &ConsolePanel::costAsked);
  connect(adaptive, &QCheckBox::toggled, this, [this](bool on) {
    if (showing_) return;
    session_.frames().setAdaptive(on);
    QSettings().setValue(QStringLiteral("adaptiveQuality"), on);
  });
  shows_.emplace_back([this, adaptive] { adaptive->setChecked(session_.frames().isAdaptive()); });
}

void ConsolePanel::addProbePage(QVBoxLayout* rows) {
  addTransducers(rows);
  addFrequencies(rows);
  addHarmonics(rows);
  addSteering(rows);
  addFacts(rows);
}

void ConsolePanel::addTransducers(QVBoxLayout* rows) {
  auto* probe = new QComboBox;
  probe->setObjectName(QStringLiteral("probe"));
  probe->setAccessibleName(tr("Transducer"));
  probe->setMinimumContentsLength(8);
  probe->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rows->addWidget(quietLabel(tr("Transducer")));
  rows->addSpacing(4);
  rows->addWidget(probe);
  rows->addSpacing(8);
  connect(probe, qOverload<int>(&QComboBox::activated), this,
          [this, probe](int index) { session_.console().chooseProbe(probe->itemData(index).toString().toStdString()); });
  shows_.emplace_back([this, probe] {
    const QSignalBlocker quiet(probe);
    bool isSame = probe->count() == static_cast<int>(session_.console().probes().size());
    for (int i = 0; isSame && i < probe->count(); ++i) {
      isSame = probe->itemData(i).toString() == words(session_.console().probes()[static_cast<std::size_t>(i)].id);
    }
    if (!isSame) {
      probe->clear();
      for (const Probe& one : session_.console().probes()) {
        probe->addItem(nameOfProbe(one.name), words(one.id));
        probe->setItemData(probe->count() - 1, nameOfProbe(one.name), Qt::ToolTipRole);
      }
    }
    probe->setCurrentIndex(probe->findData(words(session_.console().probe().id)));
    probe->setToolTip(tr("Transducer: %1 (T for the next)").arg(probe->currentText()));
  });
}

void ConsolePanel::addFrequencies(QVBoxLayout* rows) {
  rows->addWidget(quietLabel(tr("Frequency")));
  rows->addSpacing(4);
  auto* carriers = new QComboBox;
  carriers->setObjectName(QStringLiteral("frequency"));
  carriers->setAccessibleName(tr("Frequency"));
  carriers->setToolTip(tr("Higher is sharper, lower reaches deeper (H for the next)"));
  rows->addWidget(carriers);
  rows->addSpacing(8);
  connect(carriers, qOverload<int>(&QComboBox::activated), this, [this, carriers](int index) {
    const double carrier_hz = carriers->itemData(index).toDouble();
    change([this, carrier_hz](Knobs& k) { k.carrier_hz = carrier_hz == session_.console().probe().carrier_hz ? 0.0 : carrier_hz; });
  });
  shows_.emplace_back([this, carriers] {
    const QSignalBlocker quiet(carriers);
    const Probe& p = session_.console().probe();
    std::vector<double> offered_hz = p.carriers_hz;
    if (offered_hz.empty()) offered_hz = {p.carrier_hz};
    bool isSame = carriers->count() == static_cast<int>(offered_hz.size());
    for (int i = 0; isSame && i < carriers->count(); ++i) {
      isSame = carriers->itemData(i).toDouble() == offered_hz[static_cast<std::size_t>(i)];
    }
    if (!isSame) {
      carriers->clear();
      for (const double hz : offered_hz) carriers->addItem(tr("%1 MHz").arg(figure(hz / 1e6, 1)), hz);
    }
    const double now_hz = session_.console().knobs().carrier_hz > 0.0 ? session_.console().knobs().carrier_hz : p.carrier_hz;
    for (int i = 0; i < carriers->count(); ++i) {
      if (carriers->itemData(i).toDouble() == now_hz) carriers->setCurrentIndex(i);
    }
    carriers->setEnabled(carriers->count() > 1);
  });
}

void ConsolePanel::addSteering(QVBoxLayout* rows) {
  SliderParts steering{tr("Steering"),
                       QStringLiteral("steering"),
                       QStringLiteral("−30°"),
                       tipWithKeys(tr("Tilts the beams of a linear array (%1)"), "steering.less | steering.more"),
                       -30,
                       30,
                       5,
                       [this] { return rounded(glm::degrees(session_.console().knobs().steering_rad)); },
                       [this](int v) { change([v](Knobs& k) { k.steering_rad = glm::radians(static_cast<double>(v)); }); },
                       [this] { return tr("%1°").arg(rounded(glm::degrees(session_.console().knobs().steering_rad))); },
                       [this] { return !session_.console().knobs().trapezoid; },
                       [this] { return session_.console().probe().maxSteering_rad > 0.0; }};
  steering.range = [this] {
    const int most = static_cast<int>(std::floor(glm::degrees(session_.console().probe().maxSteering_rad) + 1e-9));
    return std::pair{-most, most};
  };
  addSlider(rows, std::move(steering));
  QCheckBox* trapezoid = addSwitch(rows, tr("Trapezoid"), QStringLiteral("trapezoid"),
                                   tipWithKeys(tr("The lines of a linear array fan out (%1)"), "trapezoid"));
  connect(trapezoid, &QCheckBox::toggled, this, [this](bool on) { change([on](Knobs& k) { k.trapezoid = on; }); });
  shows_.emplace_back([this, trapezoid] {
    trapezoid->setChecked(session_.console().knobs().trapezoid);
    trapezoid->setVisible(session_.console().probe().trapezoidHalfAngle_rad > 0.0);
  });
}

void ConsolePanel::addFact(QVBoxLayout* rows, const QString& name, const QString& widest, std::function<QString()> text) {
  auto* line = new QHBoxLayout;
  auto* value = new FigureLabel(widest);
  line->addWidget(quietLabel(name));
  line->addStretch(1);
  line->addWidget(value);
  rows->addLayout(line);
  rows->addSpacing(4);
  shows_.emplace_back([value, text = std::move(text)] { value->setText(text()); });
}

/// What the probe is, for whoever wonders why it shows what it shows.
void ConsolePanel::addFacts(QVBoxLayout* rows) {
  rows->addSpacing(8);
  addFact(rows, tr("Scan lines"), QStringLiteral("512"), [this] { return QString::number(session_.console().probe().lines); });
  addFact(rows, tr("Face"), QStringLiteral("88 mm"),
          [this] { return tr("%1 mm").arg(rounded(2.0 * faceHalfWidth_mm(session_.console().probe()))); });
  addFact(rows, tr("Depths"), QStringLiteral("88–888 mm"), [this] {
    return tr("%1–%2 mm").arg(rounded(session_.console().probe().minDepth_mm)).arg(rounded(session_.console().probe().maxDepth_mm));
  });
  addFact(rows, tr("Slice, thinnest"), QStringLiteral("8.8 mm"),
          [this] { return tr("%1 mm").arg(figure(session_.console().probe().elevationalThickness_mm, 1)); });
}

}  // namespace ew::ui
