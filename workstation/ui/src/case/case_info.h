#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "ew/library/case_values.h"
#include "ew/library/case_words.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace ew {
struct Case;
}

namespace ew::ui {

/// What is known of the open case before the probe touches the skin: patient, history, earlier examinations, indication, and a list of what
/// is to be shown and measured, to be ticked off. The findings come when they are asked for, and go again with the case. Folded, only its
/// head is left; whether it is folded is remembered.
class CaseInfo final : public QWidget {
  Q_OBJECT

 public:
  explicit CaseInfo(QWidget* parent = nullptr);

  /// @param shown the open case, or null: nothing is shown
  void showCase(const Case* shown);
  /// Its texts in the window's language, as they were when it was shown or edited last.
  [[nodiscard]] const CaseWords& caseWords() const { return words_; }
  [[nodiscard]] bool isOpen() const { return isOpen_; }
  void setOpen(bool open);
  /// Of all of its words at the present width, and of the head alone.
  [[nodiscard]] int wantedHeight_px() const;
  [[nodiscard]] int headHeight_px() const;
  void refreshIcons();

 Q_SIGNALS:
  void opened(bool open);
  void contentsChanged();

 private:
  void fill(const Case& shown);
  void addHeading(const QString& text);
  QLabel* addText(const QString& text, bool quiet = false);
  void addList(const Case& shown);

  QPushButton* head_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QWidget* body_ = nullptr;
  QVBoxLayout* rows_ = nullptr;
  QPushButton* findingsButton_ = nullptr;
  std::string case_;                                     ///< folder of what is shown
  std::optional<Case> contents_;                         ///< of what is shown, so that an unrelated edit keeps ticks and findings
  std::map<std::string, std::set<std::string>> ticked_;  ///< names by the case's folder, as long as the window lives
  bool isOpen_ = true;
  bool showsFindings_ = false;
  CaseWords words_;  ///< of the shown case, in the window's language
};

}  // namespace ew::ui
