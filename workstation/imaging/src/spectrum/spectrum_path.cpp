#include "spectrum/spectrum_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "colour/white_noise.h"
#include "echoes/echo_beams.h"
#include "ew/core/contract.h"
#include "ew/imaging/effects/contact.h"
#include "ew/imaging/effects/noise.h"
#include "flow/echo_powers.h"
#include "plan/planning.h"
#include "spectrum/gate_line.h"

namespace ew {

std::size_t bytesOf(const SpectrumMemory& memory) {
  const ImageView<const std::uint8_t> strip = memory.spectrogram.strip().image();
  const auto width = static_cast<std::size_t>(strip.width), height = static_cast<std::size_t>(strip.height);
  return sizeof(SpectrumMemory) + width * (height + static_cast<std::size_t>(memory.spectrogram.bins()) * sizeof(float)) +
         memory.volumes.size() * detail::SampleVolume::bytes();
}

}  // namespace ew

namespace ew::detail {
namespace {

constexpr double kLongestGap_s = 0.5;  // between frames: beyond, a spectrum begins anew
constexpr double kBlackAboveNoise_db = 5.0;
constexpr double kWayStep_mm = 0.5;
constexpr float kUnlost = 1e4F;  // from which losses are taken: far above what attenuate() calls faint
constexpr std::uint64_t kVolumeSeed = 0x5eedULL, kNoiseSeed = 0x4015eULL;
constexpr int kTissuePlaces = 5;  // along the volume and across it

}  // namespace

void SpectrumPath::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry) {
  EW_EXPECTS(knobs.spectral.has_value());
  if (!from_.changesTo(probe, knobs, scene, geometry)) return;
  knobs_ = gateKnobsOf(probe, knobs);
  probe_ = probe;
  scene_ = scene;
  const SpectralGate before = std::exchange(gate_, spectralGateOf(probe, knobs));
  Knobs atCarrier = knobs_;
  atCarrier.carrier_hz = gate_.carrier_hz;
  atCarrier.harmonic = false;
  const EchoBeams beams = echoBeamsOf(probe, atCarrier, scene, geometry.depth_mm);
  depths_mm_.assign(1, gate_.depth_mm);
  depths_mm_.insert(depths_mm_.end(), gate_.alsoAt_mm.begin(), gate_.alsoAt_mm.end());
  sizes_.clear();
  for (const double depth_mm : depths_mm_)
    sizes_.push_back({.lateralSigma_mm = beams.lateralSigma_mm(depth_mm),
                      .elevationalSigma_mm = beams.elevationalSigma_mm(depth_mm),
                      .pulseSigma_mm = 0.5 * kDopplerCycles * beams.wavelength_mm / kFwhmOfSigma,
                      .length_mm = gate_.length_mm,
                      .wavelength_mm = beams.wavelength_mm,
                      .prf_hz = gate_.prf_hz,
                      .broadens = knobs.spectral->broadens});
  const double noise = powerOf(noiseLevel_db(scene.noise.value_or(NoiseEffect{}), gate_.carrier_hz, gate_.depth_mm) - kNarrowBand_db);
  noise_ = scene.noise ? noise : 0.0;
  step_mm_ = std::min(kWayStep_mm, 0.25 * gate_.depth_mm);
  if (scene.attenuation) losses_ = makeTissueLosses(scene, gate_.carrier_hz, step_mm_);
  if (before.prf_hz != gate_.prf_hz || before.carrier_hz != gate_.carrier_hz) memory_.runs = false;
  memory_.wallFilter.configure(knobs.spectral->wallFilter_hz, gate_.prf_hz);
  memory_.spectrogram.configure({.prf_hz = gate_.prf_hz,
                                 .baseline = knobs.spectral->baseline,
                                 .invert = knobs.spectral->invert,
                                 .black = noise * powerOf(kBlackAboveNoise_db - knobs.spectral->gain_db),
                                 .dynamicRange_db = knobs.spectral->dynamicRange_db},
                                geometry.width, geometry.height, knobs.mSweep_s);
}

void SpectrumPath::clear() {
  memory_.spectrogram.clear();
  memory_.volumes.clear();
  memory_.runs = false;
  samples_.clear();
}

