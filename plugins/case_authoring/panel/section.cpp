#include "panel/section.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::case_authoring {
namespace {

QString settingOf(const QString& id) { return QStringLiteral("casePanel/closed/") + id; }

}  // namespace

Section::Section(const QString& id, const QString& title, QWidget* parent) : QWidget(parent), id_(id) {
  setObjectName(QStringLiteral("section_") + id);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  head_ = new QToolButton;
  head_->setObjectName(QStringLiteral("head_") + id);
  head_->setText(title);
  setLook(head_, Look::heading);
  head_->setCheckable(true);
  head_->setAutoRaise(true);
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  head_->setFocusPolicy(Qt::StrongFocus);
  row->addWidget(head_);
  row->addStretch(1);
  mark_ = new QLabel;
  mark_->setObjectName(QStringLiteral("missing_") + id);
  mark_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
  row->addWidget(mark_);
  column->addLayout(row);
  body_ = new QWidget;
  form_ = new QFormLayout(body_);
  form_->setContentsMargins(0, 0, 0, kGrid_px);
  form_->setSpacing(kGrid_px);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  column->addWidget(body_);
  connect(head_, &QToolButton::toggled, this, [this](bool open) {
    QSettings().setValue(settingOf(id_), !open);
    setOpen(open);
    Q_EMIT toggled();
  });
  setOpen(!QSettings().value(settingOf(id)).toBool());
}

void Section::setOpen(bool open) {
  const QSignalBlocker quiet(head_);
  head_->setChecked(open);
  head_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(open);
}

void Section::setMissing(const QStringList& names, bool isNeeded) {
  mark_->setVisible(isNeeded);
  const bool isComplete = names.isEmpty();
  mark_->setForegroundRole(isComplete ? QPalette::WindowText : QPalette::BrightText);
  setLook(mark_, Look::quiet, isComplete);
  mark_->setText(isComplete ? tr("complete") : names.size() == 1 ? tr("1 missing") : tr("%1 missing").arg(names.size()));
  mark_->updateGeometry();
  mark_->setToolTip(isComplete ? QString() : tr("Before the case can be published: %1").arg(names.join(QStringLiteral(", "))));
}

}  // namespace ew::case_authoring
