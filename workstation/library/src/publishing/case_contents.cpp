#include "ew/library/case_contents.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "case/manifest.h"
#include "ew/core/ending.h"
#include "ew/io/json_files.h"
#include "ew/io/volume_file.h"
#include "ew/library/case_card.h"
#include "ew/library/case_echoes.h"
#include "ew/library/checksums.h"
#include "ew/library/lesson_links.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// What uses which path.
class FileUses {
 public:
  explicit FileUses(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& path, const Message& by) {
    if (path.empty()) return;
    auto& uses = byPath_[fs::path(path).lexically_normal().generic_string()];  // "./volumes/v.mha" is a name, too
    if (std::find(uses.begin(), uses.end(), by) == uses.end()) uses.push_back(by);
  }
  /// A volume, and the file of its samples where that is another one.
  void addVolume(const std::string& path, const Message& by) {
    add(path, by);
    if (path.empty()) return;
    const auto header = readVolumeHeader(folder_ / path);
    if (!header) return;  // whoever opens it says what is wrong with it
    for (const fs::path& part : header->files) add(inFolder(part), by);
  }
  /// Where a link of the folder leads to is used by whatever uses the link.
  void followLinks() {
    std::error_code failed;
    const auto named = byPath_;
    for (const auto& [path, uses] : named)
      if (fs::is_symlink(folder_ / path, failed))
        for (const Message& by : uses) add(inFolder(folder_ / path), by);
  }
  [[nodiscard]] std::vector<Message> of(const std::string& path) const {
    const auto at = byPath_.find(path);
    return at == byPath_.end() ? std::vector<Message>{} : at->second;
  }

 private:
  /// The path in the folder of what lies there, links followed; empty: it lies elsewhere.
  [[nodiscard]] std::string inFolder(const fs::path& file) const {
    std::error_code failed;
    const fs::path root = fs::canonical(folder_, failed), target = failed ? fs::path() : fs::canonical(file, failed);
    if (failed) return {};
    std::string relative = target.lexically_relative(root).generic_string();
    return relative.starts_with("..") ? std::string() : relative;
  }

  fs::path folder_;
  std::map<std::string, std::vector<Message>> byPath_;
};

const std::string& lessonsFolder() {
  static const std::string folder = "parts/" + std::string(kLessonsPart) + "/";
  return folder;
}

void addLesson(const Lesson& lesson, FileUses& uses) {
  const Message by = say<"the lesson '%1'">(lesson.title);
  for (const LessonStep& step : lesson.steps) {
    if (const auto* read = std::get_if<ReadingTask>(&step.task); read != nullptr && !read->image.empty())
      uses.add(lessonsFolder() + read->image, by);
    const auto* watch = std::get_if<WatchTask>(&step.task);
    if (watch == nullptr || watch->recording.empty()) continue;
    uses.add(lessonsFolder() + watch->recording, by);
    constexpr std::string_view kEnding = ".seq.mha";
    if (watch->recording.ends_with(kEnding))  // the path it was recorded from
      uses.add(lessonsFolder() + watch->recording.substr(0, watch->recording.size() - kEnding.size()) + ".path.json", by);
  }
}

/// Every text of a manifest: one that is a file's path may be its name, in a field that this program does not know.
void addTexts(const nlohmann::json& value, FileUses& uses) {
  if (value.is_string()) uses.add(value.get<std::string>(), say<"case.json, which names it">());
  if (value.is_structured())
    for (const auto& each : value) addTexts(each, uses);
}

/// Whether a file belongs there without being named: words, and documents that say by their name what they are. Any other text may be the
/// report of another patient.
bool isDocument(const std::string& path) {
  static const std::set<std::string> names{"attribution", "authors", "changelog", "changes", "citation", "copying",
                                           "credits",     "licence", "license",   "notice",  "readme",   "source"};
  if (path.starts_with("words/") || path == kSumsName) return true;
  const fs::path name = fs::path(path).filename();
  std::string stem = name.stem().string();
  std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool isText = !name.has_extension() || hasEnding(path, ".md") || hasEnding(path, ".txt");
  return isText && names.contains(stem.substr(0, stem.find_first_of("-_.")));
}

/// The links of a case's folder by the files they lead to, all paths in the folder: one step, and where the last one ends.
class LinksOfFolder {
 public:
  LinksOfFolder(const fs::path& folder, const std::vector<FileSum>& files) {
    std::error_code failed;
    const fs::path root = fs::canonical(folder, failed);
    if (failed) return;
    for (const FileSum& each : files) {
      const fs::path link = root / each.path;
      if (!fs::is_symlink(link, failed)) continue;
      const fs::path step = link.parent_path() / fs::read_symlink(link, failed);  // an absolute one stands alone
      add(fs::canonical(step.parent_path(), failed) / step.filename(), root, each.path);
      add(fs::canonical(link, failed), root, each.path);
    }
  }
  /// @return sorted
  [[nodiscard]] std::vector<std::string> to(const std::string& path) const {
    const auto at = byTarget_.find(path);
    return at == byTarget_.end() ? std::vector<std::string>() : std::vector<std::string>(at->second.begin(), at->second.end());
  }

