#include "colour/colour_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "colour/white_noise.h"
#include "display/conversion_table.h"
#include "effects/spread_bits.h"
#include "ew/core/contract.h"
#include "ew/imaging/effects/contact.h"
#include "ew/imaging/effects/noise.h"
#include "flow/echo_powers.h"
#include "plan/planning.h"
#include "probes/sound.h"

namespace ew::detail {
namespace {

constexpr double kAboveNoise_db = 5.0;   // from here on colour is shown, without gain
constexpr double kPowerRange_db = 30.0;  // that maps of power span
constexpr double kGatesOfPulse = 0.75;   // between gates, of a pulse
constexpr int kMostGates = 240;          // along a line of the box
constexpr float kUnseen = 0.03F;         // of the noise, or of what is just shown: less is left out
constexpr double kSeenNoise = 0.35;      // of what is just shown: less is nowhere seen alone
constexpr double kOutOfTwo = 1.4142135623730951;
constexpr int kLinesOfNode = 4;
constexpr double kNode_mm = 4.0;
constexpr float kFullPower = 1e4F;  // from which losses are taken: far above what attenuate() calls faint
constexpr int kVelocities = 256, kSpreads = 16;
constexpr float kOpaqueFrom = 1.4F;  // of the power that is just shown

enum class Draw : std::uint64_t { blood = 1, tissue = 2, noise = 3 };
std::uint64_t keyOf(std::uint64_t number, Draw draw) { return spreadBits(spreadBits(number) + static_cast<std::uint64_t>(draw)); }
std::uint64_t keyAt(std::uint64_t key, int line, int gate) {
  return spreadBits(key ^ (static_cast<std::uint64_t>(line + 1) << 32U | static_cast<std::uint64_t>(gate + 1)));
}

/// Weight of a neighbour's draw for numbers that correlate by `rho` with their neighbours', of the own's: w / 1 + 2 w^2 = rho / 2.
float neighbourWeight(double rho) {
  const double bounded = std::min(rho, 0.6);  // beyond, three draws would not do
  if (bounded < 0.02) return 0.0F;
  return static_cast<float>((1.0 - std::sqrt(1.0 - 2.0 * bounded * bounded)) / (2.0 * bounded));
}

Rgba solid(const Rgb& colour) { return {colour, 255}; }

}  // namespace

void ColourPath::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry) {
  EW_EXPECTS(knobs.colour.has_value());
  if (!from_.changesTo(probe, knobs, scene, geometry)) return;
  colour_ = *knobs.colour;
  knobs_ = colourKnobsOf(probe, knobs);
  scene_ = scene;
  probe_ = colourProbeOf(probe, colour_);
  box_ = colourBoxOf(probe, knobs);
  wavelength_mm_ = kSpeedOfSound_mmPerS / box_.carrier_hz;
  const double pulse_mm = 0.5 * kDopplerCycles * wavelength_mm_;
  axialSigma_mm_ = pulse_mm / kFwhmOfSigma;
  const double spacing_mm = std::max(kGatesOfPulse * pulse_mm, (box_.bottom_mm - box_.top_mm) / kMostGates);
  grid_ = makeBeamGrid(probe_, knobs_, box_.bottom_mm, std::min(spacing_mm, 0.5 * box_.bottom_mm));
  const int lastLine = static_cast<int>(grid_.lines.size()) - 1;
  const auto lineAt = [&](double across) { return 0.5 * (across + 1.0) * lastLine; };
  region_.firstLine = std::clamp(static_cast<int>(std::floor(lineAt(box_.left))), 0, lastLine - 1);
  region_.lastLine = std::clamp(static_cast<int>(std::ceil(lineAt(box_.right))), region_.firstLine + 1, lastLine);
  region_.firstGate = std::clamp(static_cast<int>(std::floor(box_.top_mm / grid_.sampleSpacing_mm)), 0, grid_.samples - 2);
  region_.lastGate = grid_.samples - 1;

  if (packet_ != box_.packet) source_.emplace(box_.packet);
  packet_ = box_.packet;
  filter_.emplace(box_.packet, box_.filterOrder);
  filterResponse_.resize(kVelocities + 1);
  for (int n = 0; n <= kVelocities; ++n)
    filterResponse_[static_cast<std::size_t>(n)] = static_cast<float>(filter_->response(static_cast<double>(n) / kVelocities));

  Knobs atCarrier = knobs_;
  atCarrier.carrier_hz = box_.carrier_hz;
  atCarrier.harmonic = false;
  const EchoBeams beams = echoBeamsOf(probe, atCarrier, scene, geometry.depth_mm);
  const NoiseEffect noise = scene.noise.value_or(NoiseEffect{});
  const double above_db = kAboveNoise_db - colour_.gain_db;
  noiseOfShown_ = scene.noise ? powerOf(-above_db) : 0.0;
  shown_.clear();
  noise_.clear();
  cells_.clear();
  for (int gate = 0; gate < grid_.samples; ++gate) {
    const double depth_mm = grid_.depth_mm(gate);
    const double power = powerOf(noiseLevel_db(noise, box_.carrier_hz, depth_mm) - kNarrowBand_db);
    shown_.push_back(static_cast<float>(power * filter_->noiseShare() * powerOf(above_db)));
    noise_.push_back(scene.noise ? static_cast<float>(power) : 0.0F);
    const double lateral_mm = beams.lateralSigma_mm(depth_mm), apart_mm = grid_.lineSpacing_mm(depth_mm);
    cells_.push_back({static_cast<float>(lateral_mm), static_cast<float>(beams.elevationalSigma_mm(depth_mm)),
                      neighbourWeight(std::exp(-apart_mm * apart_mm / (4.0 * lateral_mm * lateral_mm)))});
  }
  const double apart_mm = grid_.sampleSpacing_mm;
  acrossGates_ = neighbourWeight(std::exp(-apart_mm * apart_mm / (4.0 * axialSigma_mm_ * axialSigma_mm_)));
  blood_ = bloodPower(box_.carrier_hz);
  if (scene.attenuation) losses_ = makeTissueLosses(scene, box_.carrier_hz, grid_.sampleSpacing_mm);

  if (pixelsFrom_.changesTo(probe, knobs_.steering_rad, knobs.steering_rad, knobs.trapezoid, grid_, geometry,
                            glm::dvec4(box_.left, box_.right, box_.top_mm, box_.bottom_mm)))
    layPixels(probe, knobs, geometry);
  layColours();
}

