#include <utility>

#include "case/outgoing_case.h"
#include "ew/library/case.h"
#include "ew/library/checksums.h"
#include "ew/library/content_name.h"
#include "files/file_pieces.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

Error misnamed(const FileSum& file) {
  return {
      ErrorCode::badField,
      say<"\"%1\" is named by its content and holds something else: it has changed; put the kept file back or choose the volume again.">(
          file.path),
      {{"file", file.path}}};
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
      check.problems = differencesOf(*kept, *found);
    else if (check.hasSums)
      check.problems.push_back(kept.error());
    for (const FileSum& each : *found)
      if (isContentNamed(each.path) && !namesItsContent(each.path, each.sha256)) check.problems.push_back(misnamed(each));
    for (Error& problem : validateCase(folder)) check.problems.push_back(std::move(problem));
    return check;
  });
}

}  // namespace ew
