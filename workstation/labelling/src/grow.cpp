#include "ew/labelling/grow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "gaussian.h"
#include "voxel_boxes.h"

namespace ew::labelling {
namespace {

constexpr double kNeighbourhood_mm = 3.0;    // of the seed, from which the band is chosen
constexpr double kFirstLook_mm = 0.4;        // of averaging, to see how thick a structure is
constexpr double kFirstStep_levels = 20.0;   // by so much what lies around a structure differs from it
constexpr double kWidestBand_levels = 48.0;  // half of it: more is several tissues
constexpr double kSmoothedShare = 0.25;      // of the half thickness, at most: more would mix a thin vessel with its walls
constexpr double kNeighbourhoodShare = 0.6;  // of the half thickness
constexpr std::array<glm::ivec3, 6> kFaces = {glm::ivec3(1, 0, 0),  glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
                                              glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1),  glm::ivec3(0, 0, -1)};

using Mask = Block<std::uint8_t>;

/// One growing: the steps of growFrom, on the box of the labels' grid that the reach allows.
class Growing {
 public:
  Growing(const Volume& labels, const Volume& echo, const Grid& echoGrid, const glm::dvec3& seed_mm, const GrowOptions& options,
          const VoxelBox& box, const glm::ivec3& seed, Progress& progress)
      : labels_(labels),
        echo_(echo),
        echoGrid_(echoGrid),
        seed_mm_(seed_mm),
        options_(options),
        seed_(seed),
        progress_(progress),
        level_(box),
        like_(box),
        perMm_(voxelsPerMm(labels.grid)) {}

  /// False: cancelled.
  bool run(GrowResult& result) {
    if (!sample() || !fit() || !blur(level_, options_.smoothing_mm * perMm_, progress_)) return false;
    step(0.5);
    if (!chooseBand(result)) return true;
    if (!markLike(result)) return false;
    step(0.7);
    if (!openPassages()) return false;
    step(0.85);
    if (!flood(result)) return false;
    return true;
  }
  [[nodiscard]] const Mask& grown() const { return like_; }

 private:
  void step(double fraction) const { progress_.report(say<"Growing from the seed">(), fraction); }
  [[nodiscard]] bool stopped() const { return progress_.cancelRequested(); }

  /// The mean of the echoes about each voxel's centre, at the corners of a box half a voxel wide; -1 where there are none.
  bool sample() {
    const auto toEcho = echoGrid_.worldToVoxel() * labels_.grid.voxelToWorld();
    const Grid& grid = echo_.grid;
    const glm::mat4 matrix(toEcho.matrix);
    int layer = level_.box().first.z - 1;
    bool isStopped = false;
    present_.assign(level_.values().size(), false);
    std::size_t n = 0;
    level_.forEach([&](int i, int j, int k, float& value) {
      if (k != layer) {
        layer = k;
        isStopped = isStopped || stopped();
      }
      const std::size_t here = n++;
      value = 0.0F;
      if (isStopped) return;
      float sum = 0.0F;
      int count = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 at(static_cast<float>(i) + ((corner & 1) != 0 ? 0.25F : -0.25F),
                           static_cast<float>(j) + ((corner & 2) != 0 ? 0.25F : -0.25F),
                           static_cast<float>(k) + ((corner & 4) != 0 ? 0.25F : -0.25F), 1.0F);
        const glm::ivec3 voxel(glm::floor(glm::vec3(matrix * at) + 0.5F));
        if (!grid.contains(voxel)) continue;
        const std::size_t index = grid.indexOf(voxel.x, voxel.y, voxel.z);
        if (echo_.coverageAt(index) == Coverage::absent) continue;
        sum += echo_.echo[index];
        ++count;
      }
      if (count == 0) return;
      present_[here] = true;
      value = sum / static_cast<float>(count);
    });
    return !isStopped;
  }

