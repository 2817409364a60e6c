#include "echo_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ew::detail {
namespace {

constexpr double kRowsPerSigma = 2.0;  // of the fine grid, at the narrowest place of the beam
constexpr double kFastRowsPerSigma = 1.4;
constexpr int kMostPadding = 64;      // rows beside the fan
constexpr double kCoarsest_mm = 0.5;  // the lattice is this times a power of the root of two: probes of nearly the same resolution, and
                                      // neighbouring settings, see the same scatterers

void layRows(EchoLayout& layout) {
  const auto lines = static_cast<int>(layout.grid.lines.size());
  double finest = std::numeric_limits<double>::infinity();  // standard deviation in lines
  for (int s = 0; s < layout.grid.samples; s += 8) {
    const double depth_mm = layout.grid.depth_mm(s);
    finest = std::min(finest, layout.beams.lateralSigma_mm(depth_mm) / std::max(layout.grid.lineSpacing_mm(depth_mm), 1e-3));
  }
  layout.rowsPerLine = std::clamp(static_cast<int>(std::ceil((layout.planes == 1 ? kFastRowsPerSigma : kRowsPerSigma) / finest)), 1, 8);
  double widest = 1.0;
  for (int s = 0; s < layout.grid.samples; ++s) {
    const double depth_mm = layout.grid.depth_mm(s);
    widest = std::max(widest, kLateralSigmas * layout.beams.lateralSigma_mm(depth_mm) / std::max(layout.rowSpacing_mm(depth_mm), 1e-6));
  }
  layout.rowPadding = static_cast<int>(std::ceil(std::min<double>(widest, kMostPadding)));
  layout.rows = (lines - 1) * layout.rowsPerLine + 1 + 2 * layout.rowPadding;
  layout.columnPadding = static_cast<int>(std::ceil(4.0 * layout.beams.axialSigma_mm / layout.grid.sampleSpacing_mm)) + 2;
  layout.columns = layout.grid.samples + 2 * layout.columnPadding;
  layout.tiles = (layout.columns + kTileColumns - 1) / kTileColumns;
}

/// The squares of the lateral beam have the integral 1, whatever its width: speckle keeps its level with depth, but for what the focus
/// does.
void layLateral(EchoLayout& layout) {
  layout.lateral.assign(static_cast<std::size_t>(layout.tiles), {});
  layout.reachOfTile.assign(static_cast<std::size_t>(layout.tiles), 1);
  layout.focusFactor.resize(static_cast<std::size_t>(layout.tiles * kTileColumns));
  constexpr int kWidth = 2 * kTileColumns;
  for (int tile = 0; tile < layout.tiles; ++tile) {
    std::vector<double> sigma(kTileColumns), spacing(kTileColumns);
    int& reach = layout.reachOfTile[static_cast<std::size_t>(tile)];
    for (int c = 0; c < kTileColumns; ++c) {
      const double depth_mm = std::clamp(layout.depthOfColumn_mm(tile * kTileColumns + c), 0.0, layout.depth_mm);
      layout.focusFactor[static_cast<std::size_t>(tile * kTileColumns + c)] =
          static_cast<float>(std::pow(10.0, 0.05 * layout.beams.beamGain_db(depth_mm)));
      spacing[static_cast<std::size_t>(c)] = std::max(layout.rowSpacing_mm(depth_mm), 1e-6);
      sigma[static_cast<std::size_t>(c)] = layout.beams.lateralSigma_mm(depth_mm) / spacing[static_cast<std::size_t>(c)];
      reach = std::max(reach, static_cast<int>(std::ceil(kLateralSigmas * sigma[static_cast<std::size_t>(c)])));
    }
    reach = std::min(reach, layout.rowPadding);
    std::vector<float>& weights = layout.lateral[static_cast<std::size_t>(tile)];
    weights.resize(static_cast<std::size_t>((reach + 1) * kWidth));
    for (int c = 0; c < kTileColumns; ++c) {
      const double width = sigma[static_cast<std::size_t>(c)];
      double power = 0.0;
      for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (width * width));
      const double strength = static_cast<double>(layout.focusFactor[static_cast<std::size_t>(tile * kTileColumns + c)]) /
                              std::sqrt(power * spacing[static_cast<std::size_t>(c)]);
      for (int t = 0; t <= reach; ++t) {
        const auto weight = static_cast<float>(strength * std::exp(-0.5 * t * t / (width * width)));
        weights[static_cast<std::size_t>(t * kWidth + 2 * c)] = weights[static_cast<std::size_t>(t * kWidth + 2 * c + 1)] = weight;
      }
    }
  }
}

