#include "ew/scanning/scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

namespace {

/// Whether images of this plan show voxels, and not only what is formed anew of the maps of tissue.
bool readsVoxels(const Plan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(), [](const Step& step) {
    return step.kind == StepKind::sampleWeave || step.kind == StepKind::sampleLinear || step.kind == StepKind::sampleCubic ||
           step.kind == StepKind::ownGrain;
  });
}

}  // namespace

std::size_t framesToSettle(const Knobs& knobs) {
  const auto until = [](double persistence) {
    constexpr double kMost = 0.95;
    return persistence > 0.0 ? 1 + static_cast<std::size_t>(std::ceil(std::log(0.5 / 255.0) / std::log(std::min(persistence, kMost)))) : 0;
  };
  const std::size_t grey = until(knobs.persistence);
  return knobs.colour ? std::max(grey, 1 + until(knobs.colour->persistence)) : grey;
}

void Scanner::show(ScanSubject subject) {
  sliced_.reset();
  subject_ = std::move(subject);
  seenTissue_.reset();
  maker_.forget();
}

void Scanner::refine(ScanSubject better) {
  EW_EXPECTS(subject_.has_value());
  sliced_.reset();
  if (better.tissue != seenTissue_) seenTissue_.reset();
  subject_ = std::move(better);
}

void Scanner::clear() {
  sliced_.reset();
  subject_.reset();
  seenTissue_.reset();
  maker_.forget();
}

void Scanner::setTitle(std::string title) {
  if (subject_) subject_->title = std::move(title);
}

void Scanner::setScene(Scene scene) {
  if (subject_) subject_->scene = std::move(scene);
}

void Scanner::know(std::shared_ptr<const TissueMaps> ofVoxels) {
  if (subject_) subject_->know(std::move(ofVoxels));
}

void Scanner::place(const Transform<frame::World, frame::World>& ownToWorld) {
  if (subject_) subject_->place(ownToWorld);
}

void Scanner::setLabels(std::shared_ptr<const Volume> labels) {
  if (!subject_) return;
  subject_->labels = std::move(labels);
  if (!subject_->labels) return;
  // The voxels stay where they are, to the last bit.
  subject_->placedLabels = placed(subject_->labels->grid, subject_->placedGrid.voxelToWorld() * subject_->voxels.grid().worldToVoxel());
}

void Scanner::prepare(const ScanState& state, int width_px, int height_px) {
  EW_EXPECTS(subject_.has_value());
  const Scene* scene = &state.scene;
  Scene joined;
  if (scene->tissues.empty() && !subject_->scene.tissues.empty()) {
    joined = state.scene;
    joined.tissues = subject_->scene.tissues;
    scene = &joined;
  }
  const FrameParts parts{.labels = subject_->labels != nullptr,
                         .tissue = subject_->tissue != nullptr,
                         .recorded = subject_->tissue != nullptr && subject_->tissue->isRecorded,
                         .flow = subject_->flow != nullptr};
  maker_.configure(state.probe, state.knobs, *scene, subject_->placedGrid, width_px, height_px, parts, state.pan);
}

DisplayImage Scanner::make(const ScanState& state, int width_px, int height_px) {
  prepare(state, width_px, height_px);
  FrameInput input;
  if (!readsVoxels(plan()))
    sliced_.reset();
  else if (!sliced_)
    sliced_ = subject_->voxels.withBricks();
  const ScanVoxels& voxels = sliced_ ? *sliced_ : subject_->voxels;
  // Zooming out, a weave undersamples as the paper's does; the better qualities read a coarser level.
  input.echo = voxels.source(subject_->placedGrid, state.knobs.quality == Quality::weave ? 0.0 : geometry().pixel_mm);
  if (subject_->labels) input.labels = VolumeView<const std::uint8_t>{subject_->labels->echo.data(), subject_->placedLabels};
  if (subject_->tissue) {
    input.tissue = subject_->tissue.get();
    if (seenTissue_ != subject_->tissue) {
      seenTissue_ = subject_->tissue;
      ++tissueVersion_;
    }
    input.tissueVersion = tissueVersion_;
    input.tissueGrid = subject_->placedTissue;
    input.motion = subject_->motion.get();
    input.body = state.body;
    input.flow = subject_->flow.get();
  }
  input.pose = state.pose;
  input.gaps_mm = state.gaps_mm;
  input.time_s = state.time_s;
  input.number = state.number;
  const DisplayImage image = maker_.make(input);
  // Nothing of the time before a gap shows behind it, neither live, where no image is made in it, nor here, when that is played again.
  if (state.pose.status != PoseStatus::ok) maker_.forget();
  return image;
}

bool Scanner::seesVolume(const Pose& pose) const {
  if (!subject_ || pose.status != PoseStatus::ok || geometry().width == 0) return false;
  const Grid& grid = subject_->placedGrid;
  const glm::dmat4 imageToVoxel = (grid.worldToVoxel() * pose.probeToWorld * geometry().imageToProbe()).matrix;
  const Spans& fan = spans();
  constexpr int kEvery_px = 8;
  for (std::size_t y = 0; y < fan.size(); y += kEvery_px) {
    for (const RowSpan& run : fan[y]) {
      for (int x = run.begin; x < run.end; x += kEvery_px) {
        const glm::dvec3 p_voxel(imageToVoxel * glm::dvec4(x, y, 0.0, 1.0));
        if (glm::all(glm::greaterThanEqual(p_voxel, glm::dvec3(-0.5))) && glm::all(glm::lessThan(p_voxel, glm::dvec3(grid.dims) - 0.5)))
          return true;
      }
    }
  }
  return false;
}

}  // namespace ew
