#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "../comparable.h"
#include "ew/core/progress.h"

namespace ew::registration {

/// One agreement found by the search over all translations at one rotation.
struct Coarse {
  Transform<frame::Moving, frame::Fixed> fixedToMoving;
  double score = 0.0;  ///< correlation times the root of the overlap's cells
  double correlation = 0.0;
  double overlapCells = 0.0;
};

struct TranslationOptions {
  double leastOverlap = 0.08;  ///< of the smaller side
  int peaks = 3;               ///< per rotation
  int threads = 0;
  glm::dmat3 base{1.0};  ///< fixed to moving: what the rotations start from
};

/// Rotation vectors (rad) that cover every turn up to `most` about as densely as a cubic lattice of `step` does, the identity first.
/// Ours is a body-centred lattice, which needs half the points for the same largest gap.
[[nodiscard]] std::vector<glm::dvec3> rotationLattice(double most_rad, double step_rad);

/// For every turn, masked correlation of `fixed` with the turned `moving` over all translations by Fourier transform.
/// @return peaks of all rotations, best first; empty when cancelled
[[nodiscard]] std::vector<Coarse> correlateOverTranslations(const ComparableImage& fixed, const ComparableImage& moving,
                                                            const std::vector<glm::dvec3>& turns, const TranslationOptions& options,
                                                            Progress& progress);

/// Memory that takes, per call and per thread.
[[nodiscard]] std::uint64_t forecastTranslations_bytes(const Grid& fixed, const Grid& moving, int threads, std::size_t turns);

}  // namespace ew::registration
