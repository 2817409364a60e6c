// Trees of vessels: how they grow.
#include "shapes/vessel_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "ew/core/contract.h"
#include "ew/phantom/speckle.h"

namespace ew::phantom {
namespace {

constexpr double kNarrowest_cos = 0.8660254037844386;  // 30 degrees
constexpr double kWidest_cos = 0.17364817766693041;    // 80 degrees
constexpr double kTrunkStep_mm = 4.0;
constexpr double kCheckStep_mm = 2.5;
constexpr int kNearest = 10;       // branches tried for an end
constexpr int kTriesPerEnd = 250;  // places tried before an organ counts as full
constexpr int kRoomsPerEnd = 60;   // forks looked at closely in all, of each end: an organ without room must not take minutes
constexpr int kPatience = 8;       // places too near to the tree before nearer ones are taken
constexpr double kShortest_mm = 1.0;
constexpr std::uint64_t kPlaceSeed = 0x76657373656c7321ull;

double evenFrom(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1.0p-53; }

/// By Newton's steps, which round the same on every machine, as the library's need not.
double cubeRoot(double x) {
  double root = std::max(1.0, x);
  for (int n = 0; n < 80; ++n) root = (2.0 * root + x / (root * root)) / 3.0;
  return root;
}

double distanceToLine2(const glm::dvec3& p, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 along = to - from, offset = p - from;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? std::clamp(glm::dot(offset, along) / squared, 0.0, 1.0) : 0.0;
  const glm::dvec3 away = offset - t * along;
  return glm::dot(away, away);
}

double cosineBetween(const glm::dvec3& a, const glm::dvec3& b) {
  const double lengths = std::sqrt(glm::dot(a, a) * glm::dot(b, b));
  return lengths > 0.0 ? glm::dot(a, b) / lengths : 1.0;
}
bool wellForked(const glm::dvec3& a, const glm::dvec3& b) {
  const double cosine = cosineBetween(a, b);
  return cosine <= kNarrowest_cos && cosine >= kWidest_cos;
}

class Grower {
 public:
  explicit Grower(const VesselGrowth& growth) : growth_(growth) {
    areas_.resize(static_cast<std::size_t>(growth.ends) + growth.trunks.size() + 2);
    for (std::size_t n = 0; n < areas_.size(); ++n) {
      const double radius = cubeRoot(static_cast<double>(n));
      areas_[n] = n == 0 ? 0.0 : radius * radius;
    }
    for (const auto& trunk : growth.trunks) addTrunk(trunk);
    for (std::size_t n = parts_.size(); n-- > 0;) {
      if (parts_[n].children.empty()) ++ends_;
      int fed = 0;
      for (const int child : parts_[n].children) fed += part(child).ends;
      parts_[n].ends = std::max(1, fed);
    }
  }

  VesselTree grow() {
    const double volume = volumeWithin_mm3();
    const int tries = kTriesPerEnd * growth_.ends;
    int failed = 0;
    double patience = 1.0;
    for (int attempt = 0; attempt < tries && rooms_ < kRoomsPerEnd * growth_.ends && ends_ < growth_.ends && volume > 0.0; ++attempt) {
      const std::optional<glm::dvec3> place = placeFor(attempt);
      if (!place) continue;
      // As large as an end's share of the organ would be if it were the last: the first ends lie far apart, the later fill the gaps.
      const double apart = 0.7 * cubeRoot(volume / (ends_ + 1)) * patience;
      if (nearestDistance_mm(*place) >= apart && join(*place)) {
        ++ends_;
        failed = 0;
        patience = 1.0;
      } else if (++failed % kPatience == 0) {
        patience *= 0.9;
      }
    }
    return inOrder();
  }

 private:
  struct Part {
    glm::dvec3 from;
    glm::dvec3 to;
    int parent = -1;
    std::vector<int> children;
    int ends = 1;
    bool drawn = false;
  };
  struct Joint {
    int part = -1;
    glm::dvec3 at{0.0};
    double cost = 0.0;
  };

