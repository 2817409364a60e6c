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
#include "logic/step_autosave.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace ew::lessons {

class OutcomePage;
class StepPage;
class TargetShown;

/// One run through a lesson: opens what each step scans, shows the step, and how it went. Whether an attempt is kept is the run's affair,
/// so a trainee works with the pages that an author tries.
class LessonPlayer final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPlayer(sdk::Host& host, QWidget* parent = nullptr);
  ~LessonPlayer() override;

  /// Begins or goes on. @param home the case that holds the lesson, which is open
  /// @param left what a crash has left of the step the run stands at, which goes on where it stood
  void play(LessonRun run, const Case& home, CaseWords words, std::optional<StepAutosave::Left> left = std::nullopt);
  [[nodiscard]] const StepAutosave& kept() const { return kept_; }
  [[nodiscard]] const LessonRun* run() const { return run_ ? &*run_ : nullptr; }
  /// Leaves the lesson at the step it is at; a step that runs begins anew when it is gone on with.
  void leave();

 Q_SIGNALS:
  void ended();      ///< left, or the summary was read: there is no run any more
  void drivenOut();  ///< before ended(): left, because the user has opened another case
  void failed(const QString& problem);
  void problemGone();

 private:
  void take(const ScanEvent& event);
  [[nodiscard]] QWidget* makeWaiting();
  void openStep();  ///< makes ready what the step scans, and starts it
  /// Says what a step waits for that may take long, or never come: the lesson can be left meanwhile.
  void waitFor(const QString& what);
  void openCaseIn(const std::filesystem::path& folder);  ///< which the step scans
  void findAndOpen(const std::string& caseId);           ///< the same where only the library knows the folder
  void loadTruth(const Case& opened);
  void startStep(std::shared_ptr<const CaseTruth> truth);
  void takeUpLeft();
  void endStep();
  void skipStep();
  void nextStep();
  void showSummary();
  void takeCase();  ///< another one is open, or none
  void leaveForAnotherCase();
  void finish();
  void fail(const Error& problem);
  void tick();
  bool setWrong(const SettingsTask& task, const sdk::Scanned& scanned);
  void giveSettingsBack();
  [[nodiscard]] StepScene sceneOf(const sdk::Scanned& scanned) const;
  [[nodiscard]] std::optional<Case> openCase() const;
  [[nodiscard]] std::vector<std::string> keepImage(const AttemptFolder& attempt) const;

  sdk::Host& host_;
  std::string homeCase_;  ///< id of the case whose lesson runs
  std::filesystem::path homeFolder_;
  std::filesystem::path folder_;  ///< of the case that is open
  CaseWords words_;               ///< of the case that holds the lesson
  std::optional<LessonRun> run_;
  StepAutosave kept_;                       ///< the step that runs, against a crash
  std::optional<StepAutosave::Left> left_;  ///< of the step that is about to start
  std::string homeTitle_;                   ///< of the case that holds the lesson, for trainees
  double keptAt_s_ = 0.0;
  std::shared_ptr<const CaseTruth> truth_;  ///< of the open case
  std::optional<ScanState> before_;         ///< how the machine stood before a step set it wrong
  std::unique_ptr<TargetShown> target_;     ///< of the step that was judged
  int loads_ = 0;                           ///< truths asked for so far; an older one that arrives late is not taken
  std::vector<sdk::Ticket> tickets_;
  QTimer timer_;

  QStackedWidget* pages_ = nullptr;
  QLabel* waiting_ = nullptr;
  QPushButton* leaveWaiting_ = nullptr;
  StepPage* step_ = nullptr;
  OutcomePage* outcome_ = nullptr;
};

/// The folder of a case by its id: the user's own, published or shipped. It reads cases, and so belongs into a job. @error notFound
[[nodiscard]] Result<std::filesystem::path> folderOfCase(const std::string& id);

}  // namespace ew::lessons
