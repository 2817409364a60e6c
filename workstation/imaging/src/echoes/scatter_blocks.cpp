#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ew/core/contract.h"
#include "scatterers.h"

namespace ew::detail {
namespace {

constexpr double kDecibelPerLevel = 60.0 / 255.0;
constexpr double kBent_mm = 1.5;  // the lens bends ranges by less, and a scatterer is shared by two columns
constexpr int kAngles = 17;       // across the fan, of the box around a piece of it

/// A piece of the slab: a box in the probe frame, and ranges.
struct Piece {
  glm::dvec3 lowest_mm{std::numeric_limits<double>::infinity()};
  glm::dvec3 highest_mm{-std::numeric_limits<double>::infinity()};
  double nearest_mm = 0.0;
  double farthest_mm = 0.0;
  double reach_mm = 0.0;   ///< beside the slice's middle
  double beside_mm = 0.0;  ///< seen beyond the outermost lines
  std::array<FanShape::Line, 2> outermost{};
  // Of the fan, for every block.
  double tangent = 0.0, cosine = 1.0;  ///< of the steering
  double halfAngleSine = 0.0, halfAngleCosine = 1.0;
};

/// How far the middle of a block may lie from one of its cells, along each axis of the probe frame and in any direction.
struct BlockSize {
  glm::dvec3 half_mm{0.0};
  double radius_mm = 0.0;
};
BlockSize sizeOf(const EchoPlace& place) {
  BlockSize size;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 half = 0.5 * kBlockCells * glm::dvec3(place.cellToProbe[axis]);
    size.half_mm += glm::abs(half);
    size.radius_mm += glm::dot(half, half);
  }
  size.radius_mm = std::sqrt(size.radius_mm);
  return size;
}

Piece pieceOf(const EchoLayout& layout, const BlockSize& size, int number) {
  Piece piece;
  // Blocks in front of the face and beyond the last sample may reach in.
  constexpr double kBeyond_mm = 20.0;
  piece.nearest_mm = number == 0 ? -kBeyond_mm : number * kPiece_mm;
  piece.farthest_mm = number + 1 == piecesOf(layout) ? layout.depth_mm + kBeyond_mm : (number + 1) * kPiece_mm;
  const double nearest_mm = std::max(piece.nearest_mm, -size.radius_mm - kBent_mm);
  const double farthest_mm = std::min(piece.farthest_mm, layout.depth_mm + size.radius_mm + kBent_mm);
  // Also of what lies in front of the face and beyond the last sample, whose echoes reach in.
  const double shallow_mm = nearest_mm - size.radius_mm, deep_mm = farthest_mm + size.radius_mm;
  const EchoBeams& beams = layout.beams;
  piece.reach_mm = layout.effect.reach * std::max(beams.elevationalSigma_mm(shallow_mm), beams.elevationalSigma_mm(deep_mm));
  piece.beside_mm = kLateralSigmas * std::max(beams.lateralSigma_mm(deep_mm), beams.lateralSigma_mm(shallow_mm));
  piece.tangent = std::tan(layout.fan.steering_rad);
  piece.cosine = std::cos(layout.fan.steering_rad);
  piece.halfAngleSine = std::sin(layout.fan.halfAngle_rad);
  piece.halfAngleCosine = std::cos(layout.fan.halfAngle_rad);
  piece.outermost = {layout.fan.lineAt(-1.0), layout.fan.lineAt(1.0)};
  for (int n = 0; n < kAngles; ++n) {
    const FanShape::Line line = layout.fan.lineAt(2.0 * n / (kAngles - 1) - 1.0);
    for (const double range_mm : {nearest_mm, farthest_mm}) {
      const glm::dvec2 at = line.origin_mm + range_mm * line.direction;
      piece.lowest_mm = glm::min(piece.lowest_mm, glm::dvec3(at, -piece.reach_mm));
      piece.highest_mm = glm::max(piece.highest_mm, glm::dvec3(at, piece.reach_mm));
    }
  }
  // Between two of the angles an arc bulges.
  const double step_rad = 2.0 * layout.fan.halfAngle_rad / (kAngles - 1);
  const double bulge_mm = (layout.fan.apexToFace_mm + std::abs(farthest_mm)) * (1.0 - std::cos(0.5 * step_rad));
  const glm::dvec3 margin_mm(piece.beside_mm + bulge_mm, bulge_mm, 0.0);
  piece.lowest_mm -= margin_mm + size.half_mm;
  piece.highest_mm += margin_mm + size.half_mm;
  return piece;
}

/// Whether the middle of a block lies in the piece's ranges, and the block may touch its lines.
bool belongs(const FanShape& fan, const Piece& piece, const glm::dvec3& p_mm, double radius_mm) {
  if (fan.kind == FanShape::Kind::parallel) {  // as placeOf has it
    const double across = (p_mm.x - p_mm.y * piece.tangent) / fan.halfWidth_mm, depth_mm = p_mm.y / piece.cosine;
    return depth_mm >= piece.nearest_mm && depth_mm < piece.farthest_mm &&
           (std::abs(across) - 1.0) * fan.halfWidth_mm < (piece.beside_mm + radius_mm) / piece.cosine;
  }
  const double y_mm = p_mm.y + fan.apexToFace_mm;
  // Without the angle, which only placeOf needs.
  const bool isArc = fan.kind == FanShape::Kind::sector && fan.steering_rad == 0.0;
  const double depth_mm = isArc ? std::sqrt(p_mm.x * p_mm.x + y_mm * y_mm) - fan.apexToFace_mm : fan.placeOf(glm::dvec2(p_mm)).depth_mm;
  if (depth_mm < piece.nearest_mm || depth_mm >= piece.farthest_mm) return false;
  if (fan.kind == FanShape::Kind::sector && !isArc) {
    const auto rightOf_mm = [&](const FanShape::Line& line) {
      const glm::dvec2 from_mm = glm::dvec2(p_mm) - line.origin_mm;
      return from_mm.x * line.direction.y - from_mm.y * line.direction.x;
    };
    const double beyond_mm = std::max(-rightOf_mm(piece.outermost[0]), rightOf_mm(piece.outermost[1]));
    return fan.halfAngle_rad + std::abs(fan.steering_rad) > 0.5 * std::numbers::pi || beyond_mm < radius_mm + piece.beside_mm;
  }
  // Distance beyond the outermost line, as far as it is a straight one.
  const double beyond_mm = std::abs(p_mm.x) * piece.halfAngleCosine - y_mm * piece.halfAngleSine;
  return fan.halfAngle_rad > 0.5 * std::numbers::pi || beyond_mm < radius_mm + piece.beside_mm;
}

/// Whole numbers n of first .. last with low <= start + n * step <= high.
void narrow(double start, double step, double low, double high, int& first, int& last) {
  if (std::abs(step) < 1e-12) {
    if (start < low || start > high) last = first - 1;
    return;
  }
  const double a = (low - start) / step, b = (high - start) / step;
  first = std::max(first, static_cast<int>(std::ceil(std::clamp(std::min(a, b), -1e8, 1e8))));
  last = std::min(last, static_cast<int>(std::floor(std::clamp(std::max(a, b), -1e8, 1e8))));
}

}  // namespace

