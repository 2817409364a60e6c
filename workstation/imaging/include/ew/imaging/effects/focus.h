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
  std::array<double, kMostFoci> foci_mm{};  ///< transmit foci, 0: not used; none at all: the transmit beam is not focused
  double recordedWidth_mm = 0.0;            ///< width the volume's own beam already has; not blurred twice
  double strength = 1.0;                    ///< of the blur, 0: none
  bool operator==(const BeamModel&) const = default;
};

/// The beam of a probe at the console's setting; focus 0 counts as half of the depth. The volume is taken to be as sharp everywhere as
/// this probe is at its best: so with the probe's own frequency a row at a focus in reach of the aperture stays as it was recorded.
[[nodiscard]] BeamModel beamModelOf(const Probe& probe, const Knobs& knobs, const FocusEffect& effect, double depth_mm);

/// Lateral width of the beam (full width at half maximum, mm) at a depth: receive focusing follows the echo, transmit focusing is at the
/// foci, each depth is taken from the focus that is sharpest there. With z the depth, F the focus, D the aperture, L the wavelength and
///   D(F) = min(D, F / 3)
///   transmit  w_t^2 = (0.731 D(F) (1 - z / F))^2 + (1.207 L z / D(F))^2
///   receive   w_r   =  1.207 L max(3, z / D)
///   two-way   1 / w^2 = 1 / w_t^2 + 1 / w_r^2
/// w_t is the beam of a Gaussian aperture, exact in Fresnel's approximation, as wide at its focus as that of an evenly driven aperture D
/// (half of a sinc's height lies at 0.603). w has its minima at the foci up to 3 D; deeper, the aperture no longer keeps its f-number and
/// the width grows with depth, but a focus there still makes its depth sharper than a shallower one would.
/// Source: Gaussian beam and f-number as in Cobbold, Foundations of Biomedical Ultrasound (2007), and Szabo, Diagnostic Ultrasound Imaging
/// (2nd ed. 2014), the chapters on focused fields and arrays. Ours departs: profiles are Gaussian without side lobes, so that the two-way
/// width at a focus is 0.853 L F / D where two even apertures give 0.886; attenuation does not lower the frequency with depth.
/// @param depth_mm below 0 or not a number: counts as 0
[[nodiscard]] double lateralWidth_mm(const BeamModel& model, double depth_mm);

/// Full width at half maximum of what the image must be blurred by at a depth so that it looks like this beam's, mm:
/// strength * sqrt(w^2 - recordedWidth^2), 0 where the recording is not sharper than the beam.
[[nodiscard]] double blurWidth_mm(const BeamModel& model, double depth_mm);

/// One symmetric kernel for each depth (row) of a beam grid.
struct LateralKernels {
  struct Row {
    int radius = 0;         ///< lines on each side; 0: the row stays as it is
    std::size_t first = 0;  ///< weights[first] is the middle one, radius + 1 weights outwards; they sum to 1 with the mirrored ones
  };
  std::vector<Row> rows;
  std::vector<float> weights;  ///< whole multiples of 2^-16: on whole levels 0..255 every sum is exact, in any order
};
/// Gaussian kernels whose full width at half maximum is blurWidth_mm, cut off at three standard deviations and at half of the lines.
/// Below 0.6 lines of standard deviation, where a sampled Gaussian is too narrow, three weights of the same variance. A row whose
/// neighbours would get less than half a grey level of full white has none.
[[nodiscard]] LateralKernels makeLateralKernels(const BeamModel& model, const BeamGrid& grid);

/// Blurs rows [firstRow, firstRow + echoes.height) of the beam grid, in place; at the fan's edges the outermost line goes on. Levels are
/// blurred as they are shown, not as amplitudes. Constants stay, exactly when they are whole levels; so do sums away from the edges. A
/// mirrored row gives the mirrored result and every vector target the same one, to the last bit. A level that is not finite spoils the
/// kernel's radius around it, in its own row alone.
/// @param scratch holds a row; does not allocate when it is large enough already
void blurLaterally(const LateralKernels& kernels, int firstRow, ImageView<float> echoes, std::vector<float>& scratch);

/// How many samples across the image a row is reduced to and stretched back from (the paper's focus): for each row of the beam grid,
/// `lines` where the blur is not wider than a line, otherwise (lines - 1) * line distance / blurWidth_mm + 1, rounded, at least 2. A line
/// met by a sample then becomes a triangle as wide at half of its height as the beam. Cruder than the kernel: from 10 to 90 % an edge
/// measures 0.8 of those widths (1.6 where a sample falls into the edge itself) and not 1.09, and it lies up to half a width beside its
/// place; the mean over all places of the edge is within 10 % of the kernel's width.
void rowResolutions(const BeamModel& model, const BeamGrid& grid, std::vector<int>& samplesOfRow);

/// The paper's focus: each row is undersampled to samplesOfRow[firstRow + y] values and stretched back (Fig. 5), in place. The first line
/// and the last one stay; one sample repeats the first line; as many samples as lines, or more, leave the row as it is. Constants stay,
/// exactly when they are whole levels; interpolated levels are within 0.1; a mirrored row gives the mirrored result and every
/// vector target the same one, to the last bit. A level that is not finite spoils up to three intervals between samples around it, in its
/// own row alone.
/// Source: Aiger & Cohen-Or 1998, "Real-Time Image Generation". Ours differs as stretch() does, and in floats.
/// @param scratch holds a row; does not allocate when it is large enough already
void stretchRows(std::span<const int> samplesOfRow, int firstRow, ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
