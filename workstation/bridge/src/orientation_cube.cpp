#include "orientation_cube.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

namespace ew::bridge {
namespace {

constexpr double kShare = 0.16;  // of the window's shorter side
constexpr int kLeast_px = 56;
constexpr int kMost_px = 120;
constexpr int kMargin_px = 6;

/// VTK's own makes its letters and their edges anew with every drawing, which takes 3 ms; this one does so once something of it was
/// changed.
class StillCube final : public vtkAnnotatedCubeActor {
 public:
  static StillCube* New();
  int RenderOpaqueGeometry(vtkViewport* viewport) override {
    return isMade() ? this->GetAssembly()->RenderOpaqueGeometry(viewport) : this->Superclass::RenderOpaqueGeometry(viewport);
  }
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override {
    return isMade() ? this->GetAssembly()->RenderTranslucentPolygonalGeometry(viewport)
                    : this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
  }
  vtkTypeBool HasTranslucentPolygonalGeometry() override {
    return isMade() ? this->GetAssembly()->HasTranslucentPolygonalGeometry() : this->Superclass::HasTranslucentPolygonalGeometry();
  }

 private:
  [[nodiscard]] bool isMade() { return std::exchange(madeAt_, this->GetMTime()) == this->GetMTime(); }

  vtkMTimeType madeAt_ = 0;

  vtkTypeMacro(StillCube, vtkAnnotatedCubeActor)
};
vtkStandardNewMacro(StillCube)

}  // namespace

OrientationCube::OrientationCube() : cube_(vtkSmartPointer<StillCube>::New()) {
  cube_->SetXPlusFaceText("L");  // the world is LPS
  cube_->SetXMinusFaceText("R");
  cube_->SetYPlusFaceText("P");
  cube_->SetYMinusFaceText("A");
  cube_->SetZPlusFaceText("H");
  cube_->SetZMinusFaceText("F");
  // Letters stand upright, on the head's side as seen from the front.
  cube_->SetXFaceTextRotation(0.0);
  cube_->SetYFaceTextRotation(0.0);
  cube_->SetZFaceTextRotation(0.0);
  cube_->SetFaceTextScale(0.62);
  cube_->GetTextEdgesProperty()->SetLineWidth(1.0F);
  cube_->GetCubeProperty()->SetAmbient(0.35);
  cube_->GetCubeProperty()->SetDiffuse(0.70);
  view_->ParallelProjectionOn();
  view_->SetParallelScale(0.92);
  corner_->SetActiveCamera(view_);
  corner_->InteractiveOff();
  corner_->AddActor(cube_);
}

void OrientationCube::addTo(vtkRenderWindow& window, int layer) {
  corner_->SetLayer(layer);
  window.AddRenderer(corner_);
}

void OrientationCube::removeFrom(vtkRenderWindow& window) { window.RemoveRenderer(corner_); }

void OrientationCube::setColours(const glm::dvec3& side, const glm::dvec3& letter, const glm::dvec3& edge) {
  cube_->GetCubeProperty()->SetColor(side.r, side.g, side.b);
  cube_->GetTextEdgesProperty()->SetColor(edge.r, edge.g, edge.b);
  for (vtkProperty* text : {cube_->GetXPlusFaceProperty(), cube_->GetXMinusFaceProperty(), cube_->GetYPlusFaceProperty(),
                            cube_->GetYMinusFaceProperty(), cube_->GetZPlusFaceProperty(), cube_->GetZMinusFaceProperty()}) {
    text->SetColor(letter.r, letter.g, letter.b);
    text->LightingOff();
  }
}

void OrientationCube::look(const glm::dvec3& forward, const glm::dvec3& up, glm::ivec2 window_px) {
  const glm::dvec3 from = -4.0 * forward;
  view_->SetFocalPoint(0.0, 0.0, 0.0);
  view_->SetPosition(from.x, from.y, from.z);
  view_->SetViewUp(up.x, up.y, up.z);
  view_->SetClippingRange(1.0, 8.0);
  const int side_px = OrientationCube::side_px(window_px) - 2 * kMargin_px;
  const double width = std::max(1, window_px.x), height = std::max(1, window_px.y);
  corner_->SetViewport(std::max(0.0, (window_px.x - kMargin_px - side_px) / width), kMargin_px / height,
                       std::max(0.01, (window_px.x - kMargin_px) / width), std::min(1.0, (kMargin_px + side_px) / height));
}

int OrientationCube::side_px(glm::ivec2 window_px) {
  return std::clamp(static_cast<int>(kShare * std::min(window_px.x, window_px.y)), kLeast_px, kMost_px) + 2 * kMargin_px;
}

void OrientationCube::setSmooth(bool smooth) { corner_->SetUseFXAA(smooth); }

}  // namespace ew::bridge
