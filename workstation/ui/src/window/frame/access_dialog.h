#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "ew/core/result.h"
#include "ew/library/passphrase.h"
#include "ew/widgets/form_dialog.h"

class QGridLayout;
class QLineEdit;
class QPushButton;

namespace ew::ui {

/// Asks for a passphrase: once for one that is known, twice for a new one. What is typed is not shown, and wiped when the dialog ends.
class AccessDialog final : public FormDialog {
  Q_OBJECT

 public:
  enum class Asks { known, fresh };
  /// @param take what to do with it; its error is shown, and the dialog stays open
  AccessDialog(Asks asks, const QString& heading, const QString& sentence, std::function<Result<void>(const Passphrase&)> take,
               QWidget* parent);
  ~AccessDialog() override;

 private:
  void tryIt();
  void refresh();
  [[nodiscard]] QLineEdit* addField(const QString& label, const QString& name);

  std::function<Result<void>(const Passphrase&)> take_;
  QGridLayout* fields_ = nullptr;
  QLineEdit* words_ = nullptr;
  QLineEdit* again_ = nullptr;  ///< of a new one
  QPushButton* accept_ = nullptr;
};

}  // namespace ew::ui
