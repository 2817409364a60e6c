#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// How well each scan line touches, 0 (air) to 1, from gaps between face and skin. A gap touches fully up to gel_mm and not at all 1 mm
/// further; between the points contact is linear; a line is made by the part of the face under its aperture (as much of it as there is),
/// so its contact is the mean there and falls off softly.
/// @param gaps_mm    distance of the skin from the face at points evenly spread from the -x end to the +x end, negative when pressed in; at
///                   least 2 values, or none: then everything touches; a gap that is no number does not touch
/// @param faceWidth_mm, aperture_mm along the face, > 0 and >= 0
/// @param contact    receives one value a line, evenly spread from the -x end to the +x end; exactly 1 where the whole aperture touches
void contactOfLines(const ContactEffect& effect, std::span<const float> gaps_mm, double faceWidth_mm, double aperture_mm,
                    std::span<float> contact);

/// Lines without contact go dark and ring down: bright bars below the face that fade with depth.
///   level' = level + 40 log10(c) greyPerDb (the share c of the aperture's amplitude, once each way; -160 dB at least), and down to
///   ringDown_mm, added as power, 255 + greyPerDb (40 log10(1 - c) - 60 d / ringDown_mm - 18 sin^2(pi d / 1.5 mm)):
/// bars 1.5 mm apart, as a lens in air shows them. Model and numbers are ours, after the look of a probe held in air.
/// Lines of full contact stay as they are to the bit; when all are full, nothing is done.
/// @param contact one value a line; what is no number or below 0 counts as 0
/// @param scratch resized to 2 floats a line
/// Cost on one core of a server of 2023 (AVX-512, shared): nothing when all touch, else 0.15 ns a sample.
void loseContact(const ContactEffect& effect, std::span<const float> contact, double greyPerDb, double sampleSpacing_mm,
                 ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
