#include "scanner/scanner_setup.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "patient/anatomy.h"

namespace ew::phantom {
namespace {

constexpr double kRowsPerSigma = 2.0;     // of the fine grid, at the narrowest place of the beam
constexpr int kMostPadding = 64;          // rows beside the fan
constexpr double kRowStepPerPitch = 0.7;  // of the walk along a line that sums up losses
constexpr double kRing_db = -8.0;         // of the transmit pulse at the face
constexpr double kRingFall_db = 34.0;     // over the near field

double gainAt(const std::vector<DepthGain>& curve, double depth_mm) {
  const auto after = std::find_if(curve.begin(), curve.end(), [&](const DepthGain& g) { return g.depth_mm > depth_mm; });
  if (after == curve.begin()) return after->gain_db;
  const DepthGain& from = *(after - 1);
  if (after == curve.end()) return from.gain_db;
  return from.gain_db + (after->gain_db - from.gain_db) * (depth_mm - from.depth_mm) / (after->depth_mm - from.depth_mm);
}

void layOutGrid(ScannerSetup& setup) {
  const auto lines = static_cast<int>(setup.grid.lines.size());
  setup.fan.sector = isSector(setup.probe.kind);
  setup.fan.apex_mm = setup.fan.sector ? setup.probe.radius_mm : 0.0;
  setup.fan.halfAngle_rad = setup.probe.halfAngle_rad;
  setup.fan.halfWidth_mm = setup.grid.lines.back().origin_mm.x;
  setup.fan.depth_mm = setup.grid.depth_mm(setup.grid.samples - 1);

  double finest = std::numeric_limits<double>::infinity();  // standard deviation in lines
  for (int s = 0; s < setup.grid.samples; s += 8)
    finest = std::min(finest, setup.beams.lateralSigma_mm(setup.grid.depth_mm(s)) / setup.grid.lineSpacing_mm(setup.grid.depth_mm(s)));
  setup.rowsPerLine = std::clamp(static_cast<int>(std::ceil(kRowsPerSigma / finest)), 1, 16);
  double widest = 1.0;  // reach in rows
  for (int s = 0; s < setup.grid.samples; ++s) widest = std::max(widest, kLateralReach * setup.rowSigma(setup.grid.depth_mm(s)));
  setup.rowPadding = static_cast<int>(std::ceil(std::min<double>(widest, kMostPadding)));
  setup.columnPadding = static_cast<int>(std::ceil(4.0 * setup.beams.axialSigma_mm / setup.grid.sampleSpacing_mm)) + 2;
  setup.columns = static_cast<std::size_t>(setup.grid.samples + 2 * setup.columnPadding);

  setup.gridding.sector = setup.fan.sector;
  setup.gridding.apex_mm = static_cast<float>(setup.fan.apex_mm);
  const double across = setup.fan.sector ? 2.0 * setup.fan.halfAngle_rad : 2.0 * setup.fan.halfWidth_mm;
  setup.gridding.rows = (lines - 1) * setup.rowsPerLine + 1 + 2 * setup.rowPadding;
  setup.gridding.columns = static_cast<std::int32_t>(setup.columns);
  setup.gridding.rowsPerUnit = static_cast<float>((lines - 1) * setup.rowsPerLine / across);
  setup.gridding.middleRow = static_cast<float>(setup.rowPadding + 0.5 * (lines - 1) * setup.rowsPerLine);
  setup.gridding.columnsPerMm = static_cast<float>(1.0 / setup.grid.sampleSpacing_mm);
  setup.gridding.firstColumn = static_cast<float>(setup.columnPadding);
  setup.gridding.turnsPerMm = static_cast<float>(2.0 / setup.beams.wavelength_mm);
  setup.gridding.lensFocus_mm = static_cast<float>(setup.beams.lensFocus_mm);
  setup.gridding.nearPerMm = static_cast<float>(1.0 / setup.beams.lensNearRange_mm);
  setup.gridding.farPerMm = static_cast<float>(1.0 / setup.beams.lensFarRange_mm);
  setup.gridding.waistPerMm2 = static_cast<float>(0.5 / (setup.beams.lensWaist_mm * setup.beams.lensWaist_mm));
  setup.gridding.weight = static_cast<float>(1.0 / std::sqrt(setup.beams.lensWaist_mm * std::sqrt(std::numbers::pi)));
  setup.gridding.cut = static_cast<float>(0.5 * kElevationalReach * kElevationalReach);
}

/// What a plane mirror square to the beam returns: the integrals of the lateral and elevational beams and the pulse's peak, where the
/// squares of all three have the integral 1. The lens' wavefront is curved, so its integral is Fresnel's.
double planeEcho(const Beams& beams, double depth_mm) {
  const double rootPi = std::sqrt(std::numbers::pi);
  const double lateral = std::sqrt(2.0 * rootPi * beams.lateralSigma_mm(depth_mm));
  const double sigma = beams.elevationalSigma_mm(depth_mm);
  const double phaseCurvature = 4.0 * std::numbers::pi / beams.wavelength_mm * beams.elevationalCurvature_perMm(depth_mm);
  const double elevational =
      rootPi / std::sqrt(sigma * rootPi) / std::pow(0.25 / std::pow(sigma, 4) + phaseCurvature * phaseCurvature, 0.25);
  return lateral * elevational / std::sqrt(beams.axialSigma_mm * rootPi);
}

void layOutBeams(ScannerSetup& setup) {
  setup.lateral.assign(static_cast<std::size_t>(setup.rowPadding + 1), std::vector<float>(2 * setup.columns, 0.0F));
  setup.reachOfChunk.assign((setup.columns + kChunk - 1) / kChunk, 0);
  setup.mirrorScale.resize(setup.columns);
  for (std::size_t column = 0; column < setup.columns; ++column) {
    const double depth =
        std::clamp((static_cast<double>(column) - setup.columnPadding) * setup.grid.sampleSpacing_mm, 0.0, setup.fan.depth_mm);
    const double sigma = setup.rowSigma(depth);
    const int reach = std::clamp(static_cast<int>(std::ceil(kLateralReach * sigma)), 1, setup.rowPadding);
    int& reachOfChunk = setup.reachOfChunk[column / kChunk];
    reachOfChunk = std::max(reachOfChunk, reach);
    double power = 0.0;
    for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (sigma * sigma));
    const double strength = 1.0 / std::sqrt(power * std::max(setup.rowSpacing_mm(depth), 1e-6));
    for (int t = 0; t <= reach; ++t) {
      const auto weight = static_cast<float>(strength * std::exp(-0.5 * t * t / (sigma * sigma)));
      setup.lateral[static_cast<std::size_t>(t)][2 * column] = weight;
      setup.lateral[static_cast<std::size_t>(t)][2 * column + 1] = weight;
    }
    setup.mirrorScale[column] = static_cast<float>(1.0 / (planeEcho(setup.beams, depth) * setup.lookScale));
  }
  // Points are shared by two columns; that adds a sixth of a step's square to the variance, which the pulse leaves out.
  const double columns = setup.beams.axialSigma_mm / setup.grid.sampleSpacing_mm, sigma = std::sqrt(columns * columns - 1.0 / 6.0);
  const int reach = setup.columnPadding - 1;
  double power = 0.0;
  for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (sigma * sigma));
  for (int t = 0; t <= reach; ++t)
    setup.pulse.push_back(static_cast<float>(std::exp(-0.5 * t * t / (sigma * sigma)) / std::sqrt(power * setup.grid.sampleSpacing_mm)));
}

