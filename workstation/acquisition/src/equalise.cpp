#include "ew/acquisition/equalise.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>

#include "body_signal.h"
#include "clip_spans.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

constexpr double kClippedShare = 0.02;
constexpr double kFewestPixels = 8.0;
constexpr int kRounds = 12;
constexpr double kLongestCurve_mm = 1000.0;

/// Depth below the face of every pixel, from the clip.
class PixelDepth {
 public:
  PixelDepth(const Clip& clip, const glm::dmat4& imageToWorld)
      : clip_(clip), pixel_mm_(glm::length(glm::dvec3(imageToWorld[0])), glm::length(glm::dvec3(imageToWorld[1]))) {}
  [[nodiscard]] double at(double x, double y) const {
    if (!clip_.fan) return std::max(0.0, (y - clip_.origin_px.y) * pixel_mm_.y);
    const glm::dvec2 from_mm = (glm::dvec2(x, y) - clip_.fan->origin_px) * pixel_mm_;
    return std::max(0.0, glm::length(from_mm) - clip_.fan->startRadius_px * pixel_mm_.y);
  }
  [[nodiscard]] double pixelHeight_mm() const { return pixel_mm_.y; }

 private:
  Clip clip_;
  glm::dvec2 pixel_mm_;
};

struct Cell {
  double pixels = 0.0;
  double clipped = 0.0;
  double grey = 0.0;
  double depth_mm = 0.0;
};
using Place = std::array<int, 3>;
using Cells = std::map<Place, Cell>;

/// What one sweep saw, cell by cell; false when cancelled.
template <class Stopped>
bool look(const SweepToEqualise& sweep, const ClipSpans& clip, const EqualiseOptions& options, const Stopped& stopped, Cells& cells) {
  const PixelDepth depth(sweep.clip, sweep.frames.front().imageToWorld.matrix);
  const int step = options.pixelStep;
  for (const PosedFrame& frame : sweep.frames) {
    if (stopped()) return false;
    const glm::dmat4& m = frame.imageToWorld.matrix;
    Place last{};
    Cell* cell = nullptr;
    for (int y = clip.firstRow(); y <= clip.lastRow(); y += step)
      for (const Span& span : clip.row(y))
        for (int x = span.begin; x < span.end; x += step) {
          const glm::dvec3 p =
              (glm::dvec3(m[0]) * static_cast<double>(x) + glm::dvec3(m[1]) * static_cast<double>(y) + glm::dvec3(m[3])) / options.cell_mm;
          const Place place{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z))};
          if (cell == nullptr || place != last) {
            cell = &cells[place];
            last = place;
          }
          const std::uint8_t level = frame.pixels.row(y)[x];
          cell->pixels += 1.0;
          cell->clipped += level == 0 || level == 255 ? 1.0 : 0.0;
          cell->grey += level;
          cell->depth_mm += depth.at(x, y);
        }
  }
  for (auto entry = cells.begin(); entry != cells.end();) {
    Cell& cell = entry->second;
    cell.grey /= cell.pixels;
    cell.depth_mm /= cell.pixels;
    entry = cell.pixels < kFewestPixels || cell.clipped > kClippedShare * cell.pixels ? cells.erase(entry) : std::next(entry);
  }
  return true;
}

/// One cell that two sweeps saw.
struct Pair {
  std::size_t first = 0;
  std::size_t second = 0;
  double firstDepth_mm = 0.0;
  double secondDepth_mm = 0.0;
  double difference = 0.0;  ///< grey of the first less that of the second
  double weight = 0.0;
};

/// A depth's two knots and the share of the second.
struct Knots {
  std::size_t at = 0;
  double share = 0.0;
};
Knots knotsOf(double depth_mm, double knot_mm, std::size_t count) {
  const double along = std::clamp(depth_mm / knot_mm, 0.0, static_cast<double>(count - 1));
  const auto at = std::min(static_cast<std::size_t>(along), count - 2);
  return {at, along - static_cast<double>(at)};
}

