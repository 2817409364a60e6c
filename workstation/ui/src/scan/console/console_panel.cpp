#include "scan/console/console_doppler.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCursor>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <QTabBar>
#include <QTabWidget>
#include <QToolTip>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>

#include "ew/widgets/double_click.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"
#include "window/layout/window_layout.h"

namespace ew::ui {
namespace {

constexpr int kSlider_px = 96, kShortSlider_px = 52;

/// Of a button between others, by where it stands as they are read.
Look lookOfSegment(bool isFirst, bool isLast) {
  const bool isAtLeft = QApplication::isRightToLeft() ? isLast : isFirst, isAtRight = QApplication::isRightToLeft() ? isFirst : isLast;
  return isAtLeft ? Look::firstOf : isAtRight ? Look::lastOf : Look::segment;
}

}  // namespace

ConsolePanel::ConsolePanel(Session& session, QWidget* parent) : QWidget(parent), session_(session), remembered_(sceneWithEverything()) {
  setObjectName(QStringLiteral("console"));
  setAttribute(Qt::WA_StyledBackground);
  session_.frames().setAdaptive(QSettings().value(QStringLiteral("adaptiveQuality"), true).toBool());
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 12);
  rows->setSpacing(0);
  rows->addSpacing(12);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(16, 0, 16, 4);
  top->setSpacing(0);
  addGain(top);  // first of topLines_
  SliderParts depth{tr("Depth"),
                    QStringLiteral("depth"),
                    QStringLiteral("30.0 cm"),
                    tipWithKeys(tr("Depth of the image (%1)"), "depth.less | depth.more"),
                    1,
                    300,
                    10,
                    [this] { return rounded(session_.console().depth_mm()); },
                    [this](int v) { change([v](Knobs& k) { k.depth_mm = v; }); },
                    [this] { return tr("%1 cm").arg(figure(session_.console().depth_mm() / 10.0, 1)); }};
  depth.range = [this] {
    return std::pair{static_cast<int>(std::ceil(session_.console().probe().minDepth_mm)),
                     static_cast<int>(session_.console().probe().maxDepth_mm)};
  };
  addSlider(top, std::move(depth));
  topLines_ = lines_;
  rows->addLayout(top);
  pages_ = new QTabWidget;
  pages_->setObjectName(QStringLiteral("consolePages"));
  pages_->setDocumentMode(true);
  pages_->setFocusPolicy(Qt::TabFocus);
  pages_->addTab(makePage([this](QVBoxLayout* page) {
                   firstPage_ = page;
                   addImagePage(page);
                 }),
                 tr("Image"));
  pages_->addTab(makePage([this](QVBoxLayout* page) { addDopplerPage(page); }), tr("Flow"));
  pages_->addTab(makePage([this](QVBoxLayout* page) { addEffectsPage(page); }), tr("Effects"));
  pages_->addTab(makePage([this](QVBoxLayout* page) { addProbePage(page); }), tr("Probe"));
  const QString keys[] = {tipWithKeys(tr("What the image shows and how (%1)"), "console.nextPage"),
                          tipWithKeys(tr("Doppler: how blood flows, in colours and as a spectrum (%1)"), "console.nextPage"),
                          tipWithKeys(tr("What the scene does to the sound (%1)"), "console.nextPage"),
                          tipWithKeys(tr("The transducer and its beams (%1)"), "console.nextPage")};
  pageTips_.assign(std::begin(keys), std::end(keys));
  rows->addWidget(pages_, 1000);  // all there is, up to its own height
  bottom_ = new QVBoxLayout;
  bottom_->setContentsMargins(16, 8, 16, 0);
  bottom_->setSpacing(0);
  alwaysBox_ = new QWidget;
  always_ = new QVBoxLayout(alwaysBox_);
  always_->setContentsMargins(0, 0, 0, 0);
  always_->setSpacing(0);
  addAlways(always_);
  bottom_->addWidget(alwaysBox_);
  bottom_->addSpacing(8);
  bottom_->addWidget(freeze_);
  rows->addLayout(bottom_);
  rows->addStretch(1);
  refreshIcons();

