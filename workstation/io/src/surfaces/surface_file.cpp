#include "ew/io/surface_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <ostream>
#include <string_view>

#include "ew/core/ending.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

template <class Value>
void put(std::ostream& out, Value value) {
  static_assert(std::endian::native == std::endian::little);
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(Value));
  out.write(bytes.data(), bytes.size());
}
void put(std::ostream& out, const glm::vec3& p) {
  put(out, p.x);
  put(out, p.y);
  put(out, p.z);
}

void writePly(const SurfaceMesh& mesh, std::ostream& out) {
  out << "ply\nformat binary_little_endian 1.0\ncomment EchoWeave, mm, LPS\nelement vertex " << mesh.points_mm.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t n = 0; n < mesh.points_mm.size(); ++n) {
    put(out, mesh.points_mm[n]);
    put(out, mesh.normals[n]);
  }
  for (const glm::ivec3& triangle : mesh.triangles) {
    put(out, std::uint8_t{3});
    for (int n = 0; n < 3; ++n) put(out, static_cast<std::int32_t>(triangle[n]));
  }
}

void writeStl(const SurfaceMesh& mesh, std::ostream& out) {
  std::array<char, 80> header{};
  constexpr std::string_view kHeader = "EchoWeave, mm, LPS";
  std::copy(kHeader.begin(), kHeader.end(), header.begin());
  out.write(header.data(), header.size());
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const glm::ivec3& triangle : mesh.triangles) {
    const auto at = [&](int n) { return mesh.points_mm[static_cast<std::size_t>(triangle[n])]; };
    const glm::vec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
    const float length = glm::length(across);
    put(out, length > 0.0F ? across / length : glm::vec3(0.0F));
    for (int n = 0; n < 3; ++n) put(out, at(n));
    put(out, std::uint16_t{0});
  }
}

}  // namespace

Result<void> writeSurface(const SurfaceMesh& mesh, const std::filesystem::path& file) {
  const bool isStl = hasEnding(file, ".stl");
  if (!isStl && !hasEnding(file, ".ply"))
    return failure(ErrorCode::unsupported,
                   say<"Surfaces are written as .stl or .ply, not as %1; change its ending.">(file.filename().string()),
                   {{"file", file.string()}});
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    if (isStl)
      writeStl(mesh, out);
    else
      writePly(mesh, out);
    return {};
  });
}

}  // namespace ew
