#pragma once

#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include "ew/imaging/probe.h"

class vtkPolyData;

namespace ew::bridge {

struct ProbeColours {
  glm::dvec3 housing{0.9};
  glm::dvec3 lens{0.4};
  glm::dvec3 marker{0.3, 0.7, 0.75};
  glm::dvec3 cable{0.35};
};

/// The housing of a probe in its own frame (mm): face around the origin looking along +y, handle and cable towards -y, marker ridge on
/// the +x side. Triangles with unit point normals and an unsigned char colour per point.
[[nodiscard]] vtkSmartPointer<vtkPolyData> probeModel(const Probe& probe, const ProbeColours& colours);

/// From the face to the end of the handle, without cable.
[[nodiscard]] double housingLength_mm(const Probe& probe);

}  // namespace ew::bridge
