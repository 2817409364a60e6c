#pragma once

#include <QWidget>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/expert_take.h"
#include "editor/lesson_document.h"

class QLabel;
class QStackedWidget;

namespace ew::lessons {

class LessonPage;
class LessonPlayer;
class LessonsPage;
class StepEditor;
class WordsPage;

/// The lessons of the open case for whoever writes them: lessons, one lesson with its steps, one step, translations; and any of it tried as
/// a trainee sees it.
class EditorPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit EditorPanel(sdk::Host& host, QWidget* parent = nullptr);
  ~EditorPanel() override;

 private:
  QWidget* makePreview();
  void connectPages();
  void showCase();     ///< another one is open, or none
  void takeChanges();  ///< the case, or its saved state
  void showLessons();
  void showLesson(const std::string& lessonId);
  void showStep(const std::string& stepId);
  void showWords();
  void tryLesson(bool onlyStep);
  void endTry();
  void say(const QString& problem);

  sdk::Host& host_;
  ExpertTake take_;  // before the document: it has followed a case that was saved elsewhere when that is told of
  LessonDocument document_;
  std::string lessonId_, stepId_;  ///< that are edited; empty: none
  /// Where a trial was begun, to come back to.
  struct Tried {
    std::filesystem::path folder;
    std::string lessonId, stepId;  ///< no step: the lesson as a whole
  };
  void comeBackTo(const Tried& tried);
  std::optional<Tried> tried_;
  QStackedWidget* pages_ = nullptr;
  QLabel* problem_ = nullptr;
  LessonsPage* lessons_ = nullptr;
  LessonPage* lesson_ = nullptr;
  StepEditor* step_ = nullptr;
  WordsPage* words_ = nullptr;
  LessonPlayer* player_ = nullptr;
  std::vector<sdk::Ticket> tickets_;
};

}  // namespace ew::lessons
