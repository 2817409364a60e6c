#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "ew/imaging/effects/focus.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/focus_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;

/// `count` vectors of a blurred row at once, so that each weight is loaded once for all of them.
template <int count>
HWY_INLINE void blurPiece(const float* in, const float* weights, int radius, float* out) {
  const Floats d;
  const std::ptrdiff_t lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const auto middle = hn::Set(d, weights[0]);
  auto sum0 = hn::Mul(middle, hn::LoadU(d, in)), sum1 = sum0, sum2 = sum0, sum3 = sum0;
  if constexpr (count == 4) {
    sum1 = hn::Mul(middle, hn::LoadU(d, in + lanes));
    sum2 = hn::Mul(middle, hn::LoadU(d, in + 2 * lanes));
    sum3 = hn::Mul(middle, hn::LoadU(d, in + 3 * lanes));
  }
  for (int k = 1; k <= radius; ++k) {
    const auto weight = hn::Set(d, weights[k]);
    const float* left = in - k;
    const float* right = in + k;
    sum0 = hn::Add(hn::Mul(weight, hn::Add(hn::LoadU(d, left), hn::LoadU(d, right))), sum0);
    if constexpr (count == 4) {
      sum1 = hn::Add(hn::Mul(weight, hn::Add(hn::LoadU(d, left + lanes), hn::LoadU(d, right + lanes))), sum1);
      sum2 = hn::Add(hn::Mul(weight, hn::Add(hn::LoadU(d, left + 2 * lanes), hn::LoadU(d, right + 2 * lanes))), sum2);
      sum3 = hn::Add(hn::Mul(weight, hn::Add(hn::LoadU(d, left + 3 * lanes), hn::LoadU(d, right + 3 * lanes))), sum3);
    }
  }
  hn::StoreU(sum0, d, out);
  if constexpr (count == 4) {
    hn::StoreU(sum1, d, out + lanes);
    hn::StoreU(sum2, d, out + 2 * lanes);
    hn::StoreU(sum3, d, out + 3 * lanes);
  }
}

/// @param in  `radius` values more on both sides, and whole vectors readable from any of its `width` places
/// @param out apart from `in`
void blurRow(const float* in, const float* weights, int radius, int width, float* out) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int x = 0;
  for (; x + 4 * lanes <= width; x += 4 * lanes) blurPiece<4>(in + x, weights, radius, out + x);
  for (; x + lanes <= width; x += lanes) blurPiece<1>(in + x, weights, radius, out + x);
  if (x >= width) return;
  if (width >= lanes) return blurPiece<1>(in + width - lanes, weights, radius, out + width - lanes);
  HWY_ALIGN float piece[HWY_MAX_BYTES / sizeof(float)];
  blurPiece<1>(in, weights, radius, piece);
  for (int n = 0; n < width; ++n) out[n] = piece[n];
}

// Both ways, result x of n lies rest / (n - 1) of the way between values `left` and left + 1, with x (m - 1) = left (n - 1) + rest in whole
// numbers. The weights are rounded to 12 bits and blended without fused operations (see CMakeLists.txt): so mirrored rows give mirrored
// results to the last bit.
constexpr float kRounder = 3072.0F;  ///< floats near it lie 2^-12 apart

/// Piecewise linear undersampling of n values to m, 2 <= m < n.
void undersampleTo(const float* in, int n, float* out, int m) {
  const float perInterval = 1.0F / static_cast<float>(m - 1);
  const int wholeStep = (n - 1) / (m - 1), restStep = (n - 1) % (m - 1);
  int left = 0, rest = 0;
  for (int k = 0; k < m - 1; ++k) {
    const float weight = (static_cast<float>(rest) * perInterval + kRounder) - kRounder;
    out[k] = in[left] * (1.0F - weight) + in[left + 1] * weight;
    left += wholeStep;
    rest += restStep;
    if (rest >= m - 1) {
      rest -= m - 1;
      ++left;
    }
  }
  out[m - 1] = in[n - 1];
}

