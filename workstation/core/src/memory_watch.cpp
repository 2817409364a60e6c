#include "ew/core/memory_watch.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <string>
#include <string_view>

#include "ew/core/freed_memory.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

double statusLine_mib(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(name) || line.size() <= name.size() || line[name.size()] != ':') continue;
    const std::string_view rest = std::string_view(line).substr(name.size() + 1);
    if (const auto kibibytes = parseNumber(rest.substr(0, rest.find("kB")))) return *kibibytes / 1024.0;
  }
  return 0.0;
}

std::atomic<double> forgottenPeak_mib = 0.0;  ///< what peakMemory_mib still knows

double own_mib(std::string_view name) { return statusLine_mib(name) - statusLine_mib("RssFile"); }

}  // namespace

// getrusage's figure survives exec, so a large parent would be reported as ours; the high water mark of the address space is not.
double peakMemory_mib() { return std::max(forgottenPeak_mib.load(), statusLine_mib("VmHWM")); }

MemoryWatch::MemoryWatch() {
  giveFreedMemoryBack();
  before_mib_ = own_mib("VmRSS");
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  isKnown_ = forgetPeak() && before_mib_ > 0.0;
#endif
}

double MemoryWatch::peak_mib() const { return own_mib("VmHWM") - before_mib_; }

double MemoryWatch::now_mib() const { return own_mib("VmRSS") - before_mib_; }

double MemoryWatch::held_mib() const {
  giveFreedMemoryBack();
  return now_mib();
}

bool MemoryWatch::forgetPeak() {
  forgottenPeak_mib = peakMemory_mib();
  std::ofstream out("/proc/self/clear_refs");
  out << "5";
  return static_cast<bool>(out.flush());
}

}  // namespace ew
