#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/scan_conversion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "display/conversion_table.h"
#include "ew/core/contract.h"
#include "ew/imaging/scan_conversion.h"

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

using Tap = ScanConversionTable::Tap;
constexpr float kPerWeight = 1.0F / 32768.0F;

/// `beams` at the first sample of the first line, `nextSample` one sample below it.
void convertPixels(const float* beams, const float* nextSample, const Tap* taps, std::size_t count, std::uint8_t* out) {
  for (std::size_t n = 0; n < count; ++n) {
    const float* near = beams + taps[n].first;
    const float* far = nextSample + taps[n].first;
    // Both products are written out: mirrored, the same two numbers are added in the other order.
    const float right = static_cast<float>(taps[n].lineWeight) * kPerWeight;
    const float left = 1.0F - right;
    const float above = near[0] * left + near[1] * right;
    const float below = far[0] * left + far[1] * right;
    const float level = above + (below - above) * (static_cast<float>(taps[n].sampleWeight) * kPerWeight);
    out[n] = static_cast<std::uint8_t>(static_cast<std::int32_t>(std::min(255.0F, level > 0.0F ? level : 0.0F) + 0.5F));
  }
}

#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR

void convertRun(const float* beams, const float* nextSample, const Tap* taps, std::size_t count, std::uint8_t* out) {
  convertPixels(beams, nextSample, taps, count, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

/// convertPixels with vectors. Two neighbouring lines come with one load of 8 bytes, apart from the arithmetic and in parts that stay in
/// the first-level cache; the gather instructions of AVX2 and AVX-512 took 1.6 times as long.
void convertRun(const float* beams, const float* nextSample, const Tap* taps, std::size_t count, std::uint8_t* out) {
  static_assert(sizeof(Tap) == 8 && offsetof(Tap, lineWeight) == 4 && offsetof(Tap, sampleWeight) == 6);
  constexpr std::size_t kPart = 128;
  const hn::ScalableTag<float> levels;
  const hn::RebindToSigned<decltype(levels)> whole;
  const hn::RebindToUnsigned<decltype(levels)> words;
  const hn::Rebind<std::uint8_t, decltype(levels)> pixels;
  const std::size_t lanes = hn::Lanes(levels);
  const auto one = hn::Set(levels, 1.0F);
  const auto weightOf = [&](auto bits) { return hn::Mul(hn::ConvertTo(levels, hn::BitCast(whole, bits)), hn::Set(levels, kPerWeight)); };
  HWY_ALIGN std::array<float, 2 * kPart> near;
  HWY_ALIGN std::array<float, 2 * kPart> far;
  const std::size_t vectors = count - count % lanes;
  for (std::size_t begin = 0; begin < vectors; begin += kPart) {
    const std::size_t part = std::min(kPart, vectors - begin);
    for (std::size_t n = 0; n < part; ++n) {
      const std::size_t first = taps[begin + n].first;
      std::memcpy(near.data() + 2 * n, beams + first, 2 * sizeof(float));
      std::memcpy(far.data() + 2 * n, nextSample + first, 2 * sizeof(float));
    }
    for (std::size_t n = 0; n < part; n += lanes) {
      hn::Vec<decltype(words)> firsts, weights;
      hn::LoadInterleaved2(words, reinterpret_cast<const std::uint32_t*>(taps + begin + n), firsts, weights);
      hn::Vec<decltype(levels)> nearLeft, nearRight, farLeft, farRight;
      hn::LoadInterleaved2(levels, near.data() + 2 * n, nearLeft, nearRight);
      hn::LoadInterleaved2(levels, far.data() + 2 * n, farLeft, farRight);
      const auto right = weightOf(hn::And(weights, hn::Set(words, 0xffff)));
      const auto down = weightOf(hn::ShiftRight<16>(weights));
      const auto left = hn::Sub(one, right);
      const auto above = hn::Add(hn::Mul(nearLeft, left), hn::Mul(nearRight, right));
      const auto below = hn::Add(hn::Mul(farLeft, left), hn::Mul(farRight, right));
      const auto level = hn::Add(above, hn::Mul(hn::Sub(below, above), down));
      const auto positive = hn::IfThenElseZero(hn::Gt(level, hn::Zero(levels)), level);  // also what is no number becomes 0
      const auto shown = hn::Add(hn::Min(positive, hn::Set(levels, 255.0F)), hn::Set(levels, 0.5F));
      hn::StoreU(hn::DemoteTo(pixels, hn::ConvertTo(whole, shown)), pixels, out + begin + n);
    }
  }
  convertPixels(beams, nextSample, taps + vectors, count - vectors, out + vectors);
}

#endif

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(convertRun);

constexpr std::int64_t kOne = 1 << 15;

/// Halves are rounded away from 0, so that mirrored numbers stay mirrored.
std::int64_t rounded(double value) {
  return value < 0.0 ? -static_cast<std::int64_t>(0.5 - value) : static_cast<std::int64_t>(value + 0.5);
}

/// Splits a position in 1/32768 into an index below `last` and the weight of the next one.
std::pair<std::uint32_t, std::uint16_t> split(std::int64_t position, std::int64_t last) {
  position = std::clamp(position, std::int64_t{0}, last * kOne);
  const std::int64_t first = std::min(position / kOne, last - 1);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint16_t>(position - first * kOne)};
}

}  // namespace