  connect(&session_.console(), &ScanConsole::knobsChanged, this, &ConsolePanel::showAll);
  connect(&session_.console(), &ScanConsole::sceneChanged, this, &ConsolePanel::showAll);
  connect(&session_.console(), &ScanConsole::probeChanged, this, &ConsolePanel::showAll);
  connect(&session_.frames(), &FrameTimer::adaptiveChanged, this, &ConsolePanel::showAll);
  connect(&session_, &Session::subjectChanged, this, &ConsolePanel::showAll);
  connect(&session_, &Session::frozenChanged, freeze_, &QPushButton::setChecked);
  showAll();
}

/// In half decibels, or per cent by the paper's law.
void ConsolePanel::addGain(QBoxLayout* rows) {
  const auto inDecibels = [this] { return session_.console().gainLaw() == GainLaw::decibel; };
  SliderParts gain;
  gain.name = tr("Gain");
  gain.objectName = QStringLiteral("gain");
  gain.widest = QStringLiteral("−30.0 dB");
  gain.tip = tipWithKeys(tr("Overall gain (%1); double-click for neutral"), "gain.more | gain.less");
  gain.get = [this, inDecibels] {
    return rounded(inDecibels() ? session_.console().knobs().gain_db * 2.0 : session_.console().knobs().gain * 100.0);
  };
  gain.set = [this, inDecibels](int v) {
    change([v, db = inDecibels()](Knobs& k) { (db ? k.gain_db : k.gain) = v / (db ? 2.0 : 100.0); });
  };
  gain.text = [this, inDecibels] {
    return inDecibels() ? tr("%1 dB").arg(signedFigure(session_.console().knobs().gain_db, 1))
                        : tr("%1 %").arg(rounded(session_.console().knobs().gain * 100.0));
  };
  gain.isOn = [this] { return session_.console().scene().gainAndDgc; };
  gain.range = [inDecibels] { return inDecibels() ? std::pair{-60, 60} : std::pair{0, 300}; };
  gain.pageNow = [inDecibels] { return inDecibels() ? 4 : 5; };
  gain.neutral = [inDecibels] { return inDecibels() ? 0 : 100; };
  addSlider(rows, std::move(gain));
}

QLabel* ConsolePanel::quietLabel(const QString& text) {
  auto* label = new QLabel(text);
  setLook(label, Look::quiet);
  return label;
}

void ConsolePanel::change(const std::function<void(Knobs&)>& apply) {
  if (showing_) return;  // the panel is being told, not telling
  Knobs knobs = session_.console().knobs();
  apply(knobs);
  session_.console().setKnobs(knobs);
}

void ConsolePanel::changeScene(const std::function<void(Scene&)>& apply) {
  if (showing_) return;
  Scene scene = session_.console().scene();
  apply(scene);
  session_.console().setScene(scene);
}

QWidget* ConsolePanel::makePage(const std::function<void(QVBoxLayout*)>& fill) {
  auto* body = new QWidget;
  body->setObjectName(QStringLiteral("consolePage"));
  auto* rows = new QVBoxLayout(body);
  rows->setContentsMargins(16, 12, 16, 8);
  rows->setSpacing(0);
  fill(rows);
  rows->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(body);
  return scroll;
}

