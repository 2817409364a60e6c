#include "ew/acquisition/reconstruct.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <new>

#include "clip_spans.h"
#include "ew/acquisition/fill_holes.h"
#include "ew/core/elapsed.h"
#include "ew/core/figures.h"
#include "ew/core/large_pages.h"
#include "ew/core/numbers.h"
#include "fill_sweep.h"
#include "paste.h"

namespace ew {
namespace {

std::string gibibytes(std::uint64_t bytes) {
  const double gib = static_cast<double>(bytes) / static_cast<double>(1ull << 30);
  return textOf(std::ceil(gib * 10.0) / 10.0) + " GiB";
}

/// A grid before anybody knows whether it can be had; sizes are doubles because anything may come out.
struct Extent {
  glm::dvec3 origin_mm{0.0};
  glm::dvec3 samples{0.0};
};

std::string sizeOf(const Extent& extent) {
  return textOf(extent.samples.x) + " x " + textOf(extent.samples.y) + " x " + textOf(extent.samples.z);
}

Result<void> checkMatrix(const glm::dmat4& m, std::size_t frame) {
  const auto refuse = [&](const Message& sentence) {
    return failure(ErrorCode::badField, sentence, {{"field", "imageToWorld"}, {"frame", std::to_string(frame)}});
  };
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row]))
        return refuse(say<"The matrix of frame %1 from image to world contains a value that is not a finite number; check the calibration "
                          "and the pose of this frame.">(frame));
  // Chains of inverted matrices leave traces of rounding here.
  constexpr double kTolerance = 1e-9;
  for (int column = 0; column < 4; ++column)
    if (std::abs(m[column][3] - (column == 3 ? 1.0 : 0.0)) > kTolerance)
      return refuse(say<"The matrix of frame %1 from image to world does not end with the row 0 0 0 1; check the calibration and the pose "
                        "of this frame.">(frame));
  const glm::dvec3 x = glm::dvec3(m[0]), y = glm::dvec3(m[1]);
  const double lengths = glm::length(x) * glm::length(y);
  // Also false when the lengths overflow or vanish.
  if (!(lengths > 0.0 && std::isfinite(lengths) && glm::length(glm::cross(x, y)) > 1e-9 * lengths))
    return refuse(say<"The matrix of frame %1 from image to world maps the image onto a line or a point; check the calibration and the "
                      "pose of this frame.">(frame));
  return {};
}

Result<void> checkFrames(std::span<const TrackedFrame> frames) {
  if (frames.empty())
    return failure(ErrorCode::noValidPose, say<"The sweep has no frame with a usable pose; check the tracking of the recording.">());
  const auto& first = frames.front().pixels;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const auto& pixels = frames[n].pixels;
    if (pixels.width < 1 || pixels.height < 1 || pixels.data == nullptr)
      return failure(ErrorCode::badField, say<"Frame %1 has no pixels; reconstruct a sweep with images.">(n),
                     {{"field", "pixels"}, {"frame", std::to_string(n)}});
    if (pixels.width != first.width || pixels.height != first.height)
      return failure(ErrorCode::badField,
                     say<"Frame %1 has %2 x %3 pixels and frame 0 has %4 x %5; reconstruct frames of one size at a time.">(
                         n, pixels.width, pixels.height, first.width, first.height),
                     {{"field", "pixels"}, {"frame", std::to_string(n)}});
    const auto& weights = frames[n].weights;
    if (weights.data != nullptr && (weights.width != first.width || weights.height != first.height))
      return failure(ErrorCode::badField,
                     say<"The weights of frame %1 have %2 x %3 values for %4 x %5 pixels; give one weight for each pixel.">(
                         n, weights.width, weights.height, first.width, first.height),
                     {{"field", "weights"}, {"frame", std::to_string(n)}});
    if (const auto checked = checkMatrix(frames[n].imageToWorld.matrix, n); !checked) return passOn(checked.error());
  }
  return {};
}

