#include "echo_motion.h"

#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/volume.h"

namespace ew::detail {
namespace {

constexpr double kFinestKnot_mm = 1.0;
constexpr double kCoarsestKnot_mm = 5.0;
constexpr int kKnotsOfDepth = 36;
constexpr int kMostStepsBack = 16;  // of the inverse
constexpr float kExactBack_mm2 = 4e-4F;
// What is seen beside a node's neighbourhood may have gone a little farther than they.
constexpr double kBeyondNodes = 0.12;  // of the differences
constexpr double kBeyondNodes_mm = 0.3;

constexpr int kFacePlaces = 33;
constexpr int kSmoothPlaces = 3;  // to either side
constexpr double kSkinStep_mm = 0.4;
constexpr double kGel_mm = 3.0;
constexpr double kLeastPress_mm = 0.3;
constexpr double kStands_mm = 60.0;  // what lies deeper is not moved
constexpr double kFades_mm = 15.0;   // towards there
constexpr double kBeyondStands_mm = 12.0;
constexpr double kNode_mm = 4.0;

/// Between nodes of a grid, three linear steps; beyond as at its edge.
glm::vec3 between(const glm::vec3* nodes, std::ptrdiff_t row, std::ptrdiff_t plane, const glm::vec3& last, const glm::vec3& p) {
  const glm::vec3 at = glm::clamp(p, glm::vec3(0.0F), last);
  const glm::ivec3 low = glm::ivec3(glm::min(at, last - 1.0F));
  const glm::vec3 t = at - glm::vec3(low);
  const glm::vec3* first = nodes + low.x + row * low.y + plane * low.z;
  const auto along = [&](const glm::vec3* v) { return v[0] + t.x * (v[1] - v[0]); };
  const glm::vec3 near0 = along(first), near1 = along(first + row), far0 = along(first + plane), far1 = along(first + plane + row);
  const glm::vec3 nearer = near0 + t.y * (near1 - near0), farther = far0 + t.y * (far1 - far0);
  return nearer + t.z * (farther - nearer);
}

}  // namespace

glm::vec3 EchoMotion::shiftAt(const glm::vec3& rest_mm) const {
  glm::vec3 shift(0.0F);
  for (const Field& field : fields_) {
    const glm::vec3 node = field.probeToNode * rest_mm + field.nodeOfProbe;
    // Beside a small field nothing is asked.
    if (!field.isEverywhere &&
        !(node.x > 0.0F && node.y > 0.0F && node.z > 0.0F && node.x < field.last.x && node.y < field.last.y && node.z < field.last.z))
      continue;
    shift += field.toProbe * between(field.shift, field.row, field.plane, field.last, node);
  }
  return shift;
}

glm::vec3 EchoMotion::backAt(const glm::vec3& now_mm, const glm::vec3& guess) const {
  // A fixed point: fields do not fold, so that steps shrink. They shrink slowly where a field falls off steeply.
  glm::vec3 back = guess;
  for (int step = 0; step < kMostStepsBack; ++step) {
    const glm::vec3 next = -shiftAt(now_mm + back), change = next - back;
    back = next;
    if (glm::dot(change, change) < kExactBack_mm2) break;
  }
  return back;
}

void EchoMotion::take(const TissueMotion& motion, const BodyState& body, double strength,
                      const Transform<frame::Probe, frame::World>& motionToProbe) {
  for (const TissueMotion::Mode& mode : motion.modes) {
    const double amplitude = strength * amplitudeOf(mode.kind, body);
    if (amplitude == 0.0) continue;
    EW_EXPECTS(glm::all(glm::greaterThan(mode.grid.dims, glm::ivec3(1))) && mode.shift_mm.size() == mode.grid.voxelCount());
    const Transform<frame::Probe, frame::Voxel> nodeToProbe = motionToProbe * mode.grid.voxelToWorld();
    const glm::dmat4 probeToNode = inverse(nodeToProbe).matrix;
    fields_.push_back({.isEverywhere = mode.kind == TissueMotion::Kind::breath,
                       .probeToNode = glm::mat3(probeToNode),
                       .nodeOfProbe = glm::vec3(probeToNode[3]),
                       .toProbe = glm::mat3(amplitude * glm::dmat3(motionToProbe.matrix) * mode.grid.directions),
                       .last = glm::vec3(mode.grid.dims - 1),
                       .row = mode.grid.dims.x,
                       .plane = std::ptrdiff_t{mode.grid.dims.x} * mode.grid.dims.y,
                       .shift = mode.shift_mm.data()});
    deepest_mm_ = std::numeric_limits<float>::infinity();
  }
}

void EchoMotion::configure(const EchoLayout& layout) {
  const FanShape& fan = layout.face;
  const FanShape::Box box = fan.box(kStands_mm);
  faceOrigin_mm_ = {-(box.halfWidth_mm + kNode_mm), box.top_mm - kFarthestSkin_mm};
  faceDims_ = {static_cast<int>(std::ceil(-2.0 * faceOrigin_mm_.x / kNode_mm)) + 1,
               static_cast<int>(std::ceil((kStands_mm + kFarthestSkin_mm - faceOrigin_mm_.y) / kNode_mm)) + 1, 2};
  faceNodes_.clear();
  for (int j = 0; j < faceDims_.y; ++j)
    for (int i = 0; i < faceDims_.x; ++i) {
      const glm::dvec2 rest_mm = glm::dvec2(i, j) * kNode_mm + faceOrigin_mm_;
      const FanShape::Place at = fan.placeOf(rest_mm);
      const double along = (std::clamp(at.across, -1.0, 1.0) + 1.0) * 0.5 * (kFacePlaces - 1);
      const int place = std::min(static_cast<int>(along), kFacePlaces - 2);
      faceNodes_.push_back({place, along - place, at.depth_mm, fan.directionThrough(rest_mm)});
    }
}

void EchoMotion::press(const EchoLayout& layout, const SliceSource& level, const Transform<frame::Voxel, frame::Probe>& probeToVoxel) {
  const FanShape& fan = layout.face;
  const auto isTissue = [&](const glm::dvec2& p_mm) {
    const glm::ivec3 voxel(glm::floor(glm::dvec3(probeToVoxel.matrix * glm::dvec4(p_mm, 0.0, 1.0)) + 0.5));
    return level.grid.contains(voxel) && level.voxels[level.grid.indexOf(voxel.x, voxel.y, voxel.z)] != 0;
  };
  // How far the face stands below the skin, at places along it; negative in front of it.
  std::array<double, kFacePlaces> found_mm{};
  for (int place = 0; place < kFacePlaces; ++place) {
    const FanShape::Line line = fan.lineAt(2.0 * place / (kFacePlaces - 1) - 1.0);
    const bool isIn = isTissue(line.origin_mm);
    double away_mm = 0.0;
    while (away_mm < kFarthestSkin_mm && isTissue(line.origin_mm - (isIn ? away_mm : -away_mm) * line.direction) == isIn)
      away_mm += kSkinStep_mm;
    if (away_mm >= kFarthestSkin_mm) away_mm = isIn ? kFarthestSkin_mm : 0.0;
    // Gel brings skin to the face; what is farther away lies in the air.
    found_mm[static_cast<std::size_t>(place)] =
        isIn ? away_mm - 0.5 * kSkinStep_mm : -away_mm * std::clamp((2.0 * kGel_mm - away_mm) / kGel_mm, 0.0, 1.0);
  }
  // Voxels are steps of a skin that is smooth.
  std::array<double, kFacePlaces> press_mm{};
  double most_mm = 0.0;
  for (int place = 0; place < kFacePlaces; ++place) {
    double sum = 0.0, weight = 0.0;
    for (int aside = -kSmoothPlaces; aside <= kSmoothPlaces; ++aside) {
      const double share = kSmoothPlaces + 1 - std::abs(aside);
      sum += share * found_mm[static_cast<std::size_t>(std::clamp(place + aside, 0, kFacePlaces - 1))];
      weight += share;
    }
    press_mm[static_cast<std::size_t>(place)] = sum / weight;
    most_mm = std::max(most_mm, std::abs(sum / weight));
  }
  if (most_mm < kLeastPress_mm) return;

  pressed_.resize(2 * faceNodes_.size());
  for (std::size_t node = 0; node < faceNodes_.size(); ++node) {
    const FaceNode& at = faceNodes_[node];
    const auto low = static_cast<std::size_t>(at.place);
    const double press = std::lerp(press_mm[low], press_mm[low + 1], at.part);
    const double below_mm = std::max(at.depth_mm + press, 0.0), stays = std::clamp((kStands_mm - below_mm) / kFades_mm, 0.0, 1.0);
    const double share = stays > 0.0 ? stays * std::exp(-below_mm * below_mm / (kGives_mm * kGives_mm)) : 0.0;
    pressed_[node] = pressed_[node + faceNodes_.size()] = glm::vec3(press * share * at.direction, 0.0);
  }
  constexpr double kAside_mm = 50.0;  // the same at all places beside the slice
  glm::dmat3 toNode(1.0 / kNode_mm);
  toNode[2] = {0.0, 0.0, 0.5 / kAside_mm};
  fields_.push_back({.isEverywhere = true,
                     .probeToNode = glm::mat3(toNode),
                     .nodeOfProbe = glm::vec3(-faceOrigin_mm_ / kNode_mm, 0.5),
                     .toProbe = glm::mat3(1.0F),
                     .last = glm::vec3(faceDims_ - 1),
                     .row = faceDims_.x,
                     .plane = static_cast<std::ptrdiff_t>(faceNodes_.size()),
                     .shift = pressed_.data()});
  // Between nodes of the field and of whoever asks it, shifts end a little deeper than it does.
  pressedTo_mm_ = static_cast<float>(kStands_mm + kNode_mm + kBeyondStands_mm);
  deepest_mm_ = std::max(deepest_mm_, pressedTo_mm_);
}

void EchoMotion::find(const EchoLayout& layout, Bands& bands) {
  if (!moves()) return;

  lines_ = static_cast<int>(layout.grid.lines.size());
  reach_ = layout.effect.reach;
  const double asked_mm = std::clamp(layout.depth_mm / kKnotsOfDepth, kFinestKnot_mm, kCoarsestKnot_mm);
  knots_ = static_cast<int>(std::ceil(layout.depth_mm / asked_mm)) + 1;
  knot_mm_ = layout.depth_mm / (knots_ - 1);
  perKnot_ = static_cast<float>(1.0 / knot_mm_);
  const double width_mm = layout.grid.lineSpacing_mm(0.75 * layout.depth_mm) * (lines_ - 1);
  columns_ = std::clamp(static_cast<int>(std::ceil(width_mm / asked_mm)) + 1, 2, std::max(2, lines_));
  nodes_.resize(static_cast<std::size_t>(2 * knots_ * columns_));
  bands.run(columns_, [&](int first, int count, int) {
    for (int column = first; column < first + count; ++column) {
      const FanShape::Line line = layout.fan.lineAt(2.0 * column / (columns_ - 1) - 1.0);
      for (const int side : {0, 1}) {
        glm::vec3 back(0.0F), before(0.0F);
        for (int knot = 0; knot < knots_; ++knot) {
          const double range_mm = knot * knot_mm_, aside_mm = (side == 0 ? -1.0 : 1.0) * layout.beams.elevationalSigma_mm(range_mm);
          const glm::dvec3 now_mm(line.origin_mm + range_mm * line.direction, aside_mm);
          const glm::vec3 guess = knot < 2 ? back : 2.0F * back - before;
          before = back;
          back = backAt(glm::vec3(now_mm), guess);
          nodes_[static_cast<std::size_t>((side * knots_ + knot) * columns_ + column)] = back;
        }
      }
    }
  });
}

EchoMotion::Reach EchoMotion::reachBetween(double near_mm, double far_mm) const {
  const int first = std::clamp(static_cast<int>(std::floor(near_mm / knot_mm_)) - 1, 0, knots_ - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(far_mm / knot_mm_)) + 1, 0, knots_ - 1);
  glm::vec3 least(std::numeric_limits<float>::infinity()), most(-least);
  const auto outward = static_cast<float>(0.5 * reach_);
  for (int knot = first; knot <= last; ++knot)
    for (int column = 0; column < columns_; ++column) {
      const glm::vec3 &a = nodeAt(0, knot, column), &b = nodeAt(1, knot, column);
      const glm::vec3 middle = 0.5F * (a + b), off = outward * glm::abs(b - a);
      least = glm::min(least, middle - off);
      most = glm::max(most, middle + off);
    }
  const glm::dvec3 beyond_mm = kBeyondNodes * glm::dvec3(most - least) + kBeyondNodes_mm;
  return {glm::dvec3(least) - beyond_mm, glm::dvec3(most) + beyond_mm};
}