EchoPlace echoPlaceOf(double pitch_mm, const Grid& grid, const Transform<frame::Voxel, frame::Probe>& probeToVoxel) {
  EchoPlace place;
  place.voxelsPerCell = pitch_mm / grid.spacing_mm;
  glm::dmat4 voxelToCell(1.0);
  for (int axis = 0; axis < 3; ++axis) voxelToCell[axis][axis] = 1.0 / place.voxelsPerCell[axis];
  place.probeToCell = voxelToCell * probeToVoxel.matrix;
  place.cellToProbe = glm::inverse(place.probeToCell);
  return place;
}

ScatterTask scatterTaskOf(const EchoLayout& layout, const EchoPlace& place, const SliceSource& level) {
  ScatterTask task;
  for (int axis = 0; axis < 3; ++axis) task.cellToProbe_mm[static_cast<std::size_t>(axis)] = glm::vec3(place.cellToProbe[axis]);
  task.voxelsPerCell = glm::vec3(place.voxelsPerCell);
  task.level = level.voxels;
  task.levelEnd = level.voxels + level.grid.voxelCount();
  task.dims = level.grid.dims;
  // One scatterer in each cell has the power of the cell's volume; equal magnitudes and random signs, so that few of them give speckle the
  // statistics of many.
  const double waist = layout.beams.lensWaist_mm;
  const double scale = std::pow(layout.pitch_mm, 1.5) / std::sqrt(waist * std::sqrt(std::numbers::pi)) / kDepositUnit;
  task.log2PerLevel = static_cast<float>(0.05 * kDecibelPerLevel * std::log2(10.0));
  // A strength that scatters by s (normal, in nepers of amplitude) adds exp(2 s^2) to the power, which the mean level does not have.
  const double texture = layout.effect.texture_db * std::log(10.0) / 20.0;
  const double zero_db = kMeanOfLog_db - 255.0 * kDecibelPerLevel + layout.effect.gain_db;
  task.log2OfTexture = static_cast<float>(texture / std::log(2.0));
  task.log2OfZero = static_cast<float>(0.05 * zero_db * std::log2(10.0) + std::log2(scale) - texture * texture / std::log(2.0));

  const FanShape& fan = layout.fan;
  task.kind = fan.kind;
  task.apex_mm = static_cast<float>(fan.apexToFace_mm);
  task.shear = static_cast<float>(std::tan(fan.steering_rad));
  task.perCosine = static_cast<float>(1.0 / std::cos(fan.steering_rad));
  const double halfRows = 0.5 * static_cast<double>(layout.grid.lines.size() - 1) * layout.rowsPerLine;
  const double units = fan.kind == FanShape::Kind::sector ? fan.halfAngle_rad : fan.halfWidth_mm;
  task.rowsPerUnit = static_cast<float>(halfRows / units);
  task.steers = fan.steering_rad != 0.0;
  task.steering_rad = static_cast<float>(fan.steering_rad);
  task.touched_mm = static_cast<float>(fan.apexToFace_mm * std::sin(fan.steering_rad));
  task.cosine_mm = static_cast<float>(fan.apexToFace_mm * std::cos(fan.steering_rad));
  task.leadTurns = static_cast<float>(2.0 / layout.beams.wavelength_mm * fan.wavefrontLead_mm() / units);
  task.middleRow = static_cast<float>(layout.rowPadding + halfRows);
  task.columnsPerMm = static_cast<float>(1.0 / layout.grid.sampleSpacing_mm);
  task.turnsPerMm = static_cast<float>(2.0 / layout.beams.wavelength_mm);
  task.firstColumn = static_cast<float>(layout.columnPadding);
  task.lastRow = static_cast<float>(layout.rows) - 0.6F;
  task.lastColumn = static_cast<float>(layout.columns);
  task.lensFocus_mm = static_cast<float>(layout.beams.lensFocus_mm);
  task.nearPerMm = layout.beams.isSlice ? static_cast<float>(1.0 / layout.beams.lensNearRange_mm) : 0.0F;
  task.farPerMm = layout.beams.isSlice ? static_cast<float>(1.0 / layout.beams.lensFarRange_mm) : 0.0F;
  task.waistPerMm2 = static_cast<float>(0.5 / (waist * waist));
  task.cut = static_cast<float>(0.5 * layout.effect.reach * layout.effect.reach);
  return task;
}

