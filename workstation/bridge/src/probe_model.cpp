#include "probe_model.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace ew::bridge {
namespace {

constexpr int kAround = 72;

/// One cross-section of the housing, a rounded rectangle in x and z.
struct Section {
  double up_mm = 0.0;         ///< distance of its middle from the face, towards -y
  double halfWidth_mm = 0.0;  ///< along x
  double halfThick_mm = 0.0;  ///< along z
  double roundness = 2.0;     ///< exponent of the superellipse: 2 is an ellipse, larger ones are boxier
  double arc = 0.0;           ///< how far it follows the curve of a convex face, 0..1
};

struct Shape {
  double halfWidth_mm = 0.0;  ///< of the head, or of the rod
  double halfThick_mm = 0.0;
  double radius_mm = 0.0;      ///< of the face's arc; 0 when flat
  bool dome = false;           ///< the head is round: half of a ball of that radius, not a cushion
  double headRoundness = 3.4;  ///< see Section::roundness
  double lens_mm = 5.0;        ///< the dark rubber reaches this far up the side
  double taperBegin_mm = 0.0;  ///< between these two the head becomes the handle
  double taperEnd_mm = 0.0;
  double neck_mm = 0.0;  ///< where the handle begins
  double end_mm = 0.0;   ///< where the handle ends
  double handleHalfWidth_mm = 0.0;
  double handleHalfThick_mm = 0.0;
};

Shape shapeOf(const Probe& probe) {
  Shape shape;
  shape.radius_mm = probe.radius_mm;
  switch (probe.kind) {
    case ProbeKind::linear:
    case ProbeKind::phased:
      shape.halfWidth_mm = faceHalfWidth_mm(probe) + 3.0;
      shape.halfThick_mm = probe.kind == ProbeKind::linear ? 7.0 : 9.0;
      shape.neck_mm = 38.0;
      shape.end_mm = 104.0;
      shape.handleHalfWidth_mm = std::min(14.0, shape.halfWidth_mm);
      shape.handleHalfThick_mm = 10.5;
      break;
    case ProbeKind::convex:
      shape.halfWidth_mm = faceHalfWidth_mm(probe) + 2.5;
      shape.halfThick_mm = 9.5;
      shape.neck_mm = 50.0;
      shape.end_mm = 118.0;
      shape.handleHalfWidth_mm = std::min(15.5, shape.halfWidth_mm);
      shape.handleHalfThick_mm = 12.0;
      break;
    case ProbeKind::endocavity:
      shape.halfWidth_mm = shape.halfThick_mm = probe.radius_mm + 0.6;
      shape.neck_mm = 128.0;
      shape.end_mm = 214.0;
      shape.handleHalfWidth_mm = 15.5;
      shape.handleHalfThick_mm = 14.0;
      break;
    case ProbeKind::sweptSector:
      shape.halfWidth_mm = shape.halfThick_mm = probe.radius_mm + 5.0;
      shape.neck_mm = 46.0;
      shape.end_mm = 132.0;
      shape.handleHalfWidth_mm = 16.5;
      shape.handleHalfThick_mm = 15.5;
      break;
  }
  shape.taperBegin_mm = 0.30 * shape.neck_mm;
  shape.taperEnd_mm = 1.25 * shape.neck_mm;
  if (probe.kind == ProbeKind::endocavity || probe.kind == ProbeKind::sweptSector) {
    shape.dome = true;
    shape.headRoundness = 2.0;
    shape.lens_mm = 0.85 * probe.radius_mm;
    shape.taperBegin_mm = shape.neck_mm - 16.0;
    shape.taperEnd_mm = shape.neck_mm + 2.0;
  }
  return shape;
}

double eased(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

std::vector<Section> sectionsOf(const Shape& s) {
  std::vector<Section> sections;
  if (s.dome) {
    const double edge_rad = std::acos(1.0 - s.lens_mm / s.radius_mm);
    for (const double part : {0.03, 0.2, 0.4, 0.55, 0.7, 0.8, 0.9, 1.0})
      sections.push_back({s.radius_mm * (1.0 - std::cos(part * edge_rad)), s.radius_mm * std::sin(part * edge_rad),
                          s.radius_mm * std::sin(part * edge_rad), 2.0, 0.0});
  } else {
    // The lens: a cushion that is foremost in its middle.
    for (const double part : {0.02, 0.3, 0.55, 0.75, 0.88, 0.96, 1.0})
      sections.push_back(
          {2.6 * (1.0 - std::sqrt(1.0 - 0.985 * part * part)), part * (s.halfWidth_mm - 0.6), part * (s.halfThick_mm - 0.6), 3.4, 1.0});
    sections.push_back({s.lens_mm, s.halfWidth_mm - 0.4, s.halfThick_mm - 0.4, 3.4, 1.0});
  }
  const double arc = s.dome ? 0.0 : 1.0;
  sections.push_back({s.lens_mm + 0.2, s.halfWidth_mm, s.halfThick_mm, s.headRoundness, arc});
  for (double up = s.lens_mm + 2.0; up < s.end_mm - 7.0; up += 2.0) {
    const double toNeck = eased((up - s.taperBegin_mm) / (s.taperEnd_mm - s.taperBegin_mm));
    const double waist = 1.6 * std::sin(glm::pi<double>() * std::clamp((up - s.neck_mm) / (s.end_mm - s.neck_mm), 0.0, 1.0));
    sections.push_back({up, glm::mix(s.halfWidth_mm, s.handleHalfWidth_mm, toNeck) - waist,
                        glm::mix(s.halfThick_mm, s.handleHalfThick_mm, toNeck) - 0.6 * waist, glm::mix(s.headRoundness, 2.5, toNeck),
                        arc * (1.0 - eased((up - s.lens_mm) / (0.7 * s.neck_mm)))});
  }
  for (const double part : {0.25, 0.5, 0.7, 0.85, 0.95, 1.0}) {
    const double shrink = std::sqrt(1.0 - 0.72 * part * part);
    sections.push_back({s.end_mm - 7.0 + 7.0 * part, s.handleHalfWidth_mm * shrink, s.handleHalfThick_mm * shrink, 2.4, 0.0});
  }
  return sections;
}

glm::dvec3 pointOn(const Section& section, const Shape& shape, int step) {
  const double angle = glm::two_pi<double>() * step / kAround;
  const auto rounded = [&](double value) { return std::copysign(std::pow(std::abs(value), 2.0 / section.roundness), value); };
  const double x = section.halfWidth_mm * rounded(std::cos(angle));
  const double z = section.halfThick_mm * rounded(std::sin(angle));
  double drop_mm = 0.0;
  if (shape.radius_mm > 0.0) {
    const double inside = std::max(0.0, shape.radius_mm * shape.radius_mm - x * x);
    drop_mm = section.arc * (shape.radius_mm - std::sqrt(inside));
  }
  return {x, -section.up_mm - drop_mm, z};
}

class Builder {
 public:
  void add(vtkPolyData* mesh, const glm::dvec3& colour) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("Colours");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id) setColour(*colours, id, colour);
    mesh->GetPointData()->SetScalars(colours);
    all_->AddInputData(mesh);
  }
  void addColoured(vtkPolyData* mesh) { all_->AddInputData(mesh); }
  vtkSmartPointer<vtkPolyData> finished() {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(all_->GetOutputPort());
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(triangles->GetOutputPort());
    normals->SetFeatureAngle(55.0);
    normals->ConsistencyOff();
    normals->Update();
    return normals->GetOutput();
  }
  static void setColour(vtkUnsignedCharArray& colours, vtkIdType id, const glm::dvec3& colour) {
    for (int c = 0; c < 3; ++c) colours.SetComponent(id, c, std::round(255.0 * std::clamp(colour[c], 0.0, 1.0)));
  }

