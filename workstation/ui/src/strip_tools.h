#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ew/measurement/caliper.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace ew::ui {

class Calipers;
class Session;

/// The tools for the strip of the M-mode, and over how many beats a heart rate is measured. There while the strip is.
class StripTools final : public QWidget {
  Q_OBJECT

 public:
  StripTools(Session& session, Calipers& calipers, QWidget* parent = nullptr);
  void showIcons();

 private:
  void showAll();

  Calipers& calipers_;
  Session& session_;
  std::vector<QPushButton*> tools_;
  std::optional<measurement::CaliperKind> held_;
  QWidget* beatsRow_ = nullptr;
  QSpinBox* beats_ = nullptr;
};

}  // namespace ew::ui