DepthRange reachedFrom(const EchoLayout& layout, int piece) {
  constexpr double kReached_mm = 0.5 * kPiece_mm - 1.0;  // what is added is shared by two columns
  constexpr double kEverything_mm = 1e6;
  return {piece == 0 ? -kEverything_mm : piece * kPiece_mm - kReached_mm,
          piece + 1 == piecesOf(layout) ? kEverything_mm : (piece + 1) * kPiece_mm + kReached_mm};
}

int piecesIn(double depth_mm) { return std::max(1, static_cast<int>(depth_mm / kPiece_mm)); }
int piecesOf(const EchoLayout& layout) { return piecesIn(layout.depth_mm); }

namespace {

constexpr double kApart_mm = 0.01;   // left between what pieces that are not neighbours may touch
constexpr double kStretched = 1.25;  // of a block at the border of a piece

/// Moves a block and stretches it about its middle.
/// @param mostStretch_mm of a corner, so that the block stays within its piece
/// @return how far corners go at most
double moveBlock(const BlockShifts& shifts, int i, double mostStretch_mm, ScatterBlock& block) {
  std::array<glm::vec3, 3> steps;
  float corner_mm = 0.0F;
  constexpr float kHalf = 0.5F * kBlockCells;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3& step = steps[static_cast<std::size_t>(axis)] = shifts.stretchAlong(i, axis);
    corner_mm += kHalf * glm::length(step);
  }
  const auto most_mm = static_cast<float>(mostStretch_mm);
  const float scale = corner_mm > most_mm ? most_mm / corner_mm : 1.0F;
  block.shift_mm = shifts.shiftAt(i);
  for (std::size_t n = 0; n < steps.size(); ++n) {
    block.stretch_mm[n] = scale * steps[n];
    block.shift_mm -= kHalf * block.stretch_mm[n];
  }
  return static_cast<double>(scale * corner_mm);
}

