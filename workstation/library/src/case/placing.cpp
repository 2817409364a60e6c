#include "ew/library/placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/numbers.h"
#include "ew/library/body_skin.h"
#include "ew/registration/landmarks.h"

namespace ew {
namespace {

constexpr double kMostTip_rad = 35.0 * std::numbers::pi / 180.0;
constexpr double kPick_mm = 5.0;  // how well a person finds a place on skin and in a volume
constexpr const char* kDepthField = "depth_direction";
constexpr const char* kAssumedField = "probe_side_is_assumed";
constexpr const char* kLateralField = "lateral_direction";

/// How far a point stands off the skin: > 0 outside the body.
double gapTo_mm(const Skin& skin, const glm::dvec3& p_mm) {
  const Skin::Contact contact = skin.nearest(p_mm);
  const glm::dvec3 away = p_mm - contact.point_mm;
  return glm::dot(away, contact.outward) < 0.0 ? -glm::length(away) : glm::length(away);
}

/// Whether a point lies outside: the skin that is met on the way towards the probe is entered, or there is none.
bool isOutside(const Skin& skin, const glm::dvec3& p_mm, const glm::dvec3& towardsProbe) {
  const auto met = skin.hit(p_mm, towardsProbe);
  return !met || glm::dot(met->outward, towardsProbe) < 0.0;
}

glm::dvec3 middleOf(const std::vector<glm::dvec3>& points_mm) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& each : points_mm) sum += each;
  return sum / static_cast<double>(points_mm.size());
}

/// Unit, at right angles to `axis`, as near to `wanted` as may be.
glm::dvec3 acrossOf(const glm::dvec3& wanted, const glm::dvec3& axis) {
  const glm::dvec3 across = wanted - glm::dot(wanted, axis) * axis;
  if (glm::length(across) > 1e-6) return glm::normalize(across);
  const glm::dvec3 other = std::abs(axis.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  return glm::normalize(other - glm::dot(other, axis) * axis);
}

/// The direction of the beams: as wanted, and never tipped further from the skin's normal than a probe keeps its contact.
glm::dvec3 beamOf(const glm::dvec3& wanted, const glm::dvec3& inward) {
  if (!(glm::length(wanted) > 0.0)) return inward;
  const glm::dvec3 beam = glm::normalize(wanted);
  const double tip_rad = std::acos(std::clamp(glm::dot(beam, inward), -1.0, 1.0));
  if (tip_rad <= kMostTip_rad) return beam;
  return glm::normalize(std::cos(kMostTip_rad) * inward + std::sin(kMostTip_rad) * acrossOf(beam, inward));
}

/// The shift by which most of the sorted values lie within `reach` of zero; the middle one of equally good ones.
double bestShift(std::vector<double> values, double reach) {
  std::sort(values.begin(), values.end());
  std::size_t most = 0;
  double best = values[values.size() / 2];
  for (std::size_t low = 0, high = 0; low < values.size(); ++low) {
    while (high < values.size() && values[high] <= values[low] + 2.0 * reach) ++high;
    if (high - low <= most) continue;
    most = high - low;
    best = 0.5 * (values[low] + values[high - 1]);
  }
  return best;
}

std::optional<glm::dvec3> unitIn(const nlohmann::json& volume, const char* field) {
  if (!volume.is_object() || !volume.contains(field)) return std::nullopt;
  const auto& list = volume[field];
  if (!list.is_array() || list.size() != 3) return std::nullopt;
  glm::dvec3 found(0.0);
  for (int n = 0; n < 3; ++n) {
    if (!list[static_cast<std::size_t>(n)].is_number()) return std::nullopt;
    found[n] = list[static_cast<std::size_t>(n)].get<double>();
  }
  const double length = glm::length(found);
  if (!std::isfinite(length) || std::abs(length - 1.0) > 1e-2) return std::nullopt;
  return found / length;
}

tl::unexpected<Error> badPairs(Message text) { return failure(ErrorCode::badField, std::move(text), {{"field", "landmarks"}}); }

LandmarkFit fitOf(const registration::LandmarkResult& found, std::size_t pairs) {
  LandmarkFit fit;
  fit.fileToWorld = renamed<frame::World, frame::File>(found.fixedToMoving);
  fit.residuals_mm = found.residual_mm;
  double sum = 0.0;
  for (const double each : fit.residuals_mm) sum += each * each;
  fit.rms_mm = std::sqrt(sum / static_cast<double>(pairs));
  return fit;
}

std::vector<registration::LandmarkPair> withoutPair(const std::vector<registration::LandmarkPair>& all, std::size_t left) {
  auto rest = all;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left));
  return rest;
}

