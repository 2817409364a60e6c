#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
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
#include <atomic>
#include <cmath>
#include <vector>

#include "ew/bridge/mannequin.h"
#include "ew/bridge/mesh_skin.h"
#include "ew/core/contract.h"
#include "ew/phantom/patient.h"

namespace ew::bridge {
namespace {

constexpr int kBlock = 8;

struct Field {
  glm::ivec3 dims{0};
  glm::dvec3 origin_mm{0.0};
  double cell_mm = 0.0;
  std::vector<float> inside_mm;  ///< negated distance, because contour filters take larger values to be inside
};

/// One sample decides a block of 8 x 8 x 8 that lies far from the surface; a blended field may be off by its blends, hence the margin.
void fillBlock(const BodyShape& body, Field& field, const glm::ivec3& low) {
  const glm::ivec3 high = glm::min(low + kBlock, field.dims);
  const auto place = [&](const glm::dvec3& at) { return field.origin_mm + field.cell_mm * at; };
  const double toCorner_mm = field.cell_mm * 0.5 * glm::length(glm::dvec3(kBlock));
  const double middle_mm = -body.signedDistance_mm(place(0.5 * glm::dvec3(low + high - 1)));
  const bool far = std::abs(middle_mm) > 1.5 * toCorner_mm + 2.0 * field.cell_mm;
  for (int k = low.z; k < high.z; ++k)
    for (int j = low.y; j < high.y; ++j) {
      const std::size_t row = (static_cast<std::size_t>(k) * static_cast<std::size_t>(field.dims.y) + static_cast<std::size_t>(j)) *
                              static_cast<std::size_t>(field.dims.x);
      for (int i = low.x; i < high.x; ++i)
        field.inside_mm[row + static_cast<std::size_t>(i)] =
            static_cast<float>(far ? middle_mm : -body.signedDistance_mm(place(glm::dvec3(i, j, k))));
    }
}

/// @return false when it was cancelled
bool sample(const BodyShape& body, Field& field, Progress& progress) {
  const glm::ivec3 blocks = (field.dims + kBlock - 1) / kBlock;
  std::atomic<bool> stopped{false};
  oneapi::tbb::parallel_for(0, blocks.z * blocks.y, [&](int row) {
    if (stopped.load(std::memory_order_relaxed)) return;
    if (progress.cancelRequested()) {
      stopped = true;
      return;
    }
    for (int i = 0; i < blocks.x; ++i) fillBlock(body, field, kBlock * glm::ivec3(i, row % blocks.y, row / blocks.y));
  });
  progress.report("Shaping the body", 0.6);
  return !stopped;
}

glm::dvec3 outwardAt(const BodyShape& body, const glm::dvec3& p_mm) {
  constexpr double kStep_mm = 0.5;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = kStep_mm;
    gradient[axis] = body.signedDistance_mm(p_mm + step) - body.signedDistance_mm(p_mm - step);
  }
  const double length = glm::length(gradient);
  return length > 0.0 ? gradient / length : glm::dvec3(0.0, -1.0, 0.0);
}

vtkSmartPointer<vtkPolyData> contour(Field& field) {
  vtkNew<vtkFloatArray> values;
  values->SetArray(field.inside_mm.data(), static_cast<vtkIdType>(field.inside_mm.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(field.dims.x, field.dims.y, field.dims.z);
  image->SetSpacing(field.cell_mm, field.cell_mm, field.cell_mm);
  image->SetOrigin(field.origin_mm.x, field.origin_mm.y, field.origin_mm.z);
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
    return failure(ErrorCode::badField, "The body's bounds are empty or larger than 5 m; give the recipe parts in millimetres.");
  Field field;
  field.cell_mm = options.cell_mm;
  field.origin_mm = bounds.lowest_mm - 2.0 * options.cell_mm;
  field.dims = glm::ivec3(glm::ceil(extent_mm / options.cell_mm)) + 5;
  const double cells = static_cast<double>(field.dims.x) * field.dims.y * field.dims.z;
  if (cells > 500e6)
    return failure(ErrorCode::tooLarge, "The body would be sampled at more than 500 million places; choose a larger cell size.");
  field.inside_mm.resize(static_cast<std::size_t>(cells));
  const auto cancelled = [] { return failure(ErrorCode::cancelled, "Making the body was cancelled."); };
  progress.report("Shaping the body", 0.0);
  if (!sample(body, field, progress)) return cancelled();
  Mannequin result;
  result.surface = contour(field);
  vtkPolyData& surface = *result.surface;
  if (surface.GetNumberOfPolys() == 0)
    return failure(ErrorCode::emptyVolume, "The body has no surface inside its bounds; check the parts of its recipe.");
  if (progress.cancelRequested()) return cancelled();
  const vtkIdType count = surface.GetNumberOfPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  float* out = normals->GetPointer(0);
  vtkPoints& points = *surface.GetPoints();
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<vtkIdType>(0, count), [&](const auto& range) {
    for (vtkIdType id = range.begin(); id != range.end(); ++id) {
      glm::dvec3 p;
      points.GetPoint(id, &p.x);
      const glm::dvec3 outward = outwardAt(body, p);
      for (int axis = 0; axis < 3; ++axis) out[3 * id + axis] = static_cast<float>(outward[axis]);
    }
  });
  surface.GetPointData()->SetNormals(normals);
  progress.report("Making the skin", 0.85);
  if (progress.cancelRequested()) return cancelled();
  double box[6];
  surface.GetBounds(box);
  result.bounds = {{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  result.skin = makeMeshSkin(result.surface);
  progress.report("Making the skin", 1.0);
  return result;
}

}  // namespace ew::bridge
