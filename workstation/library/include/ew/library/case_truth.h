#pragma once

#include <string>
#include <vector>

#include "ew/library/case.h"

namespace ew {

/// A measurement that a case expects, with the value that its virtual patient has exactly.
struct ReferenceMeasurement {
  std::string name;                   ///< "aorta, largest outer diameter"
  std::string kind;                   ///< "distance", "diameter", "circumference", "volume" ...
  double value = 0.0;                 ///< in `unit`
  std::string unit;                   ///< "mm" or "ml"
  std::optional<double> tolerance;    ///< in `unit`, where the case gives one
  std::vector<glm::dvec3> points_mm;  ///< where calipers go, in the world; empty for volumes
  std::string plane;                  ///< the standard plane it is taken in, or empty
  bool operator==(const ReferenceMeasurement&) const = default;
};

struct ReferencePlane {
  std::string name;
  Transform<frame::World, frame::Probe> probeToWorld = {};
  double positionTolerance_mm = 10.0;
  double angleTolerance_deg = 15.0;
  std::vector<std::string> shows;  ///< organs that are cut by it
  bool operator==(const ReferencePlane&) const = default;
};

struct ReferencePoint {
  std::string name;
  glm::dvec3 at_mm{0.0};
  double tolerance_mm = 10.0;
  bool operator==(const ReferencePoint&) const = default;
};

struct ReferenceStructure {
  std::string name;
  std::string organ;
  int label = 0;  ///< in the case's label volume
  bool operator==(const ReferenceStructure&) const = default;
};

/// What a lesson compares a trainee's work with, in the world as the case is placed (file_to_world applied).
struct CaseTruth {
  std::vector<ReferencePoint> points;
  std::vector<ReferencePlane> planes;  ///< the case's targets, in their order
  std::vector<ReferenceStructure> structures;
  std::vector<ReferenceMeasurement> measurements;  ///< those the case names, in its order
  bool operator==(const CaseTruth&) const = default;
};

/// The targets and expected measurements of a case. What only the virtual patient knows is kept in the cache beside the prepared volume,
/// and worked out from the patient when it is not there.
/// @error badField (a plane, organ or measurement that the patient does not have, with the names it has), as readPatient; cancelled
[[nodiscard]] Result<CaseTruth> loadCaseTruth(const Case& opened, Progress& progress);

}  // namespace ew
