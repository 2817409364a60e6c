#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/core/image.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/slicing.h"

namespace ew {

/// Echo levels on the beam grid: width = scan lines (from the -x end of the face to the +x end), height = samples (from the face down).
/// So a row holds one depth of all lines: what acts along depth goes from row to row, and both are vector code. Levels are floats, 0..255
/// at the ends of a chain and anything finite within it.
using BeamImage = Image<float>;

/// Where the scan lines of a probe lie, and where along them samples are taken. Depth 0 is the face, along the line itself.
struct BeamGrid {
  struct Line {
    glm::dvec2 origin_mm{0.0};       ///< on the face, x and y of the probe frame
    glm::dvec2 direction{0.0, 1.0};  ///< unit vector
    bool operator==(const Line&) const = default;
  };
  std::vector<Line> lines;  ///< probe.lines of them, >= 2
  int samples = 0;          ///< >= 2; sample s lies at depth s * sampleSpacing_mm
  double sampleSpacing_mm = 0.0;
  bool operator==(const BeamGrid&) const = default;

  [[nodiscard]] double depth_mm(double sample) const { return sample * sampleSpacing_mm; }
  /// Distance between neighbouring lines at a depth, measured across them, mm.
  [[nodiscard]] double lineSpacing_mm(double depth_mm) const;
};

/// The grid of a probe at a depth. Steering and trapezoid act on linear probes alone.
/// @param sampleSpacing_mm wanted; made smaller so that the last sample lies at depth_mm exactly
/// @param look_rad how far all lines are steered beyond that, on any probe: one direction of a compound image
[[nodiscard]] BeamGrid makeBeamGrid(const Probe& probe, const Knobs& knobs, double depth_mm, double sampleSpacing_mm,
                                    double look_rad = 0.0);

/// Line and sample, both fractional, of a point of the image plane: the inverse of the grid in closed form. Outside the fan they lie
/// outside [0, lines - 1] or [0, samples - 1].
/// @param p_mm x and y of the probe frame
/// @param look_rad with which the grid was made
[[nodiscard]] glm::dvec2 lineAndSampleAt(const Probe& probe, const Knobs& knobs, const BeamGrid& grid, const glm::dvec2& p_mm,
                                         double look_rad = 0.0);

/// The rows of samples that sampleRows takes to fill a (samples x lines) image: row n of it is line n.
/// @param elevation_mm offset of each sample along the probe's z, as a straight line over depth: at the face and at the last sample
/// @param rows resized to the lines of the grid
void rowsOf(const BeamGrid& grid, const Transform<frame::Voxel, frame::Probe>& probeToVoxel, glm::dvec2 elevation_mm,
            std::vector<SampleRow>& rows);

}  // namespace ew
