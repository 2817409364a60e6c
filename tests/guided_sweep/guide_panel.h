#pragma once

#include <QWidget>

#include "ew/core/result.h"
#include "guide.h"

class QLabel;
class QPushButton;

namespace ew {
class NumberField;
}

namespace guided_sweep {

/// Two poses, a duration, and a button that shows the sweep.
class GuidePanel final : public QWidget {
  Q_OBJECT

 public:
  GuidePanel(ew::sdk::Host& host, Guide& guide, QWidget* parent);
  ~GuidePanel() override;

 private:
  void show_();
  void tell(const ew::Result<void>& done);

  ew::sdk::Host& host_;
  Guide& guide_;
  QLabel* state_ = nullptr;
  ew::NumberField* duration_ = nullptr;
  QPushButton* run_ = nullptr;
};

}  // namespace guided_sweep