Result<void> checkOptions(const ReconstructOptions& options) {
  if (!(options.spacing_mm > 0.0) || !std::isfinite(options.spacing_mm))
    return failure(ErrorCode::badField,
                   say<"A voxel spacing of %1 mm cannot be used; give a positive number of millimetres.">(figureText(options.spacing_mm)),
                   {{"field", "spacing"}});
  if (options.threads < 0)
    return failure(ErrorCode::badField, say<"The number of threads is negative; give 0 for all cores or a positive number.">(),
                   {{"field", "threads"}});
  if (!(options.fillReach_mm >= 0.0) || !std::isfinite(options.fillReach_mm))
    return failure(ErrorCode::badField,
                   say<"A hole filling reach of %1 mm cannot be used; give 0 mm or more.">(textOf(options.fillReach_mm)),
                   {{"field", "fill reach"}});
  if (options.keepWeights && options.compounding != Compounding::mean && options.compounding != Compounding::weighted)
    return failure(ErrorCode::badField, say<"Only the mean has weights; ask for the mean or do not ask for weights.">(),
                   {{"field", "weights"}});
  return {};
}

/// Smallest and largest coordinates of the clip rectangle over all frames.
Bounds boundsOf(std::span<const TrackedFrame> frames, const ClipRectangle& rectangle) {
  glm::dvec3 lowest_mm(std::numeric_limits<double>::infinity()), highest_mm(-std::numeric_limits<double>::infinity());
  for (const TrackedFrame& frame : frames)
    for (const double x : {rectangle.left, rectangle.right})
      for (const double y : {rectangle.top, rectangle.bottom}) {
        const glm::dvec3 corner_mm = (frame.imageToWorld * Point<frame::Image>{{x, y, 0.0}}).at;
        lowest_mm = glm::min(lowest_mm, corner_mm);
        highest_mm = glm::max(highest_mm, corner_mm);
      }
  return {lowest_mm, highest_mm};
}

/// Smallest corner of the clip rectangle over all frames, and samples per axis = round((largest - smallest) / spacing) + 1.
Extent extentOf(std::span<const TrackedFrame> frames, const ClipRectangle& rectangle, double spacing_mm) {
  const Bounds bounds = boundsOf(frames, rectangle);
  return {bounds.lowest_mm, glm::floor((bounds.highest_mm - bounds.lowest_mm) / spacing_mm + 0.5) + 1.0};
}

Result<Grid> checkedGrid(const Extent& extent, const ReconstructOptions& options) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(extent.origin_mm[axis]) || !(extent.samples[axis] <= kMaxPasteDim))
      return failure(ErrorCode::tooLarge,
                     say<"The volume would have %1 voxels, more than %2 along one axis; use a coarser spacing, or check the calibration "
                         "and poses for a wrong scale.">(sizeOf(extent), kMaxPasteDim),
                     {{"dims", sizeOf(extent)}});
  Grid grid;
  grid.dims = glm::ivec3(extent.samples);
  grid.spacing_mm = glm::dvec3(options.spacing_mm);
  grid.origin_mm = extent.origin_mm;
  // Above 2^40 voxels the byte count below might not fit its type.
  const double voxels = extent.samples.x * extent.samples.y * extent.samples.z;
  if (voxels > std::ldexp(1.0, 40))
    return failure(ErrorCode::tooLarge,
                   say<"The volume would have %1 voxels and need more than 2048 GiB of memory; use a coarser spacing.">(sizeOf(extent)),
                   {{"dims", sizeOf(extent)}});
  const std::uint64_t bytes = forecastBytes(grid, options);
  if (bytes > options.maxBytes)
    return failure(
        ErrorCode::tooLarge,
        say<"The volume would have %1 voxels and need %2 of memory, more than the %3 that a volume may take; use a coarser spacing.">(
            sizeOf(extent), gibibytes(bytes), gibibytes(options.maxBytes)),
        {{"dims", sizeOf(extent)}, {"bytes", std::to_string(bytes)}, {"maxBytes", std::to_string(options.maxBytes)}});
  return grid;
}