void ColourPath::layPixels(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry) {
  // Pixels of the image's fan that lie in the box, looked for in the rectangle around it.
  const glm::dmat4 toImage = inverse(geometry.imageToProbe()).matrix;
  glm::dvec2 low(1e300), high(-1e300);
  for (const glm::dvec2& at_mm : colourBoxOutline_mm(probe, knobs)) {
    const glm::dvec2 at_px(toImage * glm::dvec4(at_mm, 0.0, 1.0));
    low = glm::min(low, at_px);
    high = glm::max(high, at_px);
  }
  const int firstRow = std::max(0, static_cast<int>(std::floor(low.y)) - 1);
  const int lastRow = std::min(geometry.height - 1, static_cast<int>(std::ceil(high.y)) + 1);
  const int firstColumn = static_cast<int>(std::floor(std::max(low.x, 0.0))) - 1;
  const int endColumn = static_cast<int>(std::ceil(std::min(high.x, static_cast<double>(geometry.width)))) + 2;
  const FanShape fan = fanShapeOf(probe, knobs_);
  Spans within(static_cast<std::size_t>(geometry.height));
  const Spans inFan = fanSpans(probe, knobs, geometry);
  for (int y = firstRow; y <= lastRow; ++y) {
    auto& row = within[static_cast<std::size_t>(y)];
    for (const RowSpan& span : inFan[static_cast<std::size_t>(y)])
      for (int x = std::max(span.begin, firstColumn); x < std::min(span.end, endColumn); ++x) {
        const FanShape::Place place = fan.placeOf(geometry.probePoint_mm(x, y));
        if (place.across < box_.left || place.across > box_.right || place.depth_mm < box_.top_mm || place.depth_mm > box_.bottom_mm)
          continue;
        if (row.empty() || row.back().end != x) row.push_back({x, x});
        ++row.back().end;
      }
  }
  conversion_ = conversionOf(fan, std::move(within), grid_, geometry);
  image_ = Image<Rgba>(geometry.width, geometry.height, Rgba(0));
}

