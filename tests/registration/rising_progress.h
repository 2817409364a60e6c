#pragma once

#include <atomic>
#include <mutex>

#include "ew/core/progress.h"

namespace ew::test {

/// Counts reports that lie before an earlier one.
class RisingProgress final : public Progress {
 public:
  void report(const Message&, double fraction) override {
    const std::lock_guard lock(guard_);
    if (fraction < last_ || fraction > 1.0) ++backwards_;
    last_ = fraction;
    ++reports_;
  }
  [[nodiscard]] bool cancelRequested() const override { return false; }
  [[nodiscard]] int backwards() const { return backwards_; }
  [[nodiscard]] int reports() const { return reports_; }
  [[nodiscard]] double last() const { return last_; }

 private:
  std::mutex guard_;
  double last_ = 0.0;
  int backwards_ = 0;
  int reports_ = 0;
};

}  // namespace ew::test
