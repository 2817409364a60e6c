#include "logic/kept_painting.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "ew/core/foreign_json.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"

namespace ew::case_authoring {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPaintingFile = "painting.json";
constexpr const char* kPaintingLock = "lock";

/// Whether the program that made the folder is gone.
bool isLeft(const fs::path& folder) {
  const int lock = ::open((folder / kPaintingLock).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return errno == ENOENT;
  const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  ::close(lock);
  return free;
}

std::optional<KeptPainting::Left> leftIn(const fs::path& folder) {
  const auto text = readTextFile(folder / kPaintingFile, 1u << 20);
  if (!text) return std::nullopt;
  const auto kept = jsonOrNull(*text);
  const auto field = [&](const char* key) { return textAt(kept, key); };
  // A name made by addVolume, never a path that leads elsewhere.
  if (field("case_folder").empty() || !isContentNamed(field("labels"))) return std::nullopt;
  return KeptPainting::Left{folder, field("case_folder"), field("labels"), field("before")};
}

}  // namespace

KeptPainting::KeptPainting(fs::path root) : root_(std::move(root)) {}

KeptPainting::~KeptPainting() { forget(); }

Result<void> KeptPainting::makeFolder() {
  if (lock_ >= 0) return {};
  std::error_code failed;
  fs::create_directories(root_, failed);
  std::string name = (root_ / "XXXXXX").string();
  if (!failed && ::mkdtemp(name.data()) != nullptr) {
    folder_ = name;
    lock_ = ::open((folder_ / kPaintingLock).c_str(), O_RDWR | O_CLOEXEC | O_CREAT, 0600);
  }
  if (lock_ < 0)
    return failure(ErrorCode::notWritable,
                   say<"What is painted cannot be kept in '%1', so a crash would lose it; keep it in the case often.">(root_),
                   {{"folder", root_.string()}});
  // Without locks (some network file systems) another program may offer what this one still keeps; nothing is lost by it.
  static_cast<void>(::flock(lock_, LOCK_EX));
  return {};
}

Result<void> KeptPainting::keep(const Volume& labels, const fs::path& caseFolder, const std::string& before, Progress& progress) {
  const std::lock_guard lock(guard_);
  if (auto made = makeFolder(); !made) return made;
  auto name = addVolume(labels, folder_, progress);
  if (!name) return passOn(name.error());
  const nlohmann::json kept = {{"case_folder", caseFolder.string()}, {"labels", *name}, {"before", before}};
  if (auto written = writeFileSafely(folder_ / kPaintingFile, kept.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
      !written)
    return written;
  // Those before are not named any more.
  std::error_code ignored;
  for (fs::directory_iterator at(folder_ / "volumes", ignored); !ignored && at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().filename() != fs::path(*name).filename()) fs::remove(at->path(), ignored);
  return {};
}

void KeptPainting::forget() {
  const std::lock_guard lock(guard_);
  if (lock_ < 0) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  ::close(lock_);
  lock_ = -1;
  folder_.clear();
}

void KeptPainting::leave() {
  const std::lock_guard lock(guard_);
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  folder_.clear();
}

std::optional<KeptPainting::Left> KeptPainting::leftFor(const fs::path& caseFolder) const {
  const std::lock_guard lock(guard_);
  std::optional<Left> latest;
  fs::file_time_type at = fs::file_time_type::min();
  std::error_code failed;
  for (fs::directory_iterator each(root_, failed); !failed && each != fs::directory_iterator(); each.increment(failed)) {
    const fs::path& folder = each->path();
    std::error_code ignored;
    if (folder == folder_ || !fs::is_directory(folder, ignored) || !isLeft(folder)) continue;
    const auto left = leftIn(folder);
    const auto written = fs::last_write_time(folder / kPaintingFile, ignored);
    if (!left || left->caseFolder != caseFolder || (latest && written <= at)) continue;
    latest = left;
    at = written;
  }
  return latest;
}

Result<Volume> KeptPainting::read(const Left& left, Progress& progress) {
  auto labels = readLabelVolume(left.kept / left.labels, progress);
  if (!labels) return passOn(labels.error());
  return std::move(labels->volume);
}

void KeptPainting::remove(const Left& decided) {
  std::error_code ignored;
  fs::remove(decided.kept / decided.labels, ignored);
  fs::remove(decided.kept / "volumes", ignored);  // only when nothing else lies in it
  fs::remove(decided.kept / kPaintingFile, ignored);
  fs::remove(decided.kept / kPaintingLock, ignored);
  fs::remove(decided.kept, ignored);
}

}  // namespace ew::case_authoring
