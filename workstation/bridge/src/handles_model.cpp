#include "handles_model.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "ew/bridge/convert.h"

namespace ew::bridge {
namespace {

/// A point of an outline that is turned about an axis: how far out, how far along, and the outline's normal there.
struct Outline {
  glm::dvec2 at;      ///< out, along
  glm::dvec2 normal;  ///< unit
};

/// The surface of an outline turned about `axis`. @param around corners of a circle
vtkSmartPointer<vtkPolyData> turnedAbout(int axis, const std::vector<Outline>& outline, int around) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> quads;
  const auto size = static_cast<vtkIdType>(outline.size());
  for (int turn = 0; turn < around; ++turn) {
    const double angle_rad = glm::two_pi<double>() * turn / around;
    for (const Outline& each : outline) {
      const auto placed = [&](const glm::dvec2& outAlong) {
        glm::dvec3 p(0.0);
        p[axis] = outAlong.y;
        p[(axis + 1) % 3] = outAlong.x * std::cos(angle_rad);
        p[(axis + 2) % 3] = outAlong.x * std::sin(angle_rad);
        return p;
      };
      const glm::dvec3 at = placed(each.at), normal = placed(each.normal);
      points->InsertNextPoint(at.x, at.y, at.z);
      normals->InsertNextTuple3(normal.x, normal.y, normal.z);
    }
  }
  for (vtkIdType turn = 0; turn < around; ++turn)
    for (vtkIdType n = 0; n + 1 < size; ++n) {
      const vtkIdType here = turn * size + n, next = ((turn + 1) % around) * size + n;
      const std::array<vtkIdType, 4> quad{here, next, next + 1, here + 1};
      quads->InsertNextCell(4, quad.data());
    }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

vtkSmartPointer<vtkPolyData> arrow(int axis) {
  constexpr double kShaft = 0.014, kHead = 0.052, kNeck = 0.84;
  const glm::dvec2 slope = glm::normalize(glm::dvec2(1.0 - kNeck, kHead));
  return turnedAbout(axis,
                     {{{0.0, kArrowFrom}, {0.0, -1.0}},
                      {{kShaft, kArrowFrom}, {0.0, -1.0}},
                      {{kShaft, kArrowFrom}, {1.0, 0.0}},
                      {{kShaft, kNeck}, {1.0, 0.0}},
                      {{kShaft, kNeck}, {0.0, -1.0}},
                      {{kHead, kNeck}, {0.0, -1.0}},
                      {{kHead, kNeck}, slope},
                      {{0.0, 1.0}, slope}},
                     20);
}

vtkSmartPointer<vtkPolyData> ring(int axis) {
  constexpr double kThick = 0.012;
  constexpr int kCorners = 10;
  std::vector<Outline> outline;
  for (int n = 0; n <= kCorners; ++n) {
    const double angle_rad = glm::two_pi<double>() * n / kCorners;
    const glm::dvec2 out(std::cos(angle_rad), std::sin(angle_rad));
    outline.push_back({glm::dvec2(kRingShare, 0.0) + kThick * out, out});
  }
  return turnedAbout(axis, outline, 96);
}

Handle handleOf(std::size_t actor) { return {actor < 3 ? Handle::Kind::move : Handle::Kind::turn, static_cast<int>(actor % 3)}; }

}  // namespace

HandlesModel::HandlesModel() {
  layer_->InteractiveOff();
  for (std::size_t n = 0; n < actors_.size(); ++n) {
    const int axis = static_cast<int>(n % 3);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(n < 3 ? arrow(axis) : ring(axis));
    vtkActor& actor = *actors_[n];
    actor.SetMapper(mapper);
    actor.SetUserMatrix(unitToWorld_);
    actor.GetProperty()->SetAmbient(0.45);
    actor.GetProperty()->SetDiffuse(0.60);
    layer_->AddActor(&actor);
  }
}

HandlesModel::~HandlesModel() = default;

void HandlesModel::setPlace(const HandlesPlace& place, const glm::dvec3& eye_mm) {
  copyTo(*unitToWorld_, glm::scale(place.toWorld.matrix, glm::dvec3(place.reach_mm)));
  for (std::size_t n = 0; n < actors_.size(); ++n) actors_[n]->SetVisibility(isUsable(place, handleOf(n), eye_mm));
}

void HandlesModel::setColours(const std::array<glm::dvec3, 3>& axes, const glm::dvec3& used) {
  axes_ = axes;
  usedColour_ = used;
  colour();
}

void HandlesModel::setUsed(const std::optional<Handle>& used) {
  used_ = used;
  colour();
}

void HandlesModel::colour() {
  for (std::size_t n = 0; n < actors_.size(); ++n) {
    const Handle handle = handleOf(n);
    const bool isUsed = used_ == handle;
    const glm::dvec3 colour = isUsed ? usedColour_ : axes_[n % 3];
    actors_[n]->GetProperty()->SetColor(colour.r, colour.g, colour.b);
    actors_[n]->GetProperty()->SetOpacity(used_ && !isUsed ? 0.35 : 1.0);
  }
}

}  // namespace ew::bridge
