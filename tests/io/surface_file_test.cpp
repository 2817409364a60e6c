#include "ew/io/surface_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "io/files.h"

namespace ew::surface_file_test {
namespace {

using nlohmann::json;

/// A tetrahedron with its corner at `at`.
SurfaceMesh tetrahedron(const glm::vec3& at) {
  SurfaceMesh mesh;
  mesh.points_mm = {at, at + glm::vec3(10, 0, 0), at + glm::vec3(0, 20, 0), at + glm::vec3(0, 0, 30)};
  for (const glm::vec3& p : mesh.points_mm) mesh.normals.push_back(glm::normalize(p - (at + 5.0F)));
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

template <class Value>
Value at(const std::string& bytes, std::size_t offset) {
  Value value;
  EXPECT_LE(offset + sizeof(Value), bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof(Value));
  return value;
}

struct Glb {
  json document;
  std::string binary;
  [[nodiscard]] const json& view(std::size_t accessor) const {
    return document["bufferViews"][document["accessors"][accessor]["bufferView"].get<std::size_t>()];
  }
  [[nodiscard]] glm::vec3 point(std::size_t accessor, std::size_t n) const {
    return surface_file_test::at<glm::vec3>(binary, view(accessor)["byteOffset"].get<std::size_t>() + 12 * n);
  }
};

Glb parsed(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(at<std::uint32_t>(bytes, 4), 2u);
  EXPECT_EQ(at<std::uint32_t>(bytes, 8), bytes.size());
  const std::size_t words = at<std::uint32_t>(bytes, 12);
  EXPECT_EQ(words % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const std::size_t binary = 20 + words;
  EXPECT_EQ(at<std::uint32_t>(bytes, binary), bytes.size() - binary - 8);
  EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
  return {json::parse(bytes.substr(20, words)), bytes.substr(binary + 8)};
}

TEST(SurfaceFile, GltfHasANodeMeshAndMaterialForEachSurface) {
  const test::TempFolder folder;
  const auto file = folder / "organs.glb";
  const std::vector<SurfacePart> surfaces = {{"liver", {0.5, 0.25, 1.0}, tetrahedron({1, 2, 3})},
                                             {"nothing", glm::dvec3(0.1), {}},
                                             {"a \"name\" \xC3\xA4 \xFF", glm::dvec3(1.0), tetrahedron({-100, -200, 300})}};
  ASSERT_TRUE(writeGltf(surfaces, file));
  const Glb glb = parsed(test::bytesOfFile(file));
  const json& document = glb.document;
  EXPECT_EQ(document["asset"]["version"], "2.0");
  ASSERT_EQ(document["nodes"].size(), 2u) << "what has no triangles is left out";
  EXPECT_EQ(document["scenes"][0]["nodes"], json({0, 1}));
  EXPECT_EQ(document["nodes"][0]["name"], "liver");
  EXPECT_EQ(document["nodes"][1]["name"], "a \"name\" \xC3\xA4 \xEF\xBF\xBD");
  EXPECT_EQ(document["buffers"][0]["byteLength"], glb.binary.size());
  const auto colour = document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(colour[0].get<double>(), 0.21404, 1e-4) << "linear";
  EXPECT_NEAR(colour[2].get<double>(), 1.0, 1e-12);
  for (const json& view : document["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), glb.binary.size());
  }
  const json& primitive = document["meshes"][1]["primitives"][0];
  EXPECT_EQ(primitive["material"], 1);
  const auto indices = primitive["indices"].get<std::size_t>();
  EXPECT_EQ(document["accessors"][indices]["count"], 12);
  EXPECT_EQ(at<std::uint32_t>(glb.binary, glb.view(indices)["byteOffset"].get<std::size_t>() + 4), 2u);
}

TEST(SurfaceFile, GltfIsInMetresWithSuperiorUpAndAnteriorToTheFront) {
  const test::TempFolder folder;
  const SurfacePart surface{"one", glm::dvec3(0.5), tetrahedron({100, 2000, 300})};
  ASSERT_TRUE(writeGltf({&surface, 1}, folder / "one.GLB"));
  const Glb glb = parsed(test::bytesOfFile(folder / "one.GLB"));
  const json& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
  const auto points = attributes["POSITION"].get<std::size_t>(), normals = attributes["NORMAL"].get<std::size_t>();
  EXPECT_NEAR(glm::distance(glb.point(points, 0), glm::vec3(0.1F, 0.3F, -2.0F)), 0.0F, 1e-6F);
  EXPECT_NEAR(glm::distance(glb.point(points, 3), glm::vec3(0.1F, 0.33F, -2.0F)), 0.0F, 1e-6F);
  const glm::vec3 normal = surface.mesh.normals[2];
  EXPECT_EQ(glb.point(normals, 2), glm::vec3(normal.x, normal.z, -normal.y));
  const json& accessor = glb.document["accessors"][points];
  for (int axis = 0; axis < 3; ++axis) {
    float lowest = 1e9F, highest = -1e9F;
    for (std::size_t n = 0; n < 4; ++n) {
      lowest = std::min(lowest, glb.point(points, n)[axis]);
      highest = std::max(highest, glb.point(points, n)[axis]);
    }
    EXPECT_EQ(accessor["min"][static_cast<std::size_t>(axis)].get<float>(), lowest);
    EXPECT_EQ(accessor["max"][static_cast<std::size_t>(axis)].get<float>(), highest);
  }
}

TEST(SurfaceFile, StlAndPlyHoldEveryTriangle) {
  const test::TempFolder folder;
  const SurfaceMesh mesh = tetrahedron({1, 2, 3});
  ASSERT_TRUE(writeSurface(mesh, folder / "a.stl"));
  const std::string stl = test::bytesOfFile(folder / "a.stl");
  ASSERT_EQ(stl.size(), 84 + 50 * mesh.triangles.size());
  EXPECT_EQ(at<std::uint32_t>(stl, 80), 4u);
  EXPECT_EQ(at<glm::vec3>(stl, 84), glm::vec3(0, 0, -1)) << "outwards";
  EXPECT_EQ(at<glm::vec3>(stl, 84 + 24), mesh.points_mm[2]);
  ASSERT_TRUE(writeSurface(mesh, folder / "a.PLY"));
  EXPECT_GT(std::filesystem::file_size(folder / "a.PLY"), 24 * mesh.points_mm.size() + 13 * mesh.triangles.size());
}

TEST(SurfaceFile, ThatCannotBeWrittenSaysWhyAndIsNotThere) {
  const test::TempFolder folder;
  const SurfacePart empty{"empty", glm::dvec3(0.5), {}}, one{"one", glm::dvec3(0.5), tetrahedron({0, 0, 0})};
  EXPECT_EQ(writeSurface(one.mesh, folder / "a.obj").error().code, ErrorCode::unsupported);
  EXPECT_EQ(writeGltf({&one, 1}, folder / "a.stl").error().code, ErrorCode::unsupported);
  EXPECT_EQ(writeGltf({&empty, 1}, folder / "a.glb").error().code, ErrorCode::emptyVolume);
  EXPECT_EQ(writeGltf({}, folder / "a.glb").error().code, ErrorCode::emptyVolume);
  EXPECT_EQ(writeGltf({&one, 1}, folder / "no" / "folder.glb").error().code, ErrorCode::notWritable);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace ew::surface_file_test
