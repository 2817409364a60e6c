#include "ew/scanning/contact.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kGel_mm = 3.0;
constexpr double kGrazing = 0.17364817766693033;     // cos 80 degrees, between the probe and the way into the body
constexpr double kTurnedAway = -0.3420201433256687;  // cos 110 degrees
constexpr double kTooDeep_mm = kMaxPress_mm + 10.0;  // a firm hand, and an alignment as bad as one still works with

/// How far a line goes through air until it meets skin.
double throughAir_mm(const Skin& skin, const glm::dvec3& from_mm, const glm::dvec3& direction) {
  const auto met = skin.hit(from_mm, direction);
  return met ? std::min(glm::distance(from_mm, met->point_mm), static_cast<double>(kOpenAir_mm)) : static_cast<double>(kOpenAir_mm);
}

/// The gap of a point where the probe looks further from the body than a hand tips it.
/// @param along_mm of the skin's normal  @param looksIn cosine between the probe and the way into the body, below kGrazing
double gapOfFreePose_mm(double along_mm, double looksIn, const Skin& skin, const glm::dvec3& from_mm, const glm::dvec3& line) {
  if (along_mm > 0.0) {
    const double way_mm = throughAir_mm(skin, from_mm, line);
    return way_mm < static_cast<double>(kOpenAir_mm) ? std::max(along_mm, kGrazing * way_mm) : way_mm;
  }
  const double share = (kGrazing - looksIn) / (kGrazing - kTurnedAway);
  return share < 1.0 ? along_mm + share * kMaxPress_mm : static_cast<double>(kOpenAir_mm);
}

/// Where the line at a point of the face goes, in the probe's frame.
glm::dvec3 lineAt(const Probe& probe, const glm::dvec3& point_mm) {
  const bool isArc = isSector(probe.kind) && probe.kind != ProbeKind::phased && probe.radius_mm > 0.0;
  return isArc ? glm::normalize(point_mm + glm::dvec3(0.0, probe.radius_mm, 0.0)) : glm::dvec3(0.0, 1.0, 0.0);
}

}  // namespace

std::vector<float> gapsToSkin_mm(const Probe& probe, const Pose& pose, const Skin& skin) {
  std::vector<float> gaps_mm;
  gaps_mm.reserve(kPointsOfFace);
  const glm::dmat4& probeToWorld = pose.probeToWorld.matrix;
  for (const glm::dvec3& p_probe : facePoints_mm(probe, kPointsOfFace)) {
    const glm::dvec3 p_world = glm::dvec3(probeToWorld * glm::dvec4(p_probe, 1.0));
    const Skin::Contact nearest = skin.nearest(p_world);
    double gap_mm = glm::dot(p_world - nearest.point_mm, nearest.outward);
    const double looksIn = -glm::dot(glm::dvec3(probeToWorld[1]), nearest.outward);
    if (looksIn < kGrazing)
      gap_mm = gapOfFreePose_mm(gap_mm, looksIn, skin, p_world, glm::dvec3(probeToWorld * glm::dvec4(lineAt(probe, p_probe), 0.0)));
    gaps_mm.push_back(static_cast<float>(gap_mm));
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

FaceReport faceOnSkin(const std::vector<float>& gaps_mm) {
  if (gaps_mm.empty()) return {};
  const double nearest_mm = static_cast<double>(*std::min_element(gaps_mm.begin(), gaps_mm.end()));
  if (nearest_mm < -kTooDeep_mm) return {FaceOnSkin::tooDeep, nearest_mm};
  if (nearest_mm >= static_cast<double>(kOpenAir_mm)) return {FaceOnSkin::looksAway, 0.0};
  const double share = contactShare(gaps_mm);
  return {share > 0.5 ? FaceOnSkin::touches : share > 0.0 ? FaceOnSkin::partly : FaceOnSkin::inAir, nearest_mm};
}

Message faceSentence(const FaceReport& report) {
  const int whole_mm = static_cast<int>(std::lround(std::abs(report.away_mm)));
  switch (report.how) {
    case FaceOnSkin::touches:
      return {};
    case FaceOnSkin::partly:
      return say<"Only a part of the probe touches the skin: hold it upright, or press it on.">();
    case FaceOnSkin::inAir:
      return say<"The probe is %1 mm above the skin.">(whole_mm);
    case FaceOnSkin::looksAway:
      return say<"The probe looks away from the body.">();
    case FaceOnSkin::tooDeep:
      return say<"The probe is %1 mm inside the body: check the alignment of the tracker.">(whole_mm);
  }
  return {};
}

double usualPress_mm(const Probe& probe) {
  constexpr double kLeast_mm = 1.0;
  constexpr double kShare = 0.8;
  return std::min(kLeast_mm + kShare * faceSagitta_mm(probe), kMaxPress_mm);
}

}  // namespace ew
