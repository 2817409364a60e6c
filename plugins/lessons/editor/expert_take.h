#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/io/autosave.h"
#include "ew/sdk/host.h"
#include "logic/expert_recorder.h"

namespace ew::lessons {

/// The expert's scan that is being recorded for one step of the open case. When another case is opened it pauses, and goes on in its own;
/// when the case is saved elsewhere it goes on there.
class ExpertTake final : public QObject {
  Q_OBJECT

 public:
  explicit ExpertTake(sdk::Host& host, QObject* parent = nullptr);

  /// @param title of what is scanned, as trainees may read it @error badUsage (nothing is scanned)
  [[nodiscard]] Result<void> start(const std::string& lessonId, const std::string& stepId, const std::string& caseId,
                                   const std::string& title);
  [[nodiscard]] bool isRecording() const { return recorder_.isRecording(); }
  [[nodiscard]] bool isPaused() const { return recorder_.isPaused(); }
  /// Whether what is recorded is for this step of the case that is open.
  [[nodiscard]] bool isFor(const std::string& lessonId, const std::string& stepId) const;
  /// Whether it is for a step of the case that is open.
  [[nodiscard]] bool isOfOpenCase() const;
  [[nodiscard]] const std::string& lessonId() const { return lessonId_; }
  [[nodiscard]] const std::string& stepId() const { return stepId_; }
  [[nodiscard]] double length_s() const;
  [[nodiscard]] std::size_t markCount() const { return recorder_.marks_s().size(); }
  void pause();
  void goOn();
  void mark();
  /// Pauses it and gives what was recorded, which stays here until it is discarded. @param marks_s moments that were marked, on the
  /// recording's clock @error as ExpertRecorder::stop
  [[nodiscard]] Result<ScanRecording> stop(std::vector<double>& marks_s);
  void discard();
  /// Meanwhile it is written: it can be neither gone on with nor written once more.
  void setKeeping(bool keeping);
  [[nodiscard]] bool isKeeping() const { return keeping_; }

 Q_SIGNALS:
  void changed();  ///< begun, paused, ended, or some time longer
  void full();     ///< it is as long as it may be: it has been paused

 private:
  void followCase(const std::filesystem::path& folder);
  void tick();
  void keep();
  void describe();
  void forgetKept();

  sdk::Host& host_;
  ExpertRecorder recorder_;
  Autosave kept_;                 ///< what is recorded, against a crash
  std::size_t events_ = 0;        ///< so many are kept
  std::string title_;             ///< of what is scanned
  std::filesystem::path folder_;  ///< of the case it is for
  std::filesystem::path open_;    ///< of the case that is open
  std::string lessonId_, stepId_;
  bool keeping_ = false;
  QTimer timer_;
  std::vector<sdk::Ticket> tickets_;
};

}  // namespace ew::lessons
