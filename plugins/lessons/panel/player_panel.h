#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/library/learning_progress.h"
#include "ew/sdk/host.h"
#include "logic/lesson_run.h"
#include "logic/step_autosave.h"

class QLabel;
class QStackedWidget;

namespace ew::lessons {

class ExerciseCard;
class ExercisePlayer;
class LessonList;
class LessonPlayer;

/// The lessons of the open case in Explore: choosing one, working through it step by step, seeing how it went; and exercises. A lesson is
/// left by leaving it, and gone on with at the step it was left at, also after a crash.
class PlayerPanel final : public QWidget {
  Q_OBJECT

 public:
  /// @param working told when a lesson or exercises begin, and when they are left; may be empty
  explicit PlayerPanel(sdk::Host& host, std::function<void(bool)> working = {}, QWidget* parent = nullptr);
  ~PlayerPanel() override;

 private:
  void showCase();
  struct Listing;
  void showLessons();  ///< once a job has read how far the person has got
  void takeListing(const Listing& read, const Result<void>& done);
  void showListing(const Listing& read);
  void begin(const std::string& lessonId);
  /// Who asks: the list here; the window, which offers what a crash has left; or a learning system that started the window for the lesson,
  /// which is told of an attempt that begins now, and of no other.
  enum class Asked { byList, byWindow, byLaunch };
  void goOn(const std::string& lessonId, Asked asked);
  /// What a crash has left of the lesson, of whichever attempt: one that is finished has a step that was tried once more.
  [[nodiscard]] std::optional<StepAutosave::Left> leftOf(const std::string& lessonId, const AttemptList& attempts) const;
  void take(Result<LessonRun> run, std::optional<StepAutosave::Left> left = std::nullopt);
  void beginExercises();
  void stop();
  void fail(const Error& problem);
  [[nodiscard]] bool isAtWork() const;
  [[nodiscard]] const Lesson* lessonOf(const std::string& id) const;

  sdk::Host& host_;
  std::function<void(bool)> working_;
  std::optional<Case> case_;     ///< the open one
  CaseWords words_;              ///< of the case that holds the lesson
  std::vector<Lesson> lessons_;  ///< of the open case, as they were written
  std::vector<sdk::Ticket> tickets_;
  int listings_ = 0;                                             ///< begun so far: an older one that arrives late is not shown
  bool isListing_ = false;                                       ///< the latest is being read
  std::optional<std::pair<std::string, Asked>> askedMeanwhile_;  ///< a lesson that the window wants once it is
  bool hasBegunLaunched_ = false;                                ///< the lesson that this window was started for

  QStackedWidget* pages_ = nullptr;
  QLabel* problem_ = nullptr;
  LessonList* list_ = nullptr;
  ExerciseCard* card_ = nullptr;
  LessonPlayer* player_ = nullptr;
  ExercisePlayer* exercises_ = nullptr;
};

}  // namespace ew::lessons