void layPulse(EchoLayout& layout) {
  // Scatterers are shared by two columns; that adds a sixth of a step's square to the variance, which the pulse leaves out.
  const double columns = layout.beams.axialSigma_mm / layout.grid.sampleSpacing_mm, sigma = std::sqrt(columns * columns - 1.0 / 6.0);
  const int reach = std::min(layout.columnPadding - 1, static_cast<int>(std::ceil(3.2 * sigma)));
  double power = 0.0;
  for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (sigma * sigma));
  for (int t = 0; t <= reach; ++t)
    layout.pulse.push_back(static_cast<float>(std::exp(-0.5 * t * t / (sigma * sigma)) / std::sqrt(power * layout.grid.sampleSpacing_mm)));
}

/// Turn of the carrier of a look from column to column.
double turnOf_rad(const EchoLayout& layout, int look) {
  return (look - 0.5 * (layout.beams.looks - 1)) * layout.beams.lookStep_radPerMm() * layout.grid.sampleSpacing_mm;
}

void layLooks(EchoLayout& layout) {
  const int looks = layout.beams.looks;
  // The mean of the logarithm rises with the number of looks: their averaged amplitude has the mean sqrt(pi) / 2 and the squared
  // coefficient of variation 4 / pi - 1 over the independent looks among them.
  const double independent = looks * looks / (looks + 2.0 * (looks - 1) * std::exp(-2.0));
  const double mean_db = 10.0 * std::log10(0.25 * std::numbers::pi) - 0.5 * 8.685889638 * (4.0 / std::numbers::pi - 1.0) / independent;
  if (looks > 1) layout.lookScale = std::pow(10.0, -0.05 * (mean_db + kMeanOfLog_db));
  // Scatterers that are shared by two columns lose 1 - (1 - cos) / 3 of their power at a carrier that turns so far in a column.
  const auto shareOf = [&](double turn_rad) {
    return static_cast<float>(layout.lookScale / (looks * std::sqrt(1.0 - (1.0 - std::cos(turn_rad)) / 3.0)));
  };
  layout.middleShare = looks % 2 == 1 ? shareOf(0.0) : 0.0F;
  for (int look = (looks + 1) / 2; look < looks; ++look) {
    const double turn_rad = turnOf_rad(layout, look);
    LookPair& pair = layout.lookPairs.emplace_back();
    pair.share = shareOf(turn_rad);
    for (std::size_t t = 0; t < layout.pulse.size(); ++t) {
      const auto weight = static_cast<double>(layout.pulse[t]), turned_rad = turn_rad * static_cast<double>(t);
      pair.cosine.push_back(static_cast<float>(weight * std::cos(turned_rad)));
      pair.sine.push_back(static_cast<float>(weight * std::sin(turned_rad)));
    }
  }
}

}  // namespace

double echoPitch_mm(const EchoBeams& beams, double depth_mm, double scatterersPerCell) {
  double cell_mm3 = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= 64; ++n) {
    const double at_mm = depth_mm * n / 64.0;
    cell_mm3 = std::min(cell_mm3, beams.usualLateralSigma_mm(at_mm) * beams.elevationalSigma_mm(at_mm));
  }
  cell_mm3 *= beams.axialSigma_mm * kFwhmOfSigma * kFwhmOfSigma * kFwhmOfSigma;
  const double steps = std::floor(2.0 * std::log2(std::cbrt(cell_mm3 / scatterersPerCell) / kCoarsest_mm));
  return kCoarsest_mm * std::exp2(0.5 * std::clamp(steps, -6.0, 4.0));
}

double echoSpacing_mm(const EchoBeams& beams, const LiveEchoesEffect& effect) {
  return kFwhmOfSigma * beams.axialSigma_mm / effect.samplesPerPulse;
}

EchoLayout echoLayoutOf(const Probe& probe, const Knobs& knobs, const LiveEchoesEffect& effect, const EchoBeams& beams, BeamGrid grid,
                        double look_rad) {
  EchoLayout layout;
  layout.beams = beams;
  layout.grid = std::move(grid);
  layout.fan = fanShapeOf(probe, knobs, look_rad);
  layout.face = layout.fan;
  layout.face.steering_rad = 0.0;
  layout.depth_mm = layout.grid.depth_mm(layout.grid.samples - 1);
  layout.effect = effect;
  layout.planes = echoPlanesOf(knobs.quality);
  layRows(layout);
  layout.pitch_mm = echoPitch_mm(beams, layout.depth_mm, effect.scatterersPerCell);
  layLateral(layout);
  layPulse(layout);
  layLooks(layout);
  return layout;
}

}  // namespace ew::detail
