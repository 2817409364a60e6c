#include "ew/scanning/events.h"

#include <algorithm>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

void ScanLog::addFrame(const ScanState& made) {
  if (probe_ == kNone || std::get<ProbeChosen>(events_[probe_].what).probe != made.probe) add({made.time_s, ProbeChosen{made.probe}});
  const SettingsChanged settings{made.knobs, made.pan};
  if (settings_ == kNone || std::get<SettingsChanged>(events_[settings_].what) != settings) add({made.time_s, settings});
  if (scene_ == kNone || std::get<SceneChanged>(events_[scene_].what).scene != made.scene) add({made.time_s, SceneChanged{made.scene}});
  add({made.time_s, FrameMade{made.pose, made.gaps_mm, made.number, made.body}});
}

void ScanLog::setFrozen(double time_s, bool isFrozen) {
  if (isFrozenAt(std::max(time_s, end_s())) != isFrozen) add({time_s, FreezeChanged{isFrozen}});
}

void ScanLog::addNote(double time_s, std::string kind, nlohmann::json what) { add({time_s, Note{std::move(kind), std::move(what)}}); }

void ScanLog::add(ScanEvent event) {
  if (!events_.empty()) event.time_s = std::max(event.time_s, end_s());
  const std::size_t index = events_.size();
  if (std::holds_alternative<ProbeChosen>(event.what)) probe_ = index;
  if (std::holds_alternative<SettingsChanged>(event.what)) settings_ = index;
  if (std::holds_alternative<SceneChanged>(event.what)) scene_ = index;
  if (std::holds_alternative<FrameMade>(event.what)) {
    if (probe_ == kNone) return;
    frames_.push_back({index, probe_, settings_, scene_});
  }
  events_.push_back(std::move(event));
}

double ScanLog::begin_s() const { return events_.empty() ? 0.0 : events_.front().time_s; }
double ScanLog::end_s() const { return events_.empty() ? 0.0 : events_.back().time_s; }

ScanState ScanLog::frame(std::size_t n) const {
  ScanState state;
  frame(n, state);
  return state;
}

void ScanLog::frame(std::size_t n, ScanState& state) const {
  const FrameMade& made = this->made(n);
  const Frame& at = frames_[n];
  state.probe = std::get<ProbeChosen>(events_[at.probe].what).probe;
  const auto* settings = at.settings != kNone ? &std::get<SettingsChanged>(events_[at.settings].what) : nullptr;
  state.knobs = settings != nullptr ? settings->knobs : Knobs();
  state.pan = settings != nullptr ? settings->pan : Pan();
  if (at.scene != kNone)
    state.scene = std::get<SceneChanged>(events_[at.scene].what).scene;
  else
    state.scene = Scene();
  state.pose = made.pose;
  state.gaps_mm = made.gaps_mm;
  state.time_s = events_[at.event].time_s;
  state.number = made.number;
  state.body = made.body;
}

const FrameMade& ScanLog::made(std::size_t n) const {
  EW_EXPECTS(n < frames_.size());
  return std::get<FrameMade>(events_[frames_[n].event].what);
}

double ScanLog::frameTime_s(std::size_t n) const {
  EW_EXPECTS(n < frames_.size());
  return events_[frames_[n].event].time_s;
}

std::size_t ScanLog::frameAt(double time_s) const {
  EW_EXPECTS(!frames_.empty());
  const auto after = std::upper_bound(frames_.begin(), frames_.end(), time_s,
                                      [this](double time, const Frame& frame) { return time < events_[frame.event].time_s; });
  return after == frames_.begin() ? 0 : static_cast<std::size_t>(after - frames_.begin()) - 1;
}

bool ScanLog::isFrozenAt(double time_s) const {
  bool isFrozen = false;
  for (const ScanEvent& event : events_) {
    if (event.time_s > time_s) break;
    if (const auto* change = std::get_if<FreezeChanged>(&event.what)) isFrozen = change->isFrozen;
  }
  return isFrozen;
}

}  // namespace ew
