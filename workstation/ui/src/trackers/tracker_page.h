#pragma once

#include <string>

#include "ew/widgets/form_dialog.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QSpinBox;
class QTabWidget;

namespace ew::ui {

class TrackerFigures;
class TrackerForm;
class Trackers;

/// What moves the probe: the mouse or one of the user's trackers, how it does at this moment, and what can be set of it. It stays beside
/// the scan.
class TrackerPage final : public FormDialog {
  Q_OBJECT

 public:
  explicit TrackerPage(Trackers& trackers, QWidget* parent);

  void choose(const std::string& tracker);  ///< empty: the mouse
  [[nodiscard]] const std::string& chosen() const { return chosen_; }

 Q_SIGNALS:
  void setUpAsked(const QString& tracker);
  void alignAsked(const QString& tracker);

 private:
  void addList();
  void addListButtons(class QVBoxLayout& column);
  void addState();
  void addTabs();
  [[nodiscard]] QWidget* makeSharing();
  void addTracker(int kind);
  void showList();
  void showSettings();
  void showNow();
  void showState();
  void showButtons();
  void printSheet();
  void takeName(QListWidgetItem* item);

  Trackers& trackers_;
  std::string chosen_;
  bool isFilling_ = false;
  QListWidget* list_ = nullptr;
  QPushButton *rename_ = nullptr, *remove_ = nullptr;
  QLabel *stateIcon_ = nullptr, *stateWord_ = nullptr, *stateSentence_ = nullptr, *fit_ = nullptr;
  QPushButton *use_ = nullptr, *setUp_ = nullptr, *align_ = nullptr, *print_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  TrackerFigures* figures_ = nullptr;
  QWidget* settingsPage_ = nullptr;
  TrackerForm* form_ = nullptr;
  QCheckBox *serves_ = nullptr, *sounds_ = nullptr;
  QSpinBox* servePort_ = nullptr;
  QCheckBox* servesNetwork_ = nullptr;
  QLabel* serverSentence_ = nullptr;
};

}  // namespace ew::ui
