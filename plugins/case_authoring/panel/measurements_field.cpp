#include "panel/measurements_field.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <utility>

#include "ew/widgets/fields.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/measurements.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

constexpr double kMostValue = 1e6;

QString unitWords(const std::string& unit) {
  if (unit == "cm2") return QStringLiteral("cm²");
  return unit == "deg" ? QStringLiteral("°") : QStringLiteral("mm");
}

template <class Widget>
Widget* named(Widget* widget, std::size_t number, const char* part) {
  widget->setObjectName(QStringLiteral("measurement_%1_%2").arg(number).arg(QLatin1String(part)));
  return widget;
}

}  // namespace

MeasurementsField::MeasurementsField(QWidget* parent) : ListField(2 * kGrid_px, parent) {
  setObjectName(QStringLiteral("measurements"));
  auto* add = new QPushButton(tr("Add a measurement"));
  add->setObjectName(QStringLiteral("addMeasurement"));
  column().addWidget(add, 0, Qt::AlignLeft);
  connect(add, &QPushButton::clicked, this, [this] {
    CaseMeasurement fresh;
    fresh.name = tr("measurement %1").arg(list().size() + 1).toStdString();
    if (!patientKnows_) {
      fresh.value = 0.0;
      fresh.kind = kMeasurementKinds[0].kind;
      fresh.unit = kMeasurementKinds[0].unit;
    }
    replace([&](std::vector<CaseMeasurement>& all) { all.push_back(std::move(fresh)); });
    const QString name = QStringLiteral("measurement_%1_name").arg(list().size() - 1);
    if (auto* first = findChild<QLineEdit*>(name)) {
      first->setFocus();
      first->selectAll();
    }
  });
}

void MeasurementsField::setPatientKnows(bool knows) {
  if (knows == patientKnows_) return;
  patientKnows_ = knows;
  remake();
}

void MeasurementsField::addRows(std::size_t number, QVBoxLayout& rows) {
  auto* grid = new QGridLayout;
  grid->setSpacing(kGrid_px);
  addNameRow(*grid, number);
  addKindRow(*grid, number);
  addValueRows(*grid, number);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  rows.addLayout(grid);
}

void MeasurementsField::addNameRow(QGridLayout& grid, std::size_t number) {
  auto* name = named(new WithHostUndo<QLineEdit>, number, "name");
  name->setAccessibleName(tr("what is measured"));
  name->setPlaceholderText(tr("what is measured"));
  name->setText(words(list()[number].name));
  connect(name, &QLineEdit::textEdited, this,
          [this, number](const QString& text) { edit(number, [&](CaseMeasurement& edited) { edited.name = text.toStdString(); }); });
  grid.addWidget(name, 0, 0, 1, 2);
  auto* away = named(new QPushButton(tr("Remove")), number, "remove");
  connect(away, &QPushButton::clicked, this, [this, number] { remove(number); });
  grid.addWidget(away, 0, 2);
}

void MeasurementsField::addKindRow(QGridLayout& grid, std::size_t number) {
  const CaseMeasurement& one = list()[number];
  auto* kind = named(new ChoiceField, number, "kind");
  kind->setFocusPolicy(Qt::StrongFocus);
  kind->setAccessibleName(tr("kind"));
  if (patientKnows_ || !one.value) kind->addItem(tr("known by the patient"), QString());
  const std::array<QString, 4> names = {tr("distance"), tr("circumference"), tr("area"), tr("angle")};
  for (std::size_t n = 0; n < names.size(); ++n) kind->addItem(names[n], words(std::string(kMeasurementKinds[n].kind)));
  kind->setCurrentIndex(std::max(0, kind->findData(words(one.kind))));
  connect(kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, number, kind] { chooseKind(number, kind->currentData().toString().toStdString()); });
  grid.addWidget(kind, 1, 0, 1, 2);
  auto* take = named(new QPushButton(tr("Take caliper")), number, "take");
  take->setToolTip(tr("Take the caliper I have drawn: value, kind and where it stands"));
  connect(take, &QPushButton::clicked, this, [this, number] {
    if (!onTake) return;
    if (auto taken = onTake(list()[number])) replace([&](std::vector<CaseMeasurement>& all) { all[number] = std::move(*taken); });
  });
  grid.addWidget(take, 1, 2);
}

void MeasurementsField::addValueRows(QGridLayout& grid, std::size_t number) {
  const CaseMeasurement& one = list()[number];
  const QString unit = unitWords(one.unit);
  auto* value = named(new NumberField(0.0, kMostValue, 2, unit), number, "value");
  value->setAccessibleName(tr("value"));
  value->setValue(one.value.value_or(0.0));
  value->setEnabled(one.value.has_value());
  if (!one.value) value->setToolTip(tr("The value is the virtual patient's; choose a kind to give one"));
  connect(value, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, number](double now) {
    edit(number, [now](CaseMeasurement& edited) {
      edited.points_mm.clear();  // a typed value is no longer what the calipers stand at
      edited.value = now;
    });
  });
  grid.addWidget(value, 2, 0);
  auto* tolerance = named(new NumberField(0.0, kMostValue, 2, unit), number, "tolerance");
  tolerance->setAccessibleName(tr("tolerance"));
  tolerance->setPrefix(QStringLiteral("± "));
  tolerance->setSpecialValueText(tr("usual tolerance"));
  tolerance->setValue(one.tolerance.value_or(0.0));
  connect(tolerance, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, number](double now) {
    edit(number, [now](CaseMeasurement& edited) { edited.tolerance = now > 0.0 ? std::optional(now) : std::nullopt; });
  });
  grid.addWidget(tolerance, 2, 1, 1, 2);
  auto* reveals = named(new QCheckBox(tr("Gives the finding away")), number, "reveals");
  reveals->setToolTip(tr("A trainee sees the name with the findings only"));
  reveals->setChecked(one.revealsFinding);
  connect(reveals, &QCheckBox::toggled, this,
          [this, number](bool on) { edit(number, [on](CaseMeasurement& edited) { edited.revealsFinding = on; }); });
  grid.addWidget(reveals, 3, 0, 1, 3);
}

void MeasurementsField::chooseKind(std::size_t number, const std::string& kind) {
  if (number >= list().size()) return;
  const auto known =
      std::find_if(kMeasurementKinds.begin(), kMeasurementKinds.end(), [&](const MeasurementKind& each) { return each.kind == kind; });
  const bool isKnown = known != kMeasurementKinds.end();
  replace([&](std::vector<CaseMeasurement>& all) {
    CaseMeasurement& edited = all[number];
    edited.points_mm.clear();  // of another kind of caliper
    edited.kind = isKnown ? known->kind : std::string_view();
    edited.unit = isKnown ? known->unit : std::string_view();
    edited.value = isKnown ? std::optional(edited.value.value_or(0.0)) : std::nullopt;
  });
}

}  // namespace ew::case_authoring
