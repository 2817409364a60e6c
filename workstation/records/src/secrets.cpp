#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "ew/io/private_file.h"
#include "ew/records/record_store_settings.h"
#include "iri.h"
#include "keyring.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using records::inQuotes;
using records::Keyring;

constexpr std::size_t kLargestSecret_bytes = 64u << 10;

fs::path secretsFolder(const fs::path& folder) { return folder / "secrets"; }

/// A folder that others may enter or change is not used: they could have put the secret there.
Result<void> checkFolder(const fs::path& folder) {
  const fs::path place = secretsFolder(folder);
  struct stat found {};
  if (::lstat(place.c_str(), &found) != 0) return {};
  if (S_ISDIR(found.st_mode) && found.st_uid == ::geteuid() && (found.st_mode & 077) == 0) return {};
  return failure(ErrorCode::notReadable,
                 say<"%1 is not a folder that only you can enter, so no secret in it is used; close it with 'chmod 700', and change the "
                     "password if somebody may have seen it.">(inQuotes(place.string())),
                 {{"file", place.string()}});
}

Result<void> keepInFile(const fs::path& folder, const std::string& name, const std::string& secret) {
  if (auto own = checkFolder(folder); !own) return own;
  if (auto made = makePrivateFolder(secretsFolder(folder)); !made) return made;
  return writePrivateFile(secretsFolder(folder) / name, secret);
}

/// Empty: there is none.
Result<std::string> readFromFile(const fs::path& folder, const std::string& name) {
  if (auto own = checkFolder(folder); !own) return passOn(own.error());
  auto secret = readPrivateFile(secretsFolder(folder) / name, kLargestSecret_bytes);
  if (!secret && secret.error().code == ErrorCode::notFound) return std::string();
  return secret;
}

Result<void> removeFile(const fs::path& folder, const std::string& name) {
  const fs::path file = secretsFolder(folder) / name;
  if (::unlink(file.c_str()) == 0 || errno == ENOENT || errno == ENOTDIR) return {};
  return failure(ErrorCode::notWritable,
                 say<"The secret in %1 cannot be removed (%2); remove the file.">(inQuotes(file.string()),
                                                                                  verbatim(std::generic_category().message(errno))),
                 {{"file", file.string()}});
}

Result<void> checkName(const std::string& name) {
  const bool isName = !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-';
  });
  if (isName) return {};
  return failure(ErrorCode::badField, say<"%1 is no name of a secret; use small letters, digits and '-'.">(inQuotes(name)));
}

}  // namespace

Result<SecretPlace> keepSecret(const fs::path& folder, const std::string& name, const std::string& secret, const SecretOptions& options) {
  if (auto named = checkName(name); !named) return passOn(named.error());
  if (secret.empty() || secret.size() >= kLargestSecret_bytes || secret.find('\0') != std::string::npos)
    return failure(ErrorCode::badField, say<"The secret is empty, too long, or holds a zero byte; check where it was copied from.">());
  if (options.usesKeyring && records::keepInKeyring(folder, name, secret, options.keyringTimeout_s).outcome == Keyring::done) {
    if (auto removed = removeFile(folder, name); !removed) return passOn(removed.error());
    return SecretPlace::keyring;
  }
  if (auto kept = keepInFile(folder, name, secret); !kept) return passOn(kept.error());
  // What stands in the keyring would be found first.
  if (options.usesKeyring) (void)records::forgetInKeyring(folder, name, options.keyringTimeout_s);
  return SecretPlace::file;
}

Result<std::string> readSecret(const fs::path& folder, const std::string& name, const SecretOptions& options) {
  if (auto named = checkName(name); !named) return passOn(named.error());
  if (auto found = readFromFile(folder, name); !found || !found->empty()) return found;
  std::string why;
  if (options.usesKeyring) {
    auto answer = records::readKeyring(folder, name, options.keyringTimeout_s);
    if (answer.outcome == Keyring::done) return std::move(answer.secret);
    why = records::tamed(answer.why);
  }
  if (!why.empty())
    return failure(ErrorCode::notFound,
                   say<"There is no secret '%1', and the keyring does not answer (%2); give it with 'echoweave records settings'.">(
                       std::string(name), verbatim(why)),
                   {{"name", name}});
  return failure(ErrorCode::notFound, say<"There is no secret '%1' yet; give it with 'echoweave records settings'.">(std::string(name)),
                 {{"name", name}});
}

Result<void> forgetSecret(const fs::path& folder, const std::string& name, const SecretOptions& options) {
  if (auto named = checkName(name); !named) return named;
  if (options.usesKeyring) (void)records::forgetInKeyring(folder, name, options.keyringTimeout_s);
  return removeFile(folder, name);
}

}  // namespace ew
