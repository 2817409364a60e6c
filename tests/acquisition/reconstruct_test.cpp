#include "ew/acquisition/reconstruct.h"

#include <gtest/gtest.h>

#include "acquisition/sweeps.h"

namespace ew {
namespace {

using sweeps::imageOf;
using sweeps::matrixOf;
using sweeps::stack;
using sweeps::Sweep;

ReconstructResult made(const Sweep& sweep, const ReconstructOptions& options) {
  auto result = reconstruct(sweep.frames, options, noProgress());
  if (!result) {
    ADD_FAILURE() << result.error();
    return {};
  }
  return std::move(*result);
}

constexpr Interpolation kInterpolations[] = {Interpolation::nearest, Interpolation::linear};
constexpr Compounding kCompoundings[] = {Compounding::mean, Compounding::maximum, Compounding::latest};

TEST(Reconstruct, PutsEveryPixelOfAnAlignedStackIntoItsOwnVoxel) {
  const auto value = [](int x, int y, int z) { return (17 * x + 31 * y + 57 * z) % 256; };
  const Sweep sweep = stack(37, 23, 11, 1.0, value);
  for (const Interpolation interpolation : kInterpolations)
    for (const Compounding compounding : kCompoundings) {
      const ReconstructResult result = made(sweep, {.spacing_mm = 1.0, .interpolation = interpolation, .compounding = compounding});
      ASSERT_EQ(result.volume.grid.dims, glm::ivec3(37, 23, 11));
      EXPECT_EQ(result.volume.grid.origin_mm, glm::dvec3(0.0));
      EXPECT_EQ(result.measuredVoxels, 37u * 23u * 11u);
      for (int k = 0; k < 11; ++k)
        for (int j = 0; j < 23; ++j)
          for (int i = 0; i < 37; ++i) ASSERT_EQ(result.volume.echo[result.volume.grid.indexOf(i, j, k)], value(i, j, k));
    }
}

}  // namespace
}  // namespace ew
