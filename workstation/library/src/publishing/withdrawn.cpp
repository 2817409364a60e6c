#include "ew/library/withdrawn.h"

#include <vector>

#include "case/revisions.h"
#include "ew/library/case.h"
#include "ew/library/folder_lease.h"
#include "ew/library/instructor_log.h"
#include "ew/library/learning_progress.h"
#include "ew/library/published.h"
#include "publishing/stamped_place.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool liesIn(const fs::path& parent, const fs::path& child) {
  std::error_code failed;
  return fs::equivalent(parent, child, failed);
}

/// What is moved: the own case itself, or the folder of all revisions.
struct Moved {
  fs::path folder;
  std::string id;
  bool isPublished = false;
};

Result<Moved> movedBy(const fs::path& caseFolder, const fs::path& library) {
  std::error_code failed;
  if (!fs::is_directory(caseFolder, failed))
    return failure(ErrorCode::notFound, say<"There is no case in '%1'; check the name.">(caseFolder), {{"file", caseFolder.string()}});
  const fs::path folder = fs::weakly_canonical(caseFolder, failed);
  if (isShipped(folder))
    return failure(ErrorCode::badUsage, say<"'%1' comes with the program and cannot be taken out of the library.">(folder.filename()));
  if (liesIn(library / "cases", folder.parent_path()) || liesIn(ownCasesFolder(), folder.parent_path())) {
    const auto opened = loadCase(folder);
    return Moved{folder, opened ? opened->id : folder.filename().string(), false};
  }
  for (const fs::path& all : {folder, folder.parent_path()})
    if (liesIn(publishedFolder(library), all.parent_path()) && isCaseId(all.filename().string()))
      return Moved{all, all.filename().string(), true};
  return failure(ErrorCode::badUsage,
                 say<"'%1' does not lie in the library '%2', so that there is nothing to take out of it.">(folder, library),
                 {{"file", folder.string()}});
}

}  // namespace

fs::path withdrawnFolder(const fs::path& library) { return library / "withdrawn"; }

Result<WithdrawnCase> withdrawCase(const fs::path& caseFolder, const fs::path& library, const std::string& person) {
  const auto moved = movedBy(caseFolder, library);
  if (!moved) return passOn(moved.error());
  const fs::path& from = moved->folder;
  if (const auto holder = FolderLease::holderOf(from))
    return failure(ErrorCode::notWritable, say<"%1 is editing the case at this moment; take it out when it is closed there.">(holder->user),
                   {{"file", from.string()}, {"user", holder->user}});
  const fs::path target = stampedPlace(withdrawnFolder(library), "-" + from.filename().string());
  const auto move = [&]() -> Result<void> {
    std::error_code failed;
    fs::rename(from, target, failed);
    if (failed)
      return failure(ErrorCode::notWritable, say<"'%1' cannot be moved (%2); nothing was changed.">(from, failed.message()),
                     {{"file", from.string()}});
    // Not before: that a folder cannot be moved to another medium is known when it was tried, and the log may not say what did not happen.
    auto logged = logChange(library, "case withdrawn", moved->id, from.string(), target.string(), person);
    if (!logged) fs::rename(target, from, failed);
    return logged;
  };
  if (auto done = moved->isPublished ? takeRevisionsAway(library, moved->id, move) : move(); !done) return passOn(done.error());
  return WithdrawnCase{moved->id, from, target};
}

Result<fs::path> caseToWithdraw(const std::string& id, const fs::path& library) {
  std::vector<fs::path> named = ownCases(id, library);
  if (!takenPublished(library, id).empty()) named.push_back(publishedFolder(library) / id);
  if (named.size() > 1) {
    std::string folders;
    for (const fs::path& each : named) folders += (folders.empty() ? "'" : ", '") + each.string() + "'";
    return failure(ErrorCode::badUsage, say<"'%1' is the id of several cases; name the folder of the one to take out: %2.">(id, folders),
                   {{"case", id}});
  }
  if (!named.empty()) return named.front();
  if (auto shipped = findCase(id, library)) return *shipped;  // withdrawCase says that it comes with the program
  return failure(
      ErrorCode::notFound,
      say<"There is no case '%1' in the library '%2'; give the folder or the id of a case that is your own or published.">(id, library),
      {{"case", id}});
}

}  // namespace ew
