#pragma once

#include <QDialog>
#include <filesystem>

class QLabel;
class QLineEdit;
class QPushButton;

namespace ew::ui {

/// Asks for the new folder that a case is saved to: a name in the library of the user's own cases, or in any other folder. Says what
/// will be made, and why it cannot be while it cannot.
class CaseFolderDialog final : public QDialog {
  Q_OBJECT

 public:
  /// @param why what the user should know first; may be empty
  /// @param name proposed for the folder; a number is added when it is taken
  CaseFolderDialog(const QString& why, const QString& name, QWidget* parent);

  [[nodiscard]] std::filesystem::path folder() const;
  /// The library of the user's own cases: as chosen here last, else ownCasesFolder().
  [[nodiscard]] static std::filesystem::path library();

 protected:
  void done(int result) override;

 private:
  void look();

  QLineEdit* library_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* result_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace ew::ui
