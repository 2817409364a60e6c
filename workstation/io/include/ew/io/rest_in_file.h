#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace ew {

/// Where large vectors begin within a page: behind what the C library's allocator notes in front of a block that has pages of its own.
/// Samples of a file that begin there, too, can be read by the page (restInFile).
inline constexpr std::uint64_t kBlockBegin_bytes = 16;

/// Gives memory back that a file has as well: pages of `values` are from now on read from the file when they are touched, and are in
/// memory only as long as the system has room for them, once for all who have the same file. The values are what they were, whatever
/// is done to the file's name, and may be written to: that keeps them here alone.
/// Every page is compared before it is given back. Whole pages alone rest; nothing happens where values and samples do not begin at the
/// same byte of a page, below a megabyte, on the disk of another machine (which may go away), and without Linux.
/// The file must not be written into or cut shorter as long as the values are used; to rename or remove it does no harm.
/// @param values in a block of their own, which nobody else reads yet @param offset_bytes of their file's first
/// @return how many bytes rest
std::uint64_t restInFile(std::span<std::uint8_t> values, const std::filesystem::path& file, std::uint64_t offset_bytes);

/// The same in an uncompressed volume file of one byte a voxel. 0 where it is none.
std::uint64_t restInVolumeFile(std::span<std::uint8_t> values, const std::filesystem::path& file);

}  // namespace ew
