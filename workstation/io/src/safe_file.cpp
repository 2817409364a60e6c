#include "ew/io/safe_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <system_error>

#include "image_header.h"
#include "staged_file.h"

namespace ew {
namespace fs = std::filesystem;
namespace detail {
namespace {

/// A name nobody else uses, beside the target: renaming works only within one file system.
fs::path asideName(const fs::path& target, const char* ending) {
  static std::atomic<unsigned> counter{0};
  std::string name =
      "." + target.filename().string().substr(0, 200) + "." + std::to_string(getpid()) + "-" + std::to_string(counter++) + ending;
  return target.parent_path() / name;
}

std::string reasonOf(int number) { return std::generic_category().message(number); }

bool syncPath(const fs::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool synced = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return synced;
}

}  // namespace

tl::unexpected<Error> notWritable(const fs::path& file, const std::string& reason) {
  return failure(ErrorCode::notWritable,
                 "\"" + file.string() + "\" cannot be written (" + reason + "); choose another place or free some room.",
                 {{"file", file.string()}, {"reason", reason}});
}

Result<StagedFile> StagedFile::create(const fs::path& target) {
  StagedFile staged;
  std::error_code problem;
  if (target.filename().empty()) return notWritable(target, "it names no file");
  // A link is followed, so that what it points to is replaced and not the link itself.
  staged.target_ = fs::is_symlink(fs::symlink_status(target, problem)) ? fs::weakly_canonical(target, problem) : target;
  if (problem && problem != std::errc::no_such_file_or_directory && problem != std::errc::not_a_directory)
    return notWritable(target, problem.message());
  const auto status = fs::status(staged.target_, problem);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return notWritable(target, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  if (fs::exists(status) && ::access(staged.target_.c_str(), W_OK) != 0) return notWritable(target, reasonOf(errno));
  for (int attempt = 0; attempt < 100; ++attempt) {
    staged.aside_ = asideName(staged.target_, ".part");
    const int descriptor = ::open(staged.aside_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      if (errno == EEXIST) continue;
      const std::string reason = reasonOf(errno);
      staged.aside_.clear();
      return notWritable(target, reason);
    }
    if (fs::exists(status)) ::fchmod(descriptor, static_cast<mode_t>(status.permissions()) & 07777);
    ::close(descriptor);
    staged.out_.open(staged.aside_, std::ios::binary | std::ios::trunc);
    if (!staged.out_) return notWritable(target, "its neighbour could not be opened");
    return staged;
  }
  staged.aside_.clear();
  return notWritable(target, "no free name beside it");
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      aside_(std::move(other.aside_)),
      earlier_(std::move(other.earlier_)),
      out_(std::move(other.out_)),
      committed_(other.committed_) {
  other.aside_.clear();
  other.earlier_.clear();
}

StagedFile::~StagedFile() {
  std::error_code ignored;
  if (out_.is_open()) out_.close();
  if (!aside_.empty()) fs::remove(aside_, ignored);
  if (!earlier_.empty()) fs::remove(earlier_, ignored);
}

Result<void> StagedFile::finish() {
  errno = 0;
  out_.flush();
  const bool written = out_.good();
  out_.close();
  if (!written || out_.fail()) return notWritable(target_, errno != 0 ? reasonOf(errno) : "the medium is full or gone");
  if (!syncPath(aside_, O_RDONLY)) return notWritable(target_, reasonOf(errno));
  return {};
}

Result<void> StagedFile::keepEarlier() {
  std::error_code problem;
  if (!fs::exists(target_, problem)) return {};
  const fs::path kept = asideName(target_, ".earlier");
  fs::create_hard_link(target_, kept, problem);
  if (problem) {
    // File systems without hard links: a copy does the same, slower.
    problem.clear();
    fs::copy_file(target_, kept, problem);
  }
  if (problem) {
    std::error_code ignored;
    fs::remove(kept, ignored);
    return notWritable(target_, problem.message());
  }
  earlier_ = kept;
  return {};
}

Result<void> StagedFile::commit() {
  std::error_code problem;
  fs::rename(aside_, target_, problem);
  if (problem) return notWritable(target_, problem.message());
  aside_.clear();
  committed_ = true;
  // The rename itself must survive a power cut; where a folder cannot be synced the file is complete all the same.
  const fs::path folder = target_.parent_path();
  syncPath(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  return {};
}

void StagedFile::undo() {
  if (!committed_) return;
  std::error_code ignored;
  if (earlier_.empty()) {
    fs::remove(target_, ignored);
  } else {
    fs::rename(earlier_, target_, ignored);
    if (!ignored) earlier_.clear();
  }
  committed_ = false;
}

}  // namespace detail

Result<void> writeFileSafely(const fs::path& file, const std::function<Result<void>(std::ostream&)>& write) {
  auto staged = detail::StagedFile::create(file);
  if (!staged) return passOn(staged.error());
  try {
    if (auto written = write(staged->stream()); !written) return written;
  } catch (const std::exception& thrown) {
    return failure(ErrorCode::internal, "\"" + file.string() + "\" was not written because of a fault in the program; try again.",
                   {{"file", file.string()}, {"reason", thrown.what()}});
  }
  if (auto finished = staged->finish(); !finished) return finished;
  return staged->commit();
}

Result<void> writeFileSafely(const fs::path& file, std::string_view text) {
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    return {};
  });
}

Result<std::string> readTextFile(const fs::path& file, std::size_t maxBytes) {
  if (const auto status = detail::checkIsFile(file); !status) return passOn(status.error());
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return failure(ErrorCode::notReadable, detail::quoted(file) + " cannot be opened; check its permissions.", {{"file", file.string()}});
  // The size on disk is not asked for: files under /proc have none, and a growing file has an old one.
  std::string text;
  std::string chunk(64u << 10, '\0');
  while (in) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
    if (text.size() > maxBytes)
      return failure(
          ErrorCode::tooLarge,
          detail::quoted(file) + " has more than the " + std::to_string(maxBytes) + " bytes allowed here; check that it is the right file.",
          {{"file", file.string()}, {"limit", std::to_string(maxBytes)}});
  }
  if (in.bad())
    return failure(ErrorCode::notReadable, detail::quoted(file) + " cannot be read; check the medium it is on.", {{"file", file.string()}});
  return text;
}

}  // namespace ew
