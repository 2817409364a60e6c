#include "ew/library/instructor_key.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "access/sodium_ready.h"
#include "ew/core/json_fields.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kKeyWord = "echoweave-key-";
constexpr std::size_t kChecksum_bytes = 4;
constexpr std::size_t kSecretKey_bytes = crypto_box_SECRETKEYBYTES;
// A file that was tampered with may not make the program work for hours or take all memory.
constexpr std::uint64_t kMostPasses = 20, kMostMemory_bytes = 2ull << 30;
static_assert(kSecretKey_bytes == 32 && crypto_box_PUBLICKEYBYTES == 32);

std::string hexOf(std::span<const std::uint8_t> bytes) {
  std::string text(2 * bytes.size() + 1, '\0');
  ::sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  text.resize(2 * bytes.size());
  return text;
}

std::string checksumOf(const PublicKey& key) {
  std::array<std::uint8_t, crypto_generichash_BYTES> sum{};
  ::crypto_generichash(sum.data(), sum.size(), key.bytes.data(), key.bytes.size(), nullptr, 0);
  return hexOf(std::span(sum).first(kChecksum_bytes));
}

/// What of instructor.key is read before a passphrase is asked for.
struct KeyFileContent {
  PublicKey key;
  PassphraseCost cost;
  std::array<std::uint8_t, crypto_pwhash_SALTBYTES> salt{};
  std::array<std::uint8_t, crypto_secretbox_NONCEBYTES> nonce{};
  std::array<std::uint8_t, kSecretKey_bytes + crypto_secretbox_MACBYTES> box{};
};

template <std::size_t N>
void bytesIn(const JsonFields& fields, std::string_view name, std::array<std::uint8_t, N>& bytes) {
  const std::string text = fields.text(name);
  if (fields.good() && !fromBase64(text, bytes)) fields.refuse(name, say<"%1 bytes in base64">(N));
}

Result<KeyFileContent> readKept(const fs::path& file) {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  const auto text = readPrivateFile(file, 64u << 10);
  if (!text) return passOn(text.error());
  const Message where = verbatim(file.filename().string());
  const auto document = parseJsonObject(*text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kInstructorKeyFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       file.filename().string(), format, kInstructorKeyFormat),
                   {{"file", file.string()}});
  KeyFileContent kept;
  const auto key = publicKeyOf(fields.text("public"));
  kept.cost.passes = static_cast<std::uint64_t>(fields.whole("passes", 1, kMostPasses));
  kept.cost.memory_bytes = static_cast<std::uint64_t>(fields.whole("memory_bytes", 8192, kMostMemory_bytes));
  bytesIn(fields, "salt", kept.salt);
  bytesIn(fields, "nonce", kept.nonce);
  bytesIn(fields, "sealed", kept.box);
  if (reading.problem()) return passOn(*reading.problem());
  if (!key) return passOn(key.error());
  kept.key = *key;
  return kept;
}

/// The key that a passphrase stands for.
class PassphraseKey {
 public:
  PassphraseKey() = default;
  ~PassphraseKey() { ::sodium_memzero(bytes_.data(), bytes_.size()); }
  PassphraseKey(const PassphraseKey&) = delete;
  PassphraseKey& operator=(const PassphraseKey&) = delete;
  Result<void> make(const Passphrase& passphrase, const std::uint8_t* salt, const PassphraseCost& cost) {
    const auto words = passphrase.words();
    if (::crypto_pwhash(bytes_.data(), bytes_.size(), words.data(), words.size(), salt, cost.passes, cost.memory_bytes,
                        crypto_pwhash_ALG_ARGON2ID13) == 0)
      return {};
    return noMemoryFor(cost);
  }
  [[nodiscard]] const std::uint8_t* get() const { return bytes_.data(); }

 private:
  std::array<std::uint8_t, crypto_secretbox_KEYBYTES> bytes_{};
};

}  // namespace

std::string textOf(const PublicKey& key) {
  return kKeyWord + std::to_string(kInstructorKeyFormat) + " " + base64Of(key.bytes) + " " + checksumOf(key);
}

Result<PublicKey> publicKeyOf(const std::string& text) {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  std::istringstream lines(text);
  std::string word, bytes, checksum, more;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    if (!(words >> word) || word.front() == '#') {
      word.clear();
      continue;
    }
    words >> bytes >> checksum >> more;
    break;
  }
  if (!word.starts_with(kKeyWord))
    return failure(ErrorCode::badHeader, say<"This is no public key; it is one line that begins with %1, from 'echoweave key show'.">(
                                             std::string(kKeyWord) + "1"));
  if (word != kKeyWord + std::to_string(kInstructorKeyFormat))
    return failure(ErrorCode::newerFormat, say<"This public key is of another kind (%1); use it with a newer EchoWeave.">(word));
  PublicKey key;
  if (!more.empty() || !fromBase64(bytes, key.bytes) || checksumOf(key) != checksum)
    return failure(ErrorCode::badField,
                   say<"The public key was not copied right: its checksum does not fit; copy the whole line again.">());
  return key;
}

