#include "ew/phantom/virtual_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/numbers.h"
#include "scanner/beams.h"
#include "scanner/block_echoes.h"
#include "scanner/form_lines.h"
#include "scanner/line_losses.h"
#include "scanner/scanner_setup.h"
#include "scanner/scatterers.h"
#include "scanner/slice_blocks.h"

namespace ew {

VirtualScanner::~VirtualScanner() = default;
VirtualScanner::Scratch::~Scratch() = default;

namespace {

using phantom::Beams;
using phantom::FrameScratch;

constexpr std::size_t kCacheBytes = 400u << 20;
constexpr double kSamplesPerPulse = 4.0;  // within the full width at half maximum
constexpr double kSamplesPerLook = 6.0;   // the same with several looks: their carriers lie off the middle
constexpr double kScatterersPerResolutionCell = 3.5;

class Scanner final : public VirtualScanner {
 public:
  Scanner(std::shared_ptr<const Patient> patient, const Probe& probe, const FormationOptions& options, BeamGrid grid, double pitch_mm,
          std::uint64_t seed)
      : setup_(phantom::scannerSetupOf(*patient, probe, options, std::move(grid), pitch_mm)),
        field_(std::move(patient), pitch_mm, seed, kCacheBytes) {}

  const FormationOptions& options() const override { return setup_.options; }
  const Probe& probe() const override { return setup_.probe; }
  const BeamGrid& grid() const override { return setup_.grid; }
  PointSpread pointSpreadAt(double depth_mm) const override {
    const Beams& beams = setup_.beams;
    return {phantom::kFwhmOfSigma * beams.axialSigma_mm, phantom::kFwhmOfSigma * beams.lateralSigma_mm(depth_mm),
            phantom::kFwhmOfSigma * beams.elevationalSigma_mm(depth_mm)};
  }
  std::unique_ptr<Scratch> makeScratch() const override { return std::make_unique<FrameScratch>(); }

  void envelope(const Transform<frame::World, frame::Probe>& probeToWorld, const Deformation& deformation, std::uint64_t frame,
                Scratch& scratch, Image<float>& envelope) const override {
    auto& work = static_cast<FrameScratch&>(scratch);
    const phantom::View view{probeToWorld, inverse(probeToWorld), deformation, deformation.reach_mm() > 0.0};
    envelope = {};
    if (!findBlocks(setup_, field_, view, work)) return;
    walkLines(setup_, field_, view, work);
    work.fine.assign(2 * (static_cast<std::size_t>(setup_.gridding.rows) * setup_.columns + 2), 0.0F);
    for (const FrameScratch::Block& block : work.blocks) addBlock(setup_, field_, view, block, work);
    formLines(setup_, field_.pitch_mm(), frame, work, envelope);
  }

