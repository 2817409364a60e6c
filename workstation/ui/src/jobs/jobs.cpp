#include "jobs/jobs.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QMetaObject>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <system_error>
#include <thread>

#include "ew/core/elapsed.h"
#include "ew/core/freed_memory.h"
#include "ew/core/guarded.h"
#include "ew/widgets/handler_watch.h"
#include "ew/widgets/words.h"

namespace ew::ui {

struct Jobs::Job final : Progress {
  int id = 0;
  QString title;
  Kind kind = Kind::awaited;
  Done done;
  Result<void> outcome;
  std::thread thread;
  QElapsedTimer clock;
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0.0};
  mutable std::mutex mutex;
  Message step;

  void report(const Message& what, double part) override {
    fraction.store(part);
    const std::lock_guard lock(mutex);
    step = what;
  }
  [[nodiscard]] bool cancelRequested() const override { return cancelled.load(); }
};

namespace {

Error unforeseen(const Thrown& thrown) {
  if (thrown.noMemory)
    return {ErrorCode::tooLarge, say<"There is not enough memory for this; close other programs or choose a coarser spacing.">(), {}};
  return {ErrorCode::internal,
          say<"The work stopped unexpectedly (%1); nothing was changed, please report it with what you did.">(thrown.reason),
          {}};
}

Error notTakenOver(const QString& title, const Thrown& thrown) {
  return {ErrorCode::internal,
          say<"The result of '%1' could not be taken over (%2); please report it with what you did.">(title.toStdString(), thrown.reason),
          {}};
}

/// For the log of what holds the window's thread. Titles may name files and people.
const char* takingOver(Jobs::Kind kind) {
  switch (kind) {
    case Jobs::Kind::awaited:
      return "taking over what was waited for";
    case Jobs::Kind::background:
      return "taking over what was made in the background";
    case Jobs::Kind::saving:
      return "taking over what was saved";
  }
  return "";
}

}  // namespace

Jobs::Jobs(QObject* parent) : QObject(parent) {}

Jobs::~Jobs() {
  for (const auto& job : running_) job->cancelled = true;
  for (const auto& job : running_) {
    if (job->thread.joinable()) job->thread.join();
  }
}

bool Jobs::isRunning() const {
  return std::any_of(running_.begin(), running_.end(), [](const auto& job) { return job->kind != Kind::background; });
}

bool Jobs::isSaving() const {
  return std::any_of(running_.begin(), running_.end(), [](const auto& job) { return job->kind == Kind::saving; });
}

int Jobs::start(const QString& title, Work work, Done done, Kind kind) {
  auto job = std::make_unique<Job>();
  job->id = nextId_++;
  job->title = title;
  job->kind = kind;
  job->done = std::move(done);
  job->clock.start();
  Job* raw = job.get();
  const int id = raw->id;
  running_.push_back(std::move(job));
  const auto deliverSoon = [this, id] {
    QMetaObject::invokeMethod(
        this, [this, id] { deliver(id); }, Qt::QueuedConnection);
  };
  try {
    raw->thread = std::thread([raw, deliverSoon, work = std::move(work)] {
      constexpr double kLong_s = 0.5;
      const auto begun = std::chrono::steady_clock::now();
      raw->outcome = guarded([&] { return work(*raw); }, unforeseen);
      // Of a case that was prepared, nearly as much again as it keeps; what was short took little.
      if (secondsSince(begun) > kLong_s) giveFreedMemoryBack();
      deliverSoon();
    });
  } catch (const std::system_error&) {
    raw->outcome = failure(ErrorCode::internal, say<"The system has no room for another thread; close other programs and try again.">());
    deliverSoon();
  }
  Q_EMIT started(id);
  return id;
}

Result<void> Jobs::await(const QString& title, Work work) {
  QEventLoop waiting;
  Result<void> came;
  bool hasCome = false;
  start(title, std::move(work), [&](const Result<void>& outcome) {
    came = outcome;
    hasCome = true;
  });
  // Not exec(), which comes back when the program is told to end: the job uses what lies on this stack.
  while (!hasCome) waiting.processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
  return came;
}

void Jobs::cancel(int id) {
  for (const auto& job : running_) {
    if (job->id == id) job->cancelled = true;
  }
}

void Jobs::rename(int id, const QString& title) {
  for (const auto& job : running_) {
    if (job->id == id) job->title = title;
  }
}

std::vector<Jobs::Seen> Jobs::seen() const {
  std::vector<Seen> all;
  for (const auto& job : running_) {
    Seen one{job->id,
             job->title,
             {},
             std::clamp(job->fraction.load(), 0.0, 1.0),
             static_cast<double>(job->clock.elapsed()) / 1000.0,
             job->cancelled.load(),
             job->kind};
    const std::lock_guard lock(job->mutex);
    one.step = words(job->step);
    all.push_back(std::move(one));
  }
  return all;
}

void Jobs::deliver(int id) {
  const auto at = std::find_if(running_.begin(), running_.end(), [id](const auto& job) { return job->id == id; });
  if (at == running_.end()) return;  // already delivered while waiting for everything
  const std::unique_ptr<Job> job = std::move(*at);
  running_.erase(at);
  if (job->thread.joinable()) job->thread.join();
  Q_EMIT finished(id);
  if (job->done) {
    const HandlerWatch::Part part(takingOver(job->kind));
    const auto taken = guarded([&] { job->done(job->outcome); }, [&](const Thrown& thrown) { return notTakenOver(job->title, thrown); });
    if (!taken) Q_EMIT problem(taken.error());
  }
  if (job->kind == Kind::saving && !job->outcome) Q_EMIT notSaved(id);
}

void Jobs::cancelAllAndWait() {
  // A `done` may start the next step of a chain; it is cancelled like the others.
  while (!running_.empty()) {
    for (const auto& job : running_) job->cancelled = true;
    deliver(running_.front()->id);
  }
}

}  // namespace ew::ui
