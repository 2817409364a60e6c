#include "ew/bridge/scene3d.h"

#include <vtkActor.h>
#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera.h"
#include "ew/bridge/convert.h"
#include "ew/bridge/handles.h"
#include "ew/bridge/organ_surfaces.h"
#include "ew/core/contract.h"
#include "fan_image.h"
#include "handles_model.h"
#include "layer_store.h"
#include "orientation_cube.h"
#include "probe_model.h"

namespace ew::bridge {
namespace {

void setColour(vtkProperty& property, const glm::dvec3& colour) { property.SetColor(colour.r, colour.g, colour.b); }

vtkSmartPointer<vtkLight> cameraLight(const glm::dvec3& from, const glm::dvec3& colour, double strength) {
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(colour.r, colour.g, colour.b);
  light->SetIntensity(strength);
  return light;
}

/// Distance between a ray and a segment, both in mm.
double distance_mm(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b) {
  double least = 1e300;
  // The housing is short and the answer only decides what the pointer is over: points every few millimetres are enough.
  constexpr int kPieces = 24;
  for (int i = 0; i <= kPieces; ++i) {
    const glm::dvec3 p = glm::mix(a, b, static_cast<double>(i) / kPieces) - ray.from_mm;
    const double along = std::max(0.0, glm::dot(p, ray.direction));
    least = std::min(least, glm::length(p - along * ray.direction));
  }
  return least;
}

/// A touch VTK's lighting has no setting for, made in its shader because it costs nothing there: skin that turns away from the viewer
/// darkens softly.
void shadeBody(vtkActor& body) {
  body.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                         "//VTK::Light::Impl\n"
                                                         "  float ewFacing = clamp(normalVCVSOutput.z, 0.0, 1.0);\n"
                                                         "  fragOutput0.rgb *= mix(ewRim, 1.0, sqrt(ewFacing));\n",
                                                         false);
}

}  // namespace

SceneColours darkColours() { return {}; }

SceneColours lightColours() {
  SceneColours colours;
  colours.groundTop = {0.965, 0.968, 0.975};
  colours.groundBottom = {0.900, 0.906, 0.918};
  colours.skin = {0.86, 0.745, 0.665};
  colours.rim = 0.86;
  colours.box = {0.33, 0.36, 0.40};
  colours.accent = {0.055, 0.520, 0.575};
  colours.housing = {0.74, 0.75, 0.765};
  colours.covered = {0.72, 0.80, 0.76};
  colours.cube = {0.97, 0.975, 0.98};
  colours.letter = {0.13, 0.15, 0.18};
  colours.axes = {glm::dvec3(0.80, 0.38, 0.02), glm::dvec3(0.03, 0.50, 0.55), glm::dvec3(0.16, 0.36, 0.80)};
  colours.used = {0.10, 0.11, 0.13};
  return colours;
}

struct Scene3D::Parts {
  /// Where the body is seen from.
  struct Seen {
    glm::dvec3 eye_mm{0.0}, focal_mm{0.0}, up{0.0};
    glm::ivec2 window_px{0};
    bool operator==(const Seen&) const = default;
  };

  explicit Parts(vtkRenderWindow& renderWindow) : window(&renderWindow), keptBody(renderWindow, *bodyLayer, *overlay) {}

  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> bodyLayer;
  vtkNew<vtkRenderer> overlay;
  LayerStore keptBody;    ///< on software GL the body takes many times as long as all that moves over it
  bool isBodyNew = true;  ///< it looks otherwise than it was drawn last
  Seen drawnFrom;         ///< where from that was
  vtkNew<vtkCamera> vtkView;
  OrbitCamera camera;
  SceneColours colours;

  std::shared_ptr<const Mannequin> mannequin;
  std::vector<float> coverage;  ///< of each corner of its surface; empty: unknown
  OrientationCube cube;
  vtkNew<vtkActor> body;
  vtkNew<vtkPolyDataMapper> bodyMapper;

  vtkNew<vtkActor> box;
  vtkNew<vtkPolyData> boxMesh;
  std::optional<Bounds> volume;
  bool boxWanted = true;
  std::shared_ptr<const OrganSurfaces> organs;
  vtkNew<vtkActor> organActor;
  vtkNew<vtkPolyDataMapper> organMapper;

