#include "ew/bridge/convert.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "ew/core/contract.h"
#include "ew/phantom/patient.h"

namespace ew::bridge {

void copyTo(vtkMatrix4x4& target, const glm::dmat4& matrix) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) target.SetElement(row, column, matrix[column][row]);
}

vtkSmartPointer<vtkMatrix4x4> toVtk(const glm::dmat4& matrix) {
  auto result = vtkSmartPointer<vtkMatrix4x4>::New();
  copyTo(*result, matrix);
  return result;
}

glm::dmat4 toGlm(const vtkMatrix4x4& matrix) {
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) result[column][row] = matrix.GetElement(row, column);
  return result;
}

vtkSmartPointer<vtkImageData> toVtk(const VolumeView<const std::uint8_t>& voxels) {
  const Grid& grid = voxels.grid;
  EW_EXPECTS(voxels.data != nullptr && checkGrid(grid).has_value());
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("echo");
  // VTK has no array of constant values; `save` = 1 keeps it from freeing what is not its own.
  array->SetArray(const_cast<unsigned char*>(voxels.data), static_cast<vtkIdType>(grid.voxelCount()), 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.dims.x, grid.dims.y, grid.dims.z);
  image->SetSpacing(grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z);
  image->SetOrigin(grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z);
  const glm::dmat3& d = grid.directions;
  image->SetDirectionMatrix(d[0].x, d[1].x, d[2].x, d[0].y, d[1].y, d[2].y, d[0].z, d[1].z, d[2].z);
  image->GetPointData()->SetScalars(array);
  return image;
}

vtkSmartPointer<vtkImageData> toVtk(std::shared_ptr<const Volume> volume) {
  EW_EXPECTS(volume != nullptr && volume->echo.size() == volume->grid.voxelCount());
  auto image = toVtk(volume->view());
  // The array's end releases the share: an observer owns it, because the array itself only knows how to free memory.
  auto keeper = vtkSmartPointer<vtkCallbackCommand>::New();
  keeper->SetClientData(new std::shared_ptr<const Volume>(std::move(volume)));
  keeper->SetClientDataDeleteCallback([](void* share) { delete static_cast<std::shared_ptr<const Volume>*>(share); });
  image->GetPointData()->GetScalars()->AddObserver(vtkCommand::DeleteEvent, keeper);
  return image;
}

Result<Volume> toVolume(vtkImageData& image) {
  if (image.GetNumberOfPoints() <= 0) return failure(ErrorCode::emptyVolume, say<"The image has no voxels; give one that has.">());
  auto* scalars = vtkUnsignedCharArray::SafeDownCast(image.GetPointData()->GetScalars());
  if (scalars == nullptr || scalars->GetNumberOfComponents() != 1)
    return failure(ErrorCode::unsupported,
                   say<"The image does not hold one 8-bit grey value per voxel; convert it to unsigned char first.">());
  Volume volume;
  int extent[6];
  image.GetExtent(extent);
  glm::dmat3& directions = volume.grid.directions;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) directions[column][row] = image.GetDirectionMatrix()->GetElement(row, column);
  const double* spacing = image.GetSpacing();
  const double* origin = image.GetOrigin();
  volume.grid.spacing_mm = {spacing[0], spacing[1], spacing[2]};
  volume.grid.dims = {extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, extent[5] - extent[4] + 1};
  volume.grid.origin_mm =
      glm::dvec3(origin[0], origin[1], origin[2]) + directions * (volume.grid.spacing_mm * glm::dvec3(extent[0], extent[2], extent[4]));
  if (const auto checked = checkGrid(volume.grid); !checked) return passOn(checked.error());
  if (static_cast<std::size_t>(scalars->GetNumberOfValues()) != volume.grid.voxelCount())
    return failure(ErrorCode::badHeader, say<"The image holds another number of voxels than its dimensions say; make it again.">());
  const unsigned char* first = scalars->GetPointer(0);
  volume.echo.assign(first, first + volume.grid.voxelCount());
  return volume;
}

vtkSmartPointer<vtkPolyData> toVtk(const SurfaceMesh& mesh) {
  EW_EXPECTS(mesh.normals.size() == mesh.points_mm.size());
  const auto vectors = [](const std::vector<glm::vec3>& from) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(from.size()));
    for (std::size_t i = 0; i < from.size(); ++i) array->SetTuple3(static_cast<vtkIdType>(i), from[i].x, from[i].y, from[i].z);
    return array;
  };
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(vectors(mesh.points_mm));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateEstimate(static_cast<vtkIdType>(mesh.triangles.size()), 3);
  for (const glm::ivec3& triangle : mesh.triangles) {
    const vtkIdType corners[3] = {triangle.x, triangle.y, triangle.z};
    cells->InsertNextCell(3, corners);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  auto normals = vectors(mesh.normals);
  normals->SetName("Normals");
  result->GetPointData()->SetNormals(normals);
  return result;
}

}  // namespace ew::bridge
