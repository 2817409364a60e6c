#include "plugins/host_scan.h"

#include <QPointer>
#include <algorithm>
#include <utility>

#include "ew/widgets/words.h"
#include "measure/calipers/calipers.h"
#include "scan/pick_layer.h"
#include "scan/session.h"

namespace ew::ui {

HostScan::HostScan(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::imageChanged, this, &HostScan::tellImage);
  connect(&session_.probeControl(), &ProbeControl::poseMissed, this, &HostScan::tellMissed);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) { tell({session_.frames().now_s(), FreezeChanged{frozen}}); });
  connect(&session_, &Session::subjectReplaced, this, [this] {
    told_.reset();
    ++subjects_;
  });
}

std::optional<ScanState> HostScan::state() const {
  if (!session_.subject() || session_.image().isEmpty()) return std::nullopt;
  return session_.probeControl().isLost() ? session_.probeControl().missedState() : session_.shownState();
}
DisplayImage HostScan::image() const { return session_.fanImage(); }
DisplayGeometry HostScan::geometry() const { return session_.fanGeometry(); }
Knobs HostScan::knobs() const { return session_.console().knobs(); }
double HostScan::now_s() const { return session_.frames().now_s(); }

sdk::Ticket HostScan::onEvent(EventCallback callback) {
  auto kept = std::make_shared<EventCallback>(std::move(callback));
  callbacks_.push_back(kept);
  return kept;
}

void HostScan::tell(const ScanEvent& event) {
  std::erase_if(callbacks_, [](const auto& one) { return one.expired(); });
  const auto now = callbacks_;  // a callback may register another
  for (const auto& weak : now)
    if (const auto callback = weak.lock()) (*callback)(event);
}

void HostScan::tellImage() {
  const auto made = state();
  // A frozen image that is drawn again for a window of another size is no new one.
  if (!made || session_.isFrozen() || session_.probeControl().isLost()) return;
  const auto before = std::exchange(told_, made);
  if (!before || before->probe != made->probe) tell({made->time_s, ProbeChosen{made->probe}});
  if (!before || before->knobs != made->knobs || !(before->pan == made->pan)) tell({made->time_s, SettingsChanged{made->knobs, made->pan}});
  if (!before || before->scene != made->scene) tell({made->time_s, SceneChanged{made->scene}});
  tell({made->time_s, FrameMade{made->pose, made->gaps_mm, made->number, made->body}});
}

/// No image of now, for want of a pose: told as the frame it would have been, so that nobody takes the image before for one of now.
void HostScan::tellMissed() {
  if (!told_) return;
  const ScanState& missed = session_.probeControl().missedState();
  tell({missed.time_s, FrameMade{missed.pose, {}, missed.number, missed.body}});
}

sdk::Ticket HostScan::drive(std::shared_ptr<const PoseSource> source, std::function<void()> takenBack) {
  auto driver = std::make_shared<Driver>(Driver{std::move(source), std::move(takenBack)});
  drivers_.push_back(driver);
  followLatest();
  // The ticket shares the driver, so that no later one can lie at its address.
  return {driver.get(), [host = QPointer<HostScan>(this), driver](void*) {
            if (host && std::erase(host->drivers_, driver) > 0) host->followLatest();
          }};
}

void HostScan::followLatest() { session_.probeControl().follow(drivers_.empty() ? nullptr : drivers_.back()->source); }

void HostScan::takeProbeBack() {
  const auto all = std::exchange(drivers_, {});
  followLatest();
  for (const auto& driver : all)
    if (driver->takenBack) driver->takenBack();
}

Result<void> HostScan::mayChange() const {
  if (!session_.subject()) return failure(ErrorCode::badUsage, say<"Nothing is scanned; open a case or a volume first.">());
  if (session_.isPlaying()) return failure(ErrorCode::badUsage, say<"A recording is shown; close it before the settings are changed.">());
  return {};
}

Result<void> HostScan::maySet() const {
  if (auto may = mayChange(); !may) return may;
  if (session_.isFrozen()) return failure(ErrorCode::badUsage, say<"The image is frozen; let it run before the settings are changed.">());
  return {};
}

Result<void> HostScan::placeProbe(const Transform<frame::World, frame::Probe>& probeToWorld) {
  if (auto may = maySet(); !may) return may;
  if (!session_.probeControl().skin()) return failure(ErrorCode::badUsage, say<"The body is still being read; try again in a moment.">());
  session_.probeControl().setHold(holdFor(Pose{.probeToWorld = probeToWorld}, *session_.probeControl().skin()));
  return {};
}

Result<void> HostScan::apply(const Knobs& knobs) {
  if (auto may = maySet(); !may) return may;
  session_.console().setKnobs(limited(knobs));
  return {};
}

Result<void> HostScan::chooseProbe(const std::string& id) {
  if (auto may = maySet(); !may) return may;
  const auto& probes = session_.console().probes();
  if (std::none_of(probes.begin(), probes.end(), [&](const Probe& probe) { return probe.id == id; }))
    return failure(ErrorCode::badUsage, say<"The probe '%1' is none of this case; choose one that it names.">(id));
  session_.console().chooseProbe(id);
  return {};
}

Result<void> HostScan::setFrozen(bool frozen) {
  if (auto may = mayChange(); !may) return may;
  session_.setFrozen(frozen);
  return {};
}