ScanConversionTable makeScanConversion(const Probe& probe, const Knobs& knobs, const BeamGrid& grid, const DisplayGeometry& geometry) {
  return detail::conversionOf(detail::fanShapeOf(probe, knobs), fanSpans(probe, knobs, geometry), grid, geometry);
}

ScanConversionTable detail::conversionOf(const FanShape& fan, Spans spans, const BeamGrid& grid, const DisplayGeometry& geometry) {
  EW_EXPECTS(grid.lines.size() >= 2 && grid.samples >= 2);
  ScanConversionTable table;
  table.width = geometry.width;
  table.height = geometry.height;
  table.lines = static_cast<int>(grid.lines.size());
  table.samples = grid.samples;
  table.spans = std::move(spans);
  table.firstTapOfRow.reserve(static_cast<std::size_t>(table.height) + 1);
  std::size_t pixels = 0;
  for (const std::vector<RowSpan>& row : table.spans)
    for (const RowSpan& span : row) pixels += static_cast<std::size_t>(span.end - span.begin);
  table.taps.reserve(pixels);
  const std::int64_t lastLine = table.lines - 1;
  const double halfLines = 0.5 * static_cast<double>(lastLine * kOne);
  const double perDepth = static_cast<double>(kOne) / grid.sampleSpacing_mm;
  for (int y = 0; y < table.height; ++y) {
    table.firstTapOfRow.push_back(table.taps.size());
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)])
      for (int x = span.begin; x < span.end; ++x) {
        const detail::FanShape::Place place = fan.placeOf(geometry.probePoint_mm(x, y));
        // The distance from the middle line is rounded, so mirrored pixels take mirrored lines with the same weights.
        const std::int64_t fromMiddle = rounded(place.across * halfLines);
        const auto [line, lineWeight] = split(lastLine * (kOne / 2) + fromMiddle, lastLine);
        const auto [sample, sampleWeight] = split(rounded(place.depth_mm * perDepth), table.samples - 1);
        table.taps.push_back({sample * static_cast<std::uint32_t>(table.lines) + line, lineWeight, sampleWeight});
      }
  }
  table.firstTapOfRow.push_back(table.taps.size());
  return table;
}

void scanConvert(const ScanConversionTable& table, ImageView<const float> beams, int firstRow, int rows, ImageView<std::uint8_t> image) {
  EW_EXPECTS(beams.width == table.lines && beams.height == table.samples && beams.stride == beams.width);
  EW_EXPECTS(image.width == table.width && image.height == table.height);
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= table.height);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const ScanConversionTable::Tap* taps = table.taps.data() + table.firstTapOfRow[static_cast<std::size_t>(y)];
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)]) {
      const auto count = static_cast<std::size_t>(span.end - span.begin);
      HWY_DYNAMIC_DISPATCH(convertRun)(beams.data, beams.data + table.lines, taps, count, image.row(y) + span.begin);
      taps += count;
    }
  }
}

}  // namespace ew
#endif
