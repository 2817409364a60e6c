// The tracker against the mannequin: where the probe's face is, what is kept of its calibration, and whether it still fits.
#include <QDateTime>

#include "ew/tracking/calibration_file.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"

namespace ew::ui {
namespace {

std::filesystem::path calibrationsFolder() { return libraryFolder() / "trackers" / "calibrations"; }

std::string nowUtc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

}  // namespace

std::optional<ToolReading> Trackers::reading() const { return probe_ ? probe_->reading(session_.frames().now_s()) : std::nullopt; }

std::optional<ProbeFacePosition> Trackers::face() const {
  const auto now = reading();
  if (!now || now->state != TrackingState::live) return std::nullopt;
  const TrackerCalibration calibration = probe_->calibration();
  const Point<frame::Tracker> at = now->toolToTracker * (calibration.probeToTool * Point<frame::Probe>{});
  return ProbeFacePosition{at.at, (calibration.trackerToWorld * at).at, now->arrival_s};
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
    calibration.probeToTool = papers_.bodyCalled(tool).probeToTool;
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
  mannequin_.forget(id);
  keep(id, std::move(calibration));
}

void Trackers::keepAlignment(const std::string& id, const Transform<frame::World, frame::Tracker>& trackerToWorld,
                             const CalibrationQuality& quality) {
  TrackerCalibration calibration = calibrationOf(id);
  calibration.trackerToWorld = trackerToWorld;
  calibration.mannequin = mannequin_.name();
  calibration.alignment = quality;
  calibration.alignment.made = nowUtc();
  keep(id, std::move(calibration));
}

void Trackers::mannequinChanged() {
  fit_.reset();
  if (std::exchange(fitIsLost_, false)) Q_EMIT fitFound();
}

void Trackers::checkFit() {
  const auto skin = session_.probeControl().skin();
  if (!probe_ || !skin || !isAligned(used_)) return;
  const bool isUsed = session_.subject() && !session_.isFrozen() && !session_.isPlaying() &&
                      session_.probeControl().mover() == ProbeControl::Mover::tracker;
  fit_.add(probe_->poseAt(session_.frames().now_s()), *skin, isUsed);
  const Message problem = fit_.problem();
  if (problem.empty() == !fitIsLost_) return;
  fitIsLost_ = !problem.empty();
  if (fitIsLost_)
    Q_EMIT fitLost(words(problem));
  else
    Q_EMIT fitFound();
}

}  // namespace ew::ui
