#pragma once

#include <QWidget>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

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
  void setValue(const nlohmann::json& list);                  ///< an array of objects, or null
  std::function<void(const nlohmann::json& list)> onChanged;  ///< called when the user edits; null: none are left
  /// What the calipers in the image say, as the measurement of that number; null: it was said why not.
  std::function<nlohmann::json(const nlohmann::json& expected)> onTake;

 private:
  void remake();
  void addOne(std::size_t number);
  void addNameRow(QGridLayout& grid, std::size_t number);
  void addKindRow(QGridLayout& grid, std::size_t number);
  void addValueRows(QGridLayout& grid, std::size_t number);
  void setKind(std::size_t number, const std::string& chosen);
  void tell();
  void set(std::size_t number, const char* key, const nlohmann::json& value);

  nlohmann::json list_ = nlohmann::json::array();
  bool patientKnows_ = false;
  QVBoxLayout* column_ = nullptr;
  QWidget* entries_ = nullptr;
};

}  // namespace ew::case_authoring
