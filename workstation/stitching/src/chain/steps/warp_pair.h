#pragma once

#include <string>

#include "chain/chain_run.h"
#include "chain/overlap.h"

namespace ew::stitching {

/// An elastic pair from the poses of the graph.
struct Warped {
  PairWarp warp;
  PairDeformation about;
};

/// Warps two views by what they both cover and some more around it, or finds in the store how they were warped before.
/// @param overlap of both at their poses; both views are loaded
/// @error what registering says, with the names of both volumes; cancelled
[[nodiscard]] Result<Warped> warpPair(ChainRun& run, std::size_t fixed, std::size_t moving, const Overlap& overlap, int threads,
                                      Progress& progress);

/// Notes that this run builds on a warp although nothing asked for it: the warps of all were found finished.
void useWarp(const ChainRun& run, std::size_t fixed, std::size_t moving);

/// Keeps the displacements of a lattice as a file of a result. @error notWritable
[[nodiscard]] Result<void> writeVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                                        const registration::ControlGrid& control);
/// Fills the displacements of a lattice whose nodes are known, or leaves it without any when it warps nothing.
/// @return whether the file is there and fits
[[nodiscard]] bool readVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                               registration::ControlGrid& control);

}  // namespace ew::stitching
