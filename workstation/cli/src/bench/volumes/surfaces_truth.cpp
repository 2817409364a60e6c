#include "bench/volumes/surfaces_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/parallel.h"
#include "ew/labelling/labels.h"

namespace ew {
namespace {

/// To the nearest point q of an ellipsoid, q = r^2 p / (t + r^2), whose t is found by bisection.
/// Where it is certainly more than 3 away, a bound: the distance to the unit sphere, stretched as little as the ellipsoid is anywhere.
double toEllipsoid(const glm::dvec3& p, const glm::dvec3& radii) {
  const double least = std::min({radii.x, radii.y, radii.z}) * (glm::length(p / radii) - 1.0);
  if (std::abs(least) > 3.0) return least;
  const glm::dvec3 r2 = radii * radii;
  double low = -std::min({r2.x, r2.y, r2.z}) + 1e-9, high = glm::length(radii * p) + 1.0;
  for (int n = 0; n < 50; ++n) {
    const double t = 0.5 * (low + high);
    (glm::length(radii * p / (t + r2)) > 1.0 ? low : high) = t;
  }
  const double away = glm::distance(p, r2 * p / (high + r2));
  return glm::length(p / radii) < 1.0 ? -away : away;
}

/// Points by the voxel they lie in, to find the nearest to a place.
class NearPoints {
 public:
  NearPoints(const std::vector<glm::dvec3>& points, int side) : points_(points), side_(side + 2) {
    begin_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (const glm::dvec3& p : points) ++begin_[cellOf(p) + 1];
    for (std::size_t n = 1; n < begin_.size(); ++n) begin_[n] += begin_[n - 1];
    auto next = begin_;
    order_.resize(points.size());
    for (std::size_t n = 0; n < points.size(); ++n) order_[next[cellOf(points[n])]++] = static_cast<std::uint32_t>(n);
  }
  /// Looks 1 voxel around: what is farther is at least 1 away.
  [[nodiscard]] double nearest(const glm::dvec3& q) const {
    double found = std::numeric_limits<double>::max();
    const glm::ivec3 middle = voxelOf(q);
    for (int k = middle.z - 1; k <= middle.z + 1; ++k)
      for (int j = middle.y - 1; j <= middle.y + 1; ++j)
        for (int i = middle.x - 1; i <= middle.x + 1; ++i) {
          const glm::ivec3 voxel(i, j, k);
          if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, glm::ivec3(side_)))) continue;
          const std::size_t cell = sampleIndex(glm::ivec3(side_), i, j, k);
          for (std::uint32_t n = begin_[cell]; n < begin_[cell + 1]; ++n) found = std::min(found, glm::distance(points_[order_[n]], q));
        }
    return found;
  }

 private:
  [[nodiscard]] glm::ivec3 voxelOf(const glm::dvec3& p) const {
    return glm::clamp(glm::ivec3(glm::floor(p + 1.0)), glm::ivec3(0), glm::ivec3(side_ - 1));
  }
  [[nodiscard]] std::size_t cellOf(const glm::dvec3& p) const {
    const glm::ivec3 voxel = voxelOf(p);
    return sampleIndex(glm::ivec3(side_), voxel.x, voxel.y, voxel.z);
  }

  const std::vector<glm::dvec3>& points_;
  int side_;
  std::vector<std::uint32_t> begin_, order_;
};

/// What the meshes of the organs, one after another, amount to.
struct Sums {
  SurfacesAccuracy accuracy;
  double distance = 0.0, squaredAngle = 0.0;
  std::size_t places = 0, angles = 0;
  std::vector<glm::dvec3> all;
};

/// The surface of an organ lies on its own shape, or where that of one before it cuts it.
std::pair<double, std::size_t> nearestShape(const TrueOrgans& organs, std::size_t organ, const glm::dvec3& p) {
  std::pair<double, std::size_t> nearest{std::numeric_limits<double>::max(), organ};
  for (std::size_t n = 0; n <= organ; ++n) nearest = std::min(nearest, {std::abs(organs.distance(n, p)), n});
  return nearest;
}

void addMesh(const SurfaceMesh& mesh, std::size_t organ, const TrueOrgans& organs, Sums& sums) {
  const auto place = [&](const glm::dvec3& p) {
    const auto [away, shape] = nearestShape(organs, organ, p);
    sums.accuracy.farthest = std::max(sums.accuracy.farthest, away);
    sums.distance += away;
    ++sums.places;
    sums.all.push_back(p);
    return shape;
  };
  for (std::size_t n = 0; n < mesh.points_mm.size(); ++n) {
    const glm::dvec3 p(mesh.points_mm[n]);
    const std::size_t shape = place(p);
    if (n % 8 != 0) continue;
    glm::dvec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = 0.01;
      slope[axis] = organs.distance(shape, p + step) - organs.distance(shape, p - step);
    }
    const double with = std::abs(glm::dot(glm::normalize(slope), glm::dvec3(mesh.normals[n])));
    sums.squaredAngle += std::pow(std::acos(std::min(with, 1.0)), 2);
    ++sums.angles;
  }
  for (const glm::ivec3& t : mesh.triangles) {
    const auto at = [&](int n) { return glm::dvec3(mesh.points_mm[static_cast<std::size_t>(t[n])]); };
    static_cast<void>(place((at(0) + at(1) + at(2)) / 3.0));
  }
}

double volumeWithin(const SurfaceMesh& mesh) {
  double six = 0.0;
  for (const glm::ivec3& t : mesh.triangles) {
    const auto at = [&](int n) { return glm::dvec3(mesh.points_mm[static_cast<std::size_t>(t[n])]); };
    six += glm::dot(at(0), glm::cross(at(1), at(2)));
  }
  return six / 6.0;
}

}  // namespace

