#include "ew/acquisition/temporal_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "body_signal.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "pose_track.h"

namespace ew {
namespace {

constexpr int kProfile = 256;
constexpr int kOffsetCells = 48;
constexpr int kStepsPerFrame = 8;
constexpr int kBlocks = 8;

Result<void> checkTimes(std::span<const double> time_s, std::size_t poses) {
  if (time_s.size() != poses)
    return failure(ErrorCode::badField, say<"There are %1 times and %2 poses; give one time for each frame.">(time_s.size(), poses),
                   {{"field", "time"}});
  for (std::size_t n = 0; n < time_s.size(); ++n) {
    if (!std::isfinite(time_s[n]))
      return failure(ErrorCode::badField,
                     say<"Frame %1 has no time, so poses cannot be shifted in time; choose a recording whose frames all have one.">(n),
                     {{"field", "time"}});
    if (n > 0 && time_s[n] < time_s[n - 1])
      return failure(ErrorCode::badField, say<"Time runs backwards at frame %1; put the recording in order of time.">(n),
                     {{"field", "time"}});
  }
  return {};
}

/// Mean of `count` pieces of a row or column sum.
std::vector<double> pieces(const std::vector<double>& sums, int count) {
  std::vector<double> means(static_cast<std::size_t>(count));
  const auto size = static_cast<int>(sums.size());
  for (int n = 0; n < count; ++n) {
    const int begin = n * size / count, end = (n + 1) * size / count;
    means[static_cast<std::size_t>(n)] = std::accumulate(sums.begin() + begin, sums.begin() + end, 0.0) / (end - begin);
  }
  return means;
}

/// What is kept of an image to compare it with the next.
struct Look {
  std::vector<double> along;   ///< row means
  std::vector<double> across;  ///< column means
  std::vector<double> cells;   ///< mean 0, length 1; empty for a constant image
};

Look lookAt(const ImageView<const std::uint8_t>& image) {
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  std::vector<double> rows(height, 0.0), columns(width, 0.0);
  const int across = std::min(kOffsetCells, image.width), down = std::min(kOffsetCells, image.height);
  std::vector<double> cells(static_cast<std::size_t>(across * down), 0.0), counts(cells.size(), 0.0);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* const row = image.row(y);
    const int cy = y * down / image.height;
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) {
      sum += row[x];
      columns[static_cast<std::size_t>(x)] += row[x] / static_cast<double>(height);
      const auto cell = static_cast<std::size_t>(cy * across + x * across / image.width);
      cells[cell] += row[x];
      counts[cell] += 1.0;
    }
    rows[static_cast<std::size_t>(y)] = sum / static_cast<double>(width);
  }
  for (std::size_t n = 0; n < cells.size(); ++n) cells[n] /= counts[n];
  const double mean = std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
  double power = 0.0;
  for (double& cell : cells) {
    cell -= mean;
    power += cell * cell;
  }
  if (power > 1e-9)
    for (double& cell : cells) cell /= std::sqrt(power);
  else
    cells.clear();
  return {pieces(rows, std::min(kProfile, image.height)), pieces(columns, std::min(kProfile, image.width)), std::move(cells)};
}

/// By how many samples `later` is shifted against `earlier`: the least mean square difference, between samples by a parabola.
double shiftOf(const std::vector<double>& earlier, const std::vector<double>& later) {
  const auto size = static_cast<int>(earlier.size());
  const int reach = std::max(2, size / 10);
  if (size < 8) return 0.0;
  const auto difference = [&](int shift) {
    double sum = 0.0, first = 0.0, second = 0.0;
    const int begin = std::max(0, -shift), end = std::min(size, size - shift);
    for (int n = begin; n < end; ++n) {
      const double d = later[static_cast<std::size_t>(n + shift)] - earlier[static_cast<std::size_t>(n)];
      sum += d * d;
      first += d;
    }
    second = first / (end - begin);
    return sum / (end - begin) - second * second;
  };
  std::vector<double> differences;
  for (int shift = -reach; shift <= reach; ++shift) differences.push_back(difference(shift));
  const auto best = static_cast<std::size_t>(std::min_element(differences.begin(), differences.end()) - differences.begin());
  double between = 0.0;
  if (best > 0 && best + 1 < differences.size()) {
    const double curvature = differences[best - 1] - 2.0 * differences[best] + differences[best + 1];
    if (curvature > 0.0) between = std::clamp(0.5 * (differences[best - 1] - differences[best + 1]) / curvature, -0.5, 0.5);
  }
  return static_cast<double>(best) - reach + between;
}

