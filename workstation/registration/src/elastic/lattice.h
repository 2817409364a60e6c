#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "ew/registration/deformation.h"

namespace ew::registration {

/// A control grid made ready for many questions. Borrows it.
class Lattice {
 public:
  explicit Lattice(const ControlGrid& control);

  [[nodiscard]] glm::dvec3 displacementAt(const glm::dvec3& p_mm) const;
  [[nodiscard]] glm::dvec3 nodeIndexOf(const glm::dvec3& p_mm) const { return toIndex_ * (p_mm - nodes_->origin_mm); }

 private:
  struct Place {
    std::array<std::size_t, 8> corner;
    glm::dvec3 share;
  };
  [[nodiscard]] Place placeOf(const glm::dvec3& p_mm) const;

  const Grid* nodes_;
  const std::vector<glm::vec3>* displacement_;
  glm::dmat3 toIndex_;
};

/// Corners of a cell, x fastest: (0,0,0), (1,0,0), (0,1,0) ...
using CellCorners = std::array<glm::dvec3, 8>;

/// Extremes of the Jacobian determinant of the trilinear map that takes a unit cube to `corner`, divided by `scale`.
/// The determinant is a polynomial of degree 2 along each axis; its Bernstein coefficients bound it, and halving the cell closes in on
/// the extremes until they are known to `tolerance`. Cells whose bounds lie within [knownLow, knownHigh] are not looked into further.
struct CellExtremes {
  double smallest;
  double largest;
};
[[nodiscard]] CellExtremes determinantExtremes(const CellCorners& corner, double scale, double knownLow, double knownHigh);

/// A lower bound of the same that costs no subdivision: the smallest Bernstein coefficient.
[[nodiscard]] double determinantBound(const CellCorners& corner, double scale);

/// Corners of the deformed cell (i, j, k), in mm. Along an axis with one node the cell is one spacing thick.
[[nodiscard]] CellCorners deformedCell(const ControlGrid& control, int i, int j, int k);
[[nodiscard]] glm::ivec3 cellsOf(const Grid& nodes);

}  // namespace ew::registration
