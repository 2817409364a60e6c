#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew::records {

/// In quotation marks, on one line, at most 200 bytes.
[[nodiscard]] Message inQuotes(std::string_view text);

/// Percent-encoded (RFC 3986): letters, digits, '-', '.', '_' and '~' stay.
[[nodiscard]] std::string encoded(std::string_view text);
/// Back; nothing when a '%' is not followed by two hexadecimal digits. '+' stays.
[[nodiscard]] std::optional<std::string> decoded(std::string_view text);

/// A scheme, a colon and something behind it, without spaces, controls or quotation marks.
[[nodiscard]] bool isIri(std::string_view text);
/// http(s)://host...
[[nodiscard]] bool isWebAddress(std::string_view text);
/// "en", "de-AT".
[[nodiscard]] bool isLanguageTag(std::string_view text);

/// An address that credentials may be sent to, in a normal form: https, or http to this machine itself or when that is allowed; without a
/// user, a password or a fragment.
/// @param what how sentences name it: say<"the record store's address">()
/// @error badField
[[nodiscard]] Result<std::string> safeAddress(const std::string& address, bool allowsHttp, const Message& what);
/// The same that ends with '/', for resources are named behind it. @error also badField (it has a query)
[[nodiscard]] Result<std::string> safeEndpoint(const std::string& endpoint, bool allowsHttp, const Message& what);
/// Scheme, host and port: "https://lrs.example:8443". Empty when it is no address.
[[nodiscard]] std::string originOf(const std::string& address);
[[nodiscard]] std::string hostOf(const std::string& address);

/// Takes everything out of a text of a server that has no place in a sentence: controls, tags of HTML, what is not UTF-8; on one line, at
/// most 300 bytes, without a full stop at its end. Each text of `secrets` is replaced by "***".
[[nodiscard]] std::string tamed(std::string_view text, const std::vector<std::string>& secrets = {});

}  // namespace ew::records