void EchoMotion::rowsOf(double sigmas, const glm::mat3& toVoxel, Bands& bands, std::vector<glm::vec3>& rows) const {
  rows.resize(static_cast<std::size_t>(knots_) * static_cast<std::size_t>(lines_));
  const auto side = static_cast<float>(0.5 * (1.0 + sigmas));
  const float perLine = static_cast<float>(columns_ - 1) / static_cast<float>(std::max(1, lines_ - 1));
  bands.run(knots_, [&](int first, int count, int) {
    for (int knot = first; knot < first + count; ++knot) {
      const auto nodeOf = [&](int column) {
        const glm::vec3& low = nodeAt(0, knot, column);
        return toVoxel * (low + side * (nodeAt(1, knot, column) - low));
      };
      glm::vec3* row = rows.data() + static_cast<std::ptrdiff_t>(knot) * lines_;
      glm::vec3 low = nodeOf(0), step = nodeOf(1) - low;
      for (int line = 0, column = 0; line < lines_; ++line) {
        const float at = static_cast<float>(line) * perLine;
        for (const int wanted = std::min(static_cast<int>(at), columns_ - 2); column < wanted; ++column) {
          low += step;
          step = nodeOf(column + 2) - low;
        }
        row[line] = low + (at - static_cast<float>(column)) * step;
      }
    }
  });
}

