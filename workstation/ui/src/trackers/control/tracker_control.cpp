#include "trackers/control/tracker_control.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "ew/widgets/words.h"
#include "trackers/control/scan_server.h"

namespace ew::ui {
namespace {

constexpr int kTrackerPoll_ms = 100;
constexpr int kAxes_ms = 16;

/// Beside the settings.
std::filesystem::path trackersFile() { return pathOf(QFileInfo(QSettings().fileName()).dir().filePath(QStringLiteral("trackers.json"))); }

}  // namespace

Trackers::Trackers(Session& session, Jobs& jobs, QObject* parent)
    : QObject(parent),
      session_(session),
      jobs_(jobs),
      list_(usualTrackers()),
      mannequin_(session, [this](const std::string& id, const auto& trackerToWorld, const CalibrationQuality& quality) {
        keepAlignment(id, trackerToWorld, quality);
      }) {
  poll_.setInterval(kTrackerPoll_ms);
  connect(&poll_, &QTimer::timeout, this, &Trackers::lookAtDevice);
  axisTimer_.setInterval(kAxes_ms);
  axisTimer_.setTimerType(Qt::PreciseTimer);
  connect(&axisTimer_, &QTimer::timeout, this, &Trackers::moveByAxes);
}

Trackers::~Trackers() {
  session_.probeControl().setTracked(nullptr);
  stopDevice();
}

void Trackers::load() {
  const std::filesystem::path file = trackersFile();
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    if (auto kept = readTrackers(file)) {
      list_ = std::move(*kept);
    } else {
      listIsBroken_ = true;
      Q_EMIT problem(kept.error());
    }
  }
  papers_.read();
  if (list_.serves) serve(true, list_.servePort, list_.servesNetwork);
  Q_EMIT listChanged();
  if (list_.startsOn && find(list_.chosen) != nullptr) use(list_.chosen);
}

const TrackerSettings* Trackers::find(const std::string& id) const {
  const auto found = std::find_if(list_.trackers.begin(), list_.trackers.end(), [&](const TrackerSettings& each) { return each.id == id; });
  return found != list_.trackers.end() ? &*found : nullptr;
}

TrackerSettings* Trackers::findMutable(const std::string& id) { return const_cast<TrackerSettings*>(std::as_const(*this).find(id)); }

void Trackers::keepList() {
  if (listIsBroken_) return;
  if (const auto written = writeTrackers(list_, trackersFile()); !written) Q_EMIT problem(written.error());
}

std::string Trackers::add(TrackerSettings settings) {
  settings.id = newTrackerId(list_, settings.name);
  const std::string name = settings.name;
  const auto isTaken = [this](const std::string& wanted) {
    return std::any_of(list_.trackers.begin(), list_.trackers.end(), [&](const TrackerSettings& each) { return each.name == wanted; });
  };
  for (int n = 2; isTaken(settings.name); ++n) settings.name = name + " " + std::to_string(n);
  list_.trackers.push_back(settings);
  keepList();
  Q_EMIT listChanged();
  return settings.id;
}

void Trackers::change(const TrackerSettings& settings) {
  TrackerSettings* present = findMutable(settings.id);
  if (present == nullptr || *present == settings) return;
  const TrackerSettings before = std::exchange(*present, settings);
  keepList();
  if (used_ == settings.id) {
    if (before.source != settings.source) {
      stopDevice();
      start(settings);
    } else if (probe_) {
      probe_->setOptions(probeOptionsOf(settings));
    }
  }
  Q_EMIT listChanged();
}

void Trackers::remove(const std::string& id) {
  if (used_ == id) useMouse();
  if (std::erase_if(list_.trackers, [&](const TrackerSettings& each) { return each.id == id; }) == 0) return;
  if (list_.chosen == id) list_.chosen.clear();
  keepList();
  Q_EMIT listChanged();
}

