#pragma once

#include <QWidget>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/case_values.h"

class QGridLayout;
class QVBoxLayout;

namespace ew::case_authoring {

/// What a trainee is to measure: name, kind, value, tolerance, whether the name gives the finding away. Fields that it does not show stay
/// as they are.
class MeasurementsField final : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurementsField(QWidget* parent = nullptr);

  /// Whether a virtual patient may know values: else every measurement has its own.
  void setPatientKnows(bool knows);
  void setValue(const std::vector<CaseMeasurement>& list);
  std::function<void(const std::vector<CaseMeasurement>& list)> onChanged;  ///< called when the user edits
  /// What the calipers in the image say, as the measurement of that number; empty: it was said why not.
  std::function<std::optional<CaseMeasurement>(const CaseMeasurement& expected)> onTake;

 private:
  void remake();
  void addOne(std::size_t number);
  void addNameRow(QGridLayout& grid, std::size_t number);
  void addKindRow(QGridLayout& grid, std::size_t number);
  void addValueRows(QGridLayout& grid, std::size_t number);
  void tell();
  void chooseKind(std::size_t number, const std::string& kind);
  void edit(std::size_t number, const std::function<void(CaseMeasurement&)>& change);

  std::vector<CaseMeasurement> list_;
  bool patientKnows_ = false;
  QVBoxLayout* column_ = nullptr;
  QWidget* entries_ = nullptr;
};

}  // namespace ew::case_authoring
