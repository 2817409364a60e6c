#pragma once

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/core/result.h"

namespace ew::phantom {

// What may go wrong where voxels are made of a patient, whole or in part.

[[nodiscard]] inline tl::unexpected<Error> stoppedByUser() {
  return failure(ErrorCode::cancelled, say<"Building the virtual patient was stopped.">());
}

[[nodiscard]] inline tl::unexpected<Error> tooLargeAt(double spacing_mm, std::uint64_t maxBytes, double forecast_bytes) {
  return failure(ErrorCode::tooLarge,
                 say<"This patient at %1 mm needs %2 of memory, %3 are allowed; choose a coarser spacing.">(
                     textOf(spacing_mm), mebibytesText(forecast_bytes), mebibytesText(static_cast<double>(maxBytes))),
                 {{"forecast_bytes", textOf(forecast_bytes)}});
}

[[nodiscard]] inline Result<void> checkVoxelSpacing(double spacing_mm) {
  if (spacing_mm >= 0.01 && spacing_mm <= 1000.0) return {};
  return failure(ErrorCode::badField, say<"The voxel spacing is %1 mm; choose one from 0.01 to 1000 mm.">(textOf(spacing_mm)),
                 {{"field", "spacing_mm"}});
}

}  // namespace ew::phantom
