// Surfaces of organs as triangles.
#include <array>
#include <cmath>
#include <new>
#include <unordered_map>

#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"
#include "ew/phantom/truth.h"
#include "patient/anatomy.h"

namespace ew {
namespace {

constexpr double kMostNodes = 4e8;
constexpr std::size_t kMostTriangles = 20'000'000;
constexpr int kNodesPerQuestion = 16;

/// A cube's six tetrahedra around its diagonal from corner 0 to corner 7; corner n lies at (n & 1, n >> 1 & 1, n >> 2 & 1). Neighbouring
/// cubes cut their common face along the same diagonal, so the surface has no gaps.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// The surface of a shape within a box, cube by cube.
/// Source: marching tetrahedra after Doi and Koide, IEICE Trans. E74(1), 1991; here the places on edges are found by bisection.
class Tetrahedra {
 public:
  Tetrahedra(const phantom::Shape& shape, const Bounds& box, double edge_mm) : shape_(shape), box_(box), edge_(edge_mm) {
    origin_ = box.lowest_mm - 0.5 * edge_;
    cubes_ = glm::ivec3(glm::ceil((box.highest_mm - box.lowest_mm) / edge_)) + 1;
    for (auto& layer : inside_) layer.assign(layerSize(), 0);
  }
  [[nodiscard]] int layers() const { return cubes_.z + 1; }

  /// @return false when cancelled
  [[nodiscard]] bool sampleLayer(int k, Progress& progress) {
    QuietProgress silent(progress);
    auto& layer = inside_[static_cast<std::size_t>(k & 1)];
    return forEachTask(cubes_.y + 1, 0, silent, Message(), [&](int j, int /*worker*/, const auto& stopped) {
      for (int i = 0; i <= cubes_.x && !(i % kNodesPerQuestion == 0 && stopped()); ++i)
        layer[inLayer(i, j)] = holds(nodeAt({i, j, k})) ? 1 : 0;
    });
  }

  /// The cubes between layers k and k + 1, both sampled.
  /// @return false when cancelled
  [[nodiscard]] bool addCubes(int k, SurfaceMesh& mesh, const Progress& progress) {
    std::swap(lower_, upper_);
    upper_.clear();
    for (int j = 0; j < cubes_.y; ++j)
      for (int i = 0; i < cubes_.x; ++i) {
        int mask = 0;
        for (int corner = 0; corner < 8; ++corner) mask |= insideAt(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)) << corner;
        if (mask == 0 || mask == 255) continue;
        if (progress.cancelRequested()) return false;
        for (const auto& tetrahedron : kTetrahedra) addTetrahedron({i, j, k}, tetrahedron, mask, mesh);
      }
    return true;
  }

