#pragma once

#include <filesystem>
#include <string>

#include "ew/core/result.h"
#include "ew/records/record_store.h"

namespace ew {

inline constexpr int kRecordStoreFormat = 1;  ///< `format` of record-store.json; a larger one is refused with newerFormat

/// Where records go, and what is said of people. Without anything secret.
struct RecordStoreSettings {
  enum class Login { basic, bearer };
  std::string endpoint;  ///< empty: not set up yet
  Login login = Login::basic;
  std::string user;          ///< of basic
  bool allowsHttp = false;   ///< http also to other machines
  std::string certificates;  ///< PEM file of the authorities that are trusted; empty: the system's
  std::string homePage;      ///< of the system where people have accounts; empty: the endpoint's machine
  std::string activityBase = "urn:echoweave:";
  bool operator==(const RecordStoreSettings&) const = default;
};

/// Where people have accounts: the home page, else the machine of the endpoint ("https://records.example/"); empty when there is neither.
[[nodiscard]] std::string homePageOf(const RecordStoreSettings& settings);

/// FOLDER/record-store.json. @error notFound, notReadable, badHeader, badField (field name, value found, value expected), newerFormat
[[nodiscard]] Result<RecordStoreSettings> readRecordStoreSettings(const std::filesystem::path& folder);
/// Makes the folder when it is not there. @error badField (an endpoint that passwords may not be sent to), notWritable
[[nodiscard]] Result<void> writeRecordStoreSettings(const RecordStoreSettings& settings, const std::filesystem::path& folder);

/// $XDG_CONFIG_HOME/echoweave, else ~/.config/echoweave. @error notFound (the user has no home folder)
[[nodiscard]] Result<std::filesystem::path> recordSettingsFolder();
/// LIBRARY/records: the outbox, when nothing else is asked for.
[[nodiscard]] std::filesystem::path recordOutboxFolder(const std::filesystem::path& library);

/// What must not be seen: kept in the system's keyring (Secret Service, by libsecret) where there is one, else in the file
/// FOLDER/secrets/NAME, which only its owner reads. A file or a folder that others may read is not used.
enum class SecretPlace { keyring, file };
struct SecretOptions {
  bool usesKeyring = true;
  double keyringTimeout_s = 60.0;  ///< a keyring that is locked asks its owner
};
[[nodiscard]] bool hasKeyring();  ///< whether this build knows of keyrings; the system may still have none

/// Keeps a secret; one that was kept before under this name is gone, wherever it was.
/// @param name   [a-z0-9-]+: "record-store" @param secret any bytes without a zero, at most 64 KiB
/// @error badField, notWritable
[[nodiscard]] Result<SecretPlace> keepSecret(const std::filesystem::path& folder, const std::string& name, const std::string& secret,
                                             const SecretOptions& options = {});
/// @error notFound, notReadable (others may read it: its mode, and how to close it)
[[nodiscard]] Result<std::string> readSecret(const std::filesystem::path& folder, const std::string& name,
                                             const SecretOptions& options = {});
/// Nothing happens when there is none. @error notWritable
[[nodiscard]] Result<void> forgetSecret(const std::filesystem::path& folder, const std::string& name, const SecretOptions& options = {});

inline constexpr const char* kRecordStoreSecret = "record-store";  ///< the password or the token
/// The settings of a folder with their secret. @error as readRecordStoreSettings and readSecret, badField
[[nodiscard]] Result<RecordStore> recordStoreOf(const std::filesystem::path& folder, const SecretOptions& options = {});

}  // namespace ew