void ColourPath::layColours() {
  const bool hasSpread = colour_.shows == ColourShows::variance;
  colours_.clear();
  for (int spread = 0; spread < (hasSpread ? kSpreads : 1); ++spread)
    for (int n = 0; n < kVelocities; ++n) {
      // Middles of equal parts of -1..1 Nyquist velocities.
      double velocity = (2.0 * n + 1.0) / kVelocities - 1.0, value = velocity;
      if (colour_.shows == ColourShows::velocity || hasSpread) {
        const double low = -1.0 + colour_.baseline, high = 1.0 + colour_.baseline;
        if (velocity < low) velocity += 2.0;
        if (velocity > high) velocity -= 2.0;
        value = velocity >= 0.0 ? velocity / high : -velocity / low;
      }
      const bool isSlow = std::abs(velocity) < colour_.reject && colour_.shows != ColourShows::power;
      colours_.push_back(isSlow ? Rgba(0) : solid(colourOf(colour_, value, static_cast<double>(spread) / (kSpreads - 1))));
    }
}

void ColourPath::findMotion() {
  if (!motion_.moves()) return;
  const int lines = region_.lastLine - region_.firstLine;
  columns_ = std::max(2, (lines + kLinesOfNode - 1) / kLinesOfNode + 1);
  rows_ = std::max(2, static_cast<int>(std::ceil(box_.bottom_mm / kNode_mm)) + 1);
  nodes_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int column = 0; column < columns_; ++column) {
    const auto line =
        static_cast<std::size_t>(region_.firstLine + static_cast<int>(std::lround(static_cast<double>(column) * lines / (columns_ - 1))));
    glm::vec3 back(0.0F);
    for (int row = 0; row < rows_; ++row) {
      const BeamGrid::Line& way = grid_.lines[line];
      const glm::dvec3 now_mm(way.origin_mm + static_cast<double>(row) * box_.bottom_mm / (rows_ - 1) * way.direction, 0.0);
      const RelativeMotion::At seen = motion_.at(now_mm, back);
      back = seen.back_mm;
      nodes_[static_cast<std::size_t>(row * columns_ + column)] = seen;
    }
  }
}

RelativeMotion::At ColourPath::motionAt(int line, double depth_mm) const {
  if (!motion_.moves()) return {};
  const double across = static_cast<double>(line - region_.firstLine) / (region_.lastLine - region_.firstLine) * (columns_ - 1);
  const double down = depth_mm / box_.bottom_mm * (rows_ - 1);
  const int column = std::clamp(static_cast<int>(across), 0, columns_ - 2), row = std::clamp(static_cast<int>(down), 0, rows_ - 2);
  const auto tx = static_cast<float>(across - column), ty = static_cast<float>(down - row);
  const RelativeMotion::At* at = nodes_.data() + static_cast<std::ptrdiff_t>(row) * columns_ + column;
  const auto between = [&](glm::vec3 RelativeMotion::At::*what) {
    return glm::mix(glm::mix(at[0].*what, at[1].*what, tx), glm::mix(at[columns_].*what, at[columns_ + 1].*what, tx), ty);
  };
  return {between(&RelativeMotion::At::back_mm), between(&RelativeMotion::At::velocity_mmPerS)};
}

