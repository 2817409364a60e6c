#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/schema.h"
#include "ew/phantom/patient.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Part of every cache name: raise it when the cache's own files change.
constexpr int kRecipeCacheFormat = 2;

std::string hex(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

std::string hashOf(const std::vector<std::uint8_t>& values) { return hex(XXH3_64bits(values.data(), values.size())); }

/// The four files that hold one voxelised recipe. `ready` is written last and carries the hashes of what the others hold.
struct CacheEntry {
  fs::path echo;
  fs::path coverage;
  fs::path labels;
  fs::path ready;
};

/// Where a recipe finds the mannequin it names, wherever the case folder itself lies.
fs::path mannequinFolder() {
  const auto resources = resourceFolder();
  return resources ? *resources / "mannequin" : fs::path();
}

Result<CacheEntry> cacheEntryOf(const Case& opened) {
  auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
  if (!recipe) return passOn(recipe.error());
  // The phantom library answers for everything that shapes the voxels but the spacing: recipe, mannequin and its own way of making them.
  auto fingerprint = fingerprintOfPatient(*recipe, mannequinFolder());
  if (!fingerprint) return passOn(fingerprint.error());
  const std::string name = hex(*fingerprint) + "-" + textOf(opened.volume.recipeSpacing_mm) + "mm-" + std::to_string(kRecipeCacheFormat);
  const fs::path folder = cacheFolder() / "recipes";
  return CacheEntry{folder / (name + ".mha"), folder / (name + ".coverage.mha"), folder / (name + ".labels.mha"),
                    folder / (name + ".json")};
}

struct Prepared {
  Volume volume;
  Volume labels;
};

/// What the cache holds, or why it has to be made again.
Result<Prepared> readCached(const CacheEntry& entry, Progress& progress) {
  auto text = readTextFile(entry.ready, 1u << 16);
  if (!text) return passOn(text.error());
  auto ready = parseJson(*text, entry.ready.filename().string());
  if (!ready) return passOn(ready.error());
  auto loaded = readVolume(entry.echo, progress);
  if (!loaded) return passOn(loaded.error());
  Prepared found{std::move(loaded->volume), {}};
  if (auto read = readCoverageInto(found.volume, entry.coverage, progress); !read) return passOn(read.error());
  auto labels = readLabelVolume(entry.labels, progress);
  if (!labels) return passOn(labels.error());
  found.labels = std::move(labels->volume);
  const auto promised = [&](const char* field) {
    return ready->is_object() && ready->contains(field) && (*ready)[field].is_string() ? (*ready)[field].get<std::string>() : std::string();
  };
  if (promised("echo") != hashOf(found.volume.echo) || promised("coverage") != hashOf(found.volume.coverage) ||
      promised("labels") != hashOf(found.labels.echo) || found.labels.grid != found.volume.grid)
    return failure(ErrorCode::badHeader, "A prepared volume in the cache was damaged; it is made again.", {{"file", entry.echo.string()}});
  return found;
}

Result<void> writeCached(const CacheEntry& entry, const Prepared& made, Progress& progress) {
  std::error_code error;
  fs::create_directories(entry.ready.parent_path(), error);
  if (error)
    return failure(ErrorCode::notWritable,
                   "The cache folder cannot be made (" + error.message() +
                       "); set ECHOWEAVE_CACHE to a folder you may "
                       "write to.",
                   {{"file", entry.ready.parent_path().string()}});
  // Speckle hardly compresses, and an uncompressed file opens several times faster.
  const WriteOptions plain{.compress = false};
  PartOfProgress first(progress, 0.0, 0.33);
  PartOfProgress second(progress, 0.33, 0.67);
  PartOfProgress third(progress, 0.67, 1.0);
  if (auto written = writeVolume(made.volume, entry.echo, first, plain); !written) return written;
  if (auto written = writeCoverage(made.volume, entry.coverage, second, plain); !written) return written;
  if (auto written = writeVolume(made.labels, entry.labels, third, plain); !written) return written;
  const nlohmann::json ready = {
      {"echo", hashOf(made.volume.echo)}, {"coverage", hashOf(made.volume.coverage)}, {"labels", hashOf(made.labels.echo)}};
  return writeFileSafely(entry.ready, ready.dump(2) + "\n");
}

Result<std::vector<TissueAcoustics>> acousticsOf(const fs::path& recipe) {
  const auto tissues = readLabelTissues(recipe, mannequinFolder());
  if (!tissues) return passOn(tissues.error());
  std::vector<TissueAcoustics> acoustics;
  for (const LabelTissue& each : *tissues)
    acoustics.push_back(
        {each.label, each.organ.empty() ? each.tissue.name : each.organ, each.tissue.attenuation_dbPerCmMhz, each.tissue.reflection_db});
  return acoustics;
}

Result<CaseEcho> fromRecipe(const Case& opened, Progress& progress) {
  auto entry = cacheEntryOf(opened);
  if (!entry) return passOn(entry.error());
  auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
  if (!recipe) return passOn(recipe.error());
  auto tissues = acousticsOf(*recipe);
  if (!tissues) return passOn(tissues.error());
  CaseEcho found;
  found.tissues = std::move(*tissues);
  std::error_code ignored;
  if (fs::exists(entry->ready, ignored)) {
    auto cached = readCached(*entry, progress);
    if (cached) {
      found.volume = std::move(cached->volume);
      found.labels = std::move(cached->labels);
      return found;
    }
    if (cached.error().code == ErrorCode::cancelled) return passOn(cached.error());
    found.notes.emplace_back("The prepared volume in the cache could not be used and was made again. " + cached.error().sentence);
  }
  auto patient = readPatient(*recipe, mannequinFolder());
  if (!patient) return passOn(patient.error());
  PartOfProgress making(progress, 0.0, 0.9);
  auto voxels = voxelise(**patient, {.spacing_mm = opened.volume.recipeSpacing_mm}, making);
  if (!voxels) return passOn(voxels.error());
  Prepared made{std::move(voxels->volume), {}};
  made.labels = {made.volume.grid, std::move(voxels->labels), {}};
  PartOfProgress saving(progress, 0.9, 1.0);
  saving.report("Saving the prepared volume", 0.0);
  // Without a cache the case still opens; it is only made anew next time, and the user is told why. A cancel, though, is a cancel.
  if (auto written = writeCached(*entry, made, saving); !written) {
    if (written.error().code == ErrorCode::cancelled) return passOn(written.error());
    found.notes.push_back("The prepared volume could not be kept for the next start. " + written.error().sentence);
  }
  found.volume = std::move(made.volume);
  found.labels = std::move(made.labels);
  return found;
}

}  // namespace

