#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ew/bridge/mannequin.h"
#include "ew/bridge/mesh_skin.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "ew/phantom/body_shape.h"

namespace ew::bridge {
namespace {

vtkSmartPointer<vtkPolyData> contour(const Grid& grid, std::vector<float>& inside_mm) {
  vtkNew<vtkFloatArray> values;
  values->SetArray(inside_mm.data(), static_cast<vtkIdType>(inside_mm.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.dims.x, grid.dims.y, grid.dims.z);
  image->SetSpacing(grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z);
  image->SetOrigin(grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;  // thin toes may come off on a coarse grid
  largest->SetInputConnection(edges->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  largest->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(largest->GetOutput()->GetPoints());
  surface->SetPolys(largest->GetOutput()->GetPolys());
  return surface;
}

struct Vertex {
  glm::dvec3 at_mm;
  glm::dvec3 outward;
};

/// A triangle mesh that is finer where the body is more curved than the grid can tell: fingers, lips, ears, a navel.
class Refinement {
 public:
  Refinement(const BodyShape& body, vtkPolyData& coarse) : body_(body) {
    vertices_.resize(static_cast<std::size_t>(coarse.GetNumberOfPoints()));
    for (std::size_t n = 0; n < vertices_.size(); ++n) coarse.GetPoint(static_cast<vtkIdType>(n), &vertices_[n].at_mm.x);
    triangles_.reserve(static_cast<std::size_t>(coarse.GetNumberOfPolys()));
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < coarse.GetNumberOfPolys(); ++cell) {
      coarse.GetPolys()->GetCellAtId(cell, corners);
      triangles_.push_back({static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)), static_cast<int>(corners->GetId(2))});
    }
  }

  /// Normals of the vertices from `first` on. @return false when cancelled
  [[nodiscard]] bool face(std::size_t first, Progress& progress) {
    return forEachPiece(vertices_.size() - first, progress,
                        [&](std::size_t n) { vertices_[first + n].outward = outwardNormal(body_, vertices_[first + n].at_mm); });
  }

  /// Splits edges whose middle lies off the body or along which the body turns much. Both triangles at an edge split it or neither does,
  /// so the surface stays closed. @return false when cancelled
  [[nodiscard]] bool split(Progress& progress) {
    std::vector<std::pair<int, int>> edges;
    edges.reserve(3 * triangles_.size() / 2);
    for (const glm::ivec3& t : triangles_)
      for (int side = 0; side < 3; ++side)
        if (t[side] < t[(side + 1) % 3]) edges.emplace_back(t[side], t[(side + 1) % 3]);
    std::vector<std::optional<glm::dvec3>> middles(edges.size());
    const auto middleOf = [&](std::size_t n) -> std::optional<glm::dvec3> {
      const Vertex &from = vertices_[static_cast<std::size_t>(edges[n].first)], &to = vertices_[static_cast<std::size_t>(edges[n].second)];
      glm::dvec3 p = 0.5 * (from.at_mm + to.at_mm);
      const double off_mm = body_.signedDistance_mm(p);
      if (std::abs(off_mm) < kMostOff_mm && glm::dot(from.outward, to.outward) > kLeastAlike) return std::nullopt;
      for (int step = 0; step < 3; ++step) p -= body_.signedDistance_mm(p) * outwardNormal(body_, p);
      // A step that leads far away is not a middle: the body has a crease there, and the edge may as well stay.
      const double length_mm = glm::distance(from.at_mm, to.at_mm);
      return glm::distance(p, 0.5 * (from.at_mm + to.at_mm)) < 0.5 * length_mm ? std::optional(p) : std::nullopt;
    };
    if (!forEachPiece(edges.size(), progress, [&](std::size_t n) { middles[n] = middleOf(n); })) return false;
    std::unordered_map<std::uint64_t, int> added;
    const std::size_t before = vertices_.size();
    for (std::size_t n = 0; n < edges.size(); ++n) {
      if (!middles[n]) continue;
      added.emplace(keyOf(edges[n].first, edges[n].second), static_cast<int>(vertices_.size()));
      vertices_.push_back({*middles[n], {}});
    }
    std::vector<glm::ivec3> finer;
    finer.reserve(triangles_.size() + 2 * added.size());
    for (const glm::ivec3& t : triangles_) addParts(t, added, finer);
    triangles_ = std::move(finer);
    return face(before, progress);
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> mesh() const {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(vertices_.size()));
    points->SetNumberOfPoints(static_cast<vtkIdType>(vertices_.size()));
    for (std::size_t n = 0; n < vertices_.size(); ++n) {
      points->SetPoint(static_cast<vtkIdType>(n), &vertices_[n].at_mm.x);
      normals->SetTuple(static_cast<vtkIdType>(n), &vertices_[n].outward.x);
    }
    vtkNew<vtkCellArray> cells;
    for (const glm::ivec3& t : triangles_) {
      const vtkIdType ids[3] = {t[0], t[1], t[2]};
      cells->InsertNextCell(3, ids);
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(cells);
    surface->GetPointData()->SetNormals(normals);
    return surface;
  }

 private:
  static constexpr double kMostOff_mm = 0.3;
  static constexpr double kLeastAlike = 0.91;  ///< cosine of 24 degrees

  static std::uint64_t keyOf(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | static_cast<std::uint64_t>(std::max(a, b));
  }

  /// The triangle, or the two to four it becomes; all keep its winding.
  static void addParts(const glm::ivec3& t, const std::unordered_map<std::uint64_t, int>& added, std::vector<glm::ivec3>& finer) {
    int middle[3];
    int count = 0;
    for (int side = 0; side < 3; ++side) {
      const auto found = added.find(keyOf(t[side], t[(side + 1) % 3]));
      middle[side] = found == added.end() ? -1 : found->second;
      count += middle[side] >= 0 ? 1 : 0;
    }
    if (count == 0) return finer.push_back(t);
    // Turned so that with one split edge it is the first, and with two the last is whole.
    int first = 0;
    while (!(count == 3 || (count == 1 && middle[first] >= 0) || (count == 2 && middle[(first + 2) % 3] < 0))) ++first;
    const int a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
    const int ab = middle[first], bc = middle[(first + 1) % 3], ca = middle[(first + 2) % 3];
    if (count == 1) {
      finer.insert(finer.end(), {{a, ab, c}, {ab, b, c}});
    } else if (count == 2) {
      finer.insert(finer.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    } else {
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }

  template <class Work>
  static bool forEachPiece(std::size_t count, Progress& progress, const Work& work) {
    constexpr std::size_t kPiece = 1024;
    return forEachTask(static_cast<int>((count + kPiece - 1) / kPiece), 0, progress, say<"Making the skin">(), [&](int piece) {
      const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
      for (std::size_t n = first; n < std::min(count, first + kPiece); ++n) work(n);
    });
  }

  const BodyShape& body_;
  std::vector<Vertex> vertices_;
  std::vector<glm::ivec3> triangles_;
};

}  // namespace

Result<Mannequin> polygonise(const BodyShape& body, const MannequinOptions& options, Progress& progress) {
  EW_EXPECTS(options.cell_mm > 0.0);
  const Bounds bounds = body.bounds();
  const glm::dvec3 extent_mm = bounds.highest_mm - bounds.lowest_mm;
  if (!(extent_mm.x > 0.0 && extent_mm.y > 0.0 && extent_mm.z > 0.0) || glm::any(glm::greaterThan(extent_mm, glm::dvec3(5000.0))))
    return failure(ErrorCode::badField, say<"The body's bounds are empty or larger than 5 m; give the recipe parts in millimetres.">());
  Grid grid;
  grid.spacing_mm = glm::dvec3(options.cell_mm);
  grid.origin_mm = bounds.lowest_mm - 2.0 * options.cell_mm;
  const glm::dvec3 cells = glm::ceil(extent_mm / options.cell_mm) + 5.0;
  if (cells.x * cells.y * cells.z > 500e6)
    return failure(ErrorCode::tooLarge, say<"The body would be sampled at more than 500 million places; choose a larger cell size.">());
  grid.dims = glm::ivec3(cells);
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Making the body was cancelled.">()); };
  std::vector<float> inside_mm;
  PartOfProgress sampling(progress, 0.0, 0.6);
  if (auto sampled = sampleDistance(body, grid, inside_mm, 0, sampling); !sampled) return passOn(sampled.error());
  for (float& distance_mm : inside_mm) distance_mm = -distance_mm;  // contour filters take larger values to be inside
  Mannequin result;
  result.surface = contour(grid, inside_mm);
  if (result.surface->GetNumberOfPolys() == 0)
    return failure(ErrorCode::emptyVolume, say<"The body has no surface inside its bounds; check the parts of its recipe.">());
  if (progress.cancelRequested()) return cancelled();
  Refinement finer(body, *result.surface);
  PartOfProgress facing(progress, 0.6, 0.75), once(progress, 0.75, 0.85), twice(progress, 0.85, 0.9);
  if (!finer.face(0, facing) || !finer.split(once) || !finer.split(twice)) return cancelled();
  result.surface = finer.mesh();
  double box[6];
  result.surface->GetBounds(box);
  result.bounds = {{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  result.skin = makeMeshSkin(result.surface);
  progress.report(say<"Making the skin">(), 1.0);
  return result;
}

}  // namespace ew::bridge
