#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ew::records {

/// What became of a question to the system's keyring.
enum class Keyring { done, empty, absent };
struct KeyringAnswer {
  Keyring outcome = Keyring::absent;
  std::string secret;
  std::string why;  ///< it is absent
};

// Of one folder's secrets: two installations of one user do not share them.
[[nodiscard]] KeyringAnswer keepInKeyring(const std::filesystem::path& folder, const std::string& name, const std::string& secret,
                                          double timeout_s);
[[nodiscard]] KeyringAnswer readKeyring(const std::filesystem::path& folder, const std::string& name, double timeout_s);
[[nodiscard]] KeyringAnswer forgetInKeyring(const std::filesystem::path& folder, const std::string& name, double timeout_s);

}  // namespace ew::records
