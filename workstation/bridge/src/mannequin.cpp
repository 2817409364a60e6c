#include "ew/bridge/mannequin.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "ew/bridge/mesh_skin.h"
#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/phantom/patient.h"
#include "mesh_file.h"

namespace ew::bridge {
namespace {

/// Six times the volume the triangles enclose; negative when they face inwards. Taken about the first corner, which keeps the digits
/// of a body far from the origin.
double enclosed(vtkPolyData& mesh) {
  double sum = 0.0;
  glm::dvec3 about;
  mesh.GetPoint(0, &about.x);
  auto* cells = mesh.GetPolys();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    glm::dvec3 p[3];
    for (int corner = 0; corner < 3; ++corner) mesh.GetPoint(ids[corner], &p[corner].x);
    sum += glm::dot(p[0] - about, glm::cross(p[1] - about, p[2] - about));
  }
  return sum;
}

/// One body's size in mm, or why the coordinates cannot be a body.
Result<void> scaleToMm(vtkPolyData& mesh, const std::string& file, std::vector<Message>& notes) {
  double box[6];
  mesh.GetBounds(box);
  const double largest = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]});
  double factor = 1.0;
  if (largest >= 0.5 && largest <= 2.5) {
    factor = 1000.0;
    notes.push_back(say<"The mesh measures %1 units, so it was taken to be in metres and scaled to millimetres.">(
        textOf(std::round(largest * 1000.0) / 1000.0)));
  }
  const double largest_mm = largest * factor;
  if (!(largest_mm >= 100.0 && largest_mm <= 5000.0))
    return failure(
        ErrorCode::badField,
        say<"The mesh measures %1 units, which is no body in millimetres or metres; scale it so that its height in millimetres is right.">(
            textOf(largest)),
        {{"file", file}});
  if (factor != 1.0) {
    vtkPoints& points = *mesh.GetPoints();
    for (vtkIdType id = 0; id < points.GetNumberOfPoints(); ++id) {
      glm::dvec3 p;
      points.GetPoint(id, &p.x);
      p *= factor;
      points.SetPoint(id, &p.x);
    }
    points.Modified();
  }
  return {};
}

Result<Mannequin> fromMesh(const std::filesystem::path& file, const std::string& ending, Progress& progress) {
  progress.report(say<"Reading the mesh">(), 0.0);
  auto read = readMeshFile(file, ending);
  if (!read) return passOn(read.error());
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Reading the mesh was cancelled.">()); };
  if (progress.cancelRequested()) return cancelled();
  Mannequin result;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(*read);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkCleanPolyData> merged;  // a file may repeat a corner for each triangle; smooth shading needs them shared
  merged->SetInputConnection(triangles->GetOutputPort());
  merged->ConvertPolysToLinesOff();
  merged->ConvertStripsToPolysOff();
  merged->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(merged->GetOutput()->GetPoints());
  bare->SetPolys(merged->GetOutput()->GetPolys());
  if (bare->GetNumberOfPolys() == 0)
    return failure(ErrorCode::emptyVolume, say<"%1 has no triangles; export the body as a surface mesh.">(file.filename().string()),
                   {{"file", file.string()}});
  if (const auto scaled = scaleToMm(*bare, file.string(), result.notes); !scaled) return passOn(scaled.error());
  progress.report(say<"Reading the mesh">(), 0.5);
  if (progress.cancelRequested()) return cancelled();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(bare);
  normals->SplittingOff();
  normals->ConsistencyOn();
  normals->ComputePointNormalsOn();
  normals->Update();
  vtkSmartPointer<vtkPolyData> surface = normals->GetOutput();
  if (enclosed(*surface) < 0.0) {
    vtkNew<vtkPolyDataNormals> turned;
    turned->SetInputData(bare);
    turned->SplittingOff();
    turned->ConsistencyOn();
    turned->FlipNormalsOn();
    turned->Update();
    surface = turned->GetOutput();
    if (enclosed(*surface) < 0.0) {  // this VTK flips the normals only; then the winding is turned here
      vtkNew<vtkCellArray> reversed;
      auto* cells = surface->GetPolys();
      for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(cell, count, ids);
        const vtkIdType back[3] = {ids[2], ids[1], ids[0]};
        reversed->InsertNextCell(3, back);
      }
      surface->SetPolys(reversed);
    }
    result.notes.emplace_back(say<"The triangles faced inwards and were turned.">());
  }
  result.surface = surface;
  progress.report(say<"Making the skin">(), 0.8);
  if (progress.cancelRequested()) return cancelled();
  double box[6];
  surface->GetBounds(box);
  result.bounds = {{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  result.skin = makeMeshSkin(result.surface);
  progress.report(say<"Making the skin">(), 1.0);
  return result;
}

}  // namespace

SkinVertices skinVerticesOf(const Mannequin& mannequin) {
  SkinVertices vertices;
  vtkPolyData& surface = *mannequin.surface;
  vtkDataArray& normals = *surface.GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < surface.GetNumberOfPoints(); ++id) {
    glm::dvec3 at, outward;
    surface.GetPoint(id, &at.x);
    normals.GetTuple(id, &outward.x);
    vertices.points_mm.emplace_back(at);
    vertices.outward.emplace_back(outward);
  }
  return vertices;
}

Result<Mannequin> loadMannequin(const std::filesystem::path& file, const MannequinOptions& options, Progress& progress) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem))
    return failure(ErrorCode::notFound, say<"There is no file %1; choose a mannequin recipe or a mesh.">(file.string()),
                   {{"file", file.string()}});
  const std::string ending = endingOf(file);
  try {
    if (ending == ".json") {
      auto body = readBodyShape(file);
      if (!body) return passOn(body.error());
      return polygonise(**body, options, progress);
    }
    if (ending == ".stl" || ending == ".ply" || ending == ".obj") return fromMesh(file, ending, progress);
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge,
                   say<"There is not enough memory for %1; use a mesh with fewer triangles.">(file.filename().string()),
                   {{"file", file.string()}});
  }
  return failure(ErrorCode::unsupported,
                 say<"A mannequin is a recipe (.json) or a mesh (.stl, .ply, .obj), and %1 is neither.">(file.filename().string()),
                 {{"file", file.string()}});
}

}  // namespace ew::bridge
