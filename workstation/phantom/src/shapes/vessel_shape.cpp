// Trees of vessels: their surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "ew/core/contract.h"
#include "ew/phantom/speckle.h"
#include "shapes/cone.h"
#include "shapes/vessel_tree.h"

namespace ew::phantom {
namespace {

constexpr double kPiece_mm = 3.0;
constexpr int kMostPieces = 8;         // of a branch
constexpr double kLargestFlare = 1.3;  // where a branch leaves its parent
constexpr double kWinding = 0.12;      // of a branch's length
constexpr std::size_t kInLeaf = 4;
constexpr std::uint64_t kWindingSeed = 0x77696e64696e6721ull;

glm::dvec3 directionOf(const VesselBranch& branch) {
  const glm::dvec3 along = branch.to_mm - branch.from_mm;
  const double length = glm::length(along);
  return length > 0.0 ? along / length : glm::dvec3(0.0, 0.0, 1.0);
}

/// Round cones in a hierarchy of boxes.
class TreeShape final : public Shape {
 public:
  TreeShape(VesselTree tree, std::uint64_t seed) : tree_(std::move(tree)), seed_(seed) {
    const std::vector<std::vector<int>> children = childrenOf();
    for (std::size_t n = 0; n < tree_.branches.size(); ++n) addPieces(n, children);
    order_.resize(cones_.size());
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(2 * cones_.size());
    build(0, cones_.size());
    std::vector<Cone> sorted;
    sorted.reserve(cones_.size());
    for (const int n : order_) sorted.push_back(cones_[static_cast<std::size_t>(n)]);
    cones_ = std::move(sorted);
    boxes_.clear();
    order_.clear();
    bounds_ = nodes_.front().box;
    // What a point costs: a few ways down and the leaves at their ends.
    solids_ = std::min(static_cast<double>(cones_.size()), 8.0 * kInLeaf + 2.0 * std::sqrt(static_cast<double>(cones_.size())));
  }

  double distance_mm(const glm::dvec3& p_mm) const override { return distanceUpTo_mm(p_mm, std::numeric_limits<double>::infinity()); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    double nearest = most_mm;
    double nearest2 = nearest > 0.0 ? nearest * nearest : 0.0;  // boxes are compared without a root
    std::array<std::pair<double, int>, 64> waiting;
    std::size_t count = 1;
    waiting[0] = {0.0, 0};
    while (count > 0) {
      const auto [atLeast2, number] = waiting[--count];
      if (atLeast2 > 0.0 && atLeast2 >= nearest2) continue;
      const Node& node = nodes_[static_cast<std::size_t>(number)];
      if (node.count > 0) {
        for (std::size_t n = node.first; n < node.first + node.count; ++n) nearest = std::min(nearest, cones_[n].distance_mm(p_mm));
        nearest2 = nearest > 0.0 ? nearest * nearest : 0.0;
        continue;
      }
      const int left = number + 1, right = node.right;
      const double toLeft = squaredToBox_mm2(p_mm, nodes_[static_cast<std::size_t>(left)].box);
      const double toRight = squaredToBox_mm2(p_mm, nodes_[static_cast<std::size_t>(right)].box);
      const bool leftFirst = toLeft <= toRight;
      waiting[count++] = leftFirst ? std::pair{toRight, right} : std::pair{toLeft, left};
      waiting[count++] = leftFirst ? std::pair{toLeft, left} : std::pair{toRight, right};
    }
    return nearest;
  }
  const VesselTree* vessels() const override { return &tree_; }
  const std::vector<CentreLine>* branchLines() const override { return &lines_; }

 private:
  struct Node {
    Bounds box;
    std::size_t first = 0;
    std::size_t count = 0;  ///< of a leaf; 0: its left child follows it
    int right = 0;
  };

  [[nodiscard]] std::vector<std::vector<int>> childrenOf() const {
    std::vector<std::vector<int>> children(tree_.branches.size());
    for (std::size_t n = 0; n < tree_.branches.size(); ++n)
      if (tree_.branches[n].parent >= 0) children[static_cast<std::size_t>(tree_.branches[n].parent)].push_back(static_cast<int>(n));
    return children;
  }

