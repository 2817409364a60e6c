#include "ew/library/kept_edits.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFile = "case-edits.json";
constexpr const char* kLock = "lock";
constexpr std::size_t kLargest_bytes = 8u << 20;  // a manifest has at most half of it

int openLock(const fs::path& folder, int flags) { return ::open((folder / kLock).c_str(), O_RDWR | O_CLOEXEC | flags, 0600); }

/// Whether the program that made the folder is gone.
bool isAbandoned(const fs::path& folder) {
  const int lock = openLock(folder, 0);
  if (lock < 0) return errno == ENOENT;
  const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  ::close(lock);
  return free;
}

std::optional<KeptEdits::Left> read(const fs::path& folder) {
  const fs::path file = folder / kFile;
  const auto text = readTextFile(file, kLargest_bytes);
  if (!text) return std::nullopt;
  auto kept = parseJson(*text, verbatim(kFile));
  if (!kept || !kept->is_object()) return std::nullopt;
  const auto place = kept->find("case_folder"), manifest = kept->find("manifest"), size = kept->find("read_bytes"),
             hash = kept->find("read_hash");
  const auto end = kept->end();
  if (place == end || !place->is_string() || manifest == end || !manifest->is_object() || size == end || !size->is_number_unsigned() ||
      hash == end || !hash->is_number_unsigned())
    return std::nullopt;
  std::error_code failed;
  const auto written = fs::last_write_time(file, failed);
  if (failed) return std::nullopt;
  const auto age = fs::file_time_type::clock::now() - written;
  return KeptEdits::Left{folder,
                         place->get<std::string>(),
                         std::move(*manifest),
                         {size->get<std::uint64_t>(), hash->get<std::uint64_t>()},
                         std::chrono::system_clock::now() - std::chrono::duration_cast<std::chrono::system_clock::duration>(age)};
}

}  // namespace

KeptEdits::KeptEdits(fs::path root) : root_(std::move(root)) {}

KeptEdits::~KeptEdits() { forget(); }

Result<void> KeptEdits::makeFolder() {
  if (lock_ >= 0) return {};
  std::error_code failed;
  fs::create_directories(root_, failed);
  std::string name = (root_ / "XXXXXX").string();
  const auto refuse = [&](const std::string& reason) {
    return failure(
        ErrorCode::notWritable,
        say<"Unsaved changes of the case cannot be kept in '%1' (%2), so a crash would lose them; save the case often.">(root_, reason),
        {{"folder", root_.string()}});
  };
  if (failed) return refuse(failed.message());
  if (::mkdtemp(name.data()) == nullptr) return refuse(std::generic_category().message(errno));
  folder_ = name;
  lock_ = openLock(folder_, O_CREAT);
  if (lock_ < 0) {
    const std::string reason = std::generic_category().message(errno);
    fs::remove_all(folder_, failed);
    return refuse(reason);
  }
  // Without locks (some network file systems) another program may offer what this one still keeps; nothing is lost by it.
  static_cast<void>(::flock(lock_, LOCK_EX));
  return {};
}

Result<void> KeptEdits::keep(const Case& edited, const Fingerprint& asRead) {
  if (auto made = makeFolder(); !made) return made;
  const json kept = {{"case_folder", edited.folder.string()},
                     {"manifest", manifestOf(edited)},
                     {"read_bytes", asRead.size_bytes},
                     {"read_hash", asRead.hash}};
  return writeFileSafely(folder_ / kFile, kept.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

void KeptEdits::forget() {
  if (lock_ < 0) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  ::close(lock_);
  lock_ = -1;
  folder_.clear();
}

std::vector<KeptEdits::Left> KeptEdits::left() const {
  std::vector<Left> found;
  std::error_code failed;
  for (fs::directory_iterator at(root_, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    const fs::path& folder = at->path();
    std::error_code ignored;
    if (folder == folder_ || !fs::is_directory(folder, ignored) || !isAbandoned(folder)) continue;
    if (auto left = read(folder)) found.push_back(std::move(*left));
  }
  std::sort(found.begin(), found.end(), [](const Left& a, const Left& b) { return a.at > b.at; });
  return found;
}

void KeptEdits::remove(const Left& decided) {
  std::error_code ignored;
  fs::remove(decided.kept / kFile, ignored);
  fs::remove(decided.kept / kLock, ignored);
  fs::remove(decided.kept, ignored);  // only when nothing else lies in it
}

}  // namespace ew
