#include "ew/library/published.h"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "case/manifest.h"
#include "case/outgoing_case.h"
#include "case/revisions.h"
#include "ew/core/output_set.h"
#include "ew/io/file_lock.h"
#include "files/file_pieces.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPublished = "published";
constexpr const char* kNumbers = ".numbers";  // hidden, so that no list takes it for a case

/// Numbers of revisions that were taken away: an empty file each, because a folder without files does not survive every copying.
fs::path numbersFolder(const fs::path& library, const std::string& id) { return publishedFolder(library) / kNumbers / id; }

std::optional<int> numberOfRevision(const std::string& name) {
  int revision = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), revision);
  if (read.ec != std::errc{} || read.ptr != name.data() + name.size() || revision < 1 || name.front() == '0') return std::nullopt;
  return revision;
}

/// Every number that a folder has, complete or not.
std::vector<int> takenRevisions(const fs::path& folder) {
  std::vector<int> taken;
  std::error_code problem;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    if (const auto revision = numberOfRevision(at->path().filename().string())) taken.push_back(*revision);
  std::sort(taken.begin(), taken.end());
  return taken;
}

/// Every number that was given to a revision of the case, also of one that was taken away.
std::vector<int> takenNumbers(const fs::path& library, const std::string& id) {
  std::vector<int> taken = takenRevisions(publishedFolder(library) / id);
  for (const int kept : takenRevisions(numbersFolder(library, id))) taken.push_back(kept);
  std::sort(taken.begin(), taken.end());
  return taken;
}

/// @error notWritable
Result<void> keepNumbers(const fs::path& library, const std::string& id) {
  const fs::path folder = numbersFolder(library, id);
  std::error_code ignored;
  for (const int revision : takenRevisions(publishedFolder(library) / id)) {
    fs::create_directories(folder, ignored);
    if (!std::ofstream(folder / std::to_string(revision), std::ios::app))
      return failure(ErrorCode::notWritable,
                     say<"The numbers of the revisions of '%1' cannot be kept in '%2', so nothing was changed; check that you may write "
                         "there.">(id, folder),
                     {{"file", folder.string()}});
  }
  return {};
}

bool hasManifest(const std::vector<FileSum>& files) {
  return std::any_of(files.begin(), files.end(), [](const FileSum& each) { return each.path == kManifestName; });
}

}  // namespace

fs::path publishedFolder(const fs::path& library) { return library / kPublished; }

std::optional<std::vector<FileSum>> sumsOfComplete(const fs::path& revision) {
  auto sums = readSums(revision);
  if (!sums) return std::nullopt;
  std::error_code problem;
  for (const FileSum& each : *sums)
    if (fs::file_size(revision / each.path, problem) != each.size_bytes || problem) return std::nullopt;
  return std::move(*sums);
}

bool isCaseId(std::string_view text) {
  constexpr std::size_t kLongest_bytes = 100;
  const auto isPlain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return !text.empty() && text.size() <= kLongest_bytes && isPlain(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return isPlain(c) || c == '.' || c == '_' || c == '-'; });
}

std::vector<CaseRevision> publishedRevisions(const fs::path& library, const std::string& id) {
  std::vector<CaseRevision> found;
  if (!isCaseId(id)) return found;
  const fs::path folder = publishedFolder(library) / id;
  for (const int revision : takenRevisions(folder))
    if (sumsOfComplete(folder / std::to_string(revision)))
      found.push_back({.id = id, .revision = revision, .folder = folder / std::to_string(revision)});
  return found;
}

std::optional<CaseRevision> latestPublished(const fs::path& library, const std::string& id) {
  if (!isCaseId(id)) return std::nullopt;
  const fs::path folder = publishedFolder(library) / id;
  const auto taken = takenRevisions(folder);
  for (auto revision = taken.rbegin(); revision != taken.rend(); ++revision)
    if (sumsOfComplete(folder / std::to_string(*revision)))
      return CaseRevision{.id = id, .revision = *revision, .folder = folder / std::to_string(*revision)};
  return std::nullopt;
}

