#pragma once

#include <QWidget>
#include <string>

#include "editor/lesson_document.h"

class QHBoxLayout;
class QLabel;
class QMenu;
class QPushButton;
class QVBoxLayout;

namespace ew::lessons {

class OrderList;

/// The lessons of the case: making, copying, ordering and removing them.
class LessonsPage final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonsPage(LessonDocument& document, QWidget* parent = nullptr);
  void showLessons();

 Q_SIGNALS:
  void openAsked(const QString& lessonId);
  void wordsAsked();
  void failed(const QString& problem);  ///< empty: what was asked for has been done

 private:
  void addList(QVBoxLayout& column);
  QHBoxLayout* makeChosenRow();
  QHBoxLayout* makeOrderRow();
  void addUnusedRow(QVBoxLayout& column);
  void fillMenu(QMenu& menu);
  void add(Lesson lesson);
  void edit(const QString& what, const LessonDocument::Edit& edit);
  void remove(const std::string& id);
  void removeUnused();

  LessonDocument& document_;
  OrderList* list_ = nullptr;
  QWidget* none_ = nullptr;
  QWidget* some_ = nullptr;
  QPushButton* words_ = nullptr;
  QWidget* unusedRow_ = nullptr;
  QLabel* unused_ = nullptr;
};

/// The language that somebody who uses the window in this one writes in: "de" or "en".
[[nodiscard]] std::string writtenLanguage();

}  // namespace ew::lessons