/// The site whose name `region` holds, the longest of several; null: none.
const PlacingSite* namedSite(const MannequinLandmarks& known, const std::string& region) {
  const PlacingSite* best = nullptr;
  std::string spoken = region;
  std::transform(spoken.begin(), spoken.end(), spoken.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const PlacingSite& each : known.sites)
    if (spoken.find(each.region) != std::string::npos && (best == nullptr || each.region.size() > best->region.size())) best = &each;
  return best;
}

}  // namespace

std::optional<SweepAxes> sweepAxesOf(std::span<const TrackedFrame> frames) {
  glm::dvec3 depth(0.0), lateral(0.0);
  for (const TrackedFrame& each : frames) {
    const glm::dvec3 x(each.imageToWorld.matrix[0]), y(each.imageToWorld.matrix[1]);
    if (glm::length(x) > 0.0) lateral += glm::normalize(x);
    if (glm::length(y) > 0.0) depth += glm::normalize(y);
  }
  const double least = 1e-3 * static_cast<double>(frames.size());
  if (frames.empty() || glm::length(depth) <= least) return std::nullopt;
  SweepAxes axes;
  axes.depth = glm::normalize(depth);
  axes.lateral = acrossOf(lateral, axes.depth);
  return axes;
}

std::optional<SweepAxes> sweepAxesOf(const Case& placed) {
  if (!placed.otherFields.is_object() || !placed.otherFields.contains("volume")) return std::nullopt;
  const auto& volume = placed.otherFields["volume"];
  const auto depth = unitIn(volume, kDepthField), lateral = unitIn(volume, kLateralField);
  if (!depth || !lateral) return std::nullopt;
  return SweepAxes{*depth, acrossOf(*lateral, *depth)};
}

Case withSweepAxes(Case placed, const SweepAxes& axes) {
  const auto rounded = [](const glm::dvec3& v) {
    const auto six = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    return nlohmann::json{six(v.x), six(v.y), six(v.z)};
  };
  placed.otherFields["volume"][kDepthField] = rounded(axes.depth);
  placed.otherFields["volume"][kLateralField] = rounded(axes.lateral);
  placed.otherFields["volume"].erase(kAssumedField);
  return placed;
}

Case withAssumedAxes(Case placed, const SweepAxes& axes) {
  placed = withSweepAxes(std::move(placed), axes);
  placed.otherFields["volume"][kAssumedField] = true;
  return placed;
}

bool assumesAxes(const Case& placed) {
  if (!placed.otherFields.is_object() || !placed.otherFields.contains("volume") || !placed.otherFields["volume"].is_object()) return false;
  const auto& volume = placed.otherFields["volume"];
  return volume.contains(kAssumedField) && volume[kAssumedField] == true;
}

Contact contactOf(const PlacingShape& shape, const Transform<frame::World, frame::File>& fileToWorld, const Skin& skin) {
  Contact contact;
  std::size_t touching = 0;
  for (const glm::dvec3& each : shape.face_mm) {
    const double gap_mm = gapTo_mm(skin, carried(fileToWorld, each));
    touching += std::abs(gap_mm) <= kGel_mm ? 1u : 0u;
    contact.deepestGap_mm = std::max(contact.deepestGap_mm, gap_mm);
    contact.deepestIntrusion_mm = std::max(contact.deepestIntrusion_mm, -gap_mm);
  }
  if (!shape.face_mm.empty()) contact.faceShare = static_cast<double>(touching) / static_cast<double>(shape.face_mm.size());
  const glm::dvec3 towardsProbe = -(fileToWorld * Direction<frame::File>{shape.axes.depth}).along;
  const auto outside = std::count_if(shape.inside_mm.begin(), shape.inside_mm.end(),
                                     [&](const glm::dvec3& each) { return isOutside(skin, carried(fileToWorld, each), towardsProbe); });
  if (!shape.inside_mm.empty()) contact.outsideShare = static_cast<double>(outside) / static_cast<double>(shape.inside_mm.size());
  return contact;
}

