#include <gtest/gtest.h>

#include <fstream>

#include "cli/cli_world.h"
#include "ew/io/volume_file.h"

namespace ew::test::surfaces_test {
namespace {

/// A block of label 3 beside one of label 7.
std::string labelsIn(const TemporaryFolder& folder) {
  Volume labels;
  labels.grid.dims = glm::ivec3(12, 10, 8);
  labels.grid.spacing_mm = glm::dvec3(0.5);
  labels.echo.assign(labels.grid.voxelCount(), 0);
  for (int k = 2; k < 6; ++k)
    for (int j = 2; j < 8; ++j)
      for (int i = 2; i < 10; ++i) labels.echo[labels.grid.indexOf(i, j, k)] = i < 6 ? 3 : 7;
  EXPECT_TRUE(writeVolume(labels, folder / "labels.mha"));
  return folder / "labels.mha";
}

TEST(SurfacesCommand, WritesAllLabelsAsOneGltf) {
  const TemporaryFolder folder;
  const std::string labels = labelsIn(folder);
  const auto outcome = run({"surfaces", labels, "-o", folder / "organs.glb", "--name", "3=liver", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3  liver  "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("7  label 7  "), std::string::npos) << outcome.out;
  std::ifstream file(folder / "organs.glb", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_NE(bytes.find("\"name\":\"liver\""), std::string::npos);
  EXPECT_NE(bytes.find("\"name\":\"label 7\""), std::string::npos);
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["surfaces"].size(), 2u);
  EXPECT_EQ(report["surfaces"][0]["triangles"], 2 * (2 * (16 + 24 + 24)));
  const auto only = run({"surfaces", labels, "-o", folder / "one.glb", "--label", "7"});
  EXPECT_EQ(only.status, 0);
  EXPECT_EQ(only.out.find("label 3"), std::string::npos);
}

TEST(SurfacesCommand, WritesOneLabelAsStl) {
  const TemporaryFolder folder;
  const std::string labels = labelsIn(folder);
  const auto outcome = run({"surfaces", labels, "-o", folder / "one.stl", "--label", "7", "--smoothing", "0"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(std::filesystem::file_size(folder / "one.stl"), 84u + 50u * 2u * 2u * (16u + 24u + 24u));
}

TEST(SurfacesCommand, SaysWhatItCannotDoAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string labels = labelsIn(folder);
  const std::string out = folder / "o.stl", glb = folder / "o.glb";
  EXPECT_EQ(run({"surfaces", labels, "-o", out}).status, 2) << "which of them";
  EXPECT_EQ(run({"surfaces", labels, "-o", glb, "--label", "0"}).status, 2);
  EXPECT_EQ(run({"surfaces", labels, "-o", glb, "--name", "liver"}).status, 2);
  EXPECT_EQ(run({"surfaces", labels, "-o", glb, "--smoothing", "2"}).status, 2);
  EXPECT_EQ(run({"surfaces", labels, "-o", folder / "o.obj", "--label", "3"}).status, 2);
  EXPECT_EQ(run({"surfaces", labels, "-o", glb, "--label", "5"}).status, 1) << "no voxel has it";
  EXPECT_NE(run({"surfaces", labels, "-o", labels, "--label", "3"}).status, 0) << "never over its input";
  EXPECT_FALSE(std::filesystem::exists(out) || std::filesystem::exists(glb));
}

}  // namespace
}  // namespace ew::test::surfaces_test