/// The grid as it is, when every clipped pixel of the frames falls into it.
Result<Grid> checkedOnto(const Grid& grid, std::span<const TrackedFrame> frames, const ReconstructOptions& options) {
  if (const auto smallest = gridFor(frames, options); !smallest) return passOn(smallest.error());
  if (const auto checked = checkGrid(grid); !checked) return passOn(checked.error());
  const auto rectangle = clipRectangle(options.clip, frames.front().pixels.width, frames.front().pixels.height);
  const Bounds bounds = boundsOf(frames, *rectangle);
  const glm::dvec3 lowest_voxel = (bounds.lowest_mm - grid.origin_mm) / options.spacing_mm;
  const glm::dvec3 highest_voxel = (bounds.highest_mm - grid.origin_mm) / options.spacing_mm;
  // gridFor rounds the number of samples, so pixels reach up to half a voxel beyond its last centre.
  constexpr double kRounding_voxel = 1e-6;
  const bool holds = glm::all(glm::greaterThanEqual(lowest_voxel, glm::dvec3(-kRounding_voxel))) &&
                     glm::all(glm::lessThan(highest_voxel, glm::dvec3(grid.dims) - 0.5 + kRounding_voxel));
  if (grid.spacing_mm != glm::dvec3(options.spacing_mm) || grid.directions != glm::dmat3(1.0) || !holds)
    return failure(ErrorCode::badField,
                   say<"The grid asked for does not hold every frame at a spacing of %1 mm; use the grid of all frames together.">(
                       figureText(options.spacing_mm)),
                   {{"field", "grid"}});
  return checkedGrid({grid.origin_mm, glm::dvec3(grid.dims)}, options);
}

constexpr std::size_t kMostSources = 65534;

}  // namespace

std::uint64_t forecastBytes(const Grid& grid, const ReconstructOptions& options) {
  const std::uint64_t perVoxel = 2 + (options.keepWeights ? sizeof(float) : 0) + (options.keepSource ? sizeof(std::uint16_t) : 0);
  std::uint64_t most = std::max(pasteScratchBytes(grid, options), forecastFillBytes(grid, {options.fillReach_mm, options.threads}));
  const bool along = options.fillReach_mm > 0.0 && options.fillMethod == FillMethod::sweep;
  if (along || options.interpolation == Interpolation::centred) most = std::max(most, forecastSweepBytes(grid, options));
  return grid.voxelCount() * perVoxel + most;
}

Result<Grid> gridFor(std::span<const TrackedFrame> frames, const ReconstructOptions& options) {
  if (const auto checked = checkFrames(frames); !checked) return passOn(checked.error());
  if (const auto checked = checkOptions(options); !checked) return passOn(checked.error());
  if (options.keepSource && frames.size() > kMostSources)
    return failure(ErrorCode::badField,
                   say<"Sources can be kept for at most %1 frames, the sweep has %2; reconstruct it in parts or without sources.">(
                       kMostSources, frames.size()),
                   {{"field", "source"}});
  const auto rectangle = clipRectangle(options.clip, frames.front().pixels.width, frames.front().pixels.height);
  if (!rectangle) return passOn(rectangle.error());
  auto grid = checkedGrid(extentOf(frames, *rectangle, options.spacing_mm), options);
  if (!grid) return passOn(grid.error());
  if (const auto checked = checkFillReach(*grid, options.fillReach_mm); !checked) return passOn(checked.error());
  return grid;
}

Result<ReconstructResult> reconstruct(std::span<const TrackedFrame> frames, const ReconstructOptions& options, Progress& progress) {
  const auto grid = gridFor(frames, options);
  if (!grid) return passOn(grid.error());
  return reconstructOnto(*grid, frames, options, progress);
}

