#pragma once

#include <QDialog>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTextBrowser;

namespace ew::ui {

class Worksheets;

/// The worksheet of the examination, beside the scan: what was measured with results, usual ranges and charts; its answers and the
/// gestational age by dates are given here.
class WorksheetDialog final : public QDialog {
  Q_OBJECT

 public:
  WorksheetDialog(Worksheets& worksheets, QWidget* parent);

 Q_SIGNALS:
  void saveAsked();

 private:
  void build();
  void showAll();
  void takeGestation();

  Worksheets& worksheets_;
  const void* shownPackage_ = nullptr;
  QLabel* heading_ = nullptr;
  QWidget* questions_ = nullptr;
  QLineEdit* gestation_ = nullptr;
  QLabel* gestationProblem_ = nullptr;
  struct Question {
    std::string item;
    std::string side;
    QComboBox* answer = nullptr;
  };
  std::vector<Question> asked_;
  QTextBrowser* sheet_ = nullptr;
  QPushButton* remove_ = nullptr;
  QMenu* values_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace ew::ui