void BlockShifts::begin(const EchoMotion& motion, const glm::dmat4& cellToProbe, int cellsOfBlock, const glm::ivec3& first,
                        const glm::ivec3& last) {
  motion_ = &motion;
  const double block_mm = cellsOfBlock * glm::length(glm::dvec3(cellToProbe[0]));
  blocksOfNode_ = std::max(1, static_cast<int>(std::ceil(motion.knot_mm() / block_mm - 0.25)));
  // Nodes are the same whichever piece asks: counted from the lattice's beginning.
  first_ = glm::ivec3(glm::floor(glm::dvec3(first) / static_cast<double>(blocksOfNode_))) * blocksOfNode_;
  dims_ = (last - first_) / blocksOfNode_ + 2;
  const auto cells = static_cast<double>(cellsOfBlock * blocksOfNode_);
  perCell_ = static_cast<float>(1.0 / cells);
  for (int axis = 0; axis < 3; ++axis) nodeToProbe_[axis] = cells * cellToProbe[axis];
  nodeToProbe_[3] = cellToProbe * glm::dvec4(static_cast<double>(cellsOfBlock) * glm::dvec3(first_), 1.0);
  nodes_.assign(samplesIn(dims_), glm::vec3(std::numeric_limits<float>::quiet_NaN()));
  row_.resize(static_cast<std::size_t>(3 * dims_.x));
}