sdk::Ticket HostScan::keepSettings() {
  if (!mayChange()) return nullptr;
  struct Kept {
    std::string probe;
    Knobs knobs;
    Pan pan;
    Scene scene;
  };
  auto kept = std::make_shared<Kept>(
      Kept{session_.console().probe().id, session_.console().knobs(), session_.console().pan(), session_.console().scene()});
  const auto giveBack = [host = QPointer<HostScan>(this), kept, subject = subjects_] {
    // Another case has settings of its own.
    if (!host || host->subjects_ != subject || !host->maySet()) return;
    host->session_.console().chooseProbe(kept->probe);
    host->session_.console().setKnobs(kept->knobs);
    host->session_.console().setPan(kept->pan);
    host->session_.console().setScene(kept->scene);
  };
  return {kept.get(), [host = QPointer<HostScan>(this), giveBack](void*) {
            if (!host || !host->session_.isFrozen()) return giveBack();
            auto* once = new QObject(host.data());
            QObject::connect(&host->session_, &Session::frozenChanged, once, [once, giveBack] {
              once->deleteLater();
              giveBack();
            });
          }};
}

std::optional<sdk::Scanned> HostScan::scanned() const {
  const auto& subject = session_.subject();
  if (!subject) return std::nullopt;
  return sdk::Scanned{subject->placedGrid,         subject->labels,         subject->placedLabels, session_.probeControl().skin(),
                      session_.console().probes(), subject->voxels.volume()};
}

void HostScan::setCalipers(Calipers& calipers) {
  calipers_ = &calipers;
  connect(&calipers, &Calipers::linesChanged, this, [this] {
    std::erase_if(measured_, [](const auto& one) { return one.expired(); });
    const auto now = measured_;  // a callback may register another
    for (const auto& weak : now)
      if (const auto callback = weak.lock()) (*callback)();
  });
}

sdk::Ticket HostScan::onMeasured(std::function<void()> callback) {
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  measured_.push_back(kept);
  return kept;
}

std::vector<sdk::ScanMeasurement> HostScan::measurements() const {
  std::vector<sdk::ScanMeasurement> found;
  if (calipers_ == nullptr) return found;
  for (const Calipers::Line& line : calipers_->lines()) {
    if (line.where != Where::image || line.measured.figures.empty()) continue;
    sdk::ScanMeasurement one;
    one.number = line.measurement.number;
    one.kind = measurement::wordOf(line.measurement.caliper.kind);
    for (const auto& part : line.measurement.caliper.parts)
      for (const glm::dvec2& at : part.points) one.points.push_back({{at.x, at.y, 0.0}});
    for (const auto& figure : line.measured.figures) one.figures.push_back(measurement::figureOf(figure));
    found.push_back(std::move(one));
  }
  return found;
}

Result<void> HostScan::showLabels(std::optional<Volume> labels) {
  if (!session_.subject()) return failure(ErrorCode::badUsage, say<"Nothing is scanned; open a case or a volume first.">());
  session_.previewLabels(std::move(labels));
  return {};
}

Point<frame::Probe> HostScan::probePointOf(const QPoint& pixel) const {
  const glm::dvec2 at_mm = session_.geometry().probePoint_mm(pixel.x(), pixel.y());
  return {{at_mm.x, at_mm.y, 0.0}};
}

void HostScan::tellStroke(const QPoint& pixel, sdk::StrokeRequest::At sdk::StrokeRequest::*told) const {
  if (askings_.empty() || !askings_.back()->stroke) return;
  const auto asking = askings_.back();  // it may give its ticket back meanwhile
  if (const auto& call = (*asking->stroke).*told) call(probePointOf(pixel));
}

void HostScan::setPointing(PickLayer& layer) {
  pointing_ = &layer;
  connect(&layer, &PickLayer::picked, this, [this](const QPoint& pixel) {
    if (askings_.empty()) return;
    const auto asking = askings_.back();  // it may give its ticket back meanwhile
    if (asking->pointed) asking->pointed(probePointOf(pixel));
  });
  connect(&layer, &PickLayer::strokeBegun, this, [this](const QPoint& pixel) { tellStroke(pixel, &sdk::StrokeRequest::begun); });
  connect(&layer, &PickLayer::strokeMoved, this, [this](const QPoint& pixel) { tellStroke(pixel, &sdk::StrokeRequest::moved); });
  connect(&layer, &PickLayer::strokeEnded, this, [this](const QPoint& pixel) { tellStroke(pixel, &sdk::StrokeRequest::ended); });
  connect(&layer, &PickLayer::escaped, this, [this] {
    const auto all = std::exchange(askings_, {});
    for (const auto& asking : all)
      if (asking->stopped) asking->stopped();
  });
}

void HostScan::askLatest() {
  if (pointing_ == nullptr) return;
  if (!askings_.empty()) {
    const Asking& latest = *askings_.back();
    pointing_->setHint(latest.hint);
    pointing_->setStroke(latest.stroke ? std::optional(latest.stroke->radius_mm) : std::nullopt);
  }
  pointing_->setPicking(!askings_.empty());
}

sdk::Ticket HostScan::ask(Asking asked) {
  auto asking = std::make_shared<Asking>(std::move(asked));
  askings_.push_back(asking);
  askLatest();
  return {asking.get(), [host = QPointer<HostScan>(this), asking](void*) {
            if (host && std::erase(host->askings_, asking) > 0) host->askLatest();
          }};
}

sdk::Ticket HostScan::askForPoint(const std::string& hint, std::function<void(const Point<frame::Probe>&)> pointed,
                                  std::function<void()> stopped) {
  return ask({words(hint), std::move(pointed), std::move(stopped), {}});
}

sdk::Ticket HostScan::askForStroke(sdk::StrokeRequest request) {
  return ask({words(request.hint), {}, request.stopped, std::move(request)});
}

}  // namespace ew::ui
