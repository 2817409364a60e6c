// The tracker against the mannequin: where the probe's face is, what was touched, and whether it still fits.
#include <QDateTime>
#include <algorithm>

#include "ew/tracking/calibration_file.h"
#include "trackers/control/tracker_control.h"
#include "widgets/words.h"

namespace ew::ui {
namespace {

constexpr std::size_t kFewestTraced = 30;
constexpr double kTracedApart_mm = 2.0;  ///< a probe that rests traces nothing new

std::filesystem::path calibrationsFolder() { return libraryFolder() / "trackers" / "calibrations"; }

std::string nowUtc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

}  // namespace

std::vector<BodyLandmark> Trackers::landmarks() const {
  auto known = landmarksOf(window_.mannequin ? window_.mannequin() : std::string());
  if (!known) known = landmarksOf({});
  return known ? std::move(known->landmarks) : std::vector<BodyLandmark>{};
}

std::vector<glm::dvec3> Trackers::landmarkPlaces() const {
  std::vector<glm::dvec3> places;
  for (const BodyLandmark& each : landmarks()) places.push_back(each.at_mm);
  return places;
}

std::vector<glm::vec3> Trackers::bodyPoints() const { return window_.bodyPoints_mm ? window_.bodyPoints_mm() : std::vector<glm::vec3>{}; }

double Trackers::gap_mm(const Skin& skin, const glm::dvec3& at_world) {
  const Skin::Contact nearest = skin.nearest(at_world);
  const glm::dvec3 away = at_world - nearest.point_mm;
  return glm::dot(away, nearest.outward) < 0.0 ? -glm::length(away) : glm::length(away);
}

std::optional<ToolReading> Trackers::reading() const { return probe_ ? probe_->reading(session_.frames().now_s()) : std::nullopt; }

std::optional<TrackedFace> Trackers::face() const {
  const auto now = reading();
  if (!now || now->state != TrackingState::live) return std::nullopt;
  const TrackerCalibration calibration = probe_->calibration();
  const Point<frame::Tracker> at = now->toolToTracker * (calibration.probeToTool * Point<frame::Probe>{});
  return TrackedFace{at.at, (calibration.trackerToWorld * at).at, now->arrival_s};
}

std::string Trackers::toolOf(const std::string& id) const {
  const TrackerSettings* settings = find(id);
  if (settings == nullptr) return {};
  if (std::holds_alternative<CameraSource>(settings->source)) return bodyOf(id);
  return !settings->probe.tool.empty() || used_ != id ? settings->probe.tool : report().tool;
}

/// What was kept for the tool that carries the probe; of a paper body at least where its file says that the face lies.
void Trackers::readCalibration(const std::string& id) {
  const std::string tool = toolOf(id);
  if (used_ == id) readTool_ = tool;
  auto kept = latestCalibration(calibrationsFolder(), id, tool);
  if (!kept) Q_EMIT problem(kept.error());
  TrackerCalibration calibration = kept ? std::move(*kept) : TrackerCalibration{};
  if (calibration.revision == 0) {
    calibration.source = id;
    calibration.tool = tool;
    calibration.face.method = "none";
    calibration.alignment.method = "none";
  }
  if (cameraOf(id) != nullptr && calibration.face.method != "pivot_and_flat") {
    calibration.body = tool;
    calibration.probeToTool = bodyCalled(tool).probeToTool;
    calibration.face.method = "body_file";
  }
  calibrations_[id] = std::move(calibration);
}

TrackerCalibration Trackers::calibrationOf(const std::string& id) const {
  const auto known = calibrations_.find(id);
  return known != calibrations_.end() ? known->second : TrackerCalibration{};
}

bool Trackers::isAligned(const std::string& id) const {
  const auto known = calibrations_.find(id);
  if (known == calibrations_.end()) return false;
  const std::string& method = known->second.alignment.method;
  return !method.empty() && method != "none";
}

void Trackers::keep(const std::string& id, TrackerCalibration calibration) {
  calibration.source = id;
  calibration.tool = toolOf(id);
  calibration.reference = probe_ ? probe_->options().reference : std::string();
  auto kept = keepCalibration(calibrationsFolder(), calibration);
  if (!kept) Q_EMIT problem(kept.error());
  calibrations_[id] = kept ? std::move(*kept) : std::move(calibration);
  if (used_ == id && probe_) probe_->setCalibration(calibrations_[id]);
  fit_.reset();
  if (std::exchange(fitIsLost_, false)) Q_EMIT fitFound();
  Q_EMIT listChanged();
}

void Trackers::keepFace(const std::string& id, const Transform<frame::Tool, frame::Probe>& probeToTool, const CalibrationQuality& quality) {
  TrackerCalibration calibration = calibrationOf(id);
  calibration.probeToTool = probeToTool;
  calibration.face = quality;
  calibration.face.made = nowUtc();
  // What was touched was touched with another face.
  calibration.alignment = {};
  calibration.alignment.method = "none";
  calibration.trackerToWorld = {};
  aligning_.erase(id);
  keep(id, std::move(calibration));
}

const std::vector<TrackerTouch>& Trackers::touches(const std::string& id) { return aligning_[id].touches; }
const TrackerAlignment& Trackers::alignment(const std::string& id) { return aligning_[id].found; }

void Trackers::setTouches(const std::string& id, std::vector<TrackerTouch> touches) {
  aligning_[id].touches = std::move(touches);
  findAlignment(id, {});
}

void Trackers::findAlignment(const std::string& id, const std::vector<glm::dvec3>& traced) {
  Aligning& aligning = aligning_[id];
  const std::vector<BodyLandmark> known = landmarks();
  std::vector<TouchedLandmark> touched;
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
  TrackerCalibration calibration = calibrationOf(id);
  calibration.trackerToWorld = best.trackerToWorld;
  calibration.mannequin = window_.mannequin ? window_.mannequin() : std::string();
  calibration.alignment = {isTraced ? "surface" : "landmarks", nowUtc(), best.rms_mm, best.expected_mm, best.used};
  keep(id, std::move(calibration));
}

void Trackers::beginTracing(const std::string&) { traced_.clear(); }

void Trackers::trace(const glm::dvec3& at_tracker) {
  if (traced_.empty() || glm::distance(traced_.back(), at_tracker) > kTracedApart_mm) traced_.push_back(at_tracker);
}

void Trackers::endTracing(const std::string& id) { findAlignment(id, traced_); }

void Trackers::mannequinChanged() {
  fit_.reset();
  if (std::exchange(fitIsLost_, false)) Q_EMIT fitFound();
}

void Trackers::checkFit() {
  if (!probe_ || !skin() || !isAligned(used_)) return;
  const bool isUsed = session_.subject() && !session_.isFrozen() && !session_.isPlaying() &&
                      session_.probeControl().mover() == ProbeControl::Mover::tracker;
  fit_.add(probe_->poseAt(session_.frames().now_s()), *skin(), isUsed);
  const Message problem = fit_.problem();
  if (problem.empty() == !fitIsLost_) return;
  fitIsLost_ = !problem.empty();
  if (fitIsLost_)
    Q_EMIT fitLost(words(problem));
  else
    Q_EMIT fitFound();
}

}  // namespace ew::ui
