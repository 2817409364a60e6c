#include "ew/acquisition/equalise.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>

#include "clip_spans.h"
#include "ew/core/contract.h"
#include "ew/core/depth_curves.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

constexpr double kClippedShare = 0.02;
constexpr double kFewestPixels = 8.0;

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
using LevelCells = std::map<Place, Cell>;

/// What one sweep saw, cell by cell; false when cancelled.
template <class Stopped>
bool look(const SweepToEqualise& sweep, const ClipSpans& clip, const EqualiseOptions& options, const Stopped& stopped, LevelCells& cells) {
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

Result<void> check(std::span<const SweepToEqualise> sweeps, const EqualiseOptions& options) {
  const auto refuse = [](const Message& sentence) { return failure(ErrorCode::badField, sentence, {{"field", "equalise"}}); };
  if (sweeps.size() < 2) return refuse(say<"There are fewer than two sweeps to compare; give all sweeps that are to be stitched.">());
  const bool sound = options.cell_mm > 0.0 && options.cell_mm < 1e3 && options.knot_mm > 0.5 && options.knot_mm < 1e3 &&
                     options.smoothness >= 0.0 && options.smoothness < 1e3 && options.pixelStep >= 1 && options.fewestCells >= 1 &&
                     options.dynamicRange_db > 0.0;
  if (!sound) return refuse(say<"The options of the equalisation are out of range; use cells, knots and steps above 0.">());
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

double DepthCorrection::at(double depth_mm) const { return atDepth(grey, knot_mm, depth_mm); }

Result<Equalisation> estimateEqualisation(std::span<const SweepToEqualise> sweeps, const EqualiseOptions& options, Progress& progress) {
  if (const auto checked = check(sweeps, options); !checked) return passOn(checked.error());
  std::vector<LevelCells> seen(sweeps.size());
  std::vector<ClipSpans> clips;
  for (const auto& sweep : sweeps)
    clips.push_back(*ClipSpans::of(sweep.clip, sweep.frames.front().pixels.width, sweep.frames.front().pixels.height));
  std::atomic<bool> cut{false};
  const bool done = forEachTask(static_cast<int>(sweeps.size()), options.threads, progress, say<"Comparing sweeps">(),
                                [&](int task, int /*worker*/, const auto& stopped) {
                                  const auto s = static_cast<std::size_t>(task);
                                  if (!look(sweeps[s], clips[s], options, stopped, seen[s])) cut = true;
                                });
  if (!done || cut) return failure(ErrorCode::cancelled, say<"The equalisation was stopped before it was complete.">());

  std::vector<DepthDifference> pairs;
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
  Equalisation result;
  result.sweeps.assign(sweeps.size(), {});
  for (auto& sweep : result.sweeps) sweep.knot_mm = options.knot_mm;
  result.groups = groupsOf(shared, options.fewestCells, result.sweeps);
  result.cells = pairs.size();
  const double dbPerGrey = options.dynamicRange_db / 255.0;
  DepthCurves curves;
  if (!fitDepthCurves(pairs, sweeps.size(), {options.knot_mm, options.smoothness}, progress, curves))
    return failure(ErrorCode::cancelled, say<"The equalisation was stopped before it was complete.">());
  result.disagreementBefore_db = curves.medianBefore * dbPerGrey;
  result.disagreementAfter_db = curves.medianAfter * dbPerGrey;
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    auto& sweep = result.sweeps[s];
    sweep.grey = std::move(curves.grey[s]);
    double from_mm = 1e9, to_mm = 0.0;
    for (const DepthDifference& pair : pairs)
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
      result.notes.push_back(say<"Part %1 of %2, which overlaps no other: %3.">(group + 1, result.groups, names));
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