  /// A branch as a curve: between the directions of what it leaves and of what goes on, by strength.
  void addPieces(std::size_t number, const std::vector<std::vector<int>>& children) {
    const VesselBranch& branch = tree_.branches[number];
    const glm::dvec3 own = directionOf(branch);
    const double length = glm::distance(branch.from_mm, branch.to_mm);
    glm::dvec3 begin = own, end = own;
    double first = branch.radius_mm;
    if (branch.parent >= 0) {
      const VesselBranch& parent = tree_.branches[static_cast<std::size_t>(branch.parent)];
      const double kept = std::pow(branch.radius_mm / parent.radius_mm, 2.0);  // the stronger one goes on where its parent pointed
      begin = glm::normalize(own + 0.8 * kept * directionOf(parent));
      first = std::min(parent.radius_mm, kLargestFlare * branch.radius_mm);
    }
    if (!children[number].empty()) {
      glm::dvec3 onwards = own;
      for (const int child : children[number]) {
        const VesselBranch& next = tree_.branches[static_cast<std::size_t>(child)];
        onwards += 0.8 * std::pow(next.radius_mm / branch.radius_mm, 2.0) * directionOf(next);
      }
      if (glm::length(onwards) > 0.2) end = glm::normalize(onwards);
    }
    glm::dvec3 winding(0.0);
    if (branch.parent >= 0 || !children[number].empty())
      for (int axis = 0; axis < 3; ++axis)
        winding[axis] =
            static_cast<double>(hashOfPlace(seed_ ^ kWindingSeed, static_cast<std::int64_t>(number), axis, 0) >> 11) * 0x1.0p-52 - 1.0;
    if (branch.drawn) winding = glm::dvec3(0.0);
    const int pieces = std::clamp(static_cast<int>(std::ceil(length / kPiece_mm)), 1, kMostPieces);
    glm::dvec3 from = branch.from_mm;
    double radius = first;
    CentreLine& line = lines_.emplace_back();
    line.points_mm.emplace_back(from, radius);
    for (int piece = 1; piece <= pieces; ++piece) {
      const double t = static_cast<double>(piece) / pieces, t2 = t * t, t3 = t2 * t;
      const glm::dvec3 to = (2.0 * t3 - 3.0 * t2 + 1.0) * branch.from_mm + (t3 - 2.0 * t2 + t) * 0.7 * length * begin +
                            (3.0 * t2 - 2.0 * t3) * branch.to_mm + (t3 - t2) * 0.7 * length * end +
                            16.0 * t2 * (1.0 - t) * (1.0 - t) * kWinding * length * winding;
      const RoundCone cone{from, to, radius, branch.radius_mm};
      cones_.emplace_back(cone);
      boxes_.push_back(boundsOfCone(cone));
      from = to;
      radius = branch.radius_mm;
      line.points_mm.emplace_back(from, radius);
    }
  }

  void build(std::size_t first, std::size_t last) {
    const std::size_t number = nodes_.size();
    nodes_.emplace_back();
    Bounds box = boxes_[static_cast<std::size_t>(order_[first])];
    for (std::size_t n = first; n < last; ++n) {
      const Bounds& each = boxes_[static_cast<std::size_t>(order_[n])];
      box = {glm::min(box.lowest_mm, each.lowest_mm), glm::max(box.highest_mm, each.highest_mm)};
    }
    nodes_[number].box = box;
    if (last - first <= kInLeaf) {
      nodes_[number].first = first;
      nodes_[number].count = last - first;
      return;
    }
    const glm::dvec3 size = box.highest_mm - box.lowest_mm;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto centre = [&](int n) {
      const Bounds& each = boxes_[static_cast<std::size_t>(n)];
      return each.lowest_mm[axis] + each.highest_mm[axis];
    };
    const std::size_t middle = (first + last) / 2;
    const auto at = [&](std::size_t n) { return order_.begin() + static_cast<std::ptrdiff_t>(n); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](int a, int b) { return centre(a) < centre(b) || (centre(a) == centre(b) && a < b); });
    build(first, middle);
    nodes_[number].right = static_cast<int>(nodes_.size());
    build(middle, last);
  }

  VesselTree tree_;
  std::uint64_t seed_;
  std::vector<CentreLine> lines_;  ///< by branch
  std::vector<Cone> cones_;
  std::vector<Bounds> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace

ShapePtr makeVesselTree(VesselTree tree, std::uint64_t seed) {
  EW_EXPECTS(!tree.branches.empty());
  return std::make_shared<TreeShape>(std::move(tree), seed);
}

}  // namespace ew::phantom
