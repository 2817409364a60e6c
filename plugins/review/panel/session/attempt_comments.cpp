#include "panel/session/attempt_comments.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ew/sdk/window.h"
#include "ew/widgets/words.h"

namespace ew::review {

namespace {

constexpr int kPauseInSaying_ms = 5000;

}  // namespace

AttemptComments::AttemptComments(sdk::Host& host, const ScanPair& scans, Playback& playback, const Reviewer& reviewer)
    : host_(host), scans_(scans), playback_(playback), reviewer_(reviewer) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseInSaying_ms);
  connect(this, &AttemptComments::changed, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &AttemptComments::save);
}

void AttemptComments::open() {
  others_.clear();
  history_.reset();
  const ReviewScan* scan = scans_.opened(kReviewed);
  if (scan == nullptr || scan->scan->choice.attempt.empty()) return;
  const auto& folder = scan->scan->choice.attempt;
  for (CommentFile& file : listComments(folder).files)
    if (file.author != reviewer_.name().toStdString()) others_.push_back(std::move(file));
  auto opened = CommentHistory::open(folder, reviewer_.name().toStdString());
  if (!opened) return host_.window().error(words(opened.error()).toStdString(), "review comments");
  history_ = std::move(*opened);
}

void AttemptComments::takeScans() {
  chosen_.clear();
  // They stay open, with their steps of undo, while only what the scan is compared with changes.
  const ReviewScan* scan = scans_.opened(kReviewed);
  const bool isSame = history_ && scan != nullptr && history_->attempt() == scan->scan->choice.attempt &&
                      history_->author() == reviewer_.name().toStdString();
  if (!isSame) open();
  setTracks();
}

void AttemptComments::takeReviewer() {
  open();
  setTracks();
}

void AttemptComments::setTracks() {
  std::vector<ReviewComment> comments = here();
  if (const ReviewScan* scan = scans_.opened(kReviewed); scan != nullptr && scan->scan->choice.outcome)
    for (const CommentFile& file : others_)
      for (const ReviewComment& each : file.comments)
        if (each.stepId == scan->scan->choice.stepId && each.recording == scan->scan->choice.outcome->recording) comments.push_back(each);
  playback_.setTracks(comments);
}

void AttemptComments::tellEdited() {
  setTracks();
  Q_EMIT changed();
  Q_EMIT documentChanged();
}

/// Before something else is reviewed nothing that was said is lost. @return false: it could not be kept, and nothing else is opened
bool AttemptComments::save() {
  if (isSaved()) return true;
  const auto saved = history_->save();
  if (!saved) host_.window().error(words(saved.error()).toStdString(), "review comments");
  Q_EMIT documentChanged();
  return saved.has_value();
}

void AttemptComments::undo() {
  if (!history_) return;
  history_->undo();
  tellEdited();
}

void AttemptComments::redo() {
  if (!history_) return;
  history_->redo();
  tellEdited();
}

std::vector<ReviewComment> AttemptComments::here() const {
  std::vector<ReviewComment> here;
  const ReviewScan* scan = scans_.opened(kReviewed);
  if (!history_ || scan == nullptr || !scan->scan->choice.outcome) return here;
  for (const ReviewComment& each : history_->comments())
    if (each.stepId == scan->scan->choice.stepId && each.recording == scan->scan->choice.outcome->recording) here.push_back(each);
  return here;
}

std::string AttemptComments::add(const QString& text, std::vector<CommentStroke> strokes) {
  const ReviewScan* scan = scans_.opened(kReviewed);
  if (reviewer_.name().isEmpty()) Q_EMIT reviewerWanted();  // one may be typed and not entered yet
  if (!history_ || scan == nullptr || !scan->scan->choice.outcome || reviewer_.name().isEmpty()) return {};
  ReviewComment made;
  made.stepId = scan->scan->choice.stepId;
  made.recording = scan->scan->choice.outcome->recording;
  made.time_s = std::max(0.0, playback_.time_s(kReviewed));
  made.text = text.toStdString();
  made.strokes = std::move(strokes);
  const Pose pose = scan->scan->recording.log.frame(playback_.frame(kReviewed)).pose;
  if (pose.status == PoseStatus::ok) made.probeToWorld = pose.probeToWorld;
  made.at = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  chosen_ = history_->add(std::move(made), tr("comment").toStdString());
  tellEdited();
  return chosen_;
}

void AttemptComments::edit(const ReviewComment& comment, const QString& what, const std::string& mergeKey) {
  if (!history_) return;
  history_->replace(comment, what.toStdString(), mergeKey);
  tellEdited();
}

void AttemptComments::remove(const std::string& id) {
  if (!history_) return;
  history_->remove(id, tr("remove the comment").toStdString());
  if (chosen_ == id) chosen_.clear();
  tellEdited();
}

void AttemptComments::choose(const std::string& id) {
  if (id == chosen_) return;
  chosen_ = id;
  if (history_) history_->endMerging();
  Q_EMIT changed();
}

void AttemptComments::show(const ReviewComment& comment) {
  playback_.pause();
  playback_.seek(playback_.onClock_s(kReviewed, comment.time_s));
  choose(comment.id);
}

}  // namespace ew::review