  HandlesModel handlesModel;
  struct Handles {
    HandlesToWorld toWorld;
    glm::dvec3 halfSize_mm{0.0};
  };
  std::optional<Handles> handles;

  vtkNew<vtkActor> housing;
  vtkNew<vtkPolyDataMapper> housingMapper;
  FanImage fan;
  Probe probe;
  double depth_mm = 0.0;
  double steering_rad = 0.0;
  bool trapezoid = false;
  bool hasProbe = false;
  bool hasPose = false;
  bool probeWanted = true;
  bool overviewDue = true;  ///< nobody has chosen a view yet: the first pose on a mannequin does
  Pose pose;
  vtkNew<vtkMatrix4x4> probeToWorld;

  void applyColours() {
    bodyLayer->SetBackground(colours.groundBottom.r, colours.groundBottom.g, colours.groundBottom.b);
    bodyLayer->SetBackground2(colours.groundTop.r, colours.groundTop.g, colours.groundTop.b);
    setColour(*body->GetProperty(), colours.skin);
    isBodyNew = true;
    setColour(*box->GetProperty(), colours.box);
    colourBody();
    updateRim();
    handlesModel.setColours(colours.axes, colours.used);
    cube.setColours(colours.cube, colours.letter, colours.box);
    fan.setAccent(colours.accent);
    rebuildHousing();
  }

  void updateRim() { body->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("ewRim", static_cast<float>(colours.rim)); }

  /// Skin, and tinted skin where there are data below it.
  void colourBody() {
    isBodyNew = true;
    bodyMapper->SetScalarVisibility(!coverage.empty());
    if (mannequin == nullptr) return;
    if (coverage.empty()) return bodyMapper->SetInputData(mannequin->surface);
    vtkNew<vtkUnsignedCharArray> tints;
    tints->SetNumberOfComponents(3);
    tints->SetNumberOfTuples(static_cast<vtkIdType>(coverage.size()));
    for (std::size_t n = 0; n < coverage.size(); ++n) {
      const glm::dvec3 colour = glm::mix(colours.skin, colours.covered, static_cast<double>(coverage[n]));
      for (int channel = 0; channel < 3; ++channel)
        tints->SetValue(static_cast<vtkIdType>(3 * n) + channel, static_cast<unsigned char>(std::lround(255.0 * colour[channel])));
    }
    vtkNew<vtkPolyData> tinted;  // the mannequin's surface is shared and stays as it is
    tinted->ShallowCopy(mannequin->surface);
    tinted->GetPointData()->SetScalars(tints);
    bodyMapper->SetInputData(tinted);
  }

  void rebuildHousing() {
    if (!hasProbe) return;
    housingMapper->SetInputData(probeModel(probe, {colours.housing, 0.42 * colours.housing, colours.accent, glm::dvec3(0.40, 0.43, 0.47)}));
  }

  void updateVisibility() {
    const bool visible = hasProbe && hasPose && probeWanted;
    housing->SetVisibility(visible);
    fan.setVisible(visible);
  }

  [[nodiscard]] glm::dvec3 inWorld(const glm::dvec3& p_probe_mm) const { return (pose.probeToWorld * Point<frame::Probe>{p_probe_mm}).at; }

  /// How much of the housing the viewer sees past the body, 0..1.
  [[nodiscard]] double seenPart() const {
    if (mannequin == nullptr || body->GetProperty()->GetOpacity() < 0.99) return 1.0;
    const glm::dvec3 eye_mm = camera.eye_mm();
    int seen = 0;
    constexpr std::array<double, 4> kHeights_mm{12.0, 40.0, 70.0, 100.0};
    for (const double height_mm : kHeights_mm) {
      const glm::dvec3 target_mm = inWorld({0.0, -height_mm, 0.0});
      const auto hit = mannequin->skin->hit(eye_mm, target_mm - eye_mm);
      seen += !hit || glm::distance(hit->point_mm, eye_mm) > glm::distance(target_mm, eye_mm) - 6.0 ? 1 : 0;
    }
    return seen / static_cast<double>(kHeights_mm.size());
  }

  [[nodiscard]] Bounds bodyBounds() const {
    return mannequin != nullptr ? mannequin->bounds : Bounds{{-260.0, -120.0, -1280.0}, {260.0, 120.0, 470.0}};
  }

