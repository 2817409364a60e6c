#pragma once

#include "ew/imaging/tissue_motion.h"

namespace ew {

/// What a patient is asked to do with the breath.
enum class BreathingRequest { free, breatheInAndHold, breatheOutAndHold };

/// A patient who breathes as asked. A value without a clock: whoever has one says when.
class BreathControl {
 public:
  /// From `time_s` on. Within 1.5 s the breath goes smoothly from where it is to where it is asked to be.
  void ask(BreathingRequest request, const BodyRhythms& rhythms, double time_s);
  [[nodiscard]] BreathingRequest asked() const { return asked_; }
  /// Pulse and bowel go on whatever is asked.
  [[nodiscard]] BodyState at(const BodyRhythms& rhythms, double time_s) const;
  /// Whether the body moves after this moment: it always does with a pulse or a bowel.
  [[nodiscard]] bool movesAfter(const BodyRhythms& rhythms, double time_s) const;
  bool operator==(const BreathControl&) const = default;

 private:
  BreathingRequest asked_ = BreathingRequest::free;
  double askedAt_s_ = -1e9;
  double from_ = 0.0;  ///< the breath when it was asked
};

}  // namespace ew
