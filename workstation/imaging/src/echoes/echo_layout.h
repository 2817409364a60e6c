#pragma once

#include <cstdint>
#include <vector>

#include "echo_beams.h"
#include "ew/imaging/beam_grid.h"
#include "probes/fan_shape.h"

namespace ew::detail {

/// Columns along the lines that are filtered together: their part of the fine grid stays in the processor's second cache.
inline constexpr int kTileColumns = 64;

/// Two looks whose carriers lie as far above the pulse's own as below: y+- = sum over t of pulse[t] exp(-+i turn t) x[t] = A -+ i B, where
///   A = sum of cosine[|t|] x[t],  B = sum of sign(t) sine[|t|] x[t]
struct LookPair {
  std::vector<float> cosine;  ///< by distance in columns: pulse[t] cos(turn t)
  std::vector<float> sine;    ///< pulse[t] sin(turn t)
  float share = 1.0F;         ///< of the envelope of each
};

/// What live echoes know before the first frame: the fine grid on which scatterers are added up, rows across the lines and columns along
/// them, and the weights of the beams and of the pulse.
struct EchoLayout {
  EchoBeams beams;
  BeamGrid grid;
  FanShape fan;
  FanShape face;  ///< the same without any steering: how the face presses
  double depth_mm = 0.0;
  LiveEchoesEffect effect;
  int planes = 3;         ///< of the slice in which losses and surfaces are followed: three, or the middle alone
  double pitch_mm = 0.8;  ///< of the lattice that has one scatterer in each cell

  int rowsPerLine = 2;
  int rowPadding = 0;
  int rows = 0;
  int columnPadding = 0;
  int columns = 0;
  int tiles = 0;  ///< of kTileColumns

  /// Lateral beam, symmetric: by tile, by distance in rows 0 .. reachOfTile, a weight per column, twice (real and imaginary parts).
  std::vector<std::vector<float>> lateral;
  std::vector<int> reachOfTile;
  std::vector<float> focusFactor;  ///< by column: what focus and harmonics do to amplitudes (EchoBeams::beamGain_db); in `lateral` already
  std::vector<float> pulse;        ///< by distance in columns
  std::vector<LookPair> lookPairs;
  float middleShare = 1.0F;  ///< of the envelope at the carrier itself; 0: no look is there
  double lookScale = 1.0;    ///< keeps the mean level that one look has

  [[nodiscard]] double depthOfColumn_mm(double column) const { return (column - columnPadding) * grid.sampleSpacing_mm; }
  [[nodiscard]] double rowSpacing_mm(double atDepth_mm) const { return grid.lineSpacing_mm(atDepth_mm) / rowsPerLine; }
};

/// Distance of samples along a line that the pulse of these beams asks for.
[[nodiscard]] double echoSpacing_mm(const EchoBeams& beams, const LiveEchoesEffect& effect);

/// Pitch of the lattice of scatterers: as few as the smallest resolution cell needs with the usual focus, so that who turns the focus sees
/// the same scatterers.
[[nodiscard]] double echoPitch_mm(const EchoBeams& beams, double depth_mm, double scatterersPerCell);

/// EchoLayout::planes at the price that a quality names. With one, steps of losses and rows of the fine grid are wider too.
[[nodiscard]] inline int echoPlanesOf(Quality quality) { return quality == Quality::weave ? 1 : 3; }

/// @param grid made with echoSpacing_mm and this look
[[nodiscard]] EchoLayout echoLayoutOf(const Probe& probe, const Knobs& knobs, const LiveEchoesEffect& effect, const EchoBeams& beams,
                                      BeamGrid grid, double look_rad);

/// What 0..255 of TissueMaps::level span.
inline constexpr double kLevelRange_db = 60.0;

/// Of the mean of an exponential variable's logarithm, below the logarithm of its mean.
inline constexpr double kMeanOfLog_db = 2.507;

}  // namespace ew::detail
