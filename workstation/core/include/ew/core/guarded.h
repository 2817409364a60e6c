#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "ew/core/result.h"

namespace ew {

/// What code threw that should not have.
struct Thrown {
  bool noMemory = false;  ///< std::bad_alloc: the work was too large, nobody made a mistake
  Message reason;         ///< what(), in one line of at most 300 bytes; "no reason was given" when it said nothing or was no std::exception
};

/// Of the exception that is being handled: to be called in a catch clause. Throws nothing but std::bad_alloc.
[[nodiscard]] Thrown thrownNow();

namespace detail {
template <class T>
struct ResultOf {
  using Type = Result<T>;
};
template <class T>
struct ResultOf<Result<T>> {
  using Type = Result<T>;
};
}  // namespace detail

/// Calls `work`; whatever it throws, a number as well as a std::exception, becomes the Error that `errorOf(const Thrown&)` makes of it. The
/// one place where the program stops exceptions of code it cannot trust: plugins, work on other threads, handlers of the window's events.
/// @return what `work` returned, as a Result unless it is one
template <class Work, class ErrorOf>
auto guarded(Work&& work, ErrorOf&& errorOf) -> typename detail::ResultOf<std::invoke_result_t<Work&&>>::Type {
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<Work&&>>) {
      std::forward<Work>(work)();
      return {};
    } else {
      return std::forward<Work>(work)();
    }
  } catch (...) {
    return passOn(std::forward<ErrorOf>(errorOf)(thrownNow()));
  }
}

}  // namespace ew