Result<CaseEcho> loadCaseVolume(const Case& opened, Progress& progress) {
  Result<CaseEcho> found = [&]() -> Result<CaseEcho> {
    if (!opened.volume.recipe.empty()) return fromRecipe(opened, progress);
    auto file = fileOfCase(opened.folder, opened.volume.file, "volume.file");
    if (!file) return passOn(file.error());
    PartOfProgress first(progress, 0.0, opened.volume.labels.empty() ? 1.0 : 0.5);
    auto loaded = readVolume(*file, first);
    if (!loaded) return passOn(loaded.error());
    CaseEcho read{std::move(loaded->volume), std::nullopt, {}, std::move(loaded->notes)};
    if (opened.volume.labels.empty()) return read;
    auto labelFile = fileOfCase(opened.folder, opened.volume.labels, "volume.labels");
    if (!labelFile) return passOn(labelFile.error());
    PartOfProgress second(progress, 0.5, 1.0);
    auto labels = readLabelVolume(*labelFile, second);
    if (!labels) return passOn(labels.error());
    read.labels = std::move(labels->volume);
    read.notes.insert(read.notes.end(), labels->notes.begin(), labels->notes.end());
    return read;
  }();
  if (!found) return found;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  found->volume.grid = placed(found->volume.grid, opened.volume.fileToWorld);
  if (found->labels) found->labels->grid = placed(found->labels->grid, opened.volume.fileToWorld);
  return found;
}

Scene sceneWithTissues(const Scene& manifest, const std::vector<TissueAcoustics>& recipe) {
  Scene scene = manifest;
  for (const TissueAcoustics& each : recipe) {
    const bool own = std::any_of(manifest.tissues.begin(), manifest.tissues.end(), [&](const auto& t) { return t.label == each.label; });
    if (!own) scene.tissues.push_back(each);
  }
  std::stable_sort(scene.tissues.begin(), scene.tissues.end(), [](const auto& a, const auto& b) { return a.label < b.label; });
  return scene;
}

bool caseNeedsPreparation(const Case& opened) {
  if (opened.volume.recipe.empty()) return false;
  const auto entry = cacheEntryOf(opened);
  std::error_code ignored;
  return entry && !fs::exists(entry->ready, ignored);
}

}  // namespace ew