/// Least squares: unknown (sweep, knot) is column sweep * knots + knot.
Eigen::VectorXd solved(const std::vector<Pair>& pairs, const std::vector<double>& weights, std::size_t sweeps, std::size_t knots,
                       const EqualiseOptions& options) {
  const auto size = static_cast<Eigen::Index>(sweeps * knots);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  double total = 0.0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const Pair& pair = pairs[n];
    const Knots a = knotsOf(pair.firstDepth_mm, options.knot_mm, knots), b = knotsOf(pair.secondDepth_mm, options.knot_mm, knots);
    const std::array<std::pair<Eigen::Index, double>, 4> row = {{{static_cast<Eigen::Index>(pair.first * knots + a.at), 1.0 - a.share},
                                                                 {static_cast<Eigen::Index>(pair.first * knots + a.at + 1), a.share},
                                                                 {static_cast<Eigen::Index>(pair.second * knots + b.at), b.share - 1.0},
                                                                 {static_cast<Eigen::Index>(pair.second * knots + b.at + 1), -b.share}}};
    for (const auto& [i, u] : row) {
      right(i) -= weights[n] * u * pair.difference;
      for (const auto& [j, v] : row) normal(i, j) += weights[n] * u * v;
    }
    total += weights[n];
  }
  const double share = total / static_cast<double>(sweeps * knots);
  for (std::size_t s = 0; s < sweeps; ++s)
    for (std::size_t k = 1; k + 1 < knots; ++k) {
      const auto at = static_cast<Eigen::Index>(s * knots + k);
      constexpr std::array<double, 3> bend{1.0, -2.0, 1.0};
      for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index j = 0; j < 3; ++j)
          normal(at - 1 + i, at - 1 + j) +=
              options.smoothness * share * bend[static_cast<std::size_t>(i)] * bend[static_cast<std::size_t>(j)];
    }
  // The gauge: of all curves that agree as well, the smallest.
  normal.diagonal().array() += 1e-5 * share + 1e-12;
  return normal.ldlt().solve(right);
}

double residualOf(const Pair& pair, const Eigen::VectorXd& curves, std::size_t knots, double knot_mm) {
  const auto at = [&](std::size_t sweep, double depth_mm) {
    const Knots k = knotsOf(depth_mm, knot_mm, knots);
    const auto first = static_cast<Eigen::Index>(sweep * knots + k.at);
    return (1.0 - k.share) * curves(first) + k.share * curves(first + 1);
  };
  return pair.difference + at(pair.first, pair.firstDepth_mm) - at(pair.second, pair.secondDepth_mm);
}

Result<void> check(std::span<const SweepToEqualise> sweeps, const EqualiseOptions& options) {
  const auto refuse = [](std::string sentence) { return failure(ErrorCode::badField, std::move(sentence), {{"field", "equalise"}}); };
  if (sweeps.size() < 2) return refuse("There are fewer than two sweeps to compare; give all sweeps that are to be stitched.");
  const bool sound = options.cell_mm > 0.0 && options.cell_mm < 1e3 && options.knot_mm > 0.5 && options.knot_mm < 1e3 &&
                     options.smoothness >= 0.0 && options.smoothness < 1e3 && options.pixelStep >= 1 && options.fewestCells >= 1 &&
                     options.dynamicRange_db > 0.0;
  if (!sound) return refuse("The options of the equalisation are out of range; use cells, knots and steps above 0.");
  for (const auto& sweep : sweeps) {
    // gridFor checks frames, matrices and clip; its spacing only has to be so wide that no volume is too large.
    ReconstructOptions checking;
    checking.spacing_mm = options.cell_mm;
    checking.clip = sweep.clip;
    if (const auto grid = gridFor(sweep.frames, checking); !grid) return passOn(grid.error());
  }
  return {};
}

