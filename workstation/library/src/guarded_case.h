#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>

#include "ew/core/result.h"

namespace ew {

/// What `work` returns, a Result; what a library throws in it becomes an Error about `what` ("The case 'x'"). For doors through which the
/// window's own thread comes: an exception there would end the program, and unsaved work with it.
template <class Work>
[[nodiscard]] std::invoke_result_t<const Work&> guardedCase(const std::string& what, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge, what + " needs more memory than there is; close other programs or take a smaller one.");
  } catch (const std::exception& thrown) {
    return failure(ErrorCode::internal,
                   what + " holds something the program did not foresee (" + thrown.what() + "); check its files, and please report it.");
  }
}

}  // namespace ew
