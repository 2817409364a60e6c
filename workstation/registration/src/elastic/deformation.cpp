#include "ew/registration/deformation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elastic/lattice.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "trilinear_cell.h"

namespace ew::registration {
namespace {

double determinantOf(const Grid& grid) {
  return glm::determinant(grid.directions) * grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z;
}

/// Whether the rows of `grid` run along lines of nodes, so that a displacement along a row is piecewise linear with known knees.
bool alongNodes(const Grid& grid, const Grid& nodes) {
  for (int axis = 0; axis < 3; ++axis) {
    if (glm::distance(grid.directions[axis], nodes.directions[axis]) > 1e-12) return false;
  }
  return true;
}

/// Displacements of the row (j, k) of `grid`, whose axes are those of the nodes: the nodes' line is blended once, then walked along.
void fillRow(const ControlGrid& control, const Lattice& lattice, const Grid& grid, int j, int k, std::vector<glm::dvec3>& line,
             glm::dvec3* out) {
  const glm::dvec3 first = lattice.nodeIndexOf(grid.origin_mm + grid.directions * (grid.spacing_mm * glm::dvec3(0, j, k)));
  const glm::ivec3 dims = control.nodes.dims;
  int low[2], high[2];
  double share[2];
  for (int n = 0; n < 2; ++n) {
    const int last = dims[n + 1] - 1;
    const double held = std::clamp(first[n + 1], 0.0, static_cast<double>(last));
    low[n] = std::min(static_cast<int>(held), std::max(last - 1, 0));
    high[n] = std::min(low[n] + 1, last);
    share[n] = held - low[n];
  }
  line.resize(static_cast<std::size_t>(dims.x));
  for (int i = 0; i < dims.x; ++i) {
    const auto at = [&](int y, int z) { return glm::dvec3(control.displacement_mm[control.nodes.indexOf(i, y, z)]); };
    line[static_cast<std::size_t>(i)] = glm::mix(glm::mix(at(low[0], low[1]), at(high[0], low[1]), share[0]),
                                                 glm::mix(at(low[0], high[1]), at(high[0], high[1]), share[0]), share[1]);
  }
  const double step = grid.spacing_mm.x / control.nodes.spacing_mm.x;
  for (int i = 0; i < grid.dims.x; ++i) {
    const double held = std::clamp(first.x + i * step, 0.0, static_cast<double>(dims.x - 1));
    const auto cell = static_cast<std::size_t>(std::min(static_cast<int>(held), std::max(dims.x - 2, 0)));
    out[i] = glm::mix(line[cell], line[std::min(cell + 1, line.size() - 1)], held - static_cast<double>(cell));
  }
}

/// Calls row(j, k, first point, step, displacements) for every row of `grid` of slice k; displacements in mm, one per voxel.
template <class Row>
void forEachRow(const ControlGrid& control, const Grid& grid, int k, const Row& row) {
  const Lattice lattice(control);
  const bool aligned = !control.displacement_mm.empty() && alongNodes(grid, control.nodes);
  const glm::dvec3 step = grid.directions[0] * grid.spacing_mm.x;
  std::vector<glm::dvec3> line, displacement(static_cast<std::size_t>(grid.dims.x));
  for (int j = 0; j < grid.dims.y; ++j) {
    const glm::dvec3 first = grid.origin_mm + grid.directions * (grid.spacing_mm * glm::dvec3(0, j, k));
    if (aligned) {
      fillRow(control, lattice, grid, j, k, line, displacement.data());
    } else if (!control.displacement_mm.empty()) {
      for (int i = 0; i < grid.dims.x; ++i)
        displacement[static_cast<std::size_t>(i)] = lattice.displacementAt(first + step * static_cast<double>(i));
    }
    row(j, first, step, displacement);
  }
}

}  // namespace

glm::dvec3 displacementAt(const ControlGrid& control, const glm::dvec3& p_mm) {
  if (control.displacement_mm.empty()) return glm::dvec3(0.0);
  return Lattice(control).displacementAt(p_mm);
}

void displace(const ControlGrid& control, std::span<glm::dvec3> points_mm) {
  if (control.displacement_mm.empty()) return;
  const Lattice lattice(control);
  for (glm::dvec3& p : points_mm) p += lattice.displacementAt(p);
}

glm::dvec3 movingPoint(const Deformation& fixedToMoving, const glm::dvec3& fixed_mm) {
  return carried(fixedToMoving.rigid, fixed_mm + displacementAt(fixedToMoving.control, fixed_mm));
}

Result<DisplacementField> fieldOf(const Deformation& fixedToMoving, const Grid& fixedGrid, int threads, Progress& progress) {
  if (auto usable = checkGrid(fixedGrid); !usable) return passOn(usable.error());
  DisplacementField field{fixedGrid, {}};
  field.displacement_mm.resize(fixedGrid.voxelCount());
  const glm::dmat3 turn(fixedToMoving.rigid.matrix);
  const glm::dvec3 shift(fixedToMoving.rigid.matrix[3]);
  const bool finished = forEachTask(fixedGrid.dims.z, threads, progress, say<"Writing out the displacements">(), [&](int k) {
    forEachRow(fixedToMoving.control, fixedGrid, k,
               [&](int j, const glm::dvec3& first, const glm::dvec3& step, const std::vector<glm::dvec3>& displacement) {
                 glm::vec3* out = field.displacement_mm.data() + fixedGrid.indexOf(0, j, k);
                 for (int i = 0; i < fixedGrid.dims.x; ++i) {
                   const glm::dvec3 p = first + step * static_cast<double>(i);
                   out[i] = glm::vec3(turn * (p + displacement[static_cast<std::size_t>(i)]) + shift - p);
                 }
               });
  });
  if (!finished) return failure(ErrorCode::cancelled, say<"Writing out the displacements was cancelled.">());
  return field;
}

JacobianSummary jacobianOf(const ControlGrid& control) {
  JacobianSummary summary;
  if (control.displacement_mm.empty()) return summary;
  EW_EXPECTS(control.displacement_mm.size() == control.nodes.voxelCount());
  CellExtremes all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const double scale = 1.0 / determinantOf(control.nodes);
  const glm::ivec3 cells = cellsOf(control.nodes);
  for (int k = 0; k < cells.z; ++k) {
    for (int j = 0; j < cells.y; ++j) {
      for (int i = 0; i < cells.x; ++i) {
        const CellCorners corner = deformedCell(control, i, j, k);
        all = determinantExtremes(corner, scale, all.smallest, all.largest);
        if (determinantBound(corner, scale) > 0.0) continue;
        // The bound is not the smallest value: only the extremes of this cell alone tell.
        const CellExtremes own =
            determinantExtremes(corner, scale, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
        if (own.smallest <= 0.0) ++summary.folded;
      }
    }
  }
  summary.smallest = all.smallest;
  summary.largest = all.largest;
  return summary;
}

JacobianSummary jacobianOf(const DisplacementField& field) {
  JacobianSummary summary;
  if (field.displacement_mm.empty()) return summary;
  const Grid& grid = field.grid;
  EW_EXPECTS(field.displacement_mm.size() == grid.voxelCount());
  summary.smallest = std::numeric_limits<double>::infinity();
  summary.largest = -summary.smallest;
  glm::dmat3 steps(grid.directions);
  for (int axis = 0; axis < 3; ++axis) steps[axis] *= grid.spacing_mm[axis];
  const double scale = 1.0 / glm::determinant(steps);
  const glm::ivec3 dims = grid.dims;
  for (int k = 0; k < dims.z; ++k) {
    for (int j = 0; j < dims.y; ++j) {
      for (int i = 0; i < dims.x; ++i) {
        glm::dmat3 edge = steps;
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 before(i, j, k), behind(i, j, k);
          before[axis] = std::max(before[axis] - 1, 0);
          behind[axis] = std::min(behind[axis] + 1, dims[axis] - 1);
          const int apart = behind[axis] - before[axis];
          if (apart == 0) continue;
          edge[axis] += (glm::dvec3(field.displacement_mm[grid.indexOf(behind.x, behind.y, behind.z)]) -
                         glm::dvec3(field.displacement_mm[grid.indexOf(before.x, before.y, before.z)])) /
                        static_cast<double>(apart);
        }
        const double determinant = glm::determinant(edge) * scale;
        summary.smallest = std::min(summary.smallest, determinant);
        summary.largest = std::max(summary.largest, determinant);
        if (determinant <= 0.0) ++summary.folded;
      }
    }
  }
  return summary;
}

Result<Volume> warped(const Volume& moving, const Deformation& fixedToMoving, const Grid& fixedGrid, int threads, Progress& progress) {
  if (auto usable = checkGrid(fixedGrid); !usable) return passOn(usable.error());
  if (auto usable = checkGrid(moving.grid); !usable) return passOn(usable.error());
  if (moving.echo.size() != moving.grid.voxelCount() || (!moving.coverage.empty() && moving.coverage.size() != moving.echo.size()))
    return failure(ErrorCode::badField, say<"The moving volume holds another number of voxels than its grid says; write it anew.">());
  Volume out{fixedGrid, {}, {}};
  out.echo.resize(fixedGrid.voxelCount());
  out.coverage.resize(fixedGrid.voxelCount());
  const auto toVoxel = moving.grid.toVoxel<frame::Moving>() * fixedToMoving.rigid;
  const bool finished = forEachTask(fixedGrid.dims.z, threads, progress, say<"Warping the moving volume">(), [&](int k) {
    forEachRow(fixedToMoving.control, fixedGrid, k,
               [&](int j, const glm::dvec3& first, const glm::dvec3& step, const std::vector<glm::dvec3>& displacement) {
                 const std::size_t row = fixedGrid.indexOf(0, j, k);
                 for (int i = 0; i < fixedGrid.dims.x; ++i) {
                   const glm::dvec3 p = first + step * static_cast<double>(i) + displacement[static_cast<std::size_t>(i)];
                   const auto cell = cellAt(moving.grid, carried(toVoxel, p));
                   if (!cell) continue;
                   double sum = 0.0, weight = 0.0;
                   bool measured = true;
                   cell->visit(moving.grid, [&](std::size_t at, double part) {
                     const Coverage coverage = moving.coverageAt(at);
                     if (coverage != Coverage::measured) measured = false;
                     if (coverage == Coverage::absent) return true;
                     sum += part * moving.echo[at];
                     weight += part;
                     return true;
                   });
                   if (weight < 0.5) continue;
                   const auto index = row + static_cast<std::size_t>(i);
                   out.echo[index] = static_cast<std::uint8_t>(std::lround(sum / weight));
                   out.coverage[index] = static_cast<std::uint8_t>(measured ? Coverage::measured : Coverage::interpolated);
                 }
               });
  });
  if (!finished) return failure(ErrorCode::cancelled, say<"Warping the moving volume was cancelled.">());
  return out;
}

}  // namespace ew::registration
