#include "logic/stitch_document.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/stitching/places.h"
#include "ew/stitching/value_json.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

/// The recovery file is an object around the project's own text, so the project keeps its one format.
constexpr const char* kRecoveryProject = "project";
constexpr const char* kRecoveryFile = "file";

std::string unique(const std::string& wanted, const std::set<std::string>& taken) {
  const std::string base = wanted.empty() ? "volume" : wanted;
  std::string name = base;
  for (int n = 2; taken.count(name) != 0; ++n) name = base + " (" + std::to_string(n) + ")";
  return name;
}

bool saysNothing(const ProjectPair& pair) {
  ProjectPair empty;
  empty.fixed = pair.fixed;
  empty.moving = pair.moving;
  return pair == empty;
}

/// Every index through `renumbered`; what it sends to nowhere is left out.
void renumber(StitchProject& project, const std::function<std::optional<std::size_t>(std::size_t)>& renumbered) {
  std::vector<ProjectPair> pairs;
  for (ProjectPair pair : project.pairs) {
    const auto fixed = renumbered(pair.fixed);
    const auto moving = renumbered(pair.moving);
    if (!fixed || !moving) continue;
    pair.fixed = *fixed;
    pair.moving = *moving;
    if (pair.fixed > pair.moving) pair = swapped(std::move(pair));
    pairs.push_back(std::move(pair));
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return std::pair(a.fixed, a.moving) < std::pair(b.fixed, b.moving); });
  project.pairs = std::move(pairs);
  auto& strokes = project.settings.join.seam.strokes;
  std::vector<SeamStroke> kept;
  for (SeamStroke stroke : strokes) {
    const auto view = renumbered(stroke.view);
    if (!view) continue;
    stroke.view = *view;
    kept.push_back(stroke);
  }
  strokes = std::move(kept);
}

}  // namespace

StitchProject withVolumes(StitchProject project, std::vector<ProjectVolume> added) {
  std::set<std::string> names;
  for (const auto& volume : project.volumes) names.insert(volume.name);
  for (auto& volume : added) {
    volume.name = unique(volume.name.empty() ? volume.file.filename().string() : volume.name, names);
    names.insert(volume.name);
    project.volumes.push_back(std::move(volume));
  }
  return project;
}

StitchProject withoutVolume(StitchProject project, std::size_t volume) {
  if (volume >= project.volumes.size()) return project;
  project.volumes.erase(project.volumes.begin() + static_cast<std::ptrdiff_t>(volume));
  renumber(project, [&](std::size_t n) -> std::optional<std::size_t> {
    if (n == volume) return std::nullopt;
    return n > volume ? n - 1 : n;
  });
  return project;
}

StitchProject withVolumeMoved(StitchProject project, std::size_t from, std::size_t to) {
  if (from >= project.volumes.size() || to >= project.volumes.size() || from == to) return project;
  std::vector<std::size_t> order(project.volumes.size());  // new place -> old place
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), from);
  std::vector<ProjectVolume> volumes;
  std::vector<std::size_t> now(order.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    volumes.push_back(std::move(project.volumes[order[n]]));
    now[order[n]] = n;
  }
  project.volumes = std::move(volumes);
  renumber(project, [&](std::size_t n) -> std::optional<std::size_t> { return n < now.size() ? std::optional(now[n]) : std::nullopt; });
  return project;
}

StitchProject withPlace(StitchProject project, std::size_t volume, const Transform<frame::World, frame::View>& toWorld,
                        Placement placement) {
  if (volume >= project.volumes.size()) return project;
  project.volumes[volume].toWorld = toWorld;
  project.volumes[volume].placement = placement;
  return project;
}

ProjectPair pairOf(const StitchProject& project, std::size_t fixed, std::size_t moving) {
  const auto [low, high] = std::minmax(fixed, moving);
  for (const ProjectPair& pair : project.pairs)
    if (pair.fixed == low && pair.moving == high) return pair;
  ProjectPair pair;
  pair.fixed = low;
  pair.moving = high;
  return pair;
}

ProjectPair swapped(ProjectPair pair) {
  std::swap(pair.fixed, pair.moving);
  for (auto& landmark : pair.landmarks) std::swap(landmark.fixed_mm, landmark.moving_mm);
  if (pair.start) pair.start = withRolesSwapped(*pair.start);
  return pair;
}

StitchProject withPair(StitchProject project, const ProjectPair& pair) {
  if (pair.fixed >= pair.moving || pair.moving >= project.volumes.size()) return project;
  auto& pairs = project.pairs;
  const auto at = std::find_if(pairs.begin(), pairs.end(), [&](const ProjectPair& other) {
    return std::pair(other.fixed, other.moving) >= std::pair(pair.fixed, pair.moving);
  });
  const bool there = at != pairs.end() && at->fixed == pair.fixed && at->moving == pair.moving;
  if (saysNothing(pair)) {
    if (there) pairs.erase(at);
  } else if (there) {
    *at = pair;
  } else {
    pairs.insert(at, pair);
  }
  return project;
}

