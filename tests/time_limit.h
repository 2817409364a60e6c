#pragma once

#ifndef EW_TEST_SLOWDOWN
#define EW_TEST_SLOWDOWN 1
#endif

namespace ew::test {

/// How many times longer than the plain build a test may take: 1, except under sanitizers, where cmake/EwSanitizers.cmake sets it.
inline constexpr double kSlowdown = EW_TEST_SLOWDOWN;

}  // namespace ew::test
