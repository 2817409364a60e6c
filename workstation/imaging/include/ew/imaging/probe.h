#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

enum class ProbeKind {
  linear,       ///< parallel lines from a straight face; may steer, may fan out to a trapezoid
  convex,       ///< lines perpendicular to an arc
  phased,       ///< all lines from the middle of a small straight face
  endocavity,   ///< a convex arc of small radius and wide opening at the end of a rod
  sweptSector,  ///< one element swung about an axis behind the face by a motor
};

/// A transducer as the simulator needs it; the data files are resources/probes/*.json.
/// The probe frame's origin is the centre of the transducer face: for a curved one the foremost point of the arc.
struct Probe {
  std::string id;    ///< file name without ending: "convex-3.5"
  std::string name;  ///< as shown: "Convex 3.5 MHz Abdomen"
  ProbeKind kind = ProbeKind::linear;
  double width_mm = 40.0;                ///< length of the face; of a curved one radius and angle decide (faceLength_mm)
  double radius_mm = 0.0;                ///< all but linear: from the point where the lines meet to the face; 0 for phased
  double halfAngle_rad = 0.0;            ///< all but linear: half of the opening angle
  int lines = 128;                       ///< scan lines across the face
  double carrier_hz = 5e6;               ///< the frequency at start
  std::vector<double> carriers_hz = {};  ///< what the console may choose from, rising, carrier_hz among them; empty: carrier_hz alone
  double aperture_mm = 20.0;             ///< widest active part of the face, lateral: decides how sharp a focus can be
  double elevationalThickness_mm = 2.0;  ///< slice thickness (full width at half maximum) at the elevational focus
  double elevationalFocus_mm = 60.0;     ///< depth of the acoustic lens' focus
  double elevationalAperture_mm = 10.0;  ///< height of the elements: the slice thickness at the face
  double nearField_mm = 2.0;             ///< dead zone below the face, filled by the transmit pulse's ringing
  double maxSteering_rad = 0.0;          ///< linear: 0 when it cannot steer
  double trapezoidHalfAngle_rad = 0.0;   ///< linear: 0 when it cannot fan out
  double minDepth_mm = 20.0;
  double maxDepth_mm = 100.0;
  double defaultDepth_mm = 60.0;
  bool operator==(const Probe&) const = default;
};

/// Whether the lines meet in one point behind the face (everything but a linear probe).
[[nodiscard]] inline bool isSector(ProbeKind kind) { return kind != ProbeKind::linear; }

/// Length of the face along itself, mm.
[[nodiscard]] double faceLength_mm(const Probe& probe);
/// Half of the face's lateral extent, and how far its ends lie behind its foremost point (0 for a straight face), mm.
[[nodiscard]] double faceHalfWidth_mm(const Probe& probe);
[[nodiscard]] double faceSagitta_mm(const Probe& probe);
/// `count` >= 2 points of the face in the probe frame, evenly from the -x end to the +x end.
[[nodiscard]] std::vector<glm::dvec3> facePoints_mm(const Probe& probe, int count);

/// @error notFound, badHeader (not JSON), badField (name, value found, value expected)
[[nodiscard]] Result<Probe> readProbe(const std::filesystem::path& file);

/// Every probe of a folder, by name; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<Probe>> readProbes(const std::filesystem::path& folder);

}  // namespace ew
