#include "seam_cut.h"

#include <algorithm>
#include <cmath>

#include "grid_flow.h"
#include "joiner.h"

namespace ew::stitching {
namespace {

// Costs are whole numbers, so that no order of adding them changes the cut. A grey level is worth kGrey.
constexpr double kGrey = 16.0;
/// A cell that a view did not see well costs as much as a seam face where the views differ by so many grey levels.
constexpr double kShadow_grey = 30.0;
/// The same for a cell that it does not cover at all.
constexpr double kAbsent_grey = 60.0;
/// What a face costs where the views agree: keeps seams short and smooth.
constexpr double kFace_grey = 2.0;
/// The same where the two views have nothing in common: there is no choice but to pass there.
constexpr double kBlind_grey = 40.0;
/// From this far inside, a view's border is no longer felt.
constexpr double kInside_mm = 15.0;
/// More than that within a blend's width of the border: a seam that has room leaves the blend whole.
constexpr double kMargin_grey = 80.0;
constexpr int kMostSweeps = 6;

/// What it costs to take a view for a cell of its box.
std::vector<std::uint16_t> costsOf(const ViewSurvey& survey, std::span<const float> distance_mm, const SeamOptions& options) {
  std::vector<std::uint16_t> costs(survey.share.size());
  for (std::size_t c = 0; c < costs.size(); ++c) {
    const double doubt = 1.0 - survey.trust[c] / ViewSurvey::kFull;
    const double absent = 1.0 - survey.share[c] / ViewSurvey::kFull;
    const double margin = options.blend_mm > 0.0 ? std::max(0.0, 1.0 - static_cast<double>(distance_mm[c]) / options.blend_mm) : 0.0;
    const double near = 1.0 - static_cast<double>(distance_mm[c]) / kInside_mm;
    const double grey = options.confidenceWeight * kShadow_grey * std::max(0.0, doubt - absent) + kAbsent_grey * absent +
                        options.distanceWeight * (kShadow_grey * near + kMargin_grey * margin);
    costs[c] = static_cast<std::uint16_t>(std::min(65535.0, std::round(kGrey * grey)));
  }
  return costs;
}

class Expansion {
 public:
  Expansion(std::span<const ViewSurvey> surveys, std::span<const std::uint8_t> forced, SeamMap& map)
      : surveys_(surveys), forced_(forced), map_(map), costs_(surveys.size()) {
    // A face counts by its area, a cell by its volume; equal cells count 1.
    const glm::dvec3 s = map.cells.spacing_mm;
    const double side = std::cbrt(s.x * s.y * s.z);
    for (int axis = 0; axis < 3; ++axis) area_[axis] = side / s[axis];
  }
  std::vector<std::uint16_t>& costs(std::size_t view) { return costs_[view]; }

  /// Every cell to the view that costs least by itself; of equals to the first.
  void begin() {
    std::vector<std::uint16_t> least(map_.view.size(), 0xffff);
    for (std::size_t n = 0; n < surveys_.size(); ++n)
      forEachCell(surveys_[n].box, [&](std::size_t own, std::size_t cell) {
        if (!surveys_[n].covers(own) || (map_.view[cell] != 0 && costs_[n][own] >= least[cell])) return;
        least[cell] = costs_[n][own];
        map_.view[cell] = static_cast<std::uint8_t>(n + 1);
      });
    for (std::size_t c = 0; c < forced_.size(); ++c)
      if (forced_[c] != 0) map_.view[c] = forced_[c];
  }

  /// Lets one view take cells from others. @return cells taken; empty when stopped
  template <class Stopped>
  std::optional<std::size_t> expand(std::size_t view, const Stopped& stopped) {
    const CellBox box = contested(view);
    if (box.count() == 0) return std::size_t{0};
    const ViewSurvey& survey = surveys_[view];
    const auto taker = static_cast<std::uint8_t>(view + 1);
    GridFlow flow(box.size());
    const auto nodeOf = [&](const glm::ivec3& p) { return flow.nodeOf(p.x - box.begin.x, p.y - box.begin.y, p.z - box.begin.z); };
    for (int k = box.begin.z; k < box.end.z; ++k) {
      if (stopped()) return std::nullopt;
      for (int j = box.begin.y; j < box.end.y; ++j)
        for (int i = box.begin.x; i < box.end.x; ++i) {
          const glm::ivec3 p(i, j, k);
          if (!mayTake(view, p)) continue;
          const std::uint8_t keeper = labelAt(p);
          const std::size_t node = nodeOf(p);
          flow.addCosts(node, costs_[view][survey.box.indexOf(i, j, k)], costOf(keeper, p));
          for (int towards = 0; towards < 6; ++towards) {
            const int axis = towards / 2;
            glm::ivec3 q = p;
            q[axis] += (towards & 1) != 0 ? 1 : -1;
            if (q[axis] < 0 || q[axis] >= map_.cells.dims[axis]) continue;
            const std::uint8_t other = labelAt(q);
            if (other == 0) continue;
            if (!mayTake(view, q)) {
              flow.addCosts(node, face(taker, other, p, q, axis), face(keeper, other, p, q, axis));
              continue;
            }
            if ((towards & 1) == 0) continue;  // each face between two free cells once, from its lower cell
            const std::int32_t keep = face(keeper, other, p, q, axis);
            const std::int32_t second = face(keeper, taker, p, q, axis);  // only the neighbour is taken
            const std::int32_t first = face(taker, other, p, q, axis);
            // Kolmogorov and Zabih's splitting; where views that end break the triangle, staying as it is counts less (Rother et al. 2005).
            const std::int32_t kept = std::min(keep, first + second);
            flow.addCosts(node, first - kept, 0);
            flow.addCosts(nodeOf(q), -first, 0);
            flow.addLink(node, static_cast<GridFlow::Towards>(towards), first + second - kept, 0);
          }
        }
    }
    if (!flow.solve(stopped)) return std::nullopt;
    std::size_t taken = 0;
    for (int k = box.begin.z; k < box.end.z; ++k)
      for (int j = box.begin.y; j < box.end.y; ++j)
        for (int i = box.begin.x; i < box.end.x; ++i)
          if (mayTake(view, {i, j, k}) && flow.onSinkSide(nodeOf({i, j, k}))) {
            map_.view[map_.cells.indexOf(i, j, k)] = taker;
            ++taken;
          }
    return taken;
  }