std::string shortNameOf(const PublicKey& key) {
  std::array<std::uint8_t, crypto_generichash_BYTES> sum{};
  ::crypto_generichash(sum.data(), sum.size(), key.bytes.data(), key.bytes.size(), nullptr, 0);
  const std::string digits = hexOf(std::span(sum).first(8));
  return digits.substr(0, 4) + "-" + digits.substr(4, 4) + "-" + digits.substr(8, 4) + "-" + digits.substr(12, 4);
}

Result<PublicKey> readPublicKey(const fs::path& file) {
  const auto text = readTextFile(file, 64u << 10);
  if (!text) return passOn(text.error());
  auto key = publicKeyOf(*text);
  if (!key) {
    Error problem = key.error();
    problem.message = say<"In \"%1\": %2">(file, std::move(problem.message));
    problem.context.emplace_back("file", file.string());
    return passOn(std::move(problem));
  }
  return key;
}

Result<void> writePublicKey(const PublicKey& key, const fs::path& file) {
  return writeFileSafely(
      file, "# An instructor's public key for examinations, " + shortNameOf(key) + ". It is no secret.\n" + textOf(key) + "\n");
}

Result<SecretKey> SecretKey::make() {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  std::array<std::uint8_t, kSecretKey_bytes> bytes{};
  ::randombytes_buf(bytes.data(), bytes.size());
  auto made = of(bytes.data());
  ::sodium_memzero(bytes.data(), bytes.size());
  return made;
}

Result<SecretKey> SecretKey::of(const std::uint8_t* bytes) {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  SecretKey key;
  key.bytes_ = std::shared_ptr<std::uint8_t>(static_cast<std::uint8_t*>(::sodium_malloc(kSecretKey_bytes)),
                                             [](std::uint8_t* p) { ::sodium_free(p); });
  if (key.bytes_ == nullptr)
    return failure(ErrorCode::tooLarge,
                   say<"There is no memory that can be locked for the secret key; close other programs and try again.">());
  std::copy(bytes, bytes + kSecretKey_bytes, key.bytes_.get());
  ::crypto_scalarmult_base(key.public_.bytes.data(), key.bytes_.get());
  return key;
}

const std::uint8_t* SecretKey::bytes() const { return bytes_.get(); }

fs::path instructorKeyFolder() {
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string chosen = environment("ECHOWEAVE_KEYS"); !chosen.empty()) return chosen;
  if (const std::string data = environment("XDG_DATA_HOME"); !data.empty()) return fs::path(data) / "echoweave/keys";
  return fs::path(environment("HOME")) / ".local/share/echoweave/keys";
}

fs::path instructorKeyFile() { return instructorKeyFolder() / "instructor.key"; }

Result<void> keepSecretKey(const SecretKey& key, const Passphrase& passphrase, const fs::path& file, const PassphraseCost& cost) {
  if (auto good = checkNewPassphrase(passphrase); !good) return good;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored)))
    return failure(
        ErrorCode::notWritable,
        say<"There is a key in \"%1\" already, and without it no examination that was made for it can be judged; keep it, or move it "
            "away first.">(file),
        {{"file", file.string()}});
  if (auto made = makePrivateFolder(file.parent_path()); !made) return made;
  KeyFileContent kept;
  ::randombytes_buf(kept.salt.data(), kept.salt.size());
  ::randombytes_buf(kept.nonce.data(), kept.nonce.size());
  PassphraseKey stretched;
  if (auto good = stretched.make(passphrase, kept.salt.data(), cost); !good) return good;
  ::crypto_secretbox_easy(kept.box.data(), key.bytes(), kSecretKey_bytes, kept.nonce.data(), stretched.get());
  const json document = {{"format", kInstructorKeyFormat},    {"public", textOf(key.publicKey())}, {"passes", cost.passes},
                         {"memory_bytes", cost.memory_bytes}, {"salt", base64Of(kept.salt)},       {"nonce", base64Of(kept.nonce)},
                         {"sealed", base64Of(kept.box)}};
  return writePrivateFile(file, document.dump(1) + "\n");
}

Result<PublicKey> publicKeyKeptIn(const fs::path& file) {
  const auto kept = readKept(file);
  if (!kept) return passOn(kept.error());
  return kept->key;
}

Result<SecretKey> openSecretKey(const fs::path& file, const Passphrase& passphrase) {
  const auto kept = readKept(file);
  if (!kept) return passOn(kept.error());
  PassphraseKey stretched;
  if (auto good = stretched.make(passphrase, kept->salt.data(), kept->cost); !good) return passOn(good.error());
  std::array<std::uint8_t, kSecretKey_bytes> bytes{};
  const bool opened =
      ::crypto_secretbox_open_easy(bytes.data(), kept->box.data(), kept->box.size(), kept->nonce.data(), stretched.get()) == 0;
  auto key = opened ? SecretKey::of(bytes.data()) : Result<SecretKey>(passOn({}));
  ::sodium_memzero(bytes.data(), bytes.size());
  // The public half stands in the open: one that was exchanged would have answers sealed for somebody else.
  if (!opened || (key && key->publicKey() != kept->key))
    return failure(ErrorCode::badUsage, say<"The passphrase does not open \"%1\", or the file was changed; type it again.">(file),
                   {{"file", file.string()}});
  return key;
}

}  // namespace ew
