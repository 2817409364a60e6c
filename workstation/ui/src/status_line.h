#pragma once

#include <QTimer>
#include <QWidget>

#include "session.h"

class QLabel;

namespace ew::ui {

class FigureLabel;

/// Where the probe is, how deep it looks, what the frame runs and what each step costs, and how well the probe touches.
class StatusLine final : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLine(Session& session, QWidget* parent = nullptr);
  /// What the last undoable edit was called; shown on the right.
  void setEdit(const QString& text);

 private:
  void showPose();
  void showPlan();

  Session& session_;
  QTimer soon_;
  FigureLabel* position_ = nullptr;
  FigureLabel* depth_ = nullptr;
  FigureLabel* plan_ = nullptr;
  FigureLabel* contact_ = nullptr;
  QLabel* edit_ = nullptr;
};

/// "sample linear", "table": a step in the words of the window.
[[nodiscard]] QString nameOfStep(StepKind kind);

}  // namespace ew::ui
