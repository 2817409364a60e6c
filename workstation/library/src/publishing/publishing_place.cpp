#include "publishing/publishing_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/manifest.h"
#include "ew/imaging/probe.h"
#include "ew/io/volume_file.h"
#include "ew/phantom/patient.h"

namespace ew {
namespace {

/// The grid of a case as it is placed; of a recipe, two voxels along each edge of its box.
std::optional<Grid> placedGridOf(const Case& opened) {
  Grid grid;
  if (!opened.volume.recipe.empty()) {
    const auto resources = resourceFolder();
    const auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
    if (!resources || !recipe) return std::nullopt;
    const auto box = readPatientBox(*recipe, *resources / "mannequin");
    if (!box) return std::nullopt;
    grid.dims = glm::ivec3(2);
    grid.origin_mm = box->lowest_mm;
    grid.spacing_mm = box->highest_mm - box->lowest_mm;
  } else {
    const auto file = volumeOfCase(opened.folder, opened.volume.file, "volume.file");
    const auto header = file ? readVolumeHeader(*file) : Result<VolumeHeader>(passOn(file.error()));
    if (!header || header->sequence) return std::nullopt;
    grid = header->grid;
  }
  return placed(grid, opened.volume.fileToWorld);
}

bool isWithin(const Grid& grid, const Transform<frame::Voxel, frame::World>& worldToVoxel, const glm::dvec3& p_mm) {
  const glm::dvec3 ijk = carried(worldToVoxel, p_mm);
  return glm::all(glm::greaterThanEqual(ijk, glm::dvec3(-0.5))) && glm::all(glm::lessThan(ijk, glm::dvec3(grid.dims) - 0.5));
}

/// Whether an image of 17 lines, looked at every 3 mm down to the probe's usual depth, meets the grid.
bool sees(const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld, const Grid& grid) {
  constexpr double kStep_mm = 3.0;
  constexpr int kLines = 17;
  const auto worldToVoxel = grid.worldToVoxel();
  for (const glm::dvec3& foot : facePoints_mm(probe, kLines)) {
    const glm::dvec3 apex(0.0, isSector(probe.kind) ? -probe.radius_mm : -1e6, 0.0);
    const glm::dvec3 along = glm::length(foot - apex) > 0.0 ? glm::normalize(foot - apex) : glm::dvec3(0.0, 1.0, 0.0);
    for (double depth_mm = 0.0; depth_mm <= probe.defaultDepth_mm; depth_mm += kStep_mm)
      if (isWithin(grid, worldToVoxel, carried(probeToWorld, foot + depth_mm * along))) return true;
  }
  return false;
}

std::optional<Probe> firstProbeOf(const Case& opened) {
  const auto probes = shippedProbes();
  if (!probes || probes->empty()) return std::nullopt;
  const auto named = std::find_if(probes->begin(), probes->end(),
                                  [&](const Probe& each) { return !opened.probes.empty() && each.id == opened.probes.front(); });
  return named == probes->end() ? probes->front() : *named;
}

/// Whether two poses show about the same image, whichever way the marker points.
bool areAlike(const Transform<frame::World, frame::Probe>& a, const Transform<frame::World, frame::Probe>& b, double most_mm,
              double most_deg) {
  const glm::dmat3 between = glm::transpose(glm::dmat3(a.matrix)) * glm::dmat3(b.matrix);
  const double angle_rad = std::acos(std::clamp(0.5 * (between[0][0] + between[1][1] + between[2][2] - 1.0), -1.0, 1.0));
  const double turned_rad = std::acos(std::clamp(0.5 * (-between[0][0] + between[1][1] - between[2][2] - 1.0), -1.0, 1.0));
  return glm::distance(glm::dvec3(a.matrix[3]), glm::dvec3(b.matrix[3])) <= most_mm &&
         std::min(angle_rad, turned_rad) * 180.0 / std::numbers::pi <= most_deg;
}

}  // namespace

std::optional<bool> startSeesVolume(const Case& opened) {
  const auto grid = placedGridOf(opened);
  const auto probe = firstProbeOf(opened);
  if (!opened.startPose || !grid || !probe) return std::nullopt;
  return sees(*probe, opened.startPose->probeToWorld, *grid);
}

bool startGivesAway(const Case& opened) {
  if (!opened.startPose) return false;
  constexpr double kAlike_mm = 10.0, kAlike_deg = 15.0;
  const auto& start = opened.startPose->probeToWorld;
  if (opened.expertPose && areAlike(start, opened.expertPose->probeToWorld, kAlike_mm, kAlike_deg)) return true;
  return std::any_of(opened.targets.begin(), opened.targets.end(), [&](const CaseTarget& each) {
    return each.revealsFinding && each.probeToFile &&
           areAlike(start, opened.volume.fileToWorld * *each.probeToFile, each.positionTolerance_mm.value_or(kAlike_mm),
                    each.angleTolerance_deg.value_or(kAlike_deg));
  });
}

Result<Contact> contactOfCase(const Case& opened, const CheckSources& sources, Progress& progress) {
  if (!sources.skin)
    return failure(ErrorCode::unsupported, say<"Nobody knows the skin of the mannequin here, so the volume's contact was not checked.">());
  const SweepAxes axes = sweepAxesOf(opened).value_or(SweepAxes{});
  if (sources.volume) return contactOf(placingShapeOf(*sources.volume, axes), opened.volume.fileToWorld, *sources.skin);
  const auto file = volumeOfCase(opened.folder, opened.volume.file, "volume.file");
  if (!file) return passOn(file.error());
  const auto read = readVolume(*file, progress);
  if (!read) return passOn(read.error());
  return contactOf(placingShapeOf(read->volume, axes), opened.volume.fileToWorld, *sources.skin);
}

Reach reachOf(const CaseTarget& target, const Case& opened, const CheckSources& sources) {
  const auto grid = placedGridOf(opened);
  if (!grid) return Reach::reached;
  if (target.at_mm && !isWithin(*grid, grid->worldToVoxel(), carried(opened.volume.fileToWorld, *target.at_mm))) return Reach::outside;
  if (!target.probeToFile) return Reach::reached;
  const auto probeToWorld = opened.volume.fileToWorld * *target.probeToFile;
  const auto probe = firstProbeOf(opened);
  if (probe && !sees(*probe, probeToWorld, *grid)) return Reach::outside;
  if (!sources.skin) return Reach::reached;
  const glm::dvec3 face_mm(probeToWorld.matrix[3]);
  return glm::distance(sources.skin->nearest(face_mm).point_mm, face_mm) > kFarthestFromSkin_mm ? Reach::offSkin : Reach::reached;
}

}  // namespace ew
