#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "ew/scanning/recording.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ew {
class TimeLine;
}

namespace ew::ui {

class Session;

/// Plays a recording in the scan: play and pause, a time line to drag along, speed, loop. Hidden while there is no recording.
class ReplayBar final : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayBar(Session& session, QWidget* parent = nullptr);

  /// Shows the first image of a recording, at rest.
  void load(std::shared_ptr<const ScanRecording> recording);
  /// Back to the live scan; the recording is forgotten.
  void unload();
  [[nodiscard]] const std::shared_ptr<const ScanRecording>& recording() const { return recording_; }
  void setPlaying(bool playing);
  [[nodiscard]] bool isPlaying() const { return tick_.isActive(); }
  /// @param position_s from the recording's first image; brought within it
  void seek(double position_s);
  [[nodiscard]] double position_s() const { return position_s_; }
  [[nodiscard]] double length_s() const;
  void setSaved(bool saved);
  void refreshIcons();

 Q_SIGNALS:
  void saveAsked();
  void closeAsked();

 private:
  void advance();
  void showFrame();
  void showState();

  Session& session_;
  std::shared_ptr<const ScanRecording> recording_;
  std::optional<std::size_t> frame_;  ///< that is shown
  double position_s_ = 0.0;
  QTimer tick_;
  QElapsedTimer sinceTick_;
  QPushButton* play_ = nullptr;
  TimeLine* line_ = nullptr;
  QLabel* time_ = nullptr;
  QComboBox* speed_ = nullptr;
  QPushButton* loop_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace ew::ui
