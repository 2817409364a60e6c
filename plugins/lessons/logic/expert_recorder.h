#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/scanning/recording.h"

namespace ew::lessons {

/// How long an expert's scan may be: longer than anybody watches at a stretch, and a few megabytes.
inline constexpr double kLongestExpertScan_s = 300.0;

/// The expert's scan while an author makes it. Its own clock starts at 0 and stands while it is paused; the scan's clock comes in as
/// `now_s`. No clock and no file of its own.
class ExpertRecorder {
 public:
  /// Begins a new one. @param caseId of the case that is scanned @param title as trainees may read it
  void start(std::string caseId, std::string title, double now_s);
  [[nodiscard]] bool isRecording() const { return running_; }
  [[nodiscard]] bool isPaused() const { return running_ && !since_s_; }
  void pause(double now_s);
  void goOn(double now_s);

  /// Every image of the scan and what happens in it. Nothing is taken while it is paused, frozen or full.
  /// @param size_px of the image
  void see(const ScanEvent& event, const std::optional<ScanState>& image, glm::ivec2 size_px);
  /// Of the recording, 0 when it has just begun.
  [[nodiscard]] double length_s(double now_s) const;
  [[nodiscard]] bool isFull(double now_s) const { return length_s(now_s) >= kLongestExpertScan_s; }
  /// Remembers the present moment, to be described afterwards.
  void mark(double now_s);
  [[nodiscard]] const std::vector<double>& marks_s() const { return marks_s_; }  ///< on the recording's clock
  /// What is recorded so far.
  [[nodiscard]] const ScanRecording& growing() const { return recording_; }
  [[nodiscard]] const std::string& caseId() const { return recording_.caseId; }

  /// Pauses it and gives what was recorded. It stays here as well, and can be gone on with, until it is discarded: whoever writes it may
  /// fail. @error badUsage: nothing was seen, and there is nothing to keep
  [[nodiscard]] Result<ScanRecording> stop(double now_s);
  void discard();

 private:
  ScanRecording recording_;
  bool running_ = false;
  std::optional<double> since_s_;  ///< on the scan's clock; empty while paused
  double before_s_ = 0.0;          ///< recorded before `since_s_`
  std::vector<double> marks_s_;
};

/// Puts a recording into the section's folder under a name of its content, "scans/0123456789abcdef.seq.mha": the file is complete or not
/// there, and none is ever written over, so that what a step or a step of undo names stays what it was.
/// @param partFolder parts/lessons of the case; it need not be there yet
/// @return the name, relative to partFolder
/// @error as writeRecording, notWritable
[[nodiscard]] Result<std::string> keepRecording(const ScanRecording& recording, const std::filesystem::path& partFolder,
                                                Progress& progress = noProgress());

/// The same with any bytes, as "FOLDER/0123456789abcdefENDING". @error notWritable
[[nodiscard]] Result<std::string> keepBytes(std::string_view bytes, const std::filesystem::path& partFolder, std::string_view folder,
                                            std::string_view ending);

}  // namespace ew::lessons
