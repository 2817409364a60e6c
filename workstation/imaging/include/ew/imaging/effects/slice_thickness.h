#pragma once

#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Elevational full width at half maximum of the beam at a depth, mm: the acoustic lens focuses once.
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

/// `planes` (odd, 3..9) planes whose weighted mean stands for the Gaussian elevational profile: offsets and weights of Gauss-Hermite
/// quadrature, so that the profile's moments up to 2 planes - 1 are exact.
[[nodiscard]] std::vector<ElevationPlane> makeElevationPlanes(const Probe& probe, double carrier_hz, const SliceThicknessEffect& effect,
                                                              const BeamGrid& grid, int planes);

/// The rows that sample one such plane: row n of the (samples x lines) picture is line n.
void rowsOf(const BeamGrid& grid, const ElevationPlane& plane, const Transform<frame::Voxel, frame::Probe>& probeToVoxel,
            std::vector<SampleRow>& rows);

}  // namespace ew
