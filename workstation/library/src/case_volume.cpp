#include <xxhash.h>

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
constexpr int kRecipeCacheFormat = 1;

std::string hex(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

std::string hashOf(const std::vector<std::uint8_t>& values) { return hex(XXH3_64bits(values.data(), values.size())); }

/// The three files that hold one voxelised recipe. `ready` is written last and carries the hashes of what the others hold.
struct CacheEntry {
  fs::path echo;
  fs::path coverage;
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
  return CacheEntry{folder / (name + ".mha"), folder / (name + ".coverage.mha"), folder / (name + ".json")};
}

/// The cached volume, or why it has to be made again.
Result<Volume> readCached(const CacheEntry& entry, Progress& progress) {
  auto text = readTextFile(entry.ready, 1u << 16);
  if (!text) return passOn(text.error());
  auto ready = parseJson(*text, entry.ready.filename().string());
  if (!ready) return passOn(ready.error());
  auto loaded = readVolume(entry.echo, progress);
  if (!loaded) return passOn(loaded.error());
  Volume volume = std::move(loaded->volume);
  if (auto read = readCoverageInto(volume, entry.coverage, progress); !read) return passOn(read.error());
  const auto promised = [&](const char* field) {
    return ready->is_object() && ready->contains(field) && (*ready)[field].is_string() ? (*ready)[field].get<std::string>() : std::string();
  };
  if (promised("echo") != hashOf(volume.echo) || promised("coverage") != hashOf(volume.coverage))
    return failure(ErrorCode::badHeader, "A prepared volume in the cache was damaged; it is made again.", {{"file", entry.echo.string()}});
  return volume;
}

Result<void> writeCached(const CacheEntry& entry, const Volume& volume, Progress& progress) {
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
  PartOfProgress first(progress, 0.0, 0.5);
  PartOfProgress second(progress, 0.5, 1.0);
  if (auto written = writeVolume(volume, entry.echo, first, plain); !written) return written;
  if (auto written = writeCoverage(volume, entry.coverage, second, plain); !written) return written;
  const nlohmann::json ready = {{"echo", hashOf(volume.echo)}, {"coverage", hashOf(volume.coverage)}};
  return writeFileSafely(entry.ready, ready.dump(2) + "\n");
}

Result<CaseEcho> fromRecipe(const Case& opened, Progress& progress) {
  auto entry = cacheEntryOf(opened);
  if (!entry) return passOn(entry.error());
  CaseEcho found;
  std::error_code ignored;
  if (fs::exists(entry->ready, ignored)) {
    auto cached = readCached(*entry, progress);
    if (cached) {
      found.volume = std::move(*cached);
      return found;
    }
    if (cached.error().code == ErrorCode::cancelled) return passOn(cached.error());
    found.notes.emplace_back("The prepared volume in the cache could not be used and was made again. " + cached.error().sentence);
  }
  auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
  if (!recipe) return passOn(recipe.error());
  auto patient = readPatient(*recipe, mannequinFolder());
  if (!patient) return passOn(patient.error());
  PartOfProgress making(progress, 0.0, 0.9);
  auto made = voxelise(**patient, {.spacing_mm = opened.volume.recipeSpacing_mm}, making);
  if (!made) return passOn(made.error());
  PartOfProgress saving(progress, 0.9, 1.0);
  saving.report("Saving the prepared volume", 0.0);
  // Without a cache the case still opens; it is only made anew next time, and the user is told why. A cancel, though, is a cancel.
  if (auto written = writeCached(*entry, made->volume, saving); !written) {
    if (written.error().code == ErrorCode::cancelled) return passOn(written.error());
    found.notes.push_back("The prepared volume could not be kept for the next start. " + written.error().sentence);
  }
  found.volume = std::move(made->volume);
  return found;
}

}  // namespace

Result<CaseEcho> loadCaseVolume(const Case& opened, Progress& progress) {
  Result<CaseEcho> found = [&]() -> Result<CaseEcho> {
    if (!opened.volume.recipe.empty()) return fromRecipe(opened, progress);
    auto file = fileOfCase(opened.folder, opened.volume.file, "volume.file");
    if (!file) return passOn(file.error());
    auto loaded = readVolume(*file, progress);
    if (!loaded) return passOn(loaded.error());
    return CaseEcho{std::move(loaded->volume), std::move(loaded->notes)};
  }();
  if (!found) return found;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  found->volume.grid = placed(found->volume.grid, opened.volume.fileToWorld);
  return found;
}

bool caseNeedsPreparation(const Case& opened) {
  if (opened.volume.recipe.empty()) return false;
  const auto entry = cacheEntryOf(opened);
  std::error_code ignored;
  return entry && !fs::exists(entry->ready, ignored);
}

}  // namespace ew
