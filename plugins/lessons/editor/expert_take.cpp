#include "editor/expert_take.h"

#include <utility>

#include "ew/scanning/recording_journal.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "logic/step_autosave.h"

namespace ew::lessons {

ExpertTake::ExpertTake(sdk::Host& host, QObject* parent) : QObject(parent), host_(host), kept_(autosaveFolder()) {
  timer_.setInterval(200);
  connect(&timer_, &QTimer::timeout, this, &ExpertTake::tick);
  tickets_ = {host_.scan().onEvent([this](const ScanEvent& event) {
                if (!recorder_.isRecording()) return;
                const DisplayImage display = host_.scan().image();
                recorder_.see(event, host_.scan().state(), {display.width(), display.height()});
              }),
              host_.caseParts().onOpened([this](const std::filesystem::path& folder) { followCase(folder); }),
              host_.window().onClosing([this] {
                return recorder_.isRecording() ? tr("An expert's scan is being recorded and not kept yet.").toStdString() : std::string();
              })};
}

void ExpertTake::followCase(const std::filesystem::path& folder) {
  const std::filesystem::path before = std::exchange(open_, folder);
  if (!recorder_.isRecording() || folder == folder_) return;
  // A case that is saved elsewhere is scanned as before; the volume of another one is not scanned yet when it is told of.
  if (before == folder_ && !folder.empty() && host_.cases().scan()) {
    folder_ = folder;
    if (events_ > 0) describe();
    Q_EMIT changed();
    return;
  }
  if (recorder_.isPaused()) return;
  pause();
  host_.window().info(
      tr("The recording of the expert's scan is paused, because another case was opened; it goes on in its own case.").toStdString(),
      "expert scan");
}

Result<void> ExpertTake::start(const std::string& lessonId, const std::string& stepId, const std::string& caseId,
                               const std::string& title) {
  const auto image = host_.scan().state();
  if (!image) return failure(ErrorCode::badUsage, say<"Nothing is scanned; wait until the volume of the case is shown.">());
  if (auto live = host_.scan().setFrozen(false); !live) return live;
  folder_ = open_ = host_.cases().currentFolder();
  title_ = title;
  forgetKept();
  lessonId_ = lessonId;
  stepId_ = stepId;
  const double now_s = host_.scan().now_s();
  recorder_.start(caseId, title, now_s);
  // A probe that rests makes no image by itself: the scan begins with what is shown.
  const DisplayImage display = host_.scan().image();
  recorder_.see({now_s, FrameMade{image->pose, image->gaps_mm, image->number, image->body}}, image, {display.width(), display.height()});
  timer_.start();
  Q_EMIT changed();
  return {};
}

bool ExpertTake::isFor(const std::string& lessonId, const std::string& stepId) const {
  return isOfOpenCase() && lessonId == lessonId_ && stepId == stepId_;
}

bool ExpertTake::isOfOpenCase() const { return recorder_.isRecording() && host_.cases().currentFolder() == folder_; }

double ExpertTake::length_s() const { return recorder_.length_s(host_.scan().now_s()); }

void ExpertTake::pause() {
  recorder_.pause(host_.scan().now_s());
  timer_.stop();
  Q_EMIT changed();
}

void ExpertTake::goOn() {
  if (recorder_.isFull(host_.scan().now_s())) return;
  recorder_.goOn(host_.scan().now_s());
  timer_.start();
  Q_EMIT changed();
}

void ExpertTake::mark() {
  recorder_.mark(host_.scan().now_s());
  Q_EMIT changed();
}

Result<ScanRecording> ExpertTake::stop(std::vector<double>& marks_s) {
  timer_.stop();
  const auto image = host_.scan().state();
  if (image && !recorder_.isPaused()) {  // a hand that has come to rest is seen until the end
    const DisplayImage display = host_.scan().image();
    recorder_.see({host_.scan().now_s(), FrameMade{image->pose, image->gaps_mm, image->number, image->body}}, image,
                  {display.width(), display.height()});
  }
  keep();
  auto made = recorder_.stop(host_.scan().now_s());
  marks_s = recorder_.marks_s();
  Q_EMIT changed();
  return made;
}

void ExpertTake::setKeeping(bool keeping) {
  keeping_ = keeping;
  Q_EMIT changed();
}

void ExpertTake::forgetKept() {
  events_ = 0;
  kept_.forget();
}

void ExpertTake::describe() { kept_.describe({{"kind", "expert_scan"}, {"path", folder_.string()}, {"title", title_}}); }

/// What was recorded since it was kept last.
void ExpertTake::keep() {
  const ScanRecording& growing = recorder_.growing();
  if (growing.log.frameCount() == 0 || growing.log.events().size() == events_) return;
  if (events_ == 0) describe();
  kept_.append("recording.jsonl", (events_ == 0 ? journalHead(growing) : std::string()) + journalLines(growing.log, events_));
  events_ = growing.log.events().size();
}

void ExpertTake::discard() {
  keeping_ = false;
  timer_.stop();
  forgetKept();
  recorder_.discard();
  Q_EMIT changed();
}

void ExpertTake::tick() {
  if (!recorder_.isPaused() && recorder_.isFull(host_.scan().now_s())) {
    pause();
    keep();
    Q_EMIT full();
    return;
  }
  keep();
  Q_EMIT changed();
}

}  // namespace ew::lessons
