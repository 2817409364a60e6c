#include "panel/stitch_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/stitching/places.h"
#include "logic/stitch_document.h"
#include "panel/project_document.h"
#include "panel/project_inputs.h"

namespace ew::stitching {

StitchLook::StitchLook(ProjectDocument& document, const ProjectInputs& inputs, const StitchResults& results)
    : document_(document), inputs_(inputs), results_(results) {}

const StitchProject& StitchLook::project() const { return document_.project(); }

void StitchLook::followProject() {
  const std::size_t count = project().volumes.size();
  if (chosenVolume_ && count == 0) chosenVolume_.reset();
  if (chosenVolume_ && *chosenVolume_ >= count) chosenVolume_ = count - 1;
  if (pair_ && pair_->moving >= count) pair_.reset();
  if (!pair_ && count >= 2) {
    pair_ = VolumePair{0, 1};
    if (const auto all = results_.pairs(pair_); !all.empty()) pair_ = VolumePair{all.front().fixed, all.front().moving};
    fit();
  }
  afterChoice();
}

void StitchLook::followResults() {
  if (stage_ == Stage::elastic && !hasElastic()) stage_ = Stage::rigid;
  if (!results_.found()->warps.empty() && hasElastic()) stage_ = Stage::elastic;
  afterChoice();
  fit();
}

void StitchLook::forget() {
  pair_.reset();
  chosenVolume_.reset();
}

void StitchLook::afterChoice() {
  landmarkResult_.reset();
  const auto marks = landmarks();
  if (chosenLandmark_ >= static_cast<int>(marks.size())) chosenLandmark_ = static_cast<int>(marks.size()) - 1;
  if (marks.empty()) return;
  if (auto result = registration::registerLandmarks(marks)) landmarkResult_ = std::move(*result);
}

void StitchLook::choosePair(std::size_t a, std::size_t b) {
  if (a == b || std::max(a, b) >= project().volumes.size()) return;
  const auto [low, high] = std::minmax(a, b);
  const VolumePair next{low, high};
  if (pair_ == next) return;
  pair_ = next;
  chosenLandmark_ = -1;
  pickedFixed_.reset();
  pickedMoving_.reset();
  document_.endMerging();
  afterChoice();
  fit();
  Q_EMIT choiceChanged();
  Q_EMIT pairChosen();
}

void StitchLook::chooseVolume(std::size_t index) {
  if (index >= project().volumes.size() || chosenVolume_ == index) return;
  chosenVolume_ = index;
  if (pair_ && pair_->fixed != index && pair_->moving != index && project().volumes.size() > 1) {
    // The first pair of it that was looked at, so that list and views speak of the same thing.
    for (const StitchResults::PairLine& line : results_.pairs(pair_))
      if (line.fixed == index || line.moving == index) return choosePair(line.fixed, line.moving);
  }
  Q_EMIT choiceChanged();
}

void StitchLook::chooseLandmark(int landmark) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  chosenLandmark_ = landmark;
  const auto& mark = marks[static_cast<std::size_t>(landmark)];
  setCross(mark.fixed_mm);
  if (!linked_) setMovingCross(mark.moving_mm);
  Q_EMIT choiceChanged();
}

std::vector<registration::LandmarkPair> StitchLook::landmarks() const {
  return pair_ ? pairOf(project(), pair_->fixed, pair_->moving).landmarks : std::vector<registration::LandmarkPair>{};
}

void StitchLook::pick(bool moving, const glm::dvec3& p_mm) {
  if (!pair_) return;
  (moving ? pickedMoving_ : pickedFixed_) = p_mm;
  if (!pickedFixed_ || !pickedMoving_) {
    Q_EMIT changed();
    Q_EMIT choiceChanged();
    return;
  }
  const glm::dvec3 inFixed_mm = *pickedFixed_, inMoving_mm = *pickedMoving_;
  pickedFixed_.reset();
  pickedMoving_.reset();
  chosenLandmark_ = static_cast<int>(landmarks().size());
  Q_EMIT landmarkPicked(inFixed_mm, inMoving_mm);
}