  /// Upper body for a person's height; the whole of anything smaller.
  [[nodiscard]] OrbitCamera::Framing trunkFraming() const {
    const Bounds bounds = bodyBounds();
    const glm::dvec3 extent_mm = bounds.highest_mm - bounds.lowest_mm;
    const glm::dvec3 middle_mm = 0.5 * (bounds.lowest_mm + bounds.highest_mm);
    if (extent_mm.z < 1200.0) return {middle_mm, 1.1 * std::max(extent_mm.x, extent_mm.y), 1.15 * extent_mm.z};
    return {{middle_mm.x, middle_mm.y, bounds.highest_mm.z - 0.265 * extent_mm.z}, std::min(extent_mm.x, 600.0), 0.50 * extent_mm.z};
  }

  void syncCamera() {
    const int* size = window->GetSize();
    camera.setWindow(size[0], size[1]);
    const glm::dvec3 eye = camera.eye_mm();
    const glm::dvec3 focal = camera.focal_mm();
    const glm::dvec3 up = camera.up();
    vtkView->SetPosition(eye.x, eye.y, eye.z);
    vtkView->SetFocalPoint(focal.x, focal.y, focal.z);
    vtkView->SetViewUp(up.x, up.y, up.z);
    vtkView->SetViewAngle(glm::degrees(OrbitCamera::kOpening_rad));
    const Bounds bounds = bodyBounds();
    const double reach_mm = 0.5 * glm::distance(bounds.lowest_mm, bounds.highest_mm) + 350.0;
    const double toMiddle_mm = glm::distance(eye, 0.5 * (bounds.lowest_mm + bounds.highest_mm));
    const double far_mm = toMiddle_mm + reach_mm;
    cube.look(camera.forward(), up, {size[0], size[1]});
    vtkView->SetClippingRange(std::max(far_mm / 500.0, std::max(10.0, toMiddle_mm - reach_mm)), far_mm);
  }
};

Scene3D::Scene3D(vtkRenderWindow& window) : parts_(std::make_unique<Parts>(window)) {
  Parts& p = *parts_;
  window.SetMultiSamples(0);
  window.SetNumberOfLayers(3);
  p.bodyLayer->SetLayer(0);
  p.bodyLayer->GradientBackgroundOn();
  p.overlay->SetLayer(1);
  p.overlay->InteractiveOff();
  const std::array<vtkSmartPointer<vtkLight>, 3> lights{cameraLight({-0.55, 0.75, 0.85}, {1.0, 0.985, 0.96}, 0.60),
                                                        cameraLight({0.9, 0.15, 0.6}, {0.93, 0.96, 1.0}, 0.24),
                                                        cameraLight({0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}, 0.36)};
  for (vtkRenderer* layer : {p.bodyLayer.Get(), p.overlay.Get()}) {
    layer->SetActiveCamera(p.vtkView);
    layer->AutomaticLightCreationOff();
    for (const auto& light : lights) layer->AddLight(light);
    window.AddRenderer(layer);
  }
  p.handlesModel.layer().SetLayer(2);
  p.handlesModel.layer().SetActiveCamera(p.vtkView);
  p.handlesModel.layer().AutomaticLightCreationOff();
  for (const auto& light : lights) p.handlesModel.layer().AddLight(light);
  p.cube.addTo(window, 1);
  p.body->SetMapper(p.bodyMapper);
  p.bodyMapper->SetColorModeToDirectScalars();
  p.bodyMapper->ScalarVisibilityOff();
  vtkProperty& skin = *p.body->GetProperty();
  skin.BackfaceCullingOn();
  skin.SetInterpolationToPhong();
  skin.SetAmbient(0.10);
  skin.SetDiffuse(1.0);
  skin.SetSpecular(0.05);
  skin.SetSpecularPower(12.0);
  p.body->VisibilityOff();
  p.bodyLayer->AddActor(p.body);

  p.organActor->SetMapper(p.organMapper);
  p.organMapper->SetColorModeToDirectScalars();
  p.organActor->GetProperty()->SetInterpolationToPhong();
  p.organActor->GetProperty()->SetAmbient(0.12);
  p.organActor->GetProperty()->SetDiffuse(0.85);
  p.organActor->VisibilityOff();
  p.bodyLayer->AddActor(p.organActor);

  vtkNew<vtkPolyDataMapper> boxMapper;
  boxMapper->SetInputData(p.boxMesh);
  p.box->SetMapper(boxMapper);
  p.box->GetProperty()->LightingOff();
  p.box->GetProperty()->SetLineWidth(1.0F);
  p.box->GetProperty()->SetOpacity(0.4);  // the tint of the skin says where data are; the box only where the volume ends
  // A pass for what is translucent costs more than all else that moves. Lines may be blended as they are, over all that is there: they
  // come last.
  p.box->ForceOpaqueOn();
  p.box->VisibilityOff();

  p.housing->SetMapper(p.housingMapper);
  p.housingMapper->SetColorModeToDirectScalars();
  p.housing->GetProperty()->SetInterpolationToPhong();
  // The lights add up to more than one where they overlap: brighter than this, plastic turns into a white patch without form.
  p.housing->GetProperty()->SetAmbient(0.10);
  p.housing->GetProperty()->SetDiffuse(0.82);
  p.housing->GetProperty()->SetSpecular(0.08);
  p.housing->GetProperty()->SetSpecularPower(18.0);
  p.housing->SetUserMatrix(p.probeToWorld);
  p.overlay->AddActor(p.housing);
  p.fan.addTo(*p.overlay);
  p.fan.setProbeToWorld(p.probeToWorld);
  p.overlay->AddActor(p.box);
  shadeBody(*p.body);
  p.updateVisibility();
  p.applyColours();
  showFrom(CameraPreset::overview);
  p.overviewDue = true;
}

