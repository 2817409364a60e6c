#pragma once

#include <filesystem>

namespace ew {

/// Whether the medium behind a block device can be pulled out while the system runs: a stick, a card, a drive on a cable, a disc.
/// @param device as the kernel lists it by number: /sys/dev/block/8:1. One that is not listed there cannot (file systems in memory and
/// those that are put together from several devices have no entry of their own)
[[nodiscard]] bool canBePulledOut(const std::filesystem::path& device);

}  // namespace ew