 private:
  template <class Take>
  void forEachCell(const CellBox& box, const Take& take) const {
    std::size_t own = 0;
    for (int k = box.begin.z; k < box.end.z; ++k)
      for (int j = box.begin.y; j < box.end.y; ++j) {
        std::size_t cell = map_.cells.indexOf(box.begin.x, j, k);
        for (int i = box.begin.x; i < box.end.x; ++i) take(own++, cell++);
      }
  }
  [[nodiscard]] std::uint8_t labelAt(const glm::ivec3& p) const { return map_.view[map_.cells.indexOf(p.x, p.y, p.z)]; }
  [[nodiscard]] std::int64_t costOf(std::uint8_t label, const glm::ivec3& p) const {
    return costs_[label - 1u][surveys_[label - 1u].box.indexOf(p.x, p.y, p.z)];
  }
  /// Cells with another view that this one covers and nobody painted.
  [[nodiscard]] bool mayTake(std::size_t view, const glm::ivec3& p) const {
    const ViewSurvey& survey = surveys_[view];
    if (!survey.box.contains(p.x, p.y, p.z) || !survey.covers(survey.box.indexOf(p.x, p.y, p.z))) return false;
    const std::size_t cell = map_.cells.indexOf(p.x, p.y, p.z);
    return map_.view[cell] != view + 1 && (forced_.empty() || forced_[cell] == 0);
  }
  /// The box of all cells that the view might take.
  [[nodiscard]] CellBox contested(std::size_t view) const {
    const CellBox& all = surveys_[view].box;
    CellBox box{all.end, all.begin};
    for (int k = all.begin.z; k < all.end.z; ++k)
      for (int j = all.begin.y; j < all.end.y; ++j)
        for (int i = all.begin.x; i < all.end.x; ++i)
          if (mayTake(view, {i, j, k})) {
            box.begin = glm::min(box.begin, glm::ivec3(i, j, k));
            box.end = glm::max(box.end, glm::ivec3(i, j, k) + 1);
          }
    if (box.begin.x >= box.end.x) return {};
    return box;
  }
  /// What it costs to pass from view a in cell p to view b in cell q.
  [[nodiscard]] std::int32_t face(std::uint8_t a, std::uint8_t b, const glm::ivec3& p, const glm::ivec3& q, int axis) const {
    if (a == b) return 0;
    const ViewSurvey& one = surveys_[a - 1u];
    const ViewSurvey& other = surveys_[b - 1u];
    double sum = 0.0;
    int seen = 0;
    for (const glm::ivec3* cell : {&p, &q}) {
      const auto x = one.levelAt(cell->x, cell->y, cell->z);
      const auto y = other.levelAt(cell->x, cell->y, cell->z);
      if (!x || !y) continue;
      sum += std::abs(*x - *y);
      ++seen;
    }
    const double grey = kFace_grey + (seen > 0 ? sum / seen : kBlind_grey);
    return static_cast<std::int32_t>(std::lround(kGrey * grey * area_[axis]));
  }

  std::span<const ViewSurvey> surveys_;
  std::span<const std::uint8_t> forced_;
  SeamMap& map_;
  std::vector<std::vector<std::uint16_t>> costs_;
  glm::dvec3 area_{1.0};
};

}  // namespace

Result<void> cutSeams(std::span<const ViewSurvey> surveys, std::span<const std::uint8_t> forced, const SeamOptions& options, SeamMap& map,
                      Progress& progress) {
  Expansion expansion(surveys, forced, map);
  for (std::size_t n = 0; n < surveys.size(); ++n) {
    PartOfProgress part(progress, 0.3 * static_cast<double>(n) / static_cast<double>(surveys.size()),
                        0.3 * static_cast<double>(n + 1) / static_cast<double>(surveys.size()));
    if (surveys[n].box.count() == 0) continue;
    auto distance = surveys[n].distanceFromBorder_mm(map.cells, kInside_mm, options.threads, part);
    if (!distance) return passOn(distance.error());
    expansion.costs(n) = costsOf(surveys[n], *distance, options);
  }
  expansion.begin();
  const auto stopped = [&] { return progress.cancelRequested(); };
  // A view is asked again only when another took cells since.
  std::size_t idle = 0;
  const std::size_t turns = surveys.size() * kMostSweeps;
  for (std::size_t turn = 0; turn < turns && idle < surveys.size(); ++turn) {
    progress.report(say<"Cutting seams">(), 0.3 + 0.7 * static_cast<double>(turn) / static_cast<double>(turns));
    const auto taken = expansion.expand(turn % surveys.size(), stopped);
    if (!taken) return stitchingCancelled();
    idle = *taken == 0 ? idle + 1 : 0;
  }
  return {};
}

}  // namespace ew::stitching