void Trackers::use(const std::string& id) {
  const TrackerSettings* settings = find(id);
  if (settings == nullptr) return;
  session_.probeControl().chooseMouse(false);
  if (used_ == id && (device_ || axes_)) return;
  stopDevice();
  list_.chosen = id;
  list_.startsOn = true;
  keepList();
  start(*settings);
  Q_EMIT listChanged();
}

void Trackers::useMouse() {
  stopDevice();
  session_.probeControl().setTracked(nullptr);
  used_.clear();
  list_.startsOn = false;
  keepList();
  lookAtDevice();
  Q_EMIT listChanged();
}

void Trackers::start(const TrackerSettings& settings) {
  used_ = settings.id;
  readTool_.clear();
  readCalibration(settings.id);
  poll_.start();
  if (const auto* controller = std::get_if<HandControllerSettings>(&settings.source)) return startHandController(*controller);
  auto made = makeDevice(settings, papers_.bodies());
  if (!made) {
    session_.probeControl().setTracked(nullptr);
    Q_EMIT problem(made.error());
    used_.clear();
    return;
  }
  device_ = std::shared_ptr<TrackerDevice>(std::move(*made));
  camera_ = std::dynamic_pointer_cast<CameraDevice>(device_);
  device_->onNews(session_.probeControl().newsOfTracker());
  probe_ = std::make_shared<TrackedProbe>(device_, probeOptionsOf(settings), calibrationOf(settings.id),
                                          session_.probeControl().steadyMinusScan_s());
  session_.probeControl().setTracked(probe_);
  devices_.add([device = device_] { device->start(); });
}

void Trackers::startHandController(const HandControllerSettings& settings) {
  session_.probeControl().setTracked(nullptr);
  axes_ = std::shared_ptr<AxisDevice>(makeHandController(settings.kind));
  rateHand_.emplace(settings.hand);
  movedAt_s_ = steadyNow_s();
  devices_.add([axes = axes_] { axes->start(); });
  axisTimer_.start();
}

/// The scan goes on meanwhile: a device may take half a second to stop, so it does that elsewhere.
void Trackers::stopDevice() {
  axisTimer_.stop();
  rateHand_.reset();
  camera_.reset();
  if (device_) devices_.add([device = std::exchange(device_, nullptr)] { device->stop(); });
  if (axes_) devices_.add([axes = std::exchange(axes_, nullptr)] { axes->stop(); });
  probe_.reset();
  told_ = TrackingState::off;  // what comes next is news, whatever it is
  fit_.reset();
}

TrackingReport Trackers::report() const { return probe_ ? probe_->report(session_.frames().now_s()) : TrackingReport{}; }

DeviceStatus Trackers::deviceStatus() const {
  if (device_) return device_->status();
  DeviceStatus status;
  if (!axes_) return status;
  const AxisStatus axes = axes_->status();
  status.link = axes.link;
  status.sentence = axes.sentence;
  return status;
}

std::optional<CameraView> Trackers::cameraView() const { return camera_ ? std::optional(camera_->view()) : std::nullopt; }

void Trackers::setSoundsLost(bool sounds) {
  list_.soundsLost = sounds;
  keepList();
  Q_EMIT listChanged();
}

void Trackers::lookAtDevice() {
  const TrackingState state = report().state;
  if (state != told_) {
    told_ = state;
    Q_EMIT stateChanged(state);
  }
  if (used_.empty()) poll_.stop();
  if (probe_ && !used_.empty() && toolOf(used_) != readTool_) {  // its name has been heard of
    readCalibration(used_);
    probe_->setCalibration(calibrationOf(used_));
  }
  checkFit();
  Q_EMIT reported();
}

void Trackers::moveByAxes() {
  const double now_s = steadyNow_s();
  const double since_s = now_s - std::exchange(movedAt_s_, now_s);
  if (!axes_ || !rateHand_ || !session_.probeControl().skin() || session_.probeControl().handRests()) return;
  const std::vector<double> axes = axes_->axes();
  if (rateHand_->isAtRest(axes)) return;
  session_.probeControl().setHold(rateHand_->step(session_.probeControl().hold(), *session_.probeControl().skin(), axes, since_s));
}

}  // namespace ew::ui
