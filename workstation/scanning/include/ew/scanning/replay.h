#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ew/scanning/recording.h"
#include "ew/scanning/scanner.h"

namespace ew {

/// Makes the images of a recording again. The same subject, recording and size give the same pixels on every machine and with every number
/// of threads, as long as images follow one another from the first; after a jump the images before the one that is asked for are made again
/// as far as they still show in it, which may differ by a grey level where persistence mixes them.
class Replay {
 public:
  /// @param log at least one frame; must outlive the replay
  /// @param threads as of Scanner
  Replay(const ScanLog& log, ScanSubject subject, int threads = 1);

  /// The n-th image; its views stay valid until the next one.
  DisplayImage make(std::size_t frame, int width_px, int height_px);
  [[nodiscard]] const Scanner& scanner() const { return scanner_; }

  /// How many images before the n-th still show in it: those that persistence has not yet brought below half a grey level, or that stand
  /// in the strip of the M-mode.
  [[nodiscard]] static std::size_t history(const ScanLog& log, std::size_t frame);

 private:
  const ScanLog& log_;
  Scanner scanner_;
  std::optional<std::size_t> last_;
};

}  // namespace ew
