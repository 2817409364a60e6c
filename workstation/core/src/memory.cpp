#include "ew/core/memory.h"

#include <fstream>
#include <string>

#include "ew/core/freed_memory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace ew {

std::optional<std::uint64_t> availableMemory_bytes() {
  std::ifstream table("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  std::string unit;
  while (table >> name >> kibibytes) {
    std::getline(table, unit);
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return std::nullopt;
}

void giveFreedMemoryBack() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace ew