void ColourPath::findLosses(const FrameInput& input, Bands& bands) {
  const int lines = static_cast<int>(grid_.lines.size());
  touch_.assign(grid_.lines.size(), 1.0F);
  if (scene_.contact && input.gaps_mm.size() >= 2)
    contactOfLines(*scene_.contact, input.gaps_mm, faceLength_mm(probe_), probe_.aperture_mm, touch_);
  if (lost_.width != lines || lost_.height != grid_.samples) {
    lost_ = BeamImage(lines, grid_.samples);
    labels_ = GreyImage(lines, grid_.samples);
  }
  std::fill(lost_.pixels.begin(), lost_.pixels.end(), kFullPower);
  if (!scene_.attenuation || input.labels.empty()) return;
  const glm::mat4 probeToLabel((input.labels.grid.worldToVoxel() * input.pose.probeToWorld).matrix);
  bands.run(region_.lastLine - region_.firstLine + 1, [&](int first, int count, int slot) {
    for (int n = first; n < first + count; ++n) {
      const int line = region_.firstLine + n;
      const BeamGrid::Line& way = grid_.lines[static_cast<std::size_t>(line)];
      for (int gate = 0; gate < grid_.samples; ++gate) {
        const double depth_mm = grid_.depth_mm(gate);
        const glm::vec3 now_mm(glm::vec2(way.origin_mm + depth_mm * way.direction), 0.0F);
        labels_.pixels[indexOf(line, gate)] =
            nearestVoxel(input.labels, glm::vec3(probeToLabel * glm::vec4(now_mm + motionAt(line, depth_mm).back_mm, 1.0F)));
      }
    }
    const int line = region_.firstLine + first;
    attenuate(*scene_.attenuation, losses_, {labels_.pixels.data() + line, count, labels_.height, labels_.width}, 1.0, box_.carrier_hz,
              grid_.sampleSpacing_mm, {lost_.pixels.data() + line, count, lost_.height, lost_.width},
              scratch_[static_cast<std::size_t>(slot)].attenuation);
  });
}

GateEchoes ColourPath::echoesAt(const FrameInput& input, const glm::dmat4& probeToOwn, const glm::dmat4& probeToLevel, int line,
                                int gate) const {
  const std::array<float, 256>& powers = tissuePowers();
  // Six places a standard deviation of power times 2 off, which weigh an eighth each, and the middle: means and variances are exact.
  constexpr float kOff = 2.0F;
  struct Point {
    glm::vec3 off;
    float weight;
  };
  constexpr std::array<Point, 7> kPoints{{{{0, 0, 0}, 0.25F},
                                          {{kOff, 0, 0}, 0.125F},
                                          {{-kOff, 0, 0}, 0.125F},
                                          {{0, kOff, 0}, 0.125F},
                                          {{0, -kOff, 0}, 0.125F},
                                          {{0, 0, kOff}, 0.125F},
                                          {{0, 0, -kOff}, 0.125F}}};
  const BeamGrid::Line& way = grid_.lines[static_cast<std::size_t>(line)];
  const Cell& cell = cells_[static_cast<std::size_t>(gate)];
  const double depth_mm = grid_.depth_mm(gate);
  const RelativeMotion::At motion = motionAt(line, depth_mm);
  const glm::dvec3 along(way.direction, 0.0), across(way.direction.y, -way.direction.x, 0.0);
  const glm::dvec3 middle_mm(way.origin_mm + depth_mm * way.direction, 0.0);
  const auto sigma = [](double amplitude_mm) { return amplitude_mm / kOutOfTwo; };
  const glm::dvec3 axes[] = {sigma(cell.lateralSigma_mm) * across, sigma(axialSigma_mm_) * along,
                             glm::dvec3(0.0, 0.0, sigma(cell.elevationalSigma_mm))};
  const SliceSource level(VolumeView<const std::uint8_t>{input.tissue->level.data(), input.tissueGrid});
  const glm::dmat3 ownToProbe = glm::transpose(glm::dmat3(probeToOwn));

  double inBlood = 0.0, tissue = 0.0, mean = 0.0, square = 0.0, broadening = 0.0;
  const double transit = wavelength_mm_ / (4.0 * std::numbers::pi * kOutOfTwo);
  const auto broadened = [&](const glm::dvec3& velocity_mmPerS) {
    const double a = glm::dot(velocity_mmPerS, across) / static_cast<double>(cell.lateralSigma_mm),
                 b = velocity_mmPerS.z / static_cast<double>(cell.elevationalSigma_mm),
                 c = glm::dot(velocity_mmPerS, along) / axialSigma_mm_;
    return transit * transit * (a * a + b * b + c * c);
  };
  for (const Point& point : kPoints) {
    const glm::dvec3 rest_mm = middle_mm + glm::dvec3(motion.back_mm) + static_cast<double>(point.off.x) * axes[0] +
                               static_cast<double>(point.off.y) * axes[1] + static_cast<double>(point.off.z) * axes[2];
    const auto weight = static_cast<double>(point.weight);
    tissue += weight * static_cast<double>(powers[nearestVoxel(level, glm::vec3(probeToLevel * glm::dvec4(rest_mm, 1.0)))]);
    const BloodVelocity blood = input.flow->at(moment_, glm::dvec3(probeToOwn * glm::dvec4(rest_mm, 1.0)));
    if (blood.stream < 0) continue;
    const glm::dvec3 velocity = ownToProbe * blood.mean_mmPerS + glm::dvec3(motion.velocity_mmPerS);
    const double towards = -glm::dot(velocity, along);
    inBlood += weight;
    mean += weight * towards;
    square += weight * towards * towards;
    broadening += weight * (blood.turbulence_mmPerS * blood.turbulence_mmPerS + broadened(velocity));
  }
  const float touch = touch_[static_cast<std::size_t>(line)];
  const double left = powerOf(static_cast<double>(lost_.pixels[indexOf(line, gate)] - kFullPower)) * static_cast<double>(touch * touch) *
                      static_cast<double>(touch * touch);
  const double perNyquist = 1.0 / box_.nyquist_mmPerS;
  GateEchoes echoes;
  echoes.noise = noise_[static_cast<std::size_t>(gate)];
  if (inBlood > 0.0) {
    mean /= inBlood;
    echoes.blood = static_cast<float>(inBlood * blood_ * left);
    echoes.bloodVelocity = static_cast<float>(mean * perNyquist);
    echoes.bloodSpread = static_cast<float>(std::sqrt(std::max(0.0, square / inBlood - mean * mean) + broadening / inBlood) * perNyquist);
  }
  echoes.tissue = static_cast<float>(tissue * left);
  const glm::dvec3 velocity(motion.velocity_mmPerS);
  echoes.tissueVelocity = static_cast<float>(-glm::dot(velocity, along) * perNyquist);
  echoes.tissueSpread = static_cast<float>(std::sqrt(broadened(velocity)) * perNyquist);
  return echoes;
}

