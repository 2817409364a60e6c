#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

enum class ProbeKind { linear, convex };

/// A transducer as the simulator needs it; the data files are resources/probes/*.json.
/// The probe frame's origin is the centre of the transducer face: for a convex probe the foremost point of the arc.
struct Probe {
  std::string id;    ///< file name without ending: "convex-3.5"
  std::string name;  ///< as shown: "Convex 3.5 MHz Abdomen"
  ProbeKind kind = ProbeKind::linear;
  double width_mm = 40.0;      ///< linear: length of the face
  double radius_mm = 0.0;      ///< convex: radius of the face's arc; 0 for linear
  double halfAngle_rad = 0.0;  ///< convex: half of the opening angle; 0 for linear
  int lines = 128;             ///< scan lines across the face
  double carrier_hz = 5e6;
  double elevationalThickness_mm = 2.0;  ///< slice thickness at the focus
  double minDepth_mm = 20.0;
  double maxDepth_mm = 100.0;
  double defaultDepth_mm = 60.0;
  bool operator==(const Probe&) const = default;
};

/// @error notFound, badHeader (not JSON), badField (name, value found, value expected)
[[nodiscard]] Result<Probe> readProbe(const std::filesystem::path& file);

/// Every probe of a folder, by name; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<Probe>> readProbes(const std::filesystem::path& folder);

}  // namespace ew
