#include "bench/images/echo_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ew {
namespace {

constexpr double kPatch_mm = 8.0;        // both ways
constexpr double kMostGap_mm = 2.5;      // of gel between face and skin; behind more there is air
constexpr double kLeaves_mm = 1.5;       // out of the body for so long
constexpr double kNearSurface_mm = 1.5;  // of a reflecting surface nothing counts
constexpr int kFaintest = 60;            // grey level of tissue that counts
constexpr int kEvenWithin = 60;          // grey levels; a texture is divided out
constexpr double kLeastShare = 0.5;      // of a patch that has to count
constexpr float kOpen_db = 0.5F, kShade_db = 8.0F;
constexpr float kEvenLoss_db = 4.0F;               // what differs between the lines of an even patch
constexpr double kDecibelPerLevel = 60.0 / 255.0;  // of maps
constexpr std::size_t kPlanes = 5;
constexpr std::array<double, kPlanes> kSigmas{0.0, -0.8, 0.8, -1.6, 1.6};
constexpr int kMixedReach = 1;  // voxels of labels: a thinner vessel is known to the model alone

std::optional<glm::ivec3> placeAt(const Grid& grid, const glm::dmat4& toVoxel, const glm::dvec3& p) {
  const glm::ivec3 at(glm::floor(glm::dvec3(toVoxel * glm::dvec4(p, 1.0)) + 0.5));
  return grid.contains(at) ? std::optional(at) : std::nullopt;
}

std::optional<std::size_t> voxelAt(const Grid& grid, const glm::dmat4& toVoxel, const glm::dvec3& p) {
  const auto at = placeAt(grid, toVoxel, p);
  return at ? std::optional(grid.indexOf(at->x, at->y, at->z)) : std::nullopt;
}

/// What a step of a line meets in one plane.
struct Met {
  std::uint8_t level = 0;
  bool isSeen = false;     ///< in the body, reached without air
  bool isSurface = false;  ///< close to a reflecting surface
  bool isUneven = false;
  bool isMixed = false;  ///< other tissue within kMixedReach voxels
  float reflected_db = 0.0F;
  float lost_db = 0.0F;  ///< with the excess of attenuation
};

/// Whether another label lies within kMixedReach voxels along an axis; beyond the labels there is none.
bool isMixedAt(const Volume& labels, const glm::ivec3& at) {
  const std::uint8_t own = labels.echo[labels.grid.indexOf(at.x, at.y, at.z)];
  for (int axis = 0; axis < 3; ++axis)
    for (int step = -kMixedReach; step <= kMixedReach; ++step) {
      glm::ivec3 other = at;
      other[axis] += step;
      if (labels.grid.contains(other) && labels.echo[labels.grid.indexOf(other.x, other.y, other.z)] != own) return true;
    }
  return false;
}

/// All lines of one plane, step by step.
struct Walk {
  std::size_t steps = 0;
  std::vector<Met> met;
  [[nodiscard]] const Met& at(int line, std::size_t step) const { return met[static_cast<std::size_t>(line) * steps + step]; }
};

Walk walkPlane(const EchoTruth& truth, const BeamGrid& grid, const std::vector<double>& elevationalSigma_mm, double sigmas,
               const Transform<frame::World, frame::Probe>& probeToWorld) {
  Walk walk;
  walk.steps = static_cast<std::size_t>(grid.depth_mm(grid.samples - 1) / kEchoStep_mm);
  walk.met.resize(walk.steps * grid.lines.size());
  const glm::dmat4 toMaps = truth.mapsGrid.worldToVoxel().matrix * probeToWorld.matrix,
                   toVolume = truth.volumeGrid.worldToVoxel().matrix * probeToWorld.matrix,
                   toLabels = truth.labelsGrid.worldToVoxel().matrix * probeToWorld.matrix;
  for (std::size_t l = 0; l < grid.lines.size(); ++l) {
    float reflected_db = 0.0F, absorbed_db = 0.0F;
    int before = -1;
    double outside_mm = 0.0;
    bool entered = false, lost = false;
    for (std::size_t s = 0; s < walk.steps; ++s) {
      const double depth_mm = (static_cast<double>(s) + 0.5) * kEchoStep_mm;
      const double aside_mm = sigmas * elevationalSigma_mm[static_cast<std::size_t>(depth_mm)];
      const glm::dvec3 p(grid.lines[l].origin_mm + depth_mm * grid.lines[l].direction, aside_mm);
      Met& met = walk.met[l * walk.steps + s];
      const auto voxel = voxelAt(truth.volumeGrid, toVolume, p);
      const bool inside = voxel && truth.volume.coverageAt(*voxel) != Coverage::absent;
      outside_mm = inside ? 0.0 : outside_mm + kEchoStep_mm;
      lost = lost || outside_mm > (entered ? kLeaves_mm : kMostGap_mm);
      entered = entered || inside;
      if (const auto at = placeAt(truth.labelsGrid, toLabels, p); at && truth.labels != nullptr) {
        const int label = truth.labels->echo[truth.labels->grid.indexOf(at->x, at->y, at->z)];
        if (label != before) reflected_db += truth.reflection_db[static_cast<std::size_t>(label)];
        before = label;
        absorbed_db += truth.excess_dbPerMm[static_cast<std::size_t>(label)] * static_cast<float>(kEchoStep_mm);
        met.isUneven = truth.isUneven[static_cast<std::size_t>(label)];
        met.isMixed = isMixedAt(*truth.labels, *at);
      }
      met.reflected_db = reflected_db;
      met.lost_db = reflected_db + absorbed_db;
      met.isSeen = inside && !lost;
      if (const auto at = voxelAt(truth.mapsGrid, toMaps, p)) {
        met.level = truth.maps.level[*at];
        met.isSurface = !truth.maps.surfaceDistance.empty() && truth.maps.surfaceDistance[*at] != 0 &&
                        std::abs(truth.maps.surfaceDistance[*at] - 128) < kNearSurface_mm * TissueMaps::kDistanceStepsPerMm;
      }
    }
  }
  return walk;
}

void judge(const std::array<Walk, kPlanes>& planes, EchoPatch& patch) {
  const auto first = static_cast<std::size_t>(patch.from_mm / kEchoStep_mm), last = static_cast<std::size_t>(patch.to_mm / kEchoStep_mm);
  int lowest = 255, highest = 0;
  bool isClear = true, isFull = true;
  double counted = 0.0, even = 0.0;
  for (int l = patch.firstLine; l < patch.firstLine + patch.lines; ++l)
    for (std::size_t s = first; s < last; ++s) {
      bool counts = true, isMixed = false;
      for (const Walk& plane : planes) {
        const Met& met = plane.at(l, s);
        counts = counts && met.isSeen && !met.isSurface && met.level >= kFaintest;
        isMixed = isMixed || met.isMixed;
        isClear = isClear && met.reflected_db < kOpen_db;
      }
      patch.levels.push_back(counts ? planes.front().at(l, s).level : std::uint8_t{0});
      patch.evenLevels.push_back(isMixed ? std::uint8_t{0} : patch.levels.back());
      if (!counts) continue;
      counted += 1.0;
      if (isMixed) continue;
      even += 1.0;
      for (const Walk& plane : planes) {
        const Met& met = plane.at(l, s);
        lowest = std::min<int>(lowest, met.level);
        highest = std::max<int>(highest, met.level);
        isFull = isFull && !met.isUneven;
      }
    }
  float leastLost_db = std::numeric_limits<float>::infinity(), mostLost_db = -leastLost_db;
  for (const Walk& plane : planes)
    for (int l = patch.firstLine; l < patch.firstLine + patch.lines; ++l) {
      leastLost_db = std::min(leastLost_db, plane.at(l, first).lost_db);
      mostLost_db = std::max(mostLost_db, plane.at(l, first).lost_db);
    }
  const double least = kLeastShare * static_cast<double>(patch.levels.size());
  if (counted < least) return;
  patch.isOpen = isClear;
  patch.isEven = patch.isOpen && even >= least && isFull && highest - lowest <= kEvenWithin && mostLost_db - leastLost_db <= kEvenLoss_db;
  int shaded = 0;
  for (int l = patch.firstLine; l < patch.firstLine + patch.lines; ++l)
    shaded += planes.front().at(l, first).reflected_db >= kShade_db ? 1 : 0;
  patch.isShaded = 2 * shaded >= patch.lines;
}

/// The patch's samples of a frame, divided by their mean less 1, NaN where they do not count; empty where none does.
struct Divided {
  std::vector<double> values;  ///< (lines x samples), a row for each sample
  int lines = 0, samples = 0;
  [[nodiscard]] double at(int line, int sample) const { return values[static_cast<std::size_t>(sample * lines + line)]; }
};

int firstSampleOf(const EchoFrame& frame, double depth_mm) { return static_cast<int>(std::ceil(depth_mm / frame.grid.sampleSpacing_mm)); }

Divided dividedOf(const EchoFrame& frame, const EchoPatch& patch) {
  Divided made;
  const int first = firstSampleOf(frame, patch.from_mm), last = std::min(firstSampleOf(frame, patch.to_mm), frame.grid.samples);
  made.lines = patch.lines;
  made.samples = last - first;
  double sum = 0.0, count = 0.0;
  for (int s = first; s < last; ++s)
    for (int l = 0; l < patch.lines; ++l) {
      const std::uint8_t level = patch.valueAt(patch.evenLevels, patch.firstLine + l, frame.grid.depth_mm(s));
      const bool counts = level != 0;
      // Of the power that the tissue has there by the maps.
      const double known = counts ? std::pow(10.0, 0.1 * kDecibelPerLevel * (level - 255.0)) : 1.0;
      made.values.push_back(counts ? static_cast<double>(frame.at(patch.firstLine + l, s)) / known : std::nan(""));
      if (!counts) continue;
      sum += made.values.back();
      count += 1.0;
    }
  const double mean = sum / std::max(count, 1.0);
  if (!(mean > 0.0)) return {};
  for (double& value : made.values) value = value / mean - 1.0;
  return made;
}

}  // namespace