 private:
  vtkNew<vtkAppendPolyData> all_;
};

/// Rings of kAround points joined by quads, closed at both ends, counter-clockwise from outside when the rings run towards -y.
template <class PointAt>
vtkSmartPointer<vtkPolyData> loft(int rings, PointAt pointAt) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int ring = 0; ring < rings; ++ring)
    for (int step = 0; step < kAround; ++step) {
      const glm::dvec3 p = pointAt(ring, step);
      points->InsertNextPoint(p.x, p.y, p.z);
    }
  const auto id = [](int ring, int step) { return static_cast<vtkIdType>(ring) * kAround + step % kAround; };
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int step = 0; step < kAround; ++step) {
      const std::array<vtkIdType, 4> corners{id(ring, step), id(ring + 1, step), id(ring + 1, step + 1), id(ring, step + 1)};
      cells->InsertNextCell(4, corners.data());
    }
  std::vector<vtkIdType> first(kAround);
  std::vector<vtkIdType> last(kAround);
  for (int step = 0; step < kAround; ++step) {
    first[static_cast<std::size_t>(step)] = id(0, step);
    last[static_cast<std::size_t>(step)] = id(rings - 1, kAround - 1 - step);
  }
  cells->InsertNextCell(kAround, first.data());
  cells->InsertNextCell(kAround, last.data());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> housing(const Shape& shape, const ProbeColours& colours) {
  const auto sections = sectionsOf(shape);
  auto mesh = loft(static_cast<int>(sections.size()),
                   [&](int ring, int step) { return pointOn(sections[static_cast<std::size_t>(ring)], shape, step); });
  vtkNew<vtkUnsignedCharArray> painted;
  painted->SetName("Colours");
  painted->SetNumberOfComponents(3);
  painted->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id) {
    const Section& section = sections[static_cast<std::size_t>(id / kAround)];
    const double fromMarker =
        std::abs(std::remainder(glm::two_pi<double>() * static_cast<double>(id % kAround) / kAround, glm::two_pi<double>()));
    const bool stripe = fromMarker < 0.40 && section.up_mm > shape.lens_mm + 4.0 && section.up_mm < shape.neck_mm + 16.0;
    Builder::setColour(*painted, id, section.up_mm <= shape.lens_mm ? colours.lens : stripe ? colours.marker : colours.housing);
  }
  mesh->GetPointData()->SetScalars(painted);
  return mesh;
}