std::vector<CaseRevision> takenPublished(const fs::path& library, const std::string& id) {
  std::vector<CaseRevision> found;
  if (!isCaseId(id)) return found;
  const fs::path folder = publishedFolder(library) / id;
  std::error_code ignored;
  for (const int revision : takenRevisions(folder)) {
    const fs::path place = folder / std::to_string(revision);
    if (fs::is_empty(place, ignored)) continue;  // earlier programs kept the number of what was withdrawn in this way
    found.push_back({.id = id, .revision = revision, .folder = place});
  }
  return found;
}

std::vector<CaseRevision> listPublished(const fs::path& library) {
  std::vector<CaseRevision> found;
  std::error_code problem;
  for (fs::directory_iterator at(publishedFolder(library), problem), end; !problem && at != end; at.increment(problem)) {
    const std::string id = at->path().filename().string();
    if (!isCaseId(id)) continue;
    removeLeftovers(at->path());
    if (auto latest = latestPublished(library, id)) found.push_back(std::move(*latest));
  }
  std::sort(found.begin(), found.end(), [](const CaseRevision& a, const CaseRevision& b) { return a.id < b.id; });
  return found;
}

std::optional<CaseRevision> revisionWith(const fs::path& library, const std::string& id, const std::vector<FileSum>& files) {
  auto revisions = publishedRevisions(library, id);
  const auto same = std::find_if(revisions.rbegin(), revisions.rend(), [&](const CaseRevision& each) {
    const auto sums = sumsOfComplete(each.folder);
    return sums && *sums == files;
  });
  if (same == revisions.rend()) return std::nullopt;
  same->wasThere = true;
  return *same;
}

Result<CaseRevision> makeRevision(const fs::path& library, const std::string& id, int wanted, const std::vector<FileSum>& files,
                                  const std::function<std::optional<CaseRevision>()>& there,
                                  const std::function<Result<void>(const fs::path&)>& fill) {
  if (!hasManifest(files))
    return failure(ErrorCode::notFound, say<"What is to be published holds no case.json, so it is not a case; choose a case folder.">());
  const fs::path folder = publishedFolder(library) / id;
  removeLeftovers(folder);
  constexpr int kAttempts = 5;
  for (int attempt = 1;; ++attempt) {
    const auto taken = takenNumbers(library, id);
    const bool isFree = wanted > 0 && !std::binary_search(taken.begin(), taken.end(), wanted);
    const int revision = isFree ? wanted : taken.empty() ? 1 : taken.back() + 1;
    const fs::path place = folder / std::to_string(revision);
    OutputSet outputs;
    if (auto made = outputs.announceFolder(folder); !made) return passOn(made.error());
    if (auto announced = outputs.announceNewFolder(place); !announced) {
      std::error_code ignored;
      if (attempt == kAttempts || !fs::exists(place, ignored)) return passOn(announced.error());
      continue;  // somebody took the number between the two looks
    }
    const fs::path aside = outputs.staged(place);
    if (auto filled = fill(aside); !filled) return passOn(outputs.inGivenNames(filled.error()));
    if (const auto opened = loadCase(aside); !opened) return passOn(outputs.inGivenNames(opened.error()));
    if (auto written = writeSums(files, aside); !written) return passOn(outputs.inGivenNames(written.error()));
    // Where the folder cannot be locked the second of two who look at once may make a revision of the same content.
    const FileLock lock = FileLock::takeFolder(folder);
    if (auto same = there()) return *same;
    auto committed = outputs.commit();
    if (committed) return CaseRevision{.id = id, .revision = revision, .folder = place};
    std::error_code ignored;
    if (attempt == kAttempts || !fs::exists(place, ignored)) return passOn(committed.error());
  }
}

Result<void> takeRevisionsAway(const fs::path& library, const std::string& id, const std::function<Result<void>()>& move) {
  const FileLock lock = FileLock::takeFolder(publishedFolder(library) / id);
  if (auto kept = keepNumbers(library, id); !kept) return kept;
  return move();
}

bool isPublished(const fs::path& folder) {
  std::error_code failed;
  for (fs::path at = fs::weakly_canonical(folder, failed); !failed && at.has_relative_path(); at = at.parent_path())
    if (at.parent_path().parent_path().filename() == kPublished && numberOfRevision(at.filename().string()) &&
        fs::exists(at / kSumsName, failed))
      return true;
  return false;
}

}  // namespace ew