void ColourPath::findEchoes(const FrameInput& input, const glm::dmat4& probeToOwn, Bands& bands) {
  const glm::dmat4 probeToLevel = (input.tissueGrid.worldToVoxel() * input.pose.probeToWorld).matrix;
  echoes_.resize(grid_.lines.size() * static_cast<std::size_t>(grid_.samples));
  bands.run(region_.lastLine - region_.firstLine + 1, [&](int first, int count, int) {
    for (int line = region_.firstLine + first; line < region_.firstLine + first + count; ++line)
      for (int gate = region_.firstGate; gate <= region_.lastGate; ++gate)
        echoes_[indexOf(line, gate)] = echoesAt(input, probeToOwn, probeToLevel, line, gate);
  });
}

void ColourPath::addSpeckle(std::uint64_t key, int line, int gate, std::span<std::complex<float>> white) const {
  const float across = cells_[static_cast<std::size_t>(gate)].acrossLines, along = acrossGates_;
  const float scale = 1.0F / std::sqrt((1.0F + 2.0F * across * across) * (1.0F + 2.0F * along * along));
  const NormalTable& normals = NormalTable::shared();
  std::fill(white.begin(), white.end(), std::complex<float>(0.0F));
  for (int aside = -1; aside <= 1; ++aside)
    for (int deeper = -1; deeper <= 1; ++deeper) {
      const float weight = scale * (aside == 0 ? 1.0F : across) * (deeper == 0 ? 1.0F : along);
      if (weight > 0.0F) addWhite(normals, keyAt(key, line + aside, gate + deeper), weight, white);
    }
}

