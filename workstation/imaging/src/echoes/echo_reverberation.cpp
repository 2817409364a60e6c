#include "echo_reverberation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "line_kernels.h"
#include "pairs.h"

namespace ew::detail {
namespace {

constexpr double kGasBelow_mrayl = 0.05;
constexpr double kLungBelow_mrayl = 0.5;
constexpr double kStep_mm = 0.6;   // along a line, in search of a front
constexpr int kSearched = 16;      // lines side by side
constexpr double kPatch_mm = 3.0;  // of the front, that rings as one
constexpr double kNear_mm = 1.5;   // labels and surfaces agree on a front's place within this
constexpr double kRough_db = 8.0;  // lost by a bounce at a rough front beyond that at a smooth one
constexpr double kPatchSpread_db = 5.0;
constexpr double kNoRingDown_db = -60.0;
constexpr double kNoClutter_db = -60.0;
constexpr double kNoHaze_db = -60.0;
constexpr double kSkin_mm = 5.0;       // under the face: neither makes haze nor shows any
constexpr double kSamePlace_mm = 0.4;  // a probe that moved less sees the same haze
// A mirror sends its sound straight back: it makes no more haze than tissue some decibels brighter than what lies in front.
constexpr float kMostOfMean = 4.0F;
constexpr double kFaintest_db = -46.0;  // below full white: what rings fainter is left out
constexpr int kPatchesOfATail = 9;      // of a pleura, one has a comet tail
constexpr int kPatchBlend = 3;          // lines over which neighbouring patches run into one another, on each side
constexpr double kStripeFloor = 0.55;   // of the ring-down's amplitude between its stripes
constexpr double kStrayLess_db = 5.0;
constexpr double kStrayFalls = 0.35;  // as fast as the ring-down
constexpr double kTailLess_db = 6.0;
constexpr double kTailFalls = 2.0;  // as fast as the ring-down of gas
constexpr double kClutterFall_dbPerMm = 1.0;
// Not multiples of one another, so that copies of copies do not fall together.
constexpr std::array<double, 5> kClutter_mm{3.1, 4.7, 7.3, 10.1, 13.7};
// Layers are uneven: what they throw back comes a little earlier here and later there, brighter and fainter. A bright line would have a
// ladder of itself below it.
constexpr double kWaver_mm = 1.1;
constexpr double kWaver_lines = 7.0;
constexpr double kFaintestCopy = 0.3;

double amplitudeOf(double level_db) { return std::pow(10.0, 0.05 * level_db); }

std::uint32_t spread(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x21f0aaadU;
  x = (x ^ (x >> 15)) * 0x735a2d97U;
  return x ^ (x >> 15);
}

std::uint32_t hashOf(const glm::ivec3& at) {
  return spread(static_cast<std::uint32_t>(at.x) * 0x9E3779B1U + static_cast<std::uint32_t>(at.y) * 0x85EBCA77U +
                static_cast<std::uint32_t>(at.z) * 0xC2B2AE3DU);
}

/// In [0, 1): the n-th number that follows from a hash.
double evenOf(std::uint32_t hash, std::uint32_t n) { return spread(hash + n * 0x9E3779B9U) * 0x1p-32; }

/// Nearly normal, of deviation 1.
float normalOf(std::uint32_t hash) {
  const std::uint32_t x = spread(hash);
  const auto sum = static_cast<float>((x & 0xFFU) + ((x >> 8) & 0xFFU) + ((x >> 16) & 0xFFU) + (x >> 24));
  return (sum - 510.0F) * (1.0F / 147.8F);
}

/// Nearly normal numbers of deviation 1, to begin anywhere in.
struct NoiseTable {
  static constexpr std::size_t kSize = 8192;
  std::array<float, 2 * kSize> numbers;
  NoiseTable() {
    for (std::size_t n = 0; n < kSize; ++n) numbers[n] = numbers[n + kSize] = normalOf(static_cast<std::uint32_t>(n) * 0x9E3779B9U);
  }
};

/// A number -1..1 that changes evenly from line to line.
double waverAt(int line, std::uint32_t which) {
  const double at = line / kWaver_lines, whole = std::floor(at), t = at - whole, share = t * t * (3.0 - 2.0 * t);
  const auto cell = static_cast<std::uint32_t>(static_cast<int>(whole));
  return 2.0 * std::lerp(evenOf(which, cell), evenOf(which, cell + 1), share) - 1.0;
}

}  // namespace

EchoReverberation::Aerated EchoReverberation::aeratedOf(const TissueAcoustics& tissue) {
  if (tissue.impedance_mrayl < kGasBelow_mrayl) return Aerated::gas;
  return tissue.impedance_mrayl < kLungBelow_mrayl ? Aerated::lung : Aerated::no;
}

void EchoReverberation::configure(const EchoLayout& layout, const Scene& scene) {
  layout_ = &layout;
  effect_ = scene.reverberation.value_or(ReverberationEffect{});
  noiseScale_ = static_cast<float>(std::sqrt(0.5 * layout.grid.sampleSpacing_mm));
  isGas_.fill(0.0F);
  isLung_.fill(0.0F);
  hasAerated_ = false;
  for (const TissueAcoustics& tissue : scene.tissues) {
    if (tissue.label < 0 || tissue.label > 255) continue;
    const Aerated aerated = aeratedOf(tissue);
    (aerated == Aerated::lung ? isLung_ : isGas_)[static_cast<std::size_t>(tissue.label)] = aerated == Aerated::no ? 0.0F : 1.0F;
    hasAerated_ = hasAerated_ || aerated != Aerated::no;
  }
  fronts_.assign(layout.grid.lines.size(), Front{});
  layClutter();
  layFalls();
}

void EchoReverberation::layClutter() {
  copies_.clear();
  if (!(effect_.clutter_db > kNoClutter_db)) return;
  for (int line = 0; line < static_cast<int>(fronts_.size()); ++line)
    for (std::size_t n = 0; n < kClutter_mm.size(); ++n) {
      const auto which = static_cast<std::uint32_t>(2 * n + 1) * 0x85EBCA77U;
      const double delay_mm = kClutter_mm[n] + kWaver_mm * waverAt(line, which);
      const double share = kFaintestCopy + (1.0 - kFaintestCopy) * (0.5 + 0.5 * waverAt(line, which + 0x9E3779B9U));
      const double level_db = effect_.clutter_db - kClutterFall_dbPerMm * delay_mm;
      copies_.push_back({static_cast<int>(std::lround(delay_mm / layout_->grid.sampleSpacing_mm)),
                         static_cast<float>(share * amplitudeOf(level_db)), static_cast<int>((n + 1) % 4)});
    }
}

void EchoReverberation::find(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const EchoMotion& motion,
                             Bands& bands) {
  const glm::dmat4& m = probeToLabel.matrix;
  const glm::dvec3 face_mm = glm::dvec3(m[3]) * labels.grid.spacing_mm, far_mm = glm::dvec3(m * glm::dvec4(30.0, 100.0, 0.0, 1.0));
  place_ = hashOf(glm::ivec3(glm::floor(face_mm / kSamePlace_mm))) ^
           spread(hashOf(glm::ivec3(glm::floor(far_mm * labels.grid.spacing_mm / kSamePlace_mm))));
  if (!hasAerated_) return;
  const LabelBlend blend{labels, isGas_, isLung_};
  if (motion.moves()) motion.rowsOf(0.0, glm::mat3(m), bands, back_);
  ways_.lay(layout_->grid, m);
  bands.run(static_cast<int>(fronts_.size()), [&](int first, int count, int) {
    for (int line = first; line < first + count; line += kSearched)
      findFronts(blend, motion, line, std::min(kSearched, first + count - line));
  });
}

/// Of neighbouring lines, step by step, until each has met its front.
void EchoReverberation::findFronts(const LabelBlend& blend, const EchoMotion& motion, int first, int count) {
  std::array<float, kSearched> gas{}, lung{}, before{};
  std::fill_n(fronts_.begin() + first, count, Front{});
  int left = count;
  for (int step = 0; left > 0 && step * kStep_mm < layout_->depth_mm; ++step) {
    const auto range_mm = static_cast<float>(step * kStep_mm);
    const EchoMotion::RowsAround back = motion.rowsAround(back_, range_mm);
    blendRow(blend, {ways_, glm::vec3(0.0F), range_mm, 4.0F, back}, first, count, gas.data(), lung.data());
    for (int n = 0; n < count; ++n) {
      const auto lane = static_cast<std::size_t>(n);
      const float here = gas[lane] + lung[lane], last = before[lane];
      before[lane] = here;
      Front& front = fronts_[static_cast<std::size_t>(first + n)];
      if (here < 0.5F || front.range_mm >= 0.0) continue;
      const double share = step == 0 ? 0.0 : static_cast<double>((here - 0.5F) / (here - last));
      front.range_mm = (step - share) * kStep_mm;
      front.isLung = lung[lane] > gas[lane];
      const glm::vec3 perMm = ways_.perMmOf(first + n);
      glm::vec3 place = ways_.startOf(first + n) + range_mm * perMm;
      if (back.near != nullptr) place += back.at(first + n);
      place -= static_cast<float>(share * kStep_mm) * perMm;
      front.patch = hashOf(glm::ivec3(glm::floor(glm::dvec3(place) * blend.labels.grid.spacing_mm / kPatch_mm)));
      --left;
    }
  }
}

void EchoReverberation::add(int line, std::span<float> field, Scratch& scratch) const {
  std::vector<float>& before = scratch.before;
  before.assign(field.begin(), field.end());
  if (!copies_.empty()) clutter(line, before.data(), field);
  if (effect_.shadowHaze_db > kNoHaze_db) haze(line, before.data(), field);
  const Front& front = fronts_[static_cast<std::size_t>(line)];
  if (front.range_mm < 0.0) return;
  const Echo echo = frontEcho(front, before.data(), scratch.amplitudes);
  if (!(static_cast<double>(echo.amplitude) > amplitudeOf(kFaintest_db))) return;
  ringDown(line, echo, scratch, field);
  bounce(front, echo, before.data(), field);
  if (effect_.mirror && front.isLung) mirror(echo, before.data(), field);
}

/// The brightest place about the front, as the pulse's filter will see it.
EchoReverberation::Echo EchoReverberation::frontEcho(const Front& front, const float* before, std::vector<float>& amplitudes) const {
  const double perMm = 1.0 / layout_->grid.sampleSpacing_mm;
  const int reach = static_cast<int>(layout_->pulse.size()) - 1;
  const int middle = layout_->columnPadding + static_cast<int>(std::lround(front.range_mm * perMm)),
            aside = static_cast<int>(kNear_mm * perMm);
  const int first = std::max(middle - aside, reach), count = std::min(middle + aside, layout_->columns - 1 - reach) + 1 - first;
  if (count <= 0) return {middle, 0.0F};
  amplitudes.resize(std::max(amplitudes.size(), static_cast<std::size_t>(count)));
  envelopeOf({.pulse = layout_->pulse.data(), .reach = reach, .middleShare = 1.0F, .pairs = {}}, pairAt(before, first), count,
             amplitudes.data());
  const auto brightest = std::max_element(amplitudes.begin(), amplitudes.begin() + count);
  return *brightest > 0.0F ? Echo{first + static_cast<int>(brightest - amplitudes.begin()), *brightest} : Echo{middle, 0.0F};
}

/// Patches run into one another over a few lines.
void EchoReverberation::ringDown(int line, const Echo& echo, Scratch& scratch, std::span<float> field) const {
  if (!(effect_.ringDown_db > kNoRingDown_db)) return;
  for (int aside = 1 - kPatchBlend; aside < kPatchBlend; ++aside) {
    const int other = line + aside;
    if (other < 0 || other >= static_cast<int>(fronts_.size())) continue;
    const Front& front = fronts_[static_cast<std::size_t>(other)];
    const bool hasTail = !front.isLung || spread(front.patch) % kPatchesOfATail == 0;
    if (front.range_mm < 0.0 || !hasTail) continue;
    const double share = static_cast<double>(kPatchBlend - std::abs(aside)) / (kPatchBlend * kPatchBlend);
    const double more_db = kPatchSpread_db * static_cast<double>(normalOf(front.patch + 1)) - (front.isLung ? kTailLess_db : 0.0);
    addRing(front.patch, share * amplitudeOf(effect_.ringDown_db + more_db), front.isLung ? Fall::tail : Fall::gas, echo,
            scratch.rings[front.patch % scratch.rings.size()], field);
  }
  // What no patch shares: sound that wandered about between bubbles.
  const std::uint32_t own = spread(fronts_[static_cast<std::size_t>(line)].patch + static_cast<std::uint32_t>(line));
  if (!fronts_[static_cast<std::size_t>(line)].isLung)
    addRing(own, amplitudeOf(effect_.ringDown_db - kStrayLess_db), Fall::stray, echo, scratch.own, field);
}

namespace {

/// Makes a ring as long as so many columns.
void lengthen(EchoReverberation::Ring& ring, std::size_t columns) {
  const double stripe_mm = 1.0 + 2.0 * evenOf(ring.key, 2), phase = evenOf(ring.key, 3);
  for (std::size_t n = ring.wave.size() / 2 + 1; n <= columns; ++n) {
    const double away_mm = static_cast<double>(n) * ring.sampleSpacing_mm;
    // It rises over the front's own echo.
    const double rise = std::min(1.0, away_mm / 0.8);
    const double turns = away_mm / stripe_mm + phase, part = turns - std::floor(turns);
    // Where the wave is surely below 0 nobody asks how far.
    const double wave = part > 0.26 && part < 0.74 ? 0.0 : std::max(0.0, std::cos(2.0 * std::numbers::pi * turns));
    const auto strength = static_cast<float>(rise * (kStripeFloor + (1.0 - kStripeFloor) * wave));
    const std::uint32_t hash = spread(ring.key + static_cast<std::uint32_t>(n) * 0x85EBCA77U);
    ring.wave.push_back(strength * normalOf(hash));
    ring.wave.push_back(strength * normalOf(hash ^ 0x5bd1e995U));
  }
}

}  // namespace

void EchoReverberation::layFalls() {
  constexpr std::array<double, 3> kFalls{1.0, kTailFalls, kStrayFalls};
  for (std::size_t n = 0; n < falls_.size(); ++n) {
    const double perColumn = amplitudeOf(-kFalls[n] * effect_.ringDownFall_dbPerMm * layout_->grid.sampleSpacing_mm);
    falls_[n].clear();
    for (double amplitude = 1.0; static_cast<int>(falls_[n].size()) < layout_->columns; amplitude *= perColumn)
      falls_[n].push_back(static_cast<float>(std::max(amplitude, 1e-30)));
  }
}

void EchoReverberation::addRing(std::uint32_t key, double first, Fall kind, const Echo& echo, Ring& ring, std::span<float> field) const {
  const double sampleSpacing_mm = layout_->grid.sampleSpacing_mm;
  if (ring.key != key || ring.sampleSpacing_mm != sampleSpacing_mm) {
    ring.key = key;
    ring.sampleSpacing_mm = sampleSpacing_mm;
    ring.wave.clear();
  }
  const auto amplitude = static_cast<float>(static_cast<double>(noiseScale_ * echo.amplitude) * first);
  const auto faintest = static_cast<float>(static_cast<double>(noiseScale_) * amplitudeOf(kFaintest_db));
  const std::vector<float>& fall = falls_[static_cast<std::size_t>(kind)];
  const int room = std::max(layout_->columns - echo.column - 1, 0);
  const auto end = std::partition_point(fall.begin(), fall.begin() + room, [&](float part) { return amplitude * part > faintest; });
  const auto count = static_cast<int>(end - fall.begin());
  lengthen(ring, static_cast<std::size_t>(count));
  addFalling(ring.wave.data(), fall.data(), amplitude, count, pairAt(field.data(), echo.column + 1));
}

void EchoReverberation::bounce(const Front& front, const Echo& echo, const float* before, std::span<float> field) const {
  const int range = echo.column - layout_->columnPadding, behind = static_cast<int>(kNear_mm / layout_->grid.sampleSpacing_mm);
  if (range < 1) return;
  const double front_db = 20.0 * std::log10(static_cast<double>(echo.amplitude)) - layout_->effect.gain_db;
  const double loss_db = effect_.loss_dbPerBounce + (front.isLung ? 0.0 : kRough_db);
  for (int n = 1; n <= effect_.bounces; ++n) {
    const double level_db = std::min(front_db, 0.0) - n * loss_db;
    if (level_db < kFaintest_db) break;
    const int begin = layout_->columnPadding + n * range;
    const int first = n == 1 ? behind : 0, count = std::min(range + behind, layout_->columns - begin) - first;
    if (count <= 0) break;
    const QuarterTurnRow copy{pairAt(before, layout_->columnPadding + first), static_cast<float>(amplitudeOf(level_db)), n % 4};
    addTurned(&copy, 1, count, pairAt(field.data(), begin + first));
  }
}

void EchoReverberation::mirror(const Echo& echo, const float* before, std::span<float> field) const {
  const auto weight = static_cast<float>(amplitudeOf(-effect_.mirrorLoss_db));
  const int first = static_cast<int>(kNear_mm / layout_->grid.sampleSpacing_mm);
  for (int n = first; echo.column + n < layout_->columns && echo.column - n >= layout_->columnPadding; ++n) {
    const std::size_t to = 2 * static_cast<std::size_t>(echo.column + n);
    const int from = 2 * (echo.column - n);
    field[to] += weight * before[from];
    field[to + 1] += weight * before[from + 1];
  }
}

namespace {

/// The sum of squares, in an order of its own whatever vectors the compiler makes of it.
float squaresOf(const float* numbers, int count) {
  std::array<float, 8> sums{};
  int n = 0;
  for (; n + 8 <= count; n += 8)
    for (int lane = 0; lane < 8; ++lane) sums[static_cast<std::size_t>(lane)] += numbers[n + lane] * numbers[n + lane];
  for (; n < count; ++n) sums[static_cast<std::size_t>(n % 8)] += numbers[n] * numbers[n];
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace

void EchoReverberation::haze(int line, const float* before, std::span<float> field) const {
  static const NoiseTable noise;
  constexpr int kBlock = 16;  // columns of one mean
  const auto share = static_cast<float>(0.5 * amplitudeOf(2.0 * effect_.shadowHaze_db));
  const auto faint = noiseScale_ * static_cast<float>(amplitudeOf(kFaintest_db)), faintest = 2.0F * faint * faint;
  float power = 0.0F;
  int counted = 0;
  for (int begin = layout_->columnPadding + static_cast<int>(kSkin_mm / layout_->grid.sampleSpacing_mm); begin < layout_->columns;
       begin += kBlock) {
    const int count = std::min(kBlock, layout_->columns - begin);
    const float strength = counted > 0 ? std::sqrt(share * power / static_cast<float>(counted)) : 0.0F;
    const std::uint32_t key = spread(place_ + static_cast<std::uint32_t>(line) * 0x9E3779B9U + static_cast<std::uint32_t>(begin));
    addWeighted(noise.numbers.data() + key % NoiseTable::kSize, strength, 2 * count, pairAt(field.data(), begin));
    float met = squaresOf(pairAt(before, begin), 2 * count);
    if (counted > 0) {
      const float most = std::max(kMostOfMean * power / static_cast<float>(counted), faintest);
      met = std::min(met, most * static_cast<float>(count));
    }
    power += met;
    counted += count;
  }
}

void EchoReverberation::clutter(int line, const float* before, std::span<float> field) const {
  const Copy* copies = copies_.data() + static_cast<std::size_t>(line) * kClutter_mm.size();
  for (std::size_t n = 0; n < kClutter_mm.size(); ++n)
    if (const Copy& copy = copies[n]; copy.delay < layout_->columns) {
      const QuarterTurnRow row{before, copy.weight, copy.quarter};
      addTurned(&row, 1, layout_->columns - copy.delay, pairAt(field.data(), copy.delay));
    }
}

}  // namespace ew::detail
