#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

#include "ew/cli/run_command.h"
#include "ew/core/progress.h"

namespace ew::cli {

/// Progress on the error stream: a bar that is redrawn on a terminal, otherwise a plain line whenever a new step begins and at every
/// tenth of the whole; nothing when quiet.
class ConsoleProgress final : public Progress {
 public:
  ConsoleProgress(const Surroundings& surroundings, bool quiet) : surroundings_(surroundings), quiet_(quiet) {}
  ~ConsoleProgress() override;

  void report(const Message& what, double fraction) override;
  [[nodiscard]] bool cancelRequested() const override;

  /// Removes the bar, so that a message starts on an empty line.
  void clear();

 private:
  void drawBar(double fraction);
  void writeLine(double fraction);

  Surroundings surroundings_;
  bool quiet_;
  std::mutex mutex_;
  Message what_;
  int shownTenth_ = -1;
  double fraction_ = 0.0;  ///< the furthest so far
  bool barShown_ = false;
  std::chrono::steady_clock::time_point lastDrawn_{};
};

}  // namespace ew::cli
