#include "ew/io/private_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "ew/io/file_lock.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kOthers = 077;

class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }
  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

Message reasonNow() { return verbatim(std::generic_category().message(errno)); }

tl::unexpected<Error> notPrivate(const fs::path& file, const Message& reason) {
  return failure(ErrorCode::notWritable, say<"\"%1\" cannot be kept for yourself alone (%2); choose a place of your own.">(file, reason),
                 {{"file", file.string()}, {"reason", reason.english()}});
}

bool writeAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// So that a name that was given to a file is on the medium as well.
void syncFolder(const fs::path& folder) {
  const OpenFile opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.isOpen()) ::fsync(opened.get());
}

/// What keeps an open file from being this account's own; empty: nothing.
Message strangeness(const struct stat& found) {
  if (!S_ISREG(found.st_mode)) return say<"it is no file">();
  if (found.st_uid != ::geteuid()) return say<"it belongs to another account">();
  return {};
}

}  // namespace

Result<void> makePrivateFolder(const fs::path& folder) {
  std::error_code problem;
  if (folder.empty()) return notPrivate(folder, say<"it names no folder">());
  if (const fs::path above = folder.parent_path(); !above.empty() && !fs::exists(above, problem))
    if (auto made = makePrivateFolder(above); !made) return made;
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return notPrivate(folder, reasonNow());
  const OpenFile opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!opened.isOpen()) return notPrivate(folder, reasonNow());
  struct stat found {};
  if (::fstat(opened.get(), &found) != 0) return notPrivate(folder, reasonNow());
  if (found.st_uid != ::geteuid()) return notPrivate(folder, say<"it belongs to another account">());
  if ((found.st_mode & 0777) != 0700 && ::fchmod(opened.get(), 0700) != 0) return notPrivate(folder, reasonNow());
  return {};
}

namespace {

/// @param write through the descriptor; an error that says nothing is errno's
Result<void> writeAside(const fs::path& file, const std::function<Result<void>(int descriptor, const std::string& aside)>& write) {
  std::string aside = (file.parent_path() / (std::string(kPrivateAside) + "XXXXXX")).string();
  const OpenFile out(::mkostemp(aside.data(), O_CLOEXEC));
  if (!out.isOpen()) return notPrivate(file, reasonNow());
  Result<void> written = ::fchmod(out.get(), 0600) == 0 ? write(out.get(), aside) : notPrivate(file, reasonNow());
  if (written && (::fsync(out.get()) != 0 || ::rename(aside.c_str(), file.c_str()) != 0)) written = notPrivate(file, reasonNow());
  if (!written)
    ::unlink(aside.c_str());
  else
    syncFolder(file.parent_path());
  return written;
}

}  // namespace

Result<void> writePrivateFile(const fs::path& file, std::string_view text) {
  return writeAside(file, [&](int descriptor, const std::string&) -> Result<void> {
    if (!writeAll(descriptor, text)) return notPrivate(file, reasonNow());
    return {};
  });
}

Result<void> writePrivateFile(const fs::path& file, const std::function<Result<void>(std::ostream&)>& write) {
  return writeAside(file, [&](int, const std::string& aside) -> Result<void> {
    std::ofstream out(aside, std::ios::binary);  // its mode is set already
    if (out)
      if (auto written = write(out); !written) return written;
    errno = 0;
    out.flush();
    const bool isGood = out.good();
    const Message reason = errno != 0 ? reasonNow() : say<"the medium is full or gone">();
    if (!isGood) return notPrivate(file, reason);
    return {};
  });
}

Result<std::string> readPrivateFile(const fs::path& file, std::size_t maxBytes) {
  const auto refuse = [&](ErrorCode code, Message sentence) { return failure(code, std::move(sentence), {{"file", file.string()}}); };
  const OpenFile in(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!in.isOpen() && errno == ENOENT) return refuse(ErrorCode::notFound, say<"\"%1\" is not there; check the name and the folder.">(file));
  if (!in.isOpen() && errno == ELOOP)
    return refuse(ErrorCode::notReadable,
                  say<"\"%1\" is a link, and a private file is not read through one; put the file itself there.">(file));
  if (!in.isOpen()) return refuse(ErrorCode::notReadable, say<"\"%1\" cannot be opened (%2); check its permissions.">(file, reasonNow()));
  struct stat found {};
  if (::fstat(in.get(), &found) != 0)
    return refuse(ErrorCode::notReadable, say<"\"%1\" cannot be opened (%2); check its permissions.">(file, reasonNow()));
  if (const Message strange = strangeness(found); !strange.empty())
    return refuse(ErrorCode::notReadable, say<"\"%1\" is not read, because %2; use a file of your own.">(file, strange));
  if ((found.st_mode & kOthers) != 0)
    return refuse(
        ErrorCode::notReadable,
        say<"\"%1\" can be read or changed by other accounts, so it is not trusted; close it with 'chmod 600', and replace what it "
            "keeps secret.">(file));
  std::string text;
  std::array<char, 16384> piece{};
  for (;;) {
    const ssize_t count = ::read(in.get(), piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refuse(ErrorCode::notReadable, say<"\"%1\" cannot be opened (%2); check its permissions.">(file, reasonNow()));
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
    if (text.size() > maxBytes)
      return refuse(ErrorCode::tooLarge,
                    say<"\"%1\" has more than the %2 bytes allowed here; check that it is the right file.">(file, maxBytes));
  }
}

Result<void> appendPrivateLine(const fs::path& file, std::string_view line) {
  const OpenFile out(::open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!out.isOpen()) return notPrivate(file, reasonNow());
  struct stat found {};
  if (!FileLock::holdOpen(out.get()) || ::fstat(out.get(), &found) != 0) return notPrivate(file, reasonNow());
  if (const Message strange = strangeness(found); !strange.empty()) return notPrivate(file, strange);
  if ((found.st_mode & 0777) != 0600 && ::fchmod(out.get(), 0600) != 0) return notPrivate(file, reasonNow());
  char last = '\n';
  if (found.st_size > 0 && ::pread(out.get(), &last, 1, found.st_size - 1) != 1) return notPrivate(file, reasonNow());
  const std::string whole = (last == '\n' ? "" : "\n") + std::string(line) + "\n";
  if (!writeAll(out.get(), whole) || ::fsync(out.get()) != 0) return notPrivate(file, reasonNow());
  return {};
}

Result<void> closeToOthers(const fs::path& folder) {
  if (auto made = makePrivateFolder(folder); !made) return made;
  std::error_code problem;
  for (fs::recursive_directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem)) {
    const auto type = at->symlink_status(problem).type();
    if (problem) break;
    if (type == fs::file_type::directory)
      fs::permissions(at->path(), fs::perms::owner_all, problem);
    else if (type == fs::file_type::regular)
      fs::permissions(at->path(), fs::perms::owner_read | fs::perms::owner_write, problem);
    if (problem) break;
  }
  if (problem) return notPrivate(folder, verbatim(problem.message()));
  return {};
}

void closeFileToOthers(const fs::path& file) {
  const OpenFile opened(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat found {};
  if (!opened.isOpen() || ::fstat(opened.get(), &found) != 0 || !strangeness(found).empty()) return;
  if ((found.st_mode & kOthers) != 0) static_cast<void>(::fchmod(opened.get(), 0600));
}

}  // namespace ew