enum Signal { kAlong, kAcross, kChange, kSignals };

Message nameOf(std::size_t signal) {
  if (signal == kAlong) return say<"shift along the beam">();
  if (signal == kAcross) return say<"shift across the beam">();
  return say<"change">();
}

/// One value per pair of successive frames and signal.
using Steps = std::array<std::vector<double>, kSignals>;

Result<Steps> stepsSeen(std::span<const ImageView<const std::uint8_t>> frames, int threads, Progress& progress) {
  std::vector<Look> looks(frames.size());
  if (!forEachTask(static_cast<int>(frames.size()), threads, progress, say<"Watching the images move">(), [&](int task) {
        const auto n = static_cast<std::size_t>(task);
        looks[n] = lookAt(frames[n]);
      }))
    return failure(ErrorCode::cancelled, say<"The estimate was stopped before it was complete.">());
  Steps seen;
  for (std::size_t n = 0; n + 1 < looks.size(); ++n) {
    seen[kAlong].push_back(shiftOf(looks[n].along, looks[n + 1].along) * frames[n].height / static_cast<double>(looks[n].along.size()));
    seen[kAcross].push_back(shiftOf(looks[n].across, looks[n + 1].across) * frames[n].width / static_cast<double>(looks[n].across.size()));
    const auto &first = looks[n].cells, &second = looks[n + 1].cells;
    const double alike = first.empty() || second.empty() ? 1.0 : std::inner_product(first.begin(), first.end(), second.begin(), 0.0);
    seen[kChange].push_back(std::sqrt(-2.0 * std::log(std::clamp(alike, 1e-3, 1.0))));
  }
  return seen;
}

/// What the poses say the images should do between t and next; empty where they do not say.
std::optional<std::array<double, kSignals>> stepTracked(const PoseTrack& track, double t_s, double next_s, const glm::dvec3& centre_px) {
  const auto first = track.at(t_s), second = track.at(next_s);
  if (!first || !second) return std::nullopt;
  const Point<frame::Image> centre{centre_px};
  const glm::dvec3 there_mm = (*first * centre).at;
  const glm::dvec3 shift_px = (inverse(*second) * Point<frame::World>{there_mm}).at - centre_px;
  return std::array<double, kSignals>{shift_px.y, shift_px.x, glm::distance((*second * centre).at, there_mm)};
}

/// Sums for the correlation of two signals, of the pairs that count.
struct OffsetSums {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  void add(double a, double b) {
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    yy += b * b;
    xy += a * b;
  }
  OffsetSums& operator-=(const OffsetSums& o) {
    n -= o.n;
    x -= o.x;
    y -= o.y;
    xx -= o.xx;
    yy -= o.yy;
    xy -= o.xy;
    return *this;
  }
  [[nodiscard]] double correlation() const {
    const double varianceX = xx - x * x / n, varianceY = yy - y * y / n;
    if (n < 3.0 || varianceX <= 1e-12 * std::max(xx, 1e-300) || varianceY <= 1e-12 * std::max(yy, 1e-300)) return 0.0;
    return (xy - x * y / n) / std::sqrt(varianceX * varianceY);
  }
};

struct Best {
  double step = 0.0;  ///< of the delays tried, with a part between them
  double height = 0.0;
};
Best bestOf(const std::vector<double>& heights) {
  const auto at = static_cast<std::size_t>(std::max_element(heights.begin(), heights.end()) - heights.begin());
  double between = 0.0;
  if (at > 0 && at + 1 < heights.size()) {
    const double curvature = heights[at - 1] - 2.0 * heights[at] + heights[at + 1];
    if (curvature < 0.0) between = std::clamp(0.5 * (heights[at - 1] - heights[at + 1]) / curvature, -0.5, 0.5);
  }
  return {static_cast<double>(at) + between, heights[at]};
}

/// Whether another delay, beyond the best one's own hill, does about as well.
bool ambiguous(const std::vector<double>& heights, const Best& best) {
  const auto at = static_cast<std::ptrdiff_t>(std::lround(best.step));
  const auto count = static_cast<std::ptrdiff_t>(heights.size());
  for (const std::ptrdiff_t way : {-1, 1}) {
    std::ptrdiff_t n = at;
    while (n + way >= 0 && n + way < count && heights[static_cast<std::size_t>(n)] > 0.7 * best.height) n += way;
    for (; n >= 0 && n < count; n += way)
      if (heights[static_cast<std::size_t>(n)] > 0.9 * best.height) return true;
  }
  return false;
}

constexpr std::size_t kFewestFrames = 16;

using OfBlocks = std::array<OffsetSums, kBlocks>;

