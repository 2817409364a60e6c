#include "ew/library/voxel_source.h"

#include <algorithm>

namespace ew {

Result<SweepReconstruction> importTracedSweep(SweepInput opened, const std::filesystem::path& sweep, const SweepImportOptions& options,
                                              Progress& progress) {
  EW_EXPECTS(opened.plan.reconstruct.keepSource);
  SweepImportOptions kept = options;
  // A delay that was found out need not be found out again.
  if (const auto& delay = opened.plan.poseDelay) {
    kept.estimatePoseDelay = false;
    if (delay->verdict != DelayVerdict::cannotTell) kept.poseDelay_s = delay->delay_s;
  }
  Provenance provenance;
  provenance.sweep = sweep;
  provenance.options = kept;
  provenance.width_px = opened.sequence.width;
  provenance.height_px = opened.sequence.height;
  provenance.recordedFrames = opened.sequence.frames.size();
  for (std::size_t n = 0; n < provenance.recordedFrames; ++n)
    if (const auto& pose = opened.poses.imageToWorld[n]) provenance.frames.push_back({n, opened.sequence.frames[n].time_s, *pose});
  auto imported = importSweep(std::move(opened), progress);
  if (!imported) return passOn(imported.error());
  provenance.grid = imported->reconstruction.volume.grid;
  provenance.source = std::move(imported->reconstruction.source);
  return SweepReconstruction{std::move(*imported), std::move(provenance)};
}

Point<frame::World> pointShownAt(const DisplayGeometry& geometry, const Pose& pose, const glm::dvec2& pixel) {
  return pose.probeToWorld * (geometry.imageToProbe() * Point<frame::Image>{{pixel, 0.0}});
}

VoxelSource voxelSourceAt(const Provenance& provenance, const Volume& volume, const Grid& placedGrid, const Point<frame::World>& at) {
  EW_EXPECTS(volume.grid.dims == provenance.grid.dims && placedGrid.dims == provenance.grid.dims);
  const Point<frame::Voxel> at_voxel = placedGrid.worldToVoxel() * at;
  const glm::dvec3 nearest = glm::floor(at_voxel.at + 0.5);
  VoxelSource answer;
  // Also false for what is not a number.
  for (int axis = 0; axis < 3; ++axis)
    if (!(nearest[axis] >= 0.0 && nearest[axis] < provenance.grid.dims[axis])) return answer;
  answer.voxel = glm::ivec3(nearest);
  answer.at_recorded = provenance.grid.voxelToWorld() * at_voxel;
  answer.coverage = volume.coverageAt(volume.grid.indexOf(answer.voxel.x, answer.voxel.y, answer.voxel.z));
  std::vector<TrackedFrame> frames;
  frames.reserve(provenance.frames.size());
  for (const FrameProvenance& frame : provenance.frames) frames.push_back({{}, frame.imageToWorld});
  const auto source = sourceFrameAt(provenance.grid, provenance.source, frames, answer.at_recorded);
  answer.found = source ? VoxelSource::Found::frame : VoxelSource::Found::absent;
  if (!source) return answer;
  answer.frame = source->frame;
  answer.at_px = source->at_px;
  answer.distance_mm = source->distance_mm;
  return answer;
}

Result<Sequence> readTracedImages(const Provenance& provenance, Progress& progress) {
  auto opened = openSweep(provenance.sweep, provenance.options, progress);
  if (!opened) return passOn(opened.error());
  const Sequence& sequence = opened->sequence;
  bool same = sequence.width == provenance.width_px && sequence.height == provenance.height_px &&
              sequence.frames.size() == provenance.recordedFrames && opened->poses.usable == provenance.frames.size();
  same = same && std::all_of(provenance.frames.begin(), provenance.frames.end(), [&](const FrameProvenance& frame) {
           return opened->poses.imageToWorld[frame.number] == frame.imageToWorld && sequence.frames[frame.number].time_s == frame.time_s;
         });
  if (!same)
    return failure(ErrorCode::badField,
                   say<"The recording '%1' is no longer the one that the volume was made from; make the volume again to see its frames.">(
                       provenance.sweep.filename()),
                   {{"file", provenance.sweep.string()}});
  return std::move(opened->sequence);
}

}  // namespace ew
