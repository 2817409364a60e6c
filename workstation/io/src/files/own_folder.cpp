#include "ew/io/own_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "ew/io/private_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

int openLock(const fs::path& folder, int flags) {
  return ::open((folder / OwnFolder::kLock).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
}

}  // namespace

std::string OwnFolder::make() {
  if (isMade()) return {};
  if (auto made = makePrivateFolder(root_); !made) return made.error().message.english();
  std::string name = (root_ / "XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return std::generic_category().message(errno);
  lock_ = openLock(name, O_CREAT);
  if (lock_ < 0) {
    const std::string reason = std::generic_category().message(errno);
    std::error_code ignored;
    fs::remove_all(name, ignored);
    return reason;
  }
  folder_ = name;
  static_cast<void>(::flock(lock_, LOCK_EX));
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
  ::close(lock_);
  lock_ = -1;
  folder_.clear();
}

int OwnFolder::lockOfAbandoned(const fs::path& folder) {
  const int lock = openLock(folder, 0);
  if (lock < 0) return -1;
  while (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    ::close(lock);
    return -1;
  }
  std::error_code ignored;
  if (fs::exists(folder / kLock, ignored)) return lock;
  ::close(lock);  // somebody decided about it between the two calls
  return -1;
}

std::vector<fs::path> OwnFolder::left() const {
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator at(root_, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (at->path() == folder_ || !at->is_directory(ignored)) continue;
    if (!fs::exists(at->path() / kLock, ignored)) {
      found.push_back(at->path());  // copied here, or cut off in the middle of being made: nobody holds it
      continue;
    }
    const int lock = lockOfAbandoned(at->path());
    if (lock < 0) continue;
    ::close(lock);
    found.push_back(at->path());
  }
  return found;
}

}  // namespace ew
