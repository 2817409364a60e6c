#include "ew/simulated_people/skin_distance.h"

#include <cmath>
#include <mutex>

#include "ew/scanning/contact.h"

namespace ew {
namespace {

/// Places of blocks within 2^20 of the origin either way: more than 16 km.
std::uint64_t keyOf(const glm::ivec3& place) {
  const auto part = [](int n) { return static_cast<std::uint64_t>(n + (1 << 20)) & 0x1FFFFFU; };
  return part(place.x) | part(place.y) << 21U | part(place.z) << 42U;
}

}  // namespace

const SkinDistance::Block& SkinDistance::blockOf(const glm::ivec3& place) const {
  const std::uint64_t key = keyOf(place);
  {
    const std::shared_lock reading(guard_);
    if (const auto found = blocks_.find(key); found != blocks_.end()) return *found->second;
  }
  auto made = std::make_unique<Block>();
  std::size_t n = 0;
  for (int k = 0; k <= kCells; ++k)
    for (int j = 0; j <= kCells; ++j)
      for (int i = 0; i <= kCells; ++i) {
        const glm::dvec3 p_mm = kNode_mm * glm::dvec3(kCells * place + glm::ivec3(i, j, k));
        const Skin::Contact nearest = skin_->nearest(p_mm);
        (*made)[n++] = static_cast<float>(glm::dot(p_mm - nearest.point_mm, nearest.outward));
      }
  const std::unique_lock writing(guard_);
  return *blocks_.try_emplace(key, std::move(made)).first->second;
}

double SkinDistance::at_mm(const glm::dvec3& p_mm) const {
  const glm::dvec3 node = p_mm / kNode_mm;
  const glm::ivec3 cell(glm::floor(node));
  const glm::ivec3 place(glm::floor(glm::dvec3(cell) / static_cast<double>(kCells)));
  const Block& block = blockOf(place);
  const glm::ivec3 within = cell - kCells * place;
  const glm::dvec3 share = node - glm::dvec3(cell);
  constexpr std::size_t kRow = kNodes, kSlice = kRow * kRow;
  const std::size_t first =
      static_cast<std::size_t>(within.x) + kRow * static_cast<std::size_t>(within.y) + kSlice * static_cast<std::size_t>(within.z);
  const auto along = [&](std::size_t at) { return std::lerp(static_cast<double>(block[at]), static_cast<double>(block[at + 1]), share.x); };
  const double near_mm = std::lerp(along(first), along(first + kRow), share.y);
  return std::lerp(near_mm, std::lerp(along(first + kSlice), along(first + kSlice + kRow), share.y), share.z);
}

std::vector<float> SkinDistance::gaps_mm(const Probe& probe, const Pose& pose) const {
  std::vector<float> gaps_mm;
  gaps_mm.reserve(kPointsOfFace);
  for (const glm::dvec3& p_probe : facePoints_mm(probe, kPointsOfFace))
    gaps_mm.push_back(static_cast<float>(at_mm(glm::dvec3(pose.probeToWorld.matrix * glm::dvec4(p_probe, 1.0)))));
  return gaps_mm;
}

}  // namespace ew