int groupsOf(const std::vector<std::vector<std::size_t>>& shared, int fewest, std::vector<DepthCorrection>& sweeps) {
  for (std::size_t s = 0; s < sweeps.size(); ++s) sweeps[s].group = static_cast<int>(s);
  for (std::size_t round = 0; round < sweeps.size(); ++round)
    for (std::size_t a = 0; a < sweeps.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (shared[a][b] >= static_cast<std::size_t>(fewest))
          sweeps[a].group = sweeps[b].group = std::min(sweeps[a].group, sweeps[b].group);
  std::map<int, int> renamed;
  for (auto& sweep : sweeps) sweep.group = renamed.emplace(sweep.group, static_cast<int>(renamed.size())).first->second;
  return static_cast<int>(renamed.size());
}

}  // namespace

double DepthCorrection::at(double depth_mm) const {
  if (grey.empty()) return 0.0;
  if (grey.size() == 1) return grey.front();
  const Knots knots = knotsOf(depth_mm, knot_mm, grey.size());
  return (1.0 - knots.share) * grey[knots.at] + knots.share * grey[knots.at + 1];
}

Result<Equalisation> estimateEqualisation(std::span<const SweepToEqualise> sweeps, const EqualiseOptions& options, Progress& progress) {
  if (const auto checked = check(sweeps, options); !checked) return passOn(checked.error());
  std::vector<Cells> seen(sweeps.size());
  std::vector<ClipSpans> clips;
  for (const auto& sweep : sweeps)
    clips.push_back(*ClipSpans::of(sweep.clip, sweep.frames.front().pixels.width, sweep.frames.front().pixels.height));
  std::atomic<bool> cut{false};
  const bool done = forEachTask(static_cast<int>(sweeps.size()), options.threads, progress, "Comparing sweeps",
                                [&](int task, int /*worker*/, const auto& stopped) {
                                  const auto s = static_cast<std::size_t>(task);
                                  if (!look(sweeps[s], clips[s], options, stopped, seen[s])) cut = true;
                                });
  if (!done || cut) return failure(ErrorCode::cancelled, "The equalisation was stopped before it was complete.");

  std::vector<Pair> pairs;
  std::vector<std::vector<std::size_t>> shared(sweeps.size(), std::vector<std::size_t>(sweeps.size(), 0));
  for (std::size_t a = 0; a < sweeps.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const std::size_t before = pairs.size();
      for (const auto& [place, first] : seen[a])
        if (const auto found = seen[b].find(place); found != seen[b].end()) {
          const Cell& second = found->second;
          pairs.push_back(
              {a, b, first.depth_mm, second.depth_mm, first.grey - second.grey, std::sqrt(std::min({first.pixels, second.pixels, 400.0}))});
        }
      shared[a][b] = pairs.size() - before;
      if (shared[a][b] < static_cast<std::size_t>(options.fewestCells)) pairs.resize(before);
    }
  double deepest_mm = options.knot_mm;
  for (const Pair& pair : pairs) deepest_mm = std::max({deepest_mm, pair.firstDepth_mm, pair.secondDepth_mm});
  const auto knots = static_cast<std::size_t>(std::ceil(std::min(deepest_mm, kLongestCurve_mm) / options.knot_mm)) + 1;

  Equalisation result;
  result.sweeps.assign(sweeps.size(), {});
  for (auto& sweep : result.sweeps) sweep.knot_mm = options.knot_mm;
  result.groups = groupsOf(shared, options.fewestCells, result.sweeps);
  result.cells = pairs.size();
  const double dbPerGrey = options.dynamicRange_db / 255.0;
  std::vector<double> weights, sizes(pairs.size());
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    weights.push_back(pairs[n].weight);
    sizes[n] = std::abs(pairs[n].difference);
  }
  result.disagreementBefore_db = medianValue(sizes) * dbPerGrey;
  Eigen::VectorXd curves = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(sweeps.size() * knots));
  for (int round = 0; round < kRounds && !pairs.empty(); ++round) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The equalisation was stopped before it was complete.");
    curves = solved(pairs, weights, sweeps.size(), knots, options);
    for (std::size_t n = 0; n < pairs.size(); ++n) sizes[n] = std::abs(residualOf(pairs[n], curves, knots, options.knot_mm));
    // Below half a grey level residuals are rounding, and the scale must not follow them to 0.
    const double scale = std::max(0.5, 1.4826 * medianValue(sizes));
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      const double far = sizes[n] / (2.385 * scale);
      // First Cauchy's weights, which find the way from anywhere, then Geman and McClure's, which forget what is far.
      const double cauchy = 1.0 / (1.0 + far * far);
      weights[n] = pairs[n].weight * (round < kRounds / 2 ? cauchy : cauchy * cauchy);
    }
  }
  result.disagreementAfter_db = medianValue(sizes) * dbPerGrey;
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    auto& sweep = result.sweeps[s];
    for (std::size_t k = 0; k < knots; ++k) sweep.grey.push_back(curves(static_cast<Eigen::Index>(s * knots + k)));
    double from_mm = 1e9, to_mm = 0.0;
    for (const Pair& pair : pairs)
      for (const auto& [own, depth_mm] : {std::pair{pair.first, pair.firstDepth_mm}, std::pair{pair.second, pair.secondDepth_mm}})
        if (own == s) {
          from_mm = std::min(from_mm, depth_mm);
          to_mm = std::max(to_mm, depth_mm);
        }
    if (from_mm <= to_mm) {
      sweep.seenFrom_mm = from_mm;
      sweep.seenTo_mm = to_mm;
    }
  }
  if (result.groups > 1)
    for (int group = 0; group < result.groups; ++group) {
      std::string names;
      for (std::size_t s = 0; s < sweeps.size(); ++s)
        if (result.sweeps[s].group == group) names += (names.empty() ? "" : ", ") + sweeps[s].name;
      result.notes.push_back("Part " + std::to_string(group + 1) + " of " + std::to_string(result.groups) +
                             ", which overlaps no other: " + names + ".");
    }
  return result;
}

