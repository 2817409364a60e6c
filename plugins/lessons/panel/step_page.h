#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "ew/assessment/compass.h"
#include "ew/library/lesson.h"
#include "logic/lesson_run.h"
#include "panel/aids_drawer.h"
#include "panel/click_guard.h"
#include "panel/expert_player.h"

class QButtonGroup;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace ew {
class ScrollRows;
}

namespace ew::lessons {

/// One step at work: what to do, what to look for, aids and hints, and what the trainee hands in. Owns nothing of the lesson: the panel
/// does.
class StepPage final : public QWidget {
  Q_OBJECT

 public:
  explicit StepPage(sdk::Host& host, QWidget* parent = nullptr);
  ~StepPage() override;

  /// Shows the step the run stands at, which runs. @param recording of a step that is watched
  void showStep(LessonRun& run, const LessonStep& shown, const StepScene& scene, std::optional<ScanRecording> recording,
                const std::filesystem::path& image);
  /// What stands above the step in place of its number in the lesson.
  void setHead(const QString& text, int value, int most);
  /// Where was pointed, as it stands in the image; null: nowhere.
  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> point() const { return point_ ? pointShown_ : nullptr; }
  /// Nothing is asked for any more: drawings and the probe are given back.
  void end();
  void see(const ScanState& image);
  /// A frozen image can be pointed at without more ado.
  void setFrozen(bool isFrozen);
  /// What stands handed in now.
  [[nodiscard]] Handed handed() const;
  /// Time, figures and what is missing, as they are now. Called a few times a second.
  void refresh(double now_s);

 Q_SIGNALS:
  void doneAsked();
  void skipAsked();
  void leaveAsked();
  void pauseAsked(bool paused);

 private:
  void clear();
  QLabel* addText(const QString& text, const char* name, bool quiet = false);
  void addAids(const LessonStep& step);
  void addAnswer(const AnswerTask& task);
  void addPointing();
  void addExpert(const WatchTask& task, ScanRecording recording);
  void addImage(const std::filesystem::path& file);
  void showExpert();
  void showPoint();

  sdk::Host& host_;
  LessonRun* run_ = nullptr;
  std::unique_ptr<AidsDrawer> aids_;
  std::unique_ptr<ExpertPlayer> expert_;
  sdk::Ticket asking_;
  std::shared_ptr<sdk::ScanOverlay> pointShown_;
  std::optional<Point<frame::Probe>> point_;
  bool watched_ = false;
  ClickGuard guard_;  ///< of Done

  /// Advice for the hand while a plane is sought; empty: the step has none, or the trainee does without.
  struct Compass {
    CompassTarget target;
    std::shared_ptr<const Skin> skin;
    std::optional<CompassAdvice> advice;
  };
  void makeCompass(const LessonStep& step, const StepScene& scene);
  void showCompass();
  std::optional<Compass> compass_;
  std::optional<ScanState> last_;
  bool wantsCompass_ = false;
  QLabel* compassText_ = nullptr;
  QLabel* outlineText_ = nullptr;

  QLabel* head_ = nullptr;
  QProgressBar* bar_ = nullptr;
  ScrollRows* scrolled_ = nullptr;
  QVBoxLayout* rows_ = nullptr;
  QLabel* time_ = nullptr;
  QLabel* live_ = nullptr;
  QLabel* missing_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* hintButton_ = nullptr;
  QPushButton* pause_ = nullptr;
  QPushButton* done_ = nullptr;
  QButtonGroup* options_ = nullptr;
  QDoubleSpinBox* number_ = nullptr;
  QPushButton* pointButton_ = nullptr;
  QPushButton* play_ = nullptr;
  QLabel* mark_ = nullptr;
};

}  // namespace ew::lessons