 private:
  [[nodiscard]] std::size_t layerSize() const { return static_cast<std::size_t>(cubes_.x + 1) * static_cast<std::size_t>(cubes_.y + 1); }
  [[nodiscard]] std::size_t inLayer(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(cubes_.x + 1) + static_cast<std::size_t>(i);
  }
  [[nodiscard]] int insideAt(int i, int j, int k) const { return inside_[static_cast<std::size_t>(k & 1)][inLayer(i, j)]; }
  [[nodiscard]] glm::dvec3 nodeAt(const glm::ivec3& node) const { return origin_ + edge_ * glm::dvec3(node); }
  [[nodiscard]] bool holds(const glm::dvec3& p) const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] > box_.lowest_mm[axis] && p[axis] < box_.highest_mm[axis])) return false;
    return shape_.distance_mm(p) < 0.0;
  }

  void addTetrahedron(const glm::ivec3& cube, const std::array<int, 4>& corners, int mask, SurfaceMesh& mesh) {
    std::array<int, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    for (const int corner : corners) ((mask >> corner & 1) != 0 ? in[ins++] : out[outs++]) = corner;
    if (ins == 0 || outs == 0) return;
    if (ins == 1) addTriangle(cube, {in[0], out[0], in[0], out[1], in[0], out[2]}, mesh);
    if (ins == 3) addTriangle(cube, {in[0], out[0], in[1], out[0], in[2], out[0]}, mesh);
    if (ins == 2) {
      addTriangle(cube, {in[0], out[0], in[0], out[1], in[1], out[1]}, mesh);
      addTriangle(cube, {in[0], out[0], in[1], out[1], in[1], out[0]}, mesh);
    }
  }

  /// Three edges, each from an inner to an outer corner. Turned so that its front looks outwards, judged at the edges' middles: there no
  /// triangle is ever flat.
  void addTriangle(const glm::ivec3& cube, const std::array<int, 6>& edges, SurfaceMesh& mesh) {
    const auto corner = [](int n) { return glm::dvec3(n & 1, n >> 1 & 1, n >> 2); };
    std::array<glm::dvec3, 3> middle;
    glm::dvec3 outwards(0.0);
    glm::ivec3 triangle;
    for (int n = 0; n < 3; ++n) {
      const int inner = edges[static_cast<std::size_t>(2 * n)], outer = edges[static_cast<std::size_t>(2 * n + 1)];
      middle[static_cast<std::size_t>(n)] = 0.5 * (corner(inner) + corner(outer));
      outwards += corner(outer) - corner(inner);
      triangle[n] = pointOn(cube, inner, outer, mesh);
    }
    if (glm::dot(glm::cross(middle[1] - middle[0], middle[2] - middle[0]), outwards) < 0.0) std::swap(triangle.y, triangle.z);
    mesh.triangles.push_back(triangle);
  }

  int pointOn(const glm::ivec3& cube, int inner, int outer, SurfaceMesh& mesh) {
    const glm::ivec3 a = cube + glm::ivec3(inner & 1, inner >> 1 & 1, inner >> 2),
                     b = cube + glm::ivec3(outer & 1, outer >> 1 & 1, outer >> 2);
    // An edge is its lower node and one of seven directions; those that lie wholly in the upper layer are met again by the next one.
    const glm::ivec3 low = glm::min(a, b), step = glm::abs(a - b);
    const std::uint64_t key = inLayer(low.x, low.y) * 8 + static_cast<std::uint64_t>(step.x + 2 * step.y + 4 * step.z);
    auto& known = low.z == cube.z ? lower_ : upper_;
    const auto [found, isNew] = known.try_emplace(key, static_cast<int>(mesh.points_mm.size()));
    if (!isNew) return found->second;
    glm::dvec3 inside = nodeAt(a), outside = nodeAt(b);
    for (int n = 0; n < 24; ++n) {
      const glm::dvec3 between = 0.5 * (inside + outside);
      (holds(between) ? inside : outside) = between;
    }
    const glm::dvec3 place = 0.5 * (inside + outside);
    mesh.points_mm.emplace_back(place);
    mesh.normals.emplace_back(normalAt(place, outside - inside));
    return found->second;
  }

  [[nodiscard]] glm::dvec3 normalAt(const glm::dvec3& p, const glm::dvec3& fallback) const {
    const double step_mm = 0.1 * edge_;
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = step_mm;
      gradient[axis] = shape_.distance_mm(p + step) - shape_.distance_mm(p - step);
    }
    const double length = glm::length(gradient);
    return length > 0.0 ? gradient / length : glm::normalize(fallback);
  }

  const phantom::Shape& shape_;
  Bounds box_;
  double edge_;
  glm::dvec3 origin_;
  glm::ivec3 cubes_;
  std::array<std::vector<std::uint8_t>, 2> inside_;
  std::unordered_map<std::uint64_t, int> lower_;
  std::unordered_map<std::uint64_t, int> upper_;
};

}  // namespace

Result<SurfaceMesh> surfaceOf(const Patient& patient, const std::string& organ, double edge_mm, Progress& progress) {
  if (!(edge_mm >= 0.01 && edge_mm <= 100.0))
    return failure(ErrorCode::badField, say<"The edge of the surface's cells is %1 mm; choose one from 0.01 to 100 mm.">(textOf(edge_mm)),
                   {{"field", "edge_mm"}});
  const auto found = patient.shapes.find(organ);
  if (found == patient.shapes.end()) return passOn(signedDistance_mm(patient, organ, glm::dvec3(0.0)).error());
  const phantom::Shape& shape = *found->second;
  const Bounds box{glm::max(shape.bounds().lowest_mm, patient.box.lowest_mm) - 0.01,
                   glm::min(shape.bounds().highest_mm, patient.box.highest_mm) + 0.01};
  SurfaceMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.highest_mm[axis] > box.lowest_mm[axis])) return mesh;
  const glm::dvec3 nodes = glm::ceil((box.highest_mm - box.lowest_mm) / edge_mm) + 2.0;
  const auto tooLarge = [&] {
    return failure(ErrorCode::tooLarge,
                   say<"The surface of %1 has too many parts with edges of %2 mm; choose longer ones.">(organ, textOf(edge_mm)),
                   {{"organ", organ}});
  };
  if (nodes.x * nodes.y * nodes.z > kMostNodes) return tooLarge();
  try {
    Tetrahedra tetrahedra(shape, box, edge_mm);
    bool finished = tetrahedra.sampleLayer(0, progress);
    for (int k = 0; k + 1 < tetrahedra.layers() && finished; ++k) {
      progress.report(say<"Making the surface">(), static_cast<double>(k) / tetrahedra.layers());
      finished = tetrahedra.sampleLayer(k + 1, progress) && tetrahedra.addCubes(k, mesh, progress);
      if (mesh.triangles.size() > kMostTriangles) return tooLarge();
    }
    if (!finished) return failure(ErrorCode::cancelled, say<"Making the surface was stopped.">());
  } catch (const std::bad_alloc&) {
    return tooLarge();
  }
  return mesh;
}

}  // namespace ew
