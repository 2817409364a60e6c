#include "elastic/lattice.h"

#include "ew/core/contract.h"

namespace ew::registration {
namespace {

glm::dmat3 stepsOf(const Grid& grid) {
  return {grid.directions[0] * grid.spacing_mm.x, grid.directions[1] * grid.spacing_mm.y, grid.directions[2] * grid.spacing_mm.z};
}

using CellCoefficients = std::array<double, 27>;  // of Bernstein polynomials of degree 2 along each axis, x fastest

/// From values at 0, 1/2, 1 along one axis to Bernstein coefficients: b1 = 2 f(1/2) - (f(0) + f(1)) / 2.
void toBernstein(CellCoefficients& c, std::ptrdiff_t stride, std::ptrdiff_t a, std::ptrdiff_t b) {
  for (std::ptrdiff_t v = 0; v < 3; ++v) {
    for (std::ptrdiff_t u = 0; u < 3; ++u) {
      double* at = c.data() + u * a + v * b;
      at[stride] = 2.0 * at[stride] - 0.5 * (at[0] + at[2 * stride]);
    }
  }
}

CellCoefficients determinantOf(const CellCorners& corner, double scale) {
  // An edge vector along one axis is bilinear in the other two: here at 0, 1/2, 1 of each.
  std::array<glm::dvec3, 9> edge[3];
  constexpr int kStep[3] = {1, 2, 4};
  for (int axis = 0; axis < 3; ++axis) {
    const int along = kStep[axis], first = kStep[axis == 0 ? 1 : 0], second = kStep[axis == 2 ? 1 : 2];
    const auto at = [&](int u, int v) {
      return corner[static_cast<std::size_t>(u * first + v * second + along)] - corner[static_cast<std::size_t>(u * first + v * second)];
    };
    const glm::dvec3 e00 = at(0, 0), e10 = at(1, 0), e01 = at(0, 1), e11 = at(1, 1);
    edge[axis] = {e00, 0.5 * (e00 + e10), e10, 0.5 * (e00 + e01), 0.25 * ((e00 + e10) + (e01 + e11)), 0.5 * (e10 + e11),
                  e01, 0.5 * (e01 + e11), e11};
  }
  CellCoefficients c;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i)
        c[i + 3 * j + 9 * k] = glm::dot(edge[0][j + 3 * k], glm::cross(edge[1][i + 3 * k], edge[2][i + 3 * j])) * scale;
    }
  }
  toBernstein(c, 1, 3, 9);
  toBernstein(c, 3, 1, 9);
  toBernstein(c, 9, 1, 3);
  return c;
}

/// The coefficients on the lower or upper half along an axis (de Casteljau).
CellCoefficients halfOf(const CellCoefficients& c, std::size_t stride, bool upper) {
  CellCoefficients half;
  for (std::size_t n = 0; n < 27; ++n) {
    if (n / stride % 3 != 0) continue;
    const double a = c[n], b = c[n + stride], d = c[n + 2 * stride];
    const double ab = 0.5 * (a + b), bd = 0.5 * (b + d), middle = 0.5 * (ab + bd);
    half[n] = upper ? middle : a;
    half[n + stride] = upper ? bd : ab;
    half[n + 2 * stride] = upper ? d : middle;
  }
  return half;
}

constexpr double kTolerance = 1e-9;
constexpr int kDeepest = 14;  // halvings of each axis: beyond, the bound's distance is below the tolerance of any usable cell

void closeIn(const CellCoefficients& c, int depth, CellExtremes& found) {
  for (std::size_t k = 0; k < 27; k += 18) {
    for (std::size_t j = 0; j < 9; j += 6) {
      for (std::size_t i = 0; i < 3; i += 2) {
        found.smallest = std::min(found.smallest, c[i + j + k]);  // coefficients at corners are values
        found.largest = std::max(found.largest, c[i + j + k]);
      }
    }
  }
  const auto [low, high] = std::minmax_element(c.begin(), c.end());
  if ((*low >= found.smallest - kTolerance && *high <= found.largest + kTolerance) || depth == kDeepest) return;
  for (int child = 0; child < 8; ++child)
    closeIn(halfOf(halfOf(halfOf(c, 1, (child & 1) != 0), 3, (child & 2) != 0), 9, (child & 4) != 0), depth + 1, found);
}

}  // namespace

