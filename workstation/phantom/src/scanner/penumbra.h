#pragma once

#include <vector>

#include "scanner/scanner_setup.h"

namespace ew::phantom {

/// What is left of the echoes of a plane when every part of the aperture sends and hears along its own rays: the shadow of a thing before
/// the focus has soft sides, and none of its own behind a thing much narrower than the aperture.
///   gain(l, z) = (mean over u of 10^(-L(u, l, z) / 40))^2
/// u lies on the face, within A = min(aperture, z / 2), and weighs 0.35 + 0.65 cos(pi u / A). L is summed along the ray from u to the
/// place, from the losses of the lines that the ray passes, dB both ways (Szabo, Diagnostic Ultrasound Imaging, ch. 6: rays of an array's
/// aperture). Refraction is left out.
/// @param lost_db       along each line from the face on, both ways (lines x steps)
/// @param reflection_db of what each step lies in: a ray that comes in through the side of a thing pays it
/// @param gain            resized likewise, of amplitudes
void seenFromAperture(const ScannerSetup& setup, const std::vector<float>& lost_db, const std::vector<float>& reflection_db,
                      std::vector<float>& gain);

}  // namespace ew::phantom
