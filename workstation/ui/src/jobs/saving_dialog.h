#pragma once

#include <QDialog>
#include <QTimer>

class QLabel;
class QProgressBar;

namespace ew::ui {

class Jobs;

/// Shown while something waits for what is being saved: says what that is and how far it has come, and goes away with the last of it.
class SavingDialog final : public QDialog {
  Q_OBJECT

 public:
  enum class Outcome {
    saved,
    notSaved,  ///< something could not be saved
    stay,      ///< the user does not want to wait, nor to lose it
    lose       ///< the user goes on without what is not saved
  };

  /// @param closes whether the window closes afterwards; only then the user may choose to lose what is not saved
  SavingDialog(Jobs& jobs, bool closes, QWidget* parent);
  /// Blocks until everything is saved or the user decides. Nothing is cancelled here.
  [[nodiscard]] Outcome wait();

 private:
  void look();

  Jobs& jobs_;
  Outcome outcome_ = Outcome::stay;
  QTimer poll_;
  QLabel* what_ = nullptr;
  QProgressBar* bar_ = nullptr;
};

}  // namespace ew::ui
