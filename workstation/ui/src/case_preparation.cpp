#include "case_preparation.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

#include "ew/library/preparation.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kQuiet = 10;  // of 19: what a user does goes first, and an idle machine is used in full

/// Lets the calling thread, and those it starts, give way to others.
void giveWay() { static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), kQuiet)); }

}  // namespace

CasePreparation::CasePreparation(Jobs& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {
  poll_.setInterval(250);
  connect(&poll_, &QTimer::timeout, this, &CasePreparation::changed);
}

void CasePreparation::start(const std::vector<Case>& cases) {
  waiting_.clear();
  for (Case& each : preparationOrder(cases)) {
    const bool stopped = std::find(stopped_.begin(), stopped_.end(), each.id) != stopped_.end();
    if (!stopped && !(running_ && running_->id == each.id)) waiting_.push_back(std::move(each));
  }
  next();
  Q_EMIT changed();
}

void CasePreparation::pause() {
  paused_ = true;
  if (job_ != 0) jobs_.cancel(job_);
}

void CasePreparation::resume() {
  paused_ = false;
  next();
}

void CasePreparation::stop(const std::string& caseId) {
  stopped_.push_back(caseId);
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), [&](const Case& each) { return each.id == caseId; }), waiting_.end());
  if (running_ && running_->id == caseId && job_ != 0) jobs_.cancel(job_);
  Q_EMIT changed();
}

void CasePreparation::next() {
  if (paused_ || job_ != 0) return;
  while (!waiting_.empty() && !caseNeedsPreparation(waiting_.front())) waiting_.pop_front();  // opened, and so prepared, meanwhile
  if (waiting_.empty()) {
    poll_.stop();
    return;
  }
  running_ = std::move(waiting_.front());
  waiting_.pop_front();
  auto notes = std::make_shared<std::vector<Message>>();
  job_ = jobs_.start(
      tr("Preparing %1").arg(words(titleForTrainees(*running_))),
      [opened = *running_, notes](Progress& progress) -> Result<void> {
        giveWay();
        auto made = prepareCase(opened, {}, progress);
        if (!made) return passOn(made.error());
        *notes = std::move(*made);
        return {};
      },
      [this, notes](const Result<void>& outcome) {
        const Case done = std::move(*running_);
        running_.reset();
        job_ = 0;
        if (outcome) {
          Q_EMIT prepared(words(done.id));
          for (const Message& note : *notes) Q_EMIT noted(words(note));
        } else if (outcome.error().code != ErrorCode::cancelled) {
          stopped_.push_back(done.id);
          Q_EMIT failed(outcome.error());
        } else if (paused_) {
          waiting_.push_front(done);
        } else {
          stopped_.push_back(done.id);  // the user pressed Cancel
        }
        Q_EMIT changed();
        next();
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
  if (!caseNeedsPreparation(shown)) return found;
  const bool waits = std::any_of(waiting_.begin(), waiting_.end(), [&](const Case& each) { return each.id == shown.id; });
  found.state = waits ? State::waiting : State::stopped;
  if (const auto estimate = estimatePreparation(shown)) found.estimate_s = estimate->seconds;
  return found;
}

}  // namespace ew::ui
