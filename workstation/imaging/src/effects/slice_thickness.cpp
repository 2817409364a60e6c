#include "ew/imaging/effects/slice_thickness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "effects/gaussian.h"

namespace ew {
namespace {

/// How much too wide a straight piece may be between its ends, as a share of the width.
constexpr double kWidthError = 0.03;

/// Distance of neighbouring planes in standard deviations, by (planes - 3) / 2. Closer planes resolve finer speckle, wider ones follow the
/// bell further out; these keep the error small on fields whose correlation has 0.1 to 1 of the beam's standard deviation.
constexpr std::array<double, 4> kSpacing_sigmas = {1.4, 0.85, 0.65, 0.55};

/// Normalised weights e^(-decay k^2), the middle one first, then each twice.
std::vector<double> bellWeights(int planes, double decay) {
  std::vector<double> weights{1.0};
  double sum = 1.0;
  for (int k = 1; k <= planes / 2; ++k) {
    weights.insert(weights.end(), 2, std::exp(-decay * k * k));
    sum += 2.0 * weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

double varianceOf(const ElevationRule& rule) {
  double variance = 0.0;
  for (std::size_t p = 0; p < rule.weights.size(); ++p) variance += rule.weights[p] * rule.offset_sigmas[p] * rule.offset_sigmas[p];
  return variance;
}

/// Lies the curve nowhere further than kWidthError inside the chord between two samples?
bool straightEnough(const std::vector<double>& width_mm, std::size_t first, std::size_t last) {
  const double slope = (width_mm[last] - width_mm[first]) / static_cast<double>(last - first);
  for (std::size_t s = first + 1; s < last; ++s)
    if (width_mm[first] + slope * static_cast<double>(s - first) > (1.0 + kWidthError) * width_mm[s]) return false;
  return true;
}

/// The longest straight pieces, from the face on: the width is convex over depth, so that a shorter chord is never worse.
std::vector<ElevationPlane::Piece> piecesOf(const std::vector<double>& width_mm) {
  std::vector<ElevationPlane::Piece> pieces;
  for (std::size_t first = 0; first < width_mm.size();) {
    std::size_t good = first, bad = width_mm.size();
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (middle == first + 1 || straightEnough(width_mm, first, middle) ? good : bad) = middle;
    }
    pieces.push_back({static_cast<int>(first), static_cast<int>(good), width_mm[first], width_mm[good]});
    first = good + 1;
  }
  return pieces;
}

}  // namespace

double elevationalWidth_mm(const Probe& probe, double carrier_hz, const SliceThicknessEffect& effect, double depth_mm) {
  EW_EXPECTS(probe.elevationalFocus_mm > 0.0);
  const double z_mm = depth_mm > 0.0 ? depth_mm : 0.0;
  const double wavelengths = carrier_hz > 0.0 ? probe.carrier_hz / carrier_hz : 1.0;
  const double fromLens = z_mm / probe.elevationalFocus_mm;
  const double scale = effect.scale > 0.0 ? effect.scale : 0.0;
  return scale * std::hypot(probe.elevationalAperture_mm * (1.0 - fromLens), probe.elevationalThickness_mm * wavelengths * fromLens);
}

ElevationRule elevationRule(int planes) {
  EW_EXPECTS(planes >= 3 && planes <= 9 && planes % 2 == 1);
  const double spacing_sigmas = kSpacing_sigmas[static_cast<std::size_t>((planes - 3) / 2)];
  ElevationRule rule{{0.0}, {}};
  for (int k = 1; k <= planes / 2; ++k) rule.offset_sigmas.insert(rule.offset_sigmas.end(), {k * spacing_sigmas, -k * spacing_sigmas});
  // The variance falls as the decay grows: from more than 1 with equal weights to 0.
  double low = 0.0, high = 4.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double decay = 0.5 * (low + high);
    rule.weights = bellWeights(planes, decay);
    (varianceOf(rule) > 1.0 ? low : high) = decay;
  }
  return rule;
}

std::vector<ElevationPlane> makeElevationPlanes(const Probe& probe, double carrier_hz, const SliceThicknessEffect& effect,
                                                const BeamGrid& grid, int planes) {
  const ElevationRule rule = elevationRule(std::clamp(planes, 3, 9) | 1);
  std::vector<double> width_mm(static_cast<std::size_t>(grid.samples));
  for (int s = 0; s < grid.samples; ++s)
    width_mm[static_cast<std::size_t>(s)] = elevationalWidth_mm(probe, carrier_hz, effect, grid.depth_mm(s));
  const std::vector<ElevationPlane::Piece> widths = piecesOf(width_mm);

  std::vector<ElevationPlane> result(rule.weights.size());
  double middleWeight = 1.0;
  for (std::size_t p = 1; p < result.size(); ++p) {
    const double weight = detail::quantised(rule.weights[p]);
    result[p].weight = static_cast<float>(weight);
    middleWeight -= weight;
    result[p].pieces = widths;
    const double sigmas = rule.offset_sigmas[p] / detail::kWidthOfSigma;
    for (ElevationPlane::Piece& piece : result[p].pieces) {
      piece.offsetAtFirst_mm *= sigmas;
      piece.offsetAtLast_mm *= sigmas;
    }
  }
  result[0].weight = static_cast<float>(middleWeight);
  result[0].pieces = {{0, grid.samples - 1, 0.0, 0.0}};
  return result;
}

void rowsOf(const BeamGrid& grid, const ElevationPlane& plane, const Transform<frame::Voxel, frame::Probe>& probeToVoxel,
            std::vector<SampleRow>& rows) {
  rows.resize(grid.lines.size() * plane.pieces.size());
  auto row = rows.begin();
  for (std::size_t n = 0; n < grid.lines.size(); ++n) {
    const BeamGrid::Line& line = grid.lines[n];
    for (const ElevationPlane::Piece& piece : plane.pieces) {
      const int steps = piece.lastSample - piece.firstSample;
      const double slope_mm = steps > 0 ? (piece.offsetAtLast_mm - piece.offsetAtFirst_mm) / steps : 0.0;
      const glm::dvec4 start_mm(line.origin_mm, piece.offsetAtFirst_mm - slope_mm * piece.firstSample, 1.0);
      const glm::dvec4 step_mm(grid.sampleSpacing_mm * line.direction, slope_mm, 0.0);
      *row++ = {glm::dvec3(probeToVoxel.matrix * start_mm),
                glm::dvec3(probeToVoxel.matrix * step_mm),
                static_cast<int>(n),
                {piece.firstSample, piece.lastSample + 1}};
    }
  }
}

}  // namespace ew
