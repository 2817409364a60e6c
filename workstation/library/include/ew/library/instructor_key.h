#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "ew/core/result.h"
#include "ew/library/passphrase.h"

namespace ew {

// Who examines has a key pair (X25519): anybody who has the public key can seal answers for its owner (sealed_answers.h), and only who has
// the secret key can open them, wherever a bundle goes. Why: resources/decisions/0059.

inline constexpr int kInstructorKeyFormat = 1;  ///< of instructor.key; a larger one is refused with newerFormat

struct PublicKey {
  std::array<std::uint8_t, 32> bytes{};
  bool operator==(const PublicKey&) const = default;
};

/// "echoweave-key-1 BASE64 CHECKSUM", one line: it goes by mail, on paper and into a file. A digit that was mistyped is noticed.
[[nodiscard]] std::string textOf(const PublicKey& key);
/// Lines that begin with '#', and blank ones, are passed over. @error badHeader (no key), badField (the checksum says otherwise),
/// newerFormat
[[nodiscard]] Result<PublicKey> publicKeyOf(const std::string& text);
/// "4f2a-91c7-0b3e-d605", to be compared by eye or on the telephone.
[[nodiscard]] std::string shortNameOf(const PublicKey& key);

/// A file with a public key. @error notFound, notReadable, tooLarge, as publicKeyOf
[[nodiscard]] Result<PublicKey> readPublicKey(const std::filesystem::path& file);
/// @error notWritable
[[nodiscard]] Result<void> writePublicKey(const PublicKey& key, const std::filesystem::path& file);

/// A secret key in memory that is kept off the swap where the system allows it and wiped when the last copy ends.
class SecretKey {
 public:
  /// A new one, from the system's random numbers. @error internal (it has none)
  [[nodiscard]] static Result<SecretKey> make();
  /// @param bytes 32
  [[nodiscard]] static Result<SecretKey> of(const std::uint8_t* bytes);
  [[nodiscard]] const std::uint8_t* bytes() const;
  [[nodiscard]] const PublicKey& publicKey() const { return public_; }

 private:
  SecretKey() = default;
  std::shared_ptr<std::uint8_t> bytes_;
  PublicKey public_;
};

/// The folder of this account's keys: $ECHOWEAVE_KEYS, else $XDG_DATA_HOME/echoweave/keys, else ~/.local/share/echoweave/keys. It is no
/// part of a library, and no bundle or backup of one takes it along.
[[nodiscard]] std::filesystem::path instructorKeyFolder();
/// instructor.key in it.
[[nodiscard]] std::filesystem::path instructorKeyFile();

/// Keeps a secret key: the folder 0700, the file 0600, its bytes encrypted (XSalsa20-Poly1305) under the passphrase.
/// @error badUsage (checkNewPassphrase), notWritable (also: there is a key of that name already, for with it the answers of every
///        examination that was made for it would be lost)
[[nodiscard]] Result<void> keepSecretKey(const SecretKey& key, const Passphrase& passphrase, const std::filesystem::path& file,
                                         const PassphraseCost& cost = {});

/// The public half, which needs no passphrase; it is believed only until openSecretKey has compared it.
/// @error as readPrivateFile; badHeader, badField, newerFormat
[[nodiscard]] Result<PublicKey> publicKeyKeptIn(const std::filesystem::path& file);

/// @error as publicKeyKeptIn; badUsage (another passphrase, or the file was tampered with: it cannot be told which)
[[nodiscard]] Result<SecretKey> openSecretKey(const std::filesystem::path& file, const Passphrase& passphrase);

}  // namespace ew
