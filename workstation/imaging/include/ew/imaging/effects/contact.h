#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// How well each scan line touches, 0 (air) to 1, from gaps between face and skin: a line is made by the part of the face under its
/// aperture, so contact falls off softly.
/// @param gaps_mm    distance of the skin from the face at points evenly spread from the -x end to the +x end, negative when pressed in; at
///                   least 2 values, or none: then everything touches; a gap that is no number does not touch
/// @param contact    receives one value a line, evenly spread from the -x end to the +x end
void contactOfLines(const ContactEffect& effect, std::span<const float> gaps_mm, double faceWidth_mm, double aperture_mm,
                    std::span<float> contact);

/// Lines without contact go dark and ring down: bright bars below the face that fade with depth.
/// @param contact one value a line
void loseContact(const ContactEffect& effect, std::span<const float> contact, double greyPerDb, double sampleSpacing_mm,
                 ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
