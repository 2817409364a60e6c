#include "ew/registration/verdict.h"

namespace ew::registration {

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::aligned:
      return "aligned";
    case Verdict::notAligned:
      return "not aligned";
    case Verdict::cannotTell:
      return "cannot tell";
  }
  return "cannot tell";
}

const char* nameOf(StopReason reason) {
  switch (reason) {
    case StopReason::notRun:
      return "not run";
    case StopReason::converged:
      return "converged";
    case StopReason::iterationLimit:
      return "iteration limit";
    case StopReason::timeLimit:
      return "time limit";
    case StopReason::noImprovement:
      return "no improvement";
    case StopReason::singular:
      return "singular";
    case StopReason::noOverlap:
      return "no overlap";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "not run";
}

}  // namespace ew::registration