  /// Scales fit the structure: in a thin one less is averaged, the seed's neighbourhood is smaller, and narrower passages belong to it.
  bool fit() {
    Block<float> looked = level_;
    // Of a voxel at least: single grains are no structure.
    const double voxel_mm = 1.0 / std::min({perMm_.x, perMm_.y, perMm_.z});
    if (!blur(looked, std::min(std::max(kFirstLook_mm, voxel_mm), options_.smoothing_mm) * perMm_, progress_)) return false;
    const double half_mm = halfThickness_mm(looked);
    options_.smoothing_mm = std::min(options_.smoothing_mm, std::max(kSmoothedShare * half_mm, voxel_mm));
    options_.neck_mm = std::min(options_.neck_mm, half_mm);
    neighbourhood_mm_ = std::min(kNeighbourhood_mm, kNeighbourhoodShare * half_mm);
    return true;
  }
  /// How far echoes stay as they are about the seed, in the quarter of all directions in which they do so least; no more than matters.
  [[nodiscard]] double halfThickness_mm(const Block<float>& looked) const {
    const double step_mm = 0.5 / std::max({perMm_.x, perMm_.y, perMm_.z}), most_mm = kNeighbourhood_mm / kNeighbourhoodShare;
    const double here = static_cast<double>(looked[seed_]);
    const auto isLike = [&](const glm::dvec3& at) {
      const glm::ivec3 voxel(glm::floor(at + 0.5));
      return looked.contains(voxel) && present_[looked.indexOf(voxel)] &&
             std::abs(static_cast<double>(looked[voxel]) - here) <= kFirstStep_levels;
    };
    std::vector<double> ways_mm;
    for (int n = 0; n < 27; ++n) {
      const glm::dvec3 way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (n == 13) continue;
      double reached_mm = 0.0;
      while (reached_mm < most_mm && isLike(glm::dvec3(seed_) + reached_mm * glm::normalize(way) * perMm_)) reached_mm += step_mm;
      ways_mm.push_back(reached_mm);
    }
    return std::max(valueAtRank(std::span(ways_mm), ways_mm.size() / 4), 2.0 * step_mm);
  }

