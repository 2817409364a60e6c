#include "scan/cine/recorder.h"

#include <utility>

#include "ew/tracking/tracking_words.h"
#include "scan/session.h"

namespace ew::ui {

Recorder::Recorder(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::imageChanged, this, &Recorder::takeImage);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) {
    if (recording_) recording_->log.setFrozen(session_.frames().now_s(), frozen);
  });
  connect(&session_.probeControl(), &ProbeControl::poseMissed, this, &Recorder::takeMissed);
  second_.setInterval(1000);
  connect(&second_, &QTimer::timeout, this, &Recorder::changed);
}

void Recorder::start(const std::string& caseId) {
  if (recording_ || !session_.subject() || session_.isFrozen() || session_.isPlaying()) return;
  recording_ = std::make_shared<ScanRecording>();
  recording_->caseId = caseId;
  recording_->title = session_.subject()->title;
  begin_s_ = session_.frames().now_s();
  trackerState_.clear();
  // Nothing of the time before shows in what is recorded: it could not be shown again.
  session_.forgetImages();
  second_.start();
  Q_EMIT changed();
}

std::shared_ptr<const ScanRecording> Recorder::stop() {
  if (!recording_) return nullptr;
  second_.stop();
  const std::shared_ptr<const ScanRecording> made = std::exchange(recording_, nullptr);
  Q_EMIT changed();
  return made->log.frameCount() > 0 ? made : nullptr;
}

double Recorder::length_s() const { return recording_ ? session_.frames().now_s() - begin_s_ : 0.0; }

void Recorder::addNote(const std::string& kind, const nlohmann::json& what) {
  if (recording_) recording_->log.addNote(session_.frames().now_s(), kind, what);
}

void Recorder::takeImage() {
  // A frozen image is made again for a window of another size; it is no new one.
  if (!recording_ || session_.isFrozen() || session_.probeControl().isLost() || session_.image().isEmpty()) return;
  if (recording_->log.frameCount() == 0) recording_->size_px = {session_.image().width(), session_.image().height()};
  noteTracker("");
  recording_->log.addFrame(session_.shownState());
}

/// A frame without a usable pose: whoever reads the recording knows that there was nothing to see, and from when to when.
void Recorder::takeMissed() {
  if (!recording_ || recording_->log.frameCount() == 0) return;
  // It may have come back since: then the image that shows it is the next.
  if (session_.probeControl().tracking().state != TrackingState::live)
    noteTracker(stateWord(session_.probeControl().tracking().state).english());
  recording_->log.addFrame(session_.probeControl().missedState());
}

/// Why poses are missing, once for each reason. @param state empty: they are there
void Recorder::noteTracker(const std::string& state) {
  if (state == trackerState_) return;
  trackerState_ = state;
  addNote("tracking", {{"state", state.empty() ? stateWord(TrackingState::live).english() : state}});
}

}  // namespace ew::ui
