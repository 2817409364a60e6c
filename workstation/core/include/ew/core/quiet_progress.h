#pragma once

#include "ew/core/progress.h"

namespace ew {

/// Passes the wish to cancel on, and no reports: those of a part that is done again and again would move backwards.
class QuietProgress final : public Progress {
 public:
  explicit QuietProgress(const Progress& whole) : whole_(whole) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

 private:
  const Progress& whole_;
};

}  // namespace ew
