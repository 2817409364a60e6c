#include "ew/stitching/stitch.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "ew/stitching/distance.h"

namespace ew::stitching {
namespace {

constexpr double kOnLattice_voxel = 1e-6;
/// Keeps the rounding of a tie (10.5) from depending on the order in which the inputs were added up.
constexpr double kTie = 1e-7;

/// One input as the blend reads it.
struct Source {
  const Volume* volume = nullptr;
  const std::vector<float>* distance_mm = nullptr;  ///< null: every covered voxel weighs the same
  glm::dmat4 gridToVoxel{1.0};                      ///< voxel of the common grid to voxel of this input
  double interpolatedWeight = 1.0;
  double featherWidth_mm = 0.0;
};

struct Sample {
  double level = 0.0;
  double weight = 0.0;  ///< 0: nothing there
  bool measured = false;
};

/// @param at voxel coordinates inside the input's grid (0 .. dims - 1)
Sample sampleAt(const Source& source, glm::dvec3 at) {
  const Grid& grid = source.volume->grid;
  glm::ivec3 low{0};
  glm::dvec3 part{0.0};
  glm::ivec3 nearest{0};
  for (int axis = 0; axis < 3; ++axis) {
    const double whole = std::round(at[axis]);
    // Rounding errors of the transform must not turn a voxel's own centre into a mix of two.
    const double on = std::abs(at[axis] - whole) < kOnLattice_voxel ? whole : at[axis];
    const double bounded = std::clamp(on, 0.0, static_cast<double>(grid.dims[axis] - 1));
    low[axis] = std::min(static_cast<int>(bounded), std::max(grid.dims[axis] - 2, 0));
    part[axis] = bounded - low[axis];
    nearest[axis] = static_cast<int>(std::floor(bounded + 0.5));
  }
  const Coverage own = source.volume->coverageAt(grid.indexOf(nearest.x, nearest.y, nearest.z));
  // The covered region neither grows nor shrinks: its nearest voxel decides whether a point belongs to it.
  if (own == Coverage::absent) return {};

  double level = 0.0;
  double present = 0.0;
  double quality = 0.0;
  double distance_mm = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const double share =
        (step.x != 0 ? part.x : 1.0 - part.x) * (step.y != 0 ? part.y : 1.0 - part.y) * (step.z != 0 ? part.z : 1.0 - part.z);
    if (share <= 0.0) continue;
    const std::size_t index = grid.indexOf(low.x + step.x, low.y + step.y, low.z + step.z);
    const Coverage coverage = source.volume->coverageAt(index);
    if (coverage == Coverage::absent) continue;
    level += share * source.volume->echo[index];
    present += share;
    quality += share * (coverage == Coverage::measured ? 1.0 : source.interpolatedWeight);
    if (source.distance_mm != nullptr) distance_mm += share * static_cast<double>((*source.distance_mm)[index]);
  }
  Sample sample;
  sample.level = level / present;  // the nearest voxel is covered and has at least an eighth of the share
  sample.weight = quality / present;
  if (source.distance_mm != nullptr) sample.weight *= std::min(1.0, distance_mm / present / source.featherWidth_mm);
  sample.measured = own == Coverage::measured;
  return sample;
}

/// The samples [begin, end) of a row at start + i * step that lie inside a grid of `dims`; clipped once per row, never per voxel.
std::pair<int, int> insideOf(const glm::dvec3& start, const glm::dvec3& step, const glm::ivec3& dims, int length) {
  double first = 0.0;
  double last = length - 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -kOnLattice_voxel - start[axis];
    const double high = dims[axis] - 1.0 + kOnLattice_voxel - start[axis];
    if (std::abs(step[axis]) < 1e-15) {
      if (low > 0.0 || high < 0.0) return {0, 0};
      continue;
    }
    const auto [enter, leave] = std::minmax({low / step[axis], high / step[axis]});
    first = std::max(first, enter);
    last = std::min(last, leave);
  }
  if (!(first <= last)) return {0, 0};
  return {static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(last)) + 1};
}

