#include "ew/labelling/outline.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "ew/core/contract.h"

namespace ew::labelling {
namespace {

/// The label's share at points of a plane, 0 to 1, trilinear between voxels; 0 outside of the grid.
class Shares {
 public:
  Shares(const Volume& labels, std::uint8_t label) : labels_(labels), label_(label), box_(boxOf(labels, label)) {}
  [[nodiscard]] bool empty() const { return box_.empty(); }
  [[nodiscard]] double at(const glm::dvec3& voxel) const {
    const glm::dvec3 low = glm::floor(voxel);
    if (glm::any(glm::lessThan(low, glm::dvec3(box_.first) - 1.0)) || glm::any(glm::greaterThanEqual(low, glm::dvec3(box_.end))))
      return 0.0;
    const glm::dvec3 part = voxel - low;
    const glm::ivec3 first(low);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::ivec3 ijk = first + step;
      if (!labels_.grid.contains(ijk) || labels_.echo[labels_.grid.indexOf(ijk.x, ijk.y, ijk.z)] != label_) continue;
      sum += (step.x != 0 ? part.x : 1.0 - part.x) * (step.y != 0 ? part.y : 1.0 - part.y) * (step.z != 0 ? part.z : 1.0 - part.z);
    }
    return sum;
  }

 private:
  const Volume& labels_;
  std::uint8_t label_;
  VoxelBox box_;
};

/// Edges of cells that an outline crosses: from the point (column, row) to its right (0) or lower (1) neighbour.
using Edge = std::array<int, 3>;

}  // namespace

std::vector<std::vector<glm::dvec2>> outlinesOf(const Volume& labels, std::uint8_t label,
                                                const Transform<frame::Voxel, frame::Probe>& planeToVoxel, const PlaneArea& area) {
  EW_EXPECTS(area.step_mm > 0.0);
  const Shares shares(labels, label);
  if (shares.empty() || area.right_mm <= area.left_mm || area.bottom_mm <= area.top_mm) return {};
  const int columns = static_cast<int>(std::ceil((area.right_mm - area.left_mm) / area.step_mm - 1e-9)) + 1,
            rows = static_cast<int>(std::ceil((area.bottom_mm - area.top_mm) / area.step_mm - 1e-9)) + 1;
  const auto pointOf = [&](double column, double row) {
    return glm::dvec2(area.left_mm + column * area.step_mm, area.top_mm + row * area.step_mm);
  };
  // A border of zeros closes what leaves the area.
  const int wide = columns + 2, high = rows + 2;
  std::vector<double> share(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0.0);
  const auto shareAt = [&](int column, int row) -> double& {
    return share[static_cast<std::size_t>(row) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(column)];
  };
  for (int row = 1; row + 1 < high; ++row)
    for (int column = 1; column + 1 < wide; ++column)
      shareAt(column, row) = shares.at(carried(planeToVoxel, {pointOf(column - 1, row - 1), 0.0}));

  // Each crossed edge is left to the next one with the inside at the right hand.
  std::map<Edge, std::vector<Edge>> next;
  const auto isIn = [&](int column, int row) { return shareAt(column, row) > 0.5; };
  for (int row = 0; row + 1 < high; ++row)
    for (int column = 0; column + 1 < wide; ++column) {
      const Edge top{column, row, 0}, left{column, row, 1}, bottom{column, row + 1, 0}, right{column + 1, row, 1};
      const int cell = (isIn(column, row) ? 1 : 0) | (isIn(column + 1, row) ? 2 : 0) | (isIn(column + 1, row + 1) ? 4 : 0) |
                       (isIn(column, row + 1) ? 8 : 0);
      const auto add = [&](const Edge& from, const Edge& to) { next[from].push_back(to); };
      switch (cell) {
        case 1:
          add(left, top);
          break;
        case 2:
          add(top, right);
          break;
        case 3:
          add(left, right);
          break;
        case 4:
          add(right, bottom);
          break;
        case 5:
          add(left, top);
          add(right, bottom);
          break;
        case 6:
          add(top, bottom);
          break;
        case 7:
          add(left, bottom);
          break;
        case 8:
          add(bottom, left);
          break;
        case 9:
          add(bottom, top);
          break;
        case 10:
          add(top, right);
          add(bottom, left);
          break;
        case 11:
          add(bottom, right);
          break;
        case 12:
          add(right, left);
          break;
        case 13:
          add(right, top);
          break;
        case 14:
          add(top, left);
          break;
        default:
          break;
      }
    }
  const auto placeOf = [&](const Edge& edge) {
    const int otherColumn = edge[0] + (edge[2] == 0 ? 1 : 0), otherRow = edge[1] + (edge[2] == 1 ? 1 : 0);
    const double a = shareAt(edge[0], edge[1]), b = shareAt(otherColumn, otherRow);
    const double at = a == b ? 0.5 : (0.5 - a) / (b - a);
    return pointOf(edge[0] - 1 + (edge[2] == 0 ? at : 0.0), edge[1] - 1 + (edge[2] == 1 ? at : 0.0));
  };
  std::vector<std::vector<glm::dvec2>> outlines;
  while (!next.empty()) {
    std::vector<glm::dvec2> outline;
    const Edge begin = next.begin()->first;
    Edge at = begin;
    do {
      outline.push_back(placeOf(at));
      const auto found = next.find(at);
      if (found == next.end()) break;
      const Edge to = found->second.back();
      found->second.pop_back();
      if (found->second.empty()) next.erase(found);
      at = to;
    } while (at != begin);
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace ew::labelling