Transform<frame::World, frame::File> firstPlacement(const PlacingShape& shape, const Skin& skin, const PlacingSite& site) {
  if (shape.face_mm.empty()) return {};
  const Skin::Contact at = skin.nearest(site.at_mm);
  const glm::dvec3 beam = beamOf(site.towards_mm - at.point_mm, -at.outward);
  const glm::dvec3 lateral = acrossOf(site.lateralHint, beam);
  const SweepAxes& axes = shape.axes;
  const glm::dmat3 fileAxes(axes.lateral, axes.depth, glm::cross(axes.lateral, axes.depth));
  const glm::dmat3 rotation = glm::dmat3(lateral, beam, glm::cross(lateral, beam)) * glm::transpose(fileAxes);
  Transform<frame::World, frame::File> placed{glm::dmat4(rotation)};
  glm::dvec3 origin_mm = at.point_mm - rotation * middleOf(shape.face_mm);
  for (int round = 0; round < 4; ++round) {
    placed.matrix[3] = glm::dvec4(origin_mm, 1.0);
    std::vector<double> gaps_mm;
    for (const glm::dvec3& each : shape.face_mm) gaps_mm.push_back(gapTo_mm(skin, carried(placed, each)));
    const double shift_mm = bestShift(std::move(gaps_mm), kGel_mm) / std::max(0.5, -glm::dot(beam, at.outward));
    origin_mm += shift_mm * beam;
    if (std::abs(shift_mm) < 0.05) break;
  }
  placed.matrix[3] = glm::dvec4(origin_mm, 1.0);
  return placed;
}

Result<LandmarkFit> placeByLandmarks(std::span<const PlacingPair> pairs) {
  if (pairs.size() < 3)
    return badPairs(say<"A placement needs at least three pairs of places, not on one line, and there are %1; add some.">(pairs.size()));
  std::vector<registration::LandmarkPair> given;
  for (const PlacingPair& each : pairs) given.push_back({each.name, each.file_mm, each.world_mm});
  const registration::LandmarkOptions plain{.pickError_mm = kPick_mm, .robust = false};
  const auto all = registration::registerLandmarks(given, plain);
  if (!all) return passOn(all.error());
  if (all->collinear || !(all->conditioning > 0.02))
    return badPairs(say<"The places all lie on one line, so that nobody can say how the volume is turned about it; add one beside it.">());
  LandmarkFit fit = fitOf(*all, pairs.size());
  if (pairs.size() < 4 || fit.rms_mm < kPick_mm) return fit;
  // The pair without which the others agree: only when they then agree well, and this pair alone is far off.
  std::optional<LandmarkFit> best;
  for (std::size_t n = 0; n < given.size(); ++n) {
    const auto rest = withoutPair(given, n);
    const auto found = registration::registerLandmarks(rest, plain);
    if (!found || found->collinear || !(found->conditioning > 0.02)) continue;
    LandmarkFit tried = fitOf(*found, rest.size());
    if (best && tried.rms_mm >= best->rms_mm) continue;
    tried.wrong = n;
    best = std::move(tried);
  }
  if (!best || best->rms_mm > 0.4 * fit.rms_mm) return fit;
  const PlacingPair& wrong = pairs[*best->wrong];
  best->residuals_mm.insert(best->residuals_mm.begin() + static_cast<std::ptrdiff_t>(*best->wrong),
                            glm::distance(carried(best->fileToWorld, wrong.file_mm), wrong.world_mm));
  return *best;
}

bool knowsRegion(const MannequinLandmarks& known, const std::string& region) { return namedSite(known, region) != nullptr; }

const PlacingSite* siteFor(const MannequinLandmarks& known, const std::string& region) {
  const PlacingSite* named = namedSite(known, region);
  return named != nullptr || known.sites.empty() ? named : &known.sites.front();
}

}  // namespace ew