std::uint8_t EchoPatch::valueAt(const std::vector<std::uint8_t>& values, int line, double depth_mm) const {
  const auto first = static_cast<int>(from_mm / kEchoStep_mm), steps = static_cast<int>(to_mm / kEchoStep_mm) - first;
  const int step = std::clamp(static_cast<int>(depth_mm / kEchoStep_mm) - first, 0, steps - 1);
  return values[static_cast<std::size_t>((line - firstLine) * steps + step)];
}

EchoFrame frameOfAmplitudes(const BeamGrid& grid, const Image<float>& amplitudes) {
  EchoFrame frame{grid, amplitudes.pixels};
  for (float& value : frame.power) value *= value;
  return frame;
}

EchoFrame frameOfLevels(const BeamGrid& grid, const BeamImage& levels, double dynamicRange_db) {
  EchoFrame frame{grid, levels.pixels};
  const double perLevel = 0.1 * dynamicRange_db / 255.0;
  for (float& value : frame.power) value = static_cast<float>(std::pow(10.0, perLevel * (static_cast<double>(value) - 255.0)));
  return frame;
}

std::vector<EchoPatch> patchesOf(const EchoTruth& truth, const BeamGrid& grid, const std::vector<double>& elevationalSigma_mm,
                                 const Transform<frame::World, frame::Probe>& probeToWorld) {
  std::array<Walk, kPlanes> planes;
  for (std::size_t n = 0; n < kPlanes; ++n) planes[n] = walkPlane(truth, grid, elevationalSigma_mm, kSigmas[n], probeToWorld);
  std::vector<EchoPatch> patches;
  const double depth_mm = grid.depth_mm(grid.samples - 1);
  // Small images have small patches.
  const double side_mm = std::min(kPatch_mm, 0.1 * depth_mm);
  for (double from_mm = side_mm; from_mm + side_mm < depth_mm - side_mm; from_mm += side_mm) {
    const auto wide = static_cast<int>(std::lround(side_mm / grid.lineSpacing_mm(from_mm + 0.5 * side_mm)));
    const int lines = std::clamp(wide, 6, static_cast<int>(grid.lines.size()) / 3);
    for (int first = 2; first + lines + 2 <= static_cast<int>(grid.lines.size()); first += lines) {
      EchoPatch& patch = patches.emplace_back();
      patch.firstLine = first;
      patch.lines = lines;
      patch.from_mm = from_mm;
      patch.to_mm = from_mm + side_mm;
      judge(planes, patch);
    }
  }
  return patches;
}

