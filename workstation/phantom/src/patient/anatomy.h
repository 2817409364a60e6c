#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ew/phantom/patient.h"
#include "patient/flow_recipe.h"
#include "patient/motion_recipe.h"
#include "patient/truth_recipe.h"
#include "shapes/shape.h"

namespace ew {

namespace phantom {

/// From which side an organ's surface shines.
enum class Shine {
  glint,    ///< both faces, most where the surface lies square to the beams
  front,    ///< only the face that looks towards the probe, as bone and gas do
  allRound  ///< the same from all sides
};

/// A bright line where an organ's surface reflects.
struct Border {
  double echoLevel = 0.0;
  double width_mm = 1.0;  ///< the line fades to nothing at this distance on both sides
  Shine shine = Shine::glint;
  int sheets = 1;                       ///< parallel lines, the first on the surface, the others within the organ
  double sheetGap_mm = 1.5;             ///< between them
  std::optional<double> fall_deg = {};  ///< of its mirror, as in ReflectingSurface; absent: as its shape and shine have it
  std::optional<double> rough_db = {};  ///< what is rough of it, likewise
};

struct Organ {
  std::string name;
  std::size_t tissue = 0;
  ShapePtr shape;
  std::optional<Border> border;
};

}  // namespace phantom

class Patient {
 public:
  std::string name;
  Bounds box;
  phantom::ShapePtr skin;  ///< the mannequin's surface, kept on a grid around the box
  std::vector<Tissue> tissues;
  std::size_t backgroundTissue = 0;    ///< inside the skin, outside every organ
  std::vector<phantom::Organ> organs;  ///< by priority; at most 254
  glm::dvec2 beamAxis_mm{0.0, 110.0};  ///< x and y of the vertical line that beams from all over the skin run towards: where borders shine
  std::vector<PatientParameter> parameters;
  phantom::ShapesByName shapes;  ///< every shape and organ by name, as drawn
  phantom::Motion motion;
  phantom::Flow flow;
  std::vector<phantom::MeasurementRequest> measurements;
  std::vector<StandardPlane> planes;
  double scattererPitch_mm = 0.5;  ///< of the lattice of scatterers, one in a cell where they are dense: 1 / pitch^3 to the mm3
};

}  // namespace ew
