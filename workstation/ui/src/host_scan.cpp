#include "host_scan.h"

#include <QPointer>
#include <algorithm>
#include <utility>

#include "session.h"

namespace ew::ui {

HostScan::HostScan(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::pictureChanged, this, &HostScan::tellPicture);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) { tell({session_.now_s(), FreezeChanged{frozen}}); });
  connect(&session_, &Session::subjectReplaced, this, [this] {
    told_.reset();
    ++subjects_;
  });
}

std::optional<ScanState> HostScan::state() const {
  if (!session_.subject() || session_.picture().isEmpty()) return std::nullopt;
  return session_.shownState();
}
Picture HostScan::picture() const { return session_.fanPicture(); }
DisplayGeometry HostScan::geometry() const { return session_.fanGeometry(); }
Knobs HostScan::knobs() const { return session_.knobs(); }
double HostScan::now_s() const { return session_.now_s(); }

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

void HostScan::tellPicture() {
  const auto made = state();
  // A frozen image that is drawn again for a window of another size is no new one.
  if (!made || session_.isFrozen()) return;
  const auto before = std::exchange(told_, made);
  if (!before || before->probe != made->probe) tell({made->time_s, ProbeChosen{made->probe}});
  if (!before || before->knobs != made->knobs || !(before->pan == made->pan)) tell({made->time_s, SettingsChanged{made->knobs, made->pan}});
  if (!before || before->scene != made->scene) tell({made->time_s, SceneChanged{made->scene}});
  tell({made->time_s, FrameMade{made->pose, made->gaps_mm, made->number, made->body}});
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

void HostScan::followLatest() { session_.follow(drivers_.empty() ? nullptr : drivers_.back()->source); }

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

Result<void> HostScan::apply(const Knobs& knobs) {
  if (auto may = maySet(); !may) return may;
  session_.setKnobs(limited(knobs));
  return {};
}

Result<void> HostScan::chooseProbe(const std::string& id) {
  if (auto may = maySet(); !may) return may;
  const auto& probes = session_.probes();
  if (std::none_of(probes.begin(), probes.end(), [&](const Probe& probe) { return probe.id == id; }))
    return failure(ErrorCode::badUsage, say<"The probe '%1' is none of this case; choose one that it names.">(id));
  session_.chooseProbe(id);
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
  auto kept = std::make_shared<Kept>(Kept{session_.probe().id, session_.knobs(), session_.pan(), session_.scene()});
  const auto giveBack = [host = QPointer<HostScan>(this), kept, subject = subjects_] {
    // Another case has settings of its own.
    if (!host || host->subjects_ != subject || !host->maySet()) return;
    host->session_.chooseProbe(kept->probe);
    host->session_.setKnobs(kept->knobs);
    host->session_.setPan(kept->pan);
    host->session_.setScene(kept->scene);
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

}  // namespace ew::ui