void layOutLooks(ScannerSetup& setup) {
  const int looks = setup.options.looks;
  for (int look = 0; look < looks; ++look) {
    const double step = (look - 0.5 * (looks - 1)) * setup.beams.lookStep_radPerMm() * setup.grid.sampleSpacing_mm;
    std::vector<float>& turn = setup.turns.emplace_back();
    for (std::size_t column = 0; column < setup.columns; ++column) {
      turn.push_back(static_cast<float>(std::cos(step * static_cast<double>(column))));
      turn.push_back(static_cast<float>(-std::sin(step * static_cast<double>(column))));
    }
  }
  if (looks == 1) return;
  // The mean of the logarithm rises with the number of looks: their averaged amplitude has the mean sqrt(pi) / 2 and the squared
  // coefficient of variation 4 / pi - 1 over the independent looks among them. Scaled back to that of a single look, so that a tissue
  // keeps its level.
  const double independent = looks * looks / (looks + 2.0 * (looks - 1) * std::exp(-2.0));
  const double mean_db = 10.0 * std::log10(0.25 * std::numbers::pi) - 0.5 * 8.685889638 * (4.0 / std::numbers::pi - 1.0) / independent;
  setup.lookScale = factorOf(mean_db + 2.507);
}

void layOutGains(const Patient& patient, double pitch_mm, ScannerSetup& setup) {
  for (int s = 0; s < setup.grid.samples; ++s) {
    const double gain_db = gainAt(setup.options.tgc, setup.grid.depth_mm(s)) + setup.options.gain_db;
    setup.depthGain.push_back(static_cast<float>(std::pow(10.0, 0.05 * gain_db)));
    double ring = 0.0;
    if (setup.probe.nearField_mm > 0.0) {
      const double t = setup.grid.depth_mm(s) / setup.probe.nearField_mm;
      const double beat = 0.6 + 0.4 * std::cos(2.0 * std::numbers::pi * setup.grid.depth_mm(s) / (1.7 * setup.beams.wavelength_mm));
      ring = beat * std::pow(10.0, 0.05 * (kRing_db - kRingFall_db * t));
    }
    setup.ring.push_back(static_cast<float>(ring > 1e-5 ? ring : 0.0));
  }
  setup.step_mm = kRowStepPerPitch * pitch_mm;
  setup.steps = static_cast<int>(std::ceil(setup.fan.depth_mm / setup.step_mm)) + 1;
  setup.step_mm = setup.fan.depth_mm / (setup.steps - 1);
  for (const Tissue& tissue : patient.tissues) {
    setup.lostPerStep_db.push_back(2.0 * tissue.attenuation_dbPerCmMhz * setup.options.carrier_hz * 1e-6 * setup.step_mm * 0.1);
    setup.lostAtSurface_db.push_back(tissue.reflection_db);
    setup.delayPerStep_mm.push_back((setup.options.assumedSpeed_mPerS / tissue.speed_mPerS - 1.0) * setup.step_mm);
  }
}

}  // namespace

double ScannerSetup::rowSigma(double depth_mm) const { return beams.lateralSigma_mm(depth_mm) / std::max(rowSpacing_mm(depth_mm), 1e-6); }

double ScannerSetup::reach_mm(double depth_mm) const {
  return kElevationalReach * beams.elevationalSigma_mm(std::clamp(depth_mm, 0.0, fan.depth_mm));
}

double ScannerSetup::reachBetween_mm(double nearer_mm, double farther_mm) const {
  return std::max(reach_mm(nearer_mm), reach_mm(farther_mm));  // narrowest in the focus, wider to both sides
}

ScannerSetup scannerSetupOf(const Patient& patient, const Probe& probe, const FormationOptions& options, BeamGrid grid, double pitch_mm) {
  ScannerSetup setup{.probe = probe, .options = options, .grid = std::move(grid), .beams = beamsOf(probe, options)};
  layOutGrid(setup);
  layOutLooks(setup);
  layOutBeams(setup);
  layOutGains(patient, pitch_mm, setup);
  return setup;
}

}  // namespace ew::phantom
