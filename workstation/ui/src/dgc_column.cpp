#include "dgc_column.h"

#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ew/imaging/effects/gain.h"
#include "icons.h"
#include "theme.h"

namespace ew::ui {
namespace {

constexpr int kHighest_percent = 200;
constexpr int kColumnLeft_px = 8;
constexpr int kSlider_px = 72;
constexpr int kSliderHeight_px = 20;
constexpr int kHandle_px = 14;  // with its edge, as the style sheet draws it

}  // namespace

DgcColumn::DgcColumn(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("dgcColumn"));
  for (int i = 0; i < kDgcSliders; ++i) {
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(QStringLiteral("dgc%1").arg(i + 1));
    slider->setProperty("onScan", true);
    slider->setRange(0, kHighest_percent);
    slider->setSingleStep(2);
    slider->setPageStep(20);
    slider->setAccessibleName(tr("TGC %1").arg(i + 1));
    sliders_[static_cast<std::size_t>(i)] = slider;
    connect(slider, &QSlider::valueChanged, this, [this, i](int v) {
      if (showing_) return;  // the column is being told, not telling
      Knobs knobs = session_.knobs();
      knobs.dgc[static_cast<std::size_t>(i)] = v / 100.0;
      session_.setKnobs(knobs);
    });
  }
  reset_ = new QPushButton(tr("TGC"), this);
  reset_->setObjectName(QStringLiteral("dgcReset"));
  reset_->setProperty("flat", true);
  reset_->setProperty("small", true);
  reset_->setProperty("onScan", true);
  reset_->setFocusPolicy(Qt::TabFocus);
  reset_->setAccessibleName(tr("Reset TGC"));
  reset_->setToolTip(
      tr("Depth gain compensation: one slider for each eighth of the depth. Click to put all of them back to the middle (Ctrl+0)"));
  connect(reset_, &QPushButton::clicked, this, [this] {
    Knobs knobs = session_.knobs();
    knobs.dgc = Knobs{}.dgc;
    session_.setKnobs(knobs);
  });
  connect(&session_, &Session::knobsChanged, this, &DgcColumn::showKnobs);
  connect(&session_, &Session::sceneChanged, this, &DgcColumn::showKnobs);
  connect(&session_, &Session::probeChanged, this, &DgcColumn::showKnobs);
  refreshIcons();
  showKnobs();
}

void DgcColumn::refreshIcons() { reset_->setIcon(icon(QStringLiteral("reset"), scanTheme().quiet)); }

double DgcColumn::xOf(double factor) const {
  const double share = std::clamp(factor * 100.0 / kHighest_percent, 0.0, 1.0);
  return kColumnLeft_px + kHandle_px / 2.0 + share * (kSlider_px - kHandle_px);
}

void DgcColumn::place(double top, double bottom) {
  top_ = top;
  bottom_ = bottom;
  reset_->setGeometry(kColumnLeft_px, 0, kSlider_px, kHead_px - 4);
  for (int i = 0; i < kDgcSliders; ++i) {
    QSlider* slider = sliders_[static_cast<std::size_t>(i)];
    const int y = static_cast<int>(std::lround(top_ + (bottom_ - top_) * (i + 0.5) / kDgcSliders)) - kSliderHeight_px / 2;
    slider->setGeometry(kColumnLeft_px, y, kSlider_px, kSliderHeight_px);
    slider->setVisible(session_.subject() && y >= kHead_px && y + kSliderHeight_px <= height());
  }
  reset_->setVisible(session_.subject().has_value());
  update();
}

void DgcColumn::showKnobs() {
  showing_ = true;
  const int depth_mm = static_cast<int>(std::lround(session_.depth_mm()));
  const Knobs& knobs = session_.knobs();
  for (int i = 0; i < kDgcSliders; ++i) {
    QSlider* slider = sliders_[static_cast<std::size_t>(i)];
    const int percent = static_cast<int>(std::lround(knobs.dgc[static_cast<std::size_t>(i)] * 100.0));
    slider->setValue(percent);
    slider->setEnabled(session_.scene().gainAndDgc);
    slider->setToolTip(tr("%1 to %2 mm: %3 %").arg(depth_mm * i / kDgcSliders).arg(depth_mm * (i + 1) / kDgcSliders).arg(percent));
  }
  reset_->setEnabled(session_.scene().gainAndDgc);
  showing_ = false;
  update();
}

void DgcColumn::paintEvent(QPaintEvent*) {
  if (!session_.subject() || top_ == bottom_) return;
  const Theme theme = scanTheme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(QRect(0, kHead_px, width(), height() - kHead_px));
  painter.setPen(QPen(theme.line, 1.0, Qt::DotLine));
  painter.drawLine(QPointF(xOf(1.0), top_), QPointF(xOf(1.0), bottom_));
  QPainterPath curve;
  constexpr int kPoints = 96;
  for (int i = 0; i <= kPoints; ++i) {
    const double position = static_cast<double>(i) / kPoints;
    const QPointF at(xOf(dgcAt(session_.knobs().dgc, position)), top_ + (bottom_ - top_) * position);
    if (i == 0) {
      curve.moveTo(at);
    } else {
      curve.lineTo(at);
    }
  }
  painter.setPen(QPen(session_.scene().gainAndDgc ? theme.accent : theme.line, 1.5));
  painter.drawPath(curve);
}

}  // namespace ew::ui
