#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ew/assessment/repetition_record.h"
#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/sdk/host.h"
#include "logic/exercises.h"
#include "logic/lesson_run.h"

class QLabel;
class QStackedWidget;

namespace ew::lessons {

class OutcomePage;
class StepPage;
class TargetShown;

/// Teaching yourself: the program asks one exercise of the open case after the other, the hardest for this person most often, with the
/// pages of lessons. Each try is kept as soon as it is judged.
class ExercisePlayer final : public QWidget {
  Q_OBJECT

 public:
  explicit ExercisePlayer(sdk::Host& host, QWidget* parent = nullptr);
  ~ExercisePlayer() override;

  /// @param opened the open case
  void begin(const Case& opened, CaseWords words, bool withFindings);
  /// Stops; an exercise that runs does not count.
  void leave();
  [[nodiscard]] bool isRunning() const { return case_.has_value(); }

 Q_SIGNALS:
  void ended();
  void failed(const QString& problem);
  void problemGone();

 private:
  void plan();
  void next();
  void skip();
  void startAt(const NextExercise& planned, const std::optional<Hold>& start);
  void endExercise();
  void keep(const StepOutcome& outcome, const RepetitionState& before);
  void take(const ScanEvent& event);
  void tick();
  void tell(const Error& problem);
  void finish();

  sdk::Host& host_;
  std::optional<Case> case_;
  CaseWords words_;
  std::shared_ptr<const ExercisePlan> plan_;
  std::vector<Exercise> exercises_;
  std::set<std::string> skipped_;
  std::filesystem::path file_;  ///< of what is known of the exercises
  std::vector<RepetitionState> states_;
  bool withFindings_ = false;
  bool isKept_ = true;  ///< false: the file cannot be written, and tries count until the window closes
  std::optional<LessonRun> run_;
  Exercise exercise_;
  LessonStep shown_;
  int level_ = 1;
  std::unique_ptr<TargetShown> target_;  ///< of the exercise that was judged
  int jobs_ = 0;                         ///< begun so far; one that is overtaken by leaving is not taken
  std::vector<sdk::Ticket> tickets_;
  QTimer timer_;

  QStackedWidget* pages_ = nullptr;
  QLabel* waiting_ = nullptr;
  StepPage* step_ = nullptr;
  OutcomePage* outcome_ = nullptr;
};

}  // namespace ew::lessons
