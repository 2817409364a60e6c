#include "imaging/support/count_allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

// In a file of its own: inlined into a caller, GCC 12 takes the free below for a mismatch with the library's operator new.

namespace {
std::atomic<std::size_t> allocations{0};
}

namespace ew::testing {
std::size_t allocationCount() { return allocations; }
}  // namespace ew::testing

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
