#include "edge_band.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cross.h"
#include "edge_profile.h"

namespace ew::measurement {
namespace {

constexpr double kHalfStrength = 12.0;  // grey levels a mm at which an edge counts half: the brightest must not decide alone
constexpr double kStiffness = 2.0;      // what a slope of 1 of the line against its band costs, in edges
constexpr double kStifferStill = 4.0;   // about an edge: what is left is speckle
constexpr double kFromClicks = 0.6;     // what the end of the band about clicks costs, in edges
constexpr double kFromFound = 0.1;      // and of that about an edge
constexpr double kPerPlace = 0.25;      // of a spacing
constexpr int kSteepest = 4;            // places from one point to the next
constexpr double kRoughClicks = 0.25;   // deviation of the mean of rough clicks, of the reach
constexpr double kNearby = 0.3;         // of the reach: where an edge that was found can be in truth
constexpr double kWeakestMean = 0.02;   // of edges along a line; less is no edge

/// What lies around a closed line: at each point, across it.
struct Band {
  std::vector<glm::dvec2> line, outwards;
  int reach = 0;  ///< places to either side
  double step_mm = 0.0;
  std::vector<double> slopes;  ///< point after point, from inside outwards

  [[nodiscard]] int width() const { return 2 * reach + 1; }
  [[nodiscard]] double slope(std::size_t n, int place) const {
    return slopes[n * static_cast<std::size_t>(width()) + static_cast<std::size_t>(place)];
  }
};

Band bandAround(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, const std::vector<glm::dvec2>& line,
                const TracingOptions& options, double reach_mm) {
  Band band;
  band.line = line;
  band.step_mm = kPerPlace * options.spacing_mm;
  band.reach = std::max(1, static_cast<int>(std::ceil(reach_mm / band.step_mm)));
  const std::size_t count = line.size(), width = static_cast<std::size_t>(band.width());
  double twice = 0.0;
  for (std::size_t n = 1; n + 1 < count; ++n) twice += cross(line[n] - line[0], line[n + 1] - line[0]);
  const double winding = twice < 0.0 ? -1.0 : 1.0;
  const auto step = static_cast<std::size_t>(std::clamp(std::round(options.smoothing_mm / options.spacing_mm), 1.0, count / 3.0));
  const int margin = static_cast<int>(std::ceil(3.0 * options.snap.blur_mm / band.step_mm)) + 1;
  std::vector<double> raw(count * width, 0.0);
  for (std::size_t n = 0; n < count; ++n) {
    const glm::dvec2 chord = line[(n + step) % count] - line[(n + count - step) % count];
    const double length = glm::length(chord);
    band.outwards.push_back(length > 0.0 ? winding / length * glm::dvec2(chord.y, -chord.x) : glm::dvec2(0.0));
    if (!(length > 0.0)) continue;
    const auto slopes = slopesOf(profileThrough(image, geometry, line[n], band.outwards[n], band.reach + margin, band.step_mm, 0.0),
                                 band.step_mm, options.snap.blur_mm);
    std::copy_n(slopes.begin() + margin, width, raw.begin() + static_cast<std::ptrdiff_t>(n * width));
  }
  // Along the line, for speckle is not an edge: half of the usual reach is the deviation.
  const double deviation = 0.5 * options.snap.across_mm / options.spacing_mm;
  const int far = std::min(static_cast<int>(std::ceil(2.5 * deviation)), static_cast<int>(count) / 2);
  band.slopes.assign(raw.size(), 0.0);
  double total = 0.0;
  for (int m = -far; m <= far; ++m) {
    const double weight = deviation > 0.0 ? std::exp(-0.5 * m * m / (deviation * deviation)) : 1.0;
    total += weight;
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t from = (n + count + static_cast<std::size_t>(m + static_cast<int>(count))) % count;
      for (std::size_t k = 0; k < width; ++k) band.slopes[n * width + k] += weight * raw[from * width + k];
    }
  }
  for (double& slope : band.slopes) slope /= total;
  return band;
}

/// How well each place of the band is the edge, 0 to 1: its slope beside the steepest one at this point, which counts the more the steeper
/// it is. @param sign 1: bright outside, -1: bright inside
std::vector<double> strengthsOf(const Band& band, double sign) {
  const auto width = static_cast<std::size_t>(band.width());
  std::vector<double> strengths(band.slopes.size());
  for (std::size_t first = 0; first < strengths.size(); first += width) {
    double steepest = 0.0;
    for (std::size_t k = 0; k < width; ++k) steepest = std::max(steepest, sign * band.slopes[first + k]);
    for (std::size_t k = 0; k < width; ++k)
      strengths[first + k] = std::max(0.0, sign * band.slopes[first + k]) / (steepest + kHalfStrength);
  }
  return strengths;
}

struct Way {
  std::vector<double> offset_mm;
  double mean = 0.0;  ///< of the edge's strength
  double meanOffset_mm = 0.0;
};

/// @param away what the end of the band costs, in edges
Way bestWay(const Band& band, double sign, double away, double stiffness) {
  const std::size_t count = band.line.size(), width = static_cast<std::size_t>(band.width());
  // Twice around: in the middle of that the way has forgotten where it began, and meets itself.
  std::vector<double> best(width), next(width);
  std::vector<std::int8_t> from(2 * count * width, 0);
  const auto strengths = strengthsOf(band, sign);
  const auto own = [&](std::size_t n, std::size_t k) {
    const double share = (static_cast<double>(k) - band.reach) / band.reach;
    return strengths[n * width + k] - away * share * share;
  };
  for (std::size_t k = 0; k < width; ++k) best[k] = own(0, k);
  for (std::size_t n = 1; n < 2 * count; ++n) {
    for (std::size_t k = 0; k < width; ++k) {
      double most = -1e300;
      for (int d = -kSteepest; d <= kSteepest; ++d) {
        const auto before = static_cast<std::ptrdiff_t>(k) + d;
        if (before < 0 || before >= static_cast<std::ptrdiff_t>(width)) continue;
        const double slope = kPerPlace * d, value = best[static_cast<std::size_t>(before)] - stiffness * slope * slope;
        if (value <= most) continue;
        most = value;
        from[n * width + k] = static_cast<std::int8_t>(d);
      }
      next[k] = most + own(n % count, k);
    }
    best.swap(next);
  }
  Way way;
  way.offset_mm.assign(count, 0.0);
  auto k = static_cast<std::size_t>(std::max_element(best.begin(), best.end()) - best.begin());
  for (std::size_t n = 2 * count; n-- > 0;) {
    if (n >= count / 2 && n < count / 2 + count) {
      const std::size_t at = n % count;
      const double here = strengths[at * width + k];
      double shift = 0.0;
      if (k > 0 && k + 1 < width) {
        const double before = sign * band.slope(at, static_cast<int>(k) - 1), peak = sign * band.slope(at, static_cast<int>(k)),
                     after = sign * band.slope(at, static_cast<int>(k) + 1), bend = before - 2.0 * peak + after;
        if (bend < 0.0) shift = std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
      }
      way.offset_mm[at] = (static_cast<double>(k) - band.reach + shift) * band.step_mm;
      way.mean += here / static_cast<double>(count);
      way.meanOffset_mm += way.offset_mm[at] / static_cast<double>(count);
    }
    if (n > 0) k = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) + from[n * width + k]);
  }
  return way;
}