void ColourPath::addPackets(std::uint64_t number, Bands& bands) {
  const auto size = static_cast<std::size_t>(packet_);
  sums_.resize(3 * echoes_.size());
  bands.run(region_.lastLine - region_.firstLine + 1, [&](int first, int count, int slot) {
    Scratch& mine = scratch_[static_cast<std::size_t>(slot)];
    mine.white.resize(size);
    mine.packet.resize(size);
    mine.sum.resize(size);
    const std::span<std::complex<float>> white(mine.white), packet(mine.packet), sum(mine.sum);
    for (int line = region_.firstLine + first; line < region_.firstLine + first + count; ++line)
      for (int gate = region_.firstGate; gate <= region_.lastGate; ++gate) {
        const GateEchoes& echoes = echoes_[indexOf(line, gate)];
        float* out = sums_.data() + 3 * indexOf(line, gate);
        const float shown = shown_[static_cast<std::size_t>(gate)];
        // What the filter leaves of tissue: of its own velocity, or of the fastest part of its spread.
        const float fastest = std::min(std::abs(echoes.tissueVelocity) + 3.0F * echoes.tissueSpread, 1.0F);
        const float left = echoes.tissue * filterResponse_[static_cast<std::size_t>(std::ceil(fastest * kVelocities))];
        const bool hasTissue = left > kUnseen * shown, hasBlood = echoes.blood > kUnseen * shown;
        const bool hasNoise = echoes.noise > kUnseen * shown && (hasTissue || hasBlood || noiseOfShown_ > kSeenNoise);
        out[0] = out[1] = out[2] = 0.0F;
        if (!hasTissue && !hasBlood && !hasNoise) continue;
        std::fill(sum.begin(), sum.end(), std::complex<float>(0.0F));
        const auto add = [&](Draw draw, float power, float velocity, float spread) {
          addSpeckle(keyOf(number, draw), line, gate, white);
          source_->make(static_cast<double>(velocity), static_cast<double>(spread), white, packet);
          const float amplitude = std::sqrt(power);
          for (std::size_t n = 0; n < size; ++n) sum[n] += amplitude * packet[n];
        };
        if (hasBlood) add(Draw::blood, echoes.blood, echoes.bloodVelocity, echoes.bloodSpread);
        if (hasTissue) add(Draw::tissue, echoes.tissue, echoes.tissueVelocity, echoes.tissueSpread);
        if (hasNoise) addWhite(NormalTable::shared(), keyAt(keyOf(number, Draw::noise), line, gate), std::sqrt(echoes.noise), sum);
        filter_->apply(sum);
        const PacketSums sums = sumsOf(sum);
        const auto per = static_cast<double>(1.0F / shown);
        out[0] = static_cast<float>(sums.r0 * per);
        out[1] = static_cast<float>(sums.r1.real() * per);
        out[2] = static_cast<float>(sums.r1.imag() * per);
      }
  });
}

void ColourPath::average(ColourMemory& memory, Bands& bands) {
  averaged_.resize(sums_.size());
  const bool goesOn = memory.sums.size() == sums_.size() && memory.lines == static_cast<int>(grid_.lines.size()) &&
                      memory.gates == grid_.samples && colour_.persistence > 0.0;
  if (!goesOn) memory.sums.assign(sums_.size(), 0.0F);
  memory.lines = static_cast<int>(grid_.lines.size());
  memory.gates = grid_.samples;
  const float keeps = goesOn ? static_cast<float>(colour_.persistence) : 0.0F;
  const int reach = colour_.smoothing;
  // Binomial weights, along lines and then across them; beyond the box as at its edge.
  std::array<float, 7> weights{};
  float sumOfWeights = 0.0F;
  for (int n = -reach; n <= reach; ++n) {
    double weight = 1.0;
    for (int k = 1; k <= reach + n; ++k) weight *= static_cast<double>(2 * reach - k + 1) / k;
    weights[static_cast<std::size_t>(n + reach)] = static_cast<float>(weight);
    sumOfWeights += static_cast<float>(weight);
  }
  for (float& weight : weights) weight /= sumOfWeights;
  const auto pass = [&](const std::vector<float>& from, std::vector<float>& to, bool isAlong, float share) {
    bands.run(region_.lastLine - region_.firstLine + 1, [&](int first, int count, int) {
      for (int line = region_.firstLine + first; line < region_.firstLine + first + count; ++line)
        for (int gate = region_.firstGate; gate <= region_.lastGate; ++gate) {
          float sum[3] = {0.0F, 0.0F, 0.0F};
          for (int n = -reach; n <= reach; ++n) {
            const int fromLine = isAlong ? line : std::clamp(line + n, region_.firstLine, region_.lastLine);
            const int fromGate = isAlong ? std::clamp(gate + n, region_.firstGate, region_.lastGate) : gate;
            const float* at = from.data() + 3 * indexOf(fromLine, fromGate);
            const float weight = weights[static_cast<std::size_t>(n + reach)];
            for (int k = 0; k < 3; ++k) sum[k] += weight * at[k];
          }
          float* out = to.data() + 3 * indexOf(line, gate);
          for (int k = 0; k < 3; ++k) out[k] = share == 0.0F ? sum[k] : sum[k] + share * (out[k] - sum[k]);
        }
    });
  };
  pass(sums_, averaged_, true, 0.0F);
  pass(averaged_, memory.sums, false, keeps);
}

