#include "chain/concurrent.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

#include "ew/core/parallel.h"

namespace ew::stitching {
namespace {

/// The progress of all pieces together.
class Together {
 public:
  Together(Progress& whole, std::size_t pieces) : whole_(whole), done_(pieces, 0.0) {}
  void report(std::size_t piece, const Message& what, double fraction) {
    const std::lock_guard lock(guard_);
    done_[piece] = std::max(done_[piece], fraction);
    double sum = 0.0;
    for (const double each : done_) sum += each;
    whole_.report(what, sum / static_cast<double>(done_.size()));
  }
  void finish(std::size_t piece) {
    const std::lock_guard lock(guard_);
    done_[piece] = 1.0;
  }
  void stop() { stopped_ = true; }
  [[nodiscard]] bool cancelRequested() const { return stopped_ || whole_.cancelRequested(); }

 private:
  Progress& whole_;
  std::mutex guard_;
  std::vector<double> done_;
  std::atomic<bool> stopped_{false};
};

class PieceProgress final : public Progress {
 public:
  PieceProgress(Together& together, std::size_t piece) : together_(together), piece_(piece) {}
  void report(const Message& what, double fraction) override { together_.report(piece_, what, fraction); }
  [[nodiscard]] bool cancelRequested() const override { return together_.cancelRequested(); }

 private:
  Together& together_;
  std::size_t piece_;
};

/// What counts pieces has nothing to say: they speak for themselves.
class Counting final : public Progress {
 public:
  explicit Counting(const Together& together) : together_(together) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return together_.cancelRequested(); }

 private:
  const Together& together_;
};

}  // namespace

Result<void> runConcurrently(std::size_t pieces, int atOnce, Progress& progress,
                             const std::function<Result<void>(std::size_t n, Progress& progress)>& work) {
  Together together(progress, pieces);
  Counting counting(together);
  std::vector<std::optional<Error>> failed(pieces);
  const bool all = forEachTask(static_cast<int>(pieces), std::max(atOnce, 1), counting, Message(), [&](int task) {
    const auto n = static_cast<std::size_t>(task);
    PieceProgress own(together, n);
    auto done = work(n, own);
    if (done) {
      together.finish(n);
      return;
    }
    failed[n] = done.error();
    together.stop();
  });
  // Those that were stopped by another's failure say that they were cancelled.
  for (const auto& problem : failed)
    if (problem && problem->code != ErrorCode::cancelled) return passOn(*problem);
  for (const auto& problem : failed)
    if (problem) return passOn(*problem);
  if (!all) return failure(ErrorCode::cancelled, say<"The stitching was cancelled.">());
  return {};
}

}  // namespace ew::stitching
