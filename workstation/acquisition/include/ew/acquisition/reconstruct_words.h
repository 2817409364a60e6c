#pragma once

#include "ew/acquisition/confidence.h"
#include "ew/acquisition/reconstruct.h"
#include "ew/core/word_table.h"

namespace ew {

// The words that files and commands use for the methods of a reconstruction.
inline constexpr WordTable<Interpolation, 3> kInterpolationWords{
    {{"nearest", Interpolation::nearest}, {"linear", Interpolation::linear}, {"centred", Interpolation::centred}}};
inline constexpr WordTable<Compounding, 4> kCompoundingWords{
    {{"mean", Compounding::mean}, {"maximum", Compounding::maximum}, {"latest", Compounding::latest}, {"weighted", Compounding::weighted}}};
inline constexpr WordTable<FillMethod, 2> kFillMethodWords{{{"sweep", FillMethod::sweep}, {"bridges", FillMethod::bridges}}};
inline constexpr WordTable<ConfidenceMethod, 2> kConfidenceMethodWords{
    {{"beamwise", ConfidenceMethod::beamwise}, {"randomwalk", ConfidenceMethod::randomWalk}}};

}  // namespace ew
