#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/bands.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew::detail {

// Spatial compounding: the same lines seen once more along other directions, and the mean of the amplitudes. Speckle of directions that lie
// a lateral resolution's angle apart is independent, shadows end where all directions pass what throws them, and a surface is bright that
// lies square to one of them.
// Source: Jespersen, Wilhjelm & Sillesen, Ultrasonic Imaging 20 (1998), 81-102. Ours departs: all directions are of one moment, where a
// machine adds up its last few images; near the sides of the fan, below the face and above the last depth, where a direction ends, its
// share fades.

/// The steering of each direction beside the middle one: 8.5 degrees apart from a straight face, 12 from an arc, below which lines that
/// leave it at an angle meet those of the middle direction at ever smaller ones.
/// @param angles odd
[[nodiscard]] std::vector<double> looksBeside(int angles, bool fromAnArc);

/// Where every sample of the middle direction's grid lies on the others.
struct CompoundTable {
  struct Tap {
    std::uint32_t first = 0;  ///< as ScanConversionTable::Tap::first, of the direction's own levels
    float lineWeight = 0.0F;
    float sampleWeight = 0.0F;
    float share = 0.0F;  ///< of this direction, 0 (the sample lies outside)..1; the middle one's is 1
  };
  int lines = 0;
  std::vector<std::vector<Tap>> ofLook;  ///< (lines x samples) each
};

/// @param grids of the directions, made with these looks and with as many lines and samples as the middle one's
[[nodiscard]] CompoundTable makeCompound(const Probe& probe, const Knobs& knobs, const BeamGrid& middle, std::span<const BeamGrid> grids,
                                         std::span<const double> looks_rad);

/// By how much the mean of so many directions' amplitudes is brighter than one of them, dB, in the mean of its logarithm: it has less
/// grain.
/// @param looks of each direction (LiveEchoesEffect)
[[nodiscard]] double compoundBrightens_db(int angles, int looks);

/// The middle direction's levels become those of the mean of all; those of the others become amplitudes.
void compound(const CompoundTable& table, double brightens_db, double greyPerDb, std::span<BeamImage* const> asides, Bands& bands,
              BeamImage& levels);

}  // namespace ew::detail