void ColourPath::form(const FrameInput& input, const EchoMotion* motion, const FrameBefore& before, ColourMemory& memory, Bands& bands) {
  EW_EXPECTS(input.flow != nullptr && input.tissue != nullptr);
  scratch_.resize(static_cast<std::size_t>(bands.threads()));
  const Transform<frame::World, frame::World> ownToWorld = input.tissueGrid.voxelToWorld() * input.tissue->grid.worldToVoxel();
  const Transform<frame::Probe, frame::World> ownToProbe = inverse(input.pose.probeToWorld) * ownToWorld;
  input.flow->prepare(input.time_s, moment_);
  motion_.take(input, scene_, motion, before, ownToProbe);
  findMotion();
  findLosses(input, bands);
  findEchoes(input, inverse(ownToProbe).matrix, bands);
  addPackets(input.number, bands);
  average(memory, bands);
}

void ColourPath::draw(ImageView<const std::uint8_t> grey, const ColourMemory& memory, Bands& bands) {
  EW_EXPECTS(grey.width == conversion_.width && grey.height == conversion_.height && image_.width == grey.width);
  constexpr float kPerWeight = 1.0F / 32768.0F;
  const auto brightest = static_cast<float>(255.0 * colour_.priority);
  const bool hasSpread = colour_.shows == ColourShows::variance;
  const bool isPower = colour_.shows == ColourShows::power || colour_.shows == ColourShows::directionalPower;
  const auto colourOfSums = [&](float r0, float real, float imaginary) {
    const PacketSums sums{static_cast<double>(r0), {static_cast<double>(real), static_cast<double>(imaginary)}};
    double value = meanVelocity(sums);
    if (isPower) {
      const double strength = std::clamp(10.0 * std::log10(static_cast<double>(r0)) / kPowerRange_db, 0.0, 1.0);
      value = colour_.shows == ColourShows::power || value >= 0.0 ? strength : -strength;
    }
    auto index = std::clamp(static_cast<int>((value + 1.0) * 0.5 * kVelocities), 0, kVelocities - 1);
    if (hasSpread)
      index +=
          kVelocities * std::clamp(static_cast<int>(std::lround(velocitySpread(sums, noiseOfShown_) * (kSpreads - 1))), 0, kSpreads - 1);
    Rgba colour = colours_[static_cast<std::size_t>(index)];
    if (r0 < kOpaqueFrom) colour.a = static_cast<std::uint8_t>(static_cast<float>(colour.a) * (r0 - 1.0F) / (kOpaqueFrom - 1.0F));
    return colour;
  };
  bands.run(grey.height, [&](int firstRow, int rows, int) {
    for (int y = firstRow; y < firstRow + rows; ++y) {
      const ScanConversionTable::Tap* tap = conversion_.taps.data() + conversion_.firstTapOfRow[static_cast<std::size_t>(y)];
      Rgba* out = viewOf(image_).row(y);
      for (const RowSpan& span : conversion_.spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x, ++tap) {
          out[x] = Rgba(0);
          if (static_cast<float>(grey.at(x, y)) > brightest) continue;
          const float* near = memory.sums.data() + std::size_t{3} * tap->first;
          const float* far = near + 3 * grid_.lines.size();
          const float right = static_cast<float>(tap->lineWeight) * kPerWeight, down = static_cast<float>(tap->sampleWeight) * kPerWeight;
          const auto at = [&](int k) {
            const float above = near[k] + right * (near[k + 3] - near[k]);
            return above + down * (far[k] + right * (far[k + 3] - far[k]) - above);
          };
          const float r0 = at(0);
          if (r0 > 1.0F) out[x] = colourOfSums(r0, at(1), at(2));
        }
    }
  });
}

}  // namespace ew::detail