void SpectrumPath::recall(const SpectrumMemory& memory) {
  const ImageView<const std::uint8_t> mine = memory_.spectrogram.strip().image(), theirs = memory.spectrogram.strip().image();
  if (mine.width == theirs.width && mine.height == theirs.height) memory_ = memory;
}

SpectrumPath::Way SpectrumPath::wayTo(const FrameInput& input, double depth_mm, const RelativeMotion::At& seen) {
  Way way;
  const glm::dvec3 along(gate_.direction, 0.0), across(gate_.direction.y, -gate_.direction.x, 0.0), face_mm(gate_.face_mm, 0.0);
  double left = 1.0;
  if (scene_.contact && input.gaps_mm.size() >= 2) {
    touch_.resize(static_cast<std::size_t>(probe_.lines));
    contactOfLines(*scene_.contact, input.gaps_mm, faceLength_mm(probe_), probe_.aperture_mm, touch_);
    const auto line = static_cast<std::size_t>(std::lround(0.5 * (knobs_.spectral->line + 1.0) * (probe_.lines - 1)));
    const auto touch = static_cast<double>(touch_[std::min(line, touch_.size() - 1)]);
    left = touch * touch * touch * touch;
  }
  if (scene_.attenuation && !input.labels.empty()) {
    const int steps = static_cast<int>(std::ceil(depth_mm / step_mm_)) + 1;
    labels_ = GreyImage(1, steps);
    lost_ = BeamImage(1, steps, kUnlost);
    const glm::dmat4 probeToLabel = (input.labels.grid.worldToVoxel() * input.pose.probeToWorld).matrix;
    for (int step = 0; step < steps; ++step) {
      const glm::dvec3 now_mm = face_mm + step * step_mm_ * along;
      const glm::dvec3 rest_mm = now_mm + glm::dvec3(motion_.at(now_mm, seen.back_mm).back_mm);
      labels_.pixels[static_cast<std::size_t>(step)] = nearestVoxel(input.labels, glm::vec3(probeToLabel * glm::dvec4(rest_mm, 1.0)));
    }
    attenuate(*scene_.attenuation, losses_, viewOf(std::as_const(labels_)), 1.0, gate_.carrier_hz, step_mm_, viewOf(lost_), scratch_);
    left *= powerOf(static_cast<double>(lost_.pixels.back() - kUnlost));
  }
  way.blood = bloodPower(gate_.carrier_hz) * left;
  const glm::dmat4 probeToLevel = (input.tissueGrid.worldToVoxel() * input.pose.probeToWorld).matrix;
  const SliceSource level(VolumeView<const std::uint8_t>{input.tissue->level.data(), input.tissueGrid});
  const auto share = [](int place) { return 2.0 * place / (kTissuePlaces - 1.0) - 1.0; };
  double sum = 0.0;
  for (int n = 0; n < kTissuePlaces; ++n)
    for (int aside = 0; aside < kTissuePlaces; ++aside) {
      const glm::dvec3 at_mm = face_mm + (depth_mm + 0.5 * share(n) * gate_.length_mm) * along +
                               share(aside) * sizes_.front().lateralSigma_mm * across + glm::dvec3(seen.back_mm);
      sum += static_cast<double>(tissuePowers()[nearestVoxel(level, glm::vec3(probeToLevel * glm::dvec4(at_mm, 1.0)))]);
    }
  way.tissue = left * sum / (kTissuePlaces * kTissuePlaces);
  return way;
}

