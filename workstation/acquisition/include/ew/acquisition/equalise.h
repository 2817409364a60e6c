#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// The frames of one sweep, recorded with one setting of gain and DGC.
struct SweepToEqualise {
  std::string name;  ///< for messages
  std::span<const PosedFrame> frames;
  Clip clip = {};  ///< with a fan, depth runs along its beams from the start radius; else along the rows
};

struct EqualiseOptions {
  double cell_mm = 4.0;           ///< sweeps are compared by the means of cubes of this size
  double knot_mm = 10.0;          ///< a correction is a straight line between depths this far apart
  double smoothness = 0.02;       ///< how stiff a curve is where nothing says otherwise, as a share of the data's weight
  int pixelStep = 2;              ///< one pixel in pixelStep^2 is looked at
  int fewestCells = 12;           ///< two sweeps overlap when they share so many cells
  double dynamicRange_db = 60.0;  ///< what grey levels 0..255 span, for figures in dB
  int threads = 0;                ///< 0: all cores; the result does not depend on it
};

/// What is added to the grey levels of one sweep at a depth. Gain is an offset after log compression, so one curve holds gain and DGC.
struct DepthCorrection {
  double knot_mm = 10.0;
  std::vector<double> grey;  ///< at depths 0, knot_mm, 2 knot_mm ...
  int group = 0;             ///< sweeps of one group overlap, directly or through others; between groups nothing is known
  double seenFrom_mm = 0.0;  ///< shallowest and deepest depth that another sweep says something about; outside, the curve runs on smoothly
  double seenTo_mm = 0.0;
  [[nodiscard]] double at(double depth_mm) const;
};

struct Equalisation {
  std::vector<DepthCorrection> sweeps;  ///< one per sweep, in their order; the mean over a group is about 0
  int groups = 0;
  std::size_t cells = 0;               ///< pairs of cells compared
  double disagreementBefore_db = 0.0;  ///< median size of the difference between two sweeps' cells
  double disagreementAfter_db = 0.0;
  std::vector<Message> notes;  ///< which sweeps stand apart
};

/// Corrections of gain and depth gain so that sweeps agree where they overlap: least squares over all pairs of cells that two sweeps saw,
/// each weighted down by its residual (Cauchy, then Geman and McClure: shadows and edges differ from view to view), with a smooth curve per
/// sweep; what no overlap can tell, the curve common to sweeps that look the same way, is left as it is. Cells with more than 2 % of pixels
/// at 0 or 255 are left out: what was cut off cannot be compared.
/// @error badField (fewer than two sweeps, a sweep without frames, options out of range, a matrix that is not finite), cancelled
[[nodiscard]] Result<Equalisation> estimateEqualisation(std::span<const SweepToEqualise> sweeps, const EqualiseOptions& options,
                                                        Progress& progress);

/// Applies a correction to the frames of a sweep: a table of 256 levels for each row of depth, one pixel high, worked out once. 0 stays 0,
/// as nothing was received there; all else is rounded and kept within 1..255, so tables rise with the level.
class FrameEqualiser {
 public:
  /// @param like a frame of the sweep; all its frames have its size and pixel spacing
  FrameEqualiser(const DepthCorrection& correction, const Clip& clip, const PosedFrame& like);
  /// @param equalised same size as the frame; may be the frame itself
  void apply(ImageView<const std::uint8_t> frame, ImageView<std::uint8_t> equalised) const;

 private:
  Image<std::uint16_t> rowOfPixel_;
  std::vector<std::uint8_t> table_;  ///< (rows x 256)
};

}  // namespace ew
