#include "ew/library/case.h"

#include <algorithm>

#include "case/manifest.h"
#include "ew/core/contract.h"
#include "ew/core/json_fields.h"
#include "ew/core/output_set.h"
#include "ew/core/responsive_thread.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/checksums.h"
#include "ew/library/folder_lease.h"
#include "ew/library/lesson.h"
#include "ew/library/schema.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestManifest_bytes = 4u << 20;

fs::path folderOf(const fs::path& folderOrManifest) {
  std::error_code ignored;
  if (fs::is_directory(folderOrManifest, ignored)) return folderOrManifest;
  return folderOrManifest.has_parent_path() ? folderOrManifest.parent_path() : fs::path(".");
}

fs::path manifestFileOf(const fs::path& folderOrManifest) {
  std::error_code ignored;
  return fs::is_directory(folderOrManifest, ignored) ? folderOrManifest / kManifestName : folderOrManifest;
}

Result<std::string> readManifestText(const fs::path& folderOrManifest) {
  const fs::path file = manifestFileOf(folderOrManifest);
  std::error_code ignored;
  if (file != folderOrManifest && !fs::exists(file, ignored))
    return failure(ErrorCode::notFound,
                   say<"The folder '%1' holds no case.json, so it is not a case; choose a case folder.">(folderOrManifest),
                   {{"file", file.string()}});
  return readTextFile(file, kLargestManifest_bytes);
}

Result<nlohmann::json> parseManifest(const std::string& text, const fs::path& folderOrManifest) {
  const fs::path file = manifestFileOf(folderOrManifest);
  auto manifest = parseJson(text, verbatim(file.filename().string()));
  if (!manifest) {
    Error problem = manifest.error();
    problem.context.emplace_back("path", file.string());
    return passOn(std::move(problem));
  }
  return manifest;
}

Result<nlohmann::json> readManifest(const fs::path& folderOrManifest) {
  auto text = readManifestText(folderOrManifest);
  if (!text) return passOn(text.error());
  return parseManifest(*text, folderOrManifest);
}

bool inside(const fs::path& file, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && rest != file.end();
}

bool sameFolder(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

Result<std::string> manifestText(const Case& edited) {
  try {
    return orderedManifestOf(edited).dump(2) + "\n";
  } catch (const nlohmann::json::exception&) {
    return failure(ErrorCode::badField, say<"A text of the case is not valid UTF-8 and cannot be saved; type it again.">());
  }
}

Result<void> writeManifest(const Case& edited, const fs::path& folder) {
  auto text = manifestText(edited);
  if (!text) return passOn(text.error());
  if (auto problems = checkManifest(manifestOf(edited), folder); !problems.empty()) return passOn(std::move(problems.front()));
  return writeFileSafely(folder / kManifestName, *text);
}

/// What belongs to the folder that was copied, not to the case: who edits it, the sums of a revision, and files that were taken out.
void leaveBehind(const fs::path& copied) {
  std::error_code ignored;
  std::vector<fs::path> left{copied / kSumsName};
  for (fs::directory_iterator at(copied, ignored), end; !ignored && at != end; at.increment(ignored))
    if (isLeaseFile(at->path())) left.push_back(at->path());
  for (const fs::path& each : left) fs::remove(each, ignored);
  fs::remove_all(copied / kWithdrawnFiles, ignored);  // of the copy: what was taken out of the case does not come with it
}

/// A copy of the whole case under another name, made aside and renamed, so that a half-copied case never carries the final name.
Result<void> saveElsewhere(const Case& edited, const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
    return failure(ErrorCode::notWritable,
                   say<"'%1' is not empty, and nothing in it is overwritten; choose a new or an empty folder.">(folder),
                   {{"file", folder.string()}});
  fs::path target = fs::absolute(folder, error);
  if (!target.has_filename()) target = target.parent_path();
  if (inside(fs::weakly_canonical(target, error), fs::weakly_canonical(edited.folder, error)))
    return failure(ErrorCode::notWritable, say<"A case cannot be saved inside its own folder; choose a folder beside it.">(),
                   {{"file", folder.string()}});
  const auto giveUp = [&](const Message& reason) {
    return failure(ErrorCode::notWritable,
                   say<"The case cannot be saved to '%1' (%2); choose a folder you may write to, with enough space.">(folder, reason),
                   {{"file", folder.string()}});
  };
  const auto reasonOf = [](const Error& refused) {
    for (const auto& [name, value] : refused.context)
      if (name == "reason") return verbatim(value);
    return refused.message;
  };
  const fs::path source = fs::canonical(edited.folder, error);  // copying a link would copy nothing and say that all is well
  if (error) return giveUp(verbatim(error.message()));
  OutputSet outputs;
  if (auto made = outputs.announceFolder(target.parent_path()); !made) return giveUp(reasonOf(made.error()));
  if (auto announced = outputs.announceNewFolder(target); !announced) return giveUp(reasonOf(announced.error()));
  const fs::path aside = outputs.staged(target);
  fs::copy(source, aside, fs::copy_options::recursive | fs::copy_options::skip_symlinks, error);
  if (error) return giveUp(verbatim(error.message()));
  leaveBehind(aside);
  if (auto written = writeManifest(edited, aside); !written) return passOn(outputs.inGivenNames(std::move(written.error())));
  if (auto committed = outputs.commit(); !committed) return giveUp(reasonOf(committed.error()));
  return {};
}

}  // namespace

