#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>

#include <algorithm>
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
  vtkPolyData& surface = *result.surface;
  if (surface.GetNumberOfPolys() == 0)
    return failure(ErrorCode::emptyVolume, say<"The body has no surface inside its bounds; check the parts of its recipe.">());
  if (progress.cancelRequested()) return cancelled();
  const vtkIdType count = surface.GetNumberOfPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  float* out = normals->GetPointer(0);
  vtkPoints& points = *surface.GetPoints();
  constexpr vtkIdType kPiece = 1024;
  PartOfProgress smoothing(progress, 0.6, 0.85);
  const bool finished =
      forEachTask(static_cast<int>((count + kPiece - 1) / kPiece), 0, smoothing, say<"Making the skin">(), [&](int piece) {
        for (vtkIdType id = piece * kPiece; id < std::min(count, (piece + 1) * kPiece); ++id) {
          glm::dvec3 p;
          points.GetPoint(id, &p.x);
          const glm::dvec3 outward = outwardNormal(body, p);
          for (int axis = 0; axis < 3; ++axis) out[3 * id + axis] = static_cast<float>(outward[axis]);
        }
      });
  if (!finished) return cancelled();
  surface.GetPointData()->SetNormals(normals);
  double box[6];
  surface.GetBounds(box);
  result.bounds = {{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  result.skin = makeMeshSkin(result.surface);
  progress.report(say<"Making the skin">(), 1.0);
  return result;
}

}  // namespace ew::bridge
