#include "ew/imaging/effects/noise.h"

#include <cmath>

#include "effects/grey_scale.h"
#include "effects/spread_bits.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/noise.cpp"
#include "hwy/foreach_target.h"
//
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace {

/// Multiply and shift hash of 32 bits for counters; constants of C. Wellons' search for low bias (public domain), a second key between
/// the rounds.
template <class D>
HWY_INLINE hn::Vec<D> hashOf(D d, hn::Vec<D> counter, std::uint64_t key) {
  auto x = hn::Add(counter, hn::Set(d, static_cast<std::uint32_t>(key)));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), hn::Set(d, 0x21f0aaadU));
  x = hn::Xor(x, hn::Set(d, static_cast<std::uint32_t>(key >> 32)));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), hn::Set(d, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

/// log2(u) of u in (0, 1): as log2Of with a polynomial of one degree less, relative error below 4e-4.
template <class D>
HWY_INLINE FloatsOf<D> roughLog2Of(D d, FloatsOf<D> u) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, u);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
  const auto t = hn::Sub(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent))), hn::Set(d, 1.0F));
  auto sum = hn::Set(d, -0.322623591F);
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 0.510183237F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, -0.724699847F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 1.44230705F));
  return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(sum, t));
}

/// @param unitLevel level of a sample whose -log2(u) is 1
void addNoiseToRow(std::uint64_t key, float unitLevel, float perDoubling, float* echoes, int width) {
  forColumns(width, [&](auto d, int x) HWY_ATTR {
    const hn::RebindToSigned<decltype(d)> di;
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto bits = hashOf(du, hn::Iota(du, static_cast<std::uint32_t>(x)), key);
    // 23 bits and a half: never 0, never 1, exact in a float.
    const auto whole = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<9>(bits)));
    const auto u = hn::Mul(hn::Add(whole, hn::Set(d, 0.5F)), hn::Set(d, 0x1p-23F));
    // Powers in units of the noise's own; an echo is at most 100 doublings (300 dB) off.
    const auto unit = hn::Set(d, unitLevel);
    const auto above = hn::Mul(hn::Sub(hn::LoadU(d, echoes + x), unit), hn::Set(d, 1.0F / perDoubling));
    const auto echo = exp2Of(d, hn::Min(hn::Max(above, hn::Set(d, -100.0F)), hn::Set(d, 100.0F)));
    const auto sum = log2Of(d, hn::Sub(echo, roughLog2Of(d, u)));
    hn::StoreU(hn::Add(unit, hn::Mul(sum, hn::Set(d, perDoubling))), d, echoes + x);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(addNoiseToRow);

}  // namespace

std::vector<float> noiseLevels(const NoiseEffect& effect, double carrier_hz, double recordedDynamicRange_db, const BeamGrid& grid) {
  EW_EXPECTS(recordedDynamicRange_db > 0.0);
  std::vector<float> levels(static_cast<std::size_t>(grid.samples));
  for (int s = 0; s < grid.samples; ++s) {
    const double level_db = noiseLevel_db(effect, carrier_hz, grid.depth_mm(s));
    levels[static_cast<std::size_t>(s)] = static_cast<float>(255.0 * (1.0 + level_db / recordedDynamicRange_db));
  }
  return levels;
}

void addNoise(const std::vector<float>& levels, double greyPerDb, std::uint64_t frameNumber, int firstRow, ImageView<float> echoes,
              double lift_db) {
  EW_EXPECTS(greyPerDb > 0.0);
  EW_EXPECTS(firstRow >= 0 && static_cast<std::size_t>(firstRow) + static_cast<std::size_t>(echoes.height) <= levels.size());
  const float perDoubling = levelsPerDoubling(greyPerDb);
  const auto unseen = static_cast<float>(-(kNoiseUnseen_db + lift_db) * greyPerDb);
  for (int y = 0; y < echoes.height; ++y) {
    const float level = levels[static_cast<std::size_t>(firstRow + y)];
    if (!(level > unseen)) continue;
    const auto gridRow = static_cast<std::uint64_t>(firstRow + y);
    const std::uint64_t key = detail::spreadBits(detail::spreadBits(frameNumber + 0x9e3779b97f4a7c15ULL) + gridRow * 0x9e3779b97f4a7c15ULL);
    const float unitLevel = level + perDoubling * static_cast<float>(std::log2(std::log(2.0)));
    HWY_DYNAMIC_DISPATCH(addNoiseToRow)(key, unitLevel, perDoubling, echoes.row(y), echoes.width);
  }
}

}  // namespace ew
#endif