void StitchLook::dropPick() {
  pickedFixed_.reset();
  pickedMoving_.reset();
  Q_EMIT changed();
  Q_EMIT choiceChanged();
}

void StitchLook::setStage(Stage stage) {
  if (stage_ == stage || (stage == Stage::elastic && !hasElastic())) return;
  stage_ = stage;
  Q_EMIT changed();
}

bool StitchLook::hasElastic() const { return pair_ && results_.hasElastic(pair_->fixed, pair_->moving); }

Transform<frame::Moving, frame::Fixed> StitchLook::startTransform() const {
  if (!pair_) return {};
  return fixedToMovingOf(project().volumes[pair_->fixed].toWorld, project().volumes[pair_->moving].toWorld);
}

Transform<frame::Moving, frame::Fixed> StitchLook::transform() const {
  if (!pair_) return {};
  const ProjectPair said = pairOf(project(), pair_->fixed, pair_->moving);
  const StitchResults::PairLine line = results_.pairLine(pair_->fixed, pair_->moving);
  if (said.start && (said.method == PairMethod::byHand || line.outcome == nullptr || line.stale)) return *said.start;
  if (said.method == PairMethod::landmarks && landmarkResult_ && landmarkResult_->verdict != registration::Verdict::cannotTell &&
      (line.outcome == nullptr || line.stale))
    return landmarkResult_->fixedToMoving;
  if (line.outcome != nullptr) return line.outcome->rigid.fixedToMoving;
  return startTransform();
}

Mapping StitchLook::fixedMapping(Stage stage) const {
  if (stage != Stage::elastic || !hasElastic()) return {};
  const std::size_t i = *results_.foundIndex(pair_->fixed);
  const auto& world = results_.found()->graph->toWorld[i];
  return {renamed<frame::World, frame::Fixed>(world), &results_.found()->warps[i], rigidInverse(world)};
}

Mapping StitchLook::movingMapping(Stage stage) const {
  if (!pair_) return {};
  if (stage == Stage::elastic && hasElastic()) {
    const std::size_t i = *results_.foundIndex(pair_->fixed);
    const std::size_t j = *results_.foundIndex(pair_->moving);
    const auto fixedToWorld = renamed<frame::World, frame::Fixed>(results_.found()->graph->toWorld[i]);
    return {fixedToWorld, &results_.found()->warps[j], rigidInverse(results_.found()->graph->toWorld[j])};
  }
  return {{}, nullptr, renamed<frame::View, frame::World>(stage == Stage::start ? startTransform() : transform())};
}

Plane StitchLook::movingPlane() const { return linked_ ? moved(plane_, movingMapping(stage_).withoutWarp()) : movingPlane_; }

glm::dvec3 StitchLook::movingCross() const { return linked_ ? movingMapping(stage_)(cross_) : movingCross_; }

void StitchLook::setPlane(const Plane& plane) {
  plane_ = plane;
  Q_EMIT changed();
}

void StitchLook::setCross(const glm::dvec3& p_mm) {
  cross_ = p_mm;
  const double off = distanceTo(plane_, p_mm);
  if (std::abs(off) > 1e-9) plane_.centre_mm += off * plane_.normal();
  Q_EMIT changed();
}

void StitchLook::setMovingPlane(const Plane& plane) {
  if (linked_) return setPlane(moved(plane, rigidInverse(movingMapping(stage_).withoutWarp())));
  movingPlane_ = plane;
  Q_EMIT changed();
}

void StitchLook::setMovingCross(const glm::dvec3& p_mm) {
  if (linked_) return setCross(carried(rigidInverse(movingMapping(stage_).withoutWarp()), p_mm));
  movingCross_ = p_mm;
  const double off = distanceTo(movingPlane_, p_mm);
  if (std::abs(off) > 1e-9) movingPlane_.centre_mm += off * movingPlane_.normal();
  Q_EMIT changed();
}