const glm::vec3& BlockShifts::askedAt(int i, int j, int k) {
  glm::vec3& node = nodes_[static_cast<std::size_t>((k * dims_.y + j) * dims_.x + i)];
  if (std::isnan(node.x)) node = motion_->shiftAt(glm::vec3(nodeToProbe_ * glm::dvec4(i, j, k, 1.0)));
  return node;
}

void BlockShifts::row(int firstBlock, int lastBlock, int j, int k) {
  rowFirst_ = nodeOf(firstBlock);
  const int y = (j - first_.y) / blocksOfNode_, z = (k - first_.z) / blocksOfNode_;
  const float ty = partOf(j - first_.y - y * blocksOfNode_), tz = partOf(k - first_.z - z * blocksOfNode_);
  for (int node = rowFirst_; node <= nodeOf(lastBlock) + 1; ++node) {
    const glm::vec3 a = askedAt(node, y, z), b = askedAt(node, y + 1, z), c = askedAt(node, y, z + 1), d = askedAt(node, y + 1, z + 1);
    const glm::vec3 near = a + ty * (b - a), far = c + ty * (d - c), ahead = b - a;
    glm::vec3* out = row_.data() + static_cast<std::ptrdiff_t>(3) * (node - rowFirst_);
    out[0] = near + tz * (far - near);
    out[1] = perCell_ * (ahead + tz * (d - c - ahead));
    out[2] = perCell_ * (far - near);
  }
}

}  // namespace ew::detail
