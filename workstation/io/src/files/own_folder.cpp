#include "ew/io/own_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "ew/core/foreign_json.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {

namespace fs = std::filesystem;

std::string OwnFolder::make() {
  if (isMade()) return {};
  if (auto made = makePrivateFolder(root_); !made) return made.error().message.english();
  std::string name = (root_ / "XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return std::generic_category().message(errno);
  auto lock = FileLock::take(fs::path(name) / kLock, {}, noProgress(), 0600);  // somebody may be looking whether it is held
  if (!lock) {
    std::error_code ignored;
    fs::remove_all(name, ignored);
    return lock.error().message.english();
  }
  folder_ = name;
  lock_ = std::move(*lock);
  return {};
}

void OwnFolder::remove() {
  if (!isMade()) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  leave();
}

void OwnFolder::leave() {
  if (!isMade()) return;
  lock_.reset();
  folder_.clear();
}

std::optional<FileLock> OwnFolder::lockOfAbandoned(const fs::path& folder) {
  auto lock = FileLock::tryTakeExisting(folder / kLock);
  std::error_code ignored;
  if (lock && !fs::exists(folder / kLock, ignored)) lock.reset();  // somebody decided about it between the two calls
  return lock;
}

std::vector<fs::path> OwnFolder::left() const {
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator at(root_, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (at->path() == folder_ || !at->is_directory(ignored)) continue;
    // Without a lock it was copied here, or cut off in the middle of being made: nobody holds it.
    if (!fs::exists(at->path() / kLock, ignored) || lockOfAbandoned(at->path())) found.push_back(at->path());
  }
  return found;
}

Result<void> OwnFolder::writeNote(const std::string& file, const nlohmann::json& note) const {
  return writeFileSafely(folder_ / file, note.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::vector<OwnFolder::Left> OwnFolder::leftWith(const std::string& file) const {
  constexpr std::size_t kLargestNote_bytes = 8u << 20;
  std::vector<Left> found;
  for (const fs::path& folder : left()) {
    std::error_code failed;
    const auto text = readTextFile(folder / file, kLargestNote_bytes);
    const auto written = fs::last_write_time(folder / file, failed);
    if (!text || failed) continue;
    if (auto note = jsonOrNull(*text); note.is_object()) found.push_back({folder, std::move(note), written});
  }
  std::sort(found.begin(), found.end(), [](const Left& a, const Left& b) { return a.written > b.written; });
  return found;
}

void OwnFolder::discard(const fs::path& folder, const std::vector<fs::path>& files) {
  std::error_code ignored;
  for (const fs::path& file : files) fs::remove(folder / file, ignored);
  fs::remove(folder / kLock, ignored);
  fs::remove(folder, ignored);
}

std::chrono::system_clock::time_point systemTimeOf(fs::file_time_type time) {
  const auto age = fs::file_time_type::clock::now() - time;
  return std::chrono::system_clock::now() - std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
}

}  // namespace ew
