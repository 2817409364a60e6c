#include "elastic/residual_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "elastic/rows.h"
#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr int kBlocks = 1200;       // looked at, at most about
constexpr double kCovered = 0.5;    // of a block, or it is not looked at
constexpr double kAround_mm = 9.0;  // of a node: whose blocks speak for it
constexpr double kFewest = 2.0;     // blocks that must have told
constexpr double kPlainly = 0.95;   // of the difference at rest: a correlation alone is highest where structure is strongest, moved or not

enum class Told : std::uint8_t { notAsked, nothing, still, moved };

/// How alike two sets of samples are, each less its mean.
struct Alike {
  double correlation = -1.0;
  double difference = 0.0;  ///< mean square
};
Alike alikeOf(const std::array<double, kMoments>& m) {
  if (!(m[0] > 0.0)) return {};
  const double ff = m[3] - m[1] * m[1] / m[0], mm = m[4] - m[2] * m[2] / m[0], fm = m[5] - m[1] * m[2] / m[0];
  return {ff > 1e-6 * m[0] && mm > 1e-6 * m[0] ? fm / std::sqrt(ff * mm) : -1.0, (ff + mm - 2.0 * fm) / m[0]};
}

struct MotionBlocks {
  glm::ivec3 size{1};
  glm::ivec3 count{1};
  std::vector<glm::ivec3> shifts;  // samples; none first, then by length
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(count, i, j, k); }
};

MotionBlocks blocksOf(const LevelImage& image) {
  MotionBlocks blocks;
  glm::ivec3 step, reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = image.spacing_mm[axis];
    blocks.size[axis] = std::min(std::max(4, static_cast<int>(std::lround(kLeftBlock_mm / spacing))), image.dims[axis]);
    blocks.count[axis] = image.dims[axis] / blocks.size[axis];
    step[axis] = std::max(1, static_cast<int>(std::lround(kLeftStep_mm / spacing)));
    reach[axis] = image.dims[axis] > 1 ? static_cast<int>(kLeftReach_mm / (spacing * step[axis]) + 0.25) : 0;
  }
  for (int k = -reach.z; k <= reach.z; ++k) {
    for (int j = -reach.y; j <= reach.y; ++j) {
      for (int i = -reach.x; i <= reach.x; ++i) blocks.shifts.push_back(glm::ivec3(i, j, k) * step);
    }
  }
  const auto length = [&](const glm::ivec3& s) { return glm::length(glm::dvec3(s) * image.spacing_mm); };
  std::stable_sort(blocks.shifts.begin(), blocks.shifts.end(),
                   [&](const glm::ivec3& a, const glm::ivec3& b) { return length(a) < length(b) - 1e-9; });
  return blocks;
}

/// Which shift either half of each block of the line (j, k) names.
void lookAlong(const LevelPair& pair, const MotionBlocks& blocks, int j, int k, Told* told, float* length_mm) {
  const LevelImage& fixed = pair.fixed();
  const glm::ivec3 dims = fixed.dims, size = blocks.size, low(0, j * size.y, k * size.z);
  const int stride = blocks.count.x * size.x;
  const auto across = static_cast<std::size_t>(blocks.count.x);
  struct Best {
    Alike alike;
    std::size_t shift = 0;
    double atRest = 0.0;  ///< difference without a shift
    [[nodiscard]] bool plainly() const { return alike.difference < kPlainly * atRest; }
  };
  std::vector<std::array<Best, 2>> best(across);
  std::vector<std::array<double, 2>> covered(across);
  std::vector<float> moments(2 * std::size_t{kMoments} * static_cast<std::size_t>(stride) + kOverrun);
  const std::size_t half = kMoments * static_cast<std::size_t>(stride);
  for (std::size_t s = 0; s < blocks.shifts.size(); ++s) {
    const glm::ivec3 shift = blocks.shifts[s];
    std::fill(moments.begin(), moments.end(), 0.0F);
    const int begin = std::max(0, -shift.x), end = std::min(stride, dims.x - shift.x);
    for (int z = low.z; z < low.z + size.z; ++z) {
      if (z + shift.z < 0 || z + shift.z >= dims.z) continue;
      for (int y = low.y; y < low.y + size.y; ++y) {
        if (y + shift.y < 0 || y + shift.y >= dims.y || begin >= end) continue;
        const int odd = ((z - low.z) * 2 / size.z + (y - low.y) * 2 / size.y) & 1;
        const std::size_t here = fixed.rowOf(y, z) + static_cast<std::size_t>(begin);
        const std::size_t there = fixed.rowOf(y + shift.y, z + shift.z) + static_cast<std::size_t>(begin + shift.x);
        addMoments(fixed.values.data() + here, fixed.weights.empty() ? nullptr : fixed.weights.data() + here, pair.moved().data() + there,
                   pair.movedWeights().data() + there, end - begin, moments.data() + static_cast<std::size_t>(odd) * half + begin, stride);
      }
    }
    for (std::size_t b = 0; b < across; ++b) {
      std::array<std::array<double, kMoments>, 2> sums{};
      for (int i = 0; i < size.x; ++i) {
        const int odd = i * 2 / size.x & 1;
        for (int row = 0; row < 2; ++row) {
          const float* at = moments.data() + static_cast<std::size_t>(row) * half + b * static_cast<std::size_t>(size.x) + i;
          auto& sum = sums[static_cast<std::size_t>(row ^ odd)];
          for (std::size_t q = 0; q < kMoments; ++q) sum[q] += static_cast<double>(at[q * static_cast<std::size_t>(stride)]);
        }
      }
      for (std::size_t h = 0; h < 2; ++h) {
        if (s == 0) covered[b][h] = sums[h][0];
        if (sums[h][0] < 0.5 * covered[b][h]) continue;
        const Alike alike = alikeOf(sums[h]);
        if (s == 0) best[b][h].atRest = alike.difference;
        if (alike.correlation > best[b][h].alike.correlation) best[b][h].alike = alike, best[b][h].shift = s;
      }
    }
  }
  const double whole = static_cast<double>(size.x) * size.y * size.z;
  for (std::size_t b = 0; b < across; ++b) {
    const auto& [one, other] = best[b];
    if (covered[b][0] + covered[b][1] < kCovered * whole || one.alike.correlation < 0.0 || other.alike.correlation < 0.0) continue;
    if (one.shift != other.shift) {
      told[b] = Told::nothing;
    } else if (one.shift == 0) {
      told[b] = Told::still;
    } else {
      told[b] = one.plainly() && other.plainly() ? Told::moved : Told::nothing;
    }
    length_mm[b] = static_cast<float>(glm::length(glm::dvec3(blocks.shifts[one.shift]) * fixed.spacing_mm));
  }
}

