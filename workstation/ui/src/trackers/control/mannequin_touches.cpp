#include "trackers/control/mannequin_touches.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "ew/widgets/words.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr std::size_t kFewestTraced = 30;
constexpr double kTracedApart_mm = 2.0;  ///< a probe that rests traces nothing new

}  // namespace

MannequinTouches::MannequinTouches(const Session& session, Keep keep) : session_(session), keep_(std::move(keep)) {}

std::string MannequinTouches::name() const { return window_.mannequin ? window_.mannequin() : std::string(); }

std::vector<BodyLandmark> MannequinTouches::landmarks() const {
  auto known = landmarksOf(name());
  if (!known) known = landmarksOf({});
  return known ? std::move(known->landmarks) : std::vector<BodyLandmark>{};
}

std::vector<glm::dvec3> MannequinTouches::landmarkPlaces() const {
  std::vector<glm::dvec3> places;
  for (const BodyLandmark& each : landmarks()) places.push_back(each.at_mm);
  return places;
}

std::vector<glm::vec3> MannequinTouches::bodyPoints() const {
  return window_.bodyPoints_mm ? window_.bodyPoints_mm() : std::vector<glm::vec3>{};
}

std::shared_ptr<const Skin> MannequinTouches::skin() const { return session_.probeControl().skin(); }

double MannequinTouches::gap_mm(const Skin& skin, const glm::dvec3& at_world) {
  const Skin::Contact nearest = skin.nearest(at_world);
  const glm::dvec3 away = at_world - nearest.point_mm;
  return glm::dot(away, nearest.outward) < 0.0 ? -glm::length(away) : glm::length(away);
}

void MannequinTouches::setTouches(const std::string& id, std::vector<TrackerTouch> touches) {
  aligning_[id].touches = std::move(touches);
  findAlignment(id, {});
}

void MannequinTouches::findAlignment(const std::string& id, const std::vector<glm::dvec3>& traced) {
  Aligning& aligning = aligning_[id];
  const std::vector<BodyLandmark> known = landmarks();
  std::vector<LandmarkTouch> touched;
  for (const TrackerTouch& each : aligning.touches) {
    const auto named = std::find_if(known.begin(), known.end(), [&](const BodyLandmark& mark) { return mark.id == each.landmark; });
    touched.push_back({named != known.end() ? words(named->name).toStdString() : each.landmark, each.at_mm, each.at_tracker});
  }
  TrackerAlignment found;
  AlignmentOptions options;
  if (session_.subject()) options.target_mm = session_.probeControl().pose().probeToWorld.matrix[3];
  auto byLandmarks = alignByLandmarks(touched, options);
  if (!byLandmarks) {
    found.sentence = byLandmarks.error().message;
    aligning.found = std::move(found);
    return;
  }
  found.isFound = byLandmarks->verdict == AlignmentVerdict::aligned;
  found.sentence = byLandmarks->sentence;
  found.residuals_mm = byLandmarks->verdict == AlignmentVerdict::cannotTell ? std::vector<double>{} : byLandmarks->residual_mm;
  found.rms_mm = byLandmarks->rms_mm;
  found.expected_mm = byLandmarks->expected_mm;
  if (byLandmarks->wrong && *byLandmarks->wrong < aligning.touches.size()) found.wrong = aligning.touches[*byLandmarks->wrong].landmark;
  Alignment best = *byLandmarks;
  if (found.isFound && traced.size() >= kFewestTraced && skin()) {
    const auto bySurface = alignBySurface(traced, *skin(), byLandmarks->trackerToWorld, options);
    found.sentence = bySurface ? bySurface->sentence : bySurface.error().message;
    found.isTraced = bySurface && bySurface->verdict == AlignmentVerdict::aligned;
    if (found.isTraced) best = *bySurface;
  }
  const bool isFound = found.isFound;
  const bool isTraced = found.isTraced;
  aligning.found = std::move(found);
  if (!isFound) return;
  keep_(id, best.trackerToWorld, {isTraced ? "surface" : "landmarks", {}, best.rms_mm, best.expected_mm, best.used});
}

void MannequinTouches::trace(const glm::dvec3& at_tracker) {
  if (traced_.empty() || glm::distance(traced_.back(), at_tracker) > kTracedApart_mm) traced_.push_back(at_tracker);
}

}  // namespace ew::ui
