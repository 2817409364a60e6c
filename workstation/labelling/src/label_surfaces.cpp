#include "ew/labelling/label_surfaces.h"

#include <algorithm>
#include <new>
#include <numeric>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "surface_faces.h"

namespace ew::labelling {
namespace {

constexpr std::int64_t kMostPoints = std::int64_t{1} << 28;  // at most 12 triangles each
constexpr double kShortestWave = 4.0, kLongestWave = 32.0;

std::int64_t sumOf(const std::vector<std::int32_t>& counts) { return std::accumulate(counts.begin(), counts.end(), std::int64_t{0}); }

/// Of the net with its second offsets and of the surfaces while they grow. Where labels are noise that takes 193 bytes a point at most,
/// where they are organs about 115.
std::uint64_t bytesFor(std::int64_t points, std::size_t rows) {
  constexpr std::uint64_t kNet = 4 + 8 + 16 + 1 + 2 * sizeof(CellOffset);
  constexpr std::uint64_t kSurface = sizeof(glm::vec3) + 10 * (sizeof(glm::ivec3) + sizeof(LabelSides));
  return static_cast<std::uint64_t>(points) * (kNet + kSurface) + 4 * rows;
}

tl::unexpected<Error> stoppedSurfaces() { return failure(ErrorCode::cancelled, say<"Making surfaces was stopped.">()); }

tl::unexpected<Error> needsMoreFor(std::uint64_t bytes, std::uint64_t maxBytes) {
  return failure(ErrorCode::tooLarge,
                 say<"The surfaces of these labels need %1 of memory, %2 are allowed; allow more, or make the labels coarser.">(
                     mebibytesText(static_cast<double>(bytes)), mebibytesText(static_cast<double>(maxBytes))),
                 {{"forecast_bytes", std::to_string(bytes)}});
}

Result<LabelSurfaces> madeSurfaces(const VolumeView<const std::uint8_t>& labels, const LabelSurfaceOptions& options, Progress& progress) {
  const LabelRows rows(labels);
  PartOfProgress counting(progress, 0.0, 0.1), building(progress, 0.1, 0.3), smoothing(progress, 0.3, 0.8), facing(progress, 0.8, 1.0);
  std::vector<std::int32_t> ofRow;
  if (!countPoints(rows, options.threads, counting, ofRow)) return stoppedSurfaces();
  const std::int64_t points = sumOf(ofRow);
  const std::uint64_t bytes = bytesFor(points, ofRow.size());
  if (points > kMostPoints || bytes > options.maxBytes) return needsMoreFor(bytes, options.maxBytes);
  LabelSurfaces surfaces;
  SurfaceNet net;
  if (!buildNet(rows, std::move(ofRow), options.threads, building, net) ||
      !relaxNet(net, options.shortestWave_voxel, options.threads, smoothing) || !makeFaces(rows, net, options.threads, facing, surfaces))
    return stoppedSurfaces();
  surfaces.labels = std::move(net.labels);
  return surfaces;
}

}  // namespace

std::uint64_t labelSurfacesForecast_bytes(const VolumeView<const std::uint8_t>& labels, int threads) {
  std::vector<std::int32_t> ofRow;
  if (!countPoints(LabelRows(labels), threads, noProgress(), ofRow)) return 0;
  return bytesFor(sumOf(ofRow), ofRow.size());
}

Result<LabelSurfaces> labelSurfaces(const VolumeView<const std::uint8_t>& labels, const LabelSurfaceOptions& options, Progress& progress) {
  if (auto usable = checkGrid(labels.grid); !usable) return passOn(usable.error());
  if (const double wave = options.shortestWave_voxel; wave != 0.0 && !(wave >= kShortestWave && wave <= kLongestWave))
    return failure(ErrorCode::badField,
                   say<"Surfaces are to be smoothed up to waves of %1 voxels, expected is 0 or a number from 4 to 32.">(textOf(wave)),
                   {{"field", "shortestWave_voxel"}, {"found", textOf(wave)}, {"expected", "0, or 4 to 32"}});
  try {
    return madeSurfaces(labels, options, progress);
  } catch (const std::bad_alloc&) {
    return needsMoreFor(labelSurfacesForecast_bytes(labels, options.threads), options.maxBytes);
  }
}

SurfaceMesh meshOf(const LabelSurfaces& surfaces, std::uint8_t label) {
  SurfaceMesh mesh;
  std::vector<std::int32_t> numbers(surfaces.points_mm.size(), -1);
  for (std::size_t n = 0; n < surfaces.triangles.size(); ++n) {
    const LabelSides sides = surfaces.sides[n];
    if (sides.front != label && sides.back != label) continue;
    glm::ivec3 triangle = surfaces.triangles[n];
    if (sides.front == label) std::swap(triangle.y, triangle.z);
    for (int corner = 0; corner < 3; ++corner) {
      std::int32_t& number = numbers[static_cast<std::size_t>(triangle[corner])];
      if (number < 0) {
        number = static_cast<std::int32_t>(mesh.points_mm.size());
        mesh.points_mm.push_back(surfaces.points_mm[static_cast<std::size_t>(triangle[corner])]);
      }
      triangle[corner] = number;
    }
    mesh.triangles.push_back(triangle);
  }
  mesh.normals.assign(mesh.points_mm.size(), glm::vec3(0.0F));
  for (const glm::ivec3& triangle : mesh.triangles) {
    const auto at = [&](int corner) { return mesh.points_mm[static_cast<std::size_t>(triangle[corner])]; };
    const glm::vec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
    for (int corner = 0; corner < 3; ++corner) mesh.normals[static_cast<std::size_t>(triangle[corner])] += across;
  }
  for (glm::vec3& normal : mesh.normals) {
    const float length = glm::length(normal);
    normal = length > 0.0F ? normal / length : glm::vec3(0.0F, 0.0F, 1.0F);
  }
  return mesh;
}

Result<std::vector<SurfaceMesh>> meshesOf(const LabelSurfaces& surfaces, int threads, Progress& progress) {
  std::vector<SurfaceMesh> meshes(surfaces.labels.size());
  if (!meshes.empty() && !forEachTask(static_cast<int>(meshes.size()), threads, progress, say<"Parting surfaces">(), [&](int task) {
        meshes[static_cast<std::size_t>(task)] = meshOf(surfaces, surfaces.labels[static_cast<std::size_t>(task)]);
      }))
    return stoppedSurfaces();
  return meshes;
}

}  // namespace ew::labelling
