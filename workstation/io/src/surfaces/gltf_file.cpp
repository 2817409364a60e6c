#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <vector>

#include "ew/core/ending.h"
#include "ew/core/version.h"
#include "ew/io/safe_file.h"
#include "ew/io/surface_file.h"

namespace ew {
namespace {

using nlohmann::json;

// The numbers of the format, which are those of OpenGL.
constexpr int kFloat = 5126, kUnsignedInt = 5125, kPoints = 34962, kCorners = 34963;

/// LPS to the axes of glTF: left, superior, anterior.
glm::vec3 inGltf(const glm::vec3& p) { return {p.x, p.z, -p.y}; }
glm::vec3 inGltf_m(const glm::vec3& p_mm) { return inGltf(p_mm) * 0.001F; }

/// What the format wants colours in.
double linearOf(double sRgb) { return sRgb <= 0.04045 ? sRgb / 12.92 : std::pow((sRgb + 0.055) / 1.055, 2.4); }

/// The two chunks of the file, grown surface by surface.
class GltfDocument {
 public:
  void add(const SurfacePart& surface) {
    const std::size_t n = json_["meshes"].size();
    const SurfaceMesh& mesh = surface.mesh;
    std::vector<glm::vec3> points_m, normals;
    glm::vec3 lowest_m(std::numeric_limits<float>::max()), highest_m(-lowest_m);
    for (const glm::vec3& p_mm : mesh.points_mm) {
      points_m.push_back(inGltf_m(p_mm));
      lowest_m = glm::min(lowest_m, points_m.back());
      highest_m = glm::max(highest_m, points_m.back());
    }
    for (const glm::vec3& normal : mesh.normals) normals.push_back(inGltf(normal));
    json points = accessor(points_m, "VEC3", kFloat, points_m.size(), kPoints);
    points["min"] = {lowest_m.x, lowest_m.y, lowest_m.z};
    points["max"] = {highest_m.x, highest_m.y, highest_m.z};
    const std::size_t first = json_["accessors"].size();
    json_["accessors"].push_back(std::move(points));
    json_["accessors"].push_back(accessor(normals, "VEC3", kFloat, normals.size(), kPoints));
    json_["accessors"].push_back(accessor(mesh.triangles, "SCALAR", kUnsignedInt, 3 * mesh.triangles.size(), kCorners));
    json_["materials"].push_back(
        {{"name", surface.name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {linearOf(surface.colour.x), linearOf(surface.colour.y), linearOf(surface.colour.z), 1.0}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 0.6}}}});
    json_["meshes"].push_back(
        {{"name", surface.name},
         {"primitives", {{{"attributes", {{"POSITION", first}, {"NORMAL", first + 1}}}, {"indices", first + 2}, {"material", n}}}}});
    json_["nodes"].push_back({{"name", surface.name}, {"mesh", n}});
    json_["scenes"][0]["nodes"].push_back(n);
  }

  [[nodiscard]] std::string text() {
    json_["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    std::string text = json_.dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  /// @param values of four bytes each, however they are grouped
  template <class Value>
  json accessor(const std::vector<Value>& values, const char* type, int component, std::size_t count, int target) {
    static_assert(std::endian::native == std::endian::little && sizeof(Value) == 12);
    const std::size_t length = values.size() * sizeof(Value);
    json_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}, {"target", target}});
    bytes_.append(reinterpret_cast<const char*>(values.data()), length);
    return {{"bufferView", json_["bufferViews"].size() - 1}, {"componentType", component}, {"count", count}, {"type", type}};
  }

  json json_ = {{"asset", {{"version", "2.0"}, {"generator", std::string("EchoWeave ") + kVersion}}},
                {"scene", 0},
                {"scenes", json::array({{{"nodes", json::array()}}})},
                {"nodes", json::array()},
                {"meshes", json::array()},
                {"materials", json::array()},
                {"accessors", json::array()},
                {"bufferViews", json::array()}};
  std::string bytes_;
};

void putWord(std::ostream& out, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  std::array<char, 4> bytes;
  std::memcpy(bytes.data(), &word, sizeof(word));
  out.write(bytes.data(), bytes.size());
}

void putChunk(std::ostream& out, std::uint32_t kind, const std::string& bytes) {
  putWord(out, bytes.size());
  putWord(out, kind);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

Result<void> writeGltf(std::span<const SurfacePart> surfaces, const std::filesystem::path& file) {
  constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
  constexpr std::uint64_t kMost_bytes = std::numeric_limits<std::uint32_t>::max(), kRoomForWords = std::uint64_t{1} << 24;
  if (!hasEnding(file, ".glb"))
    return failure(ErrorCode::unsupported,
                   say<"Several surfaces are written as .glb, not as %1; change its ending.">(file.filename().string()),
                   {{"file", file.string()}});
  std::uint64_t bytes = 0;
  for (const SurfacePart& each : surfaces) bytes += 24 * each.mesh.points_mm.size() + 12 * each.mesh.triangles.size();
  if (bytes > kMost_bytes - kRoomForWords)
    return failure(ErrorCode::tooLarge,
                   say<"The surfaces are too large for %1, which can hold 4 GiB; write fewer of them.">(file.filename().string()),
                   {{"file", file.string()}});
  GltfDocument document;
  bool isEmpty = true;
  for (const SurfacePart& each : surfaces) {
    if (each.mesh.triangles.empty()) continue;
    document.add(each);
    isEmpty = false;
  }
  if (isEmpty)
    return failure(ErrorCode::emptyVolume, say<"There is no surface to write to %1.">(file.filename().string()), {{"file", file.string()}});
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    const std::string text = document.text();
    putWord(out, kMagic);
    putWord(out, 2);
    putWord(out, 12 + 8 + text.size() + 8 + document.bytes().size());
    putChunk(out, kJson, text);
    putChunk(out, kBinary, document.bytes());
    return {};
  });
}

}  // namespace ew
