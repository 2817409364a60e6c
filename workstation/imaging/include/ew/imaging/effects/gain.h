#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ew/core/image.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/slicing.h"

namespace ew {

/// The DGC factor (or TGC in dB) at `position` of the depth (0 at the face, 1 at the bottom): a curve through the eight sliders, at the
/// middles of eight equal depth bands, constant beyond the first and the last. It never leaves the range of two neighbouring sliders
/// (monotone cubic Hermite interpolation, Fritsch & Carlson, SIAM J. Numer. Anal. 17(2), 1980; slopes are the mean of the neighbouring
/// secants, 0 at the first and last slider so that the curve runs smoothly into its constant ends).
[[nodiscard]] double dgcAt(const std::array<double, kDgcSliders>& sliders, double position);

/// Eq. 5 for every grey level and row: table[256 * row + V] = MIN(Gain * MIN(DGC[row] * V, 255), 255), rounded once at the end.
/// @param rowPosition depth of each row, 0..1; rows outside the fan's depth are clamped
/// @param gain, dgc >= 0; a factor that is not a number counts as 0
/// @param table receives 256 * rowPosition.size() bytes, each row monotone in V; does not allocate when it is large enough already
void buildGainTable(double gain, const std::array<double, kDgcSliders>& dgc, std::span<const double> rowPosition,
                    std::vector<std::uint8_t>& table);

/// What follows gain and DGC on the way to the screen: the dynamic range shown and the grey map.
/// Ranges are brought into 20..120 dB; one that is no number above 0 counts as 60 (recorded) or as the recorded one (shown).
struct Tone {
  double recordedDynamicRange_db = 60.0;  ///< what 0..255 span
  double dynamicRange_db = 60.0;          ///< shown
  GreyMap map = GreyMap::linear;
  double middleLevel = kMiddleGrey;  ///< that stays when the range is another than recorded (resolved.h), 0..255
  bool operator==(const Tone&) const = default;
  [[nodiscard]] bool isNeutral() const { return map == GreyMap::linear && dynamicRange_db == recordedDynamicRange_db; }
};

/// The grey level shown for an echo level 0..255 (before rounding): monotone, 255 stays 255 for every map of the recorded range.
/// With m the middle level, 255 x = m + (level - m) recorded / shown, clamped to 0..255: a narrower range adds contrast about m, a wider
/// one takes some. It is shown as 255 f(x), where f keeps 0, 1 and the order, and S(x) = 3 x^2 - 2 x^3:
///   linear    f = x
///   soft      f = 2 x - S(x)         half the slope in the middle greys, twice at both ends: flatter tissue, nothing lost in the dark
///   contrast  f = S(x)               the slope 1.5 in the middle greys, 0 at both ends
///   bright    f = 1.7 x - 0.7 x^2    darker greys lifted: the middle grey by 35 %
///   clinical  a monotone curve (as dgcAt's) from 0 at x = 0 and at the reject, x = 2/15 (52 dB below full white of 60), through 255 f =
///             24, 32, 43, 55, 68, 85, 126, 183 at 255 x = 80, 90, 100, 110, 120, 130, 150, 170, to 255 at 255
/// The clinical curve was measured: grey levels of a convex machine's liver sweep against ours of equal rank (forward model, 60 dB). Dark
/// tissue on black, a long bright tail; weak noise and clutter are rejected. `automatic` is resolved before (resolved.h); here it is
/// linear. Black of a recorded volume stays black: with a range wider than recorded, levels below kFaintLevel are shown between black and
/// where they belong, as openBlack has them (effects/beam_gain.h). A level that is not a number counts as 0.
[[nodiscard]] double shownLevel(const Tone& tone, double level);

/// buildGainTable with `tone` behind it, in one table and one rounding: tables fuse. A neutral tone gives the table without it.
void buildGainTable(double gain, const std::array<double, kDgcSliders>& dgc, const Tone& tone, std::span<const double> rowPosition,
                    std::vector<std::uint8_t>& table);

/// Looks the pixels of `spans` (one entry a row) up in their row's part of the table, in place. Threads share an image by bands of rows: a
/// band is a view of its rows, with the sub-spans of `spans` and of `table` that begin at its first row.
/// @param table 256 x image.height entries, as buildGainTable makes them
void applyGainTable(ImageView<std::uint8_t> image, std::span<const std::vector<RowSpan>> spans, std::span<const std::uint8_t> table);

}  // namespace ew