double levelOf_db(const EchoFrame& frame, const EchoPatch& patch) {
  const int first = firstSampleOf(frame, patch.from_mm), last = std::min(firstSampleOf(frame, patch.to_mm), frame.grid.samples);
  double sum = 0.0, count = 0.0;
  for (int s = first; s < last; ++s)
    for (int l = patch.firstLine; l < patch.firstLine + patch.lines; ++l) {
      if (patch.valueAt(patch.levels, l, frame.grid.depth_mm(s)) == 0) continue;
      sum += static_cast<double>(frame.at(l, s));
      count += 1.0;
    }
  return 10.0 * std::log10(std::max(sum / std::max(count, 1.0), 1e-30));
}

void SpeckleSums::add(const EchoFrame& frame, const EchoPatch& patch, double axialWidth_mm, double lateralWidth_mm) {
  const Divided x = dividedOf(frame, patch);
  if (x.values.empty()) return;
  const double depth_mm = frame.grid.depth_mm(frame.grid.samples - 1), lineSpacing_mm = frame.grid.lineSpacing_mm(patch.middle_mm());
  Band& band = bands_[static_cast<std::size_t>(std::clamp(static_cast<int>(kEchoBands * patch.middle_mm() / depth_mm), 0, kEchoBands - 1))];
  const int axialLag = std::max(1, static_cast<int>(std::lround(0.5 * axialWidth_mm / frame.grid.sampleSpacing_mm)));
  const int lateralLag = std::clamp(static_cast<int>(std::lround(0.5 * lateralWidth_mm / lineSpacing_mm)), 1, x.lines - 1);
  for (int s = 0; s < x.samples; ++s)
    for (int l = 0; l < x.lines; ++l) {
      const double here = x.at(l, s);
      if (std::isnan(here)) continue;
      amplitude_ += std::sqrt(here + 1.0);
      square_ += here + 1.0;
      count_ += 1.0;
      band.variance += here * here;
      band.count += 1.0;
      if (s + axialLag < x.samples && !std::isnan(x.at(l, s + axialLag))) {
        band.axial += here * x.at(l, s + axialLag);
        band.axialCount += 1.0;
        band.axialLag2_mm2 += std::pow(axialLag * frame.grid.sampleSpacing_mm, 2);
      }
      if (l + lateralLag < x.lines && !std::isnan(x.at(l + lateralLag, s))) {
        band.lateral += here * x.at(l + lateralLag, s);
        band.lateralCount += 1.0;
        band.lateralLag2_mm2 += std::pow(lateralLag * lineSpacing_mm, 2);
      }
    }
  ++band.patches;
}