 private:
  phantom::ScannerSetup setup_;
  phantom::ScattererField field_;
};

}  // namespace

Result<std::unique_ptr<VirtualScanner>> makeVirtualScanner(std::shared_ptr<const Patient> patient, const Probe& probe,
                                                           const FormationOptions& options, std::uint64_t seed) {
  EW_EXPECTS(patient != nullptr);
  std::optional<Error> problem;
  const auto check = [&](const char* field, double value, double lowest, double highest) {
    if (problem || (value >= lowest && value <= highest)) return;
    problem = Error{ErrorCode::badField,
                    say<"The virtual scanner's %1 is %2; choose one from %3 to %4.">(std::string(field), textOf(value), textOf(lowest),
                                                                                     textOf(highest)),
                    {{"field", field}}};
  };
  FormationOptions resolved = options;
  if (resolved.depth_mm == 0.0) resolved.depth_mm = probe.defaultDepth_mm;
  if (resolved.carrier_hz == 0.0) resolved.carrier_hz = probe.carrier_hz;
  check("depth_mm", resolved.depth_mm, std::min(5.0, probe.minDepth_mm), probe.maxDepth_mm);
  if (resolved.focus_mm == 0.0) resolved.focus_mm = 0.5 * resolved.depth_mm;
  check("focus_mm", resolved.focus_mm, 1.0, 1000.0);
  check("carrier_hz", resolved.carrier_hz, 0.5e6, 30e6);
  check("pulseCycles", resolved.pulseCycles, 0.5, 10.0);
  check("looks", resolved.looks, 1, 5);
  check("assumedSpeed_mPerS", resolved.assumedSpeed_mPerS, 500.0, 4000.0);
  check("noise_db", resolved.noise_db, -1000.0, 0.0);
  check("dynamicRange_db", resolved.dynamicRange_db, 20.0, 120.0);
  check("gain_db", resolved.gain_db, -100.0, 100.0);
  check("expected_dbPerCmMhz", resolved.expected_dbPerCmMhz, 0.0, 10.0);
  check("largestTgc_db", resolved.largestTgc_db, 0.0, 200.0);
  for (std::size_t n = 0; n < resolved.tgc.size(); ++n) {
    check("tgc.gain_db", resolved.tgc[n].gain_db, -200.0, 200.0);
    check("tgc.depth_mm", resolved.tgc[n].depth_mm, n == 0 ? 0.0 : std::nextafter(resolved.tgc[n - 1].depth_mm, 1e9), 1000.0);
  }
  if (problem) return passOn(*problem);
  if (resolved.tgc.empty()) {
    const double slope = resolved.attenuation ? 0.2 * resolved.expected_dbPerCmMhz * resolved.carrier_hz * 1e-6 : 0.0;  // dB/mm, both ways
    const double reach = slope > 0.0 ? std::min(resolved.largestTgc_db / slope, 1000.0) : 0.0;
    resolved.tgc.push_back({0.0, 0.0});
    if (reach > 0.0) resolved.tgc.push_back({reach, slope * reach});
  }

  const Beams beams = phantom::beamsOf(probe, resolved);
  const double pulse_mm = phantom::kFwhmOfSigma * beams.axialSigma_mm;
  const double samplesPerPulse = resolved.looks > 1 ? kSamplesPerLook : kSamplesPerPulse;
  BeamGrid grid = makeBeamGrid(probe, Knobs{}, resolved.depth_mm, pulse_mm / samplesPerPulse);

  // As few scatterers as the smallest resolution cell needs. The patient's pitch times powers of the root of two: probes of nearly the same
  // resolution see the same scatterers.
  double cell_mm3 = std::numeric_limits<double>::infinity();
  const double cube = phantom::kFwhmOfSigma * phantom::kFwhmOfSigma;
  for (int n = 0; n <= 64; ++n) {
    const double depth = resolved.depth_mm * n / 64.0;
    cell_mm3 = std::min(cell_mm3, pulse_mm * cube * beams.lateralSigma_mm(depth) * beams.elevationalSigma_mm(depth));
  }
  const double wanted_mm = std::cbrt(cell_mm3 / kScatterersPerResolutionCell);
  const double octave = std::clamp(std::floor(2.0 * std::log2(wanted_mm / patient->scattererPitch_mm)), -8.0, 2.0);
  const double pitch_mm = patient->scattererPitch_mm * std::exp2(0.5 * octave);
  return std::make_unique<Scanner>(std::move(patient), probe, resolved, std::move(grid), pitch_mm, seed);
}

void compressEnvelope(const Image<float>& envelope, double dynamicRange_db, Image<std::uint8_t>& levels) {
  EW_EXPECTS(dynamicRange_db > 0.0);
  levels.width = envelope.width;
  levels.height = envelope.height;
  levels.pixels.resize(envelope.pixels.size());
  const auto scale = static_cast<float>(255.0 * 20.0 / dynamicRange_db);
  for (std::size_t n = 0; n < envelope.pixels.size(); ++n) {
    const float amplitude = envelope.pixels[n];
    const float level = amplitude > 0.0F ? 255.0F + scale * std::log10(amplitude) : 0.0F;
    levels.pixels[n] = static_cast<std::uint8_t>(std::clamp(level, 0.0F, 255.0F) + 0.5F);
  }
}

}  // namespace ew
