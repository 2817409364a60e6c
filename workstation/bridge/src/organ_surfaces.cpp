#include "ew/bridge/organ_surfaces.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSmartPointer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/bridge/convert.h"
#include "ew/core/contract.h"
#include "ew/core/label_colour.h"

namespace ew::bridge {
namespace {

constexpr double kPassBand = 0.05;
constexpr int kIterations = 20;

/// The box of voxels that have a number, one voxel wider, so that its surface is closed.
struct Box {
  glm::ivec3 lowest{0}, size{0};
};

/// Boxes of all 256 numbers in one walk.
std::array<Box, 256> boxesOf(const Volume& labels) {
  std::array<glm::ivec3, 256> lowest, highest;
  lowest.fill(glm::ivec3(1 << 30));
  highest.fill(glm::ivec3(-1));
  const glm::ivec3 dims = labels.grid.dims;
  std::size_t at = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i, ++at) {
        const std::uint8_t label = labels.echo[at];
        if (label == 0) continue;
        lowest[label] = glm::min(lowest[label], glm::ivec3(i, j, k));
        highest[label] = glm::max(highest[label], glm::ivec3(i, j, k));
      }
  std::array<Box, 256> boxes;
  for (std::size_t n = 1; n < boxes.size(); ++n)
    if (highest[n].x >= 0) boxes[n] = {lowest[n] - 1, highest[n] - lowest[n] + 3};
  return boxes;
}

/// One structure alone in an image of its box, in voxels of the whole.
vtkSmartPointer<vtkImageData> alone(const Volume& labels, const Box& box, int label) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(box.lowest.x, box.lowest.x + box.size.x - 1, box.lowest.y, box.lowest.y + box.size.y - 1, box.lowest.z,
                   box.lowest.z + box.size.z - 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* to = static_cast<std::uint8_t*>(image->GetScalarPointer());
  const glm::ivec3 dims = labels.grid.dims;
  for (int k = box.lowest.z; k < box.lowest.z + box.size.z; ++k)
    for (int j = box.lowest.y; j < box.lowest.y + box.size.y; ++j)
      for (int i = box.lowest.x; i < box.lowest.x + box.size.x; ++i, ++to) {
        const bool inside = i >= 0 && j >= 0 && k >= 0 && i < dims.x && j < dims.y && k < dims.z;
        const std::size_t at = sampleIndex(dims, i, j, k);
        *to = inside && labels.echo[at] == label ? 1 : 0;
      }
  return image;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const Volume& labels, const Box& box, int label, vtkMatrix4x4* voxelToWorld) {
  vtkNew<vtkDiscreteFlyingEdges3D> edges;
  edges->SetInputData(alone(labels, box, label));
  edges->SetValue(0, 1.0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(edges->GetOutputPort());
  smooth->SetNumberOfIterations(kIterations);
  smooth->SetPassBand(kPassBand);
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NormalizeCoordinatesOn();
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(voxelToWorld);
  vtkNew<vtkTransformPolyDataFilter> place;
  place->SetTransform(transform);
  place->SetInputConnection(smooth->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(place->GetOutputPort());
  normals->SplittingOff();
  normals->AutoOrientNormalsOn();
  normals->Update();
  vtkSmartPointer<vtkPolyData> made = normals->GetOutput();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(made->GetNumberOfPoints());
  const glm::dvec3 colour = colourOfLabel(label);
  for (int channel = 0; channel < 3; ++channel) colours->FillComponent(channel, std::round(255.0 * colour[channel]));
  made->GetPointData()->SetScalars(colours);
  return made;
}

}  // namespace

struct OrganSurfaces::Parts {
  vtkSmartPointer<vtkPolyData> mesh = vtkSmartPointer<vtkPolyData>::New();
  std::vector<int> labels;
};

OrganSurfaces::OrganSurfaces(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
OrganSurfaces::~OrganSurfaces() = default;
vtkPolyData* OrganSurfaces::mesh() const { return parts_->mesh; }
const std::vector<int>& OrganSurfaces::labels() const { return parts_->labels; }

Result<std::shared_ptr<const OrganSurfaces>> OrganSurfaces::of(const Volume& labels, const Grid& placed, std::vector<int> wanted,
                                                               Progress& progress) {
  EW_EXPECTS(placed.dims == labels.grid.dims);
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  auto parts = std::make_unique<Parts>();
  const auto boxes = boxesOf(labels);
  vtkNew<vtkMatrix4x4> voxelToWorld;
  const auto rows = rowsOf(placed.voxelToWorld().matrix);
  voxelToWorld->DeepCopy(rows.data());
  vtkNew<vtkAppendPolyData> all;
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    progress.report(say<"Making the organs' surfaces">(), static_cast<double>(n) / static_cast<double>(wanted.size()));
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Making the organs' surfaces was stopped.">());
    const int label = wanted[n];
    if (label < 1 || label > 255 || boxes[static_cast<std::size_t>(label)].size.x == 0) continue;
    all->AddInputData(surfaceOf(labels, boxes[static_cast<std::size_t>(label)], label, voxelToWorld));
    parts->labels.push_back(label);
  }
  if (!parts->labels.empty()) {
    all->Update();
    parts->mesh = all->GetOutput();
  }
  return std::shared_ptr<const OrganSurfaces>(new OrganSurfaces(std::move(parts)));
}

}  // namespace ew::bridge
