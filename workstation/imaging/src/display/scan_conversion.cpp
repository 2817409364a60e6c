#include "ew/imaging/scan_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../probes/fan_shape.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr std::int64_t kOne = 1 << 15;
constexpr float kPerWeight = 1.0F / static_cast<float>(kOne);

/// Splits a position in 1/32768 into an index below `last` and the weight of the next one.
std::pair<std::uint32_t, std::uint16_t> split(std::int64_t position, std::int64_t last) {
  position = std::clamp(position, std::int64_t{0}, last * kOne);
  const std::int64_t first = std::min(position / kOne, last - 1);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint16_t>(position - first * kOne)};
}

}  // namespace

ScanConversionTable makeScanConversion(const Probe& probe, const Knobs& knobs, const BeamGrid& grid, const DisplayGeometry& geometry) {
  EW_EXPECTS(grid.lines.size() >= 2 && grid.samples >= 2);
  const detail::FanShape fan = detail::fanShapeOf(probe, knobs);
  ScanConversionTable table;
  table.width = geometry.width;
  table.height = geometry.height;
  table.lines = static_cast<int>(grid.lines.size());
  table.samples = grid.samples;
  table.spans = fanSpans(probe, knobs, geometry);
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
        // Twice the distance from the middle line is rounded, so mirrored pixels take mirrored lines with the same weights.
        const std::int64_t fromMiddle = std::llround(place.across * halfLines);
        const auto [line, lineWeight] = split(lastLine * (kOne / 2) + fromMiddle, lastLine);
        const auto [sample, sampleWeight] = split(std::llround(place.depth_mm * perDepth), table.samples - 1);
        table.taps.push_back({sample * static_cast<std::uint32_t>(table.lines) + line, lineWeight, sampleWeight});
      }
  }
  table.firstTapOfRow.push_back(table.taps.size());
  return table;
}

void scanConvert(const ScanConversionTable& table, ImageView<const float> beams, int firstRow, int rows, ImageView<std::uint8_t> picture) {
  EW_EXPECTS(beams.width == table.lines && beams.height == table.samples && beams.stride == beams.width);
  EW_EXPECTS(picture.width == table.width && picture.height == table.height);
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= table.height);
  const float* nextSample = beams.data + table.lines;
  // Loads apart from arithmetic, in parts that stay in the first-level cache: the arithmetic is then vector code.
  constexpr std::size_t kPart = 64;
  std::array<float, kPart> near0, near1, far0, far1, lineWeight, sampleWeight;
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const ScanConversionTable::Tap* tap = table.taps.data() + table.firstTapOfRow[static_cast<std::size_t>(y)];
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)]) {
      std::uint8_t* out = picture.row(y) + span.begin;
      for (std::size_t left = static_cast<std::size_t>(span.end - span.begin); left > 0;) {
        const std::size_t count = std::min(kPart, left);
        for (std::size_t n = 0; n < count; ++n) {
          const float* at = beams.data + tap[n].first;
          const float* below = nextSample + tap[n].first;
          near0[n] = at[0];
          near1[n] = at[1];
          far0[n] = below[0];
          far1[n] = below[1];
          lineWeight[n] = static_cast<float>(tap[n].lineWeight);
          sampleWeight[n] = static_cast<float>(tap[n].sampleWeight);
        }
        for (std::size_t n = 0; n < count; ++n) {
          // Both products are written out: mirrored, the same two numbers are added in the other order.
          const float right = lineWeight[n] * kPerWeight;
          const float leftPart = 1.0F - right;
          const float near = near0[n] * leftPart + near1[n] * right;
          const float far = far0[n] * leftPart + far1[n] * right;
          const float level = near + (far - near) * (sampleWeight[n] * kPerWeight);
          out[n] = static_cast<std::uint8_t>(static_cast<std::int32_t>(std::min(255.0F, std::max(0.0F, level)) + 0.5F));
        }
        tap += count;
        out += count;
        left -= count;
      }
    }
  }
}

}  // namespace ew
