#pragma once

#include <filesystem>
#include <string>

#include "ew/library/bundle.h"

namespace ew {

inline constexpr const char* kBundleHeaderName = "bundle.json";
/// Of a list with as many files as a bundle may have.
inline constexpr std::size_t kLargestBundleHeader_bytes = 48u << 20;

[[nodiscard]] std::string textOf(const BundleHeader& header);

/// @param bundle for the sentences, and how large it is for its limits
/// @error badHeader, badField, newerFormat, unsupported, tooLarge
[[nodiscard]] Result<BundleHeader> bundleHeaderFrom(const std::string& text, const std::filesystem::path& bundle,
                                                    std::uint64_t bundle_bytes, const BundleLimits& limits);

}  // namespace ew
