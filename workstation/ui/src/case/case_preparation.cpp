#include "case/case_preparation.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/quiet_work.h"
#include "ew/library/case_words.h"
#include "ew/library/preparation.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kOneThread = 1;
constexpr int kAllThreads = 0;

}  // namespace

CasePreparation::CasePreparation(Jobs& jobs, QObject* parent, int quiet) : QObject(parent), jobs_(jobs), quiet_(quiet) {
  poll_.setInterval(250);
  connect(&poll_, &QTimer::timeout, this, &CasePreparation::changed);
}

void CasePreparation::start(const std::vector<Case>& cases) {
  std::erase_if(waiting_, [&](const Case& each) { return !isAskedFor(each.id); });
  for (Case& each : preparationOrder(cases)) {
    const bool isStopped = std::find(stopped_.begin(), stopped_.end(), each.id) != stopped_.end();
    if (!isStopped && !isAskedFor(each.id) && !(running_ && running_->id == each.id)) waiting_.push_back(std::move(each));
  }
  next();
  Q_EMIT changed();
}

bool CasePreparation::isAskedFor(const std::string& caseId) const {
  return std::find(asked_.begin(), asked_.end(), caseId) != asked_.end();
}

void CasePreparation::ask(const Case& wanted) {
  if (shown_ == wanted.id) shown_.clear();
  queue(wanted, false);
}

void CasePreparation::askForShown(const Case& shown) {
  shown_ = shown.id;
  queue(shown, true);
}

void CasePreparation::queue(const Case& wanted, bool isFirst) {
  std::erase(stopped_, wanted.id);
  const bool wasAsked = isAskedFor(wanted.id);
  if (!wasAsked) asked_.push_back(wanted.id);
  if (running_ && running_->id == wanted.id) {
    if (!wasAsked) giveBackRunning();  // it goes on with all of the machine
  } else {
    std::erase_if(waiting_, [&](const Case& each) { return each.id == wanted.id; });
    const auto behind =
        isFirst ? waiting_.begin() : std::find_if(waiting_.begin(), waiting_.end(), [&](const Case& each) { return !isAskedFor(each.id); });
    waiting_.insert(behind, wanted);
    if (running_ && (isFirst || !isAskedFor(running_->id))) giveBackRunning();
  }
  next();
  Q_EMIT changed();
}

void CasePreparation::hold(bool holds) {
  if (holds == isHeld_) return;
  isHeld_ = holds;
  if (holds && running_ && !mayRun(*running_)) giveBackRunning();
  next();
  Q_EMIT changed();
}

void CasePreparation::later() {
  for (const Case& each : waiting_)
    if (!isAskedFor(each.id)) stopped_.push_back(each.id);
  std::erase_if(waiting_, [&](const Case& each) { return !isAskedFor(each.id); });
  if (running_ && !isAskedFor(running_->id) && job_ != 0) jobs_.cancel(job_);
  Q_EMIT changed();
}

void CasePreparation::pause() {
  paused_ = true;
  giveBackRunning();
}

void CasePreparation::giveBackRunning() {
  if (job_ == 0) return;
  isGivenBack_ = true;
  jobs_.cancel(job_);
}

void CasePreparation::resume() {
  paused_ = false;
  next();
}

void CasePreparation::stop(const std::string& caseId) {
  stopped_.push_back(caseId);
  std::erase(asked_, caseId);
  std::erase_if(waiting_, [&](const Case& each) { return each.id == caseId; });
  if (running_ && running_->id == caseId && job_ != 0) jobs_.cancel(job_);
  Q_EMIT changed();
}

void CasePreparation::ended(const Result<void>& outcome) {
  const Case done = std::move(*running_);
  forget();
  running_.reset();
  job_ = 0;
  const bool wasGivenBack = std::exchange(isGivenBack_, false);
  const bool wasAsked = isAskedFor(done.id);
  if (outcome) {
    std::erase(asked_, done.id);
    Q_EMIT prepared(words(done.id));
  } else if (outcome.error().code != ErrorCode::cancelled) {
    std::erase(asked_, done.id);
    stopped_.push_back(done.id);
    Q_EMIT failed(outcome.error());
  } else if (wasGivenBack) {
    // It goes on next of those like it.
    const auto at = wasAsked ? waiting_.begin() + (!waiting_.empty() && waiting_.front().id == shown_ ? 1 : 0)
                             : std::find_if(waiting_.begin(), waiting_.end(), [&](const Case& each) { return !isAskedFor(each.id); });
    waiting_.insert(at, done);
  } else {
    std::erase(asked_, done.id);
    stopped_.push_back(done.id);
    if (!wasAsked) later();  // whoever stops one that nobody asked for does not want the next one begun
  }
  Q_EMIT changed();
  next();
}

void CasePreparation::next() {
  if (paused_ || job_ != 0) return;
  while (!waiting_.empty() && !caseNeedsPreparation(waiting_.front())) {  // opened, and so prepared, meanwhile
    std::erase(asked_, waiting_.front().id);
    waiting_.pop_front();
  }
  if (waiting_.empty() || !mayRun(waiting_.front())) {
    poll_.stop();
    return;
  }
  running_ = std::move(waiting_.front());
  waiting_.pop_front();
  auto notes = std::make_shared<std::vector<Message>>();
  const bool isWanted = isAskedFor(running_->id);
  job_ = jobs_.start(
      tr("Preparing %1").arg(shownTitle(*running_)),
      [opened = *running_, notes, threads = isWanted ? kAllThreads : kOneThread,
       quiet = isWanted && running_->id != shown_ ? quiet_ / 2 : quiet_](Progress& progress) -> Result<void> {
        const QuietWork quietly(quiet);
        PreparationOptions how;
        how.threads = threads;
        auto made = prepareCase(opened, how, progress);
        if (!made) return passOn(made.error());
        *notes = std::move(*made);
        return {};
      },
      [this, notes](const Result<void>& outcome) {
        ended(outcome);
        for (const Message& note : *notes) Q_EMIT noted(words(note));
      },
      Jobs::Kind::background);
  poll_.start();
}

CasePreparation::Seen CasePreparation::seen(const Case& shown) const {
  Seen found;
  if (running_ && running_->id == shown.id) {
    found.state = State::running;
    for (const Jobs::Seen& job : jobs_.seen()) {
      if (job.id != job_) continue;
      found.fraction = job.fraction;
      found.step = job.step;
    }
    return found;
  }
  auto left = left_.find(shown.folder);
  if (left == left_.end()) {
    Left asked{caseNeedsPreparation(shown), 0.0};
    if (asked.isAny)
      if (const auto estimate = estimatePreparation(shown)) asked.estimate_s = estimate->seconds;
    left = left_.emplace(shown.folder, asked).first;
  }
  if (!left->second.isAny) return found;
  const bool waits = std::any_of(waiting_.begin(), waiting_.end(), [&](const Case& each) { return each.id == shown.id; });
  found.state = waits ? State::waiting : State::stopped;
  found.estimate_s = left->second.estimate_s;
  return found;
}

QString shownTitle(const Case& opened) {
  return words(ew::wordsOf(opened.folder, QLocale().name().toStdString()).of(titleForTrainees(opened)));
}

QString aboutMinutes(double seconds) {
  constexpr double kCoarse_min = 10.0;
  const double minutes = seconds / 60.0;
  if (minutes <= 1.0) return CasePreparation::tr("less than a minute");
  const int shown = static_cast<int>(std::ceil(minutes < kCoarse_min ? minutes : 5.0 * std::ceil(minutes / 5.0)));
  return CasePreparation::tr("about %n minutes", nullptr, shown);
}

}  // namespace ew::ui
