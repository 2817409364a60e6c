#include "files/private_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace ew {
namespace {

namespace fs = std::filesystem;

fs::path temporaryFiles() {
  std::error_code error;
  fs::path found = fs::temp_directory_path(error);
  return error ? fs::path("/tmp") : found;
}

/// A folder and no link to one, ours, and closed to everybody else.
bool isOwn(const fs::path& folder) {
  struct stat found {};
  return ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::geteuid() && (found.st_mode & 077) == 0;
}

}  // namespace

std::optional<PrivateFolder> PrivateFolder::make() { return makeNamed((temporaryFiles() / "echoweave-XXXXXX").string()); }

std::optional<PrivateFolder> PrivateFolder::makeBeside(const fs::path& file) {
  std::error_code failed;
  return makeNamed((fs::absolute(file, failed).parent_path() / ".echoweave-XXXXXX").string());
}

std::optional<PrivateFolder> PrivateFolder::makeNamed(std::string pattern) {
  if (::mkdtemp(pattern.data()) == nullptr) return std::nullopt;
  return PrivateFolder(std::move(pattern));
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

fs::path ownTemporaryFolder(const std::string& name) {
  fs::path folder = temporaryFiles() / (name + "-" + std::to_string(::geteuid()));
  static_cast<void>(::mkdir(folder.c_str(), 0700));  // what stands there decides, whoever made it
  if (isOwn(folder)) return folder;
  static const std::optional<PrivateFolder> instead = PrivateFolder::make();
  return instead ? instead->path() : folder;
}

}  // namespace ew
