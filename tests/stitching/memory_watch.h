#pragma once

#include <malloc.h>

#include <fstream>
#include <string>

namespace ew::test {

/// What this process takes more than when the watch was made: its own memory, not the pages of its program's files. Known on Linux alone.
class MemoryWatch {
 public:
  MemoryWatch() {
    malloc_trim(0);
    before_mib_ = own_mib("VmRSS");
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    known_ = false;  // the sanitizers keep what is freed, and shadows of it
#else
    known_ = forgetPeak() && before_mib_ > 0.0;
#endif
  }
  [[nodiscard]] bool isKnown() const { return known_; }
  /// Since the watch was made or the peak was forgotten.
  [[nodiscard]] double peak_mib() const { return own_mib("VmHWM") - before_mib_; }
  [[nodiscard]] double now_mib() const { return own_mib("VmRSS") - before_mib_; }
  /// The peak begins anew. @return whether it can be forgotten here
  bool forgetPeak() {
    std::ofstream out("/proc/self/clear_refs");
    out << "5";
    return static_cast<bool>(out.flush());
  }

 private:
  static double line_mib(const std::string& what) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
      if (line.starts_with(what + ":")) return std::stod(line.substr(what.size() + 1)) / 1024.0;
    return 0.0;
  }
  static double own_mib(const std::string& what) { return line_mib(what) - line_mib("RssFile"); }

  double before_mib_ = 0.0;
  bool known_ = false;
};

}  // namespace ew::test
