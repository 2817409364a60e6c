#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/image.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display.h"

namespace ew {

/// Where each pixel of an image finds its echo on the beam grid: made once for a probe, its depth and an image, used for every frame.
struct ScanConversionTable {
  int width = 0;  ///< of the image
  int height = 0;
  int lines = 0;  ///< of the beam grid
  int samples = 0;
  Spans spans;  ///< pixels inside the fan
  struct Tap {
    std::uint32_t first = 0;         ///< index of sample s of line l in a BeamImage: s * lines + l; l + 1 and s + 1 exist
    std::uint16_t lineWeight = 0;    ///< of line l + 1, in 1/32768
    std::uint16_t sampleWeight = 0;  ///< of sample s + 1
    bool operator==(const Tap&) const = default;
  };
  std::vector<Tap> taps;                   ///< of the pixels in the spans, row after row
  std::vector<std::size_t> firstTapOfRow;  ///< height + 1 entries
  bool operator==(const ScanConversionTable&) const = default;
};

/// Exact: each pixel's centre is taken back to the grid in closed form, weights are rounded to 2^-15.
[[nodiscard]] ScanConversionTable makeScanConversion(const Probe& probe, const Knobs& knobs, const BeamGrid& grid,
                                                     const DisplayGeometry& geometry);

/// Bilinear scan conversion of rows [firstRow, firstRow + rows) of the image; pixels outside the spans are left as they are. Levels are
/// clamped to 0..255 and rounded.
/// Cost: four loads and two blends a pixel.
void scanConvert(const ScanConversionTable& table, ImageView<const float> beams, int firstRow, int rows, ImageView<std::uint8_t> image);

}  // namespace ew
