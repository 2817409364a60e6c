#include "echo_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "pairs.h"

namespace ew::detail {
namespace {

constexpr float kBlind_mm = 0.8F;  // at least, where no surface is known

struct ElevationRay {
  float sigmas;
  float weight;
};
// exp(-x^2 / 2) at 0 and 0.9 standard deviations; together 1.
constexpr std::array<ElevationRay, 3> kRays{{{0.0F, 0.4284F}, {-0.9F, 0.2858F}, {0.9F, 0.2858F}}};

constexpr int kSideBySide = 16;  // lines that are walked together
constexpr double kDecibelPerLevel = 60.0 / 255.0;

std::uint32_t hashOf(const glm::ivec3& at) {
  std::uint32_t x = static_cast<std::uint32_t>(at.x) * 0x9E3779B1U + static_cast<std::uint32_t>(at.y) * 0x85EBCA77U +
                    static_cast<std::uint32_t>(at.z) * 0xC2B2AE3DU;
  x = (x ^ (x >> 16)) * 0x21f0aaadU;
  x = (x ^ (x >> 15)) * 0x735a2d97U;
  return x ^ (x >> 15);
}

constexpr double kFragmentScale_mm = 1.6;  // of the Gamma distribution (shape 2) of their lengths
constexpr double kLeastLength = 1e-6;      // e to the minus of the longest one's, 13.82
static_assert(0.5 * kFragmentScale_mm * 13.82 <= kMostFragment_mm);
constexpr double kFragmentSpread_db = 4.0;
constexpr double kFragmentFall_deg = 9.0;
constexpr double kMostBend_perMm = 0.08;
constexpr double kPairs = 0.4;                // of them: the two walls of a little vessel
constexpr double kSecondWall = 0.7;           // as strong as the one in front
constexpr double kSteepestFragment = 0.15;    // squared sine of the incidence: beyond, less than -13 dB are left
constexpr std::uint8_t kFaintestTissue = 40;  // no walls in fluids

/// Numbers that follow from a hash.
struct Hashed {
  explicit Hashed(std::uint32_t hash) : state(hash) {}
  std::uint32_t state;
  /// In [0, 1).
  double even() {
    state += 0x9E3779B9U;
    std::uint32_t x = state;
    x = (x ^ (x >> 16)) * 0x21f0aaadU;
    x = (x ^ (x >> 15)) * 0x735a2d97U;
    return (x ^ (x >> 15)) * 0x1p-32;
  }
  /// Nearly normal, of deviation 1.
  double normal() {
    double sum = -2.0;
    for (int n = 0; n < 4; ++n) sum += even();
    return sum * std::numbers::sqrt3;
  }
};

/// sin(2 pi turns) of 0 <= turns < 1 to 0.0012.
double nearlySineOf(double turns) {
  const double part = turns - 0.5, parabola = -8.0 * part * (1.0 - 2.0 * std::abs(part));
  return parabola * (0.775 + 0.225 * std::abs(parabola));
}

}  // namespace

void EchoSurfaces::configure(const EchoLayout& layout) {
  layout_ = &layout;
  lines_.clear();
  for (const BeamGrid::Line& line : layout.grid.lines) lines_.emplace_back(glm::vec2(line.origin_mm), glm::vec2(line.direction));
  elevation_mm_.clear();
  for (double depth_mm = 0.0; depth_mm < layout.depth_mm + 2.0; depth_mm += 1.0)
    elevation_mm_.push_back(static_cast<float>(layout.beams.elevationalSigma_mm(depth_mm + 0.5)));
  scale_.resize(static_cast<std::size_t>(layout.columns));
  for (int column = 0; column < layout.columns; ++column) {
    const int tile = column / kTileColumns;
    const std::vector<float>& weights = layout.lateral[static_cast<std::size_t>(tile)];
    double sum = 0.0;
    for (int t = 0; t <= layout.reachOfTile[static_cast<std::size_t>(tile)]; ++t) {
      const double weight = static_cast<double>(weights[static_cast<std::size_t>(2 * (t * kTileColumns + column % kTileColumns))]);
      sum += (t == 0 ? 1.0 : 2.0) * weight;
    }
    // What the focus does to speckle it does to surfaces: divided out of the weights it stays in.
    const double rest = static_cast<double>(layout.pulse.front()) * layout.lookScale * kDepositUnit /
                        static_cast<double>(layout.focusFactor[static_cast<std::size_t>(column)]);
    scale_[static_cast<std::size_t>(column)] = static_cast<float>(1.0 / (sum * rest));
  }
}

void EchoSurfaces::add(const TissueMaps& maps, const Transform<frame::Voxel, frame::Probe>& probeToVoxel, const EchoMotion& motion,
                       Bands& bands, std::int32_t* fine, std::ptrdiff_t stride) {
  const glm::mat4 toVoxel(probeToVoxel.matrix);
  static_assert(kRays.size() == std::tuple_size_v<decltype(back_)>);
  // In one plane what lies beside it is told by the surface's slope.
  const bool isFlat = layout_->planes == 1;
  const std::size_t rays = isFlat ? 1 : kRays.size();
  if (motion.moves())
    for (std::size_t ray = 0; ray < rays; ++ray)
      motion.rowsOf(static_cast<double>(kRays[ray].sigmas), glm::mat3(toVoxel), bands, back_[ray]);
  const auto lines = static_cast<int>(layout_->grid.lines.size());
  ways_.resize(layout_->grid.lines.size());
  for (std::size_t line = 0; line < layout_->grid.lines.size(); ++line) {
    const BeamGrid::Line& way = layout_->grid.lines[line];
    ways_.set(line, glm::vec3(toVoxel * glm::vec4(way.origin_mm, 0.0F, 1.0F)), glm::mat3(toVoxel) * glm::vec3(way.direction, 0.0F));
  }
  strengths_.take(maps.surfaces, layout_->effect.gain_db);
  const double atFace_mm = layout_->rowSpacing_mm(0.0), far_mm = layout_->rowSpacing_mm(layout_->depth_mm);
  const SurfaceEchoTask echoes{
      .distances = {maps.surfaceDistance.data(), maps.grid.dims},
      .kinds = {maps.surfaceKind.data(), maps.grid.dims},
      .strengths = strengths_,
      .spacing_mm = glm::vec3(maps.grid.spacing_mm),
      .slopeToProbe = glm::mat3(glm::transpose(glm::dmat3(probeToVoxel.matrix)) / TissueMaps::kDistanceStepsPerMm),
      .lines = lines_,
      .sideSigmas = isFlat ? kRays[2].sigmas : 0.0F,
      .sideShare = isFlat ? kRays[2].weight : 0.0F,
      .sigma_mm = elevation_mm_.data(),
      .rowsPerLine = layout_->rowsPerLine,
      .rowPadding = layout_->rowPadding,
      .rows = layout_->rows,
      .spacingAtFace_mm = static_cast<float>(atFace_mm),
      .spacingPerMm = static_cast<float>((far_mm - atFace_mm) / layout_->depth_mm),
      .firstColumn = static_cast<float>(layout_->columnPadding),
      .columnsPerMm = static_cast<float>(1.0 / layout_->grid.sampleSpacing_mm),
      .columns = layout_->columns,
      .scale = scale_.data(),
      .field = fine,
      .stride = static_cast<std::int32_t>(stride),
  };
  const float blind_mm = std::max(kBlind_mm, static_cast<float>(TissueMaps::kSurfaceReach_mm - glm::length(maps.grid.spacing_mm) - 0.1));
  scratch_.resize(static_cast<std::size_t>(bands.threads()));
  bands.runEach((lines + kSideBySide - 1) / kSideBySide, [&](int group, int slot) {
    const int first = group * kSideBySide;
    for (std::size_t n = 0; n < rays; ++n) {
      const SurfaceWalk walk{.ways = ways_,
                             .aside_voxel = glm::vec3(toVoxel[2]),
                             .sigmas = kRays[n].sigmas,
                             .sigma_mm = elevation_mm_.data(),
                             .distances = echoes.distances,
                             .back = motion.asRows(back_[n]),
                             .depth_mm = static_cast<float>(layout_->depth_mm),
                             .blind_mm = blind_mm};
      SurfaceEchoTask own = echoes;
      own.weight = isFlat ? 1.0F : kRays[n].weight;
      addLines(first, std::min(kSideBySide, lines - first), walk, toVoxel, motion, own, scratch_[static_cast<std::size_t>(slot)]);
    }
  });
}

void EchoSurfaces::addLines(int first, int count, const SurfaceWalk& walk, const glm::mat4& toVoxel, const EchoMotion& motion,
                            const SurfaceEchoTask& echoes, Scratch& mine) const {
  const int lastLine = static_cast<int>(lines_.size()) - 1;
  const auto& back = back_[static_cast<std::size_t>(walk.sigmas == 0.0F ? 0 : walk.sigmas < 0.0F ? 1 : 2)];
  mine.found.clear();
  mine.probes.clear();
  findCrossings(walk, first, count, mine.found);
  if (mine.found.empty()) return;
  SurfaceCrossings& met = mine.met;
  met.resize(mine.found.size());
  for (std::size_t n = 0; n < mine.found.size(); ++n) {
    const auto& [line, range_mm, isEntering] = mine.found[n];
    const float off_mm = walk.sigmas * elevation_mm_[static_cast<std::size_t>(range_mm)];
    const glm::vec3 at =
        ways_.startOf(line) + range_mm * ways_.perMmOf(line) + off_mm * walk.aside_voxel + motion.backOn(back, line, range_mm);
    met.line[n] = line;
    met.range_mm[n] = range_mm;
    met.entering[n] = isEntering ? 1.0F : -1.0F;
    for (int axis = 0; axis < 3; ++axis) met.at[static_cast<std::size_t>(axis)][n] = at[axis];
    announce(echoes, line, range_mm, at);
    if (!motion.isPressed(range_mm)) continue;
    for (const float there_mm : {range_mm + kFineStep_mm, std::max(range_mm - kFineStep_mm, 0.0F)})
      mine.probes.push_back({line, there_mm, off_mm});
    for (const int other : {std::min(line + 1, lastLine), std::max(line - 1, 0)}) mine.probes.push_back({other, range_mm, off_mm});
  }
  distancesOf(walk, toVoxel, lines_, mine.probes, mine.around_mm);
  const float* around_mm = mine.around_mm.data();
  for (std::size_t n = 0; n < mine.found.size(); ++n) {
    glm::vec2 slope(std::numeric_limits<float>::quiet_NaN());
    if (motion.isPressed(met.range_mm[n])) {
      slope = turnedSlope(met.line[n], met.range_mm[n], around_mm);
      around_mm += 4;
    }
    for (int axis = 0; axis < 2; ++axis) met.turned[static_cast<std::size_t>(axis)][n] = slope[axis];
  }
  addSurfaceEchoes(echoes, met);
}

/// Asks for what a crossing reads and what its echo is added to.
void EchoSurfaces::announce(const SurfaceEchoTask& echoes, int line, float range_mm, const glm::vec3& at) const {
  const glm::ivec3 low = glm::clamp(glm::ivec3(at), glm::ivec3(0), glm::ivec3(echoes.kinds.last) - 1);
  const std::ptrdiff_t row = echoes.kinds.row, plane = echoes.kinds.plane;
  const std::uint8_t* kind = echoes.kinds.first + low.x + row * low.y + plane * low.z;
  for (const std::ptrdiff_t more : {std::ptrdiff_t{0}, row, plane, row + plane}) __builtin_prefetch(kind + more);
  const int column = static_cast<int>(echoes.firstColumn + range_mm * echoes.columnsPerMm);
  if (column >= echoes.columns - 1) return;
  const int first = line * echoes.rowsPerLine - echoes.rowsPerLine / 2 + echoes.rowPadding;
  for (int n = std::max(first, 0); n < std::min(first + echoes.rowsPerLine, echoes.rows); ++n)
    __builtin_prefetch(pairAt(echoes.field + static_cast<std::ptrdiff_t>(n) * echoes.stride, column), 1);
}

/// As the surface lies now: tissue that gives way turns it. Not a number where that cannot be told.
glm::vec2 EchoSurfaces::turnedSlope(int line, float range_mm, const float* around_mm) const {
  const int low = std::max(line - 1, 0), high = std::min(line + 1, static_cast<int>(lines_.size()) - 1);
  const float down = around_mm[0] - around_mm[1], across = around_mm[2] - around_mm[3];
  if (low == high || std::isnan(down) || std::isnan(across)) return glm::vec2(std::numeric_limits<float>::quiet_NaN());
  const auto aside_mm = static_cast<float>((high - low) * layout_->grid.lineSpacing_mm(static_cast<double>(range_mm)));
  const glm::vec2 along(layout_->grid.lines[static_cast<std::size_t>(line)].direction);
  return down / (2.0F * kFineStep_mm) * along + across / aside_mm * glm::vec2(along.y, -along.x);
}

void EchoSurfaces::add(int row, double range_mm, double amplitude, double rough, std::int32_t* fine, std::ptrdiff_t stride) const {
  const double column = layout_->columnPadding + range_mm / layout_->grid.sampleSpacing_mm;
  const int at = row + layout_->rowPadding;
  if (!(column >= 0.0 && column < layout_->columns - 1) || at < 0 || at >= layout_->rows) return;
  const int whole = static_cast<int>(column);
  const double part = column - whole;
  const auto c = static_cast<std::size_t>(whole);
  const auto scale = static_cast<double>(scale_[c]);
  const double re = amplitude * scale, im = rough * scale;
  std::int32_t* first = pairAt(fine + at * stride, whole);
  const auto rounded = [](double x) { return static_cast<std::int32_t>(std::floor(x + 0.5)); };
  first[0] += rounded((1.0 - part) * re);
  first[1] += rounded((1.0 - part) * im);
  first[2] += rounded(part * re);
  first[3] += rounded(part * im);
}

namespace {

glm::mat3 stretchOf(const ScatterBlock& block) { return {block.stretch_mm[0], block.stretch_mm[1], block.stretch_mm[2]}; }

}  // namespace

void EchoSurfaces::addFragments(const SliceSource& level, const EchoPlace& fragments, const std::vector<ScatterBlock>& blocks,
                                const DepthRange& reached, std::int32_t* fine, std::ptrdiff_t stride) const {
  const double share = layout_->effect.fragmentsPerCm3 * 1e-3 * kFragmentCell_mm * kFragmentCell_mm * kFragmentCell_mm;
  const FanShape& fan = layout_->fan;
  const double middleLine = 0.5 * static_cast<double>(layout_->grid.lines.size() - 1);
  const glm::dmat3 toProbe(fragments.cellToProbe);
  const double cell2_mm2 = glm::dot(toProbe[0], toProbe[0]);  // of a cell's edge, the same along each
  for (const ScatterBlock& block : blocks) {
    Hashed hashed(hashOf(glm::ivec3(block.cell[0], block.cell[1], block.cell[2])));
    if (hashed.even() >= share) continue;
    // Its direction first: most do not lie square to the beam.
    const double height = 2.0 * hashed.even() - 1.0, turns = hashed.even();
    const double flat = std::sqrt(1.0 - height * height);
    glm::dvec3 cell(hashed.even(), hashed.even(), hashed.even());
    const glm::dvec3 firstCell(block.cell[0], block.cell[1], block.cell[2]);
    cell = cell * double{kBlockCells} + firstCell;
    const glm::dvec3 moved_mm = glm::dvec3(block.shift_mm) + glm::dmat3(stretchOf(block)) * (cell - firstCell);
    const glm::dvec3 at_mm = glm::dvec3(fragments.cellToProbe * glm::dvec4(cell, 1.0)) + moved_mm;
    const glm::dvec2 way = fan.directionThrough(glm::dvec2(at_mm));
    // Most are far too steep, which needs no exact angle.
    const glm::dvec3 nearly(flat * nearlySineOf(turns < 0.75 ? turns + 0.25 : turns - 0.75), flat * nearlySineOf(turns), height);
    if (const double slant = glm::dot(glm::dvec2(toProbe * nearly), way); slant * slant < (1.0 - kSteepestFragment - 0.02) * cell2_mm2)
      continue;
    const double turn = 2.0 * std::numbers::pi * turns;
    const glm::dvec3 normal = glm::normalize(toProbe * glm::dvec3(flat * std::cos(turn), flat * std::sin(turn), height));
    const double cosine = glm::dot(glm::dvec2(normal), way), sine2 = std::max(0.0, 1.0 - cosine * cosine);
    if (sine2 > kSteepestFragment) continue;
    const FanShape::Place place = fan.placeOf(glm::dvec2(at_mm));
    if (!(place.depth_mm > 0.0 && place.depth_mm < layout_->depth_mm)) continue;
    const glm::ivec3 voxel(glm::floor(cell * fragments.voxelsPerCell + 0.5));
    if (!level.grid.contains(voxel)) continue;
    const std::uint8_t around = level.voxels[level.grid.indexOf(voxel.x, voxel.y, voxel.z)];
    if (around < kFaintestTissue) continue;

    const double radius_mm = 0.5 * kFragmentScale_mm * -std::log(std::max(hashed.even() * hashed.even(), kLeastLength));
    const double more_db = layout_->effect.fragment_db + kFragmentSpread_db * hashed.normal();
    const double fall = std::sin(kFragmentFall_deg * std::numbers::pi / 180.0);
    const double level_db = (around - 255.0) * kDecibelPerLevel + kMeanOfLog_db + layout_->effect.gain_db + more_db;
    const double amplitude = std::pow(10.0, 0.05 * level_db) * std::exp(-0.5 * sine2 / (fall * fall));
    // Row by row of the fine grid, as wide in elevation as the disc is there.
    const double spacing_mm = layout_->rowSpacing_mm(place.depth_mm), elevation_mm = layout_->beams.elevationalSigma_mm(place.depth_mm);
    const double lean = -(normal.x * way.y - normal.y * way.x) / cosine;
    const double middle = (middleLine + middleLine * place.across) * layout_->rowsPerLine;
    const double bend_perMm = kMostBend_perMm * (2.0 * hashed.even() - 1.0);
    const bool isPair = hashed.even() < kPairs;
    const double apart_mm = 1.2 + 1.8 * hashed.even();
    for (int row = static_cast<int>(std::ceil(middle - radius_mm / spacing_mm)); row <= middle + radius_mm / spacing_mm; ++row) {
      const double aside_mm = (row - middle) * spacing_mm, half_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - aside_mm * aside_mm));
      const auto below = [&](double z_mm) { return 0.5 * std::erf(z_mm / (std::numbers::sqrt2 * elevation_mm)); };
      // Curved, and fading towards its ends.
      const double seen = (below(at_mm.z + half_mm) - below(at_mm.z - half_mm)) * half_mm * half_mm / (radius_mm * radius_mm);
      const double range_mm = place.depth_mm + lean * aside_mm + 0.5 * bend_perMm * aside_mm * aside_mm;
      if (reached.has(range_mm)) add(row, range_mm, amplitude * seen, 0.0, fine, stride);
      if (isPair && reached.has(range_mm + apart_mm)) add(row, range_mm + apart_mm, kSecondWall * amplitude * seen, 0.0, fine, stride);
    }
  }
}

}  // namespace ew::detail
