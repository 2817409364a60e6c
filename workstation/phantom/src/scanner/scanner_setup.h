#pragma once

#include <cmath>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/phantom/virtual_scanner.h"
#include "scanner/beams.h"
#include "scanner/formation_kernels.h"

namespace ew::phantom {

inline constexpr double kLateralReach = 3.0;      ///< standard deviations of the lateral beam
inline constexpr double kElevationalReach = 2.2;  ///< of the elevational one: what is left out has less than a hundredth of the power
inline constexpr std::size_t kChunk = 32;         ///< columns whose lateral width is taken as one

/// Of an amplitude.
inline double factorOf(double loss_db) { return std::pow(10.0, -0.05 * loss_db); }

/// Where the lines lie.
struct Fan {
  bool sector = false;
  double apex_mm = 0.0;
  double halfAngle_rad = 0.0;
  double halfWidth_mm = 0.0;
  double depth_mm = 0.0;
};

/// What a virtual machine knows before its first frame: the fine grid on which echoes are added up, the weights of its beams and of its
/// pulse, its gains, and what each tissue takes from a line. Rows of the grid run across the lines, columns along them.
struct ScannerSetup {
  Probe probe;
  FormationOptions options;
  BeamGrid grid;
  Beams beams;
  Fan fan = {};
  Gridding gridding = {};
  int rowsPerLine = 4;
  int rowPadding = 0;
  int columnPadding = 0;
  std::size_t columns = 0;
  std::vector<std::vector<float>> lateral = {};  ///< by distance in rows: a weight per column, twice
  std::vector<int> reachOfChunk = {};            ///< in rows
  std::vector<float> pulse = {};                 ///< by distance in columns
  std::vector<std::vector<float>> turns = {};    ///< by look: the phase that brings its carrier to the middle, per column
  double lookScale = 1.0;
  std::vector<float> mirrorScale = {};  ///< per column: of a plane mirror's echo
  std::vector<float> depthGain = {};    ///< per sample
  std::vector<float> ring = {};         ///< per sample: the transmit pulse's own, near the face
  double step_mm = 0.5;                 ///< of the walk along a line that sums up losses
  int steps = 0;
  std::vector<double> lostPerStep_db = {};    ///< by tissue, both ways
  std::vector<double> lostAtSurface_db = {};  ///< by tissue that is entered
  std::vector<double> delayPerStep_mm = {};

  [[nodiscard]] double rowSpacing_mm(double depth_mm) const { return grid.lineSpacing_mm(depth_mm) / rowsPerLine; }
  /// Of the lateral beam, in rows.
  [[nodiscard]] double rowSigma(double depth_mm) const;
  /// How far beside the slice the beam sees at a depth, and at most between two.
  [[nodiscard]] double reach_mm(double depth_mm) const;
  [[nodiscard]] double reachBetween_mm(double nearer_mm, double farther_mm) const;
};

/// @param options  with every 0 replaced
/// @param grid     at least two lines and samples
/// @param pitch_mm of the scatterers
[[nodiscard]] ScannerSetup scannerSetupOf(const Patient& patient, const Probe& probe, const FormationOptions& options, BeamGrid grid,
                                          double pitch_mm);

}  // namespace ew::phantom