QSlider* ConsolePanel::addSlider(QBoxLayout* rows, SliderParts parts) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(parts.objectName);
  slider->setRange(parts.lowest, parts.highest);
  slider->setPageStep(parts.page);
  holdFixedHeight(*slider, 22);
  slider->setMinimumWidth(kSlider_px);
  slider->setToolTip(parts.tip);
  slider->setAccessibleName(parts.name);
  auto* value = new FigureLabel(parts.widest);
  value->setObjectName(parts.objectName + QStringLiteral("Value"));
  QLabel* name = nullptr;
  if (!parts.name.isEmpty()) {
    name = quietLabel(parts.name);
    name->setBuddy(slider);
    name->setToolTip(parts.tip);
    line->addWidget(name);
    line->addStretch(1);
    line->addWidget(value);
    column->addLayout(line);
    column->addWidget(slider);
  } else {
    line->addWidget(slider, 1);
    line->addWidget(value);
    column->addLayout(line);
  }
  rows->addWidget(box);
  if (name != nullptr) lines_.push_back({column, line, slider, name});
  connect(slider, &QSlider::valueChanged, this, [this, slider, set = parts.set, isNamed = !parts.name.isEmpty()](int v) {
    if (showing_) return;
    set(v);
    if (!isNamed && slider->isSliderDown()) QToolTip::showText(QCursor::pos(), slider->toolTip(), slider);
  });
  if (parts.neutral) onDoubleClick(slider, [slider, neutral = parts.neutral] { slider->setValue(neutral()); });
  shows_.emplace_back([box, slider, value, parts = std::move(parts)] {
    if (parts.pageNow) slider->setPageStep(parts.pageNow());
    if (parts.range) {
      const auto [lowest, highest] = parts.range();
      slider->setRange(lowest, highest);
    }
    slider->setValue(parts.get());
    slider->setAccessibleDescription(parts.text());
    if (parts.name.isEmpty()) slider->setToolTip(tr("%1: %2").arg(parts.tip, parts.text()));
    value->setText(parts.text());
    const bool isOn = parts.isOn();
    slider->setEnabled(isOn);
    value->setEnabled(isOn);
    box->setVisible(parts.isThere());
  });
  return slider;
}

void ConsolePanel::addSegments(QBoxLayout* rows, ChoiceParts parts) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 4, 0, 6);
  column->setSpacing(4);
  auto* line = new QHBoxLayout;
  line->setSpacing(0);
  if (parts.isInline) {
    line->addWidget(quietLabel(parts.name));
    line->addSpacing(16);
  } else if (!parts.name.isEmpty()) {
    column->addWidget(quietLabel(parts.name));
  }
  auto* group = new QButtonGroup(box);
  group->setObjectName(parts.objectName);
  std::vector<QPushButton*> buttons;
  for (std::size_t i = 0; i < parts.choices.size(); ++i) {
    const Choice& choice = parts.choices[i];
    auto* button = new QPushButton(choice.text);
    button->setObjectName(choice.objectName);
    button->setToolTip(choice.tip);
    button->setAccessibleName(!choice.accessibleName.isEmpty() ? choice.accessibleName
                              : parts.name.isEmpty()           ? choice.text
                                                               : parts.name + QStringLiteral(": ") + choice.text);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys away from the probe
    const bool isFirst = i % parts.perLine == 0;
    const bool isLast = i + 1 == parts.choices.size() || (i + 1) % parts.perLine == 0;
    setLook(button, lookOfSegment(isFirst, isLast));
    if (isFirst && i > 0) {
      column->addLayout(line);
      line = new QHBoxLayout;
      line->setSpacing(0);
    }
    group->addButton(button, static_cast<int>(i));
    line->addWidget(button, 1);
    buttons.push_back(button);
  }
  column->addLayout(line);
  rows->addWidget(box);
  connect(group, &QButtonGroup::idClicked, this, [this, set = parts.set](int index) {
    if (!showing_) set(index);
  });
  shows_.emplace_back([box, group, buttons, parts = std::move(parts)] {
    const int now = parts.get();
    group->setExclusive(now >= 0);  // an exclusive group keeps one that is pressed, also where none is chosen
    for (std::size_t i = 0; i < buttons.size(); ++i) {
      buttons[i]->setChecked(static_cast<int>(i) == now);
      buttons[i]->setEnabled(parts.isOn());
      if (!parts.choices[i].isThere || parts.choices[i].isThere() != buttons[i]->isHidden()) continue;
      buttons[i]->setVisible(buttons[i]->isHidden());
      if (i > 0) setLook(buttons[i - 1], lookOfSegment(i == 1, buttons[i]->isHidden()));
    }
    box->setVisible(parts.isThere());
  });
}

