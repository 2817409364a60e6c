namespace ew::rules {

enum class Verdict { passed, failed, handedIn };

/// Compiled by the test UnhandledEnumerator alone, which wants an error.
const char* wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::failed:
      return "failed";
  }
  return "";
}

}  // namespace ew::rules