Result<fs::path> fileOfCase(const fs::path& folder, const std::string& relative, const std::string& field) {
  const fs::path path(relative);
  const auto refuse = [&](ErrorCode code, Message message) {
    return failure(code, std::move(message), {{"field", field}, {"found", relative}, {"expected", "a file inside the case folder"}});
  };
  if (relative.empty() || path.is_absolute() || relative.find('\0') != std::string::npos || relative.find('\\') != std::string::npos ||
      std::find(path.begin(), path.end(), "..") != path.end())
    return refuse(ErrorCode::badField,
                  say<"'%1' in case.json is \"%2\", which is not a relative path inside the case folder; copy the file into "
                      "the case folder and name it there.">(field, relative));
  if (folder.empty()) return path;
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error)
    return refuse(ErrorCode::notFound,
                  say<"'%1' in case.json is \"%2\", but the case folder cannot be opened; check that it is still there.">(field, relative));
  const fs::path file = fs::weakly_canonical(root / path, error);
  if (error || !inside(file, root))
    return refuse(ErrorCode::badField,
                  say<"'%1' in case.json is \"%2\", which leads out of the case folder through a link; copy the file itself "
                      "into the case folder.">(field, relative));
  if (!fs::is_regular_file(file, error))
    return refuse(ErrorCode::notFound,
                  say<"'%1' in case.json is \"%2\", but there is no such file in the case folder; put it there or correct "
                      "the name.">(field, relative));
  return file;
}

Result<fs::path> volumeOfCase(const fs::path& folder, const std::string& relative, const std::string& field) {
  auto file = fileOfCase(folder, relative, field);
  if (!file || folder.empty()) return file;
  const auto header = readVolumeHeader(*file);
  if (!header) return file;  // whoever opens it says what is wrong with it
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  for (const fs::path& part : header->files) {
    const fs::path samples = fs::canonical(part, error);
    if (error || inside(samples, root)) continue;
    return failure(
        ErrorCode::badField,
        say<"'%1' in case.json is \"%2\", which keeps its samples in '%3', outside of the case folder; copy both files into the case "
            "folder and correct the name in the header.">(field, relative, part),
        {{"field", field}, {"found", part.string()}, {"expected", "samples inside the case folder"}});
  }
  return file;
}

Result<Case> loadCase(const fs::path& folderOrManifest) {
  auto read = readCase(folderOrManifest);
  if (!read) return passOn(read.error());
  return std::move(read->opened);
}