OffsetSums totalOf(const OfBlocks& blocks) {
  OffsetSums total;
  for (const OffsetSums& block : blocks) {
    total.n += block.n;
    total.x += block.x;
    total.y += block.y;
    total.xx += block.xx;
    total.yy += block.yy;
    total.xy += block.xy;
  }
  return total;
}

/// The delays that are tried, evenly to both sides of none.
struct Delays {
  double step_s = 0.0;
  int reach = 0;

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(2 * reach + 1); }
  [[nodiscard]] double at_s(double n) const { return (n - reach) * step_s; }
};

/// Comparisons of what the images did with what the poses say, for every signal, delay and block of the sweep.
using Comparisons = std::array<std::vector<OfBlocks>, kSignals>;

std::optional<Comparisons> compareSteps(const Steps& seen, std::span<const double> time_s, const PoseTrack& track,
                                        const glm::dvec3& centre_px, const Delays& delays, double gap_s, int threads, Progress& progress) {
  const std::size_t pairs = time_s.size() - 1;
  Comparisons sums;
  for (auto& ofDelays : sums) ofDelays.resize(delays.count());
  if (!forEachTask(static_cast<int>(delays.count()), threads, progress, say<"Comparing movements">(), [&](int task) {
        const auto d = static_cast<std::size_t>(task);
        const double delay_s = delays.at_s(task);
        for (std::size_t n = 0; n < pairs; ++n) {
          if (!(time_s[n + 1] > time_s[n]) || time_s[n + 1] - time_s[n] > gap_s) continue;
          const auto step = stepTracked(track, time_s[n] + delay_s, time_s[n + 1] + delay_s, centre_px);
          if (!step) continue;
          for (std::size_t s = 0; s < kSignals; ++s) sums[s][d][n * kBlocks / pairs].add((*step)[s], seen[s][n]);
        }
      }))
    return std::nullopt;
  return sums;
}

/// By how much the best delay changes when one block of the sweep after the other is left out (jackknife).
double uncertaintyOf_s(const std::vector<OfBlocks>& ofDelays, const Best& best, const Delays& delays) {
  double mean = 0.0, squares = 0.0;
  std::array<double, kBlocks> without{};
  for (std::size_t b = 0; b < kBlocks; ++b) {
    std::vector<double> part(ofDelays.size(), 0.0);
    // Near the best delay alone: a part of the sweep may have other hills.
    const auto from = static_cast<std::size_t>(std::max(0.0, best.step - 2 * kStepsPerFrame));
    const auto to = std::min(delays.count(), static_cast<std::size_t>(best.step + 2 * kStepsPerFrame) + 1);
    for (std::size_t d = from; d < to; ++d) {
      OffsetSums rest = totalOf(ofDelays[d]);
      rest -= ofDelays[d][b];
      part[d] = rest.correlation();
    }
    without[b] = bestOf(part).step;
    mean += without[b] / kBlocks;
  }
  for (const double step : without) squares += (step - mean) * (step - mean);
  return delays.step_s * std::sqrt((kBlocks - 1.0) / kBlocks * squares);
}

/// What the signals say of the delay, one after the other: the surest that tells counts, else why the last one does not.
struct DelayJudgement {
  const PoseDelayOptions& options;
  const Delays& delays;
  PoseDelay result;
  Message why = say<"The probe moves too evenly, or has too few poses: no change of speed can be found again in the images.">();
  double closest = 0.0;

  void take(std::size_t signal, const std::vector<OfBlocks>& ofDelays) {
    const OffsetSums still = totalOf(ofDelays[static_cast<std::size_t>(delays.reach)]);
    if (!moves(signal, still)) return;
    std::vector<double> heights;
    for (const OfBlocks& blocks : ofDelays) {
      const OffsetSums total = totalOf(blocks);
      heights.push_back(total.n >= 0.5 * still.n ? total.correlation() : 0.0);
    }
    const Best best = bestOf(heights);
    if (!standsOut(heights, best)) return;
    const double uncertainty_s = uncertaintyOf_s(ofDelays, best, delays);
    if (result.verdict == DelayVerdict::found && uncertainty_s >= result.uncertainty_s) return;
    result.verdict = DelayVerdict::found;
    result.delay_s = delays.at_s(best.step);
    result.uncertainty_s = uncertainty_s;
    result.correlation = best.height;
    result.seenBy = nameOf(signal);
  }

