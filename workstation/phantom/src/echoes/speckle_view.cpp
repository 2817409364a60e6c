#include "ew/phantom/speckle_view.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "ew/phantom/speckle.h"

namespace ew {
namespace {

constexpr std::uint64_t kScene = 77;  // seed of what is the same in all views
constexpr int kSlices = 16;

/// 1 inside, 0 outside, over 1 mm.
double within(double depth_mm) { return std::clamp(0.5 + depth_mm, 0.0, 1.0); }

}  // namespace

double speckledScene_db(const glm::dvec3& p) {
  double db = kEvenScene_db + 4.0 * valueNoise(kScene, p / 22.0) + 2.0 * valueNoise(kScene + 1, p / 9.0);
  const auto blend = [&](double share, double to_db) { db += share * (to_db - db); };
  // An organ of which several views show a part, brighter and finer.
  const glm::dvec3 fromOrgan = (p - glm::dvec3(45.0, 38.0, 26.0)) / glm::dvec3(34.0, 18.0, 20.0);
  blend(within(18.0 * (1.0 - glm::length(fromOrgan))), -17.0 + 2.0 * valueNoise(kScene + 2, p / 6.0));
  // Vessels along three directions.
  const auto tube = [&](const glm::dvec2& off, double radius_mm) { blend(within(radius_mm - glm::length(off)), -46.0); };
  tube({p.y - 40.0 - 4.0 * std::sin(p.x / 14.0), p.z - 22.0}, 3.0);
  tube({p.x - 30.0 - 3.0 * std::sin(p.z / 9.0), p.y - 30.0}, 2.5);
  tube({p.x - 62.0, p.z - 34.0 + 0.2 * p.y}, 2.0);
  // A bright sheet, curved, through all views.
  blend(within(0.9 - std::abs(p.y - 52.0 - 3.0 * std::sin(p.x / 20.0) - 2.0 * std::cos(p.z / 13.0))), -6.0);
  return db;
}

SpeckleView speckledView(const SpeckleViewRecipe& recipe, int threads) {
  EW_EXPECTS(recipe.spacing_mm > 0.0 && recipe.dims.x > 0 && recipe.dims.y > 0 && recipe.dims.z > 0);
  SpeckleView view;
  Grid& grid = view.volume.grid;
  grid.dims = recipe.dims;
  grid.spacing_mm = glm::dvec3(recipe.spacing_mm);
  grid.origin_mm = recipe.origin_mm;
  view.volume.echo.resize(grid.voxelCount());
  view.confidence.assign(grid.voxelCount(), 255);
  const glm::ivec3 lattice(glm::round(recipe.origin_mm / recipe.spacing_mm));  // where this box lies in the speckle of its frame
  const Decibel decibel;
  const int slabs = (grid.dims.z + kSlices - 1) / kSlices;
  forEachTask(slabs, threads, noProgress(), say<"Drawing views">(), [&](int slab) {
    const int from = slab * kSlices;
    const int slices = std::min(kSlices, grid.dims.z - from);
    SpeckleScratch scratch;
    std::vector<float> power;
    specklePower(recipe.speckle, lattice + glm::ivec3(0, 0, from), {grid.dims.x, grid.dims.y, slices}, scratch, power);
    std::size_t at = grid.indexOf(0, 0, from);
    std::size_t n = 0;
    for (int k = from; k < from + slices; ++k)
      for (int j = 0; j < grid.dims.y; ++j) {
        const double down = grid.dims.y > 1 ? 2.0 * j / (grid.dims.y - 1.0) - 1.0 : 0.0;
        const double gain_db = recipe.gain_db + recipe.depthGain_db * down;
        for (int i = 0; i < grid.dims.x; ++i, ++at, ++n) {
          const glm::dvec3 own_mm = recipe.origin_mm + recipe.spacing_mm * glm::dvec3(i, j, k);
          double db = gain_db + static_cast<double>(decibel.of(power[n]));
          db += recipe.scene ? speckledScene_db(carried(recipe.toWorld, own_mm)) : kEvenScene_db;
          if (recipe.shadow) {
            const auto& shadow = *recipe.shadow;
            const double lost = within(std::min({own_mm.x - shadow.from_mm, shadow.to_mm - own_mm.x, own_mm.y - shadow.below_mm}));
            db -= lost * shadow.loss_db;
            view.confidence[at] = static_cast<std::uint8_t>(255.0 * (1.0 - lost) + 0.5);
          }
          view.volume.echo[at] = static_cast<std::uint8_t>(std::clamp(255.0 * (1.0 + db / kSpeckledRange_db) + 0.5, 0.0, 255.0));
        }
      }
  });
  return view;
}

}  // namespace ew
