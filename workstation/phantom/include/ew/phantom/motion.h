#pragma once

#include <memory>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/tissue_motion.h"
#include "ew/phantom/deformation.h"
#include "ew/phantom/patient.h"

namespace ew {

/// Whether the recipe describes any motion.
[[nodiscard]] bool moves(const Patient& patient);

/// The rhythms of a recipe; what it does not describe has none.
[[nodiscard]] BodyRhythms rhythmsOf(const Patient& patient);

/// Breath, pulse and bowel at a time, from the recipe's rhythms; the same time gives the same state.
[[nodiscard]] BodyState stateAt(const Patient& patient, double time_s);

/// Electrocardiogram at a time, mV: R peaks of 1 mV at the beginning of each beat, with P and T waves. Constant 0 without a pulse.
[[nodiscard]] double ecgAt_mv(const Patient& patient, double time_s);

/// The body's own motion as displacement of its tissue: breathing moves organs along and against the spine, the pulse widens vessels about
/// their centre lines and pushes what surrounds them, less with distance; chambers of the heart narrow and draw what surrounds them along.
/// The gut's own waves are left out: no sweep asks for them. The patient must outlive the result.
[[nodiscard]] std::unique_ptr<Deformation> bodyMotion(const Patient& patient, const BodyState& state);

/// The same and the gut's waves as fields on grids, for echoes that are formed live: breath every 6 mm, each vessel and chamber every 1
/// to 2.5 mm as it is thin, the gut every 4 mm. Breath alone is bodyMotion's to 0.01 mm; a pulse alone is right within 7 % of the growth of
/// the diameter, or of the way of a chamber's wall, at the wall, where it has a kink. Null when the patient does not move.
/// @error cancelled
[[nodiscard]] Result<std::shared_ptr<TissueMotion>> tissueMotionOf(const Patient& patient, int threads, Progress& progress);

}  // namespace ew
