#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "ew/tracking/hand.h"

class vtkPolyData;

namespace ew::bridge {

struct MeshSkinOptions {
  double smoothing_mm = 18.0;  ///< radius over which normals are averaged: about half of a probe's face
};

/// A skin of triangles. Normals are the mean of the surface's own within `smoothing_mm` of the contact, weighted down to zero at that
/// distance and for parts that face away (the other side of a finger), so they change smoothly as the contact slides, over edges too.
/// @param triangles only triangles, consistently wound, counter-clockwise seen from outside; kept, and must not change afterwards
[[nodiscard]] std::shared_ptr<const Skin> makeMeshSkin(vtkSmartPointer<vtkPolyData> triangles, const MeshSkinOptions& options = {});

}  // namespace ew::bridge