QVBoxLayout* ConsolePanel::addFold(QBoxLayout* rows, const QString& title, const QString& objectName, const QString& tip) {
  auto* head = new QPushButton(title);
  head->setObjectName(objectName);
  setLook(head, Look::fold);
  head->setAccessibleName(title);
  head->setToolTip(tip);
  head->setCheckable(true);
  head->setFocusPolicy(Qt::TabFocus);
  auto* body = new QWidget;
  auto* inside = new QVBoxLayout(body);
  inside->setContentsMargins(0, 4, 0, 4);
  inside->setSpacing(0);
  rows->addWidget(head);
  rows->addWidget(body);
  const QString setting = QStringLiteral("fold/") + objectName;
  head->setChecked(QSettings().value(setting, false).toBool());
  body->setVisible(head->isChecked());
  connect(head, &QPushButton::toggled, this, [this, body, setting](bool open) {
    QSettings().setValue(setting, open);
    body->setVisible(open);
    refreshIcons();
    fitPages();
  });
  folds_.push_back(head);
  return inside;
}

void ConsolePanel::fitPages() {
  int most_px = 0;
  for (int i = 0; i < pages_->count(); ++i) {
    QWidget* body = static_cast<QScrollArea*>(pages_->widget(i))->widget();
    body->layout()->activate();
    most_px = std::max(most_px, body->sizeHint().height());
  }
  pages_->setMaximumHeight(pages_->tabBar()->sizeHint().height() + most_px + 2);
}

QCheckBox* ConsolePanel::addSwitch(QBoxLayout* rows, const QString& name, const QString& objectName, const QString& tip) {
  auto* made = new QCheckBox(name);
  made->setObjectName(objectName);
  made->setToolTip(tip);
  made->setAccessibleName(name);
  made->setFocusPolicy(Qt::TabFocus);
  holdLeastHeight(*made, 24);
  rows->addWidget(made);
  return made;
}

void ConsolePanel::addBelow(QWidget* row) { always_->addWidget(row); }

void ConsolePanel::addModes(QVBoxLayout* rows) {
  constexpr std::array kModes{DisplayMode::bMode, DisplayMode::both, DisplayMode::mMode, DisplayMode::spectrum};
  const auto knowsBlood = [this] { return session_.subject() && session_.subject()->showsColour(); };
  addSegments(rows, {{},
                     QStringLiteral("mode"),
                     {{QStringLiteral("B"), QStringLiteral("modeB"), tr("The image (M for the next mode)")},
                      {QStringLiteral("B + M"), QStringLiteral("modeBoth"), tr("Image and one beam over time (M for the next mode)")},
                      {QStringLiteral("M"), QStringLiteral("modeM"), tr("One beam over time (M for the next mode)")},
                      {tr("PW", "spectral Doppler"), QStringLiteral("modePw"),
                       tipWithKeys(tr("Image and the spectrum of blood in a sample volume over time (%1)"), "spectral"), knowsBlood,
                       tr("Spectral Doppler")}},
                     [this, kModes, knowsBlood] {
                       const DisplayMode mode = session_.console().knobs().mode;
                       if (mode == DisplayMode::spectrum && !knowsBlood()) return 0;
                       return static_cast<int>(std::find(kModes.begin(), kModes.end(), mode) - kModes.begin());
                     },
                     [this, kModes](int i) {
                       change([this, mode = kModes[static_cast<std::size_t>(i)]](Knobs& k) {
                         k.mode = mode;
                         if (mode == DisplayMode::spectrum && !k.spectral) k.spectral = firstSpectrum(session_.console().probe(), k);
                       });
                     }});
}

