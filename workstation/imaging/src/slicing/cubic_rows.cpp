#include <algorithm>
#include <array>

#include "template_line.h"

namespace ew::detail {
namespace {

/// Weights of the four neighbours at -1, 0, 1, 2 of a place `t` in [0, 1) between the middle two.
/// Source: Keys, IEEE Trans. ASSP 29(6), 1981, with a = -1/2 (third order).
std::array<float, 4> cubicWeights(float t) {
  return {((-0.5F * t + 1.0F) * t - 0.5F) * t, (1.5F * t - 2.5F) * t * t + 1.0F, ((-1.5F * t + 2.0F) * t + 0.5F) * t,
          (0.5F * t - 0.5F) * t * t};
}

}  // namespace

void cubicRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping, ImageView<std::uint8_t> out) {
  FixedPosition outermost{};
  for (std::size_t a = 0; a < 3; ++a) outermost[a] = line.dims[static_cast<int>(a)] * kOneVoxel - kHalfVoxel;
  for (int y = 0; y < out.height; ++y) {
    const FixedPosition base = line.base(firstRow + y);
    std::uint8_t* row = out.row(y);
    for (const RowSpan& within : clipping.of(y)) {
      RowSpan run = clipRow(line, scratch, base, within, {-kHalfVoxel, -kHalfVoxel, -kHalfVoxel}, outermost);
      if (run.begin == run.end) run = {within.begin, within.begin};
      std::fill(row + within.begin, row + run.begin, std::uint8_t{0});
      for (int x = run.begin; x < run.end; ++x) {
        std::array<std::array<float, 4>, 3> weights;
        std::array<std::array<std::uint64_t, 4>, 3> offsets{};
        for (std::size_t a = 0; a < 3; ++a) {
          const std::int64_t last = line.dims[static_cast<int>(a)] - 1;
          const std::int64_t position =
              std::clamp(base[a] + scratch.templatePosition[a][static_cast<std::size_t>(x)], std::int64_t{0}, last * kOneVoxel);
          const std::int64_t whole = position >> kFractionBits;
          weights[a] =
              cubicWeights(static_cast<float>(position & static_cast<std::int64_t>(kFractionMask)) / static_cast<float>(kOneVoxel));
          for (std::size_t n = 0; n < 4; ++n)
            offsets[a][n] =
                static_cast<std::uint64_t>(std::clamp(whole - 1 + static_cast<std::int64_t>(n), std::int64_t{0}, last)) * line.stride[a];
        }
        float sum = 0.0F;
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t j = 0; j < 4; ++j) {
            const std::uint8_t* at = line.voxels + offsets[2][k] + offsets[1][j];
            float along = 0.0F;
            for (std::size_t i = 0; i < 4; ++i) along += weights[0][i] * static_cast<float>(at[offsets[0][i]]);
            sum += weights[2][k] * weights[1][j] * along;
          }
        row[x] = static_cast<std::uint8_t>(static_cast<std::int32_t>(std::clamp(sum, 0.0F, 255.0F) + 0.5F));
      }
      std::fill(row + run.end, row + within.end, std::uint8_t{0});
    }
  }
}

}  // namespace ew::detail