  /// Slope of the averaged echo, levels a mm.
  [[nodiscard]] double slopeAt(const glm::ivec3& at) const {
    glm::dvec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 low = at, high = at;
      if (at[axis] > level_.box().first[axis]) --low[axis];
      if (at[axis] + 1 < level_.box().end[axis]) ++high[axis];
      if (high[axis] == low[axis]) continue;
      slope[axis] = static_cast<double>(level_[high] - level_[low]) / (high[axis] - low[axis]) * perMm_[axis];
    }
    return glm::length(slope);
  }
  [[nodiscard]] bool isEdge(const glm::ivec3& at) const {
    return options_.edge_levelsPerMm > 0.0 && slopeAt(at) > options_.edge_levelsPerMm;
  }
  [[nodiscard]] double fromSeed_mm(const glm::ivec3& at) const {
    return glm::distance(carried(labels_.grid.voxelToWorld(), glm::dvec3(at)), seed_mm_);
  }

  bool chooseBand(GrowResult& result) {
    if (!present_[level_.indexOf(seed_)] || isEdge(seed_)) return false;
    double sum = 0.0, squares = 0.0;
    int count = 0;
    const glm::ivec3 reach = glm::ivec3(glm::ceil(neighbourhood_mm_ * perMm_));
    for (int k = seed_.z - reach.z; k <= seed_.z + reach.z; ++k)
      for (int j = seed_.y - reach.y; j <= seed_.y + reach.y; ++j)
        for (int i = seed_.x - reach.x; i <= seed_.x + reach.x; ++i) {
          const glm::ivec3 at(i, j, k);
          if (!level_.contains(at) || !present_[level_.indexOf(at)] || fromSeed_mm(at) > neighbourhood_mm_ || isEdge(at)) continue;
          const double value = level_[at];
          sum += value;
          squares += value * value;
          ++count;
        }
    if (count == 0) return false;
    const double mean = sum / count, deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    const double half = std::max(options_.leastBand_levels, std::min(options_.bandWidth * deviation, kWidestBand_levels));
    result.lowest_level = mean - half;
    result.highest_level = mean + half;
    return true;
  }

  bool markLike(const GrowResult& result) {
    std::size_t n = 0;
    int layer = -1;
    bool isStopped = false;
    like_.forEach([&](int i, int j, int k, std::uint8_t& is) {
      if (k != layer) {
        layer = k;
        isStopped = isStopped || stopped();
      }
      const std::size_t here = n++;
      const glm::ivec3 at(i, j, k);
      const double level = level_[at];
      is = !isStopped && present_[here] && level >= result.lowest_level && level <= result.highest_level &&
                   fromSeed_mm(at) <= options_.reach_mm && !isEdge(at)
               ? 1
               : 0;
    });
    return !isStopped;
  }

  /// Which voxels lie within radius_mm of one that is (or is not) in the mask, by distances along the axes, one after another (exact).
  bool spread(Mask& mask, double radius_mm, std::uint8_t value) {
    const glm::ivec3 size = mask.size();
    const double far = 1e9;
    std::vector<double> distance2(mask.values().size());
    for (std::size_t n = 0; n < distance2.size(); ++n) distance2[n] = mask.values()[n] == value ? 0.0 : far;
    const std::size_t strides[3] = {1, static_cast<std::size_t>(size.x),
                                    static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)};
    std::vector<double> line;
    for (int axis = 0; axis < 3; ++axis) {
      const double step_mm = 1.0 / perMm_[axis];
      const int reach = static_cast<int>(std::floor(radius_mm / step_mm));
      const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
      line.resize(static_cast<std::size_t>(size[axis]));
      for (int y = 0; y < size[b]; ++y) {
        if (stopped()) return false;
        for (int x = 0; x < size[a]; ++x) {
          double* const first = distance2.data() + static_cast<std::size_t>(x) * strides[a] + static_cast<std::size_t>(y) * strides[b];
          for (int n = 0; n < size[axis]; ++n) line[static_cast<std::size_t>(n)] = first[static_cast<std::size_t>(n) * strides[axis]];
          for (int n = 0; n < size[axis]; ++n) {
            double least = far;
            for (int m = std::max(0, n - reach); m <= std::min(size[axis] - 1, n + reach); ++m) {
              const double along_mm = (m - n) * step_mm;
              least = std::min(least, line[static_cast<std::size_t>(m)] + along_mm * along_mm);
            }
            first[static_cast<std::size_t>(n) * strides[axis]] = least;
          }
        }
      }
    }
    const double radius2 = radius_mm * radius_mm + 1e-9;
    for (std::size_t n = 0; n < distance2.size(); ++n)
      if (distance2[n] <= radius2) mask.values()[n] = value;
    return true;
  }

  /// What is within the neck's half width of what is not like the seed is left out; flood() gives back what it can reach from the rest.
  bool openPassages() {
    core_ = like_.values();
    const double half_mm = 0.5 * options_.neck_mm;
    if (half_mm <= 0.0) return true;
    Mask core = like_;
    if (!spread(core, half_mm, 0)) return false;
    // A seed in a narrow place would have nothing to grow from.
    if (core[seed_] != 0) core_ = core.values();
    isOpened_ = core[seed_] != 0;
    return true;
  }

  bool flood(GrowResult& result) {
    Mask grown(like_.box());
    std::vector<glm::ivec3> front;
    if (like_[seed_] != 0) {
      front.push_back(seed_);
      grown[seed_] = 1;
    }
    const double voxel_ml = 1e-3 / (perMm_.x * perMm_.y * perMm_.z);
    const auto most = static_cast<std::size_t>(options_.largest_ml / voxel_ml);
    std::size_t count = front.size();
    while (!front.empty()) {
      const glm::ivec3 at = front.back();
      front.pop_back();
      for (const glm::ivec3& face : kFaces) {
        const glm::ivec3 to = at + face;
        if (!grown.contains(to)) continue;
        const std::size_t there = grown.indexOf(to);
        if (grown.values()[there] != 0 || core_[there] == 0) continue;
        grown.values()[there] = 1;
        front.push_back(to);
        if ((++count & 0xfffu) == 0 && stopped()) return false;
      }
      if (count > most) {
        result.stop = GrowStop::tooLarge;
        result.volume_ml = static_cast<double>(count) * voxel_ml;
        return true;
      }
    }
    if (count == 0) return true;
    if (isOpened_ && !giveBack(grown)) return false;
    if (!closeHoles(grown) || !reachBorder(grown)) return false;
    count = 0;
    grown.forEach([&](int i, int j, int k, std::uint8_t& is) {
      if (is == 0) return;
      ++count;
      result.touchesReach =
          result.touchesReach || fromSeed_mm({i, j, k}) > options_.reach_mm - 1.5 / std::min({perMm_.x, perMm_.y, perMm_.z});
    });
    result.volume_ml = static_cast<double>(count) * voxel_ml;
    result.stop = result.volume_ml > options_.largest_ml ? GrowStop::tooLarge : GrowStop::done;
    like_ = std::move(grown);
    return true;
  }

  /// The opening's second half: what lies within the neck's half width of the rest, and is like the seed.
  bool giveBack(Mask& grown) {
    Mask wider = grown;
    if (!spread(wider, 0.5 * options_.neck_mm, 1)) return false;
    for (std::size_t n = 0; n < grown.values().size(); ++n) grown.values()[n] = wider.values()[n] & like_.values()[n];
    return true;
  }

  /// Averaging has blurred the border, and what lies on its slope was an edge: the region goes on to where echoes are half way between its
  /// own and those around it, at most as far as the blur reaches.
  bool reachBorder(Mask& grown) {
    const double blur_mm = std::max(2.5 * options_.smoothing_mm, 2.0 / std::min({perMm_.x, perMm_.y, perMm_.z}));
    Mask near = grown;
    if (!spread(near, blur_mm, 1)) return false;
    Mask around = near;
    if (!spread(around, kNeighbourhood_mm, 1)) return false;
    double inside = 0.0, outside = 0.0;
    std::size_t insideCount = 0, outsideCount = 0;
    for (std::size_t n = 0; n < grown.values().size(); ++n) {
      if (!present_[n]) continue;
      const double level = level_.values()[n];
      if (grown.values()[n] != 0) {
        inside += level;
        ++insideCount;
      } else if (around.values()[n] != 0 && near.values()[n] == 0) {
        outside += level;
        ++outsideCount;
      }
    }
    if (insideCount == 0 || outsideCount == 0) return true;
    inside /= static_cast<double>(insideCount);
    outside /= static_cast<double>(outsideCount);
    if (std::abs(inside - outside) < 2.0 * options_.leastBand_levels) return true;
    const double half = 0.5 * (inside + outside), sign = inside < outside ? 1.0 : -1.0;
    std::vector<glm::ivec3> front;
    grown.forEach([&](int i, int j, int k, const std::uint8_t& is) {
      if (is != 0) front.emplace_back(i, j, k);
    });
    while (!front.empty()) {
      if ((front.size() & 0xfffu) == 0 && stopped()) return false;
      const glm::ivec3 at = front.back();
      front.pop_back();
      for (const glm::ivec3& face : kFaces) {
        const glm::ivec3 to = at + face;
        if (!grown.contains(to)) continue;
        const std::size_t there = grown.indexOf(to);
        if (grown.values()[there] != 0 || near.values()[there] == 0 || !present_[there]) continue;
        const double level = level_.values()[there];
        if (sign * level > sign * half || fromSeed_mm(to) > options_.reach_mm) continue;
        grown.values()[there] = 1;
        front.push_back(to);
      }
    }
    return true;
  }

  /// Closing by a voxel: speckle leaves single voxels out.
  bool closeHoles(Mask& grown) {
    const double one_mm = 1.0 / std::min({perMm_.x, perMm_.y, perMm_.z});
    const Mask before = grown;
    if (!spread(grown, one_mm, 1) || !spread(grown, one_mm, 0)) return false;
    for (std::size_t n = 0; n < grown.values().size(); ++n) grown.values()[n] |= before.values()[n];
    return true;
  }

  const Volume& labels_;
  const Volume& echo_;
  const Grid& echoGrid_;
  glm::dvec3 seed_mm_;
  GrowOptions options_;  ///< as they fit the structure
  glm::ivec3 seed_;
  Progress& progress_;
  Block<float> level_;
  Mask like_;
  std::vector<std::uint8_t> core_;
  std::vector<bool> present_;
  glm::dvec3 perMm_;
  double neighbourhood_mm_ = kNeighbourhood_mm;
  bool isOpened_ = false;
};

}  // namespace