Scene3D::~Scene3D() {
  parts_->cube.removeFrom(*parts_->window);
  clearHandles();
  parts_->window->RemoveRenderer(parts_->overlay);
  parts_->window->RemoveRenderer(parts_->bodyLayer);
}

void Scene3D::setMannequin(std::shared_ptr<const Mannequin> mannequin) {
  Parts& p = *parts_;
  const bool first = p.mannequin == nullptr;
  p.mannequin = std::move(mannequin);
  p.coverage.clear();
  p.colourBody();
  p.body->SetVisibility(p.mannequin != nullptr);
  if (first) p.camera.frame(p.trunkFraming());
}

std::shared_ptr<const Mannequin> Scene3D::mannequin() const { return parts_->mannequin; }

void Scene3D::setCoverage(std::vector<float> shares) {
  Parts& p = *parts_;
  EW_EXPECTS(shares.empty() ||
             (p.mannequin != nullptr && static_cast<vtkIdType>(shares.size()) == p.mannequin->surface->GetNumberOfPoints()));
  p.coverage = std::move(shares);
  p.colourBody();
}

void Scene3D::setBodyOpacity(double opacity) {
  parts_->body->GetProperty()->SetOpacity(std::clamp(opacity, 0.0, 1.0));
  parts_->isBodyNew = true;
}

