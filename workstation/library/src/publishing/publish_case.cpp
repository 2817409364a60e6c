#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/outgoing_case.h"
#include "case/revisions.h"
#include "ew/core/find_entry.h"
#include "ew/library/published.h"
#include "ew/library/publishing.h"
#include "files/file_pieces.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// A file of the latest revision in another one's place; false: it has to be copied. What the link leads to is read: a revision that was
/// damaged may not damage the next.
Result<bool> linked(const fs::path& earlier, const fs::path& to, const FileSum& file, ByteCount& count) {
  const auto sum = sumInPieces(earlier, count);
  if (!sum && sum.error().code == ErrorCode::cancelled) return passOn(sum.error());
  if (!sum || sum->sha256 != file.sha256) return false;
  std::error_code problem;
  fs::create_directories(to.parent_path(), problem);
  fs::create_hard_link(earlier, to, problem);
  return !problem;
}

Result<void> copyFiles(const CaseToHandOn& from, const std::optional<CaseRevision>& earlier, const fs::path& to, ByteCount& count) {
  std::vector<FileSum> before;
  if (earlier) before = sumsOfComplete(earlier->folder).value_or(std::vector<FileSum>());
  for (const FileSum& each : from.files) {
    const auto same = std::find_if(before.begin(), before.end(), [&](const FileSum& file) { return file.sha256 == each.sha256; });
    if (same != before.end()) {
      const auto done = linked(earlier->folder / same->path, to / each.path, each, count);
      if (!done) return passOn(done.error());
      if (*done) continue;
    }
    const auto copied = copyInPieces(from.opened.folder / each.path, to / each.path, count);
    if (!copied) return passOn(copied.error());
    if (copied->sha256 != each.sha256)
      return failure(ErrorCode::notReadable,
                     say<"\"%1\" was changed while the case was read; do it again when nobody is writing to the case folder.">(each.path),
                     {{"file", each.path}});
  }
  return {};
}

/// The cases that lessons may refer to: beside this one, the program's own, and those that are published.
std::vector<Case> casesAround(const fs::path& caseFolder, const fs::path& library) {
  std::vector<Case> all = listCases(fs::weakly_canonical(caseFolder).parent_path()).cases;
  if (const auto shipped = shippedCasesFolder())
    for (Case& each : listCases(*shipped).cases) all.push_back(std::move(each));
  for (const CaseRevision& each : listPublished(library))
    if (auto opened = loadCase(each.folder)) all.push_back(*std::move(opened));
  return all;
}

std::optional<CaseRevision> sameAsLatest(const CaseToHandOn& from, const fs::path& library, const std::optional<CaseRevision>& latest) {
  if (!latest) return std::nullopt;
  auto same = revisionWith(library, from.opened.id, from.files);
  return same && same->revision == latest->revision ? same : std::nullopt;
}

/// @error badField: the first thing that is missing, and how many there are
Result<void> checkReady(const Case& opened, const fs::path& library) {
  std::optional<std::vector<Case>> around;
  const auto missing = missingForPublishing(opened, [&](const std::string& id) -> const Case* {
    if (!around) around = casesAround(opened.folder, library);
    return entryWith(*around, &Case::id, id);
  });
  if (missing.empty()) return {};
  std::vector<std::pair<std::string, std::string>> context = {{"field", missing.front().field},
                                                              {"missing", std::to_string(missing.size())}};
  if (missing.size() == 1)
    return failure(ErrorCode::badField, say<"The case is not ready to be published: %1">(missing.front().what), std::move(context));
  return failure(ErrorCode::badField,
                 say<"The case is not ready to be published, %1 things are missing. The first: %2">(missing.size(), missing.front().what),
                 std::move(context));
}

}  // namespace

Result<CaseRevision> publishCase(const fs::path& caseFolder, const fs::path& library, Progress& progress) {
  return guardedCase(caseFolder, [&]() -> Result<CaseRevision> {
    PartOfProgress summing(progress, 0.0, 0.3), copying(progress, 0.3, 1.0);
    const auto from = caseToHandOn(caseFolder, summing);
    if (!from) return passOn(from.error());
    if (auto ready = checkReady(from->opened, library); !ready) return passOn(ready.error());
    const std::string& id = from->opened.id;
    const auto latest = latestPublished(library, id);
    if (auto same = sameAsLatest(*from, library, latest)) return *same;
    if (auto room = checkRoom(library, bytesOf(from->files)); !room) return passOn(room.error());
    const auto there = [&] { return sameAsLatest(*from, library, latestPublished(library, id)); };
    return makeRevision(library, id, 0, from->files, there, [&](const fs::path& aside) {
      ByteCount count(say<"Publishing the case">(), bytesOf(from->files), copying);
      return copyFiles(*from, latest, aside, count);
    });
  });
}

Result<std::optional<CaseRevision>> publishedAsItIs(const fs::path& caseFolder, const fs::path& library, Progress& progress) {
  return guardedCase(caseFolder, [&]() -> Result<std::optional<CaseRevision>> {
    const auto from = caseToHandOn(caseFolder, progress);
    if (!from) return passOn(from.error());
    return sameAsLatest(*from, library, latestPublished(library, from->opened.id));
  });
}

}  // namespace ew
