#pragma once

// Not part of the library ew_sdk: a plugin that includes this has a panel, and so links ew::widgets.

#include <QCoreApplication>
#include <QGridLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "ew/sdk/placement.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"

namespace ew::sdk {

/// Six number fields for a rigid placement. Keeps the numbers as they were typed: a matrix that means the same does not rewrite them.
template <class To, class From>
class PlacementFields final : public QWidget {
 public:
  explicit PlacementFields(QWidget* parent = nullptr) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGrid_px);
    static constexpr std::array<const char*, 6> names = {"x", "y", "z", "rx", "ry", "rz"};
    const std::array<QString, 6> hints = {tr_("Towards the patient's left"), tr_("Towards the back"),      tr_("Towards the head"),
                                          tr_("Turn about the x axis"),      tr_("Turn about the y axis"), tr_("Turn about the z axis")};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const bool length = i < 3;
      const QString unit = length ? QStringLiteral("mm") : QStringLiteral("°");
      auto* field = new NumberField(length ? -1e5 : -360.0, length ? 1e5 : 360.0, 3, unit, this);
      field->setObjectName(QLatin1String("placement_") + QLatin1String(names[i]));
      field->setToolTip(hints[i]);
      field->setAccessibleName(hints[i]);
      auto* name = quietLabel(QLatin1String(names[i]), this);
      name->setWordWrap(false);
      name->setBuddy(field);
      const int row = static_cast<int>(i % 3);
      const int column = length ? 0 : 2;
      grid->addWidget(name, row, column);
      grid->addWidget(field, row, column + 1);
      connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, i](double value) {
        (i < 3 ? shown_.at_mm : shown_.rotation_deg)[static_cast<int>(i % 3)] = value;
        transform_ = transformOf<To, From>(shown_);
        if (onChanged) onChanged(transform_, names[i]);
      });
      fields_[i] = field;
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
  }

  /// The exact matrix: what was set, until a field is edited.
  [[nodiscard]] const Transform<To, From>& transform() const { return transform_; }

  void setTransform(const Transform<To, From>& rigid) {
    double difference = 0.0;
    const auto now = transformOf<To, From>(shown_);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) difference = std::max(difference, std::abs(now.matrix[c][r] - rigid.matrix[c][r]));
    transform_ = rigid;
    if (difference < 1e-9) return;
    shown_ = placementOf(rigid);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const QSignalBlocker quiet(fields_[i]);
      fields_[i]->setValue((i < 3 ? shown_.at_mm : shown_.rotation_deg)[static_cast<int>(i % 3)]);
    }
  }

  /// Called when the user edits a field: "x", "y", "z", "rx", "ry" or "rz". Undo takes back one field, not all that were typed in a row.
  std::function<void(const Transform<To, From>&, const std::string& field)> onChanged;

 private:
  static QString tr_(const char* text) { return QCoreApplication::translate("ew::sdk::PlacementFields", text); }
  std::array<NumberField*, 6> fields_{};
  Placement shown_;
  Transform<To, From> transform_;
};

}  // namespace ew::sdk
