#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

#include "ew/controls/binding.h"
#include "keys/key_map.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace ew::ui {

class ControlSurface;
class KeyField;

/// Every key and every knob: find, change, take back, save and share. What is changed acts at once.
class KeysDialog final : public QDialog {
  Q_OBJECT

 public:
  /// A key of a plugin's panel, which is listed and cannot be changed.
  struct PanelKey {
    QString panel, key, what;
  };
  KeysDialog(KeyMap& keys, ControlSurface& surface, std::vector<PanelKey> ofPanels, QWidget* parent);
  ~KeysDialog() override;

  /// Takes over a file of somebody else's, and says what came of it.
  void takeFile(const QString& file);

 Q_SIGNALS:
  void changed();  ///< by the person, and to be kept

 private:
  QWidget* makeKeys();
  QWidget* makeControls();
  QWidget* makeChosen();
  void fillKeys();
  void filter();
  void showChosen();
  [[nodiscard]] const KeyCommand* chosen() const;
  void addKey(const QKeySequence& key, bool takesAway);
  void setKeys(const QList<QKeySequence>& keys);
  void ask(const QString& question, const QString& answer, std::function<void()> yes);
  void tell(const QString& sentence);
  void fillControls();
  void fillTargets();
  void showLearning();
  void showDevices();
  void learn();
  void changeBinding(int row, const std::function<void(controls::Binding&)>& change);
  void removeBinding();
  [[nodiscard]] QString nameOf(const controls::Target& target) const;
  void saveFile();

  KeyMap& keys_;
  ControlSurface& surface_;
  std::vector<PanelKey> ofPanels_;
  QLineEdit* filter_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QLabel* name_ = nullptr;
  QHBoxLayout* present_ = nullptr;
  KeyField* field_ = nullptr;
  QPushButton* reset_ = nullptr;
  QLabel* said_ = nullptr;
  QPushButton* yes_ = nullptr;
  QPushButton* no_ = nullptr;
  std::function<void()> onYes_;
  QComboBox* targets_ = nullptr;
  QPushButton* learn_ = nullptr;
  QLabel* learning_ = nullptr;
  QTreeWidget* controls_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* devices_ = nullptr;
  QLabel* fileSaid_ = nullptr;
};

}  // namespace ew::ui
