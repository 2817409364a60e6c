#pragma once

#include <vtkNew.h>

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "ew/bridge/handles.h"

class vtkActor;
class vtkMatrix4x4;
class vtkRenderer;

namespace ew::bridge {

/// Three arrows and three rings, in a layer before all others.
class HandlesModel {
 public:
  HandlesModel();
  ~HandlesModel();

  [[nodiscard]] vtkRenderer& layer() { return *layer_; }
  void setPlace(const HandlesPlace& place, const glm::dvec3& eye_mm);
  /// @param axes a colour for each axis @param used of the handle in use, which the others stand back from
  void setColours(const std::array<glm::dvec3, 3>& axes, const glm::dvec3& used);
  void setUsed(const std::optional<Handle>& used);

 private:
  void colour();

  vtkNew<vtkRenderer> layer_;
  vtkNew<vtkMatrix4x4> unitToWorld_;
  std::array<vtkNew<vtkActor>, 6> actors_;  ///< arrows along x, y, z, then rings
  std::array<glm::dvec3, 3> axes_{};
  glm::dvec3 usedColour_{1.0};
  std::optional<Handle> used_;
};

}  // namespace ew::bridge
