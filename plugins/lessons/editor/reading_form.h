#pragma once

#include <filesystem>

#include "editor/task_form.h"

class QLabel;
class QPushButton;

namespace ew::lessons {

/// The image of a step that is read: chosen, or dropped here, and kept as its pixels alone.
class ReadingForm final : public TaskForm {
  Q_OBJECT

 public:
  ReadingForm(const StepEdit& edited, QWidget* parent);
  void showTask(bool typed) override;

 public Q_SLOTS:
  /// @param file PNG or JPEG
  void takeImage(const QString& file);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void say(const Result<void>& done);

  QLabel* image_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace ew::lessons
