#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "ew/library/new_case.h"
#include "ew/library/templates.h"
#include "ew/sdk/host.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace ew::case_authoring {

class RightsForm;
class SourceField;

/// Makes a case in three steps: from what, what it is about, where it is kept and what that takes. Making is a job with progress and
/// cancel; the dialog is out of the way meanwhile, and comes back with all that was said when it failed. The new case is opened in Author.
class NewCaseDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit NewCaseDialog(sdk::Host& host, QWidget* parent = nullptr);

 private:
  enum Step { from, about, where };
  QWidget* makeFrom();
  QWidget* makeAbout();
  QWidget* makeWhere();
  QWidget* makeButtons();
  void goTo(int step);
  void look();  ///< what may be done now, and why not
  void takeTemplate();
  void plan();
  void showPlan(const NewCasePlan& found);
  void make();
  [[nodiscard]] NewCase wanted() const;
  [[nodiscard]] std::filesystem::path folder() const;
  [[nodiscard]] QString problemOf(int step) const;

  sdk::Host& host_;
  std::vector<CaseTemplate> templates_;
  QLabel* stepName_ = nullptr;
  QStackedWidget* steps_ = nullptr;
  SourceField* source_ = nullptr;
  QComboBox* template_ = nullptr;
  QLabel* templateText_ = nullptr;
  QLineEdit* title_ = nullptr;
  QLineEdit* titleForTrainees_ = nullptr;
  QComboBox* region_ = nullptr;
  RightsForm* rights_ = nullptr;
  QLineEdit* library_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* needs_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* next_ = nullptr;
  bool nameWasTyped_ = false;
  int planned_ = 0;  ///< number of the plan that is waited for
};

}  // namespace ew::case_authoring
