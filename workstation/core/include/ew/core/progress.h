#pragma once

#include "ew/core/message.h"

namespace ew {

/// How long work talks to whoever waits for it. Called from the working thread; an implementation must be safe to call from any.
/// Work polls cancelRequested() at least every 100 ms, then returns an Error with ErrorCode::cancelled and leaves nothing half done.
class Progress {
 public:
  virtual ~Progress();
  /// @param what     the step in the user's words (say<"Reading frames">()); may repeat
  /// @param fraction of the whole work, 0..1; never moves backwards
  virtual void report(const Message& what, double fraction) = 0;
  [[nodiscard]] virtual bool cancelRequested() const = 0;
};

/// For callers that wait in silence and never cancel.
Progress& noProgress();

/// Maps a part of the work onto [begin, end] of the whole.
class PartOfProgress final : public Progress {
 public:
  PartOfProgress(Progress& whole, double begin, double end) : whole_(whole), begin_(begin), end_(end) {}
  void report(const Message& what, double fraction) override { whole_.report(what, begin_ + (end_ - begin_) * fraction); }
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

 private:
  Progress& whole_;
  double begin_;
  double end_;
};

}  // namespace ew
