#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "ew/library/lesson.h"
#include "ew/scanning/recording.h"
#include "ew/sdk/host.h"
#include "ew/sdk/scan.h"

namespace ew::lessons {

/// Plays an expert's scan on the body that is open: the probe follows the recorded poses with the recorded settings, and rests at each mark
/// until it is told to go on. The trainee's probe and settings come back when it is destroyed.
class ExpertPlayer final : public QObject {
  Q_OBJECT

 public:
  ExpertPlayer(sdk::Host& host, ScanRecording recording, WatchTask task, QObject* parent = nullptr);
  ~ExpertPlayer() override;

  void play();  ///< on from where it rests; from the beginning when it has ended
  void rest();
  [[nodiscard]] bool isPlaying() const { return playing_; }
  [[nodiscard]] bool hasEnded() const { return ended_; }
  /// The mark it rests at; null: at none.
  [[nodiscard]] const ExpertMark* mark() const;
  [[nodiscard]] double at_s() const;  ///< on the recording's clock
  /// Shows a moment of the shown part and rests there.
  void jumpTo(double time_s);
  /// @param speed 1: as it was recorded
  void setSpeed(double speed);

 Q_SIGNALS:
  void changed();
  void takenBack();  ///< the user took the probe (Escape)

 private:
  struct Path;
  void tick();
  void applySettings();

  sdk::Host& host_;
  ScanRecording recording_;
  WatchTask task_;
  std::shared_ptr<Path> path_;
  sdk::Ticket drive_, settings_;
  QTimer timer_;
  bool playing_ = false, ended_ = false;
  std::size_t nextMark_ = 0;
  std::optional<std::size_t> atMark_;
  std::optional<Knobs> applied_;
};

}  // namespace ew::lessons
