#include "ew/scanning/contact.h"

#include <algorithm>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kGel_mm = 3.0;

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

double contactShare(const std::vector<float>& gaps_mm) { return contactShare(gaps_mm, std::vector<bool>(gaps_mm.size(), true)); }

double contactShare(const std::vector<float>& gaps_mm, const std::vector<bool>& data) {
  EW_EXPECTS(data.size() == gaps_mm.size());
  if (gaps_mm.empty()) return 1.0;
  int touching = 0;
  for (std::size_t n = 0; n < gaps_mm.size(); ++n) touching += static_cast<double>(gaps_mm[n]) <= kGel_mm && data[n] ? 1 : 0;
  return touching / static_cast<double>(gaps_mm.size());
}

double usualPress_mm(const Probe& probe) {
  constexpr double kLeast_mm = 1.0;
  constexpr double kShare = 0.8;
  return std::min(kLeast_mm + kShare * faceSagitta_mm(probe), kMaxPress_mm);
}

}  // namespace ew