 private:
  /// Shifts below a tenth of a pixel and an even speed drown in the noise of watching.
  [[nodiscard]] static bool moves(std::size_t signal, const OffsetSums& still) {
    if (2.0 * still.n < kFewestFrames) return false;
    const double mean = still.x / still.n, spread = std::sqrt(std::max(0.0, still.xx / still.n - mean * mean));
    return signal == kChange ? spread >= 0.1 * std::abs(mean) && spread > 0.0 : spread >= 0.1;
  }
  [[nodiscard]] bool standsOut(const std::vector<double>& heights, const Best& best) {
    if (best.height > closest) {
      closest = best.height;
      result.correlation = std::max(result.correlation, best.height);
    }
    if (best.height < options.leastCorrelation) {
      if (result.verdict == DelayVerdict::cannotTell)
        why = say<"Movement in the images and in the poses do not agree at any delay (correlation %1, %2 is needed).">(
            textOf(std::round(100.0 * closest) / 100.0), textOf(options.leastCorrelation));
      return false;
    }
    const auto last = static_cast<double>(delays.count() - 1);
    if (best.step < 1.0 || best.step > last - 1.0) {
      why = say<"The best delay lies at the end of the range; try a larger one.">();
      return false;
    }
    if (ambiguous(heights, best)) {
      why = say<"The probe moves to and fro so regularly that several delays fit; use a sweep with uneven movement.">();
      return false;
    }
    return true;
  }
};

Result<void> checkFramesAndPoses(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s,
                                 const FramePoses& poses) {
  if (const auto checked = checkTimes(time_s, poses.size()); !checked) return passOn(checked.error());
  if (frames.size() != poses.size())
    return failure(ErrorCode::badField, say<"There are %1 frames and %2 poses; give one pose for each frame.">(frames.size(), poses.size()),
                   {{"field", "frames"}});
  for (const auto& frame : frames)
    if (frame.width != frames.front().width || frame.height != frames.front().height || frame.width < 1 || frame.height < 1)
      return failure(ErrorCode::badField, say<"The frames differ in size; estimate the delay of frames of one size.">(),
                     {{"field", "pixels"}});
  return {};
}

}  // namespace

Result<FramePoses> posesDelayedBy(double delay_s, std::span<const double> time_s, const FramePoses& poses, const glm::dvec2& centre_px,
                                  double longestGap_s) {
  if (const auto checked = checkTimes(time_s, poses.size()); !checked) return passOn(checked.error());
  if (!std::isfinite(delay_s))
    return failure(ErrorCode::badField, say<"A delay that is not a finite number cannot be used; give seconds.">(), {{"field", "delay"}});
  if (delay_s == 0.0) return poses;
  const PoseTrack track(time_s, poses, centre_px, longestGapOf(longestGap_s, time_s));
  FramePoses delayed;
  delayed.reserve(poses.size());
  for (const double t_s : time_s) delayed.push_back(track.at(t_s + delay_s));
  return delayed;
}

Result<PoseDelay> estimatePoseDelay(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s,
                                    const FramePoses& poses, const PoseDelayOptions& options, Progress& progress) {
  if (const auto checked = checkFramesAndPoses(frames, time_s, poses); !checked) return passOn(checked.error());
  const double gap_s = longestGapOf(options.longestGap_s, time_s);
  if (frames.size() < kFewestFrames || gap_s <= 0.0) {
    PoseDelay result;
    result.why = say<"The sweep has too few frames at different times to compare movements.">();
    return result;
  }
  PartOfProgress watching(progress, 0.0, 0.6), comparing(progress, 0.6, 1.0);
  const auto seen = stepsSeen(frames, options.threads, watching);
  if (!seen) return passOn(seen.error());

  const glm::dvec3 centre_px(0.5 * (frames.front().width - 1), 0.5 * (frames.front().height - 1), 0.0);
  const PoseTrack track(time_s, poses, glm::dvec2(centre_px), gap_s);
  Delays delays;
  delays.step_s = gap_s / (options.longestGap_s > 0.0 ? 1.0 : 3.0) / kStepsPerFrame;
  delays.reach = std::clamp(static_cast<int>(std::ceil(options.largest_s / delays.step_s)), 2, 20000);
  const auto sums = compareSteps(*seen, time_s, track, centre_px, delays, gap_s, options.threads, comparing);
  if (!sums) return failure(ErrorCode::cancelled, say<"The estimate was stopped before it was complete.">());

  DelayJudgement judgement{options, delays, {}};
  for (std::size_t s = 0; s < kSignals; ++s) judgement.take(s, (*sums)[s]);
  if (judgement.result.verdict != DelayVerdict::found) judgement.result.why = std::move(judgement.why);
  return std::move(judgement.result);
}

}  // namespace ew
