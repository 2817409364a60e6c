#include "ew/core/word_table.h"

namespace ew::rules {

enum class Verdict { passed, failed, handedIn };
constexpr WordTable<Verdict, 2> kVerdictWords{{{"passed", Verdict::passed}, {"failed", Verdict::failed}}};

/// Compiled by the test UnhandledWord alone, which wants an error.
const char* wordOf(Verdict verdict) { return wordIn(kVerdictWords, verdict); }

}  // namespace ew::rules