Result<CaseAsRead> readCase(const fs::path& folderOrManifest) {
  EW_EXPECTS(!isResponsiveThread());
  return guardedCase(folderOrManifest, [&]() -> Result<CaseAsRead> {
    auto text = readManifestText(folderOrManifest);
    if (!text) return passOn(text.error());
    auto manifest = parseManifest(*text, folderOrManifest);
    if (!manifest) return passOn(manifest.error());
    auto opened = caseFromManifest(*manifest, folderOf(folderOrManifest));
    if (!opened) return passOn(opened.error());
    return CaseAsRead{std::move(*opened), fingerprintOf(*text)};
  });
}

Result<Fingerprint> manifestFingerprint(const fs::path& folderOrManifest) {
  auto text = readManifestText(folderOrManifest);
  if (!text) return passOn(text.error());
  return fingerprintOf(*text);
}

std::vector<Error> validateCase(const fs::path& folderOrManifest) {
  EW_EXPECTS(!isResponsiveThread());
  auto checked = guardedCase(folderOrManifest, [&]() -> Result<std::vector<Error>> {
    auto manifest = readManifest(folderOrManifest);
    if (!manifest) return passOn(manifest.error());
    auto problems = checkManifest(*manifest, folderOf(folderOrManifest));
    if (!problems.empty()) return problems;
    const auto opened = caseFromManifest(*manifest, folderOf(folderOrManifest));
    if (!opened) return passOn(opened.error());
    return problemsInUse(*opened);
  });
  if (!checked) return {checked.error()};
  return *std::move(checked);
}

Result<void> saveCase(const Case& edited, const fs::path& folder) {
  if (!edited.folder.empty() && !sameFolder(edited.folder, folder)) return saveElsewhere(edited, folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return failure(ErrorCode::notWritable,
                   say<"The case folder '%1' cannot be made (%2); choose a folder you may write to.">(folder, verbatim(error.message())),
                   {{"file", folder.string()}});
  return writeManifest(edited, folder);
}

std::string idForFolder(const fs::path& folder) {
  std::error_code ignored;
  fs::path place = fs::absolute(folder, ignored).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  std::vector<std::string> taken;
  for (const Case& beside : listCases(place.parent_path()).cases)
    if (beside.folder.filename() != place.filename()) taken.push_back(beside.id);
  return idFor(place.filename().string(), taken, "case");
}

CaseList listCases(const fs::path& folder) {
  EW_EXPECTS(!isResponsiveThread());
  CaseList found;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) {
    found.problems.push_back({ErrorCode::notReadable,
                              say<"The case library '%1' cannot be opened (%2); choose another folder.">(folder, verbatim(error.message())),
                              {{"file", folder.string()}}});
    return found;
  }
  for (; entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path& entry = entries->path();
    std::error_code ignored;
    // A hidden folder is a save in progress or a tool's own; a folder without a manifest is not a case.
    if (entry.filename().string().starts_with('.')) continue;
    if (!fs::exists(entry / kManifestName, ignored)) {
      if (fs::is_directory(entry, ignored)) found.noCases.push_back(entry);
      continue;
    }
    auto opened = loadCase(entry);
    if (opened)
      found.cases.push_back(std::move(*opened));
    else {
      Error problem = opened.error();
      problem.message = say<"The case in the folder '%1' is left out: %2">(entry.filename(), std::move(problem.message));
      problem.context.emplace_back("case", entry.string());
      found.problems.push_back(std::move(problem));
    }
  }
  std::sort(found.cases.begin(), found.cases.end(),
            [](const Case& a, const Case& b) { return std::tie(a.title, a.id) < std::tie(b.title, b.id); });
  std::sort(found.problems.begin(), found.problems.end(), [](const Error& a, const Error& b) { return a.sentence() < b.sentence(); });
  std::sort(found.noCases.begin(), found.noCases.end());
  return found;
}

}  // namespace ew
