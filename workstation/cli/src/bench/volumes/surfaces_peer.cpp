#include "bench/volumes/surfaces_peer.h"

#include <vtkCellArray.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <bitset>
#include <utility>

namespace ew {

struct PeerSurfaces::Filters {
  vtkNew<vtkImageData> image;
  vtkNew<vtkDiscreteFlyingEdges3D> edges;
  vtkNew<vtkWindowedSincPolyDataFilter> sinc;
};

PeerSurfaces::PeerSurfaces(const Volume& labels) : filters_(std::make_unique<Filters>()) {
  vtkNew<vtkUnsignedCharArray> voxels;
  // VTK takes a mutable pointer; the filters only read.
  voxels->SetArray(const_cast<unsigned char*>(labels.echo.data()), static_cast<vtkIdType>(labels.echo.size()), 1);
  filters_->image->SetDimensions(labels.grid.dims.x, labels.grid.dims.y, labels.grid.dims.z);
  filters_->image->GetPointData()->SetScalars(voxels);
  std::bitset<256> seen;
  for (const std::uint8_t each : labels.echo) seen.set(each);
  int contours = 0;
  for (std::size_t label = 1; label < seen.size(); ++label)
    if (seen[label]) filters_->edges->SetValue(contours++, static_cast<double>(label));
  filters_->edges->SetInputData(filters_->image);
  filters_->edges->ComputeNormalsOff();
  filters_->edges->ComputeGradientsOff();
  filters_->sinc->SetInputConnection(filters_->edges->GetOutputPort());
  filters_->sinc->SetNumberOfIterations(20);
  filters_->sinc->SetPassBand(0.05);
  filters_->sinc->BoundarySmoothingOff();
  filters_->sinc->FeatureEdgeSmoothingOff();
  filters_->sinc->NonManifoldSmoothingOn();
  filters_->sinc->NormalizeCoordinatesOn();
}

PeerSurfaces::~PeerSurfaces() = default;

void PeerSurfaces::make() {
  filters_->edges->Modified();
  filters_->sinc->Update();
}

labelling::LabelSurfaces PeerSurfaces::made() const {
  labelling::LabelSurfaces surfaces;
  vtkPolyData* const mesh = filters_->sinc->GetOutput();
  for (vtkIdType n = 0; n < mesh->GetNumberOfPoints(); ++n) {
    double p[3];
    mesh->GetPoint(n, p);
    surfaces.points_mm.emplace_back(p[0], p[1], p[2]);
  }
  std::bitset<256> seen;
  vtkDataArray* const labels = mesh->GetPointData()->GetScalars();
  vtkNew<vtkIdList> corners;
  double six = 0.0;
  for (vtkIdType n = 0; n < mesh->GetPolys()->GetNumberOfCells(); ++n) {
    mesh->GetPolys()->GetCellAtId(n, corners);
    surfaces.triangles.emplace_back(corners->GetId(0), corners->GetId(1), corners->GetId(2));
    const auto label = static_cast<std::uint8_t>(labels->GetTuple1(corners->GetId(0)));
    surfaces.sides.push_back({.front = 0, .back = label});
    seen.set(label);
    const auto at = [&](int corner) { return glm::dvec3(surfaces.points_mm[static_cast<std::size_t>(corners->GetId(corner))]); };
    six += glm::dot(at(0), glm::cross(at(1), at(2)));
  }
  if (six < 0.0)
    for (labelling::LabelSides& each : surfaces.sides) std::swap(each.front, each.back);
  for (std::size_t label = 1; label < seen.size(); ++label)
    if (seen[label]) surfaces.labels.push_back(static_cast<std::uint8_t>(label));
  return surfaces;
}

}  // namespace ew