/// The raised mark a finger feels for.
vtkSmartPointer<vtkPolyData> ridge(const Shape& shape) {
  const glm::dvec3 centre(shape.handleHalfWidth_mm + 0.4, -(shape.neck_mm + 10.0), 0.0);
  constexpr int kRings = 16;
  return loft(kRings, [&](int ring, int step) {
    const double along = glm::pi<double>() * (0.02 + 0.96 * ring / (kRings - 1));
    const double angle = glm::two_pi<double>() * step / kAround;
    return centre + glm::dvec3(2.4 * std::sin(along) * std::cos(angle), 9.0 * std::cos(along), 2.6 * std::sin(along) * std::sin(angle));
  });
}

vtkSmartPointer<vtkPolyData> strainRelief(const Shape& shape) {
  constexpr int kRings = 26;
  return loft(kRings, [&](int ring, int step) {
    const double t = static_cast<double>(ring) / (kRings - 1);
    const double grooves = 0.45 * std::cos(5.0 * glm::two_pi<double>() * t);
    const double radius_mm = glm::mix(7.4, 4.2, t) + grooves;
    const double angle = glm::two_pi<double>() * step / kAround;
    return glm::dvec3(radius_mm * std::cos(angle), -(shape.end_mm - 1.0) - 24.0 * t, radius_mm * std::sin(angle));
  });
}

/// A piece of cable that hangs off towards -z, on a cubic curve.
vtkSmartPointer<vtkPolyData> cable(const Shape& shape) {
  const double begin_mm = shape.end_mm + 20.0;
  const glm::dvec3 p0(0.0, -begin_mm, 0.0);
  const glm::dvec3 p1(0.0, -begin_mm - 62.0, 0.0);
  const glm::dvec3 p2(0.0, -begin_mm - 62.0, -42.0);
  const glm::dvec3 p3(10.0, -begin_mm - 50.0, -120.0);
  constexpr int kPieces = 28;
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> ids;
  for (int i = 0; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    const double u = 1.0 - t;
    const glm::dvec3 p = u * u * u * p0 + 3.0 * u * u * t * p1 + 3.0 * u * t * t * p2 + t * t * t * p3;
    ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  path->SetLines(lines);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(path);
  tube->SetRadius(3.4);
  tube->SetNumberOfSides(20);
  tube->CappingOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tube->GetOutputPort());
  triangles->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(triangles->GetOutput()->GetPoints());
  mesh->SetPolys(triangles->GetOutput()->GetPolys());
  return mesh;
}

}  // namespace

vtkSmartPointer<vtkPolyData> probeModel(const Probe& probe, const ProbeColours& colours) {
  const Shape shape = shapeOf(probe);
  Builder builder;
  builder.addColoured(housing(shape, colours));
  builder.add(ridge(shape), colours.marker);
  builder.add(strainRelief(shape), colours.cable);
  builder.add(cable(shape), colours.cable);
  return builder.finished();
}

double housingLength_mm(const Probe& probe) { return shapeOf(probe).end_mm; }

}  // namespace ew::bridge
