#pragma once

#include <chrono>
#include <filesystem>

namespace ew {

inline constexpr auto kOldResult = std::chrono::hours(24 * 90);

/// Removes from a folder of the cache what nobody will come back for: what killed programs left half written, and results not used for
/// `oldAfter` with all that belongs to them. Only names that this program gives are touched: 32 hexadecimal digits and an ending of the
/// pipeline's, alone or as older programs wrote them aside (".NAME.PID-NUMBER.part", a day after the last write and their process gone).
void removeOldResults(const std::filesystem::path& folder, std::chrono::seconds oldAfter = kOldResult);

}  // namespace ew
