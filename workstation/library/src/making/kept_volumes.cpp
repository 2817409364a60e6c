#include "making/kept_volumes.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "case/kept_maps.h"
#include "case/kept_motion.h"
#include "ew/io/rest_in_file.h"

namespace ew {
namespace {

bool hasVoxels(const Volume& volume) { return !volume.echo.empty(); }

}  // namespace

bool isWhole(const StepStore& store, const char* step, const std::string& key, std::initializer_list<const char*> names) {
  return store.find(step, key) && std::all_of(names.begin(), names.end(), [&](const char* name) { return store.isSound(step, key, name); });
}

tl::unexpected<Error> damagedInCache(const StepStore& store, const char* step, const std::string& key) {
  return failure(ErrorCode::badHeader, say<"A prepared volume in the cache was damaged; it is made again.">(),
                 {{"file", store.fileOf(step, key, {}).string()}});
}

Result<Volume> readKeptVolume(const StepStore& store, const char* step, const std::string& key, Progress& progress) {
  if (!isWhole(store, step, key, {kVolumeFile, kCoverageFile})) return damagedInCache(store, step, key);
  auto loaded = readVolume(store.fileOf(step, key, kVolumeFile), progress);
  if (!loaded) return passOn(loaded.error());
  restInVolumeFile(loaded->volume.echo, store.fileOf(step, key, kVolumeFile));  // before the next array is read
  if (auto read = readCoverageInto(loaded->volume, store.fileOf(step, key, kCoverageFile), progress); !read) return passOn(read.error());
  restInVolumeFile(loaded->volume.coverage, store.fileOf(step, key, kCoverageFile));
  return std::move(loaded->volume);
}

Result<Volume> readKeptLabels(const StepStore& store, const char* step, const std::string& key, Progress& progress) {
  if (!isWhole(store, step, key, {kLabelsFile})) return damagedInCache(store, step, key);
  auto labels = readLabelVolume(store.fileOf(step, key, kLabelsFile), progress);
  if (!labels) return passOn(labels.error());
  restInVolumeFile(labels->volume.echo, store.fileOf(step, key, kLabelsFile));
  return std::move(labels->volume);
}

Result<void> keepPrepared(const StepStore& store, const char* step, const std::string& key, const Prepared& made, Progress& progress) {
  if (auto room = store.prepare(step); !room) return room;
  PartOfProgress first(progress, 0.0, 0.33), second(progress, 0.33, 0.67), third(progress, 0.67, 1.0);
  std::vector<std::string> names;
  const auto fileFor = [&](const char* name) { return store.fileOf(step, key, names.emplace_back(name)); };
  if (hasVoxels(made.volume)) {
    if (auto written = writeVolume(made.volume, fileFor(kVolumeFile), first, kPlain); !written) return written;
    if (auto written = writeCoverage(made.volume, fileFor(kCoverageFile), second, kPlain); !written) return written;
  }
  if (hasVoxels(made.labels))
    if (auto written = writeVolume(made.labels, fileFor(kLabelsFile), third, kPlain); !written) return written;
  return store.keep(step, key, {}, names);
}

void restWhereKept(const StepStore& store, const char* step, const std::string& key, Prepared& made) {
  restInVolumeFile(made.volume.echo, store.fileOf(step, key, kVolumeFile));
  restInVolumeFile(made.volume.coverage, store.fileOf(step, key, kCoverageFile));
  restInVolumeFile(made.labels.echo, store.fileOf(step, key, kLabelsFile));
}

Result<Prepared> readPrepared(const CasePlan& plan, const StepStore& store, Progress& progress) {
  PartOfProgress first(progress, 0.0, 0.7), second(progress, 0.7, 1.0);
  auto volume = readKeptVolume(store, kVolumes, plan.volume, first);
  if (!volume) return passOn(volume.error());
  auto labels =
      plan.sweeps.empty() ? readKeptLabels(store, kVolumes, plan.volume, second) : readKeptLabels(store, kLabels, plan.labels, second);
  if (!labels) return passOn(labels.error());
  Prepared done{std::move(*volume), std::move(*labels)};
  done.maps = readKeptMaps(store, kMaps, plan.maps, done.volume.grid);
  if (!done.maps) return damagedInCache(store, kMaps, plan.maps);
  if (!plan.motion.empty() && !readKeptMotion(store, kMotions, plan.motion, done.motion))
    return damagedInCache(store, kMotions, plan.motion);
  return done;
}

}  // namespace ew
