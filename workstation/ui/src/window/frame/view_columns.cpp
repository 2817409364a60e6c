#include "window/frame/view_columns.h"

#include <QEvent>
#include <QMouseEvent>
#include <QSettings>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "case/case_info.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

const auto kWideSetting = QStringLiteral("bodyShare");
const auto kNarrowSetting = QStringLiteral("bodyShareNarrow");
constexpr double kNarrowShare = 0.3;
constexpr int kLeastBody_px = 240;  // of the 3D view, whatever words stand below it

}  // namespace

BodyColumn::BodyColumn(QWidget* view3d, CaseInfo* info, QWidget* parent) : QWidget(parent), view3d_(view3d), info_(info) {
  setObjectName(QStringLiteral("bodyColumn"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(view3d_, 1);
  rows->addWidget(info_);
  connect(info_, &CaseInfo::opened, this, &BodyColumn::arrange);
  connect(info_, &CaseInfo::contentsChanged, this, &BodyColumn::arrange);
}

void BodyColumn::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void BodyColumn::arrange() {
  if (info_->isHidden()) return;
  const int most_px = std::max(info_->headHeight_px(), std::min(height() / 2, height() - kLeastBody_px));
  info_->setFixedHeight(std::min(info_->wantedHeight_px(), most_px));
}

ViewColumns::ViewColumns(QSplitter& columns, QWidget& panel, QWidget& body, QWidget& scan, QWidget& canvas, QObject* parent)
    : QObject(parent), columns_(columns), panel_(panel), body_(body), scan_(scan), canvas_(canvas) {
  columns_.installEventFilter(this);
  canvas_.installEventFilter(this);
  connect(&columns_, &QSplitter::splitterMoved, this, [this] {
    if (staged_) return;
    if (!panel_.isHidden()) panel_px_ = panel_.width();
    if (body_px_ > 0 && !swapped_) {
      if (!body_.isHidden()) panel_px_ = body_.width();
      body_px_ = panel_px_;
      return;
    }
    if (!hasBoth()) return;
    const int both_px = body_.width() + scan_.width();
    if (both_px <= 0) return;
    const double share = static_cast<double>(body_.width()) / both_px;
    QSettings().setValue(isNarrow() ? kNarrowSetting : kWideSetting, swapped_ ? 1.0 - share : share);
  });
}

void ViewColumns::watch(QWidget& view) { view.installEventFilter(this); }

bool ViewColumns::isNarrow() const { return columns_.window()->width() < scaled(kNarrow_px); }

double ViewColumns::share() const {
  const double kept =
      isNarrow() ? QSettings().value(kNarrowSetting, kNarrowShare).toDouble() : QSettings().value(kWideSetting, kBodyShare).toDouble();
  const double share = kept > 0.05 && kept < 0.95 ? kept : kBodyShare;  // a damaged file compares false
  return swapped_ && isNarrow() ? 1.0 - share : share;
}

bool ViewColumns::hasBoth() const { return showsScan_ && !scanOnly_ && !staged_ && !body_.isHidden(); }

void ViewColumns::follow(const WindowLayout& layout, bool showsScan, bool isStaged) {
  // What the user has made of a width stays until the layout wants another one.
  if (layout.panel_px != layout_.panel_px || isStaged != staged_) panel_px_ = layout.panel_px;
  if (layout.body_px != layout_.body_px || layout.panel_px != layout_.panel_px) body_px_ = layout.body_px;
  layout_ = layout;
  showsScan_ = showsScan;
  staged_ = isStaged;
  arrange();
}

void ViewColumns::swap() {
  swapped_ = !swapped_;
  arrange();
}

void ViewColumns::arrange() {
  const int panel_px = panel_.isHidden() ? 0 : panel_px_;
  const int rest_px = std::max(0, columns_.width() - panel_px);
  if (staged_) return columns_.setSizes({panel_px, 0, 0, rest_px});
  if (!showsScan_) return columns_.setSizes({panel_px, body_.isHidden() ? 0 : rest_px, 0, 0});
  const bool isSwapped = swapped_ && isNarrow();
  const int body_px = body_.isHidden()             ? 0
                      : body_px_ > 0 && !isSwapped ? std::min(body_px_, rest_px)
                                                   : static_cast<int>(std::lround(share() * rest_px));
  columns_.setSizes({panel_px, body_px, rest_px - body_px, 0});
}

bool ViewColumns::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &columns_) {
    // After the splitter has shared the new width in its own way.
    if (event->type() == QEvent::Resize) QMetaObject::invokeMethod(this, &ViewColumns::arrange, Qt::QueuedConnection);
    return false;
  }
  const bool isLeft = (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) &&
                      static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton &&
                      static_cast<QMouseEvent*>(event)->modifiers() == Qt::NoModifier;
  if (!isLeft || !isNarrow() || !hasBoth()) return false;
  if (event->type() == QEvent::MouseButtonPress) {
    if (onPress) onPress();
    return false;
  }
  if (takeBackPress) takeBackPress();
  swap();
  return true;
}

}  // namespace ew::ui
