#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "echo_layout.h"
#include "echo_motion.h"
#include "ew/imaging/slice_source.h"
#include "scatterer_store.h"

namespace ew::detail {

/// Cells along each edge of a block of the lattice, whose scatterers are made together.
inline constexpr int kBlockCells = 4;

/// Amplitudes are added up as whole multiples of this: whole numbers have the same sum in any order, and so with any number of threads.
inline constexpr double kDepositUnit = 0x1p-20;

/// What the vector code of scatterers needs for a frame.
struct ScatterTask {
  std::uint32_t seed = 1;
  // Lattice to probe and to the voxels of the level map.
  std::array<glm::vec3, 3> cellToProbe_mm{};  ///< columns: one cell along i, j, k
  glm::vec3 voxelsPerCell{1.0F};
  const std::uint8_t* level = nullptr;
  const std::uint8_t* levelEnd = nullptr;
  glm::ivec3 dims{0};
  float log2PerLevel = 0.0F;   ///< of the amplitude
  float log2OfTexture = 0.0F;  ///< one standard deviation of their strength
  float log2OfZero = 0.0F;     ///< where the level is 0, everything that multiplies amplitudes included

  // Lines, as FanShape.
  FanShape::Kind kind = FanShape::Kind::sector;
  float apex_mm = 0.0F;
  float shear = 0.0F;      ///< parallel: tangent of the steering
  float perCosine = 1.0F;  ///< parallel: 1 / cosine of the steering
  bool steers = false;
  float touched_mm = 0.0F;  ///< sector: the circle about the apex that steered lines touch
  float steering_rad = 0.0F;
  float cosine_mm = 0.0F;    ///< sector: of the steering, times apex_mm
  float leadTurns = 0.0F;    ///< of the carrier's phase, for one unit of `across` (FanShape::wavefrontLead_mm)
  float rowsPerUnit = 1.0F;  ///< of angle (sector) or of width on the face
  float middleRow = 0.0F;
  float columnsPerMm = 1.0F;
  float firstColumn = 0.0F;  ///< where depth 0 lies
  float turnsPerMm = 1.0F;   ///< of the carrier's phase, both ways
  float lastRow = 0.0F;
  float lastColumn = 0.0F;  ///< itself left out

  // Elevational beam.
  float lensFocus_mm = 0.0F;
  float nearPerMm = 0.0F;
  float farPerMm = 0.0F;
  float waistPerMm2 = 0.0F;
  float cut = 2.5F;  ///< exponent where the beam ends

  std::int32_t* field = nullptr;  ///< complex numbers, row after row
  std::int32_t stride = 0;        ///< of a row

  /// Whether blocks hold the same scatterers as with another task, of the same tissue.
  [[nodiscard]] bool hasSameScatterers(const ScatterTask& other) const {
    return seed == other.seed && voxelsPerCell == other.voxelsPerCell && level == other.level && dims == other.dims &&
           log2PerLevel == other.log2PerLevel && log2OfTexture == other.log2OfTexture && log2OfZero == other.log2OfZero;
  }
};

/// One block: where its lowest corner lies.
struct ScatterBlock {
  std::array<std::uint32_t, 3> cell{};
  glm::vec3 probe_mm{0.0F};
  glm::ivec3 voxel{0};            ///< whole part
  glm::vec3 voxelFraction{0.0F};  ///< 0..1
  float reach_mm = 0.0F;          ///< of the beams there, beside the slice's middle
  /// Where tissue moves: how much farther than at rest its cells have gone, one cell on along i, j, k.
  std::array<glm::vec3, 3> stretch_mm{glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(0.0F)};
  glm::vec3 shift_mm{0.0F};  ///< of the lowest corner, in probe_mm already
};

/// Adds the scatterers of these blocks to the field. The same bits on every instruction set.
/// @param store of the same task but for where the probe is
void addScatterers(const ScatterTask& task, const std::vector<ScatterBlock>& blocks, ScattererStore& store);

/// Where the tissue lies in the probe frame, in the lattice's own cells.
struct EchoPlace {
  glm::dmat4 cellToProbe{1.0};
  glm::dmat4 probeToCell{1.0};
  glm::dvec3 voxelsPerCell{1.0};
  double beside_mm = 0.0;  ///< how far beside a block what it adds may lie
};
[[nodiscard]] EchoPlace echoPlaceOf(double pitch_mm, const Grid& grid, const Transform<frame::Voxel, frame::Probe>& probeToVoxel);

[[nodiscard]] ScatterTask scatterTaskOf(const EchoLayout& layout, const EchoPlace& place, const SliceSource& level);

/// The slab that the beams see is cut across them into pieces. A block belongs to the piece in which its middle lies, so that each is met
/// once; what two pieces that are not neighbours add to the field does not overlap.
[[nodiscard]] int piecesOf(const EchoLayout& layout);
/// Of a slab so deep. The last one is up to twice as thick as the others.
[[nodiscard]] int piecesIn(double depth_mm);
inline constexpr double kPiece_mm = 20.0;  ///< more than a block's diagonal, so that pieces that are not neighbours stay apart
struct DepthRange {
  double near_mm = 0.0, far_mm = 0.0;
  [[nodiscard]] bool has(double depth_mm) const { return depth_mm >= near_mm && depth_mm < far_mm; }
};
/// To which a piece may add.
[[nodiscard]] DepthRange reachedFrom(const EchoLayout& layout, int piece);
/// Of a piece: its blocks to the left and to the right of the fan's middle have no row in common, those between have some with either.
enum class PartOfPiece { all, left, right, between };
/// Whether pieces have such sides: not where lines are steered.
[[nodiscard]] inline bool hasSides(const EchoLayout& layout) { return layout.fan.steering_rad == 0.0; }
/// @param motion of the tissue: a block is moved, sheared and stretched with it
/// @param shifts scratch memory
void findBlocks(const EchoLayout& layout, const EchoPlace& place, const EchoMotion& motion, const glm::ivec3& dims, int piece,
                PartOfPiece part, BlockShifts& shifts, std::vector<ScatterBlock>& blocks);

}  // namespace ew::detail
