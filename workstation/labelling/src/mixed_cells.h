#pragma once

#include <cstdint>
#include <span>

namespace ew::labelling {

/// Which cells between four rows of voxels hold more than one label.
/// @param voxels in each row, >= 1
/// @param bits (voxels + 62) / 64 words; bit n, counted from the lowest of the first: the eight voxels n and n + 1 are not all alike. Those
///        from voxels - 1 on become 0
void findMixed(const std::uint8_t* const (&rows)[4], int voxels, std::span<std::uint64_t> bits);

}  // namespace ew::labelling
