#include "case/outgoing_case.h"

#include <map>
#include <utility>

#include "case/manifest.h"
#include "ew/library/published.h"

namespace ew {
namespace {

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

/// A revision is handed on as it was published, or not at all. @error badField
Result<void> expectAsPublished(const std::filesystem::path& folder, const std::vector<FileSum>& found) {
  if (!isPublished(folder)) return {};
  const auto kept = readSums(folder);
  if (!kept) return passOn(kept.error());
  const std::vector<Error> problems = differencesOf(*kept, found);
  if (problems.empty()) return {};
  std::vector<std::pair<std::string, std::string>> context = problems.front().context;
  context.emplace_back("problems", std::to_string(problems.size()));
  if (problems.size() == 1)
    return failure(ErrorCode::badField,
                   say<"The published revision '%1' is damaged and is not handed on: %2">(folder, problems.front().message),
                   std::move(context));
  return failure(ErrorCode::badField,
                 say<"The published revision '%1' is damaged in %2 files and is not handed on. The first: %3">(folder, problems.size(),
                                                                                                               problems.front().message),
                 std::move(context));
}

}  // namespace

std::vector<Error> differencesOf(const std::vector<FileSum>& kept, const std::vector<FileSum>& found) {
  std::vector<Error> problems;
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
  return problems;
}

Result<CaseToHandOn> caseToHandOn(const std::filesystem::path& folder, Progress& progress) {
  auto opened = loadCase(folder);
  if (!opened) return passOn(opened.error());
  if (auto good = checkNothingHiddenIsNeeded(manifestOf(*opened), opened->folder); !good) return passOn(good.error());
  auto files = sumsOfCase(opened->folder, progress);
  if (!files) return passOn(files.error());
  if (auto whole = expectAsPublished(opened->folder, *files); !whole) return passOn(whole.error());
  return CaseToHandOn{std::move(*opened), std::move(*files)};
}

}  // namespace ew
