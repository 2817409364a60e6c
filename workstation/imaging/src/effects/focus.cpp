#include "ew/imaging/effects/focus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/gaussian.h"
#include "probes/sound.h"

namespace ew {
namespace {

using detail::kSpeedOfSound_mmPerS;
using detail::kWidthOfSigma;
using detail::quantised;

constexpr double kFNumber = 3.0;
/// sin(pi u) / (pi u) = 1/2 at u = 0.60335.
constexpr double kFocalWidth = 1.2067;
/// A Gaussian aperture of full width W (half maximum) has the focal width (4 ln 2 / pi) L F / W; equal to kFocalWidth L F / D it is
/// 0.731 D wide.
constexpr double kFaceWidth = 4.0 * std::numbers::ln2 / (std::numbers::pi * kFocalWidth);

constexpr double kReach_sigmas = 3.0;
constexpr double kNarrow_lines = 0.6;
constexpr double kLeastWeight = 0.5 / 255.0;

double usableDepth_mm(double depth_mm) { return depth_mm > 0.0 ? depth_mm : 0.0; }

double transmitWidth_mm(const BeamModel& model, double focus_mm, double depth_mm) {
  const double aperture_mm = std::min(model.aperture_mm, focus_mm / kFNumber);
  return std::hypot(kFaceWidth * aperture_mm * (1.0 - depth_mm / focus_mm), kFocalWidth * model.wavelength_mm * depth_mm / aperture_mm);
}

double unfocusedWidth_mm(const BeamModel& model, double depth_mm) {
  return std::hypot(kFaceWidth * model.aperture_mm, kFocalWidth * model.wavelength_mm * depth_mm / model.aperture_mm);
}

}  // namespace

BeamModel beamModelOf(const Probe& probe, const Knobs& knobs, const FocusEffect& effect, double depth_mm) {
  BeamModel model;
  const double carrier_hz = knobs.carrier_hz > 0.0 ? knobs.carrier_hz : probe.carrier_hz;
  model.wavelength_mm = kSpeedOfSound_mmPerS / carrier_hz;
  model.aperture_mm = probe.aperture_mm;
  model.foci_mm[0] = knobs.focus_mm > 0.0 ? knobs.focus_mm : 0.5 * depth_mm;
  std::copy(knobs.moreFoci_mm.begin(), knobs.moreFoci_mm.end(), model.foci_mm.begin() + 1);
  model.recordedWidth_mm = kFocalWidth * std::numbers::sqrt2 / 2.0 * kFNumber * kSpeedOfSound_mmPerS / probe.carrier_hz;
  model.strength = effect.strength;
  return model;
}

double lateralWidth_mm(const BeamModel& model, double depth_mm) {
  EW_EXPECTS(model.wavelength_mm > 0.0 && model.aperture_mm > 0.0);
  const double z_mm = usableDepth_mm(depth_mm);
  double transmit_mm = 0.0;
  for (const double focus_mm : model.foci_mm) {
    if (!(focus_mm > 0.0 && std::isfinite(focus_mm))) continue;
    const double width_mm = transmitWidth_mm(model, focus_mm, z_mm);
    transmit_mm = transmit_mm > 0.0 ? std::min(transmit_mm, width_mm) : width_mm;
  }
  if (!(transmit_mm > 0.0)) transmit_mm = unfocusedWidth_mm(model, z_mm);
  const double receive_mm = kFocalWidth * model.wavelength_mm * std::max(kFNumber, z_mm / model.aperture_mm);
  return transmit_mm * receive_mm / std::hypot(transmit_mm, receive_mm);
}

double blurWidth_mm(const BeamModel& model, double depth_mm) {
  const double width_mm = lateralWidth_mm(model, depth_mm);
  const double beyond_mm2 = (width_mm - model.recordedWidth_mm) * (width_mm + model.recordedWidth_mm);
  return beyond_mm2 > 0.0 && model.strength > 0.0 ? model.strength * std::sqrt(beyond_mm2) : 0.0;
}

LateralKernels makeLateralKernels(const BeamModel& model, const BeamGrid& grid) {
  LateralKernels kernels;
  kernels.rows.resize(static_cast<std::size_t>(grid.samples));
  const int widest = static_cast<int>(grid.lines.size() / 2);
  for (int s = 0; s < grid.samples; ++s) {
    const double depth_mm = grid.depth_mm(s);
    const double sigma_lines = blurWidth_mm(model, depth_mm) / kWidthOfSigma / grid.lineSpacing_mm(depth_mm);
    // The variance of weights b, 1 - 2 b, b is 2 b.
    const double narrowWeight = 0.5 * sigma_lines * sigma_lines;
    if (!(narrowWeight > kLeastWeight)) continue;
    LateralKernels::Row& row = kernels.rows[static_cast<std::size_t>(s)];
    row.first = kernels.weights.size();
    if (sigma_lines < kNarrow_lines) {
      row.radius = 1;
      const double side = quantised(narrowWeight);
      kernels.weights.insert(kernels.weights.end(), {static_cast<float>(1.0 - 2.0 * side), static_cast<float>(side)});
      continue;
    }
    row.radius = static_cast<int>(std::min(std::ceil(kReach_sigmas * sigma_lines), static_cast<double>(widest)));
    const auto gaussian = [&](int line) { return std::exp(-0.5 * line * line / (sigma_lines * sigma_lines)); };
    double sum = 1.0;
    for (int k = 1; k <= row.radius; ++k) sum += 2.0 * gaussian(k);
    kernels.weights.resize(row.first + static_cast<std::size_t>(row.radius) + 1);
    double middle = 1.0;
    for (int k = row.radius; k >= 1; --k) {
      const double weight = quantised(gaussian(k) / sum);
      kernels.weights[row.first + static_cast<std::size_t>(k)] = static_cast<float>(weight);
      middle -= 2.0 * weight;
    }
    kernels.weights[row.first] = static_cast<float>(middle);
  }
  return kernels;
}

void rowResolutions(const BeamModel& model, const BeamGrid& grid, std::vector<int>& samplesOfRow) {
  const int lines = static_cast<int>(grid.lines.size());
  samplesOfRow.resize(static_cast<std::size_t>(grid.samples));
  for (int s = 0; s < grid.samples; ++s) {
    const double depth_mm = grid.depth_mm(s);
    const double width_lines = blurWidth_mm(model, depth_mm) / grid.lineSpacing_mm(depth_mm);
    samplesOfRow[static_cast<std::size_t>(s)] =
        width_lines > 1.0 ? std::max(2, static_cast<int>(std::lround((lines - 1) / width_lines)) + 1) : lines;
  }
}

}  // namespace ew