Result<GrowResult> growFrom(Volume& labels, const Volume& echo, const Grid& echoGrid, const glm::dvec3& seed_mm, const GrowOptions& options,
                            const Brush& brush, Progress& progress) {
  EW_EXPECTS(echoGrid.dims == echo.grid.dims);
  GrowResult result;
  const glm::dvec3 seed_voxel = carried(labels.grid.toVoxel<frame::File>(), seed_mm);
  const glm::ivec3 seed(glm::floor(glm::clamp(seed_voxel, -1e6, 1e6) + 0.5));
  if (!labels.grid.contains(seed)) return result;
  const glm::dvec3 seeds[] = {seed_voxel};
  const VoxelBox box = boxAround(seeds, options.reach_mm * voxelsPerMm(labels.grid) + 1.0, labels.grid);
  Growing growing(labels, echo, echoGrid, seed_mm, options, box, seed, progress);
  if (!growing.run(result)) return failure(ErrorCode::cancelled, say<"Cancelled.">());
  if (result.stop != GrowStop::done) return result;
  Mask grown = growing.grown();
  grown.forEach([&](int i, int j, int k, std::uint8_t& is) {
    std::uint8_t& here = labels.echo[labels.grid.indexOf(i, j, k)];
    if (is == 0 || here == brush.label || (brush.over && here != *brush.over)) return;
    here = brush.label;
    result.changed = joined(result.changed, {{i, j, k}, {i + 1, j + 1, k + 1}});
  });
  return result;
}

}  // namespace ew::labelling
