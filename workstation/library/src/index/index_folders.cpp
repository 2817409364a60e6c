#include "index/index_folders.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "case/manifest.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Longer than any clock of a file system ticks, but for those that count whole seconds and do not name a fraction.
constexpr std::chrono::milliseconds kFileTick{50};

using FileStatus = std::optional<struct ::stat>;

FileStatus lookAt(const std::string& file) {
  struct ::stat seen {};
  if (::stat(file.c_str(), &seen) != 0 || !S_ISREG(seen.st_mode)) return {};
  return seen;
}

std::string stampText(const struct ::stat& seen) {
  return std::to_string(seen.st_mtim.tv_sec) + '.' + std::to_string(seen.st_mtim.tv_nsec) + ' ' + std::to_string(seen.st_size) + ' ' +
         std::to_string(seen.st_ino);
}

/// words/de_AT.json and words/de.json.
std::vector<std::string> wordsFiles(const std::string& folder, const std::string& language) {
  std::vector<std::string> files;
  if (language.empty() || language.find('/') != std::string::npos) return files;
  files.push_back(folder + "/words/" + language + ".json");
  if (const auto end = language.find_first_of("_-"); end != std::string::npos)
    files.push_back(folder + "/words/" + language.substr(0, end) + ".json");
  return files;
}

std::optional<std::string> caseStamp(const std::string& folder, const std::string& language) {
  const FileStatus manifest = lookAt(folder + '/' + kManifestName);
  if (!manifest) return {};
  std::string stamp = stampText(*manifest);
  for (const std::string& file : wordsFiles(folder, language))
    if (const FileStatus words = lookAt(file)) stamp += " / " + stampText(*words);
  return stamp;
}

std::optional<int> revisionNamed(const std::string& name) {
  int revision = 0;
  const auto [end, failed] = std::from_chars(name.data(), name.data() + name.size(), revision);
  if (failed != std::errc() || end != name.data() + name.size() || revision < 0) return {};
  return revision;
}

/// Calls `take` with each sub-folder or link that is not hidden, in no order. @return why the folder cannot be listed
template <class Take>
std::error_code forEachFolder(const fs::path& folder, Take take) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string& path = entry->path().native();
    if (path[path.rfind('/') + 1] == '.') continue;
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) take(path);
  }
  return failed;
}

std::optional<CaseFolder> highestRevision(const std::string& folder, const std::string& language) {
  std::optional<CaseFolder> highest;
  forEachFolder(folder, [&](const std::string& path) {
    const auto revision = revisionNamed(path.substr(path.rfind('/') + 1));
    if (!revision || (highest && highest->revision >= *revision)) return;
    if (auto stamp = caseStamp(path, language)) highest = CaseFolder{path, LibraryKind::published, *revision, std::move(*stamp)};
  });
  return highest;
}

}  // namespace

CaseFolders findCases(const std::vector<LibraryRoot>& roots, const std::string& language) {
  CaseFolders found;
  for (const LibraryRoot& root : roots) {
    const auto failed = forEachFolder(root.folder, [&](const std::string& path) {
      if (root.kind == LibraryKind::published) {
        if (auto highest = highestRevision(path, language)) found.cases.push_back(std::move(*highest));
      } else if (auto stamp = caseStamp(path, language)) {
        found.cases.push_back({path, root.kind, 0, std::move(*stamp)});
      }
    });
    if (failed && failed != std::errc::no_such_file_or_directory)
      found.problems.push_back(
          {root.folder, say<"The folder of cases '%1' cannot be listed (%2); check its permissions.">(root.folder, failed.message())});
  }
  // A root that is given twice, or as own and as shipped, has each case once.
  std::stable_sort(found.cases.begin(), found.cases.end(),
                   [](const CaseFolder& a, const CaseFolder& b) { return a.folder.native() < b.folder.native(); });
  const auto same = [](const CaseFolder& a, const CaseFolder& b) { return a.folder.native() == b.folder.native(); };
  found.cases.erase(std::unique(found.cases.begin(), found.cases.end(), same), found.cases.end());
  return found;
}

bool isSettled(const fs::path& caseFolder, const std::string& language, std::chrono::system_clock::time_point now) {
  std::vector<std::string> files = wordsFiles(caseFolder.string(), language);
  files.push_back((caseFolder / kManifestName).string());
  return std::all_of(files.begin(), files.end(), [&](const std::string& file) {
    const FileStatus seen = lookAt(file);
    if (!seen) return true;
    const auto since = std::chrono::seconds(seen->st_mtim.tv_sec) + std::chrono::nanoseconds(seen->st_mtim.tv_nsec);
    const auto age = now.time_since_epoch() - since;
    return age > kFileTick || age < -std::chrono::seconds(1);  // a file from the future keeps its stamp, or it would be read at every start
  });
}

}  // namespace ew
