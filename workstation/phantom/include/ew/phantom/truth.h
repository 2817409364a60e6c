#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"

namespace ew {

/// A length, circumference or volume that the anatomy has exactly (to the stated accuracy of its kind), for a lesson's expected values.
struct TrueMeasurement {
  std::string name;                   ///< "aorta, largest outer diameter"
  std::string kind;                   ///< "distance", "diameter", "circumference", "volume" ...: what a user would do with calipers
  double value = 0.0;                 ///< in `unit`
  std::string unit;                   ///< "mm" or "ml"
  std::vector<glm::dvec3> points_mm;  ///< where calipers go, in the world; empty for volumes
  std::string plane;                  ///< name of the standard plane it is taken in, or empty
};

/// A plane that examinations of this region ask for.
struct StandardPlane {
  std::string name;                                    ///< "transverse at the aneurysm"
  Transform<frame::World, frame::Probe> probeToWorld;  ///< the face on the skin; the plane is z = 0 of the probe frame
  double positionTolerance_mm = 10.0;
  double angleTolerance_deg = 15.0;
  std::vector<std::string> shows;  ///< organs that must be cut by it
};

/// The measurements that the recipe asks for, computed from its shapes as they are at a moment; places and centre lines move along.
/// Lengths are right within 0.05 mm for what the shapes draw; volumes are what an organ owns, within 1 % down to 1 ml.
/// @error badField (a line that does not cross what it measures, a place outside of it), cancelled
[[nodiscard]] Result<std::vector<TrueMeasurement>> measurementsOf(const Patient& patient, const BodyState& state = {},
                                                                  Progress& progress = noProgress());

[[nodiscard]] std::vector<StandardPlane> planesOf(const Patient& patient);

/// Surface of a named organ or shape at rest, as it was drawn, inside the patient's box: closed, its triangles' fronts outwards, its points
/// on the surface within a hundredth of `edge_mm`. Parts thinner than `edge_mm` may be missed.
/// @error badField (no such organ, edge), tooLarge, cancelled
[[nodiscard]] Result<SurfaceMesh> surfaceOf(const Patient& patient, const std::string& organ, double edge_mm, Progress& progress);

}  // namespace ew
