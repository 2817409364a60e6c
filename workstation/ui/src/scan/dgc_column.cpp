#include "scan/dgc_column.h"

#include <QPainter>
#include <QPolygonF>
#include <QPushButton>
#include <QSlider>
#include <QToolTip>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "ew/imaging/effects/gain.h"
#include "ew/widgets/double_click.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"

namespace ew::ui {
namespace {

constexpr int kColumnLeft_px = 8;
constexpr int kSlider_px = 72;
constexpr int kLeastSlider_px = 40;
constexpr int kOffImage_px = 4;
constexpr int kSliderHeight_px = 20;

double handle_px() { return scaled(12.0) + 2.0; }  // with its edge, as the style sheet draws it

}  // namespace

int DgcColumn::wanted_px() { return 2 * kColumnLeft_px + scaled(kSlider_px); }
int DgcColumn::least_px() { return kColumnLeft_px + scaled(kLeastSlider_px) + kOffImage_px; }
int DgcColumn::head_px() { return scaled(20) + 4; }

DgcColumn::DgcColumn(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("dgcColumn"));
  for (int i = 0; i < kDgcSliders; ++i) {
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(QStringLiteral("dgc%1").arg(i + 1));
    setLook(slider, Look::onScan);
    slider->setAccessibleName(tr("TGC %1").arg(i + 1));
    sliders_[static_cast<std::size_t>(i)] = slider;
    connect(slider, &QSlider::valueChanged, this, [this, slider, i](int v) {
      if (showing_) return;  // the column is being told, not telling
      set(i, v);
      if (slider->isSliderDown()) showHeld(slider);
    });
    connect(slider, &QSlider::sliderPressed, this, [this, slider] { showHeld(slider); });
    onDoubleClick(slider, [this, slider] { slider->setValue(scale().neutral); });
  }
  reset_ = new QPushButton(tr("TGC"), this);
  reset_->setObjectName(QStringLiteral("dgcReset"));
  setLook(reset_, Look::flat);
  setLook(reset_, Look::small);
  setLook(reset_, Look::onScan);
  reset_->setFocusPolicy(Qt::TabFocus);
  reset_->setAccessibleName(tr("Reset TGC"));
  reset_->setToolTip(
      tipWithKeys(tr("Time gain compensation: one slider for each eighth of the depth. Click to put all of them back to the middle (%1), "
                     "double-click one for itself"),
                  "tgc.reset"));
  connect(reset_, &QPushButton::clicked, &session_.console(), &ScanConsole::resetTgc);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, &DgcColumn::showKnobs);
  connect(&session_.console(), &ScanConsole::sceneChanged, this, &DgcColumn::showKnobs);
  connect(&session_.console(), &ScanConsole::probeChanged, this, &DgcColumn::showKnobs);
  refreshIcons();
  showKnobs();
}

void DgcColumn::refreshIcons() { reset_->setIcon(icon(QStringLiteral("reset"), scanTheme().quiet)); }

DgcColumn::Scale DgcColumn::scale() const { return isInDecibels() ? Scale{-20, 20, 0, 1.0} : Scale{0, 200, 100, 100.0}; }

const std::array<double, kDgcSliders>& DgcColumn::values() const {
  return isInDecibels() ? session_.console().knobs().tgc_db : session_.console().knobs().dgc;
}

void DgcColumn::set(int slider, int value) {
  Knobs knobs = session_.console().knobs();
  (isInDecibels() ? knobs.tgc_db : knobs.dgc)[static_cast<std::size_t>(slider)] = value / scale().perUnit;
  session_.console().setKnobs(knobs);
}

/// A drag is felt, but how far it went is not.
void DgcColumn::showHeld(QSlider* slider) {
  QToolTip::showText(slider->mapToGlobal(QPoint(slider->width(), -slider->height())), slider->toolTip(), slider);
}

double DgcColumn::xOf(double value) const {
  const Scale on = scale();
  const double share = std::clamp((value * on.perUnit - on.lowest) / (on.highest - on.lowest), 0.0, 1.0);
  return kColumnLeft_px + handle_px() / 2.0 + share * (width_px_ - handle_px());
}

/// All sliders have one width, so that the curve through their handles is straight where they are neutral.
void DgcColumn::place(double top, double bottom, int room_px) {
  top_ = top;
  bottom_ = bottom;
  width_px_ = std::clamp(room_px - kColumnLeft_px - kOffImage_px, scaled(kLeastSlider_px), scaled(kSlider_px));
  reset_->setGeometry(kColumnLeft_px, 0, scaled(kSlider_px), head_px() - 4);
  for (std::size_t i = 0; i < kDgcSliders; ++i) {
    QSlider* slider = sliders_[i];
    const int y = static_cast<int>(std::lround(top_ + (bottom_ - top_) * (static_cast<double>(i) + 0.5) / kDgcSliders)) -
                  scaled(kSliderHeight_px) / 2;
    slider->setGeometry(kColumnLeft_px, y, width_px_, scaled(kSliderHeight_px));
    slider->setVisible(session_.subject() && y >= head_px() && y + scaled(kSliderHeight_px) <= height());
  }
  reset_->setVisible(session_.subject().has_value());
  update();
}

void DgcColumn::showKnobs() {
  showing_ = true;
  const int depth_mm = static_cast<int>(std::lround(session_.console().depth_mm()));
  const Scale on = scale();
  for (int i = 0; i < kDgcSliders; ++i) {
    QSlider* slider = sliders_[static_cast<std::size_t>(i)];
    const double value = values()[static_cast<std::size_t>(i)];
    slider->setRange(on.lowest, on.highest);
    slider->setSingleStep(isInDecibels() ? 1 : 2);
    slider->setPageStep(isInDecibels() ? 3 : 20);
    slider->setValue(static_cast<int>(std::lround(value * on.perUnit)));
    slider->setEnabled(session_.console().scene().gainAndDgc);
    const int from_mm = depth_mm * i / kDgcSliders, to_mm = depth_mm * (i + 1) / kDgcSliders;
    slider->setToolTip(isInDecibels() ? tr("%1 to %2 mm: %3 dB").arg(from_mm).arg(to_mm).arg(signedFigure(value, 0))
                                      : tr("%1 to %2 mm: %3 %").arg(from_mm).arg(to_mm).arg(std::lround(value * on.perUnit)));
  }
  reset_->setEnabled(session_.console().scene().gainAndDgc);
  showing_ = false;
  update();
}

void DgcColumn::paintEvent(QPaintEvent*) {
  if (!session_.subject() || top_ == bottom_) return;
  const Theme theme = scanTheme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(QRect(0, head_px(), width(), height() - head_px()));
  painter.setPen(QPen(theme.edge, 1.0, Qt::DotLine));
  const double neutral = scale().neutral / scale().perUnit;
  constexpr int kPoints = 96;
  const auto curveOf = [&](const auto& valueAt) {
    QPolygonF curve;
    for (int i = 0; i <= kPoints; ++i) {
      const double position = static_cast<double>(i) / kPoints;
      curve << QPointF(xOf(valueAt(position)), top_ + (bottom_ - top_) * position);
    }
    return curve;
  };
  painter.drawPolyline(curveOf([neutral](double) { return neutral; }));
  painter.setPen(QPen(session_.console().scene().gainAndDgc ? theme.accent : theme.line, 1.5));
  painter.drawPolyline(curveOf([this](double position) { return dgcAt(values(), position); }));
}

}  // namespace ew::ui
