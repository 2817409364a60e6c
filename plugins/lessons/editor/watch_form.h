#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "editor/task_form.h"
#include "ew/scanning/recording.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ew {
class TimeLine;
}

namespace ew::lessons {

class ExpertPlayer;

/// The expert's scan of a step: recording it, showing a part of it, marking moments.
class WatchForm final : public TaskForm {
  Q_OBJECT

 public:
  WatchForm(const StepEdit& edited, ExpertTake& take, QWidget* parent);
  ~WatchForm() override;
  void showTask(bool typed) override;

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* makeTakePart();
  [[nodiscard]] QWidget* makePlayPart();
  void start();
  void stop();
  void showTake();
  struct ScanToKeep;
  void keep(ScanRecording made, const std::vector<double>& marks_s, bool isTaken);
  void saveTaken(ScanRecording made);
  [[nodiscard]] static Result<void> nameInStep(const StepEdit& at, const ScanToKeep& kept);
  void choose(const std::filesystem::path& file);
  void load();
  void showRecording();
  void showMarks(const WatchTask& task);
  [[nodiscard]] QWidget* makeMark(std::size_t number, const ExpertMark& mark);
  [[nodiscard]] ExpertPlayer* player();  ///< takes the probe; null without a recording
  void release();                        ///< gives it back
  void play();
  void lookAt(double time_s);
  void showPlace();
  void setPart(double begin_s, double end_s);
  void addMark();
  void change(const QString& what, const std::string& field, const std::function<void(WatchTask&)>& edit);
  void say(const Result<void>& done);
  [[nodiscard]] bool isHome() const;

  ExpertTake& take_;
  std::string shown_;  ///< name of the recording that is loaded or on its way
  std::shared_ptr<const ScanRecording> recording_;
  std::unique_ptr<ExpertPlayer> player_;
  int loads_ = 0;

  QLabel* state_ = nullptr;
  QPushButton* record_ = nullptr;
  QPushButton* choose_ = nullptr;
  QWidget* takePart_ = nullptr;
  QLabel* length_ = nullptr;
  QPushButton* stop_ = nullptr;
  QPushButton* pause_ = nullptr;
  QPushButton* takeMark_ = nullptr;
  QPushButton* discard_ = nullptr;
  QWidget* playPart_ = nullptr;
  TimeLine* line_ = nullptr;
  QPushButton* play_ = nullptr;
  QComboBox* speed_ = nullptr;
  QLabel* place_ = nullptr;
  QVBoxLayout* marks_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace ew::lessons
