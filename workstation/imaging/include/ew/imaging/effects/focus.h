#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// What decides how wide a beam is.
struct BeamModel {
  double wavelength_mm = 0.44;
  double aperture_mm = 20.0;                ///< widest active part of the face
  std::array<double, kMostFoci> foci_mm{};  ///< transmit foci, 0: not used; at least one
  double recordedWidth_mm = 0.0;            ///< width the volume's own beam already has; not blurred twice
  double strength = 1.0;
  bool operator==(const BeamModel&) const = default;
};

/// The beam of a probe at the console's setting; focus 0 counts as half of the depth.
[[nodiscard]] BeamModel beamModelOf(const Probe& probe, const Knobs& knobs, const FocusEffect& effect, double depth_mm);

/// Lateral width of the beam (full width at half maximum, mm) at a depth: receive focusing follows the echo, transmit focusing is at the
/// foci, each depth is taken from the focus that is sharpest there. The .cpp gives equation and source.
[[nodiscard]] double lateralWidth_mm(const BeamModel& model, double depth_mm);

/// One symmetric kernel for each depth (row) of a beam grid; a row narrower than a line needs none.
struct LateralKernels {
  struct Row {
    int radius = 0;         ///< lines on each side; 0: the row stays as it is
    std::size_t first = 0;  ///< weights[first] is the middle one, radius + 1 weights outwards; they sum to 1 with the mirrored ones
  };
  std::vector<Row> rows;
  std::vector<float> weights;
};
/// Gaussian kernels whose full width at half maximum is the beam's.
[[nodiscard]] LateralKernels makeLateralKernels(const BeamModel& model, const BeamGrid& grid);

/// Blurs rows [firstRow, firstRow + echoes.height) of the beam grid, in place; at the fan's edges the outermost line goes on.
/// @param scratch holds a row; does not allocate when it is large enough already
void blurLaterally(const LateralKernels& kernels, int firstRow, ImageView<float> echoes, std::vector<float>& scratch);

/// How many samples across the picture a row is reduced to and stretched back from (the paper's focus): for each row of the beam grid,
/// `lines` where it is sharp, fewer where the beam is wider than a line.
void rowResolutions(const BeamModel& model, const BeamGrid& grid, std::vector<int>& samplesOfRow);

/// The paper's focus: each row is undersampled to samplesOfRow[firstRow + y] values and stretched back (Fig. 5), in place.
void stretchRows(std::span<const int> samplesOfRow, int firstRow, ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
