#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "ew/phantom/virtual_scanner.h"
#include "scanner/formation_kernels.h"
#include "scanner/scatterers.h"

namespace ew::phantom {

/// Where the probe is held and what the body does meanwhile.
struct View {
  Transform<frame::World, frame::Probe> probeToWorld;
  Transform<frame::Probe, frame::World> worldToProbe;
  const Deformation& deformation;
  bool deforms;
  [[nodiscard]] glm::dvec3 toProbe(const glm::dvec3& world) const { return (worldToProbe * Point<frame::World>{world}).at; }
  [[nodiscard]] glm::dvec3 toWorld(const glm::dvec3& probe) const { return (probeToWorld * Point<frame::Probe>{probe}).at; }
};

/// Work space of one frame.
struct FrameScratch final : VirtualScanner::Scratch {
  std::vector<float> fine;  ///< rows x columns complex numbers, and two that take what misses
  std::vector<float> line;  ///< columns complex numbers
  std::vector<float> turned;
  std::vector<float> pulsed;
  std::vector<float> gain;                          ///< lines x steps
  std::vector<float> lost_db, reflection_db, left;  ///< of one plane, lines x steps
  std::vector<float> smooth;
  std::vector<float> delay_mm;
  std::vector<glm::dvec3> restOnLines;
  struct Block {
    std::shared_ptr<const ScattererBlock> made;
    glm::ivec3 index{0};
  };
  std::vector<Block> blocks;
  std::vector<std::int32_t> blockAt;  ///< of a box of blocks: number in `blocks`, or -1
  glm::ivec3 boxFirst{0}, boxSize{0};
  std::vector<glm::dvec3> corners;  ///< of that box, moved; x is not a number where nobody asked yet
  std::vector<float> facetX, facetY, facetZ;
  PointBatch batch;
};

}  // namespace ew::phantom
