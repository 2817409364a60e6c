#pragma once

#include <cstddef>

namespace ew::testing {

/// How often the program asked for memory with `new` so far; a test says with it that a piece of work allocates nothing.
std::size_t allocationCount();

}  // namespace ew::testing