void ConsolePanel::addAlways(QVBoxLayout* rows) {
  const auto hasBeam = [this] {
    const DisplayMode mode = session_.console().knobs().mode;
    return mode == DisplayMode::mMode || mode == DisplayMode::both;
  };
  const auto movesInTime = [this] { return session_.console().knobs().mode != DisplayMode::bMode; };
  addModes(rows);
  SliderParts line{
      tr("M line"),
      QStringLiteral("mLine"),
      QStringLiteral("−100 %"),
      tipWithKeys(tr("Which beam is shown over time, from one end of the face to the other (%1)"), "mode.lineLeft | mode.lineRight"),
      -100,
      100,
      5,
      [this] { return rounded(session_.console().knobs().mLine * 100.0) * (session_.console().knobs().markerLeft ? -1 : 1); },
      [this](int v) { change([v](Knobs& k) { k.mLine = (k.markerLeft ? -v : v) / 100.0; }); },
      [this] {
        return tr("%1 %").arg(rounded(session_.console().knobs().mLine * 100.0) * (session_.console().knobs().markerLeft ? -1 : 1));
      },
      [] { return true; },
      hasBeam};
  addSlider(rows, std::move(line));
  addSlider(rows,
            {tr("Sweep"), QStringLiteral("sweep"), QStringLiteral("16 s"),
             tipWithKeys(tr("Time across the strip (%1)"), "mode.slower | mode.faster"), 1, 16, 1,
             [this] { return rounded(session_.console().knobs().mSweep_s); }, [this](int v) { change([v](Knobs& k) { k.mSweep_s = v; }); },
             [this] { return tr("%1 s").arg(rounded(session_.console().knobs().mSweep_s)); }, [] { return true; }, movesInTime});
  flip_ = new QPushButton(tr("Left/right", "inverts the image"));
  flip_->setObjectName(QStringLiteral("flip"));
  turn_ = new QPushButton(tr("Up/down", "inverts the image"));
  turn_->setObjectName(QStringLiteral("upsideDown"));
  freeze_ = new QPushButton(tr("Freeze"));
  freeze_->setObjectName(QStringLiteral("freeze"));
  freeze_->setToolTip(tipWithKeys(tr("Keep the image, and look through the last 30 s (%1)"), "freeze"));
  for (QPushButton* button : {flip_, turn_, freeze_}) {
    button->setCheckable(true);
    setLook(button, Look::compact);  // two long words side by side in some languages
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(button->text());
  }
  flip_->setAccessibleName(tr("Invert left/right"));
  turn_->setAccessibleName(tr("Invert up/down"));
  auto* orientation = new QHBoxLayout;
  orientation->setSpacing(4);
  orientation->addWidget(flip_, 1);
  orientation->addWidget(turn_, 1);
  rows->addSpacing(4);
  rows->addLayout(orientation);
  connect(flip_, &QPushButton::toggled, this, [this](bool on) { change([on](Knobs& k) { k.markerLeft = !on; }); });
  connect(turn_, &QPushButton::toggled, this, [this](bool on) { change([on](Knobs& k) { k.upsideDown = on; }); });
  connect(freeze_, &QPushButton::toggled, &session_, &Session::setFrozen);
  shows_.emplace_back([this] {
    const Knobs& knobs = session_.console().knobs();
    flip_->setChecked(!knobs.markerLeft);
    flip_->setToolTip(knobs.markerLeft ? tipWithKeys(tr("The marker is at the left, as usual; put it at the right (%1)"), "flip.sides")
                                       : tipWithKeys(tr("The marker is at the right; put it at the left, as usual (%1)"), "flip.sides"));
    turn_->setChecked(knobs.upsideDown);
    turn_->setToolTip(knobs.upsideDown
                          ? tipWithKeys(tr("The probe is at the bottom; put it at the top, as usual (%1)"), "flip.upsideDown")
                          : tipWithKeys(tr("The probe is at the top, as usual; put it at the bottom (%1)"), "flip.upsideDown"));
  });
}

void ConsolePanel::refreshIcons() {
  flip_->setIcon(icon(QStringLiteral("flip")));
  turn_->setIcon(icon(QStringLiteral("turn")));
  freeze_->setIcon(icon(QStringLiteral("freeze")));
  for (QPushButton* fold : folds_) fold->setIcon(icon(fold->isChecked() ? QStringLiteral("unfolded") : QStringLiteral("folded")));
}

void ConsolePanel::showAll() {
  if (showing_) return;
  showing_ = true;
  for (const auto& show : shows_) show();
  showing_ = false;
  fitPages();
}

void ConsolePanel::step(const QString& control, int steps) {
  if (auto* slider = findChild<QSlider*>(control)) {
    // A slider is hidden with the box around it, which says that the probe does not have it.
    if (slider->isEnabled() && !slider->parentWidget()->isHidden()) slider->setValue(slider->value() + steps * slider->pageStep());
  } else if (auto* group = findChild<QButtonGroup*>(control)) {
    const int count = static_cast<int>(group->buttons().size());
    int next = group->checkedId();
    do next = (next + steps + count) % count;
    while (group->button(next)->isHidden());
    if (group->button(next)->isEnabled()) group->button(next)->click();
  } else if (auto* choice = findChild<QComboBox*>(control)) {
    if (choice->count() < 2) return;
    choice->setCurrentIndex((choice->currentIndex() + steps + choice->count()) % choice->count());
    Q_EMIT choice->activated(choice->currentIndex());
  } else if (auto* button = findChild<QAbstractButton*>(control)) {
    if (button->isEnabled() && !button->isHidden()) button->click();
  }
}

