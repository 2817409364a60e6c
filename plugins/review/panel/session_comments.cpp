// Comments as the document of the panel, and what counts.
#include <algorithm>
#include <chrono>

#include "ew/assessment/attempt_scoring.h"
#include "ew/core/json_fields.h"
#include "ew/sdk/window.h"
#include "ew/sdk/words.h"
#include "panel/review_session.h"

namespace ew::review {

using sdk::words;

namespace {

std::chrono::sys_seconds now() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

}  // namespace

std::string ReviewSession::title() const { return lesson() != nullptr ? lesson()->lesson.title : tr("Review").toStdString(); }

std::string ReviewSession::remark() const { return comments_ && !comments_->isSaved() ? tr("not saved").toStdString() : std::string(); }

std::string ReviewSession::unsaved() const {
  std::string lost = comments_ && !comments_->isSaved() ? tr("Comments on an attempt are not saved.").toStdString() : std::string();
  for (const auto& each : held_)
    if (const auto work = each.lock())
      if (const std::string more = work->unsaved(); !more.empty()) lost += (lost.empty() ? "" : " ") + more;
  return lost;
}

std::shared_ptr<void> ReviewSession::holdWork(HeldWork work) {
  auto kept = std::make_shared<HeldWork>(std::move(work));
  std::erase_if(held_, [](const auto& each) { return each.expired(); });
  held_.push_back(kept);
  return kept;
}

std::shared_ptr<void> ReviewSession::onChanged(std::function<void()> callback) {
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  listeners_.push_back(kept);
  return kept;
}

void ReviewSession::tellDocument() {
  std::erase_if(listeners_, [](const auto& each) { return each.expired(); });
  const auto all = listeners_;
  for (const auto& each : all)
    if (const auto callback = each.lock()) (*callback)();
}

bool ReviewSession::openComments() {
  others_.clear();
  comments_.reset();
  const ReviewScan* scan = opened(kReviewed);
  if (scan == nullptr || scan->scan->choice.attempt.empty()) return false;
  const auto& folder = scan->scan->choice.attempt;
  for (CommentFile& file : listComments(folder).files)
    if (file.author != reviewer_.toStdString()) others_.push_back(std::move(file));
  auto opened = CommentHistory::open(folder, reviewer_.toStdString());
  if (!opened) {
    host_.window().error(words(opened.error()).toStdString(), "review comments");
    return false;
  }
  comments_ = std::move(*opened);
  return true;
}

/// Before something else is reviewed nothing that was said is lost. @return false: it could not be kept, and nothing else is opened
bool ReviewSession::saveComments() {
  if (!comments_ || comments_->isSaved()) return true;
  const auto saved = comments_->save();
  if (!saved) host_.window().error(words(saved.error()).toStdString(), "review comments");
  tellDocument();
  return saved.has_value();
}

/// What pages hold may become comments: it is asked for first. @return false: as saveComments
bool ReviewSession::keepAll() {
  bool areKept = true;
  const auto held = held_;
  for (const auto& each : held)
    if (const auto work = each.lock()) areKept = work->keep() && areKept;
  return saveComments() && areKept;
}

void ReviewSession::save(bool) { static_cast<void>(keepAll()); }

void ReviewSession::undo() {
  if (!comments_) return;
  comments_->undo();
  setTracks();
  Q_EMIT commentsChanged();
  tellDocument();
}

void ReviewSession::redo() {
  if (!comments_) return;
  comments_->redo();
  setTracks();
  Q_EMIT commentsChanged();
  tellDocument();
}

std::vector<ReviewComment> ReviewSession::commentsHere() const {
  std::vector<ReviewComment> here;
  const ReviewScan* scan = opened(kReviewed);
  if (!comments_ || scan == nullptr || !scan->scan->choice.outcome) return here;
  for (const ReviewComment& each : comments_->comments())
    if (each.stepId == scan->scan->choice.stepId && each.recording == scan->scan->choice.outcome->recording) here.push_back(each);
  return here;
}

std::string ReviewSession::addComment(const QString& text, std::vector<CommentStroke> strokes) {
  const ReviewScan* scan = opened(kReviewed);
  if (reviewer_.isEmpty()) Q_EMIT reviewerWanted();  // one may be typed and not entered yet
  if (!comments_ || scan == nullptr || !scan->scan->choice.outcome || reviewer_.isEmpty()) return {};
  ReviewComment made;
  made.stepId = scan->scan->choice.stepId;
  made.recording = scan->scan->choice.outcome->recording;
  made.time_s = std::max(0.0, time_s(kReviewed));
  made.text = text.toStdString();
  made.strokes = std::move(strokes);
  const Pose pose = scan->scan->recording.log.frame(frame(kReviewed)).pose;
  if (pose.status == PoseStatus::ok) made.probeToWorld = pose.probeToWorld;
  made.at = now();
  chosenComment_ = comments_->add(std::move(made), tr("comment").toStdString());
  setTracks();
  Q_EMIT commentsChanged();
  tellDocument();
  return chosenComment_;
}

void ReviewSession::editComment(const ReviewComment& comment, const QString& what, const std::string& mergeKey) {
  if (!comments_) return;
  comments_->replace(comment, what.toStdString(), mergeKey);
  setTracks();
  Q_EMIT commentsChanged();
  tellDocument();
}

void ReviewSession::removeComment(const std::string& id) {
  if (!comments_) return;
  comments_->remove(id, tr("remove the comment").toStdString());
  if (chosenComment_ == id) chosenComment_.clear();
  setTracks();
  Q_EMIT commentsChanged();
  tellDocument();
}

void ReviewSession::chooseComment(const std::string& id) {
  if (id == chosenComment_) return;
  chosenComment_ = id;
  if (comments_) comments_->endMerging();
  Q_EMIT commentsChanged();
}

void ReviewSession::showComment(const ReviewComment& comment) {
  pause();
  seek(onClock_s(kReviewed, comment.time_s));
  chooseComment(comment.id);
}

void ReviewSession::setShowsClass(bool shown) {
  if (shown == showsClass_) return;
  pause();
  showsClass_ = shown;
  Q_EMIT pageChanged();
}

void ReviewSession::readPlan() {
  plan_ = {};
  if (lesson() == nullptr) return;
  auto read = ew::readPlan(libraryFolder(), lesson()->home.id, lesson()->lesson.id);
  if (!read) return host_.window().error(words(read.error()).toStdString(), "review plan");
  plan_ = std::move(*read);
  plan_.caseId = lesson()->home.id;
  plan_.lessonId = lesson()->lesson.id;
}

AttemptResult ReviewSession::resultOf(std::size_t number) const { return review::resultOf(*lesson(), number, plan_, records_, results_); }

std::vector<ClassAttempt> ReviewSession::classAttempts() const {
  return lesson() != nullptr ? classOf(*lesson(), plan_, records_, results_) : std::vector<ClassAttempt>();
}

bool ReviewSession::mayReadRaters(const std::filesystem::path& attempt) const {
  const auto word = records_.ratersWords.find(attempt);
  return word != records_.ratersWords.end() && word->second.openTo.contains(reviewer_.toStdString());
}

bool ReviewSession::keepStanding(const std::string& attemptId, Standing standing) {
  auto kept = ew::keepStanding(libraryFolder(), attemptId, standing, reviewer_.toStdString());
  if (!kept) {
    host_.window().error(words(kept.error()).toStdString(), "review standings");
    return false;
  }
  records_.standings = std::move(*kept);
  records_.problem.reset();
  return true;
}

void ReviewSession::takeRating(const std::filesystem::path& attempt) {
  records_.readRatings(attempt);
  Q_EMIT scoresChanged();
}

const AttemptScore* ReviewSession::scoreOf(std::size_t number) const {
  if (lesson() == nullptr || number >= lesson()->attempts.size()) return nullptr;
  const auto score = records_.scores.find(lesson()->attempts[number].first);
  return score == records_.scores.end() ? nullptr : &score->second;
}

std::vector<MetricValue> ReviewSession::metricsOf(Side side) const {
  const ReviewScan* scan = opened(side);
  if (scan == nullptr) return {};
  const auto& folder = scan->scan->choice.attempt;
  for (std::size_t n = 0; lesson() != nullptr && !folder.empty() && n < lesson()->attempts.size(); ++n)
    if (const AttemptScore* score = scoreOf(n); score != nullptr && lesson()->attempts[n].first == folder)
      if (const StepScore* scored = score->of(stepId_); scored != nullptr && score->planRevision == plan_.revision) return scored->metrics;
  return scan->metrics;
}

void ReviewSession::keepPlan(AssessmentPlan plan) {
  plan.changedBy = reviewer_.toStdString();
  plan.changedAt = now();
  auto kept = ew::keepPlan(libraryFolder(), std::move(plan));
  if (!kept) return host_.window().error(words(kept.error()).toStdString(), "review plan");
  plan_ = std::move(*kept);
  Q_EMIT scoresChanged();
  scoreAll();
}

void ReviewSession::scoreAll() {
  if (scoring_ || lesson() == nullptr) return;
  std::vector<std::filesystem::path> folders;
  for (const auto& [folder, tried] : lesson()->attempts) folders.push_back(folder);
  if (folders.empty()) return;
  scoring_ = true;
  Q_EMIT scoresChanged();
  auto scored = std::make_shared<std::vector<AssessedAttempt>>();
  host_.jobs().start(
      tr("Scoring the attempts").toStdString(),
      [scored, folders](Progress& progress) -> Result<void> {
        *scored = assess(folders, libraryFolder(), {.threads = 1}, progress);
        for (const AssessedAttempt& each : *scored)
          if (each.problem) return passOn(*each.problem);
        return {};
      },
      [this, scored, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        scoring_ = false;
        for (AssessedAttempt& each : *scored)
          if (each.score) records_.scores.insert_or_assign(each.folder, std::move(*each.score));
        if (!done && done.error().code != ErrorCode::cancelled) host_.window().warn(words(done.error()).toStdString(), "review scores");
        Q_EMIT scoresChanged();
      });
}

}  // namespace ew::review
