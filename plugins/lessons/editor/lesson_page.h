#pragma once

#include <QWidget>
#include <string>

#include "editor/lesson_document.h"

class QLabel;
class QPushButton;

namespace ew::lessons {

class FieldForm;
class OrderList;

/// One lesson: what is said of it, and its steps.
class LessonPage final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPage(LessonDocument& document, QWidget* parent = nullptr);

  void showLesson(const std::string& id);
  void refresh();  ///< the lesson may have changed
  void chooseStep(const std::string& stepId);
  [[nodiscard]] const std::string& lessonId() const { return id_; }

 Q_SIGNALS:
  void backAsked();
  void openAsked(const QString& stepId);
  void tryAsked();
  void failed(const QString& problem);

 private:
  [[nodiscard]] const Lesson* lesson() const { return lessonIn(document_.lessons(), id_); }
  Result<void> change(const QString& what, const std::string& field, const std::function<void(Lesson&)>& change);
  void edit(const QString& what, const std::function<Lesson(Lesson)>& edit);
  void addFields();
  [[nodiscard]] QWidget* makeStepButtons();
  void addStep(std::string_view kind);
  void showSteps();

  LessonDocument& document_;
  std::string id_;
  QLabel* head_ = nullptr;
  QPushButton* try_ = nullptr;
  FieldForm* form_ = nullptr;
  OrderList* steps_ = nullptr;
  QLabel* noSteps_ = nullptr;
};

}  // namespace ew::lessons
