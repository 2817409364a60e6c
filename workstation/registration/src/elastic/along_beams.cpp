#include "elastic/along_beams.h"

#include <algorithm>

#include "comparable.h"
#include "streaks.h"

namespace ew::registration {
namespace {

constexpr double kBetter = 0.1;  // by which the correlation must rise

ComparableImage imageOf(const Input& side, const LevelImage& level) {
  ComparableImage image;
  image.grid = side.volume->grid;
  image.grid.dims = level.dims;
  image.grid.spacing_mm = level.spacing_mm;
  image.grid.origin_mm += image.grid.directions * level.first_mm;
  image.value.resize(image.grid.voxelCount());
  image.weight.assign(image.grid.voxelCount(), 255);
  for (int k = 0; k < level.dims.z; ++k) {
    for (int j = 0; j < level.dims.y; ++j) {
      const std::size_t from = level.rowOf(j, k), to = image.grid.indexOf(0, j, k);
      for (std::size_t i = 0; i < static_cast<std::size_t>(level.dims.x); ++i) {
        image.value[to + i] = level.values[from + i];
        if (!level.weights.empty() && level.weights[from + i] <= 0.0F) image.weight[to + i] = 0;
      }
    }
  }
  return image;
}

std::vector<Beams> candidatesOf(const Input& side, const LevelImage& level, int threads, Progress& progress) {
  if (side.beams) return {*side.beams};
  std::vector<Beams> candidates;
  for (const glm::dvec3& found : findStreaks(imageOf(side, level), threads, progress)) candidates.push_back({found});
  return candidates;
}

std::optional<double> correlationOf(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform,
                                    const NodeGrid& nodes, int threads, Progress& progress) {
  LevelPair pair(fixed, moving, transform, nodes, threads);
  PairSums sums;
  if (!pair.warp(NodeValues(4 * nodes.count(), 0.0F), progress) || !pair.assemble({}, nullptr, sums, progress)) return {};
  return sums.correlation();
}

}  // namespace

std::optional<BeamPair> beamsToTakeOut(const Input& fixedInput, const Input& movingInput,
                                       const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const AxesTransform& transform,
                                       const NodeGrid& nodes, const MakeLevels& make, int threads, Progress& progress, LevelImage& fixed,
                                       LevelImage& moving) {
  const std::vector<Beams> ofFixed = candidatesOf(fixedInput, fixed, threads, progress);
  const std::vector<Beams> ofMoving = candidatesOf(movingInput, moving, threads, progress);
  std::vector<BeamPair> ways;
  for (const Beams& f : ofFixed) {
    for (const Beams& m : ofMoving) ways.push_back({f, m});
  }
  // A direction that one side alone shows may be the other's as well.
  const glm::dmat3 turn(fixedToMoving.matrix);
  if (!movingInput.beams) {
    for (const Beams& f : ofFixed) ways.push_back({f, {turn * f.direction}});
  }
  if (!fixedInput.beams) {
    for (const Beams& m : ofMoving) ways.push_back({{glm::transpose(turn) * m.direction}, m});
  }
  if (ways.empty()) return {};
  const auto asTheyAre = correlationOf(fixed, moving, transform, nodes, threads, progress);
  if (!asTheyAre) return {};
  double best = std::max(*asTheyAre, 0.0) + kBetter;
  std::optional<BeamPair> chosen;
  for (const BeamPair& way : ways) {
    LevelImage f, m;
    if (!make(&way, f, m)) return {};
    const auto correlation = correlationOf(f, m, transform, nodes, threads, progress);
    if (!correlation) return {};
    if (*correlation <= best) continue;
    best = *correlation;
    chosen = way;
    fixed = std::move(f);
    moving = std::move(m);
  }
  return chosen;
}

}  // namespace ew::registration