Lattice::Lattice(const ControlGrid& control)
    : nodes_(&control.nodes), displacement_(&control.displacement_mm), toIndex_(glm::inverse(stepsOf(control.nodes))) {
  EW_EXPECTS(control.displacement_mm.empty() || control.displacement_mm.size() == control.nodes.voxelCount());
}

Lattice::Place Lattice::placeOf(const glm::dvec3& p_mm) const {
  const glm::dvec3 index = nodeIndexOf(p_mm);
  Place place{};
  std::array<std::size_t, 3> low{}, step{};
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(nodes_->dims.x),
                                          static_cast<std::size_t>(nodes_->dims.x) * static_cast<std::size_t>(nodes_->dims.y)};
  for (int axis = 0; axis < 3; ++axis) {
    const int last = nodes_->dims[axis] - 1;
    const double held = std::clamp(index[axis], 0.0, static_cast<double>(last));
    const int cell = std::min(static_cast<int>(held), std::max(last - 1, 0));
    const auto a = static_cast<std::size_t>(axis);
    place.share[axis] = held - cell;
    low[a] = static_cast<std::size_t>(cell) * stride[a];
    step[a] = last > 0 ? stride[a] : 0;
  }
  const std::size_t first = low[0] + low[1] + low[2];
  for (std::size_t n = 0; n < 8; ++n)
    place.corner[n] = first + ((n & 1) != 0 ? step[0] : 0) + ((n & 2) != 0 ? step[1] : 0) + ((n & 4) != 0 ? step[2] : 0);
  return place;
}

glm::dvec3 Lattice::displacementAt(const glm::dvec3& p_mm) const {
  if (displacement_->empty()) return glm::dvec3(0.0);
  const Place place = placeOf(p_mm);
  const auto at = [&](std::size_t n) { return glm::dvec3((*displacement_)[place.corner[n]]); };
  const glm::dvec3 s = place.share;
  const glm::dvec3 low = glm::mix(glm::mix(at(0), at(1), s.x), glm::mix(at(2), at(3), s.x), s.y);
  const glm::dvec3 high = glm::mix(glm::mix(at(4), at(5), s.x), glm::mix(at(6), at(7), s.x), s.y);
  return glm::mix(low, high, s.z);
}

CellExtremes determinantExtremes(const CellCorners& corner, double scale, double knownLow, double knownHigh) {
  CellExtremes found{knownLow, knownHigh};
  closeIn(determinantOf(corner, scale), 0, found);
  return found;
}

double determinantBound(const CellCorners& corner, double scale) {
  const CellCoefficients c = determinantOf(corner, scale);
  return *std::min_element(c.begin(), c.end());
}

glm::ivec3 cellsOf(const Grid& nodes) { return glm::max(nodes.dims - 1, glm::ivec3(1)); }

CellCorners deformedCell(const ControlGrid& control, int i, int j, int k) {
  const glm::dmat3 steps = stepsOf(control.nodes);
  CellCorners corner;
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 at(i + (n & 1), j + (n >> 1 & 1), k + (n >> 2 & 1));
    const glm::ivec3 held = glm::min(at, control.nodes.dims - 1);
    const auto index = static_cast<std::size_t>(n);
    corner[index] =
        steps * glm::dvec3(at - glm::ivec3(i, j, k)) + glm::dvec3(control.displacement_mm[control.nodes.indexOf(held.x, held.y, held.z)]);
  }
  return corner;
}

}  // namespace ew::registration
