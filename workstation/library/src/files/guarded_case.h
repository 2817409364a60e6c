#pragma once

#include <exception>
#include <filesystem>
#include <new>
#include <type_traits>

#include "ew/core/result.h"

namespace ew {

/// What `work` returns, a Result; what a library throws in it becomes an Error about the case. For doors through which the window's own
/// thread comes: an exception there would end the program, and unsaved work with it.
template <class Work>
[[nodiscard]] std::invoke_result_t<const Work&> guardedCase(const std::filesystem::path& folder, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge,
                   say<"The case '%1' needs more memory than there is; close other programs or take a smaller one.">(folder));
  } catch (const std::exception& thrown) {
    return failure(ErrorCode::internal,
                   say<"The case '%1' holds something the program did not foresee (%2); check its files, and please report it.">(
                       folder, verbatim(thrown.what())));
  }
}

}  // namespace ew