/// Name and value above the slider, or at its sides; then the sliders begin below each other.
void ConsolePanel::placeLines() {
  int widest_px = 0;
  for (const Line& each : topLines_) widest_px = std::max(widest_px, each.name->sizeHint().width());
  for (const Line& each : topLines_) {
    each.name->setMinimumWidth(isShort_ ? widest_px : 0);
    each.slider->setMinimumWidth(isShort_ ? kShortSlider_px : kSlider_px);  // beside name and figure, which both have to be read
    const bool isBeside = each.line->indexOf(each.slider) >= 0;
    if (isBeside == isShort_) continue;
    if (isShort_) {
      each.column->removeWidget(each.slider);
      each.line->insertWidget(1, each.slider, 1000);
    } else {
      each.line->removeWidget(each.slider);
      each.column->addWidget(each.slider);
    }
  }
}

void ConsolePanel::setShort(bool isShort) {
  if (isShort == isShort_) return;
  isShort_ = isShort;
  placeLines();
  if (isShort) {
    bottom_->removeWidget(alwaysBox_);
    firstPage_->insertWidget(firstPage_->count() - 1, alwaysBox_);  // before the stretch
  } else {
    firstPage_->removeWidget(alwaysBox_);
    bottom_->insertWidget(0, alwaysBox_);
  }
  alwaysBox_->show();
  fitPages();
}

void ConsolePanel::addPresets(QVBoxLayout* rows) {
  preset_ = new QPushButton;
  preset_->setObjectName(QStringLiteral("presets"));
  preset_->setAccessibleName(tr("Presets"));
  preset_->setFocusPolicy(Qt::TabFocus);
  rows->addWidget(preset_);
  rows->addSpacing(8);
  shows_.emplace_back([this] {
    if (presetKnobs_ && !(*presetKnobs_ == session_.console().knobs())) presetKnobs_.reset();
    const QString whole = presetKnobs_ ? tr("Preset: %1").arg(presetTitle_) : tr("Presets");
    const int room_px = scaled(kConsoleWidth_px - 80);
    preset_->setText(preset_->fontMetrics().elidedText(whole, Qt::ElideRight, room_px).replace(QLatin1Char('&'), QStringLiteral("&&")));
    preset_->setToolTip(presetKnobs_ ? whole : tr("Sets the whole console for an examination"));
    preset_->setEnabled(session_.subject().has_value());
  });
}

void ConsolePanel::setPresetMenu(QMenu& menu) { preset_->setMenu(&menu); }

void ConsolePanel::showPreset(const QString& title) {
  presetTitle_ = title;
  presetKnobs_ = session_.console().knobs();
  showAll();
}

void ConsolePanel::addPage(QWidget* page, const QString& title, const QString& tip) {
  const int index = pages_->addTab(makePage([page](QVBoxLayout* rows) { rows->addWidget(page); }), title);
  pageTips_.insert(pageTips_.begin() + index, tip);
}

void ConsolePanel::showKeys(const KeyTips& tips) {
  for (int i = 0; i < pages_->count(); ++i) pages_->setTabToolTip(i, tips.filledIn(pageTips_[static_cast<std::size_t>(i)]));
}

void ConsolePanel::showPage(const QWidget* page) {
  for (int i = 0; i < pages_->count(); ++i)
    if (pages_->widget(i)->isAncestorOf(page)) pages_->setCurrentIndex(i);
}

void ConsolePanel::showNextPage() { pages_->setCurrentIndex((pages_->currentIndex() + 1) % pages_->count()); }

void ConsolePanel::chooseQuality(Quality quality) {
  change([quality](Knobs& k) { k.quality = quality; });
}

}  // namespace ew::ui
