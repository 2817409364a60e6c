#include <algorithm>
#include <set>

#include "ew/library/case_contents.h"
#include "ew/library/checksums.h"
#include "ew/library/folder_lease.h"
#include "ew/library/published.h"
#include "files/guarded_case.h"
#include "publishing/stamped_place.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Whether files may be taken out of the folder at all.
Result<void> expectOwn(const Case& opened, CaseEditor editor) {
  const auto refuse = [&](Message sentence) {
    return failure(ErrorCode::notWritable, std::move(sentence), {{"file", opened.folder.string()}});
  };
  if (opened.folder.empty() || isShipped(opened.folder) || isPublished(opened.folder))
    return refuse(say<"The case is not your own, so that nothing is taken out of its folder; save it as your own case first.">());
  if (opened.sealed)
    return refuse(say<"The case is an examination: attempts at it are judged by its files, and nothing is taken out of them.">());
  if (editor == CaseEditor::nobody)
    if (const auto holder = FolderLease::holderOf(opened.folder))
      return refuse(say<"%1 is editing the case at this moment; take files out there, or when it is closed there.">(holder->user));
  return {};
}

/// The files that are meant, each once, when all of them may go.
Result<std::set<std::string>> freeFiles(const Case& opened, const std::vector<std::string>& paths) {
  const auto uses = fileUsesOf(opened);
  if (!uses) return passOn(uses.error());
  for (const std::string& path : paths) {
    const auto use = std::find_if(uses->begin(), uses->end(), [&](const CaseFileUse& each) { return each.path == path; });
    if (use == uses->end())
      return failure(ErrorCode::notFound,
                     say<"The case has no file '%1'; name it by its path in the case folder, as 'echoweave case files' lists it.">(path),
                     {{"file", path}});
    const bool goesWithLinks =
        use->usedBy.size() == use->linkedBy.size() && std::all_of(use->linkedBy.begin(), use->linkedBy.end(), [&](const std::string& link) {
          return std::find(paths.begin(), paths.end(), link) != paths.end();
        });
    if (!goesWithLinks)
      return failure(ErrorCode::badUsage, say<"'%1' is used by %2, and stays.">(path, joined(use->usedBy, ", ")), {{"file", path}});
  }
  return std::set<std::string>(paths.begin(), paths.end());
}

/// What is taken out stays in the case's folder: a link there would lead it elsewhere.
Result<void> expectOwnPlace(const fs::path& caseFolder) {
  std::error_code ignored;
  const fs::path place = caseFolder / kWithdrawnFiles;
  const auto type = fs::symlink_status(place, ignored).type();
  if (type == fs::file_type::not_found || type == fs::file_type::directory) return {};
  return failure(ErrorCode::notWritable,
                 say<"'%1' is a link or a file, and what is taken out lies in a folder of that name; move it away.">(place),
                 {{"file", place.string()}});
}

/// Moves every file or none. @error notWritable
template <class Paths>
Result<void> moveAll(const Paths& paths, const fs::path& from, const fs::path& to) {
  std::vector<std::string> moved;
  for (const std::string& path : paths) {
    std::error_code failed;
    fs::create_directories((to / path).parent_path(), failed);
    if (!failed) fs::rename(from / path, to / path, failed);
    if (failed) {
      std::error_code ignored;
      for (const std::string& each : moved) fs::rename(to / each, from / each, ignored);
      return failure(ErrorCode::notWritable,
                     say<"'%1' cannot be moved (%2); nothing was changed.">(from / path, verbatim(failed.message())),
                     {{"file", (from / path).string()}});
    }
    moved.push_back(path);
  }
  return {};
}

/// Folders in which nothing is left, up to `top`, which goes as well.
void removeEmptyFolders(const std::vector<std::string>& paths, const fs::path& top) {
  std::error_code ignored;
  for (const std::string& path : paths)
    for (fs::path at = fs::path(path).parent_path(); !at.empty(); at = at.parent_path())
      fs::remove(top / at, ignored);  // only an empty one
  fs::remove(top, ignored);
}

std::vector<std::string> filesBelow(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code failed;
  fs::recursive_directory_iterator at(folder, failed), end;
  for (; !failed && at != end; at.increment(failed))
    if (at->symlink_status(failed).type() != fs::file_type::directory)
      paths.push_back(at->path().lexically_relative(folder).generic_string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

Result<WithdrawnFiles> withdrawFiles(const Case& opened, const std::vector<std::string>& paths, CaseEditor editor) {
  return guardedCase(opened.folder, [&]() -> Result<WithdrawnFiles> {
    if (auto own = expectOwn(opened, editor); !own) return passOn(own.error());
    const auto wanted = freeFiles(opened, paths);
    if (!wanted) return passOn(wanted.error());
    if (auto place = expectOwnPlace(opened.folder); !place) return passOn(place.error());
    WithdrawnFiles taken{opened.folder, stampedPlace(opened.folder / kWithdrawnFiles, {}), {wanted->begin(), wanted->end()}};
    if (auto moved = moveAll(taken.paths, taken.caseFolder, taken.folder); !moved) return passOn(moved.error());
    return taken;
  });
}

Result<void> putBack(const WithdrawnFiles& taken) {
  return guardedCase(taken.caseFolder, [&]() -> Result<void> {
    std::error_code ignored;
    for (const std::string& path : taken.paths)
      if (fs::exists(fs::symlink_status(taken.caseFolder / path, ignored)))
        return failure(ErrorCode::notWritable,
                       say<"The case has another file '%1' by now, so that nothing was put back; take that one out first.">(path),
                       {{"file", path}});
    if (auto moved = moveAll(taken.paths, taken.folder, taken.caseFolder); !moved) return moved;
    removeEmptyFolders(taken.paths, taken.folder);
    fs::remove(taken.folder.parent_path(), ignored);  // only an empty one
    return {};
  });
}

std::vector<std::pair<int, std::vector<std::string>>> stillPublished(const WithdrawnFiles& taken, const std::string& caseId,
                                                                     const fs::path& library) {
  std::vector<std::pair<int, std::vector<std::string>>> held;
  const auto revisions = publishedRevisions(library, caseId);
  if (revisions.empty()) return held;
  std::vector<std::pair<std::string, std::string>> sums;  // path and sum
  for (const std::string& path : taken.paths)
    if (auto sum = sha256Of(taken.folder / path)) sums.emplace_back(path, *std::move(sum));
  for (const CaseRevision& each : revisions) {
    const auto files = readSums(each.folder);
    if (!files) continue;
    std::vector<std::string> there;
    for (const auto& [path, sum] : sums)
      if (std::any_of(files->begin(), files->end(), [&, &sum = sum](const FileSum& file) { return file.sha256 == sum; }))
        there.push_back(path);
    if (!there.empty()) held.emplace_back(each.revision, std::move(there));
  }
  return held;
}

std::vector<WithdrawnFiles> withdrawnFilesOf(const fs::path& caseFolder) {
  std::vector<WithdrawnFiles> all;
  std::error_code failed;
  for (fs::directory_iterator at(caseFolder / kWithdrawnFiles, failed), end; !failed && at != end; at.increment(failed)) {
    std::error_code ignored;
    if (at->symlink_status(ignored).type() != fs::file_type::directory) continue;
    WithdrawnFiles taken{caseFolder, at->path(), filesBelow(at->path())};
    if (!taken.paths.empty()) all.push_back(std::move(taken));
  }
  std::sort(all.begin(), all.end(), [](const WithdrawnFiles& a, const WithdrawnFiles& b) { return a.folder > b.folder; });
  return all;
}

}  // namespace ew