 private:
  void add(const fs::path& target, const fs::path& root, const std::string& link) {
    byTarget_[target.lexically_relative(root).generic_string()].insert(link);
  }
  std::map<std::string, std::set<std::string>> byTarget_;
};

/// What the case names, and what of it cannot be told by names.
class UsesOfCase {
 public:
  explicit UsesOfCase(const Case& opened) : uses_(opened.folder), hasRecipe_(!opened.volume.recipe.empty()) {
    const CaseVolume& volume = opened.volume;
    uses_.add(kManifestName, say<"the case itself">());
    uses_.add(kCardName, say<"its card">());
    uses_.addVolume(volume.file, say<"its volume">());
    uses_.addVolume(volume.labels, say<"the labels of its volume">());
    uses_.addVolume(volume.frames, say<"its recorded images">());
    uses_.addVolume(volume.level, say<"its live echoes">());
    for (const std::string& each : echoFilesOf(opened)) uses_.addVolume(each, say<"its live echoes">());
    uses_.add(volume.recipe, say<"its virtual patient">());
    for (const std::string& each : volume.sweeps) uses_.add(each, say<"its virtual patient">());
    uses_.add(opened.mannequin, say<"its mannequin">());
    for (const CaseExamination& each : opened.previousExaminations)
      for (const std::string& image : each.images) uses_.add(image, say<"an earlier examination">());
    if (opened.sealed) uses_.add(opened.sealed->file, say<"its sealed answers">());
    const auto lessons = lessonsOf(opened);
    hasUnknownLessons_ = !lessons;
    if (lessons)
      for (const Lesson& each : *lessons) addLesson(each, uses_);
    // Last: whoever names it in a field that is known says more.
    FileUses texts(opened.folder);
    addTexts(manifestOf(opened), texts);
    texts_ = std::move(texts);
    uses_.followLinks();
    texts_.followLinks();
  }

  [[nodiscard]] std::vector<Message> of(const std::string& path) const {
    if (auto known = uses_.of(path); !known.empty()) return known;
    const std::string& lessons = lessonsFolder();
    if (path.starts_with(lessons) && hasUnknownLessons_) return {say<"lessons that cannot be read">()};
    if (path.starts_with("parts/") && !path.starts_with(lessons))
      return {say<"the part '%1'">(path.substr(6, path.find('/', 6) == std::string::npos ? path.npos : path.find('/', 6) - 6))};
    if (hasRecipe_ && hasEnding(path, ".json")) return {say<"its virtual patient">()};  // what a recipe or its mannequin extends
    if (isDocument(path)) return {say<"readers, as words or a document">()};
    return texts_.of(path);
  }

 private:
  FileUses uses_;
  FileUses texts_{fs::path()};
  bool hasRecipe_ = false;
  bool hasUnknownLessons_ = false;
};

/// The case as its folder holds it, whether or not all its files are there.
Result<Case> savedCase(const fs::path& folder) {
  const auto manifest = readJsonFile(folder / kManifestName, verbatim(kManifestName));
  if (!manifest) return passOn(manifest.error());
  auto saved = caseFromManifest(*manifest, {});
  if (saved) saved->folder = folder;
  return saved;
}

}  // namespace

Result<std::vector<CaseFileUse>> fileUsesOf(const Case& opened) {
  const auto files = filesOfCase(opened.folder);
  if (!files) return passOn(files.error());
  const auto saved = savedCase(opened.folder);
  if (!saved) return passOn(saved.error());
  const UsesOfCase now(opened), before(*saved);
  const LinksOfFolder links(opened.folder, *files);
  std::vector<CaseFileUse> all;
  for (const FileSum& each : *files) {
    CaseFileUse use{each.path, each.size_bytes, now.of(each.path), {}};
    if (use.usedBy.empty() && !before.of(each.path).empty()) use.usedBy = {say<"the case as it was saved last">()};
    if (use.usedBy.empty()) use.linkedBy = links.to(each.path);
    for (const std::string& link : use.linkedBy) use.usedBy.push_back(say<"the link '%1'">(link));
    all.push_back(std::move(use));
  }
  return all;
}

std::vector<std::string> unusedFiles(const Case& opened) {
  std::vector<std::string> unused;
  const auto files = filesOfCase(opened.folder);
  if (!files) return unused;  // publishing says what is wrong with them
  const UsesOfCase uses(opened);
  const LinksOfFolder links(opened.folder, *files);
  for (const FileSum& each : *files)
    if (uses.of(each.path).empty() && links.to(each.path).empty()) unused.push_back(each.path);
  return unused;
}

}  // namespace ew
