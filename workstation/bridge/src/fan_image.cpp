#include "fan_image.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolygon.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "ew/bridge/convert.h"

namespace ew::bridge {
namespace {

constexpr double kFloor = 30.0;  // of 255, in the edge's colour: what black is shown as

glm::ivec3 levelAt(const DisplayImage& image, int x, int y) {
  const Rgb grey(image.grey.row(y)[x]);
  return image.hasColour() ? over(image.colour.row(y)[x], grey) : grey;
}

/// Row `y` of an image of which each pixel stands for `step` by `step`.
/// @param shown the colour of each level
void shrinkGrey(const ImageView<const std::uint8_t>& grey, int y, int step, const std::array<Rgb, 256>& shown, std::span<Rgb> out) {
  const std::uint8_t* row = grey.row(step * y);
  if (step == 1) {
    for (Rgb& pixel : out) pixel = shown[*row++];
    return;
  }
  const std::uint8_t* below = grey.row(step * y + 1);
  for (Rgb& pixel : out) {
    pixel = shown[static_cast<std::size_t>((row[0] + row[1] + below[0] + below[1] + 2) / 4)];
    row += 2;
    below += 2;
  }
}

void shrinkColours(const DisplayImage& image, int y, int step, const std::array<Rgb, 256>& shown, std::span<Rgb> out) {
  for (int x = 0; x < static_cast<int>(out.size()); ++x) {
    const auto at = [&](int right, int down) { return levelAt(image, step * x + right, step * y + down); };
    const glm::ivec3 level = step == 1 ? at(0, 0) : (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4;
    for (int c = 0; c < 3; ++c) out[static_cast<std::size_t>(x)][c] = shown[static_cast<std::size_t>(level[c])][c];
  }
}

bool isInside(const std::vector<glm::dvec2>& outline, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0, last = outline.size() - 1; i < outline.size(); last = i++) {
    const glm::dvec2 &a = outline[i], &b = outline[last];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// The parts of the line from `from` to `to` that lie inside the outline, as pairs of shares of its length.
std::vector<glm::dvec2> partsInside(const std::vector<glm::dvec2>& outline, const glm::dvec2& from, const glm::dvec2& to) {
  std::vector<double> cuts{0.0, 1.0};
  const glm::dvec2 along = to - from;
  for (std::size_t i = 0, last = outline.size() - 1; i < outline.size(); last = i++) {
    const glm::dvec2 side = outline[i] - outline[last];
    const double across = along.x * side.y - along.y * side.x;
    if (across == 0.0) continue;  // parallel: crosses nowhere
    const glm::dvec2 gap = outline[last] - from;
    const double onLine = (gap.x * side.y - gap.y * side.x) / across;
    const double onSide = (gap.x * along.y - gap.y * along.x) / across;
    if (onLine > 0.0 && onLine < 1.0 && onSide >= 0.0 && onSide <= 1.0) cuts.push_back(onLine);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<glm::dvec2> parts;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (isInside(outline, from + 0.5 * (cuts[i - 1] + cuts[i]) * along)) parts.emplace_back(cuts[i - 1], cuts[i]);
  }
  return parts;
}

}  // namespace

FanImage::FanImage() {
  vtkNew<vtkPolyDataMapper> paneMapper;
  paneMapper->SetInputData(paneMesh_);
  pane_->SetMapper(paneMapper);
  pane_->GetProperty()->LightingOff();
  pane_->ForceOpaqueOn();
  vtkNew<vtkPolyDataMapper> edgeMapper;
  edgeMapper->SetInputData(edgeMesh_);
  edgeMapper->SetResolveCoincidentTopologyToPolygonOffset();
  // The edge lies in the pane's plane; it is to win on both of its sides.
  edgeMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -4.0);
  edge_->SetMapper(edgeMapper);
  edge_->GetProperty()->LightingOff();
  edge_->GetProperty()->SetLineWidth(2.0F);
  vtkNew<vtkPolyDataMapper> frameMapper;
  frameMapper->SetInputData(frameMesh_);
  frameMapper->SetResolveCoincidentTopologyToPolygonOffset();
  frameMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -4.0);
  frame_->SetMapper(frameMapper);
  frame_->GetProperty()->LightingOff();
  frame_->GetProperty()->SetLineWidth(1.0F);
  texture_->SetInputData(pixels_);
  texture_->InterpolateOn();
  // Beside a zoomed image there is nothing: its last pixels drawn on to the rim would be seen as one.
  texture_->SetWrap(vtkTexture::ClampToBorder);
  texture_->SetColorModeToDirectScalars();
  setAccent(accent_);
}

FanImage::~FanImage() = default;

void FanImage::addTo(vtkRenderer& renderer) {
  renderer.AddActor(pane_);
  renderer.AddActor(edge_);
  renderer.AddActor(frame_);
}

void FanImage::setOutline(const Probe& probe, double depth_mm, const Knobs& knobs) {
  outline_mm_ = fanOutline_mm(probe, knobs, depth_mm);
  if (outline_mm_.size() > 1 && outline_mm_.front() == outline_mm_.back()) outline_mm_.pop_back();
  const auto count = static_cast<vtkIdType>(outline_mm_.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkPolygon> polygon;
  for (const glm::dvec2& p : outline_mm_) {
    const vtkIdType id = points->InsertNextPoint(p.x, p.y, 0.0);
    polygon->GetPointIds()->InsertNextId(id);
    polygon->GetPoints()->InsertNextPoint(p.x, p.y, 0.0);
  }
  vtkNew<vtkIdList> corners;
  polygon->NonDegenerateTriangulate(corners);
  if (corners->GetNumberOfIds() < 3) polygon->Triangulate(corners);
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i + 2 < corners->GetNumberOfIds(); i += 3) {
    const std::array<vtkIdType, 3> ids{corners->GetId(i), corners->GetId(i + 1), corners->GetId(i + 2)};
    triangles->InsertNextCell(3, ids.data());
  }
  paneMesh_->SetPoints(points);
  paneMesh_->SetPolys(triangles);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(count) + 1);
  for (vtkIdType id = 0; id <= count; ++id) lines->InsertCellPoint(id % count);
  edgeMesh_->SetPoints(points);
  edgeMesh_->SetLines(lines);
  updateTextureCoordinates();
}

