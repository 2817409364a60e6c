#include "chain/chain_keys.h"

#include <algorithm>

#include "chain/overlap.h"
#include "ew/core/version.h"
#include "ew/stitching/places.h"

namespace ew::stitching {
namespace {

/// Voxels of the finest images of rigid pairs that are warped afterwards: places within 0.2 mm are all that warping needs.
constexpr double kFinestBeforeBending_mm = 1.5;

void addOptions(ContentKey& key, const StitchOptions& grid) {
  key.add(grid.spacing_mm).add(grid.featherWidth_mm).add(grid.interpolatedWeight).add(static_cast<int>(grid.axes));
}
void addOptions(ContentKey& key, const SeamOptions& seam) {
  key.add(static_cast<int>(seam.method))
      .add(seam.cell_mm)
      .add(seam.blend_mm)
      .add(seam.levelBlend_mm)
      .add(seam.confidenceWeight)
      .add(seam.distanceWeight);
  for (const auto& stroke : seam.strokes) key.add(static_cast<std::uint64_t>(stroke.view)).add(stroke.at_mm).add(stroke.radius_mm);
}

std::string keyOf(const Candidate& candidate, const ChainInputs& inputs) {
  const PairTask& task = candidate.task;
  const PairMethod first = firstMethod(task);
  ContentKey key = newKey("pair", kPairFormat);
  key.add(inputs[candidate.fixed].key).add(inputs[candidate.moving].key);
  key.add(static_cast<int>(task.method)).add(static_cast<int>(first));
  if (first != PairMethod::byHand) key.add(task.finest_mm);
  if (first == PairMethod::refine || first == PairMethod::byHand) key.add(task.start);
  if (first == PairMethod::search) key.add(task.maxRotation_deg);
  if (first == PairMethod::refine) {
    const SearchReach reach = searchReach(task);
    key.add(reach.rotation_deg).add(reach.shift_mm);
  }
  if (first == PairMethod::landmarks)
    for (const auto& landmark : task.landmarks) key.add(landmark.name).add(landmark.fixed_mm).add(landmark.moving_mm);
  return key.text();
}

/// What is asked of a pair.
/// @param entry what a person said about it; null: nothing
PairTask taskOf(const StitchProject& project, std::size_t f, std::size_t m, bool placesKnown, const ProjectPair* entry) {
  const ProjectSettings& settings = project.settings;
  PairTask task{.placesKnown = placesKnown,
                .start = fixedToMovingOf(project.volumes[f].toWorld, project.volumes[m].toWorld),
                .landmarks = {},
                .maxRotation_deg = settings.maxRotation_deg,
                .trackerError_mm = settings.trackerError_mm,
                .trackerError_deg = settings.trackerError_deg};
  if (settings.elastic) task.finest_mm = kFinestBeforeBending_mm;
  if (entry == nullptr) return task;
  task.method = entry->method;
  task.landmarks = entry->landmarks;
  if (entry->start) {
    task.start = *entry->start;
    task.placesKnown = true;
  }
  if (entry->maxRotation_deg) task.maxRotation_deg = *entry->maxRotation_deg;
  return task;
}

}  // namespace

ContentKey newKey(const char* what, int format) {
  ContentKey key;
  key.add(what).add(format).add(kVersion);
  return key;
}

bool isExact(const StitchProject& project, std::size_t v) {
  return project.settings.trackerError_mm == 0.0 && project.volumes[v].placement == Placement::tracker;
}

std::vector<Candidate> candidatesOf(const StitchProject& project, const ChainInputs& inputs) {
  const auto isKnown = [&](std::size_t v) { return project.volumes[v].placement != Placement::unknown; };
  const auto box = [&](std::size_t v) { return placed(inputs[v].grid, project.volumes[v].toWorld); };
  std::vector<Candidate> found;
  for (std::size_t f = 0; f < inputs.size(); ++f)
    for (std::size_t m = f + 1; m < inputs.size(); ++m) {
      const auto at = std::find_if(project.pairs.begin(), project.pairs.end(),
                                   [&](const ProjectPair& pair) { return pair.fixed == f && pair.moving == m; });
      const ProjectPair* entry = at != project.pairs.end() && speaksOfPose(*at) ? &*at : nullptr;
      const bool known = isKnown(f) && isKnown(m);
      if (entry == nullptr && isExact(project, f) && isExact(project, m)) continue;
      if (entry == nullptr && known && !boxesMeet(box(f), box(m), project.settings.trackerError_mm)) continue;
      Candidate candidate;
      candidate.fixed = f;
      candidate.moving = m;
      candidate.task = taskOf(project, f, m, known, entry);
      if (entry != nullptr) candidate.decision = entry->decision;
      candidate.key = keyOf(candidate, inputs);
      found.push_back(std::move(candidate));
    }
  return found;
}

Keys keysOf(const StitchProject& project, const ChainOptions& options, const ChainInputs& inputs, const std::vector<Candidate>& pairs) {
  const ProjectSettings& settings = project.settings;
  Keys keys;
  ContentKey reconstructed = newKey("reconstruct", kInputFormat);
  for (std::size_t v = 0; v < inputs.size(); ++v) reconstructed.add(inputs[v].key);
  keys[Step::reconstruct] = reconstructed.text();
  ContentKey matched = newKey("rigid", kPairFormat);
  matched.add(keys[Step::reconstruct]);
  for (const Candidate& pair : pairs)
    if (pair.decision != Decision::rejected)
      matched.add(static_cast<std::uint64_t>(pair.fixed)).add(static_cast<std::uint64_t>(pair.moving)).add(pair.key);
  keys[Step::rigid] = matched.text();
  ContentKey posed = newKey("graph", kGraphFormat);
  posed.add(keys[Step::rigid]).add(settings.trackerError_mm).add(settings.trackerError_deg);
  for (const Candidate& pair : pairs) posed.add(static_cast<int>(pair.decision));
  for (const ProjectVolume& volume : project.volumes) posed.add(static_cast<int>(volume.placement)).add(volume.toWorld);
  const std::string poses = posed.text();
  for (const ProjectVolume& volume : project.volumes) posed.add(volume.name);  // the reason names them
  keys[Step::graph] = posed.text();
  keys[Step::equalise] = newKey("equalise", kEqualiseFormat).add(poses).add(settings.equalise).text();
  ContentKey warped = newKey("elastic", kWarpFormat);
  warped.add(poses).add(settings.elastic);
  if (settings.elastic) {
    warped.add(static_cast<int>(settings.effort)).add(settings.fallOff_mm);
    for (const ProjectPair& pair : project.pairs)
      if (pair.effort && *pair.effort != settings.effort)
        warped.add(static_cast<std::uint64_t>(pair.fixed)).add(static_cast<std::uint64_t>(pair.moving)).add(static_cast<int>(*pair.effort));
  }
  keys[Step::elastic] = warped.text();
  ContentKey cut = newKey("seam", kSeamFormat);
  cut.add(keys[Step::equalise]).add(keys[Step::elastic]);
  addOptions(cut, settings.join.grid);
  addOptions(cut, settings.join.seam);
  keys[Step::seam] = cut.text();
  ContentKey joined = newKey("volume", kVolumeFormat);
  joined.add(keys[Step::seam]).add(keys[Step::graph]);
  for (const ProjectVolume& volume : project.volumes)
    joined.add(volume.file.generic_string()).add(volume.coverage.generic_string()).add(volume.confidence.generic_string());
  joined.add(options.streamAbove_voxels);  // the same voxels, but other bytes of the files
  keys[Step::volume] = joined.text();
  return keys;
}

std::string keyOfWarp(const ChainInput& fixed, const ChainInput& moving, const Transform<frame::Moving, frame::Fixed>& start,
                      registration::ElasticEffort effort) {
  ContentKey name = newKey("bend", kWarpFormat);
  name.add(fixed.key).add(moving.key).add(start).add(static_cast<int>(effort));
  return name.text();
}

}  // namespace ew::stitching
