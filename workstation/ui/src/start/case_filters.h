#pragma once

#include <QWidget>

#include "ew/library/index.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ew::ui {

/// By what the list of cases is narrowed beside words: where from, region, level, tag, with lessons. Filters with nothing to choose are not
/// there.
class CaseFilters final : public QWidget {
  Q_OBJECT

 public:
  explicit CaseFilters(QWidget* parent = nullptr);
  /// What is chosen stays chosen, also when no case has it any more.
  void setChoices(const CaseChoices& choices);
  /// Puts what is chosen into a query.
  void fill(CaseQuery& query) const;
  [[nodiscard]] bool isNarrowing() const;
  /// Chooses everything.
  void clear();
  void setCount(const QString& words);
  void setClearable(bool clearable);
  /// From the first to the last in the order of the tab key.
  [[nodiscard]] std::vector<QWidget*> inOrder() const;

 Q_SIGNALS:
  void changed();
  void clearRequested();

 private:
  QComboBox* addChoice(const char* name, const QString& accessible);
  void fillChoice(QComboBox& box, const QString& all, const std::vector<std::pair<QString, QVariant>>& choices);
  QComboBox* kind_ = nullptr;
  QComboBox* region_ = nullptr;
  QComboBox* level_ = nullptr;
  QComboBox* tag_ = nullptr;
  QCheckBox* lessons_ = nullptr;
  QPushButton* clear_ = nullptr;
  QLabel* count_ = nullptr;
};

}  // namespace ew::ui
