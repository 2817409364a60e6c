#include "panel/rights_form.h"

#include <QFormLayout>
#include <QLineEdit>

#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"

namespace ew::case_authoring {

RightsForm::RightsForm(QWidget* parent) : QWidget(parent) {
  form_ = new QFormLayout(this);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setHorizontalSpacing(2 * kGrid_px);
  form_->setVerticalSpacing(kGrid_px);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->addRow(headingLabel(tr("Recording")));
  form_->addRow(quietLabel(tr("Whom to name, and under which licence it may be passed on. Needed before the case is published.")));
  attribution_ = new QLineEdit;
  attribution_->setObjectName(QStringLiteral("sourceAttribution"));
  attribution_->setMaxLength(1000);
  form_->addRow(tr("Attribution"), attribution_);
  licence_ = new QLineEdit;
  licence_->setObjectName(QStringLiteral("sourceLicence"));
  licence_->setMaxLength(200);
  licence_->setPlaceholderText(QStringLiteral("CC BY 4.0"));
  form_->addRow(tr("Licence"), licence_);
}

RecordingRights RightsForm::rights() const {
  return {attribution_->text().trimmed().toStdString(), licence_->text().trimmed().toStdString()};
}

}  // namespace ew::case_authoring