/// @param off_mm so far from the middle a block stays on its side
PartOfPiece partAt(double x_mm, double off_mm) {
  if (x_mm < -off_mm) return PartOfPiece::left;
  return x_mm > off_mm ? PartOfPiece::right : PartOfPiece::between;
}

/// Of the probe frame.
struct Box {
  glm::dvec3 from_mm{0.0}, to_mm{0.0};
};

/// Leaves what is surely in another part, before blocks are looked at one by one.
/// @param least_mm, most_mm how far from the middle blocks that stay on their side may begin
Box narrowTo(PartOfPiece part, double least_mm, double most_mm, Box box) {
  constexpr double kRounded_mm = 1e-6;
  if (part == PartOfPiece::left) box.to_mm.x = std::min(box.to_mm.x, kRounded_mm - least_mm);
  if (part == PartOfPiece::right) box.from_mm.x = std::max(box.from_mm.x, least_mm - kRounded_mm);
  if (part != PartOfPiece::between) return box;
  box.from_mm.x = std::max(box.from_mm.x, -most_mm - kRounded_mm);
  box.to_mm.x = std::min(box.to_mm.x, most_mm + kRounded_mm);
  return box;
}

/// Blocks of a lattice, the last ones included.
struct Region {
  glm::ivec3 begin{0}, end{-1};
};
/// Those that a box of the probe frame touches, where there are voxels.
Region regionOf(const EchoPlace& place, const glm::ivec3& dims, const Box& box) {
  glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-lowest);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? box.from_mm.x : box.to_mm.x, corner & 2 ? box.from_mm.y : box.to_mm.y,
                       corner & 4 ? box.from_mm.z : box.to_mm.z);
    const glm::dvec3 cell(place.probeToCell * glm::dvec4(p, 1.0));
    lowest = glm::min(lowest, cell);
    highest = glm::max(highest, cell);
  }
  lowest = glm::max(lowest, glm::dvec3(0.0));
  highest = glm::min(highest, glm::dvec3(dims - 1) / place.voxelsPerCell);
  if (!glm::all(glm::lessThan(lowest, highest))) return {};
  return {glm::ivec3(glm::floor(lowest / double{kBlockCells})), glm::ivec3(glm::floor(highest / double{kBlockCells}))};
}

bool liesIn(const Piece& piece, const glm::dvec3& p_mm, const glm::dvec3& margin_mm) {
  return glm::all(glm::greaterThanEqual(p_mm, piece.lowest_mm - margin_mm)) &&
         glm::all(glm::lessThanEqual(p_mm, piece.highest_mm + margin_mm));
}

}  // namespace