/// How far the border of a bright wall lies from the steepest place of its flank, outwards. Logarithmic compression carries a flank far
/// into the dark: the narrower the wall, the farther beyond its border. In the mean profile of the whole line the border is where the cube
/// of grey is steepest, nearer to the amplitude; a mere step from dark to bright needs nothing, and what is between goes by parts.
double flankOfWall_mm(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, const Band& band, const Way& way, double sign,
                      const TracingOptions& options) {
  const int half = static_cast<int>(std::ceil(options.snap.reach_mm / band.step_mm));
  std::vector<double> mean(static_cast<std::size_t>(2 * half + 1), 0.0), counted(mean.size(), 0.0);
  for (std::size_t n = 0; n < band.line.size(); ++n) {
    const auto profile =
        profileThrough(image, geometry, band.line[n] + way.offset_mm[n] * band.outwards[n], band.outwards[n], half, band.step_mm, 0.0);
    for (std::size_t k = 0; k < profile.size(); ++k) {
      if (std::isnan(profile[k])) continue;
      mean[k] += profile[k];
      counted[k] += 1.0;
    }
  }
  for (std::size_t k = 0; k < mean.size(); ++k) {
    if (counted[k] == 0.0) return 0.0;
    mean[k] /= 255.0 * counted[k];
  }
  std::vector<double> unpacked;
  for (const double grey : mean) unpacked.push_back(grey * grey * grey);
  const int near = static_cast<int>(std::ceil(kNearby * options.snap.reach_mm / band.step_mm));
  const auto steepestOf = [&](const std::vector<double>& profile) {
    const auto slopes = slopesOf(profile, band.step_mm, 0.5 * options.snap.blur_mm);
    int best = 0;
    for (int k = -near; k <= near; ++k)
      if (sign * slopes[static_cast<std::size_t>(half + k)] > sign * slopes[static_cast<std::size_t>(half + best)]) best = k;
    return best;
  };
  // The bright side is outside for sign 1.
  const auto at = [&](int k) { return mean[static_cast<std::size_t>(half + static_cast<int>(sign) * k)]; };
  double top = at(0);
  for (int k = 0; k <= half; ++k) top = std::max(top, at(k));
  const double height = top - at(-half);
  if (!(height > 0.0)) return 0.0;
  const double wall = std::clamp((top - at(half)) / height, 0.0, 1.0);
  return wall * band.step_mm * (steepestOf(unpacked) - steepestOf(mean));
}

std::vector<glm::dvec2> moved(const Band& band, const Way& way) {
  std::vector<glm::dvec2> line;
  for (std::size_t n = 0; n < band.line.size(); ++n) line.push_back(band.line[n] + way.offset_mm[n] * band.outwards[n]);
  return line;
}

}  // namespace

