#pragma once

#include <string>
#include <string_view>

#include "ew/core/result.h"

namespace ew {

/// Makes the kernels of all libraries run on an instruction set: "avx3" (AVX-512), "avx2", "sse4", "scalar" (plain code), or "best" (empty
/// means the same), the best one this processor has. For the whole process, threads that already work included; images are the same on
/// each. Libraries of others (VTK, OpenCV, Ceres) choose for themselves.
/// @error badUsage: another word, or an instruction set that this processor lacks
[[nodiscard]] Result<void> useSimd(std::string_view word);

/// The word of the instruction set in use: "avx3", "avx2", "sse4", "scalar", or "other" on processors with other names for theirs.
[[nodiscard]] std::string simdInUse();

/// That of "best".
[[nodiscard]] std::string bestSimd();

/// What the system calls this processor, such as "AMD EPYC".
[[nodiscard]] std::string processorName();

/// What the environment asks for: ECHOWEAVE_SIMD, or nothing.
[[nodiscard]] std::string simdOfEnvironment();

}  // namespace ew
