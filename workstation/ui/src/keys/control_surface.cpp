#include "keys/control_surface.h"

#include <algorithm>

namespace ew::ui {

using controls::Binding;
using controls::ControlEvent;
using controls::Learner;
using controls::Motion;
using controls::Target;

ControlSurface::ControlSurface(QObject* parent) : QObject(parent) { makeHub(controls::systemBackends()); }

ControlSurface::~ControlSurface() = default;

void ControlSurface::makeHub(std::vector<std::unique_ptr<controls::Backend>> backends) {
  hub_.reset();
  hub_ = std::make_unique<controls::Hub>(std::move(backends), [this] {
    QMetaObject::invokeMethod(
        this, [this] { drain(); }, Qt::QueuedConnection);
  });
}

void ControlSurface::setBackends(std::vector<std::unique_ptr<controls::Backend>> backends) {
  makeHub(std::move(backends));
  wantDevices();
}

const SurfaceSetting* ControlSurface::setting(const std::string& id) const {
  const auto found =
      std::find_if(window_.settings.begin(), window_.settings.end(), [&](const SurfaceSetting& each) { return each.id == id; });
  return found != window_.settings.end() ? &*found : nullptr;
}

void ControlSurface::setBindings(std::vector<Binding> bindings) {
  bindings_ = std::move(bindings);
  followers_.clear();
  wantDevices();
}

void ControlSurface::wantDevices() {
  std::set<std::string> names;
  for (const Binding& each : bindings_) names.insert(each.control.device);
  hub_->want(std::move(names), isLearning() || isLooking_);
}

void ControlSurface::setLooking(bool looking) {
  isLooking_ = looking;
  wantDevices();
}

void ControlSurface::learn(const Target& target) {
  wanted_ = target;
  learner_.emplace(target.kind);
  wantDevices();
  Q_EMIT learningChanged();
}

void ControlSurface::stopLearning() {
  learner_.reset();
  followers_.clear();  // knobs were moved meanwhile
  wantDevices();
  Q_EMIT learningChanged();
}

Learner::Needs ControlSurface::learnerNeeds() const { return learner_ ? learner_->needs() : Learner::Needs::move; }

void ControlSurface::takeNow() {
  hub_->lookNow();
  drain();
}

void ControlSurface::drain() {
  for (const ControlEvent& event : hub_->takeEvents()) take(event);
  controls::Hub::State now = hub_->state();
  if (now == told_) return;
  told_ = std::move(now);
  Q_EMIT stateChanged();
}

void ControlSurface::take(const ControlEvent& event) {
  if (learner_) {
    const Learner::Needs before = learner_->needs();
    learner_->take(event);
    if (learner_->found()) return keep(*learner_->found());
    if (learner_->needs() != before) Q_EMIT learningChanged();
    return;
  }
  for (std::size_t n = 0; n < bindings_.size(); ++n)
    if (bindings_[n].control == event.id) follow(n, event.value);
}

void ControlSurface::keep(const controls::Learned& found) {
  QString before;
  const auto other = std::find_if(bindings_.begin(), bindings_.end(), [&](const Binding& each) { return each.control == found.control; });
  if (other != bindings_.end()) {
    const SurfaceSetting* did = other->target.kind == Target::Kind::setting ? setting(other->target.id) : nullptr;
    before = did != nullptr ? did->name : QString::fromStdString(other->target.id);
    bindings_.erase(other);
  }
  bindings_.push_back({found.control, found.encoding, wanted_, false});
  stopLearning();
  Q_EMIT learnt(before);
  Q_EMIT bindingsChanged();
}

void ControlSurface::follow(std::size_t n, int value) {
  const Binding& binding = bindings_[n];
  controls::Follower& follower = followers_[n];
  if (binding.target.kind == Target::Kind::action) {
    const std::string command = binding.target.id;  // what it does may change the bindings
    if (follower.take(binding, value, {}).kind == Motion::Kind::press) window_.doCommand(command);
    return;
  }
  const SurfaceSetting* moved = setting(binding.target.id);
  if (moved == nullptr) return;
  const Motion motion = follower.take(binding, value, moved->present());
  if (motion.kind == Motion::Kind::none) return;
  if (!moved->isThere()) return window_.say(tr("%1: off, or not there now.").arg(moved->name));
  if (motion.kind == Motion::Kind::wait) {
    const double present = moved->present().value_or(0.0);
    return window_.say(
        (motion.value < present ? tr("%1: turn the knob up until it meets %2.") : tr("%1: turn the knob down until it meets %2."))
            .arg(moved->name, moved->words()));
  }
  if (motion.kind == Motion::Kind::to)
    moved->to(motion.value);
  else
    moved->by(motion.value);
  if (const auto present = moved->present()) follower.settle(*present);
}

}  // namespace ew::ui
