#pragma once

#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Elevational full width at half maximum of the beam at a depth, mm: the acoustic lens focuses once. With z the depth, F the lens' focus,
/// A the height of the elements, T the thickness at the focus (of the probe's own frequency f0) and f the frequency in use
///   w = scale * sqrt((A (1 - z / F))^2 + (T (f0 / f) z / F)^2)
/// A at the face, T at the focus with the probe's own frequency. It is the beam of a Gaussian aperture in Fresnel's approximation with
/// both widths taken from the probe's data instead of from each other.
/// Source: Cobbold, Foundations of Biomedical Ultrasound (2007), Gaussian beams. Ours departs: A and T count for both ways together.
/// @param carrier_hz 0, less or not a number: the probe's own
/// @param depth_mm   below 0 or not a number: counts as 0; so does effect.scale
[[nodiscard]] double elevationalWidth_mm(const Probe& probe, double carrier_hz, const SliceThicknessEffect& effect, double depth_mm);

/// A plane of samples beside the image plane. Its offset runs in straight pieces along depth, so that a scan line in it is a few rows for
/// sampleRows.
struct ElevationPlane {
  struct Piece {
    int firstSample = 0;
    int lastSample = 0;           ///< included
    double offsetAtFirst_mm = 0;  ///< along the probe's z
    double offsetAtLast_mm = 0;
  };
  std::vector<Piece> pieces;
  float weight = 1.0F;  ///< the planes' weights sum to 1
};

/// Offsets, in standard deviations, and weights of planes that stand for the mean under a normal distribution: evenly spaced, with weights
/// that fall off like a bell such that the variance is exactly 1. The middle first, then pairs outwards, the positive one first.
/// Gauss-Hermite quadrature, exact on polynomials, was tried and left: its outer planes lie far out and weigh next to nothing, and echoes
/// are speckle, not polynomials. Where the speckle's correlation has 0.4 of the beam's standard deviation, its mean error with 3, 5, 7, 9
/// planes is 0.46, 0.33, 0.25, 0.18 of the speckle's own standard deviation, ours 0.34, 0.11, 0.045, 0.024; on fields smoother than the
/// beam it is the better one, but there both are below 0.06.
struct ElevationRule {
  std::vector<double> offset_sigmas;
  std::vector<double> weights;
};
/// @param planes odd, 3..9
[[nodiscard]] ElevationRule elevationRule(int planes);

/// `planes` planes whose weighted mean stands for the Gaussian elevational profile (elevationRule). Their weights are rounded to whole
/// multiples of 2^-16 that sum to 1, so that mean levels are exact whatever the order of the planes: turning the probe by 180 degrees
/// swaps planes and mirrors the image to the last bit.
/// The offsets' pieces are exact at both ends; between, the width is at most 3 % too wide.
/// @param planes 3..9; others are taken as the next odd number within
[[nodiscard]] std::vector<ElevationPlane> makeElevationPlanes(const Probe& probe, double carrier_hz, const SliceThicknessEffect& effect,
                                                              const BeamGrid& grid, int planes);

/// The rows that sample one such plane: row n of the (samples x lines) image is line n, piece after piece.
/// @param rows resized to the lines of the grid times the pieces
void rowsOf(const BeamGrid& grid, const ElevationPlane& plane, const Transform<frame::Voxel, frame::Probe>& probeToVoxel,
            std::vector<SampleRow>& rows);

/// Adds a plane's levels times its weight to the echoes, turning lines as rows into lines as columns.
/// @param linesAsRows (samples x lines), as sampleRows fills it
/// @param first       the echoes are overwritten instead of added to
/// @param echoes      (lines x samples)
/// With the weights of makeElevationPlanes, or a weight of 1, the sums are exact.
void accumulatePlane(ImageView<const std::uint8_t> linesAsRows, float weight, bool first, ImageView<float> echoes);

}  // namespace ew
