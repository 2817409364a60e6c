#include "panel/place_pages.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include "ew/assessment/plane_error.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/targets.h"
#include "panel/target_drawer.h"

namespace ew::case_authoring {
namespace {

QString shownNumber(double value, int decimals = 1) { return QLocale().toString(value, 'f', decimals); }

QFormLayout* targetForm(QWidget* owner) {
  auto* form = new QFormLayout(owner);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kGrid_px);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  return form;
}

}  // namespace

Transform<frame::File, frame::Probe> planeInFile(const Case& shown, const ScanState& image) {
  return rigidInverse(shown.volume.fileToWorld) * image.pose.probeToWorld;
}

PointPage::PointPage(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* form = targetForm(this);
  where_ = quietLabel({});
  where_->setObjectName(QStringLiteral("pointWhere"));
  form->addRow(where_);
  click_ = new QPushButton(tr("Click in the scan"));
  click_->setObjectName(QStringLiteral("pointClick"));
  click_->setCheckable(true);
  click_->setToolTip(tr("The next clicks into the image put the point there"));
  connect(click_, &QPushButton::clicked, this, &PointPage::ask);
  form->addRow(click_);
  tolerance_ = new NumberField(0.1, 200.0, 1, tr("mm"));
  tolerance_->setObjectName(QStringLiteral("pointTolerance"));
  tolerance_->setAccessibleName(tr("Near enough"));
  connect(tolerance_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double mm) {
    change(tr("Change the tolerance"), "tolerance_mm", [mm](Case edited, std::size_t n) {
      return withTarget(std::move(edited), n, [mm](CaseTarget& target) { target.tolerance_mm = mm; });
    });
  });
  form->addRow(quietLabel(tr("Near enough")), tolerance_);
}

void PointPage::setTarget(const CaseTarget& target) {
  const QSignalBlocker quiet(tolerance_);
  tolerance_->setValue(target.tolerance_mm.value_or(10.0));
  const auto& at_mm = target.at_mm;
  where_->setText(at_mm ? tr("At %1, %2, %3 mm of the volume").arg(shownNumber(at_mm->x), shownNumber(at_mm->y), shownNumber(at_mm->z))
                        : tr("It lies nowhere yet: click it in the scan."));
}

void PointPage::rest() {
  asking_.reset();
  click_->setChecked(false);
}

void PointPage::ask(bool on) {
  if (!on) return rest();
  asking_ = host_.scan().askForPoint(
      tr("Click the point. Arrows and Enter do the same, Escape ends.").toStdString(),
      [this](const Point<frame::Probe>& at) {
        const auto image = host_.scan().state();
        if (!image) return;
        change(tr("Move the point"), "at_mm", [&](Case edited, std::size_t n) {
          const glm::dvec3 at_mm = carried(planeInFile(edited, *image), at.at);
          return withTarget(std::move(edited), n, [&](CaseTarget& target) { target.at_mm = at_mm; });
        });
      },
      [this] { rest(); });
  click_->setChecked(asking_ != nullptr);
}

PlanePage::PlanePage(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* form = targetForm(this);
  away_ = quietLabel({});
  away_->setObjectName(QStringLiteral("planeAway"));
  form->addRow(away_);
  auto* take = new QPushButton(tr("Use the present image plane"));
  take->setObjectName(QStringLiteral("planeTake"));
  take->setToolTip(tr("The plane becomes the one that the probe images now"));
  connect(take, &QPushButton::clicked, this, [this] {
    const auto scan = host_.cases().scan();
    const auto image = host_.scan().state();
    if (!scan || !image)
      return onSaid(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
    onSaid({});
    change(tr("Take the plane"), "plane taken", [&](Case edited, std::size_t n) {
      const auto plane = planeInFile(edited, *image);
      return withTarget(std::move(edited), n, [&](CaseTarget& target) { target.probeToFile = plane; });
    });
  });
  form->addRow(take);
  go_ = new QPushButton(tr("Go there"));
  go_->setObjectName(QStringLiteral("planeGo"));
  go_->setToolTip(tr("Put the probe where the plane was taken"));
  connect(go_, &QPushButton::clicked, this, [this] {
    if (!target_.probeToFile) return;
    const auto placed = host_.scan().placeProbe(fileToWorld_ * *target_.probeToFile);
    onSaid(placed ? QString() : words(placed.error().message));
  });
  form->addRow(go_);
  position_ =
      addTolerance(form, tr("Place within"), &CaseTarget::positionTolerance_mm, "position_tolerance_mm", 200.0, tr("mm"), "planePosition");
  angle_ = addTolerance(form, tr("Tilted at most"), &CaseTarget::angleTolerance_deg, "angle_tolerance_deg", 180.0, tr("°"), "planeAngle");
}

QDoubleSpinBox* PlanePage::addTolerance(QFormLayout* form, const QString& text, std::optional<double> CaseTarget::*tolerance,
                                        const char* key, double highest, const QString& unit, const char* name) {
  auto* field = new NumberField(0.1, highest, 1, unit);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(text);
  connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, tolerance, key](double value) {
    change(tr("Change the tolerance"), key, [tolerance, value](Case edited, std::size_t n) {
      return withTarget(std::move(edited), n, [&](CaseTarget& target) { target.*tolerance = value; });
    });
  });
  form->addRow(quietLabel(text), field);
  return field;
}

void PlanePage::setTarget(const Case& shown, const CaseTarget& target) {
  fileToWorld_ = shown.volume.fileToWorld;
  target_ = target;
  const QSignalBlocker quietPosition(position_), quietAngle(angle_);
  position_->setValue(target.positionTolerance_mm.value_or(5.0));
  angle_->setValue(target.angleTolerance_deg.value_or(10.0));
  const bool isOwn = target.probeToFile.has_value();
  go_->setEnabled(isOwn);
  go_->setToolTip(isOwn ? tr("Put the probe where the plane was taken")
                        : tr("The patient's own plane of this name is kept by the patient"));
  if (!isOwn) away_->setText(tr("The standard plane of that name, as the patient has it."));
  if (const auto image = host_.scan().state()) see(*image);
}

void PlanePage::see(const ScanState& image) {
  if (!target_.probeToFile) return;
  const PlaneTolerance tolerance{position_->value(), angle_->value()};
  // Judged where the middle of the image is, as it is for a trainee.
  const auto error = planeError({fileToWorld_ * *target_.probeToFile, {0.0, 0.5 * seenSize_mm(image).y}}, image.pose.probeToWorld);
  const QString figures = tr("%1 mm and %2° away").arg(shownNumber(error.distance_mm), shownNumber(error.angle_deg, 0));
  away_->setText(isFound(error, tolerance) ? tr("%1: within the tolerance").arg(figures) : figures);
}

}  // namespace ew::case_authoring
