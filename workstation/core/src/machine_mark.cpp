#include "ew/core/machine_mark.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>

namespace ew {
namespace {

std::string lineOfFile(const char* file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// FNV-1a.
std::string digitsOf(const std::string& text) {
  std::uint32_t hash = 2166136261u;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  std::array<char, 9> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", hash);
  return digits.data();
}

}  // namespace

const std::string& machineMark() {
  static const std::string mark = [] {
    std::array<char, 256> host{}, processes{};
    ::gethostname(host.data(), host.size() - 1);
    static_cast<void>(::readlink("/proc/self/ns/pid", processes.data(), processes.size() - 1));
    return digitsOf(std::string(host.data()) + '\n' + processes.data() + '\n' + lineOfFile("/etc/machine-id") + '\n' +
                    lineOfFile("/proc/sys/kernel/random/boot_id"));
  }();
  return mark;
}

bool isProcessThere(pid_t process) { return process > 0 && (::kill(process, 0) == 0 || errno != ESRCH); }

}  // namespace ew
