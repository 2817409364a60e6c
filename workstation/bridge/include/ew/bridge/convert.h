#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "ew/core/volume.h"

class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;

namespace ew {
struct SurfaceMesh;
}

/// The only place where our values become VTK's and back. GLM is column-major, vtkMatrix4x4 row-major.
namespace ew::bridge {

[[nodiscard]] vtkSmartPointer<vtkMatrix4x4> toVtk(const glm::dmat4& matrix);
void copyTo(vtkMatrix4x4& target, const glm::dmat4& matrix);
[[nodiscard]] glm::dmat4 toGlm(const vtkMatrix4x4& matrix);

/// An image that shares the volume's voxels without copying and keeps the volume alive as long as the image's own array lives. The
/// array is not to be written through.
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(std::shared_ptr<const Volume> volume);

/// The same without ownership: `voxels` must outlive the image.
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(const VolumeView<const std::uint8_t>& voxels);

/// A copy of an image's unsigned char scalars with its grid (extent start and direction matrix included); coverage stays empty.
/// @error emptyVolume, unsupported (other scalars than one unsigned char component), and those of checkGrid
[[nodiscard]] Result<Volume> toVolume(vtkImageData& image);

/// Triangles with normals; the mesh's sizes must agree.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toVtk(const SurfaceMesh& mesh);

}  // namespace ew::bridge
