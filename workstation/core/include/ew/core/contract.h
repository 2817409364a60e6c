#pragma once

#include <cstdio>
#include <cstdlib>

/// States what a caller must guarantee. A violation is a caller's bug: it stops development, test and sanitizer runs with the
/// place and the broken expectation; release builds do not evaluate it. What the outside world may get wrong is an Error instead.
#ifdef EW_CHECK_CONTRACTS
#define EW_EXPECTS(condition)                                                               \
  do {                                                                                      \
    if (!(condition)) {                                                                     \
      std::fprintf(stderr, "%s:%d: contract broken: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                         \
    }                                                                                       \
  } while (false)
#else
#define EW_EXPECTS(condition) static_cast<void>(0)
#endif
