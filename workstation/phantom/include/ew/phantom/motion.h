#pragma once

#include <memory>

#include "ew/phantom/deformation.h"
#include "ew/phantom/patient.h"

namespace ew {

/// Where breath and pulse stand at a moment.
struct BodyState {
  double breath = 0.0;  ///< 0: end of expiration, where the recipe draws the body; 1: the recipe's full inspiration
  double pulse = 0.0;   ///< 0: end of diastole, as wide as the recipe draws the vessels; 1: as wide as they get
  bool operator==(const BodyState&) const = default;
};

/// Whether the recipe describes any motion.
[[nodiscard]] bool moves(const Patient& patient);

/// Breath and pulse at a time, from the recipe's rhythms; the same time gives the same state.
[[nodiscard]] BodyState stateAt(const Patient& patient, double time_s);

/// Electrocardiogram at a time, mV: R peaks of 1 mV at the beginning of each beat, with P and T waves. Constant 0 without a pulse.
[[nodiscard]] double ecgAt_mv(const Patient& patient, double time_s);

/// The body's own motion as displacement of its tissue: breathing moves organs along and against the spine, the pulse widens vessels about
/// their centre lines and pushes what surrounds them, less with distance. The patient must outlive the result.
[[nodiscard]] std::unique_ptr<Deformation> bodyMotion(const Patient& patient, const BodyState& state);

}  // namespace ew
