#include "ew/imaging/effects/edge_enhancement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace ew {
namespace {

constexpr int kReach = 2;  // pixels the kernel looks at on each side

using FiveRows = std::array<const std::uint8_t*, 5>;

/// out[x] for x in begin .. end - 1, all of whose surroundings may be read.
/// @param strength 15 fraction bits
void enhanceRun(const FiveRows& rows, int strength, int begin, int end, std::uint8_t* out) {
  constexpr int kPiece = 256;
  std::array<std::uint16_t, kPiece + 2 * kReach> down{};
  for (int from = begin; from < end; from += kPiece) {
    const int count = std::min(kPiece, end - from);
    for (int n = 0; n < count + 2 * kReach; ++n) {
      const int x = from - kReach + n;
      down[static_cast<std::size_t>(n)] =
          static_cast<std::uint16_t>(rows[0][x] + rows[4][x] + 4 * (rows[1][x] + rows[3][x]) + 6 * rows[2][x]);
    }
    for (int n = 0; n < count; ++n) {
      const std::uint16_t* d = down.data() + n;
      const int mean256 = d[0] + d[4] + 4 * (d[1] + d[3]) + 6 * d[2];
      const int v = rows[2][from + n];
      const int difference128 = 128 * v - (mean256 >> 1);
      const int scaled128 = (difference128 * strength + (1 << 14)) >> 15;
      out[from + n] = static_cast<std::uint8_t>(std::clamp(v + ((scaled128 + 32) >> 6), 0, 255));
    }
  }
}

}  // namespace

void enhanceEdges(double strength, std::span<const std::vector<RowSpan>> spans, ImageView<const std::uint8_t> in, int firstRow, int rows,
                  ImageView<std::uint8_t> out) {
  EW_EXPECTS(in.width == out.width && in.height == out.height && in.data != out.data);
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(in.height));
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= in.height);
  const double usable = strength > 0.0 ? std::min(strength, 1.0) : 0.0;
  const int fixedStrength = std::min(static_cast<int>(std::lround(usable * 32768.0)), 32767);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const std::uint8_t* source = in.row(y);
    std::uint8_t* target = out.row(y);
    const bool hasRows = y >= kReach && y + kReach < in.height;
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
      std::memcpy(target + span.begin, source + span.begin, static_cast<std::size_t>(span.end - span.begin));
      if (!hasRows || fixedStrength == 0) continue;
      const FiveRows around = {in.row(y - 2), in.row(y - 1), source, in.row(y + 1), in.row(y + 2)};
      // Walk through the runs that all five rows have in common.
      int x = span.begin;
      while (x < span.end) {
        int begin = x, end = span.end;
        for (int dy = -kReach; dy <= kReach && begin < end; ++dy) {
          const auto& row = spans[static_cast<std::size_t>(y + dy)];
          const auto found = std::find_if(row.begin(), row.end(), [begin](const RowSpan& other) { return other.end > begin; });
          if (found == row.end()) {
            begin = end = span.end;
            break;
          }
          // A later start may lie beyond the runs that earlier rows gave; then the walk goes on from there.
          begin = std::max(begin, found->begin);
          end = std::min(end, found->end);
        }
        if (begin < end) {
          if (end - begin > 2 * kReach) enhanceRun(around, fixedStrength, begin + kReach, end - kReach, target);
          x = end;
        } else {
          x = std::max(begin, x + 1);
        }
      }
    }
  }
}

}  // namespace ew
