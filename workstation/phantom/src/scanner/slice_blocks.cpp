#include "scanner/slice_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ew::phantom {
namespace {

constexpr std::size_t kBlocksPerQuestion = 16;

/// Whether a ball in the probe frame may touch what the beams see.
bool seen(const ScannerSetup& setup, const glm::dvec3& centre, double radius) {
  double depth = centre.y, beside = std::abs(centre.x) - setup.fan.halfWidth_mm;
  if (setup.fan.sector) {
    const double x = centre.x, y = centre.y + setup.fan.apex_mm, rho = std::sqrt(x * x + y * y);
    depth = rho - setup.fan.apex_mm;
    const double over = std::abs(std::atan2(x, y)) - setup.fan.halfAngle_rad;
    beside = over <= 0.0 ? 0.0 : (over < 0.5 * std::numbers::pi ? rho * std::sin(over) : rho);
  }
  const double delay = setup.options.speedOfSound ? 0.1 * setup.fan.depth_mm : 0.0;
  if (depth < -radius - 1.0 || depth > setup.fan.depth_mm + radius + 1.0 + delay) return false;
  const double clamped = std::clamp(depth, 0.0, setup.fan.depth_mm);
  if (beside > radius + kLateralReach * setup.beams.lateralSigma_mm(clamped)) return false;
  return std::abs(centre.z) < radius + setup.reachBetween_mm(depth - radius, depth + radius);
}

const ScattererBlock* blockOf(const glm::ivec3& index, const FrameScratch& work) {
  const glm::ivec3 at = index - work.boxFirst;
  if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= work.boxSize.x || at.y >= work.boxSize.y || at.z >= work.boxSize.z) return nullptr;
  const auto n = work.blockAt[(static_cast<std::size_t>(at.z) * static_cast<std::size_t>(work.boxSize.y) + static_cast<std::size_t>(at.y)) *
                                  static_cast<std::size_t>(work.boxSize.x) +
                              static_cast<std::size_t>(at.x)];
  return n < 0 ? nullptr : work.blocks[static_cast<std::size_t>(n)].made.get();
}

}  // namespace

bool findBlocks(const ScannerSetup& setup, const ScattererField& field, const View& view, FrameScratch& work) {
  const double size = field.blockSize_mm();
  const double slack = view.deforms ? view.deformation.reach_mm() : 0.0;
  const double widest = setup.reachBetween_mm(0.0, setup.fan.depth_mm) + 1.0;
  glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-std::numeric_limits<double>::infinity());
  for (std::size_t n = 0; n < setup.grid.lines.size(); ++n) {
    for (int corner = 0; corner < 4; ++corner) {
      const BeamGrid::Line& line = setup.grid.lines[n];
      const glm::dvec2 at = line.origin_mm + line.direction * ((corner & 1) ? setup.fan.depth_mm + 1.0 : -1.0);
      const glm::dvec3 world = view.toWorld(glm::dvec3(at, (corner & 2) ? widest : -widest));
      lowest = glm::min(lowest, world);
      highest = glm::max(highest, world);
    }
  }
  const double margin = slack + size;
  work.boxFirst = glm::ivec3(glm::floor((lowest - margin) / size));
  work.boxSize = glm::ivec3(glm::floor((highest + margin) / size)) - work.boxFirst + 1;
  const auto count =
      static_cast<std::size_t>(work.boxSize.x) * static_cast<std::size_t>(work.boxSize.y) * static_cast<std::size_t>(work.boxSize.z);
  work.blockAt.assign(count, -1);
  work.blocks.clear();
  if (view.deforms) {
    const glm::ivec3 nodes = work.boxSize + 1;
    work.corners.assign(samplesIn(nodes), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  }
  // A deformed block may be larger than it rests; its facets lie a little outside it.
  const double radius = std::sqrt(0.75) * size * (view.deforms ? 1.2 : 1.0) + field.overhang_mm();
  std::size_t at = 0;
  for (int k = 0; k < work.boxSize.z; ++k)
    for (int j = 0; j < work.boxSize.y; ++j)
      for (int i = 0; i < work.boxSize.x; ++i, ++at) {
        const glm::ivec3 index = work.boxFirst + glm::ivec3(i, j, k);
        const glm::dvec3 centre = size * (glm::dvec3(index) + 0.5);
        if (!seen(setup, view.toProbe(centre), radius + slack)) continue;
        if (view.deforms && !seen(setup, view.toProbe(view.deformation.moved(centre)), radius)) continue;
        auto block = field.block(index, work.stopped);
        if (!block) return false;
        work.blockAt[at] = static_cast<std::int32_t>(work.blocks.size());
        work.blocks.push_back({std::move(block), index});
        if (work.blocks.size() % kBlocksPerQuestion == 0 && work.stopped && work.stopped()) return false;
      }
  return true;
}

std::uint8_t tissueAt(const ScattererField& field, const glm::dvec3& rest, const FrameScratch& work) {
  const double perPitch = 1.0 / field.pitch_mm();
  const glm::ivec3 cell(glm::floor(rest * perPitch));
  static_assert(ScattererBlock::kCells == 8);
  const glm::ivec3 index(cell.x >> 3, cell.y >> 3, cell.z >> 3);
  const ScattererBlock* block = blockOf(index, work);
  return block == nullptr ? ScattererBlock::kOutside : block->tissueAt(cell.x & 7, cell.y & 7, cell.z & 7);
}

Trilinear motionOf(const ScattererField& field, const View& view, const glm::ivec3& index, FrameScratch& work) {
  const double size = field.blockSize_mm();
  Trilinear to{};
  if (!view.deforms) {
    to[0] = glm::vec3(view.toProbe(size * glm::dvec3(index)));
    const glm::dmat4& m = view.worldToProbe.matrix;
    for (int axis = 0; axis < 3; ++axis) to[static_cast<std::size_t>(axis) + 1] = glm::vec3(m[axis]);
    return to;
  }
  std::array<glm::dvec3, 8> corner;
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 node = index + glm::ivec3(n & 1, (n >> 1) & 1, n >> 2) - work.boxFirst, nodes = work.boxSize + 1;
    glm::dvec3& kept = work.corners[sampleIndex(nodes, node.x, node.y, node.z)];
    if (std::isnan(kept.x)) kept = view.toProbe(view.deformation.moved(size * glm::dvec3(node + work.boxFirst)));
    corner[static_cast<std::size_t>(n)] = kept;
  }
  const auto& c = corner;
  to[0] = glm::vec3(c[0]);
  to[1] = glm::vec3((c[1] - c[0]) / size);
  to[2] = glm::vec3((c[2] - c[0]) / size);
  to[3] = glm::vec3((c[4] - c[0]) / size);
  to[4] = glm::vec3((c[3] - c[2] - c[1] + c[0]) / (size * size));
  to[5] = glm::vec3((c[5] - c[4] - c[1] + c[0]) / (size * size));
  to[6] = glm::vec3((c[6] - c[4] - c[2] + c[0]) / (size * size));
  to[7] = glm::vec3((c[7] - c[6] - c[5] - c[3] + c[4] + c[2] + c[1] - c[0]) / (size * size * size));
  return to;
}

}  // namespace ew::phantom
