#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

class vtkAnnotatedCubeActor;
class vtkCamera;
class vtkRenderWindow;
class vtkRenderer;

namespace ew::bridge {

/// A cube in the lower right corner that turns with the body and names its sides as DICOM does: R and L the patient's right and left, A and
/// P front and back, H and F head and feet.
class OrientationCube {
 public:
  OrientationCube();
  void addTo(vtkRenderWindow& window, int layer);
  void removeFrom(vtkRenderWindow& window);
  void setColours(const glm::dvec3& side, const glm::dvec3& letter, const glm::dvec3& edge);
  /// As the scene's camera looks. @param window_px size of the window
  void look(const glm::dvec3& forward, const glm::dvec3& up, glm::ivec2 window_px);
  void setSmooth(bool smooth);
  /// Length of the corner's sides in a window of this size, with the margin around them.
  [[nodiscard]] static int side_px(glm::ivec2 window_px);

 private:
  vtkNew<vtkRenderer> corner_;
  vtkNew<vtkCamera> view_;
  vtkSmartPointer<vtkAnnotatedCubeActor> cube_;
};

}  // namespace ew::bridge