void SpectrumPath::addVolume(std::size_t n, const FrameInput& input, const Transform<frame::Probe, frame::World>& ownToProbe,
                             double first_s) {
  const glm::dvec3 along(gate_.direction, 0.0), across(gate_.direction.y, -gate_.direction.x, 0.0);
  const glm::dmat4 probeToOwn = inverse(ownToProbe).matrix;
  const glm::dmat3 turn(ownToProbe.matrix);
  SampleVolume& volume = memory_.volumes[n];
  volume.configure(sizes_[n], kVolumeSeed + n);
  const glm::dvec3 middle_mm = glm::dvec3(gate_.face_mm, 0.0) + depths_mm_[n] * along;
  const RelativeMotion::At seen = motion_.at(middle_mm);
  const Way way = wayTo(input, depths_mm_[n], seen);
  const glm::dvec3 rest_mm = middle_mm + glm::dvec3(seen.back_mm), tissue_mmPerS(seen.velocity_mmPerS);
  std::size_t prepared = samples_.size();
  const auto flow = [&](std::size_t sample, const glm::dvec3& at_mm) {
    if (sample != prepared) input.flow->prepare(first_s + static_cast<double>(sample) / gate_.prf_hz, moment_);
    prepared = sample;
    const glm::dvec3 place_mm = rest_mm + at_mm.x * across + at_mm.y * along + glm::dvec3(0.0, 0.0, at_mm.z);
    const BloodVelocity blood = input.flow->at(moment_, glm::dvec3(probeToOwn * glm::dvec4(place_mm, 1.0)));
    const glm::dvec3 velocity = turn * blood.mean_mmPerS + tissue_mmPerS;
    return MovingBlood{blood.stream >= 0, {glm::dot(velocity, across), glm::dot(velocity, along), velocity.z}, blood.turbulence_mmPerS};
  };
  volume_.assign(samples_.size(), {});
  volume.add(flow, volume_);
  const auto amplitude = static_cast<float>(std::sqrt(way.blood));
  for (std::size_t k = 0; k < samples_.size(); ++k) samples_[k] += amplitude * volume_[k];
  if (n > 0) return;
  // Tissue goes as one: its phase says how far it is.
  const std::complex<double> step =
      std::polar(1.0, -4.0 * std::numbers::pi * glm::dot(tissue_mmPerS, along) / (sizes_[0].wavelength_mm * gate_.prf_hz));
  const double strength = std::sqrt(way.tissue);
  for (std::complex<float>& sample : samples_) {
    sample += std::complex<float>(strength * memory_.tissue);
    memory_.tissue *= step;
  }
  memory_.tissue /= std::abs(memory_.tissue);
}

void SpectrumPath::addNoise() {
  if (!(noise_ > 0.0)) return;
  const auto amplitude = static_cast<float>(std::sqrt(noise_));
  // Of each pulse its own, however many come with one frame.
  for (std::size_t k = 0; k < samples_.size(); ++k)
    addWhite(NormalTable::shared(), spreadBits(kNoiseSeed + static_cast<std::uint64_t>(memory_.samples) + k), amplitude,
             std::span(samples_).subspan(k, 1));
}

void SpectrumPath::run(const FrameInput& input, const EchoMotion* motion, const FrameBefore& before) {
  EW_EXPECTS(input.flow != nullptr && input.tissue != nullptr);
  SpectrumMemory& m = memory_;
  samples_.clear();
  const double next_s = m.start_s + static_cast<double>(m.samples) / gate_.prf_hz;
  if (!m.runs || input.time_s < next_s - 2.0 / gate_.prf_hz || input.time_s > next_s + kLongestGap_s) {
    m.runs = true;
    m.start_s = input.time_s;
    m.samples = 0;
    m.wallFilter.clear();
  }
  const auto due = static_cast<std::int64_t>(std::floor((input.time_s - m.start_s) * gate_.prf_hz + 1e-6)) + 1 - m.samples;
  if (due <= 0) return;
  samples_.assign(static_cast<std::size_t>(due), {});
  const double first_s = m.start_s + static_cast<double>(m.samples) / gate_.prf_hz;
  const Transform<frame::Probe, frame::World> ownToProbe =
      inverse(input.pose.probeToWorld) * (input.tissueGrid.voxelToWorld() * input.tissue->grid.worldToVoxel());
  motion_.take(input, scene_, motion, before, ownToProbe);
  m.volumes.resize(depths_mm_.size());
  for (std::size_t n = 0; n < depths_mm_.size(); ++n) addVolume(n, input, ownToProbe, first_s);
  addNoise();
  for (std::complex<float>& sample : samples_) sample = m.wallFilter.next(sample);
  m.samples += due;
  m.spectrogram.add(samples_, first_s);
}

}  // namespace ew::detail
