#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/image.h"
#include "ew/imaging/frame.h"

class vtkActor;
class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;

namespace ew::bridge {

/// The fan of the probe: its outline as a pane with the live image on it, and its edge as a line. A zoomed image covers a part of the
/// pane: the rest stays empty, and the image's own border is drawn on it.
class FanImage {
 public:
  FanImage();
  ~FanImage();

  void addTo(vtkRenderer& renderer);
  void setOutline(const Probe& probe, double depth_mm, const Knobs& knobs);
  /// An image wider than kTextureLimit_px is halved: the pane is never that large on the screen.
  void setImage(const DisplayImage& image, const DisplayGeometry& geometry);
  void clearImage();
  void setAccent(const glm::dvec3& accent);
  void setVisible(bool visible);
  void setProbeToWorld(vtkMatrix4x4* matrix);

  /// Corners of the pane as it is drawn: the points of its mesh under its actor's matrix.
  [[nodiscard]] std::vector<glm::dvec3> corners_mm() const;

 private:
  void updateTextureCoordinates();
  void updateFrame();
  void showTexture(bool show);

  static constexpr int kTextureLimit_px = 640;
  vtkNew<vtkActor> pane_;
  vtkNew<vtkActor> edge_;
  vtkNew<vtkPolyData> paneMesh_;
  vtkNew<vtkPolyData> edgeMesh_;
  vtkNew<vtkActor> frame_;  ///< border of a zoomed image
  vtkNew<vtkPolyData> frameMesh_;
  vtkNew<vtkImageData> pixels_;
  vtkNew<vtkTexture> texture_;
  vtkSmartPointer<vtkMatrix4x4> probeToWorld_;
  std::vector<glm::dvec2> outline_mm_;
  DisplayGeometry geometry_;
  bool hasImage_ = false;
  glm::dvec3 accent_{0.31, 0.71, 0.75};
};

}  // namespace ew::bridge
