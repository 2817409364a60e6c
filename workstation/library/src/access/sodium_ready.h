#pragma once

#include <sodium.h>

#include <cstdint>
#include <span>
#include <string>

#include "ew/core/result.h"
#include "ew/library/passphrase.h"

namespace ew {

/// libsodium, ready for use. @error internal
[[nodiscard]] Result<void> readySodium();

[[nodiscard]] tl::unexpected<Error> noMemoryFor(const PassphraseCost& cost);

/// As libsodium's "original" variant has it, with padding.
[[nodiscard]] std::string base64Of(std::span<const std::uint8_t> bytes);
/// Nothing when it is not base64 of exactly `count` bytes.
[[nodiscard]] bool fromBase64(const std::string& text, std::span<std::uint8_t> bytes);

}  // namespace ew
