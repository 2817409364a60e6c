#include "ew/io/vector_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/files.h"

namespace ew::vector_file_test {
namespace {

Grid someGrid(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = {0.5, 0.7, 1.25};
  grid.origin_mm = {-10.0, 3.5, 100.0};
  grid.directions = glm::dmat3(0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0);
  return grid;
}

/// A number that says where it belongs.
float numberAt(std::size_t voxel, int component) { return static_cast<float>(voxel) + 0.25F * static_cast<float>(component); }

VectorSlices numbered(const Grid& grid, int components) {
  return [grid, components](int first, int, std::span<float> out) -> Result<void> {
    const std::size_t begin = grid.indexOf(0, 0, first);
    const auto width = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = numberAt(begin + i / width, static_cast<int>(i % width));
    return {};
  };
}

TEST(VectorFile, ComesBackAsItWasWritten) {
  const test::TempFolder folder;
  for (const auto& [dims, components] :
       {std::pair{glm::ivec3(5, 4, 3), 3}, {glm::ivec3(300, 200, 9), 3}, {glm::ivec3(6, 7, 1), 2}, {glm::ivec3(6, 7, 1), 3}}) {
    const Grid grid = someGrid(dims);
    const auto file = folder / "field.mha";
    ASSERT_TRUE(writeVectorField(grid, components, file, numbered(grid, components)));
    const auto read = readVectorField(file);
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->components, components);
    EXPECT_EQ(read->grid.dims, grid.dims);
    EXPECT_EQ(read->grid.spacing_mm.x, grid.spacing_mm.x);
    EXPECT_EQ(read->grid.origin_mm.y, grid.origin_mm.y);
    ASSERT_EQ(read->values.size(), grid.voxelCount() * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < read->values.size(); i += 7)
      ASSERT_EQ(read->values[i],
                numberAt(i / static_cast<std::size_t>(components), static_cast<int>(i % static_cast<std::size_t>(components))));
  }
}

TEST(VectorFile, SaysInItsHeaderWhatOtherProgramsLookFor) {
  const test::TempFolder folder;
  const Grid grid = someGrid({6, 7, 1});
  ASSERT_TRUE(writeVectorField(grid, 2, folder / "flat.mha", numbered(grid, 2)));
  ASSERT_TRUE(writeVectorField(grid, 3, folder / "full.mha", numbered(grid, 3)));
  const std::string flat = test::bytesOfFile(folder / "flat.mha");
  const std::string full = test::bytesOfFile(folder / "full.mha");
  for (const char* line :
       {"NDims = 2\n", "ElementNumberOfChannels = 2\n", "ElementType = MET_FLOAT\n", "CompressedData = False\n", "DimSize = 6 7\n"})
    EXPECT_NE(flat.find(line), std::string::npos) << line;
  for (const char* line : {"NDims = 3\n", "ElementNumberOfChannels = 3\n", "DimSize = 6 7 1\n"})
    EXPECT_NE(full.find(line), std::string::npos) << line;
}

TEST(VectorFile, AFailureHalfwayLeavesWhatWasThere) {
  const test::TempFolder folder;
  const auto file = folder / "field.mha";
  std::ofstream(file) << "earlier";
  const Grid grid = someGrid({100, 100, 50});
  const auto written = writeVectorField(grid, 3, file, [](int first, int, std::span<float>) -> Result<void> {
    if (first > 0) return failure(ErrorCode::cancelled, verbatim("Stopped."));
    return {};
  });
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::cancelled);
  EXPECT_EQ(test::bytesOfFile(file), "earlier");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(VectorFile, RefusesWhatIsNoFieldOfVectors) {
  const test::TempFolder folder;
  Volume volume;
  volume.grid = someGrid({3, 3, 3});
  volume.echo.assign(27, 1);
  ASSERT_TRUE(writeVolume(volume, folder / "v.mha"));
  const auto read = readVectorField(folder / "v.mha");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::badField);
  EXPECT_EQ(readVectorField(folder / "none.mha").error().code, ErrorCode::notFound);
  const auto grid = someGrid({50, 50, 50});
  ASSERT_TRUE(writeVectorField(grid, 3, folder / "cut.mha", numbered(grid, 3)));
  std::filesystem::resize_file(folder / "cut.mha", 1000);
  EXPECT_EQ(readVectorField(folder / "cut.mha").error().code, ErrorCode::truncated);
  EXPECT_EQ(writeVectorField(grid, 3, folder / "field.nrrd", numbered(grid, 3)).error().code, ErrorCode::unsupported);
}

}  // namespace
}  // namespace ew::vector_file_test
