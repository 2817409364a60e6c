#pragma once

#include <QWidget>

class QSpinBox;

namespace ew::ui {

class CaliperToolRow;
class Calipers;
class Session;

/// The tools for the strip of the M-mode, and over how many beats a heart rate is measured. There while the strip is.
class StripTools final : public QWidget {
  Q_OBJECT

 public:
  StripTools(Session& session, Calipers& calipers, QWidget* parent = nullptr);
  void refreshIcons();

 private:
  void showAll();

  Calipers& calipers_;
  Session& session_;
  CaliperToolRow* tools_ = nullptr;
  QWidget* beatsRow_ = nullptr;
  QSpinBox* beats_ = nullptr;
};

}  // namespace ew::ui
