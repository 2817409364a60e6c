#include "ew/bridge/mesh_skin.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ew/core/contract.h"

namespace ew::bridge {
namespace {

glm::dvec3 pointOf(vtkPoints& points, vtkIdType id) {
  glm::dvec3 p;
  points.GetPoint(id, &p.x);
  return p;
}

struct Corners {
  glm::dvec3 a, b, c;
  [[nodiscard]] glm::dvec3 areaNormal() const { return 0.5 * glm::cross(b - a, c - a); }
};

class MeshSkin final : public Skin {
 public:
  MeshSkin(vtkSmartPointer<vtkPolyData> triangles, const MeshSkinOptions& options)
      : triangles_(std::move(triangles)), smoothing_mm_(options.smoothing_mm) {
    EW_EXPECTS(triangles_->GetNumberOfPolys() > 0 && smoothing_mm_ > 0.0);
    triangles_->BuildCells();  // otherwise the first query does, which no two threads may
    double bounds[6];
    triangles_->GetBounds(bounds);
    centre_mm_ = 0.5 * glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
    reach_mm_ = glm::length(glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]));
    vtkNew<vtkIdList> corners;
    ids_.reserve(static_cast<std::size_t>(triangles_->GetNumberOfPolys()));
    for (vtkIdType cell = 0; cell < triangles_->GetNumberOfPolys(); ++cell) {
      triangles_->GetPolys()->GetCellAtId(cell, corners);
      EW_EXPECTS(corners->GetNumberOfIds() == 3);
      ids_.push_back({corners->GetId(0), corners->GetId(1), corners->GetId(2)});
    }
    cells_->SetDataSet(triangles_);
    cells_->BuildLocator();
    spreadSamples();
  }

  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3& from_mm, const glm::dvec3& direction) const override {
    const double length = glm::length(direction);
    EW_EXPECTS(length > 0.0);
    const glm::dvec3 along = direction / length;
    // The locator takes a segment: from where the ray comes near the body to where it has certainly left it.
    const double nearest_mm = glm::dot(centre_mm_ - from_mm, along);
    const double begin_mm = std::max(0.0, nearest_mm - reach_mm_);
    const double end_mm = nearest_mm + reach_mm_;
    if (end_mm <= begin_mm) return std::nullopt;
    glm::dvec3 begin = from_mm + begin_mm * along;
    glm::dvec3 end = from_mm + end_mm * along;
    double t = 0.0;
    glm::dvec3 at;
    double parametric[3];
    int subId = 0;
    vtkIdType cell = -1;
    vtkNew<vtkGenericCell> scratch;
    if (cells_->IntersectWithLine(&begin.x, &end.x, 0.0, t, &at.x, parametric, subId, cell, scratch) == 0 || cell < 0) return std::nullopt;
    return contactOn(cell, at);
  }

  [[nodiscard]] Contact nearest(const glm::dvec3& p_mm) const override {
    glm::dvec3 from = p_mm;
    glm::dvec3 at;
    int subId = 0;
    vtkIdType cell = -1;
    double distance2 = 0.0;
    vtkNew<vtkGenericCell> scratch;
    cells_->FindClosestPoint(&from.x, &at.x, scratch, cell, subId, distance2);
    EW_EXPECTS(cell >= 0);
    return contactOn(cell, at);
  }

 private:
  [[nodiscard]] Corners cornersOf(vtkIdType cell) const {
    const auto& ids = ids_[static_cast<std::size_t>(cell)];
    vtkPoints& points = *triangles_->GetPoints();
    return {pointOf(points, ids[0]), pointOf(points, ids[1]), pointOf(points, ids[2])};
  }

  /// Area-weighted normals at a few millimetres' distance all over the surface, so that large triangles count as much as many small
  /// ones. The spacing grows with the surface so that memory stays bounded.
  void spreadSamples() {
    const vtkIdType count = triangles_->GetNumberOfPolys();
    double area_mm2 = 0.0;
    for (vtkIdType cell = 0; cell < count; ++cell) area_mm2 += glm::length(cornersOf(cell).areaNormal());
    constexpr double kMostSamples = 400e3;
    const double spacing_mm = std::max(smoothing_mm_ / 4.0, std::sqrt(area_mm2 / kMostSamples));
    vtkNew<vtkPoints> places;
    for (vtkIdType cell = 0; cell < count; ++cell) {
      const Corners t = cornersOf(cell);
      const glm::dvec3 areaNormal = t.areaNormal();
      const double longest = std::max({glm::length(t.b - t.a), glm::length(t.c - t.b), glm::length(t.a - t.c)});
      // By length a needle would get thousands of samples for no area; its share of the area limits it.
      const double byLength = std::ceil(longest / (1.5 * spacing_mm));
      const double byArea = std::ceil(2.0 * std::sqrt(glm::length(areaNormal)) / spacing_mm);
      const int parts = std::max(1, static_cast<int>(std::min(byLength, byArea)));
      // parts * parts equal triangles: the upright and the inverted ones of each row.
      for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j)
          for (const double third : {1.0 / 3.0, 2.0 / 3.0}) {
            if (third > 0.5 && i + j + 1 >= parts) continue;
            const glm::dvec3 p = t.a + (i + third) / parts * (t.b - t.a) + (j + third) / parts * (t.c - t.a);
            places->InsertNextPoint(p.x, p.y, p.z);
            areaNormals_mm2_.push_back(areaNormal / (static_cast<double>(parts) * parts));
          }
    }
    places_->SetPoints(places);
    points_->SetDataSet(places_);
    points_->BuildLocator();
  }

  /// The surface's own normal at a point of a triangle: its point normals blended, or the triangle's.
  [[nodiscard]] glm::dvec3 localNormal(vtkIdType cell, const glm::dvec3& at) const {
    const Corners t = cornersOf(cell);
    const glm::dvec3 face = t.areaNormal();
    const double area2 = glm::dot(face, face);
    vtkDataArray* normals = triangles_->GetPointData()->GetNormals();
    if (normals != nullptr && area2 > 0.0) {
      const auto& ids = ids_[static_cast<std::size_t>(cell)];
      const double a = glm::dot(0.5 * glm::cross(t.b - at, t.c - at), face) / area2;
      const double b = glm::dot(0.5 * glm::cross(t.c - at, t.a - at), face) / area2;
      const double weights[3] = {a, b, 1.0 - a - b};
      glm::dvec3 sum(0.0);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        glm::dvec3 n;
        normals->GetTuple(ids[corner], &n.x);
        sum += weights[corner] * n;
      }
      if (glm::length(sum) > 1e-6) return glm::normalize(sum);
    }
    return area2 > 0.0 ? glm::normalize(face) : glm::dvec3(0.0);
  }

  [[nodiscard]] Contact contactOn(vtkIdType cell, const glm::dvec3& at) const {
    const glm::dvec3 local = localNormal(cell, at);
    vtkNew<vtkIdList> around;
    glm::dvec3 p = at;
    points_->FindPointsWithinRadius(smoothing_mm_, &p.x, around);
    struct Share {
      glm::dvec3 areaNormal_mm2;
      double area_mm2;
    };
    std::vector<Share> shares;
    shares.reserve(static_cast<std::size_t>(around->GetNumberOfIds()));
    glm::dvec3 all(0.0);
    double area_mm2 = 0.0;
    for (vtkIdType i = 0; i < around->GetNumberOfIds(); ++i) {
      const vtkIdType id = around->GetId(i);
      glm::dvec3 place;
      places_->GetPoint(id, &place.x);
      const glm::dvec3 offset = (place - at) / smoothing_mm_;
      const double near = std::max(0.0, 1.0 - glm::dot(offset, offset));
      const glm::dvec3 weighted = near * near * areaNormals_mm2_[static_cast<std::size_t>(id)];
      const double size = glm::length(weighted);
      if (size <= 0.0) continue;
      shares.push_back({weighted, size});
      all += weighted;
      area_mm2 += size;
    }
    // A thin part's other side must not cancel this one. Which side is ours is told by the mean of all, which changes smoothly over an
    // edge, and only where that mean vanishes by the local normal, which may jump.
    const glm::dvec3 side = area_mm2 > 0.0 ? all / area_mm2 + 0.1 * local : local;
    const glm::dvec3 ours = glm::length(side) > 1e-9 ? glm::normalize(side) : local;
    glm::dvec3 sum(0.0);
    for (const Share& share : shares)
      sum += std::clamp(0.25 + 0.75 * glm::dot(share.areaNormal_mm2 / share.area_mm2, ours), 0.0, 1.0) * share.areaNormal_mm2;
    const double length = glm::length(sum);
    if (length > 1e-9) return {at, sum / length};
    // A needle or a degenerate triangle alone in the world: away from the middle is the best that can be said.
    if (glm::length(local) > 0.5) return {at, local};
    const glm::dvec3 away = at - centre_mm_;
    return {at, glm::length(away) > 0.0 ? glm::normalize(away) : glm::dvec3(0.0, -1.0, 0.0)};
  }

  vtkSmartPointer<vtkPolyData> triangles_;
  std::vector<std::array<vtkIdType, 3>> ids_;
  double smoothing_mm_;
  glm::dvec3 centre_mm_{0.0};
  double reach_mm_ = 0.0;
  vtkNew<vtkStaticCellLocator> cells_;
  vtkNew<vtkPolyData> places_;
  vtkNew<vtkStaticPointLocator> points_;
  std::vector<glm::dvec3> areaNormals_mm2_;  ///< normal times area of each of places_
};

}  // namespace

std::shared_ptr<const Skin> makeMeshSkin(vtkSmartPointer<vtkPolyData> triangles, const MeshSkinOptions& options) {
  return std::make_shared<MeshSkin>(std::move(triangles), options);
}

}  // namespace ew::bridge
