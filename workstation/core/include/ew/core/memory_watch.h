#pragma once

namespace ew {

/// The most memory this process has taken since it began, the pages of its files with it, in MiB; 0 where the system does not say.
[[nodiscard]] double peakMemory_mib();

/// What this process takes more than when the watch was made: its own memory, not the pages of files. One at a time, for the system keeps
/// one peak for all of it.
class MemoryWatch {
 public:
  MemoryWatch();
  /// The system tells, and no sanitizer keeps what was freed.
  [[nodiscard]] bool isKnown() const { return isKnown_; }
  /// Since the watch was made or the peak was forgotten, in MiB.
  [[nodiscard]] double peak_mib() const;
  [[nodiscard]] double now_mib() const;  ///< in MiB, with what was freed and not given back
  /// Gives back what was freed, then tells what is left, in MiB.
  [[nodiscard]] double held_mib() const;
  /// The watch's peak begins anew. @return whether it can be forgotten here
  bool forgetPeak();

 private:
  double before_mib_ = 0.0;
  bool isKnown_ = false;
};

}  // namespace ew
