#include <algorithm>
#include <map>

#include "ew/library/case.h"
#include "ew/library/checksums.h"
#include "ew/library/content_name.h"
#include "files/file_pieces.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

Error problemOfFile(const FileSum& file, ErrorCode code, Message sentence) { return {code, std::move(sentence), {{"file", file.path}}}; }

Error missing(const FileSum& file) {
  return problemOfFile(file, ErrorCode::notFound, say<"\"%1\" is missing; put it back, or import or publish the case again.">(file.path));
}

Error changed(const FileSum& file) {
  return problemOfFile(
      file, ErrorCode::badField,
      say<"\"%1\" is not what was kept: its content has changed; put the kept file back, or import or publish the case again.">(file.path));
}

Error extra(const FileSum& file) {
  return problemOfFile(file, ErrorCode::badField, say<"\"%1\" does not belong to the case; move it to another place.">(file.path));
}

Error misnamed(const FileSum& file) {
  return problemOfFile(
      file, ErrorCode::badField,
      say<"\"%1\" is named by its content and holds something else: it has changed; put the kept file back or choose the volume again.">(
          file.path));
}

void compare(const std::vector<FileSum>& kept, const std::vector<FileSum>& found, std::vector<Error>& problems) {
  std::map<std::string, const FileSum*> there;
  for (const FileSum& each : found) there.emplace(each.path, &each);
  for (const FileSum& each : kept) {
    const auto at = there.find(each.path);
    if (at == there.end())
      problems.push_back(missing(each));
    else if (*at->second != each)
      problems.push_back(changed(each));
    if (at != there.end()) there.erase(at);
  }
  for (const auto& [path, each] : there) problems.push_back(extra(*each));
}

}  // namespace

Result<CaseCheck> verifyCase(const fs::path& folder, Progress& progress) {
  return guardedCase(folder, [&]() -> Result<CaseCheck> {
    CaseCheck check;
    auto found = sumsOfCase(folder, progress);
    if (!found && (found.error().code == ErrorCode::unsupported || found.error().code == ErrorCode::badField)) {
      check.problems.push_back(found.error());
      return check;
    }
    if (!found) return passOn(found.error());
    check.files = found->size();
    check.bytes = bytesOf(*found);
    const auto kept = readSums(folder);
    check.hasSums = kept || kept.error().code != ErrorCode::notFound;
    if (kept)
      compare(*kept, *found, check.problems);
    else if (check.hasSums)
      check.problems.push_back(kept.error());
    for (const FileSum& each : *found)
      if (isContentNamed(each.path) && !namesItsContent(each.path, each.sha256)) check.problems.push_back(misnamed(each));
    for (Error& problem : validateCase(folder)) check.problems.push_back(std::move(problem));
    return check;
  });
}

}  // namespace ew