  [[nodiscard]] Part& part(int n) { return parts_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const Part& part(int n) const { return parts_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] double area(int ends) const { return areas_[static_cast<std::size_t>(ends)]; }

  void addTrunk(const std::vector<glm::dvec3>& drawn) {
    // Leaves an earlier trunk at its nearest joint, if one is there.
    constexpr double kJoins_mm = 6.0;
    int parent = -1;
    glm::dvec3 from = drawn.front();
    double nearest = kJoins_mm;
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      const double d = glm::distance(parts_[n].to, drawn.front());
      if (d >= nearest) continue;
      nearest = d;
      parent = static_cast<int>(n);
      from = parts_[n].to;
    }
    for (std::size_t n = 1; n < drawn.size(); ++n) {
      const glm::dvec3 start = from;
      if (glm::distance(start, drawn[n]) < 1e-3) continue;
      const int steps = std::max(1, static_cast<int>(glm::distance(start, drawn[n]) / kTrunkStep_mm));
      for (int step = 1; step <= steps; ++step) {
        const glm::dvec3 to = glm::mix(start, drawn[n], static_cast<double>(step) / steps);
        parts_.push_back({from, to, parent, {}, 1, true});
        const int made = static_cast<int>(parts_.size()) - 1;
        if (parent >= 0) part(parent).children.push_back(made);
        parent = made;
        from = to;
      }
    }
  }

  [[nodiscard]] glm::dvec3 anywhere(int attempt) const {
    const Bounds& box = growth_.within->bounds();
    glm::dvec3 share;
    for (int axis = 0; axis < 3; ++axis) share[axis] = evenFrom(hashOfPlace(growth_.seed ^ kPlaceSeed, attempt, axis, 0));
    return box.lowest_mm + share * (box.highest_mm - box.lowest_mm);
  }
  [[nodiscard]] double volumeWithin_mm3() const {
    constexpr int kSamples = 2000;
    int inside = 0;
    for (int n = 0; n < kSamples; ++n) inside += growth_.within->distance_mm(anywhere(-1 - n)) < 0.0;
    const glm::dvec3 size = growth_.within->bounds().highest_mm - growth_.within->bounds().lowest_mm;
    return size.x * size.y * size.z * inside / kSamples;
  }
  [[nodiscard]] std::optional<glm::dvec3> placeFor(int attempt) const {
    const glm::dvec3 place = anywhere(attempt);
    if (growth_.within->distance_mm(place) > -growth_.margin_mm) return std::nullopt;
    for (const ShapePtr& other : growth_.avoid)
      if (other->distance_mm(place) < growth_.clearance_mm + growth_.endRadius_mm) return std::nullopt;
    return place;
  }
  [[nodiscard]] double nearestDistance_mm(const glm::dvec3& place) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Part& each : parts_) nearest = std::min(nearest, distanceToLine2(place, each.from, each.to));
    return std::sqrt(nearest);
  }

