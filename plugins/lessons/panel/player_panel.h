#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/sdk/host.h"
#include "logic/lesson_run.h"

class QLabel;
class QStackedWidget;

namespace ew::lessons {

class LessonList;
class OutcomePage;
class StepPage;

/// The lessons of the open case in Explore: choosing one, working through it step by step, seeing how it went. A lesson is left by leaving
/// it, and gone on with at the step it was left at, also after a crash.
class PlayerPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerPanel(sdk::Host& host, QWidget* parent = nullptr);
  ~PlayerPanel() override;

  [[nodiscard]] const LessonRun* run() const { return run_ ? &*run_ : nullptr; }

 private:
  void showCase();
  void showLessons();
  void begin(const std::string& lessonId);
  void goOn(const std::string& lessonId);
  void take(Result<LessonRun> run);
  void take(const ScanEvent& event);
  void openStep();  ///< makes ready what the step scans, and starts it
  void loadTruth();
  void startStep(std::shared_ptr<const CaseTruth> truth);
  void endStep();
  void skipStep();
  void nextStep();
  void leave();
  void leaveForAnotherCase();
  void fail(const Error& problem);
  void tick();
  [[nodiscard]] const Lesson* lessonOf(const std::string& id) const;
  [[nodiscard]] std::vector<std::string> keepPicture(const KeptAttempt& attempt) const;

  sdk::Host& host_;
  std::optional<Case> case_;     ///< the open one
  CaseWords words_;              ///< of the case that holds the lesson
  std::vector<Lesson> lessons_;  ///< of the open case, as they were written
  std::string homeCase_;         ///< id of the case whose lesson runs
  std::filesystem::path homeFolder_;
  std::optional<LessonRun> run_;
  std::shared_ptr<const CaseTruth> truth_;  ///< of the open case
  int loads_ = 0;                           ///< truths asked for so far; an older one that arrives late is not taken
  std::vector<sdk::Ticket> tickets_;
  QTimer timer_;

  QStackedWidget* pages_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* waiting_ = nullptr;
  LessonList* list_ = nullptr;
  StepPage* step_ = nullptr;
  OutcomePage* outcome_ = nullptr;
};

/// The folder of a case by its id, among the shipped ones and the user's own. @error notFound
[[nodiscard]] Result<std::filesystem::path> folderOfCase(const std::string& id);

}  // namespace ew::lessons
