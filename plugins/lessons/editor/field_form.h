#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"

class QFormLayout;
class QLabel;

namespace ew::lessons {

/// Labelled fields one below the other. Each knows how to read its value and how to set it; what refuses the value says so below the field,
/// and the field stays as it was typed.
class FieldForm : public QWidget {
 public:
  template <class Value>
  struct Access {
    std::function<Value()> get;
    std::function<Result<void>(const Value&)> set;
  };
  using TextAccess = Access<QString>;

  explicit FieldForm(QWidget* parent = nullptr);

  /// Every field as its value is now.
  void showValues();

  void addHeading(const QString& text);
  QLabel* addRemark(const QString& text);
  void addWidget(QWidget* widget);
  void addLine(const char* name, const QString& label, const TextAccess& access);
  /// @param placeholder of an empty field
  void addText(const char* name, const QString& label, const TextAccess& access, int lines = 4, const QString& placeholder = {});
  void addFlag(const char* name, const QString& label, const Access<bool>& access, const QString& tip = {});
  /// A number, or none where `noneText` says what that means; none lies below the lowest.
  struct NumberRange {
    double lowest = 0.0, highest = 100.0;
    int decimals = 0;
    QString unit = {};
    QString noneText = {};  ///< empty: there is always a number
    double step = 1.0;
  };
  void addNumber(const char* name, const QString& label, const NumberRange& range, const Access<std::optional<double>>& access);
  /// One of several; one that is set and not among them is shown as such. @param options value and what is shown, now
  using Options = std::vector<std::pair<std::string, QString>>;
  void addChoice(const char* name, const QString& label, std::function<Options()> options, const Access<std::string>& access);

  [[nodiscard]] QFormLayout* rows() const { return rows_; }

 private:
  QLabel* addRow(const QString& label, QWidget* editor);
  void add(std::function<void()> show) { shows_.push_back(std::move(show)); }

  QFormLayout* rows_ = nullptr;
  std::vector<std::function<void()>> shows_;
  std::vector<QLabel*> problems_;
};

}  // namespace ew::lessons
