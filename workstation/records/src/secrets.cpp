#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

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

std::string reasonNow() { return std::generic_category().message(errno); }

tl::unexpected<Error> cannotKeep(const fs::path& file, const std::string& why) {
  return failure(ErrorCode::notWritable,
                 say<"The secret cannot be kept in %1 (%2); check the folder and its permissions.">(inQuotes(file.string()), verbatim(why)),
                 {{"file", file.string()}});
}

/// Refuses what others may read or change. @param isFolder else a file
Result<void> checkPrivate(const fs::path& place, const struct stat& found, bool isFolder) {
  std::array<char, 16> mode{};
  std::snprintf(mode.data(), mode.size(), "%03o", static_cast<unsigned>(found.st_mode & 0777));
  if (isFolder ? !S_ISDIR(found.st_mode) : !S_ISREG(found.st_mode))
    return failure(
        ErrorCode::notReadable,
        say<"%1 is no plain file or folder of this program, so no secret is kept there; move it away.">(inQuotes(place.string())),
        {{"file", place.string()}});
  if (found.st_uid != ::geteuid())
    return failure(ErrorCode::notReadable,
                   say<"%1 belongs to somebody else, so no secret is kept there; move it away.">(inQuotes(place.string())),
                   {{"file", place.string()}});
  if ((found.st_mode & 077) == 0) return {};
  return failure(
      ErrorCode::notReadable,
      say<"Others may read %1 (its mode is %2), so the secret in it is not used; close it with 'chmod %3 FILE', and change the password "
          "if somebody may have seen it.">(inQuotes(place.string()), verbatim(mode.data()), verbatim(isFolder ? "700" : "600")),
      {{"file", place.string()}, {"mode", mode.data()}});
}

Result<void> checkFolder(const fs::path& folder) {
  struct stat found {};
  if (::lstat(secretsFolder(folder).c_str(), &found) != 0) return {};
  return checkPrivate(secretsFolder(folder), found, true);
}

Result<void> keepInFile(const fs::path& folder, const std::string& name, const std::string& secret) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  const fs::path place = secretsFolder(folder);
  if (::mkdir(place.c_str(), 0700) != 0 && errno != EEXIST) return cannotKeep(place, reasonNow());
  if (auto own = checkFolder(folder); !own) return own;
  // Not writeFileSafely: nobody may read the neighbour either, not even for a moment.
  const fs::path aside = place / (".new-" + name);
  ::unlink(aside.c_str());
  const int out = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (out < 0) return cannotKeep(aside, reasonNow());
  const bool isWritten =
      ::fchmod(out, 0600) == 0 && ::write(out, secret.data(), secret.size()) == static_cast<ssize_t>(secret.size()) && ::fsync(out) == 0;
  const std::string why = isWritten ? std::string() : reasonNow();
  ::close(out);
  if (!isWritten || ::rename(aside.c_str(), (place / name).c_str()) != 0) {
    const std::string reason = isWritten ? reasonNow() : why;
    ::unlink(aside.c_str());
    return cannotKeep(place / name, reason);
  }
  return {};
}

/// Empty: there is none.
Result<std::string> readFromFile(const fs::path& folder, const std::string& name) {
  if (auto own = checkFolder(folder); !own) return passOn(own.error());
  const fs::path file = secretsFolder(folder) / name;
  const int in = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (in < 0 && errno == ENOENT) return std::string();
  if (in < 0)
    return failure(ErrorCode::notReadable,
                   say<"The secret in %1 cannot be read (%2); check its permissions.">(inQuotes(file.string()), verbatim(reasonNow())),
                   {{"file", file.string()}});
  struct stat found {};
  Result<void> own = ::fstat(in, &found) == 0 ? checkPrivate(file, found, false) : Result<void>();
  std::string secret(kLargestSecret_bytes, '\0');
  const ssize_t size = own ? ::read(in, secret.data(), secret.size()) : 0;
  ::close(in);
  if (!own) return passOn(own.error());
  secret.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return secret;
}

Result<void> removeFile(const fs::path& folder, const std::string& name) {
  const fs::path file = secretsFolder(folder) / name;
  if (::unlink(file.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) return cannotKeep(file, reasonNow());
  return {};
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