void Scene3D::setVolumeBox(const Grid& grid) {
  EW_EXPECTS(checkGrid(grid).has_value());
  Parts& p = *parts_;
  p.volume = boundsOf(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto voxelToWorld = grid.voxelToWorld();
  for (int corner = 0; corner < 8; ++corner) {
    // The box encloses the voxels, not only their centres.
    const glm::dvec3 voxel(corner & 1 ? grid.dims.x - 0.5 : -0.5, corner & 2 ? grid.dims.y - 0.5 : -0.5,
                           corner & 4 ? grid.dims.z - 0.5 : -0.5);
    const glm::dvec3 at = (voxelToWorld * Point<frame::Voxel>{voxel}).at;
    points->InsertNextPoint(at.x, at.y, at.z);
  }
  vtkNew<vtkCellArray> lines;
  for (int corner = 0; corner < 8; ++corner)
    for (const int bit : {1, 2, 4})
      if ((corner & bit) == 0) {
        const std::array<vtkIdType, 2> ends{corner, corner | bit};
        lines->InsertNextCell(2, ends.data());
      }
  p.boxMesh->SetPoints(points);
  p.boxMesh->SetLines(lines);
  p.box->SetVisibility(p.boxWanted);
}

void Scene3D::setBoxVisible(bool visible) {
  parts_->boxWanted = visible;
  parts_->box->SetVisibility(visible && parts_->volume.has_value());
}

void Scene3D::setOrgans(std::shared_ptr<const OrganSurfaces> organs) {
  Parts& p = *parts_;
  p.organs = std::move(organs);
  const bool any = p.organs != nullptr && !p.organs->labels().empty();
  if (any) p.organMapper->SetInputData(p.organs->mesh());
  p.organActor->SetVisibility(any);
  p.isBodyNew = true;
}

void Scene3D::setHandles(const HandlesToWorld& toWorld, const glm::dvec3& halfSize_mm) {
  Parts& p = *parts_;
  if (!p.handles) p.window->AddRenderer(&p.handlesModel.layer());
  p.handles = Parts::Handles{toWorld, halfSize_mm};
}

void Scene3D::clearHandles() {
  Parts& p = *parts_;
  if (p.handles) p.window->RemoveRenderer(&p.handlesModel.layer());
  p.handles.reset();
  p.handlesModel.setUsed(std::nullopt);
}

void Scene3D::setUsedHandle(const Handle* used) { parts_->handlesModel.setUsed(used != nullptr ? std::optional(*used) : std::nullopt); }

std::optional<HandlesPlace> Scene3D::handles() const {
  const Parts& p = *parts_;
  if (!p.handles) return std::nullopt;
  const double mmPerPixel = mmPerPixelAt(glm::dvec3(p.handles->toWorld.matrix[3]));
  return HandlesPlace{p.handles->toWorld, handlesReach_mm(mmPerPixel, p.handles->halfSize_mm)};
}

std::optional<Handle> Scene3D::handleAt(glm::dvec2 at_px, double near_px) const {
  const auto place = handles();
  if (!place) return std::nullopt;
  return bridge::handleAt(
      *place, eye_mm(), at_px, [this](const glm::dvec3& p_mm) { return pixelOf(p_mm); }, near_px);
}

void Scene3D::clearVolumeBox() {
  parts_->volume.reset();
  parts_->box->VisibilityOff();
}

void Scene3D::setProbe(const Probe& probe, double depth_mm, const Knobs& knobs) {
  EW_EXPECTS(depth_mm > 0.0);
  Parts& p = *parts_;
  const bool sameProbe = p.hasProbe && probe == p.probe;
  const bool sameFan = depth_mm == p.depth_mm && knobs.steering_rad == p.steering_rad && knobs.trapezoid == p.trapezoid;
  if (sameProbe && sameFan) return;  // a caller may say so with every frame
  p.probe = probe;
  p.depth_mm = depth_mm;
  p.steering_rad = knobs.steering_rad;
  p.trapezoid = knobs.trapezoid;
  p.hasProbe = true;
  if (!sameProbe) p.rebuildHousing();
  p.fan.setOutline(probe, depth_mm, knobs);
  p.updateVisibility();
}

void Scene3D::setPose(const Pose& pose) {
  Parts& p = *parts_;
  p.hasPose = pose.status == PoseStatus::ok;
  if (p.hasPose) {
    p.pose = pose;
    copyTo(*p.probeToWorld, pose.probeToWorld.matrix);
    if (p.overviewDue && p.mannequin != nullptr) showFrom(CameraPreset::overview);
  }
  p.updateVisibility();
}

void Scene3D::setProbeVisible(bool visible) {
  parts_->probeWanted = visible;
  parts_->updateVisibility();
}

void Scene3D::setFanImage(const DisplayImage& image, const DisplayGeometry& geometry) { parts_->fan.setImage(image, geometry); }

void Scene3D::clearFanImage() { parts_->fan.clearImage(); }

std::vector<glm::dvec3> Scene3D::fanCorners_mm() const { return parts_->fan.corners_mm(); }

void Scene3D::setColours(const SceneColours& colours) {
  parts_->colours = colours;
  parts_->applyColours();
}

void Scene3D::showFrom(CameraPreset preset) {
  Parts& p = *parts_;
  p.overviewDue = false;
  if (preset == CameraPreset::overview && p.hasPose)
    p.camera.overlook(glm::dvec3(p.pose.probeToWorld.matrix[2]), p.trunkFraming());
  else
    p.camera.look(preset, p.trunkFraming());
}

void Scene3D::fitToVolume() {
  Parts& p = *parts_;
  if (!p.volume) return p.camera.frame(p.trunkFraming());
  const double diagonal_mm = glm::distance(p.volume->lowest_mm, p.volume->highest_mm);
  p.camera.frame({0.5 * (p.volume->lowest_mm + p.volume->highest_mm), 1.5 * diagonal_mm, 1.5 * diagonal_mm});
}

void Scene3D::orbit(double right_rad, double up_rad) {
  parts_->overviewDue = false;
  parts_->camera.orbit(right_rad, up_rad);
}

void Scene3D::pan(glm::dvec2 by_px) {
  parts_->overviewDue = false;
  Bounds near = parts_->bodyBounds();
  near.lowest_mm -= 150.0;
  near.highest_mm += 150.0;
  parts_->camera.pan(by_px, near);
}

void Scene3D::zoom(double factor) {
  parts_->overviewDue = false;
  parts_->camera.zoom(factor);
}

Ray Scene3D::rayAt(glm::dvec2 at_px) const {
  parts_->syncCamera();
  return parts_->camera.rayAt(at_px);
}

std::optional<Skin::Contact> Scene3D::contactAt(glm::dvec2 at_px) const {
  if (parts_->mannequin == nullptr) return std::nullopt;
  const Ray ray = rayAt(at_px);
  return parts_->mannequin->skin->hit(ray.from_mm, ray.direction);
}

bool Scene3D::isProbeAt(glm::dvec2 at_px) const {
  const Parts& p = *parts_;
  if (!p.housing->GetVisibility()) return false;
  const Ray ray = rayAt(at_px);
  const double halfFace_mm = faceHalfWidth_mm(p.probe);
  return distance_mm(ray, p.inWorld({0.0, -10.0, 0.0}), p.inWorld({0.0, -housingLength_mm(p.probe), 0.0})) < 17.0 ||
         distance_mm(ray, p.inWorld({-halfFace_mm, -16.0, 0.0}), p.inWorld({halfFace_mm, -16.0, 0.0})) < 16.0;
}

glm::dvec2 Scene3D::pixelOf(const glm::dvec3& p_world_mm) const {
  parts_->syncCamera();
  return parts_->camera.pixelOf(p_world_mm);
}

double Scene3D::mmPerPixelAt(const glm::dvec3& p_world_mm) const {
  parts_->syncCamera();
  return parts_->camera.mmPerPixelAt(p_world_mm);
}

Sight Scene3D::sight() const {
  parts_->syncCamera();
  return parts_->camera.sight();
}

int Scene3D::cubeSide_px() const {
  const int* size = parts_->window->GetSize();
  return OrientationCube::side_px({size[0], size[1]});
}

glm::dvec3 Scene3D::cameraRight() const { return parts_->camera.right(); }
glm::dvec3 Scene3D::cameraUp() const { return parts_->camera.up(); }
glm::dvec3 Scene3D::eye_mm() const { return parts_->camera.eye_mm(); }

void Scene3D::render(Edges edges) {
  Parts& p = *parts_;
  vtkRenderer& last = p.handles ? p.handlesModel.layer() : *p.overlay;
  p.overlay->SetUseFXAA(false);
  last.SetUseFXAA(edges == Edges::smooth);  // on the last layer it smooths the whole image
  p.cube.setSmooth(edges == Edges::smooth);
  p.syncCamera();
  if (const auto place = handles()) p.handlesModel.setPlace(*place, p.camera.eye_mm());
  if (p.housing->GetVisibility()) p.housing->GetProperty()->SetOpacity(0.22 + 0.78 * p.seenPart());
  const int* size = p.window->GetSize();
  const Parts::Seen from{p.camera.eye_mm(), p.camera.focal_mm(), p.camera.up(), {size[0], size[1]}};
  if (!(std::exchange(p.drawnFrom, from) == from)) p.isBodyNew = true;
  p.keptBody.prepare(std::exchange(p.isBodyNew, false));
  p.window->Render();
  p.bodyLayer->SetDraw(1);  // a widget that has the window drawn by itself, after a change of its size, draws all of it
}

}  // namespace ew::bridge
