#include "panel/measurements_field.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ew/core/foreign_json.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/measurements.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

constexpr double kMostValue = 1e6;

struct KindOfMeasurement {
  const char* kind;
  const char* unit;
};
constexpr std::array<KindOfMeasurement, 4> kKinds = {{{"distance", "mm"}, {"circumference", "mm"}, {"area", "cm2"}, {"angle", "deg"}}};

QString unitWords(const std::string& unit) {
  if (unit == "cm2") return QStringLiteral("cm²");
  return unit == "deg" ? QStringLiteral("°") : QStringLiteral("mm");
}

/// The widget, under the name by which tests and styles find that part of the measurement.
template <class Widget>
Widget* named(Widget* widget, std::size_t number, const char* part) {
  widget->setObjectName(QStringLiteral("measurement_%1_%2").arg(number).arg(QLatin1String(part)));
  return widget;
}

}  // namespace

MeasurementsField::MeasurementsField(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("measurements"));
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(kGrid_px);
  entries_ = new QWidget;
  column_->addWidget(entries_);
  auto* add = new QPushButton(tr("Add a measurement"));
  add->setObjectName(QStringLiteral("addMeasurement"));
  column_->addWidget(add, 0, Qt::AlignLeft);
  connect(add, &QPushButton::clicked, this, [this] {
    nlohmann::json fresh = {{"name", tr("measurement %1").arg(list_.size() + 1).toStdString()}};
    if (!patientKnows_) fresh.update({{"kind", kKinds[0].kind}, {"unit", kKinds[0].unit}, {"value", 0.0}});
    list_.push_back(std::move(fresh));
    remake();
    tell();
    const QString name = QStringLiteral("measurement_%1_name").arg(list_.size() - 1);
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

void MeasurementsField::setValue(const nlohmann::json& list) {
  const nlohmann::json next = list.is_array() ? list : nlohmann::json::array();
  if (next == list_) return;
  list_ = next;
  remake();
}

void MeasurementsField::remake() {
  column_->removeWidget(entries_);
  entries_->hide();
  entries_->setParent(nullptr);
  entries_->deleteLater();
  entries_ = new QWidget;
  auto* rows = new QVBoxLayout(entries_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2 * kGrid_px);
  column_->insertWidget(0, entries_);
  for (std::size_t n = 0; n < list_.size(); ++n) addOne(n);
}

void MeasurementsField::addOne(std::size_t number) {
  auto* grid = new QGridLayout;
  grid->setSpacing(kGrid_px);
  addNameRow(*grid, number);
  addKindRow(*grid, number);
  addValueRows(*grid, number);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  static_cast<QVBoxLayout*>(entries_->layout())->addLayout(grid);
}

void MeasurementsField::addNameRow(QGridLayout& grid, std::size_t number) {
  auto* name = named(new WithHostUndo<QLineEdit>, number, "name");
  name->setAccessibleName(tr("what is measured"));
  name->setPlaceholderText(tr("what is measured"));
  name->setText(words(textAt(list_[number], "name")));
  connect(name, &QLineEdit::textEdited, this, [this, number](const QString& text) { set(number, "name", text.toStdString()); });
  grid.addWidget(name, 0, 0, 1, 2);
  auto* away = named(new QPushButton(tr("Remove")), number, "remove");
  connect(away, &QPushButton::clicked, this, [this, number] {
    list_.erase(number);
    remake();
    tell();
  });
  grid.addWidget(away, 0, 2);
}

void MeasurementsField::addKindRow(QGridLayout& grid, std::size_t number) {
  const nlohmann::json& one = list_[number];
  auto* kind = named(new ChoiceField, number, "kind");
  kind->setFocusPolicy(Qt::StrongFocus);
  kind->setAccessibleName(tr("kind"));
  if (patientKnows_ || !hasValue(one)) kind->addItem(tr("known by the patient"), QString());
  const std::array<QString, 4> names = {tr("distance"), tr("circumference"), tr("area"), tr("angle")};
  for (std::size_t n = 0; n < kKinds.size(); ++n) kind->addItem(names[n], QLatin1String(kKinds[n].kind));
  kind->setCurrentIndex(std::max(0, kind->findData(words(textAt(one, "kind")))));
  connect(kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, number, kind] { setKind(number, kind->currentData().toString().toStdString()); });
  grid.addWidget(kind, 1, 0, 1, 2);
  auto* take = named(new QPushButton(tr("Take caliper")), number, "take");
  take->setToolTip(tr("Take the caliper I have drawn: value, kind and where it stands"));
  connect(take, &QPushButton::clicked, this, [this, number] {
    if (!onTake) return;
    nlohmann::json taken = onTake(list_[number]);
    if (taken.is_null()) return;
    list_[number] = std::move(taken);
    remake();
    tell();
  });
  grid.addWidget(take, 1, 2);
}

void MeasurementsField::addValueRows(QGridLayout& grid, std::size_t number) {
  const nlohmann::json& one = list_[number];
  const QString unit = unitWords(textAt(one, "unit", "mm"));
  auto* value = named(new NumberField(0.0, kMostValue, 2, unit), number, "value");
  value->setAccessibleName(tr("value"));
  value->setValue(numberAt(one, "value").value_or(0.0));
  value->setEnabled(hasValue(one));
  if (!hasValue(one)) value->setToolTip(tr("The value is the virtual patient's; choose a kind to give one"));
  connect(value, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, number](double now) {
    list_[number].erase("points_mm");  // a typed value is no longer what the calipers stand at
    set(number, "value", now);
  });
  grid.addWidget(value, 2, 0);
  auto* tolerance = named(new NumberField(0.0, kMostValue, 2, unit), number, "tolerance");
  tolerance->setAccessibleName(tr("tolerance"));
  tolerance->setPrefix(QStringLiteral("± "));
  tolerance->setSpecialValueText(tr("usual tolerance"));
  tolerance->setValue(numberAt(one, "tolerance").value_or(0.0));
  connect(tolerance, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, number](double now) { set(number, "tolerance", now > 0.0 ? nlohmann::json(now) : nlohmann::json()); });
  grid.addWidget(tolerance, 2, 1, 1, 2);
  auto* reveals = named(new QCheckBox(tr("Gives the finding away")), number, "reveals");
  reveals->setToolTip(tr("A trainee sees the name with the findings only"));
  reveals->setChecked(flagAt(one, "reveals_finding"));
  connect(reveals, &QCheckBox::toggled, this,
          [this, number](bool on) { set(number, "reveals_finding", on ? nlohmann::json(true) : nlohmann::json()); });
  grid.addWidget(reveals, 3, 0, 1, 3);
}

void MeasurementsField::setKind(std::size_t number, const std::string& chosen) {
  nlohmann::json& edited = list_[number];
  for (const char* key : {"points_mm", "kind", "unit"}) edited.erase(key);  // the points are those of another kind of caliper
  const auto known = std::find_if(kKinds.begin(), kKinds.end(), [&](const KindOfMeasurement& each) { return each.kind == chosen; });
  if (known == kKinds.end()) {
    edited.erase("value");
  } else {
    edited["kind"] = known->kind;
    edited["unit"] = known->unit;
    if (!edited.contains("value")) edited["value"] = 0.0;
  }
  remake();
  tell();
}

void MeasurementsField::set(std::size_t number, const char* key, const nlohmann::json& value) {
  if (number >= list_.size()) return;
  if (value.is_null())
    list_[number].erase(key);
  else
    list_[number][key] = value;
  tell();
}

void MeasurementsField::tell() {
  if (onChanged) onChanged(list_.empty() ? nlohmann::json() : list_);
}

}  // namespace ew::case_authoring