Result<ReconstructResult> reconstructOnto(const Grid& asked, std::span<const TrackedFrame> frames, const ReconstructOptions& options,
                                          Progress& progress) {
  const auto grid = checkedOnto(asked, frames, options);
  if (!grid) return passOn(grid.error());
  const auto clip = ClipSpans::of(options.clip, frames.front().pixels.width, frames.front().pixels.height);
  if (!clip) return passOn(clip.error());

  const double filledFrom = options.fillReach_mm > 0.0 ? 0.7 : 1.0;
  const auto started = std::chrono::steady_clock::now();
  ReconstructResult result;
  try {
    result.volume.grid = *grid;
    const std::size_t voxels = grid->voxelCount();
    if (!growInLargePages(result.volume.echo, voxels, progress) || !growInLargePages(result.volume.coverage, voxels, progress) ||
        (options.keepWeights && !growInLargePages(result.weights, voxels, progress)) ||
        (options.keepSource && !growInLargePages(result.source, voxels, progress)))
      return failure(ErrorCode::cancelled, say<"The reconstruction was stopped before it was complete.">());
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge,
                   say<"There is not enough memory for a volume of %1; use a coarser spacing.">(gibibytes(forecastBytes(*grid, options))));
  }
  PartOfProgress pasting(progress, 0.0, filledFrom);
  const PasteTarget pasted{*grid, result.volume.echo.data(), result.volume.coverage.data(),
                           options.keepWeights ? result.weights.data() : nullptr, options.keepSource ? result.source.data() : nullptr};
  const auto measured = pasteFrames(frames, *clip, options, pasted, pasting);
  if (!measured) return passOn(measured.error());
  const SweepTarget target{*grid, pasted.echo, pasted.coverage, pasted.source};
  if (options.interpolation == Interpolation::centred &&
      (options.compounding == Compounding::mean || options.compounding == Compounding::weighted)) {
    PartOfProgress centring(progress, 0.5 * filledFrom, filledFrom);
    if (const auto centred = centreMeasured(frames, *clip, options, target, centring); !centred) return passOn(centred.error());
  }
  result.measuredVoxels = *measured;
  result.framesUsed = frames.size();
  result.pixelsPasted = frames.size() * clip->pixelCount();
  result.pasteSeconds = secondsSince(started);

  if (options.fillReach_mm > 0.0) {
    const auto fillStarted = std::chrono::steady_clock::now();
    PartOfProgress along(progress, filledFrom, filledFrom + 0.5 * (1.0 - filledFrom)),
        bridging(progress, filledFrom + 0.5 * (1.0 - filledFrom), 1.0);
    if (options.fillMethod == FillMethod::sweep) {
      const auto filled = fillBetweenFrames(frames, *clip, options, target, along);
      if (!filled) return passOn(filled.error());
      result.interpolatedVoxels = *filled;
    }
    auto filled = fillHoles(std::move(result.volume), {options.fillReach_mm, options.threads, result.source}, bridging);
    if (!filled) return passOn(filled.error());
    result.volume = std::move(filled->volume);
    result.interpolatedVoxels += filled->filledVoxels;
    result.fillSeconds = secondsSince(fillStarted);
  }
  return result;
}

FrameProjection projectionOnto(const Transform<frame::World, frame::Image>& imageToWorld, const Point<frame::World>& at) {
  const glm::dmat4& m = imageToWorld.matrix;
  const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1])));
  const glm::dvec3 image = glm::inverse(glm::dmat3(glm::dvec3(m[0]), glm::dvec3(m[1]), normal)) * (at.at - glm::dvec3(m[3]));
  return {{image.x, image.y}, std::abs(image.z)};
}

std::optional<SourceFrame> sourceFrameAt(const Grid& grid, std::span<const std::uint16_t> source, std::span<const TrackedFrame> frames,
                                         const Point<frame::World>& at) {
  EW_EXPECTS(source.size() == grid.voxelCount());
  const glm::dvec3 voxel = glm::floor((grid.worldToVoxel() * at).at + 0.5);
  // Also false for what is not a number.
  for (int axis = 0; axis < 3; ++axis)
    if (!(voxel[axis] >= 0.0 && voxel[axis] < grid.dims[axis])) return std::nullopt;
  const std::uint16_t found = source[grid.indexOf(static_cast<int>(voxel.x), static_cast<int>(voxel.y), static_cast<int>(voxel.z))];
  if (found == 0 || found > frames.size()) return std::nullopt;
  const FrameProjection projection = projectionOnto(frames[found - 1u].imageToWorld, at);
  return SourceFrame{found - 1u, projection.at_px, projection.distance_mm};
}

}  // namespace ew
