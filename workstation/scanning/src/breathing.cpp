#include "ew/scanning/breathing.h"

#include <algorithm>

namespace ew {
namespace {

constexpr double kTransition_s = 1.5;

}  // namespace

void BreathControl::ask(BreathingRequest request, const BodyRhythms& rhythms, double time_s) {
  from_ = at(rhythms, time_s).breath;
  asked_ = request;
  askedAt_s_ = time_s;
}

BodyState BreathControl::at(const BodyRhythms& rhythms, double time_s) const {
  BodyState body = bodyAt(rhythms, time_s);
  if (!rhythms.breathing) return body;
  if (asked_ != BreathingRequest::free) body.breath = asked_ == BreathingRequest::breatheInAndHold ? 1.0 : 0.0;
  const double t = std::clamp((time_s - askedAt_s_) / kTransition_s, 0.0, 1.0);
  const double share = t * t * (3.0 - 2.0 * t);
  body.breath = share < 1.0 ? from_ + share * (body.breath - from_) : body.breath;
  return body;
}

bool BreathControl::movesAfter(const BodyRhythms& rhythms, double time_s) const {
  if (rhythms.pulse || rhythms.bowel) return true;
  return rhythms.breathing && (asked_ == BreathingRequest::free || time_s < askedAt_s_ + kTransition_s);
}

}  // namespace ew