/// Blocks that told, less those that name the same shift by chance: two halves that know nothing do so once in as many shifts as there are.
struct Count {
  double still = 0.0;
  double moved = 0.0;
  double nothing = 0.0;
  void add(Told what) {
    still += what == Told::still ? 1.0 : 0.0;
    moved += what == Told::moved ? 1.0 : 0.0;
    nothing += what == Told::nothing ? 1.0 : 0.0;
  }
  [[nodiscard]] double movedBeyondChance(std::size_t shifts) const {
    return shifts > 1 ? std::max(0.0, moved - nothing / static_cast<double>(shifts - 1)) : 0.0;
  }
};

}  // namespace

bool lookForResidualMotion(const LevelPair& pair, const NodeGrid& nodes, int threads, Progress& progress, ResidualMotion& left) {
  left = {};
  left.nodeShare.assign(nodes.count(), 0.0F);
  const LevelImage& fixed = pair.fixed();
  const MotionBlocks blocks = blocksOf(fixed);
  const int all = blocks.count.x * blocks.count.y * blocks.count.z, every = (all + kBlocks - 1) / kBlocks;
  std::vector<Told> told(static_cast<std::size_t>(all), Told::notAsked);
  std::vector<float> length_mm(told.size(), 0.0F);
  if (!forEachTask(blocks.count.y * blocks.count.z, threads, progress, say<"Checking for residual motion">(), [&](int line) {
        const int j = line % blocks.count.y, k = line / blocks.count.y;
        if ((j + k) % every != 0) return;
        const std::size_t at = blocks.indexOf(0, j, k);
        lookAlong(pair, blocks, j, k, told.data() + at, length_mm.data() + at);
      }))
    return false;
  Count count;
  double length = 0.0;
  for (std::size_t n = 0; n < told.size(); ++n) {
    count.add(told[n]);
    if (told[n] == Told::moved) length += static_cast<double>(length_mm[n]);
  }
  const double moved = count.movedBeyondChance(blocks.shifts.size());
  left.blocks = count.still + moved;
  if (!(left.blocks > 0.0)) return true;
  left.share = moved / left.blocks;
  left.deviation = std::sqrt(std::max(left.share * (1.0 - left.share), 1.0 / left.blocks) / left.blocks);
  left.length_mm = count.moved > 0.0 ? length / count.moved : 0.0;

  const glm::dvec3 block_mm = glm::dvec3(blocks.size) * fixed.spacing_mm;
  for (int k = 0; k < nodes.dims.z; ++k) {
    for (int j = 0; j < nodes.dims.y; ++j) {
      for (int i = 0; i < nodes.dims.x; ++i) {
        const glm::dvec3 at =
            (nodes.first_mm + glm::dvec3(i, j, k) * nodes.spacing_mm - fixed.first_mm + 0.5 * fixed.spacing_mm) / block_mm;
        const glm::ivec3 from = glm::max(glm::ivec3(glm::ceil(at - kAround_mm / block_mm - 0.5)), glm::ivec3(0));
        const glm::ivec3 to = glm::min(glm::ivec3(glm::floor(at + kAround_mm / block_mm - 0.5)), blocks.count - 1);
        Count around;
        for (int z = from.z; z <= to.z; ++z) {
          for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) around.add(told[blocks.indexOf(x, y, z)]);
          }
        }
        const double here = around.movedBeyondChance(blocks.shifts.size());
        if (around.still + here >= kFewest) left.nodeShare[nodes.indexOf(i, j, k)] = static_cast<float>(here / (around.still + here));
      }
    }
  }
  return true;
}

}  // namespace ew::registration
