#include "surface_faces.h"

#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"

namespace ew::labelling {
namespace {

/// A face about the line between two voxels: four points around it, counterclockwise seen from the second voxel.
struct Face {
  std::array<std::int32_t, 4> points{};
  std::array<glm::vec3, 4> at{};  ///< beside the middle of the line, in voxels; x along it, y and z as they follow x
  LabelSides sides;
};

/// A face that no diagonal cuts well: four triangles around a point of the line. Two of them take the face's place in the list.
struct FanFace {
  Face face;
  int axis = 0;
  glm::ivec3 cell{0};  ///< of its first point
  std::size_t triangle = 0;
};

/// A triangle's plane may meet the line at most so far from its middle: the voxels are 0.5 away. The rest is for rounding.
constexpr float kReach = 0.499F;
/// Twice the area that a triangle has at least, seen along the line.
constexpr float kLeastArea = 1e-4F;

/// Whether a triangle of a face stays among the face's tetrahedra: seen along the line it is counterclockwise, and its plane meets the line
/// between the voxels.
bool staysInside(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  return normal.x > kLeastArea && std::abs(glm::dot(normal, a)) < kReach * normal.x;
}

enum class Cut { first, second, fan };

/// The shorter diagonal that keeps both triangles inside. @param axes_mm steps of a voxel along the face's x, y, z
Cut cutOf(const Face& face, const glm::mat3& axes_mm) {
  const auto& at = face.at;
  const glm::vec3 first = axes_mm * (at[2] - at[0]), second = axes_mm * (at[3] - at[1]);
  const auto fits = [&](Cut cut) {
    return cut == Cut::first ? staysInside(at[0], at[1], at[2]) && staysInside(at[0], at[2], at[3])
                             : staysInside(at[1], at[2], at[3]) && staysInside(at[1], at[3], at[0]);
  };
  const Cut shorter = glm::dot(first, first) <= glm::dot(second, second) ? Cut::first : Cut::second;
  if (fits(shorter)) return shorter;
  const Cut other = shorter == Cut::first ? Cut::second : Cut::first;
  return fits(other) ? other : Cut::fan;
}

class FaceMaker {
 public:
  FaceMaker(const LabelRows& rows, const SurfaceNet& net, LabelSurfaces& surfaces)
      : rows_(rows), net_(net), voxelToWorld_(net.grid.voxelToWorld().matrix), made_(surfaces) {
    const glm::mat3 axes(voxelToWorld_);
    for (int axis = 0; axis < 3; ++axis)
      axes_mm_[static_cast<std::size_t>(axis)] = glm::mat3(axes[axis], axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
    isMirrored_ = glm::determinant(glm::dmat3(voxelToWorld_)) < 0.0;
  }

  [[nodiscard]] std::size_t countFaces(int j, int k) const {
    std::size_t count = 0;
    visitFaces(j, k, [&](std::int32_t, int, int, LabelSides) { ++count; });
    return count;
  }

  void placePoints(int j, int k) {
    for (std::int32_t p = net_.rowBegin[net_.rowOf(j, k)]; p < net_.rowBegin[net_.rowOf(j, k) + 1]; ++p) {
      const auto point = static_cast<std::size_t>(p);
      const float* const offset = net_.offsets[point].at;
      made_.points_mm[point] = placeOf(glm::dvec3(net_.column[point], j, k) - 0.5 + glm::dvec3(offset[0], offset[1], offset[2]));
    }
  }

  /// The row's faces, from the place `triangle` of the list on. @return the place after them
  std::size_t cutFaces(int j, int k, std::size_t triangle, std::vector<FanFace>& fanned) {
    visitFaces(j, k, [&](std::int32_t p, int i, int axis, LabelSides sides) {
      const Face face = faceOf(p, axis, sides);
      const Cut cut = cutOf(face, axes_mm_[static_cast<std::size_t>(axis)]);
      const auto& at = face.points;
      if (cut == Cut::fan) fanned.push_back({face, axis, {i, j, k}, triangle});
      if (cut == Cut::first) put(triangle, {at[0], at[1], at[2]}, {at[0], at[2], at[3]}, sides);
      if (cut == Cut::second) put(triangle, {at[1], at[2], at[3]}, {at[1], at[3], at[0]}, sides);
      triangle += 2;
    });
    return triangle;
  }

  /// @param point in the middle of the fan, and `triangle` the place of the two triangles that are more than those of other faces
  void fanFace(const FanFace& fanned, std::size_t point, std::size_t triangle) {
    const auto& at = fanned.face.at;
    const float along = std::clamp(0.25F * (at[0].x + at[1].x + at[2].x + at[3].x), -0.45F, 0.45F);
    glm::dvec3 voxel = glm::dvec3(fanned.cell);
    voxel[fanned.axis] += static_cast<double>(along) - 0.5;
    made_.points_mm[point] = placeOf(voxel);
    const auto middle = static_cast<std::int32_t>(point);
    const auto& points = fanned.face.points;
    put(fanned.triangle, {middle, points[0], points[1]}, {middle, points[1], points[2]}, fanned.face.sides);
    put(triangle, {middle, points[2], points[3]}, {middle, points[3], points[0]}, fanned.face.sides);
  }

 private:
  /// Each face belongs to the cell at whose last corner its line ends: visit(point, i, axis, sides).
  template <class Visit>
  void visitFaces(int j, int k, const Visit& visit) const {
    const std::uint8_t *const own = rows_.at(j, k), *const beforeJ = rows_.at(j - 1, k), *const beforeK = rows_.at(j, k - 1);
    const int voxels = net_.grid.dims.x;
    for (std::int32_t p = net_.rowBegin[net_.rowOf(j, k)]; p < net_.rowBegin[net_.rowOf(j, k) + 1]; ++p) {
      const int i = net_.column[static_cast<std::size_t>(p)];
      const auto at = [&](const std::uint8_t* row, int x) { return x >= 0 && x < voxels ? row[x] : std::uint8_t{0}; };
      const std::uint8_t here = at(own, i), others[3] = {at(own, i - 1), at(beforeJ, i), at(beforeK, i)};
      for (int axis = 0; axis < 3; ++axis)
        if (others[axis] != here) visit(p, i, axis, LabelSides{.front = here, .back = others[axis]});
    }
  }

  [[nodiscard]] std::int32_t after(std::int32_t p, int axis) const {
    return axis == 0 ? p + 1 : net_.after[static_cast<std::size_t>(p)][static_cast<std::size_t>(axis - 1)];
  }

  [[nodiscard]] Face faceOf(std::int32_t p, int axis, LabelSides sides) const {
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    const std::int32_t afterY = after(p, y), afterZ = after(p, z);
    Face face{.points = {p, afterY, after(afterY, z), afterZ}, .at = {}, .sides = sides};
    static constexpr float kMiddles[4][2] = {{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
    for (std::size_t n = 0; n < 4; ++n) {
      const float* const offset = net_.offsets[static_cast<std::size_t>(face.points[n])].at;
      face.at[n] = {offset[axis], offset[y] + kMiddles[n][0], offset[z] + kMiddles[n][1]};
    }
    return face;
  }

  [[nodiscard]] glm::vec3 placeOf(const glm::dvec3& voxel) const { return glm::vec3(voxelToWorld_ * glm::dvec4(voxel, 1.0)); }

  void put(std::size_t triangle, glm::ivec3 a, glm::ivec3 b, LabelSides sides) {
    if (isMirrored_) {
      std::swap(a.y, a.z);
      std::swap(b.y, b.z);
    }
    made_.triangles[triangle] = a;
    made_.triangles[triangle + 1] = b;
    made_.sides[triangle] = made_.sides[triangle + 1] = sides;
  }

  const LabelRows& rows_;
  const SurfaceNet& net_;
  glm::dmat4 voxelToWorld_;
  std::array<glm::mat3, 3> axes_mm_{};
  bool isMirrored_ = false;
  LabelSurfaces& made_;
};

/// @param work work(slab, j, k) for the rows of a slab in their order
template <class Work>
bool forEachSlab(const glm::ivec3& cells, int threads, Progress& progress, const Work& work) {
  return forEachTask(slabsOf(cells), threads, progress, say<"Making triangles">(), [&](int slab, int, const auto& stopped) {
    for (int k = slab * kSlab; k < std::min(cells.z, (slab + 1) * kSlab) && !stopped(); ++k)
      for (int j = 0; j < cells.y; ++j) work(static_cast<std::size_t>(slab), j, k);
  });
}

}  // namespace

bool makeFaces(const LabelRows& rows, const SurfaceNet& net, int threads, Progress& progress, LabelSurfaces& surfaces) {
  const auto slabs = static_cast<std::size_t>(slabsOf(net.cells));
  FaceMaker maker(rows, net, surfaces);
  std::vector<std::size_t> next(slabs, 0);
  PartOfProgress counting(progress, 0.0, 0.1), cutting(progress, 0.1, 0.9), fanning(progress, 0.9, 1.0);
  if (!forEachSlab(net.cells, threads, counting, [&](std::size_t slab, int j, int k) { next[slab] += 2 * maker.countFaces(j, k); }))
    return false;
  std::size_t triangles = 0;
  for (std::size_t& each : next) triangles += std::exchange(each, triangles);
  if (!growInLargePages(surfaces.points_mm, net.points(), progress) || !growInLargePages(surfaces.triangles, triangles, progress) ||
      !growInLargePages(surfaces.sides, triangles, progress))
    return false;
  std::vector<std::vector<FanFace>> fanned(slabs);
  if (!forEachSlab(net.cells, threads, cutting, [&](std::size_t slab, int j, int k) {
        maker.placePoints(j, k);
        next[slab] = maker.cutFaces(j, k, next[slab], fanned[slab]);
      }))
    return false;
  std::vector<std::size_t> firstFan(slabs, 0);
  std::size_t fans = 0;
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    firstFan[slab] = fans;
    fans += fanned[slab].size();
  }
  surfaces.points_mm.resize(net.points() + fans);
  surfaces.triangles.resize(triangles + 2 * fans);
  surfaces.sides.resize(triangles + 2 * fans);
  return forEachTask(static_cast<int>(slabs), threads, fanning, say<"Making triangles">(), [&](int task) {
    const auto slab = static_cast<std::size_t>(task);
    for (std::size_t n = 0; n < fanned[slab].size(); ++n)
      maker.fanFace(fanned[slab][n], net.points() + firstFan[slab] + n, triangles + 2 * (firstFan[slab] + n));
  });
}

}  // namespace ew::labelling
