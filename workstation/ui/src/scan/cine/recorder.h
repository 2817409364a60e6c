#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "ew/scanning/recording.h"

namespace ew::ui {

class Session;

/// Records the scan of a session while it goes on: every image with all that it was made with, freezing, and
/// what was missed while a tracker had lost the probe.
class Recorder final : public QObject {
  Q_OBJECT

 public:
  explicit Recorder(Session& session, QObject* parent = nullptr);

  /// @param caseId of the case that is scanned, or empty. Nothing happens without a subject, while frozen or while a recording is played.
  void start(const std::string& caseId);
  /// @return null when nothing was recorded
  std::shared_ptr<const ScanRecording> stop();
  [[nodiscard]] bool isRecording() const { return recording_ != nullptr; }
  [[nodiscard]] double length_s() const;
  /// What is recorded so far; null while nothing is.
  [[nodiscard]] const ScanRecording* growing() const { return recording_.get(); }
  void addNote(const std::string& kind, const nlohmann::json& what);

 Q_SIGNALS:
  void changed();  ///< begun, ended, or another second long

 private:
  void takeImage();
  void takeMissed();
  void noteTracker(const std::string& state);

  Session& session_;
  std::shared_ptr<ScanRecording> recording_;  ///< null: none is made
  double begin_s_ = 0.0;
  std::string trackerState_;  ///< that was noted last; empty: poses come, or nobody tracks
  QTimer second_;
};

}  // namespace ew::ui
