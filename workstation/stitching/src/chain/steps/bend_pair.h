#pragma once

#include <string>

#include "chain/chain_run.h"
#include "chain/overlap.h"

namespace ew::stitching {

/// An elastic pair from the poses of the graph.
struct Bent {
  PairBend bend;
  BentPair about;
};

/// Bends two views by what they both cover and some more around it, or finds in the store how they were bent before.
/// @param overlap of both at their poses; both views are loaded
/// @error what registering says, with the names of both volumes; cancelled
[[nodiscard]] Result<Bent> bendPair(ChainRun& run, std::size_t fixed, std::size_t moving, const Overlap& overlap, int threads,
                                    Progress& progress);

/// Notes that this run builds on a bend although nothing asked for it: the bends of all were found finished.
void useBend(const ChainRun& run, std::size_t fixed, std::size_t moving);

/// Keeps the displacements of a lattice as a file of a result. @error notWritable
[[nodiscard]] Result<void> writeVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                                        const registration::ControlGrid& control);
/// Fills the displacements of a lattice whose nodes are known, or leaves it without any when it bends nothing.
/// @return whether the file is there and fits
[[nodiscard]] bool readVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                               registration::ControlGrid& control);

}  // namespace ew::stitching
