#include "logic/placing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <utility>

namespace ew::case_authoring {
namespace {

constexpr double kSquare = 0.9994;    // cosine of 2 degrees
constexpr double kGoodShare = 0.6;    // of the near face
constexpr double kMostOutside = 0.1;  // of the volume
constexpr double kFarOff_mm = 8.0;    // from the skin: more than gel bridges and a hand presses in

glm::dvec3 placedAlong(const FilePlace& fileToWorld, const glm::dvec3& along) {
  return (fileToWorld * Direction<frame::File>{along}).along;
}

/// Half of the box of all voxels along a direction, mm.
double halfAlong_mm(const Grid& own, const glm::dvec3& direction) {
  double half_mm = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    half_mm += 0.5 * own.dims[axis] * own.spacing_mm[axis] * std::abs(glm::dot(own.directions[axis], direction));
  return half_mm;
}

glm::dmat3 rotationOf(const SweepAxes& axes) { return {axes.lateral, axes.depth, glm::cross(axes.lateral, axes.depth)}; }

/// Of each cell of a lattice over the near face the point that lies nearest to its middle.
std::vector<glm::dvec3> spreadOver(const PlacingShape& shape, std::size_t most) {
  if (shape.face_mm.empty() || most == 0) return {};
  const glm::dmat3 fileToAxes = glm::transpose(rotationOf(shape.axes));
  glm::dvec3 lowest_mm(std::numeric_limits<double>::infinity()), highest_mm(-std::numeric_limits<double>::infinity());
  for (const glm::dvec3& each : shape.face_mm) {
    lowest_mm = glm::min(lowest_mm, fileToAxes * each);
    highest_mm = glm::max(highest_mm, fileToAxes * each);
  }
  const int across = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(most))));
  const glm::dvec3 cell_mm = glm::max((highest_mm - lowest_mm) / static_cast<double>(across), glm::dvec3(1e-6));
  std::map<std::pair<int, int>, std::pair<double, glm::dvec3>> nearest;
  for (const glm::dvec3& each : shape.face_mm) {
    const glm::dvec3 at = (fileToAxes * each - lowest_mm) / cell_mm;
    const int x = std::min(across - 1, static_cast<int>(at.x)), z = std::min(across - 1, static_cast<int>(at.z));
    const double apart = glm::length(glm::dvec2(at.x - x - 0.5, at.z - z - 0.5));
    const auto found = nearest.find({x, z});
    if (found == nearest.end() || apart < found->second.first) nearest[{x, z}] = {apart, each};
  }
  std::vector<glm::dvec3> spread;
  for (const auto& [cell, point] : nearest) spread.push_back(point.second);
  return spread;
}

}  // namespace

std::optional<std::size_t> faceOf(const Grid& own, const SweepAxes& axes) {
  for (std::size_t face = 0; face < 6; ++face)
    if (glm::dot(inwardOf(own, face), axes.depth) > kSquare) return face;
  return std::nullopt;
}

std::size_t likelyFace(const Grid& own, const FilePlace& fileToWorld, const Skin& skin, const std::optional<glm::dvec3>& beam) {
  // Of a volume that reaches from skin to skin the side of the start counts; in general the front is likelier than the back.
  const glm::dvec3 looks = beam.value_or(glm::dvec3(0.0, 1.0, 0.0));
  const double weight_mm = beam ? 100.0 : 30.0;
  std::size_t best = 0;
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::size_t face = 0; face < 6; ++face) {
    const glm::dvec3 inward = inwardOf(own, face);
    const glm::dvec3 middle_mm = carried(fileToWorld, middleOf(own) - halfAlong_mm(own, inward) * inward);
    const Skin::Contact contact = skin.nearest(middle_mm);
    // Beams that would leave the body are worse than any distance.
    const double facing = -glm::dot(placedAlong(fileToWorld, inward), contact.outward);
    const double badness_mm = glm::distance(middle_mm, contact.point_mm) + 200.0 * (1.0 - facing) +
                              weight_mm * (1.0 - glm::dot(placedAlong(fileToWorld, inward), looks));
    if (badness_mm >= least_mm) continue;
    least_mm = badness_mm;
    best = face;
  }
  return best;
}

