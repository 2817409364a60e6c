#pragma once

#include <cstddef>
#include <functional>

#include "ew/core/progress.h"

namespace ew::stitching {

/// Runs `body(index)` for every index below `count` on `threads` threads (0: all cores), the caller's among them, which also reports.
/// Bodies must not depend on each other. Exceptions of a body are passed to the caller once all threads have stopped.
/// @return false when it was cancelled; some bodies have not run then
bool forEachIndex(std::size_t count, int threads, const char* what, Progress& progress, const std::function<void(std::size_t)>& body);

}  // namespace ew::stitching
