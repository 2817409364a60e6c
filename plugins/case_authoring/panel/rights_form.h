#pragma once

#include <QWidget>

#include "ew/library/new_case.h"

class QFormLayout;
class QLineEdit;

namespace ew::case_authoring {

/// Whom to name for a recording, and its licence.
class RightsForm final : public QWidget {
  Q_OBJECT

 public:
  explicit RightsForm(QWidget* parent = nullptr);

  [[nodiscard]] RecordingRights rights() const;
  [[nodiscard]] QFormLayout* form() const { return form_; }

 private:
  QFormLayout* form_ = nullptr;
  QLineEdit* attribution_ = nullptr;
  QLineEdit* licence_ = nullptr;
};

}  // namespace ew::case_authoring