void StitchLook::setLinked(bool linked) {
  if (linked_ == linked) return;
  if (!linked) {
    movingPlane_ = movingPlane();
    movingCross_ = movingCross();
    // Where the two do not overlap yet, a view of nothing helps nobody.
    if (pair_) {
      if (const auto moving = inputs_.volume(pair_->moving)) {
        const Bounds box = boundsOf(moving->grid);
        if (glm::any(glm::lessThan(movingCross_, box.lowest_mm)) || glm::any(glm::greaterThan(movingCross_, box.highest_mm))) {
          movingCross_ = middleOf(moving->grid);
          movingPlane_.centre_mm = movingCross_;
        }
      }
    }
  }
  linked_ = linked;
  Q_EMIT changed();
  Q_EMIT choiceChanged();
}

void StitchLook::setCut(Cut cut) {
  plane_ = planeOf(cut, cross_, plane_.pixel_mm);
  if (!linked_) movingPlane_ = planeOf(cut, movingCross_, movingPlane_.pixel_mm);
  Q_EMIT changed();
}

void StitchLook::setViewSide(int px) {
  px = std::max(40, px);
  if (px == viewSide_px_) return;
  const double factor = static_cast<double>(viewSide_px_) / px;
  viewSide_px_ = px;
  plane_.pixel_mm *= factor;
  movingPlane_.pixel_mm *= factor;
  Q_EMIT changed();
}

void StitchLook::fit() {
  if (!pair_) return;
  const auto fixed = inputs_.volume(pair_->fixed);
  const auto moving = inputs_.volume(pair_->moving);
  const Volume* any = fixed ? fixed.get() : moving.get();
  if (any == nullptr) return;
  const Grid& grid = any->grid;
  glm::dvec3 middle = middleOf(grid);
  if (fixed && moving) {
    // The middle of what both cover: where there is something to compare.
    const auto toVoxel = moving->grid.toVoxel<frame::Moving>() * transform();
    glm::dvec3 sum{0.0};
    int count = 0;
    constexpr int kSide = 16;
    for (int n = 0; n < kSide * kSide * kSide; ++n) {
      const glm::dvec3 share = glm::dvec3(n % kSide, (n / kSide) % kSide, n / kSide / kSide) / (kSide - 1.0);
      const glm::ivec3 at = glm::ivec3(glm::round(share * (glm::dvec3(grid.dims) - 1.0)));
      if (fixed->coverageAt(grid.indexOf(at.x, at.y, at.z)) == Coverage::absent) continue;
      const glm::dvec3 p = carried(grid.voxelTo<frame::Fixed>(), glm::dvec3(at));
      const glm::ivec3 other = glm::ivec3(glm::round(carried(toVoxel, p)));
      if (!moving->grid.contains(other) || moving->coverageAt(moving->grid.indexOf(other.x, other.y, other.z)) == Coverage::absent)
        continue;
      sum += p;
      ++count;
    }
    if (count > 0) middle = sum / static_cast<double>(count);
  }
  const glm::dvec3 extent = glm::dvec3(grid.dims) * grid.spacing_mm;
  const double pixel_mm = std::max({extent.x, extent.y, extent.z, 1.0}) / (0.96 * viewSide_px_);
  plane_.centre_mm = middle;
  plane_.pixel_mm = pixel_mm;
  cross_ = middle;
  movingPlane_ = moved(plane_, transform());
  if (moving) {
    movingCross_ = middleOf(moving->grid);
    movingPlane_.centre_mm = movingCross_;
  }
  Q_EMIT changed();
}

QuickAgreement StitchLook::agreement() const {
  if (!pair_) return {};
  const auto fixed = inputs_.volume(pair_->fixed);
  const auto moving = inputs_.volume(pair_->moving);
  if (!fixed || !moving) return {};
  // Cross-hairs that move ask again and again about a pose that stays.
  const auto now = transform();
  if (agreementOf_.fixed == fixed && agreementOf_.moving == moving && agreementOf_.transform == now) return agreementOf_.found;
  const glm::dvec3 extent = glm::dvec3(fixed->grid.dims) * fixed->grid.spacing_mm;
  const double step_mm = std::max(1.0, std::cbrt(extent.x * extent.y * extent.z) / 40.0);
  agreementOf_ = {fixed, moving, now, quickAgreement(*fixed, *moving, now, step_mm)};
  return agreementOf_.found;
}

}  // namespace ew::stitching