/// Sums over one slice of the result; added up in the order of the slices, so that no thread count changes them.
struct SliceCounts {
  std::size_t covered = 0;
  std::size_t overlapping = 0;
  double squaredSpread = 0.0;
  std::vector<Contribution> contributions;
};

struct RowSums {
  std::vector<double> weight;
  std::vector<double> mean;
  std::vector<double> spread;  ///< sum of weight times squared distance from the mean
  std::vector<double> heaviest;
  std::vector<int> inputs;
  std::vector<bool> measured;
  explicit RowSums(std::size_t n) : weight(n), mean(n), spread(n), heaviest(n), inputs(n), measured(n) {}
  void clear() {
    for (auto* sums : {&weight, &mean, &spread, &heaviest}) std::fill(sums->begin(), sums->end(), 0.0);
    std::fill(inputs.begin(), inputs.end(), 0);
    std::fill(measured.begin(), measured.end(), false);
  }
};

void blendRow(const std::vector<Source>& sources, int j, int k, RowSums& row, StitchResult& result, SliceCounts& counts) {
  const Grid& grid = result.volume.grid;
  const std::size_t rowStart = grid.indexOf(0, j, k);
  row.clear();
  for (std::size_t n = 0; n < sources.size(); ++n) {
    const Source& source = sources[n];
    const glm::dvec3 start(source.gridToVoxel * glm::dvec4(0.0, j, k, 1.0));
    const glm::dvec3 step(source.gridToVoxel[0]);
    const auto [begin, end] = insideOf(start, step, source.volume->grid.dims, grid.dims.x);
    for (int i = begin; i < end; ++i) {
      const Sample sample = sampleAt(source, start + static_cast<double>(i) * step);
      if (sample.weight <= 0.0) continue;
      const auto at = static_cast<std::size_t>(i);
      // West's running mean: a sum of squares would lose the spread of inputs that nearly agree.
      row.weight[at] += sample.weight;
      const double beside = sample.level - row.mean[at];
      row.mean[at] += beside * (sample.weight / row.weight[at]);  // the first share is exactly 1
      row.spread[at] += sample.weight * beside * (sample.level - row.mean[at]);
      ++row.inputs[at];
      if (sample.measured) row.measured[at] = true;
      ++counts.contributions[n].voxels;
      if (sample.weight > row.heaviest[at]) {
        row.heaviest[at] = sample.weight;
        result.source[rowStart + at] = static_cast<std::uint8_t>(n + 1);
      }
    }
  }
  for (std::size_t at = 0; at < row.inputs.size(); ++at) {
    if (row.inputs[at] == 0) continue;
    result.volume.echo[rowStart + at] = static_cast<std::uint8_t>(std::clamp(std::floor(row.mean[at] + 0.5 + kTie), 0.0, 255.0));
    result.volume.coverage[rowStart + at] = static_cast<std::uint8_t>(row.measured[at] ? Coverage::measured : Coverage::interpolated);
    ++counts.contributions[result.source[rowStart + at] - 1u].dominantVoxels;
    ++counts.covered;
    if (row.inputs[at] < 2) continue;
    ++counts.overlapping;
    counts.squaredSpread += std::max(0.0, row.spread[at] / row.weight[at]);
  }
}

/// Without coverage the black outside of a fan counts as seen, and darkens what another volume shows there.
void noteMissingCoverage(std::span<const PlacedView> inputs, StitchResult& result) {
  constexpr double suspicious = 0.05;
  if (inputs.size() < 2) return;
  for (const auto& input : inputs) {
    if (!input.volume->coverage.empty()) continue;
    const auto black = std::count(input.volume->echo.begin(), input.volume->echo.end(), std::uint8_t{0});
    if (static_cast<double>(black) > suspicious * static_cast<double>(input.volume->echo.size()))
      result.notes.push_back("Volume '" + input.name +
                             "' has no coverage, so its black voxels count as measured and darken the blend; give its coverage file if "
                             "there is one.");
  }
}

tl::unexpected<Error> cancelled() { return failure(ErrorCode::cancelled, "The stitching was cancelled."); }

