#include "console_panel.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "figures.h"
#include "icons.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kDgcHighest_percent = 200;
constexpr int kGainHighest_percent = 300;
constexpr int kZoomSteps = 10;  // of the slider per factor 1

QSlider* slider(const QString& objectName, int lowest, int highest, int step, int page) {
  auto* made = new QSlider(Qt::Horizontal);
  made->setObjectName(objectName);
  made->setRange(lowest, highest);
  made->setSingleStep(step);
  made->setPageStep(page);
  made->setFixedHeight(24);
  made->setMinimumWidth(96);
  return made;
}

}  // namespace

ConsolePanel::ConsolePanel(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("console"));
  setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 12, 16, 16);
  rows->setSpacing(0);
  addDgc();
  rows->addSpacing(8);
  gain_ = addRow(tr("Gain"), QStringLiteral("gain"), QStringLiteral("300 %"), tr("Overall gain (Ctrl+Up, Ctrl+Down)"));
  gain_.slider->setRange(0, kGainHighest_percent);
  gain_.slider->setPageStep(25);
  depth_ = addRow(tr("Depth"), QStringLiteral("depth"), QStringLiteral("300 mm"), tr("Depth of the picture (Page Up, Page Down)"));
  focus_ = addRow(tr("Focus"), QStringLiteral("focus"), QStringLiteral("300 mm"), tr("Depth of the focus mark"));
  zoom_ = addRow(tr("Zoom"), QStringLiteral("zoom"), QStringLiteral("8.0 x"), tr("Magnify about the middle of the picture (Z, Shift+Z)"));
  zoom_.slider->setRange(kZoomSteps, 8 * kZoomSteps);
  zoom_.slider->setPageStep(kZoomSteps / 2);
  rows->addSpacing(8);
  addChoices();
  rows->addStretch(1);

  connect(gain_.slider, &QSlider::valueChanged, this, [this](int v) { change([v](Knobs& k) { k.gain = v / 100.0; }); });
  connect(depth_.slider, &QSlider::valueChanged, this, [this](int v) { change([v](Knobs& k) { k.depth_mm = v; }); });
  connect(focus_.slider, &QSlider::valueChanged, this, [this](int v) { change([v](Knobs& k) { k.focus_mm = v; }); });
  connect(zoom_.slider, &QSlider::valueChanged, this,
          [this](int v) { change([v](Knobs& k) { k.zoom = static_cast<double>(v) / kZoomSteps; }); });
  connect(&session_, &Session::knobsChanged, this, &ConsolePanel::showKnobs);
  connect(&session_, &Session::probeChanged, this, &ConsolePanel::showProbes);
  connect(&session_, &Session::frozenChanged, freeze_, &QPushButton::setChecked);
  showProbes();
  showKnobs();
}

template <class Change>
void ConsolePanel::change(Change&& apply) {
  if (showing_) return;  // the panel is being told, not telling
  Knobs knobs = session_.knobs();
  apply(knobs);
  session_.setKnobs(knobs);
}

ConsolePanel::Row ConsolePanel::addRow(const QString& name, const QString& objectName, const QString& widest, const QString& tip) {
  auto* line = new QHBoxLayout;
  auto* label = new QLabel(name);
  label->setProperty("quiet", true);
  Row row;
  row.value = new FigureLabel(widest);
  row.value->setObjectName(objectName + QStringLiteral("Value"));
  row.slider = slider(objectName, 0, 100, 1, 10);
  row.slider->setToolTip(tip);
  row.slider->setAccessibleName(name);
  label->setBuddy(row.slider);
  line->addWidget(label);
  line->addStretch(1);
  line->addWidget(row.value);
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->addLayout(line);
  rows->addWidget(row.slider);
  return row;
}

void ConsolePanel::addDgc() {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  auto* head = new QHBoxLayout;
  auto* name = new QLabel(tr("DGC"));
  name->setProperty("quiet", true);
  name->setToolTip(tr("Depth gain compensation: one slider for each eighth of the depth, near on top"));
  reset_ = new QPushButton(tr("Reset"));
  reset_->setObjectName(QStringLiteral("dgcReset"));
  reset_->setProperty("flat", true);
  reset_->setToolTip(tr("All eight sliders back to the middle (Ctrl+0)"));
  head->addWidget(name);
  head->addStretch(1);
  head->addWidget(reset_);
  rows->addLayout(head);
  rows->addSpacing(4);
  for (int i = 0; i < kDgcSliders; ++i) {
    QSlider* one = slider(QStringLiteral("dgc%1").arg(i + 1), 0, kDgcHighest_percent, 2, 20);
    one->setAccessibleName(tr("DGC %1").arg(i + 1));
    dgc_[static_cast<std::size_t>(i)] = one;
    rows->addWidget(one);
    connect(one, &QSlider::valueChanged, this,
            [this, i](int v) { change([v, i](Knobs& k) { k.dgc[static_cast<std::size_t>(i)] = v / 100.0; }); });
  }
  connect(reset_, &QPushButton::clicked, this, &ConsolePanel::resetDgc);
}