TrueOrgans::TrueOrgans(int side_voxel) : side_(side_voxel) {
  addTube({0.5, 0.62, 0.1}, {0.52, 0.6, 0.9}, 0.035);
  addTube({0.58, 0.63, 0.12}, {0.6, 0.58, 0.88}, 0.03);
  addRing({0.36, 0.45, 0.6}, 0.09, 0.022, {0, 0, 1});
  addEllipsoid({0.30, 0.35, 0.62}, {0.06, 0.05, 0.09});
  addEllipsoid({0.36, 0.45, 0.6}, {0.22, 0.25, 0.2});
  addEllipsoid({0.72, 0.5, 0.66}, {0.12, 0.16, 0.13});
  addEllipsoid({0.33, 0.62, 0.36}, {0.08, 0.07, 0.13});
  addEllipsoid({0.69, 0.62, 0.38}, {0.08, 0.07, 0.13});
  addEllipsoid({0.52, 0.36, 0.7}, {0.15, 0.09, 0.08});
  addRing({0.5, 0.4, 0.3}, 0.16, 0.045, {0, 1, 0});
  addEllipsoid({0.5, 0.42, 0.14}, {0.1, 0.09, 0.08});
  addEllipsoid({0.5, 0.5, 0.5}, {0.46, 0.4, 0.47});
}

void TrueOrgans::addEllipsoid(const glm::dvec3& middle, const glm::dvec3& radii) {
  const double scale = side_;
  shapes_.emplace_back([=](const glm::dvec3& p) { return toEllipsoid(p - scale * middle, scale * radii); });
}

void TrueOrgans::addRing(const glm::dvec3& middle, double ring, double tube, const glm::dvec3& axis) {
  const double scale = side_;
  shapes_.emplace_back([=](const glm::dvec3& p) {
    const glm::dvec3 from = p - scale * middle;
    const double along = glm::dot(from, axis);
    return std::hypot(glm::length(from - along * axis) - scale * ring, along) - scale * tube;
  });
}

void TrueOrgans::addTube(const glm::dvec3& from, const glm::dvec3& to, double radius) {
  const double scale = side_;
  shapes_.emplace_back([=](const glm::dvec3& p) {
    const glm::dvec3 way = scale * (to - from), own = p - scale * from;
    const double share = std::clamp(glm::dot(own, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(own - share * way) - scale * radius;
  });
}

Result<Volume> TrueOrgans::labels(Progress& progress) const {
  Volume made;
  made.grid.dims = glm::ivec3(side_);
  made.echo.assign(made.grid.voxelCount(), 0);
  const bool finished = forEachTask(side_, 0, progress, say<"Labelling organs">(), [&](int k) {
    for (int j = 0; j < side_; ++j)
      for (int i = 0; i < side_; ++i)
        for (std::size_t organ = 0; organ < shapes_.size(); ++organ) {
          if (shapes_[organ]({i, j, k}) >= 0.0) continue;
          made.echo[made.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(organ + 1);
          break;
        }
  });
  if (!finished) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
  return made;
}

std::vector<glm::dvec3> TrueOrgans::surfacePoints(const Volume& labels) const {
  std::vector<glm::dvec3> points;
  const auto at = [&](const glm::ivec3& p) { return labels.echo[labels.grid.indexOf(p.x, p.y, p.z)]; };
  for (int axis = 0; axis < 3; ++axis)
    for (int a = 0; a < side_; a += 4)
      for (int b = 0; b < side_; b += 4)
        for (int n = 0; n + 1 < side_; ++n) {
          glm::ivec3 here(0), next(0);
          here[axis] = n;
          here[(axis + 1) % 3] = a;
          here[(axis + 2) % 3] = b;
          next = here;
          ++next[axis];
          const int one = at(here), other = at(next);
          if (one == other) continue;
          // Of the two organs the first one's own shape ends here.
          const auto organ = static_cast<std::size_t>((one == 0 || (other != 0 && other < one) ? other : one) - 1);
          glm::dvec3 inside(here), outside(next);
          if (distance(organ, inside) >= 0.0) std::swap(inside, outside);
          for (int step = 0; step < 30; ++step) {
            const glm::dvec3 middle = 0.5 * (inside + outside);
            (distance(organ, middle) < 0.0 ? inside : outside) = middle;
          }
          points.push_back(inside);
        }
  return points;
}

SurfacesAccuracy accuracyOf(const labelling::LabelSurfaces& surfaces, const TrueOrgans& organs, const Volume& labels) {
  Sums sums;
  for (const std::uint8_t label : surfaces.labels) {
    const SurfaceMesh mesh = labelling::meshOf(surfaces, label);
    addMesh(mesh, label - std::size_t{1}, organs, sums);
    const auto voxels = static_cast<double>(labelling::voxelsOf(labels, label));
    sums.accuracy.volume_percent = std::max(sums.accuracy.volume_percent, 100.0 * std::abs(volumeWithin(mesh) / voxels - 1.0));
  }
  const NearPoints near(sums.all, organs.side());
  for (const glm::dvec3& q : organs.surfacePoints(labels))
    sums.accuracy.farthestBack = std::max(sums.accuracy.farthestBack, near.nearest(q));
  sums.accuracy.mean = sums.distance / static_cast<double>(std::max<std::size_t>(sums.places, 1));
  sums.accuracy.normal_deg =
      std::sqrt(sums.squaredAngle / static_cast<double>(std::max<std::size_t>(sums.angles, 1))) * 180.0 / std::numbers::pi;
  return sums.accuracy;
}

}  // namespace ew
