#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ew/tracking/tool_reading.h"

namespace ew::tracking {

/// A reading of one tool with its moment on our clock.
struct Stamped {
  double measured_s = 0.0;
  ToolReading reading;
};

/// Says when a tracker sends one and the same reading for longer than a frozen device may pass as a still one. The same stamp again is
/// proof. The same numbers under new stamps are none by themselves: a recording, a simulated tracker or one that rounds does so when it
/// rests. They count for a source alone that was seen to have noise of its own (steps that turn back, as white noise's do) and to repeat
/// itself so seldom that a row like this one comes by chance in one of a thousand million.
class FreezeDetector {
 public:
  void add(const ToolReading& reading);
  /// @param after_s how long it has to go on
  [[nodiscard]] bool isFrozen(double after_s) const;
  /// The latest reading says nothing that an earlier one did not.

 private:
  void learn(const ToolReading& reading);
  std::optional<ToolReading> before_;
  glm::dvec3 step_mm_{0.0};
  double turnsBack_ = 0.0;  ///< smoothed cosine of steps with the one before
  int steps_ = 0;
  bool isNoisy_ = false;
  double repeats_ = 0.0;  ///< share of readings that repeated the one before, while nothing was frozen
  int sameStamp_ = 0, sameNumbers_ = 0;
  double stampSince_s_ = 0.0, numbersSince_s_ = 0.0, latest_s_ = 0.0;
};

/// Brings readings of a tool together with those of the reference of the same moment: toolToReference.
class ReferencePairing {
 public:
  void add(const Stamped& reading, bool isReference);
  /// The tool's readings whose reference is known by now, in the reference's frame, oldest first. The state of one whose reference is not
  /// live is that of the reference.
  /// @param staleAfter_s a reference that was seen no longer ago counts as standing where it stood: a hand covers it for a moment
  [[nodiscard]] std::vector<Stamped> take(double now_s, bool needsReference, double staleAfter_s);
  [[nodiscard]] const std::optional<Stamped>& latestReference() const { return latestReference_; }
  void reset() { *this = {}; }

 private:
  [[nodiscard]] std::optional<Transform<frame::Tracker, frame::Tool>> referenceAt(double measured_s, double staleAfter_s) const;
  std::deque<Stamped> tools_, references_;
  std::optional<Stamped> latestReference_;  ///< whatever its state
};

}  // namespace ew::tracking
