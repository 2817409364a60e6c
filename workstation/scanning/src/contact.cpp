#include "ew/scanning/contact.h"

#include <algorithm>

namespace ew {
namespace {

constexpr double kGel_mm = 3.0;
constexpr int kPointsOfFace = 17;

}  // namespace

std::vector<float> gapsToSkin_mm(const Probe& probe, const Pose& pose, const Skin& skin) {
  std::vector<float> gaps_mm;
  gaps_mm.reserve(kPointsOfFace);
  for (const glm::dvec3& p_probe : facePoints_mm(probe, kPointsOfFace)) {
    const glm::dvec3 p_world = glm::dvec3(pose.probeToWorld.matrix * glm::dvec4(p_probe, 1.0));
    const Skin::Contact nearest = skin.nearest(p_world);
    gaps_mm.push_back(static_cast<float>(glm::dot(p_world - nearest.point_mm, nearest.outward)));
  }
  return gaps_mm;
}

double contactShare(const std::vector<float>& gaps_mm) {
  if (gaps_mm.empty()) return 1.0;
  const auto touching = std::count_if(gaps_mm.begin(), gaps_mm.end(), [](float gap_mm) { return static_cast<double>(gap_mm) <= kGel_mm; });
  return static_cast<double>(touching) / static_cast<double>(gaps_mm.size());
}

double usualPress_mm(const Probe& probe) {
  constexpr double kLeast_mm = 1.0;
  constexpr double kShare = 0.8;
  return std::min(kLeast_mm + kShare * faceSagitta_mm(probe), kMaxPress_mm);
}

}  // namespace ew
