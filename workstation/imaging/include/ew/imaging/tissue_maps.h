#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ew/core/volume.h"

namespace ew {

/// How a surface between tissues sends sound back: like a mirror where the beam meets it square, and what is rough of it into a wide lobe.
struct ReflectingSurface {
  std::string name;  ///< "liver", as in the patient's list of organs
  double echoLevel =
      200.0;  ///< grey level of its echo where it lies square to the beam, on the scale of TissueMaps::level; above 255 possible
  double thickness_mm = 0.8;    ///< full width at half maximum of the layer that echoes
  double fall_deg = 9.0;        ///< the mirror's amplitude falls with the incidence b as exp(-sin^2 b / (2 sin^2 fall_deg))
  double rough_db = -12.0;      ///< what is rough of it sends back square to the beam, below echoLevel ...
  double roughFall_deg = 26.0;  ///< ... and falls as the mirror does, only slower: so that it is seen 30 to 40 degrees off
  int sheets = 1;               ///< one behind the other, each a little fainter: peritoneum, muscle and pleura of a diaphragm; 1 to 4
  double sheetGap_mm = 1.5;     ///< between them, into the surface's organ
  bool frontOnly = false;       ///< bone, stone, gas: seen from outside alone
  bool operator==(const ReflectingSurface&) const = default;
};

/// Tissue as it is known, before any machine looks at it: maps on one grid, from which every frame forms its echoes anew
/// (effects/live_echoes.h). No speckle, no shadow, nothing that depends on where the probe is.
struct TissueMaps {
  Grid grid;

  /// Per voxel the mean grey level that fully developed speckle of this tissue has after log compression, 255 full white, 60 dB to black,
  /// without the echo of surfaces; 0: sends nothing back (outside the body too).
  std::vector<std::uint8_t> level;

  /// Per voxel the signed distance to the nearest reflecting surface, negative inside the organ that owns it: 128 + 32 per mm, 1 to 255;
  /// 0 where none is within kSurfaceReach_mm. Empty: no surfaces are known.
  std::vector<std::uint8_t> surfaceDistance;
  /// Per voxel 1 + the number of that surface in `surfaces`; 0: none.
  std::vector<std::uint8_t> surfaceKind;
  std::vector<ReflectingSurface> surfaces;

  /// The level is that of a recorded volume (tissue_level.h), on the volume's grid: images may keep the volume's own grain.
  bool isRecorded = false;

  static constexpr double kDistanceStepsPerMm = 32.0;
  static constexpr double kSurfaceReach_mm = 3.9;
  bool operator==(const TissueMaps&) const = default;
};

}  // namespace ew