PlacingShape shapeOf(const Volume& voxels, const Grid& own, const SweepAxes& axes) {
  // Only a grid can be moved without copying voxels: the shape is read where they lay, and carried into the file.
  const auto thereToFile = renamed<frame::File, frame::World>(own.voxelToWorld() * voxels.grid.worldToVoxel());
  const auto fileToThere = rigidInverse(thereToFile);
  const auto there = [&](const glm::dvec3& along) { return (fileToThere * Direction<frame::File>{along}).along; };
  PlacingShape shape = placingShapeOf(voxels, {there(axes.depth), there(axes.lateral)});
  shape.axes = axes;
  for (auto* points_mm : {&shape.face_mm, &shape.inside_mm})
    for (glm::dvec3& each : *points_mm) each = carried(thereToFile, each);
  return shape;
}

sdk::BodyHandles handlesOf(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld) {
  glm::dmat4 handlesToFile(rotationOf(axes));
  handlesToFile[3] = glm::dvec4(middleOf(own), 1.0);
  sdk::BodyHandles handles;
  handles.toWorld = {fileToWorld.matrix * handlesToFile};
  const glm::dmat3 rotation = rotationOf(axes);
  handles.halfSize_mm = {halfAlong_mm(own, rotation[0]), halfAlong_mm(own, rotation[1]), halfAlong_mm(own, rotation[2])};
  return handles;
}

FilePlace movedWith(const FilePlace& fileToWorld, const HandlesPose& before, const HandlesPose& now) {
  if (now == before) return fileToWorld;
  return {now.matrix * rigidInverse(before).matrix * fileToWorld.matrix};
}

FilePlace turnedAboutBeam(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld, double angle_rad) {
  const glm::dvec3 middle_mm = middleOf(own);
  const glm::dmat4 turned = glm::rotate(glm::translate(fileToWorld.matrix, middle_mm), angle_rad, axes.depth);
  return {glm::translate(turned, -middle_mm)};
}

FilePlace putOnSkin(const PlacingShape& shape, const FilePlace& fileToWorld, const Skin& skin, const Point<frame::World>& at) {
  const Skin::Contact contact = skin.nearest(at.at);
  PlacingSite site;
  site.at_mm = contact.point_mm;
  site.towards_mm = contact.point_mm - 100.0 * contact.outward;
  site.lateralHint = placedAlong(fileToWorld, shape.axes.lateral);
  return firstPlacement(shape, skin, site);
}

std::vector<FaceMark> faceMarksOf(const PlacingShape& shape, const FilePlace& fileToWorld, const Skin& skin, std::size_t most) {
  std::vector<FaceMark> marks;
  for (const glm::dvec3& each : spreadOver(shape, most)) {
    const Point<frame::World> at = fileToWorld * Point<frame::File>{each};
    const Skin::Contact contact = skin.nearest(at.at);
    const double gap_mm = glm::distance(at.at, contact.point_mm);
    const bool isAbove = glm::dot(at.at - contact.point_mm, contact.outward) > 0.0;
    marks.push_back({at, gap_mm <= kGel_mm ? FaceMark::Kind::touching : isAbove ? FaceMark::Kind::above : FaceMark::Kind::below});
  }
  return marks;
}

std::array<Point<frame::World>, 4> nearSideOf(const Grid& own, const SweepAxes& axes, const FilePlace& fileToWorld) {
  const glm::dmat3 rotation = rotationOf(axes);
  const double x_mm = halfAlong_mm(own, rotation[0]), y_mm = halfAlong_mm(own, rotation[1]), z_mm = halfAlong_mm(own, rotation[2]);
  const auto corner = [&](double x, double z) {
    return fileToWorld * Point<frame::File>{middleOf(own) + x * x_mm * rotation[0] - y_mm * rotation[1] + z * z_mm * rotation[2]};
  };
  return {corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)};
}

ContactVerdict verdictOf(const Contact& contact) {
  const bool standsOff = contact.deepestGap_mm > kFarOff_mm, liesBelow = contact.deepestIntrusion_mm > kFarOff_mm;
  if (contact.outsideShare > kMostOutside && !standsOff) return ContactVerdict::outside;
  if (contact.outsideShare <= kMostOutside && contact.faceShare >= kGoodShare) return ContactVerdict::good;
  if (standsOff && liesBelow) return ContactVerdict::tipped;
  return contact.deepestIntrusion_mm > contact.deepestGap_mm ? ContactVerdict::liesBelow : ContactVerdict::standsOff;
}

}  // namespace ew::case_authoring
