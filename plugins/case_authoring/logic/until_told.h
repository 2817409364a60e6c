#pragma once

#include <atomic>

#include "ew/core/progress.h"

namespace ew::case_authoring {

/// Goes on until the job, or somebody at the panel, has enough.
class UntilTold final : public Progress {
 public:
  UntilTold(Progress& progress, const std::atomic<bool>& stop) : progress_(progress), stop_(stop) {}
  void report(const Message& what, double fraction) override { progress_.report(what, fraction); }
  [[nodiscard]] bool cancelRequested() const override { return stop_.load() || progress_.cancelRequested(); }

 private:
  Progress& progress_;
  const std::atomic<bool>& stop_;
};

}  // namespace ew::case_authoring
