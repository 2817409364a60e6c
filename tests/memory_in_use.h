#pragma once
#include <malloc.h>

#include <cstddef>
#include <cstdint>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // sanitizer/allocator_interface.h, which GCC's package leaves out
#endif

namespace ew::test {

/// What the program holds of memory from its allocator now, in bytes. The sanitizers bring an allocator of their own, of which the
/// C library's count knows nothing.
inline std::uint64_t memoryInUse_bytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return __sanitizer_get_current_allocated_bytes();
#else
  const auto now = mallinfo2();
  return now.uordblks + now.hblkhd;
#endif
}

}  // namespace ew::test