StitchProject withStroke(StitchProject project, const SeamStroke& stroke) {
  if (stroke.view < project.volumes.size()) project.settings.join.seam.strokes.push_back(stroke);
  return project;
}

std::optional<Error> problemOfName(const StitchProject& project, std::size_t volume, const std::string& name) {
  if (name.find_first_not_of(" \t\r\n") == std::string::npos)
    return Error{ErrorCode::badField, say<"A volume needs a name; type one.">(), {{"field", "name"}}};
  for (std::size_t n = 0; n < project.volumes.size(); ++n)
    if (n != volume && project.volumes[n].name == name)
      return Error{ErrorCode::badField, say<"Another volume is called '%1' already; choose another name.">(name), {{"field", "name"}}};
  return std::nullopt;
}

std::string letterOf(std::size_t volume) {
  std::string letters;
  for (std::size_t n = volume + 1; n > 0; n = (n - 1) / 26) letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
  return letters;
}

StitchDocument::StitchDocument(sdk::Files& files, fs::path recovery) : files_(files), recovery_(std::move(recovery)) {}

void StitchDocument::edit(StitchProject next, std::string what, std::string mergeKey) {
  if (next == project()) return;
  states_.step(std::move(next), std::move(what), std::move(mergeKey));
}

void StitchDocument::begin(StitchProject project, StitchProject saved, fs::path file, std::string textOfFile) {
  states_ = History<StitchProject>(std::move(project));
  saved_ = std::move(saved);
  file_ = std::move(file);
  textOfFile_ = std::move(textOfFile);
}

void StitchDocument::clear() { begin({}, {}, {}, {}); }

Result<void> StitchDocument::open(const fs::path& file) {
  auto text = files_.readText(file);
  if (!text) return passOn(text.error());
  auto project = parseProject(*text, file.parent_path());
  if (!project) return passOn(project.error());
  StitchProject same = *project;
  begin(std::move(*project), std::move(same), file, std::move(*text));
  return {};
}

bool StitchDocument::isChangedOnDisk() const {
  if (file_.empty()) return false;
  const auto text = files_.readText(file_);
  return text && *text != textOfFile_;  // where it is gone, nothing is lost by writing it again
}

Result<void> StitchDocument::save(const fs::path& file) {
  if (project().volumes.empty())
    return failure(ErrorCode::emptyVolume, say<"The project has no volume yet; add one before it is saved.">());
  std::string text = projectText(project(), file.parent_path());
  if (auto written = files_.writeText(file, text); !written) return written;
  file_ = file;
  textOfFile_ = std::move(text);
  saved_ = project();
  forgetRecovery();
  return {};
}

Result<void> StitchDocument::keepRecovery() {
  if (!hasUnsavedChanges() || project().volumes.empty()) {  // a project without volumes holds nothing that could be lost
    if (kept_) forgetRecovery();
    return {};
  }
  if (kept_ && *kept_ == project()) return {};
  // Paths are written in full: the recovery file lies elsewhere than the project.
  auto asJson = parseJson(projectText(project(), {}), say<"the stitch project">());
  if (!asJson) return passOn(asJson.error());
  const nlohmann::json around = {{kRecoveryFile, file_.string()}, {kRecoveryProject, *std::move(asJson)}};
  std::error_code ignored;
  fs::create_directories(recovery_.parent_path(), ignored);
  if (auto written = files_.writeText(recovery_, around.dump(1)); !written) return written;
  kept_ = project();
  return {};
}

Result<std::optional<StitchDocument::Left>> StitchDocument::leftIn(const fs::path& recovery) const {
  std::error_code ignored;
  if (!fs::exists(recovery, ignored)) return std::nullopt;
  auto text = files_.readText(recovery);
  if (!text) return passOn(text.error());
  const auto around = jsonOrNull(*text);
  if (!around.is_object() || !around.contains(kRecoveryProject) || !around.contains(kRecoveryFile) ||
      !around.at(kRecoveryFile).is_string()) {
    return failure(ErrorCode::badHeader,
                   say<"The file that keeps unsaved work ('%1') is damaged; it is left where it is and nothing was reopened.">(recovery));
  }
  auto project = parseProject(around.at(kRecoveryProject).dump(), recovery.parent_path());
  if (!project) return passOn(project.error());
  return Left{around.at(kRecoveryFile).get<std::string>(), std::move(*project)};
}

void StitchDocument::takeOver(const Left& left) {
  StitchProject saved;
  std::string textOfFile;
  // What the file holds now, so that "not saved" is true; a file that is gone counts as never saved.
  if (!left.file.empty()) {
    if (auto text = files_.readText(left.file)) {
      if (auto project = parseProject(*text, left.file.parent_path())) saved = std::move(*project);
      textOfFile = std::move(*text);
    }
  }
  begin(left.project, std::move(saved), left.file, std::move(textOfFile));
  kept_.reset();
}

void StitchDocument::forgetRecovery() {
  std::error_code ignored;
  fs::remove(recovery_, ignored);
  kept_.reset();
}

}  // namespace ew::stitching