void FanImage::updateTextureCoordinates() {
  if (!hasImage_ || outline_mm_.empty()) return;
  const glm::dmat4 probeToImage = inverse(geometry_.imageToProbe()).matrix;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Texture");
  coordinates->SetNumberOfComponents(2);
  for (const glm::dvec2& p : outline_mm_) {
    const glm::dvec4 at_px = probeToImage * glm::dvec4(p, 0.0, 1.0);
    // Pixel centres are whole numbers in the image frame and halves in a texture.
    coordinates->InsertNextTuple2((at_px.x + 0.5) / geometry_.width, (at_px.y + 0.5) / geometry_.height);
  }
  paneMesh_->GetPointData()->SetTCoords(coordinates);
  paneMesh_->Modified();
  updateFrame();
}

void FanImage::updateFrame() {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  if (hasImage_ && outline_mm_.size() > 2) {
    const Transform<frame::Probe, frame::Image> imageToProbe = geometry_.imageToProbe();
    const double right = geometry_.width - 0.5;
    const double bottom = geometry_.height - 0.5;
    const std::array<glm::dvec2, 4> corners_px{{{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}};
    for (std::size_t i = 0; i < corners_px.size(); ++i) {
      const auto at_mm = [&](std::size_t corner) {
        return glm::dvec2((imageToProbe * Point<frame::Image>{{corners_px[corner % corners_px.size()], 0.0}}).at);
      };
      const glm::dvec2 from_mm = at_mm(i);
      const glm::dvec2 to_mm = at_mm(i + 1);
      for (const glm::dvec2& part : partsInside(outline_mm_, from_mm, to_mm)) {
        lines->InsertNextCell(2);
        for (const double share : {part.x, part.y}) {
          const glm::dvec2 p_mm = from_mm + share * (to_mm - from_mm);
          lines->InsertCellPoint(points->InsertNextPoint(p_mm.x, p_mm.y, 0.0));
        }
      }
    }
  }
  frameMesh_->SetPoints(points);
  frameMesh_->SetLines(lines);
  frameMesh_->Modified();
}

void FanImage::setImage(const DisplayImage& image, const DisplayGeometry& geometry) {
  if (image.width() < 1 || image.height() < 1) return clearImage();
  const bool sameGeometry = hasImage_ && geometry == geometry_;
  const int step = image.width() > kTextureLimit_px && image.height() > 1 ? 2 : 1;
  const int width = image.width() / step;
  const int height = image.height() / step;
  int dims[3];
  pixels_->GetDimensions(dims);
  if (dims[0] != width || dims[1] != height || pixels_->GetScalarType() != VTK_UNSIGNED_CHAR) {
    pixels_->SetDimensions(width, height, 1);
    pixels_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  }
  // Black on a dark ground would be a hole: the floor of the pane is a trace of its edge's colour.
  std::array<Rgb, 256> shown;
  for (int level = 0; level < 256; ++level)
    for (int c = 0; c < 3; ++c) {
      const int floor = static_cast<int>(kFloor * accent_[c]);
      shown[static_cast<std::size_t>(level)][c] = static_cast<std::uint8_t>(floor + level * (255 - floor) / 255);
    }
  auto* out = static_cast<Rgb*>(pixels_->GetScalarPointer());
  for (int y = 0; y < height; ++y, out += width)
    image.hasColour() ? shrinkColours(image, y, step, shown, {out, static_cast<std::size_t>(width)})
                      : shrinkGrey(image.grey, y, step, shown, {out, static_cast<std::size_t>(width)});
  pixels_->Modified();
  geometry_ = geometry;
  hasImage_ = true;
  if (!sameGeometry) updateTextureCoordinates();
  showTexture(true);
}

void FanImage::clearImage() {
  hasImage_ = false;
  updateFrame();
  showTexture(false);
}

void FanImage::showTexture(bool show) {
  pane_->SetTexture(show ? texture_.Get() : nullptr);
  pane_->GetProperty()->SetOpacity(show ? 1.0 : 0.35);
  pane_->SetForceOpaque(show);
  pane_->SetForceTranslucent(!show);
  if (show)
    pane_->GetProperty()->SetColor(1.0, 1.0, 1.0);
  else
    pane_->GetProperty()->SetColor(accent_.r, accent_.g, accent_.b);
}

void FanImage::setAccent(const glm::dvec3& accent) {
  accent_ = accent;
  edge_->GetProperty()->SetColor(accent.r, accent.g, accent.b);
  frame_->GetProperty()->SetColor(accent.r, accent.g, accent.b);
  const glm::vec3 floor = glm::vec3(kFloor * accent) / 255.0F;
  texture_->SetBorderColor(floor.r, floor.g, floor.b, 1.0F);
  showTexture(hasImage_);
}

void FanImage::setVisible(bool visible) {
  pane_->SetVisibility(visible);
  edge_->SetVisibility(visible);
  frame_->SetVisibility(visible);
}

void FanImage::setProbeToWorld(vtkMatrix4x4* matrix) {
  probeToWorld_ = matrix;
  pane_->SetUserMatrix(matrix);
  edge_->SetUserMatrix(matrix);
  frame_->SetUserMatrix(matrix);
}

std::vector<glm::dvec3> FanImage::corners_mm() const {
  std::vector<glm::dvec3> corners;
  if (!pane_->GetVisibility() || paneMesh_->GetNumberOfPoints() == 0) return corners;
  vtkNew<vtkMatrix4x4> placed;
  // GetMatrix is what the mapper draws with.
  const_cast<vtkActor*>(pane_.Get())->GetMatrix(placed);
  const glm::dmat4 toWorld = toGlm(*placed);
  for (vtkIdType id = 0; id < paneMesh_->GetNumberOfPoints(); ++id) {
    glm::dvec3 p;
    paneMesh_->GetPoint(id, &p.x);
    corners.emplace_back(toWorld * glm::dvec4(p, 1.0));
  }
  return corners;
}

}  // namespace ew::bridge
