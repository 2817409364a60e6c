#pragma once

#include <QTimer>
#include <QWidget>

#include "scan/session.h"

class QLabel;
class QPushButton;

namespace ew {
class FigureLabel;
}

namespace ew::ui {

/// Where the probe is and how well it touches; for authors also what the frame runs and what it costs: the plan's tooltip shows each step,
/// estimated and measured, and how long images took from the hand to the screen's memory.
class StatusLine final : public QWidget {
  Q_OBJECT

 public:
  explicit StatusLine(Session& session, QWidget* parent = nullptr);
  /// What the last undoable edit was called; shown on the right.
  void setEdit(const QString& text);
  /// What the panel in front wants to be known; at the very right.
  void setNote(const QString& text);
  /// Without the figures of the probe: they are not the panel's matter.
  void setStaged(bool staged);
  /// A bar that takes the place of what is said of the probe while it is shown, so that the views keep their sizes. Becomes a child.
  void takeCine(QWidget* bar);
  void takeJobs(QWidget* line);  ///< at the end of the line, on every page
  void setCineShown(bool shown);
  /// What follows the probe and how it does: an icon, a word and a colour of its own; without a word nothing is said.
  void setTracker(const QString& icon, const QString& word, const QColor& colour, const QString& tip);
  /// Empty, while something else than the scan is shown.
  void setIdle(bool idle);
  /// What a frame runs and costs is for authors.
  void setForAuthors(bool forAuthors);

 Q_SIGNALS:
  void trackerAsked();  ///< its word was clicked

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showPose();
  void showPlan();
  void showLabels();
  [[nodiscard]] QString planTip() const;

  Session& session_;
  QTimer soon_;
  bool staged_ = false, idle_ = false, forAuthors_ = false, isCineShown_ = false;
  QWidget* cine_ = nullptr;
  QWidget* jobs_ = nullptr;
  QPushButton* tracker_ = nullptr;
  FigureLabel* position_ = nullptr;
  FigureLabel* plan_ = nullptr;
  FigureLabel* contact_ = nullptr;
  QLabel* lowered_ = nullptr;
  QLabel* edit_ = nullptr;
  QLabel* note_ = nullptr;
};

/// "sample linear", "table": a step in the words of the window.
[[nodiscard]] QString nameOfStep(StepKind kind);
[[nodiscard]] QString nameOfQuality(Quality quality);

}  // namespace ew::ui
