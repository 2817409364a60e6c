#include "logic/painting.h"

#include <algorithm>

namespace ew::case_authoring {
namespace {

labelling::Brush brushFor(int label, bool onlyUnlabelled) {
  labelling::Brush brush{.label = static_cast<std::uint8_t>(label)};
  if (onlyUnlabelled) brush.over = 0;
  return brush;
}

Grid inFile(const Grid& inWorld, const Transform<frame::World, frame::File>& fileToWorld) {
  return placed(inWorld, renamed<frame::World, frame::File>(rigidInverse(fileToWorld)));
}

}  // namespace

Result<std::unique_ptr<Painting>> Painting::goOn(Volume labels, const sdk::Scanned& scanned,
                                                 const Transform<frame::World, frame::File>& fileToWorld) {
  if (!scanned.voxels)
    return failure(
        ErrorCode::badUsage,
        say<"The volume of this case stays in its file, so nothing can be painted in it; take a case whose volume fits into memory.">());
  return std::unique_ptr<Painting>(new Painting(std::move(labels), scanned.voxels, inFile(scanned.volume, fileToWorld), true));
}

Result<std::unique_ptr<Painting>> Painting::begin(const sdk::Scanned& scanned, const Transform<frame::World, frame::File>& fileToWorld) {
  Volume labels;
  if (scanned.labels) {
    labels = *scanned.labels;
    labels.grid = inFile(scanned.placedLabels, fileToWorld);
  } else {
    labels.grid = labelling::labelGridFor(inFile(scanned.volume, fileToWorld));
    labels.echo.assign(labels.grid.voxelCount(), 0);
  }
  auto begun = goOn(std::move(labels), scanned, fileToWorld);
  if (begun) (*begun)->wasKept_ = false;
  return begun;
}

Volume Painting::inWorld(const Transform<frame::World, frame::File>& fileToWorld) const {
  Volume labels = edits_.labels();
  labels.grid = placed(labels.grid, fileToWorld);
  return labels;
}

void Painting::strokeBegun(const PaintSettings& settings, int label, const std::string& what,
                           const Transform<frame::File, frame::Probe>& planeToFile, const glm::dvec2& at_mm) {
  strokeEnded();
  drawn_ = settings;
  label_ = label;
  planeToFile_ = planeToFile;
  stroke_.assign(1, at_mm);
  isDrawing_ = true;
  edits_.open(what);
  dab(at_mm, at_mm);
}

void Painting::strokeMoved(const glm::dvec2& at_mm) {
  if (!isDrawing_) return;
  const glm::dvec2 before_mm = stroke_.back();
  stroke_.push_back(at_mm);
  dab(before_mm, at_mm);
}

void Painting::dab(const glm::dvec2& from_mm, const glm::dvec2& to_mm) {
  if (drawn_.tool != PaintTool::paint && drawn_.tool != PaintTool::erase) return;
  labelling::Brush brush = brushFor(label_, drawn_.onlyUnlabelled);
  if (drawn_.tool == PaintTool::erase) brush = {.label = 0, .over = static_cast<std::uint8_t>(label_)};
  edits_.edit({}, [&](Volume& labels) {
    if (drawn_.inPlane) {
      const glm::dvec2 path[] = {from_mm, to_mm};
      const double half_mm = std::max(0.5 * drawn_.thickness_mm, labelling::thinnestHalf_mm(labels.grid));
      return labelling::paintDisc(labels, planeToFile_, path, drawn_.radius_mm, half_mm, brush);
    }
    const glm::dvec3 path[] = {carried(planeToFile_, {from_mm, 0.0}), carried(planeToFile_, {to_mm, 0.0})};
    return labelling::paintBall(labels, path, drawn_.radius_mm, brush);
  });
}

void Painting::strokeEnded() {
  if (!isDrawing_) return;
  isDrawing_ = false;
  if (drawn_.tool == PaintTool::trace && stroke_.size() >= 3) {
    traced_.push_back({planeToFile_, stroke_});
    edits_.edit({}, [&](Volume& labels) {
      const double half_mm = std::max(0.5 * drawn_.thickness_mm, labelling::thinnestHalf_mm(labels.grid));
      return labelling::fillContour(labels, planeToFile_, stroke_, half_mm, brushFor(label_, drawn_.onlyUnlabelled));
    });
  }
  edits_.close();
  stroke_.clear();
}

Result<void> Painting::fillBetween(int label, bool onlyUnlabelled, const std::string& what, Progress& progress) {
  Result<void> outcome;
  edits_.edit(what, [&](Volume& labels) -> labelling::VoxelBox {
    const auto filled = labelling::fillBetween(labels, traced_, brushFor(label, onlyUnlabelled), progress);
    if (filled) return *filled;
    outcome = passOn(filled.error());
    return {};
  });
  if (outcome) traced_.clear();
  return outcome;
}

std::function<Result<Painting::Growth>(Progress&)> Painting::growing(const glm::dvec3& seed_mm, const labelling::GrowOptions& options,
                                                                     int label, bool onlyUnlabelled) const {
  return [labels = edits_.labels(), echo = echo_, grid = echoGrid_, seed_mm, options,
          brush = brushFor(label, onlyUnlabelled)](Progress& progress) mutable -> Result<Growth> {
    auto result = labelling::growFrom(labels, *echo, grid, seed_mm, options, brush, progress);
    if (!result) return passOn(result.error());
    return Growth{std::move(labels), *result};
  };
}

void Painting::take(Growth growth, const std::string& what) {
  edits_.edit(what, [&](Volume& labels) {
    // What was painted meanwhile stays: only the voxels that grew are taken over.
    const labelling::VoxelBox& box = growth.result.changed;
    for (int k = box.first.z; k < box.end.z; ++k)
      for (int j = box.first.y; j < box.end.y; ++j) {
        const auto first = static_cast<std::ptrdiff_t>(labels.grid.indexOf(box.first.x, j, k));
        std::copy_n(growth.labels.echo.begin() + first, box.end.x - box.first.x, labels.echo.begin() + first);
      }
    return box;
  });
}

Result<void> Painting::keepLargest(int label, const std::string& what, Progress& progress) {
  Result<void> outcome;
  edits_.edit(what, [&](Volume& labels) -> labelling::VoxelBox {
    const auto kept = labelling::keepLargest(labels, static_cast<std::uint8_t>(label), progress);
    if (kept) return *kept;
    outcome = passOn(kept.error());
    return {};
  });
  return outcome;
}

Result<void> Painting::smooth(int label, const std::string& what, Progress& progress) {
  Result<void> outcome;
  edits_.edit(what, [&](Volume& labels) -> labelling::VoxelBox {
    const double sigma_mm = 1.2 * std::max({labels.grid.spacing_mm.x, labels.grid.spacing_mm.y, labels.grid.spacing_mm.z});
    const auto smoothed = labelling::smooth(labels, static_cast<std::uint8_t>(label), sigma_mm, progress);
    if (smoothed) return *smoothed;
    outcome = passOn(smoothed.error());
    return {};
  });
  return outcome;
}

}  // namespace ew::case_authoring
