#pragma once

#ifndef EW_TEST_SLOWDOWN
#define EW_TEST_SLOWDOWN 1
#endif

namespace ew::test {

/// How many times longer than the plain build a test may take: 1, except under sanitizers, where cmake/EwSanitizers.cmake sets it.
inline constexpr double kSlowdown = EW_TEST_SLOWDOWN;

/// How long a test waits for something that has to happen before it says that it hangs. It limits nothing else: a machine may be busy with
/// other things for minutes, and what a test is about does not depend on how fast one is.
inline constexpr double kPatience_ms = 240000.0 * kSlowdown;

}  // namespace ew::test
