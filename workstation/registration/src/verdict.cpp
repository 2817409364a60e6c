#include "ew/registration/verdict.h"

#include "ew/core/word_table.h"

namespace ew::registration {

constexpr WordTable<Verdict, 3> kVerdictWords{
    {{"aligned", Verdict::aligned}, {"not aligned", Verdict::notAligned}, {"cannot tell", Verdict::cannotTell}}};
const char* nameOf(Verdict verdict) { return wordIn(kVerdictWords, verdict); }

constexpr WordTable<StopReason, 8> kStopReasonWords{{{"not run", StopReason::notRun},
                                                     {"converged", StopReason::converged},
                                                     {"iteration limit", StopReason::iterationLimit},
                                                     {"time limit", StopReason::timeLimit},
                                                     {"no improvement", StopReason::noImprovement},
                                                     {"singular", StopReason::singular},
                                                     {"no overlap", StopReason::noOverlap},
                                                     {"cancelled", StopReason::cancelled}}};
const char* nameOf(StopReason reason) { return wordIn(kStopReasonWords, reason); }

}  // namespace ew::registration