double SpeckleSums::signalToNoise() const {
  if (!(count_ > 0.0)) return 0.0;
  const double mean = amplitude_ / count_, variance = square_ / count_ - mean * mean;
  return variance > 0.0 ? mean / std::sqrt(variance) : 0.0;
}

SpeckleSums::Lengths SpeckleSums::lengths(int band) const {
  const Band& sums = bands_[static_cast<std::size_t>(band)];
  Lengths found;
  found.patches = sums.patches;
  // A Gaussian autocovariance that has fallen to c at a lag is lag sqrt(4 ln 2 / -ln c) wide (Wagner et al. 1983).
  const auto width = [&](double product, double count, double lag2) {
    if (!(count > 0.0 && sums.variance > 0.0)) return 0.0;
    const double correlated = product / count / (sums.variance / sums.count);
    return correlated > 0.02 && correlated < 0.999 ? std::sqrt(lag2 / count * 4.0 * std::log(2.0) / -std::log(correlated)) : 0.0;
  };
  found.axial_mm = width(sums.axial, sums.axialCount, sums.axialLag2_mm2);
  found.lateral_mm = width(sums.lateral, sums.lateralCount, sums.lateralLag2_mm2);
  return found;
}

void ViewCorrelation::add(const EchoFrame& still, const EchoFrame& moved, const EchoPatch& patch,
                          const Transform<frame::Probe, frame::Probe>& stillToMoved, const Probe& probe) {
  const int first = firstSampleOf(still, patch.from_mm), last = std::min(firstSampleOf(still, patch.to_mm), still.grid.samples);
  const auto lines = static_cast<int>(moved.grid.lines.size());
  std::vector<double> a, b;
  for (int s = first; s < last; ++s)
    for (int l = patch.firstLine; l < patch.firstLine + patch.lines; ++l) {
      if (patch.valueAt(patch.evenLevels, l, still.grid.depth_mm(s)) == 0) continue;
      const BeamGrid::Line& line = still.grid.lines[static_cast<std::size_t>(l)];
      const glm::dvec3 p(line.origin_mm + still.grid.depth_mm(s) * line.direction, 0.0);
      const glm::dvec3 q = (stillToMoved * Point<frame::Probe>{p}).at;
      const glm::dvec2 place = lineAndSampleAt(probe, Knobs{}, moved.grid, glm::dvec2(q));
      const auto l0 = static_cast<int>(std::floor(place.x)), s0 = static_cast<int>(std::floor(place.y));
      if (l0 < 0 || l0 + 1 >= lines || s0 < 1 || s0 + 2 >= moved.grid.samples) continue;
      const double u = place.x - l0, v = place.y - s0;
      const auto along = [&](int at) {  // Catmull-Rom: straight lines between samples would cost correlation
        const double p0 = static_cast<double>(moved.at(at, s0 - 1)), p1 = static_cast<double>(moved.at(at, s0)),
                     p2 = static_cast<double>(moved.at(at, s0 + 1)), p3 = static_cast<double>(moved.at(at, s0 + 2));
        return p1 + 0.5 * v * (p2 - p0 + v * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 + v * (3.0 * (p1 - p2) + p3 - p0)));
      };
      a.push_back(static_cast<double>(still.at(l, s)));
      b.push_back((1.0 - u) * along(l0) + u * along(l0 + 1));
    }
  if (a.size() < 16) return;
  double meanA = 0.0, meanB = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) meanA += a[n], meanB += b[n];
  meanA /= static_cast<double>(a.size());
  meanB /= static_cast<double>(b.size());
  if (!(meanA > 0.0 && meanB > 0.0)) return;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double x = a[n] / meanA - 1.0, y = b[n] / meanB - 1.0;
    aa_ += x * x;
    bb_ += y * y;
    ab_ += x * y;
  }
  ++patches_;
}

double ViewCorrelation::value() const { return aa_ > 0.0 && bb_ > 0.0 ? ab_ / std::sqrt(aa_ * bb_) : 0.0; }

}  // namespace ew
