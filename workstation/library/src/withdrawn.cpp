#include "ew/library/withdrawn.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string>

#include "ew/library/case.h"
#include "ew/library/folder_lease.h"
#include "ew/library/moment.h"
#include "ew/library/published.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool liesIn(const fs::path& parent, const fs::path& child) {
  std::error_code failed;
  return fs::equivalent(parent, child, failed);
}

/// What is moved: the own case itself, or the folder of all revisions.
Result<fs::path> movedFolderOf(const fs::path& caseFolder, const fs::path& library) {
  std::error_code failed;
  if (!fs::is_directory(caseFolder, failed))
    return failure(ErrorCode::notFound, say<"There is no case in '%1'; check the name.">(caseFolder), {{"file", caseFolder.string()}});
  const fs::path folder = fs::weakly_canonical(caseFolder, failed);
  if (isShipped(folder))
    return failure(ErrorCode::badUsage, say<"'%1' comes with the program and cannot be taken out of the library.">(folder.filename()));
  if (liesIn(library / "cases", folder.parent_path()) || liesIn(ownCasesFolder(), folder.parent_path())) return folder;
  if (liesIn(publishedFolder(library), folder.parent_path().parent_path())) return folder.parent_path();
  return failure(ErrorCode::badUsage,
                 say<"'%1' does not lie in the library '%2', so that there is nothing to take out of it.">(folder, library),
                 {{"file", folder.string()}});
}

/// The number of the last revision stays taken, by an empty folder: attempts name a revision, and must not find another content under it.
void keepNumber(const fs::path& from, const fs::path& target, const fs::path& library) {
  std::error_code failed;
  if (!liesIn(publishedFolder(library), from.parent_path())) return;
  int last = 0;
  for (fs::directory_iterator at(target, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    int number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    if (read.ec == std::errc() && read.ptr == name.data() + name.size()) last = std::max(last, number);
  }
  if (last > 0) fs::create_directories(from / std::to_string(last), failed);
}

}  // namespace

fs::path withdrawnFolder(const fs::path& library) { return library / "withdrawn"; }

Result<fs::path> withdrawCase(const fs::path& caseFolder, const fs::path& library) {
  const auto from = movedFolderOf(caseFolder, library);
  if (!from) return from;
  if (const auto holder = FolderLease::holderOf(*from))
    return failure(ErrorCode::notWritable, say<"%1 is editing the case at this moment; take it out when it is closed there.">(holder->user),
                   {{"file", from->string()}, {"user", holder->user}});
  std::error_code failed;
  fs::create_directories(withdrawnFolder(library), failed);
  std::string stamp = momentText(std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  std::erase(stamp, ':');
  const std::string name = stamp + '-' + from->filename().string();
  fs::path target = withdrawnFolder(library) / name;
  for (int n = 2; fs::exists(target, failed); ++n) target = withdrawnFolder(library) / (name + '-' + std::to_string(n));
  fs::rename(*from, target, failed);
  if (failed)
    return failure(ErrorCode::notWritable, say<"'%1' cannot be moved (%2); nothing was changed.">(*from, failed.message()),
                   {{"file", from->string()}});
  keepNumber(*from, target, library);
  return target;
}

}  // namespace ew
