#pragma once

#include <cstddef>
#include <functional>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::stitching {

/// Does pieces of work that know nothing of each other, up to `atOnce` beside each other, begun in the order of their numbers. The whole
/// progresses as the pieces do on average.
/// @param work work(n, progress); called on up to `atOnce` threads, of which the caller's is one
/// @error that of the piece with the lowest number that failed, which stops the others; cancelled
[[nodiscard]] Result<void> runConcurrently(std::size_t pieces, int atOnce, Progress& progress,
                                           const std::function<Result<void>(std::size_t n, Progress& progress)>& work);

}  // namespace ew::stitching
