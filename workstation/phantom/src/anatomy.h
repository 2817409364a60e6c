#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ew/phantom/patient.h"
#include "shape.h"

namespace ew {

namespace phantom {

/// A bright line where an organ's surface reflects.
struct Border {
  double echoLevel = 0.0;
  double width_mm = 1.0;   ///< the line fades to nothing at this distance on both sides
  glm::dvec3 facing{0.0};  ///< unit vector: only surfaces whose outward normal looks this way shine; zero: all do
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
  std::uint64_t fingerprint = 0;
};

}  // namespace ew