FrameEqualiser::FrameEqualiser(const DepthCorrection& correction, const Clip& clip, const PosedFrame& like)
    : rowOfPixel_(like.pixels.width, like.pixels.height) {
  const PixelDepth depth(clip, like.imageToWorld.matrix);
  const double row_mm = depth.pixelHeight_mm();
  int rows = 1;
  for (int y = 0; y < like.pixels.height; ++y)
    for (int x = 0; x < like.pixels.width; ++x) {
      const int row = static_cast<int>(std::min(65535.0, depth.at(x, y) / row_mm + 0.5));
      viewOf(rowOfPixel_).at(x, y) = static_cast<std::uint16_t>(row);
      rows = std::max(rows, row + 1);
    }
  table_.resize(static_cast<std::size_t>(rows) * 256);
  for (int row = 0; row < rows; ++row) {
    const double adds = correction.at(row * row_mm);
    for (int level = 1; level < 256; ++level)
      table_[static_cast<std::size_t>(row * 256 + level)] =
          static_cast<std::uint8_t>(std::clamp(std::floor(level + adds + 0.5), 1.0, 255.0));
  }
}

void FrameEqualiser::apply(ImageView<const std::uint8_t> frame, ImageView<std::uint8_t> equalised) const {
  EW_EXPECTS(frame.width == rowOfPixel_.width && frame.height == rowOfPixel_.height);
  EW_EXPECTS(equalised.width == frame.width && equalised.height == frame.height);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint16_t* const rows = viewOf(rowOfPixel_).row(y);
    const std::uint8_t* const from = frame.row(y);
    std::uint8_t* const to = equalised.row(y);
    for (int x = 0; x < frame.width; ++x) to[x] = table_[static_cast<std::size_t>(rows[x]) * 256 + from[x]];
  }
}

}  // namespace ew