/// Piecewise linear stretch of m >= 2 values to n > m. Whole vectors are read from any of the m places and written to any of the n.
/// Neighbouring results lie less than one value apart, so that a vector of them needs a vector of values from the first one's on: they are
/// put in place within a register, which is faster than gathering them from memory.
void stretchTo(const float* in, int m, float* out, int n) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  // Half a rest more than the result's place keeps the rounding of the product away from whole numbers.
  const auto perInterval = hn::Set(d, 1.0F / static_cast<float>(n - 1));
  const auto intervals = hn::Set(d, static_cast<float>(n - 1)), values = hn::Set(d, static_cast<float>(m - 1));
  const auto one = hn::Set(d, 1.0F), half = hn::Set(d, 0.5F), rounder = hn::Set(d, kRounder);
  const auto laneNumbers = hn::Iota(d, 0.0F);
  for (int x = 0; x < n; x += lanes) {
    const auto place = hn::Mul(hn::Add(laneNumbers, hn::Set(d, static_cast<float>(x))), values);
    const auto left = hn::Min(hn::ConvertTo(di, hn::Mul(hn::Add(place, half), perInterval)), hn::Set(di, m - 2));
    const int first = std::min(static_cast<int>(static_cast<std::int64_t>(x) * (m - 1) / (n - 1)), m - 2);
    const auto from = hn::Max(hn::Zero(di), hn::Min(hn::Sub(left, hn::Set(di, first)), hn::Set(di, lanes - 1)));
    const auto indices = hn::IndicesFromVec(d, from);
    const auto atLeft = hn::TableLookupLanes(hn::LoadU(d, in + first), indices);
    const auto atRight = hn::TableLookupLanes(hn::LoadU(d, in + first + 1), indices);
    const auto rest = hn::Sub(place, hn::Mul(hn::ConvertTo(d, left), intervals));
    const auto weight = hn::Sub(hn::Add(hn::Mul(rest, perInterval), rounder), rounder);
    hn::StoreU(hn::Add(hn::Mul(atLeft, hn::Sub(one, weight)), hn::Mul(atRight, weight)), d, out + x);
  }
  out[n - 1] = in[m - 1];
}

void reduceAndStretch(const float* in, int n, int m, float* few, float* out) {
  undersampleTo(in, n, few, m);
  stretchTo(few, m, out, n);
}

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(blurRow);
HWY_EXPORT(reduceAndStretch);

/// Floats in the widest vector of any target; HWY_MAX_BYTES is that of the target compiled last.
constexpr std::size_t kWidestVector = 64;

}  // namespace

void blurLaterally(const LateralKernels& kernels, int firstRow, ImageView<float> echoes, std::vector<float>& scratch) {
  EW_EXPECTS(firstRow >= 0 && static_cast<std::size_t>(firstRow + echoes.height) <= kernels.rows.size());
  if (echoes.width < 1) return;
  const auto width = static_cast<std::size_t>(echoes.width);
  const auto blur = HWY_DYNAMIC_DISPATCH(blurRow);
  for (int y = 0; y < echoes.height; ++y) {
    const LateralKernels::Row& kernel = kernels.rows[static_cast<std::size_t>(firstRow + y)];
    if (kernel.radius == 0) continue;
    const auto radius = static_cast<std::size_t>(kernel.radius);
    const std::size_t needed = width + 2 * radius + kWidestVector;
    if (scratch.size() < needed) scratch.resize(needed);
    float* row = echoes.row(y);
    float* middle = scratch.data() + radius;
    std::fill(scratch.data(), middle, row[0]);
    std::copy(row, row + width, middle);
    std::fill(middle + width, scratch.data() + needed, row[width - 1]);
    blur(middle, kernels.weights.data() + kernel.first, kernel.radius, echoes.width, row);
  }
}

void stretchRows(std::span<const int> samplesOfRow, int firstRow, ImageView<float> echoes, std::vector<float>& scratch) {
  EW_EXPECTS(firstRow >= 0 && static_cast<std::size_t>(firstRow + echoes.height) <= samplesOfRow.size());
  if (echoes.width < 2) return;
  const auto width = static_cast<std::size_t>(echoes.width);
  if (scratch.size() < 2 * (width + kWidestVector)) scratch.resize(2 * (width + kWidestVector));
  float* few = scratch.data();
  float* stretched = few + width + kWidestVector;
  const auto stretchFloats = HWY_DYNAMIC_DISPATCH(reduceAndStretch);
  for (int y = 0; y < echoes.height; ++y) {
    const int samples = samplesOfRow[static_cast<std::size_t>(firstRow + y)];
    if (samples >= echoes.width) continue;
    float* row = echoes.row(y);
    if (samples <= 1) {
      std::fill(row + 1, row + width, row[0]);
      continue;
    }
    stretchFloats(row, echoes.width, samples, few, stretched);
    std::copy(stretched, stretched + width, row);
  }
}

}  // namespace ew
#endif
