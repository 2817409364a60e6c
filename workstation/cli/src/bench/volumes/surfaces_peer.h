#pragma once

#include <memory>

#include "ew/core/volume.h"
#include "ew/labelling/label_surfaces.h"

namespace ew {

/// VTK's surfaces of the same voxels in the same memory: vtkDiscreteFlyingEdges3D for all labels, then vtkWindowedSincPolyDataFilter with
/// 20 iterations and a pass band of 0.05. Each label has a surface of its own, so where two touch there are two.
class PeerSurfaces {
 public:
  /// @param labels must outlive it
  explicit PeerSurfaces(const Volume& labels);
  ~PeerSurfaces();
  /// Makes them anew.
  void make();
  /// What was made last, in our shape.
  [[nodiscard]] labelling::LabelSurfaces made() const;

 private:
  struct Filters;
  std::unique_ptr<Filters> filters_;
};

}  // namespace ew