void addUp(const std::vector<SliceCounts>& slices, StitchResult& result) {
  std::size_t covered = 0;
  std::size_t overlapping = 0;
  double squaredSpread = 0.0;
  for (const auto& slice : slices) {
    covered += slice.covered;
    overlapping += slice.overlapping;
    squaredSpread += slice.squaredSpread;
    for (std::size_t n = 0; n < slice.contributions.size(); ++n) {
      result.contributions[n].voxels += slice.contributions[n].voxels;
      result.contributions[n].dominantVoxels += slice.contributions[n].dominantVoxels;
    }
  }
  if (covered > 0) result.overlapShare = static_cast<double>(overlapping) / static_cast<double>(covered);
  if (overlapping > 0) result.disagreementRms = std::sqrt(squaredSpread / static_cast<double>(overlapping));
  for (const auto& each : result.contributions)
    if (each.voxels == 0) result.notes.push_back("Volume '" + each.name + "' contributed nothing: none of its voxels are covered.");
  if (result.contributions.size() > 1 && overlapping == 0)
    result.notes.emplace_back("The volumes do not overlap anywhere, so nothing was blended; check their places if they should.");
}

}  // namespace

Result<StitchResult> stitch(std::span<const PlacedView> inputs, const StitchOptions& options, Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  auto forecast = forecastStitch(inputs, options);
  if (!forecast) return passOn(forecast.error());
  for ([[maybe_unused]] const auto& [volume, toWorld, name] : inputs) {
    EW_EXPECTS(volume->echo.size() == volume->grid.voxelCount());
    EW_EXPECTS(volume->coverage.empty() || volume->coverage.size() == volume->grid.voxelCount());
  }

  const bool feathers = options.featherWidth_mm > 0.0;
  std::vector<std::vector<float>> distances_mm(inputs.size());
  std::vector<Source> sources(inputs.size());
  StitchResult result;
  for (std::size_t n = 0; n < inputs.size(); ++n) {
    if (feathers) {
      PartOfProgress part(progress, 0.3 * static_cast<double>(n) / static_cast<double>(inputs.size()),
                          0.3 * static_cast<double>(n + 1) / static_cast<double>(inputs.size()));
      auto distance = distanceFromBorder_mm(*inputs[n].volume, options.featherWidth_mm, options.threads, part);
      if (!distance) return passOn(distance.error());
      distances_mm[n] = std::move(*distance);
    }
    const auto worldToVoxel = placed(inputs[n].volume->grid, inputs[n].toWorld).worldToVoxel();
    sources[n] = {inputs[n].volume, feathers ? &distances_mm[n] : nullptr, (worldToVoxel * forecast->grid.voxelToWorld()).matrix,
                  options.interpolatedWeight, options.featherWidth_mm};
    result.contributions.push_back({inputs[n].name, 0, 0});
  }

  result.volume.grid = forecast->grid;
  const std::size_t voxels = forecast->grid.voxelCount();
  result.volume.echo.assign(voxels, 0);
  result.volume.coverage.assign(voxels, 0);
  result.source.assign(voxels, 0);
  std::vector<SliceCounts> slices(static_cast<std::size_t>(forecast->grid.dims.z));
  PartOfProgress part(progress, 0.3, 1.0);
  const bool whole = forEachTask(forecast->grid.dims.z, options.threads, part, "Blending", [&](int k) {
    SliceCounts& counts = slices[static_cast<std::size_t>(k)];
    counts.contributions.resize(inputs.size());
    RowSums row(static_cast<std::size_t>(forecast->grid.dims.x));
    for (int j = 0; j < forecast->grid.dims.y && !progress.cancelRequested(); ++j) blendRow(sources, j, k, row, result, counts);
  });
  if (!whole || progress.cancelRequested()) return cancelled();
  addUp(slices, result);
  noteMissingCoverage(inputs, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

Result<StitchResult> stitch(std::span<const PlacedVolume> inputs, const StitchOptions& options, Progress& progress) {
  std::vector<PlacedView> views;
  for (const auto& input : inputs) views.push_back({&input.volume, input.toWorld, input.name});
  return stitch(views, options, progress);
}

}  // namespace ew::stitching