  /// Joins an end at the cheapest of the nearest branches where the fork is well formed and its branches have room.
  bool join(const glm::dvec3& end) {
    std::vector<std::pair<double, int>> order;
    order.reserve(parts_.size());
    for (std::size_t n = 0; n < parts_.size(); ++n)
      order.emplace_back(distanceToLine2(end, parts_[n].from, parts_[n].to), static_cast<int>(n));
    const std::size_t tried = std::min<std::size_t>(kNearest, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(tried), order.end());
    std::vector<Joint> joints;
    for (std::size_t n = 0; n < tried; ++n) addJoints(order[n].second, end, joints);
    std::sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.cost < b.cost; });
    for (const Joint& joint : joints) {
      ++rooms_;
      if (!hasRoom(joint, end)) continue;
      insert(joint, end);
      return true;
    }
    return false;
  }

  void addJoints(int number, const glm::dvec3& end, std::vector<Joint>& joints) const {
    const Part& old = part(number);
    const glm::dvec3 along = old.to - old.from;
    if (old.drawn) {
      for (const double t : {0.25, 0.5, 0.75}) addJoint(number, old.from + t * along, end, joints);
      return;
    }
    // Where three vessels of these strengths meet with least volume: Weiszfeld's steps.
    const std::array<glm::dvec3, 3> corners{old.from, old.to, end};
    const std::array<double, 3> weights{area(old.ends + 1), area(old.ends), area(1)};
    glm::dvec3 at = (old.from + old.to + end) / 3.0;
    for (int step = 0; step < 10; ++step) {
      glm::dvec3 sum(0.0);
      double total = 0.0;
      for (std::size_t n = 0; n < corners.size(); ++n) {
        const double pull = weights[n] / std::max(1e-6, glm::distance(at, corners[n]));
        sum += pull * corners[n];
        total += pull;
      }
      at = sum / total;
    }
    // A thin branch would leave a strong one nearly at a right angle; vessels leave earlier and more slanting.
    for (const double back : {0.0, 0.25, 0.5, 0.7}) addJoint(number, glm::mix(at, old.from, back), end, joints);
  }

  void addJoint(int number, const glm::dvec3& at, const glm::dvec3& end, std::vector<Joint>& joints) const {
    const Part& old = part(number);
    const double shortest = std::max(kShortest_mm, growth_.endRadius_mm);
    if (glm::distance(at, old.from) < (old.drawn ? 0.5 : shortest) || glm::distance(at, old.to) < (old.drawn ? 0.5 : shortest) ||
        glm::distance(at, end) < 3.0 * shortest)
      return;
    if (!wellForked(old.to - at, end - at)) return;
    if (!old.drawn) {
      // Neither the vessel above nor the one below may turn sharply, and the fork above must stay well formed.
      if (cosineBetween(at - old.from, old.to - at) < 0.5) return;
      if (old.parent >= 0) {
        for (const int sibling : part(old.parent).children)
          if (sibling != number && !wellForked(part(sibling).to - old.from, at - old.from)) return;
        if (cosineBetween(at - old.from, part(old.parent).to - part(old.parent).from) < kWidest_cos) return;
      }
      for (const int child : old.children)
        if (cosineBetween(old.to - at, part(child).to - part(child).from) < kWidest_cos) return;
    }
    double cost = area(1) * glm::distance(at, end) + area(old.ends + 1) * glm::distance(old.from, at) +
                  area(old.ends) * (glm::distance(at, old.to) - glm::distance(old.from, old.to));
    for (int up = old.parent; up >= 0; up = part(up).parent)
      cost += (area(part(up).ends + 1) - area(part(up).ends)) * glm::distance(part(up).from, part(up).to);
    joints.push_back({number, at, cost});
  }

  [[nodiscard]] bool freeAlong(const glm::dvec3& from, const glm::dvec3& to, double radius) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / kCheckStep_mm)));
    for (int n = 1; n <= steps; ++n) {
      const glm::dvec3 p = glm::mix(from, to, static_cast<double>(n) / steps);
      if (growth_.within->distance_mm(p) > -(growth_.margin_mm / 3.0 + radius)) return false;
      for (const ShapePtr& other : growth_.avoid)
        if (other->distance_mm(p) < growth_.clearance_mm + radius) return false;
    }
    return true;
  }
  [[nodiscard]] double radiusOf_mm(int ends) const { return growth_.endRadius_mm * std::sqrt(area(ends)); }

  [[nodiscard]] bool hasRoom(const Joint& joint, const glm::dvec3& end) const {
    const Part& old = part(joint.part);
    if (!freeAlong(joint.at, end, growth_.endRadius_mm)) return false;
    if (!old.drawn && (!freeAlong(old.from, joint.at, radiusOf_mm(old.ends + 1)) || !freeAlong(joint.at, old.to, radiusOf_mm(old.ends))))
      return false;
    // The new branch keeps away from all others, but for its own beginning.
    const double length = glm::distance(joint.at, end),
                 begin = std::min(0.6, (radiusOf_mm(old.ends + 1) + growth_.clearance_mm + 2.0) / length);
    for (double t = 1.0; t >= begin; t -= std::max(0.1, kCheckStep_mm / length)) {
      const glm::dvec3 p = glm::mix(joint.at, end, t);
      for (std::size_t n = 0; n < parts_.size(); ++n) {
        const bool own = static_cast<int>(n) == joint.part || (old.drawn && part(static_cast<int>(n)).drawn);
        const double room = radiusOf_mm(parts_[n].ends) + growth_.endRadius_mm + (own ? 0.0 : 0.5 * growth_.clearance_mm);
        if (distanceToLine2(p, parts_[n].from, parts_[n].to) < room * room) return false;
      }
    }
    return true;
  }

  void insert(const Joint& joint, const glm::dvec3& end) {
    const int lower = static_cast<int>(parts_.size()), made = lower + 1;
    Part below = part(joint.part);
    below.from = joint.at;
    below.parent = joint.part;
    for (const int child : below.children) part(child).parent = lower;
    parts_.push_back(std::move(below));
    parts_.push_back({joint.at, end, joint.part, {}, 1, false});
    Part& upper = part(joint.part);
    upper.to = joint.at;
    upper.children = {lower, made};
    for (int up = joint.part; up >= 0; up = part(up).parent) ++part(up).ends;
  }

  [[nodiscard]] VesselTree inOrder() const {
    VesselTree tree;
    std::vector<std::pair<int, int>> waiting;  // a part and the place of its parent's branch
    for (std::size_t n = parts_.size(); n-- > 0;)
      if (parts_[n].parent < 0) waiting.emplace_back(static_cast<int>(n), -1);
    while (!waiting.empty()) {
      const auto [number, parent] = waiting.back();
      waiting.pop_back();
      const Part& each = part(number);
      tree.branches.push_back({each.from, each.to, radiusFeeding_mm(each.ends, growth_.endRadius_mm), parent, each.drawn});
      for (const int child : each.children) waiting.emplace_back(child, static_cast<int>(tree.branches.size()) - 1);
    }
    return tree;
  }

  const VesselGrowth& growth_;
  std::vector<Part> parts_;
  std::vector<double> areas_;  ///< by ends fed: the square of the radius, of an end's
  int ends_ = 0;
  int rooms_ = 0;  ///< forks looked at closely
};

}  // namespace