void findBlocks(const EchoLayout& layout, const EchoPlace& place, const EchoMotion& motion, const glm::ivec3& dims, int number,
                PartOfPiece part, BlockShifts& shifts, std::vector<ScatterBlock>& blocks) {
  blocks.clear();
  const BlockSize size = sizeOf(place);
  const double mostStretch_mm = 0.5 * kPiece_mm - kBent_mm - kApart_mm - size.radius_mm;
  EW_EXPECTS(mostStretch_mm > 0.0);
  const Piece piece = pieceOf(layout, size, number);
  const bool moves = motion.movesFrom(piece.nearest_mm);
  // Two rows off the middle one, where they are widest.
  const double aside_mm =
      size.radius_mm + place.beside_mm + 2.0 * layout.rowSpacing_mm(std::min(piece.farthest_mm, layout.depth_mm) + kPiece_mm);
  // Where what is seen rests.
  Box whole{piece.lowest_mm, piece.highest_mm}, own = narrowTo(part, aside_mm, aside_mm + (moves ? mostStretch_mm : 0.0), whole);
  glm::dvec3 stretched_mm(0.0);
  double radius_mm = size.radius_mm;
  if (moves) {
    stretched_mm = (kStretched - 1.0) * size.half_mm;
    radius_mm *= kStretched;
    const EchoMotion::Reach back = motion.reachBetween(piece.nearest_mm, piece.farthest_mm);
    for (Box* box : {&whole, &own}) {
      box->from_mm += back.least_mm - stretched_mm;
      box->to_mm += back.most_mm + stretched_mm;
    }
  }
  const auto [begin, end] = regionOf(place, dims, own);
  if (moves && begin.z <= end.z) {
    // Shifts are those of the whole piece, whichever part asks.
    const Region all = regionOf(place, dims, whole);
    shifts.begin(motion, place.cellToProbe, kBlockCells, all.begin, all.end);
  }
  const glm::dvec3 blockStep(place.cellToProbe[0] * double{kBlockCells});
  for (int k = begin.z; k <= end.z; ++k)
    for (int j = begin.y; j <= end.y; ++j) {
      const glm::dvec3 start(place.cellToProbe * glm::dvec4(double{kBlockCells} * (glm::dvec3(0, j, k) + 0.5), 1.0));
      int first = begin.x, last = end.x;
      for (const int axis : {2, 1, 0}) narrow(start[axis], blockStep[axis], own.from_mm[axis], own.to_mm[axis], first, last);
      if (moves && first <= last) shifts.row(first, last, j, k);
      for (int i = first; i <= last; ++i) {
        glm::dvec3 middle_mm = start + static_cast<double>(i) * blockStep;
        if (moves) {
          middle_mm += glm::dvec3(shifts.shiftAt(i));
          if (!liesIn(piece, middle_mm, stretched_mm)) continue;
        }
        if (!belongs(layout.fan, piece, middle_mm, radius_mm)) continue;
        ScatterBlock block;
        const double stretch_mm = moves ? moveBlock(shifts, i, mostStretch_mm, block) : 0.0;
        if (part != PartOfPiece::all && part != partAt(middle_mm.x, aside_mm + stretch_mm)) continue;
        const glm::dvec3 cell = double{kBlockCells} * glm::dvec3(i, j, k);
        const glm::dvec3 voxel = cell * place.voxelsPerCell, low = glm::floor(voxel);
        for (int axis = 0; axis < 3; ++axis)
          block.cell[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(kBlockCells * glm::ivec3(i, j, k)[axis]);
        block.probe_mm = glm::vec3(glm::dvec3(place.cellToProbe * glm::dvec4(cell, 1.0)) + glm::dvec3(block.shift_mm));
        block.voxel = glm::ivec3(low);
        block.voxelFraction = glm::vec3(voxel - low);
        block.reach_mm = static_cast<float>(piece.reach_mm);
        blocks.push_back(block);
      }
    }
}

}  // namespace ew::detail