void ConsolePanel::addChoices() {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  auto* qualityName = new QLabel(tr("Quality"));
  qualityName->setProperty("quiet", true);
  rows->addWidget(qualityName);
  rows->addSpacing(4);
  weave_ = new QPushButton(tr("Weave"));
  linear_ = new QPushButton(tr("Linear"));
  weave_->setObjectName(QStringLiteral("qualityWeave"));
  linear_->setObjectName(QStringLiteral("qualityLinear"));
  weave_->setToolTip(tr("Nearest voxels, fastest (1)"));
  linear_->setToolTip(tr("Interpolated between eight voxels (2)"));
  weave_->setProperty("segment", QStringLiteral("first"));
  linear_->setProperty("segment", QStringLiteral("last"));
  auto* exclusive = new QButtonGroup(this);
  auto* quality = new QHBoxLayout;
  quality->setSpacing(0);
  for (QPushButton* button : {weave_, linear_}) {
    button->setCheckable(true);
    exclusive->addButton(button);
    quality->addWidget(button, 1);
  }
  rows->addLayout(quality);
  rows->addSpacing(12);

  probe_ = new QComboBox;
  probe_->setObjectName(QStringLiteral("probe"));
  probe_->setToolTip(tr("Transducer"));
  probe_->setAccessibleName(tr("Transducer"));
  probe_->setMinimumContentsLength(8);
  probe_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rows->addWidget(probe_);
  rows->addSpacing(12);

  flip_ = new QPushButton(tr("Flip"));
  flip_->setObjectName(QStringLiteral("flip"));
  flip_->setCheckable(true);
  freeze_ = new QPushButton(tr("Freeze"));
  freeze_->setObjectName(QStringLiteral("freeze"));
  freeze_->setCheckable(true);
  freeze_->setToolTip(tr("Keep the picture (Space or F)"));
  for (QPushButton* button : {flip_, freeze_}) button->setProperty("compact", true);  // two long words side by side in some languages
  auto* last = new QHBoxLayout;
  last->setSpacing(8);
  last->addWidget(flip_, 1);
  last->addWidget(freeze_, 1);
  rows->addLayout(last);
  // A click must not take the arrow keys away from the probe.
  for (QPushButton* button : {reset_, weave_, linear_, flip_, freeze_}) button->setFocusPolicy(Qt::TabFocus);
  refreshIcons();

  connect(weave_, &QPushButton::clicked, this, [this] { chooseQuality(Quality::weave); });
  connect(linear_, &QPushButton::clicked, this, [this] { chooseQuality(Quality::linear); });
  connect(flip_, &QPushButton::toggled, this, [this](bool on) { change([on](Knobs& k) { k.markerLeft = !on; }); });
  connect(freeze_, &QPushButton::toggled, &session_, &Session::setFrozen);
  connect(probe_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { session_.chooseProbe(probe_->itemData(index).toString().toStdString()); });
}

void ConsolePanel::refreshIcons() {
  flip_->setIcon(icon(QStringLiteral("flip")));
  freeze_->setIcon(icon(QStringLiteral("freeze")));
}

void ConsolePanel::showProbes() {
  const QSignalBlocker quiet(probe_);
  probe_->clear();
  for (const Probe& probe : session_.probes()) {
    probe_->addItem(words(probe.name), words(probe.id));
    probe_->setItemData(probe_->count() - 1, words(probe.name), Qt::ToolTipRole);
    if (probe == session_.probe()) probe_->setCurrentIndex(probe_->count() - 1);
  }
  probe_->setToolTip(tr("Transducer: %1").arg(probe_->currentText()));
}

void ConsolePanel::showKnobs() {
  showing_ = true;
  const Knobs& knobs = session_.knobs();
  const Probe& probe = session_.probe();
  const int depth_mm = static_cast<int>(std::lround(session_.depth_mm()));
  for (std::size_t i = 0; i < dgc_.size(); ++i) {
    const int percent = static_cast<int>(std::lround(knobs.dgc[i] * 100.0));
    dgc_[i]->setValue(percent);
    const int n = static_cast<int>(i);
    dgc_[i]->setToolTip(tr("%1 to %2 mm: %3 %").arg(depth_mm * n / kDgcSliders).arg(depth_mm * (n + 1) / kDgcSliders).arg(percent));
  }
  gain_.slider->setValue(static_cast<int>(std::lround(knobs.gain * 100.0)));
  gain_.value->setText(tr("%1 %").arg(gain_.slider->value()));
  depth_.slider->setRange(static_cast<int>(std::ceil(probe.minDepth_mm)), static_cast<int>(probe.maxDepth_mm));
  depth_.slider->setPageStep(10);
  depth_.slider->setValue(depth_mm);
  depth_.value->setText(tr("%1 mm").arg(depth_mm));
  focus_.slider->setRange(5, depth_mm);
  focus_.slider->setPageStep(10);
  focus_.slider->setValue(static_cast<int>(std::lround(session_.focus_mm())));
  focus_.value->setText(tr("%1 mm").arg(focus_.slider->value()));
  zoom_.slider->setValue(static_cast<int>(std::lround(knobs.zoom * kZoomSteps)));
  zoom_.value->setText(tr("%1 x").arg(knobs.zoom, 0, 'f', 1));
  weave_->setChecked(knobs.quality == Quality::weave);
  linear_->setChecked(knobs.quality == Quality::linear);
  flip_->setChecked(!knobs.markerLeft);
  flip_->setToolTip(knobs.markerLeft ? tr("The marker is at the left, as usual; put it at the right (X)")
                                     : tr("The marker is at the right; put it at the left, as usual (X)"));
  showing_ = false;
}

void ConsolePanel::stepDepth(int steps) { depth_.slider->setValue(depth_.slider->value() + 10 * steps); }
void ConsolePanel::stepGain(int steps) { gain_.slider->setValue(gain_.slider->value() + 5 * steps); }
void ConsolePanel::stepZoom(int steps) { zoom_.slider->setValue(zoom_.slider->value() + steps * kZoomSteps / 2); }
void ConsolePanel::chooseQuality(Quality quality) {
  change([quality](Knobs& k) { k.quality = quality; });
}
void ConsolePanel::flip() { flip_->toggle(); }
void ConsolePanel::resetDgc() {
  change([](Knobs& k) { k.dgc = Knobs{}.dgc; });
}

}  // namespace ew::ui