std::vector<glm::dvec2> resampled(const std::vector<glm::dvec2>& line, double spacing) {
  std::vector<double> way{0.0};
  for (std::size_t n = 0; n < line.size(); ++n) way.push_back(way.back() + glm::length(line[(n + 1) % line.size()] - line[n]));
  const double total = way.back();
  const auto count = static_cast<std::size_t>(std::max(8.0, std::round(total / spacing)));
  std::vector<glm::dvec2> points;
  std::size_t at = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double wanted = total * static_cast<double>(n) / static_cast<double>(count);
    while (at + 1 < line.size() && way[at + 1] <= wanted) ++at;
    const double piece = way[at + 1] - way[at];
    points.push_back(glm::mix(line[at], line[(at + 1) % line.size()], piece > 0.0 ? (wanted - way[at]) / piece : 0.0));
  }
  return points;
}

std::vector<glm::dvec2> smoothed(const std::vector<glm::dvec2>& line, double deviation) {
  const auto pass = [&](const std::vector<glm::dvec2>& from) {
    const int count = static_cast<int>(from.size()), reach = std::min(static_cast<int>(std::ceil(3.0 * deviation)), count / 2);
    std::vector<glm::dvec2> to(from.size(), glm::dvec2(0.0));
    double total = 0.0;
    for (int m = -reach; m <= reach; ++m) {
      const double weight = std::exp(-0.5 * m * m / (deviation * deviation));
      total += weight;
      for (int n = 0; n < count; ++n)
        to[static_cast<std::size_t>(n)] += weight * from[static_cast<std::size_t>(((n + m) % count + count) % count)];
    }
    for (glm::dvec2& each : to) each /= total;
    return to;
  };
  const auto once = pass(line), twice = pass(once);
  std::vector<glm::dvec2> made(line.size());
  for (std::size_t n = 0; n < line.size(); ++n) made[n] = 2.0 * once[n] - twice[n];
  return made;
}

std::vector<glm::dvec2> closedCurveThrough(std::span<const glm::dvec2> points, double spacing) {
  const std::size_t count = points.size();
  std::vector<glm::dvec2> line;
  for (std::size_t n = 0; n < count; ++n) {
    const glm::dvec2 &p0 = points[(n + count - 1) % count], &p1 = points[n], &p2 = points[(n + 1) % count], &p3 = points[(n + 2) % count];
    const double a = glm::length(p1 - p0), b = glm::length(p2 - p1), c = glm::length(p3 - p2);
    if (!(b > 0.0)) continue;
    // Slopes at both ends by chord lengths; two clicks at one place have none between them.
    const glm::dvec2 along = (p2 - p1) / b;
    const glm::dvec2 begin = a > 0.0 ? (b * (p1 - p0) / a + a * along) / (a + b) : along;
    const glm::dvec2 end = c > 0.0 ? (c * along + b * (p3 - p2) / c) / (b + c) : along;
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(b / spacing)));
    for (std::size_t m = 0; m < steps; ++m) {
      const double t = static_cast<double>(m) / static_cast<double>(steps), u = 1.0 - t;
      line.push_back(u * u * (1.0 + 2.0 * t) * p1 + t * u * u * b * begin + t * t * (3.0 - 2.0 * t) * p2 - t * t * u * b * end);
    }
  }
  return line;
}

std::vector<glm::dvec2> broughtToEdge(ImageView<const std::uint8_t> image, const ImageGeometry& geometry,
                                      const std::vector<glm::dvec2>& line, const TracingOptions& options) {
  const double reach_mm = options.snap.reach_mm;
  const Band wide = bandAround(image, geometry, line, options, reach_mm);
  std::optional<Way> way;
  double sign = 1.0, most = 0.0;
  for (const double each : {1.0, -1.0}) {
    if (options.snap.side == (each > 0.0 ? EdgeSide::brightToDark : EdgeSide::darkToBright)) continue;
    Way candidate = bestWay(wide, each, kFromClicks, kStiffness);
    const double off = candidate.meanOffset_mm / (kRoughClicks * reach_mm), worth = candidate.mean * std::exp(-0.5 * off * off);
    if (way && worth <= most) continue;
    most = worth;
    sign = each;
    way = std::move(candidate);
  }
  if (!way || way->mean < kWeakestMean) return line;
  // Once more about what was found: only now are its normals those of the edge.
  const double deviation = options.smoothing_mm / options.spacing_mm;
  auto found = moved(wide, *way);
  found = resampled(deviation > 0.0 ? smoothed(resampled(found, options.spacing_mm), deviation) : found, options.spacing_mm);
  const Band narrow = bandAround(image, geometry, found, options, kNearby * reach_mm);
  auto onEdge = bestWay(narrow, sign, kFromFound, kStifferStill);
  const double shift_mm = flankOfWall_mm(image, geometry, narrow, onEdge, sign, options);
  for (double& offset : onEdge.offset_mm) offset += shift_mm;
  return moved(narrow, onEdge);
}

}  // namespace ew::measurement
