#include "ew/labelling/outline.h"

#include <array>
#include <cmath>
#include <map>

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

/// The shares at the points of a grid over the area, within a border of zeros that closes what leaves it.
class ShareGrid {
 public:
  ShareGrid(const Shares& shares, const Transform<frame::Voxel, frame::Probe>& planeToVoxel, const PlaneArea& area)
      : area_(area), wide_(pointsAlong(area.right_mm - area.left_mm)), high_(pointsAlong(area.bottom_mm - area.top_mm)) {
    share_.resize(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_), 0.0);
    for (int row = 1; row + 1 < high_; ++row)
      for (int column = 1; column + 1 < wide_; ++column)
        share_[indexOf(column, row)] = shares.at(carried(planeToVoxel, {pointOf(column - 1, row - 1), 0.0}));
  }

  [[nodiscard]] int wide() const { return wide_; }
  [[nodiscard]] int high() const { return high_; }
  [[nodiscard]] bool isIn(int column, int row) const { return share_[indexOf(column, row)] > 0.5; }

  /// Where the outline crosses an edge, mm.
  [[nodiscard]] glm::dvec2 crossing(const Edge& edge) const {
    const auto& [column, row, downwards] = edge;
    const double a = share_[indexOf(column, row)], b = share_[indexOf(column + 1 - downwards, row + downwards)];
    const double at = a == b ? 0.5 : (0.5 - a) / (b - a);
    return pointOf(column - 1 + (downwards == 0 ? at : 0.0), row - 1 + (downwards == 1 ? at : 0.0));
  }

 private:
  [[nodiscard]] int pointsAlong(double length_mm) const { return static_cast<int>(std::ceil(length_mm / area_.step_mm - 1e-9)) + 3; }
  [[nodiscard]] std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] glm::dvec2 pointOf(double column, double row) const {
    return {area_.left_mm + column * area_.step_mm, area_.top_mm + row * area_.step_mm};
  }

  PlaneArea area_;
  int wide_, high_;
  std::vector<double> share_;
};

/// The edges that follow each crossed one.
using Followers = std::map<Edge, std::vector<Edge>>;

Followers followersIn(const ShareGrid& grid) {
  // The pieces of outline in a cell by which of its corners are inside (1, 2, 4, 8: clockwise from the upper left): from the side that a
  // piece comes from to the one it leaves by, the inside at its right hand. -1: none.
  enum Side { top, right, bottom, left };
  static constexpr std::array<std::array<int, 4>, 16> kPieces{{{-1, -1, -1, -1},
                                                               {left, top, -1, -1},
                                                               {top, right, -1, -1},
                                                               {left, right, -1, -1},
                                                               {right, bottom, -1, -1},
                                                               {left, top, right, bottom},
                                                               {top, bottom, -1, -1},
                                                               {left, bottom, -1, -1},
                                                               {bottom, left, -1, -1},
                                                               {bottom, top, -1, -1},
                                                               {top, right, bottom, left},
                                                               {bottom, right, -1, -1},
                                                               {right, left, -1, -1},
                                                               {right, top, -1, -1},
                                                               {top, left, -1, -1},
                                                               {-1, -1, -1, -1}}};
  Followers next;
  for (int row = 0; row + 1 < grid.high(); ++row)
    for (int column = 0; column + 1 < grid.wide(); ++column) {
      const std::array<Edge, 4> sides{{{column, row, 0}, {column + 1, row, 1}, {column, row + 1, 0}, {column, row, 1}}};
      const int corners = (grid.isIn(column, row) ? 1 : 0) | (grid.isIn(column + 1, row) ? 2 : 0) |
                          (grid.isIn(column + 1, row + 1) ? 4 : 0) | (grid.isIn(column, row + 1) ? 8 : 0);
      const auto& pieces = kPieces[static_cast<std::size_t>(corners)];
      for (std::size_t n = 0; n < pieces.size() && pieces[n] >= 0; n += 2)
        next[sides[static_cast<std::size_t>(pieces[n])]].push_back(sides[static_cast<std::size_t>(pieces[n + 1])]);
    }
  return next;
}

/// One outline, taken out of `next`, which is not empty.
std::vector<glm::dvec2> takeOutline(Followers& next, const ShareGrid& grid) {
  std::vector<glm::dvec2> outline;
  const Edge begin = next.begin()->first;
  Edge at = begin;
  do {
    outline.push_back(grid.crossing(at));
    const auto found = next.find(at);
    if (found == next.end()) break;
    const Edge to = found->second.back();
    found->second.pop_back();
    if (found->second.empty()) next.erase(found);
    at = to;
  } while (at != begin);
  return outline;
}

}  // namespace

std::vector<std::vector<glm::dvec2>> outlinesOf(const Volume& labels, std::uint8_t label,
                                                const Transform<frame::Voxel, frame::Probe>& planeToVoxel, const PlaneArea& area) {
  EW_EXPECTS(area.step_mm > 0.0);
  const Shares shares(labels, label);
  if (shares.empty() || area.right_mm <= area.left_mm || area.bottom_mm <= area.top_mm) return {};
  const ShareGrid grid(shares, planeToVoxel, area);
  Followers next = followersIn(grid);
  std::vector<std::vector<glm::dvec2>> outlines;
  while (!next.empty()) outlines.push_back(takeOutline(next, grid));
  return outlines;
}

}  // namespace ew::labelling