double radiusFeeding_mm(int ends, double endRadius_mm) { return endRadius_mm * cubeRoot(static_cast<double>(ends)); }

VesselTree growVesselTree(const VesselGrowth& growth) {
  EW_EXPECTS(growth.within && growth.ends > 0 && growth.endRadius_mm > 0.0 && !growth.trunks.empty());
  return Grower(growth).grow();
}

VesselTree vesselsBeside(const VesselTree& tree, const VesselsBeside& beside) {
  VesselTree made;
  std::vector<int> copies(tree.branches.size(), -1);
  std::vector<glm::dvec3> sides(tree.branches.size(), beside.side);
  for (std::size_t n = 0; n < tree.branches.size(); ++n) {
    const VesselBranch& of = tree.branches[n];
    glm::dvec3 side = of.parent >= 0 ? sides[static_cast<std::size_t>(of.parent)] : beside.side;
    const glm::dvec3 along = glm::normalize(of.to_mm - of.from_mm);
    side -= glm::dot(side, along) * along;
    if (glm::length(side) < 0.1) side = glm::cross(along, glm::dvec3(along.y, along.z, along.x) + glm::dvec3(0.3, 0.1, 0.7));
    side = glm::normalize(side);
    sides[n] = side;
    if (of.radius_mm < beside.leastRadius_mm) continue;
    const int parent = of.parent >= 0 ? copies[static_cast<std::size_t>(of.parent)] : -1;
    if (of.parent >= 0 && parent < 0) continue;
    const double radius = beside.ratio * of.radius_mm, away = of.radius_mm + radius + beside.gap_mm;
    const glm::dvec3 from = parent >= 0 ? made.branches[static_cast<std::size_t>(parent)].to_mm : of.from_mm + away * side;
    copies[n] = static_cast<int>(made.branches.size());
    made.branches.push_back({from, of.to_mm + away * side, radius, parent, of.drawn});
  }
  return made;
}

}  // namespace ew::phantom
