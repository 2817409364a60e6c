#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ew/library/case_values.h"
#include "panel/list_field.h"

class QGridLayout;

namespace ew::case_authoring {

/// What a trainee is to measure: name, kind, value, tolerance, whether the name gives the finding away.
class MeasurementsField final : public ListField<CaseMeasurement> {
  Q_OBJECT

 public:
  explicit MeasurementsField(QWidget* parent = nullptr);

  /// Whether a virtual patient may know values: else every measurement has its own.
  void setPatientKnows(bool knows);
  /// What the calipers in the image say, as the measurement of that number; empty: it was said why not.
  std::function<std::optional<CaseMeasurement>(const CaseMeasurement& expected)> onTake;

 private:
  void addRows(std::size_t number, QVBoxLayout& rows) override;
  void addNameRow(QGridLayout& grid, std::size_t number);
  void addKindRow(QGridLayout& grid, std::size_t number);
  void addValueRows(QGridLayout& grid, std::size_t number);
  void chooseKind(std::size_t number, const std::string& kind);

  bool patientKnows_ = false;
};

}  // namespace ew::case_authoring
