#include "ew/ui_test_door/jobs.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "ew/widgets/handler_watch.h"
#include "time_limit.h"

namespace ew::ui::jobs_test {
namespace {

class JobsOnTheirOwn : public testing::Test {
 protected:
  /// Lets what was queued run until `condition` holds; false when that takes too long.
  template <class Condition>
  static bool waitUntil(const Condition& condition) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
      if (static_cast<double>(clock.elapsed()) > test::kPatience_ms) return false;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  static Result<void> workUntilCancelled(Progress& progress) {
    while (!progress.cancelRequested()) {
      progress.report(verbatim("Turning"), 0.5);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return failure(ErrorCode::cancelled, verbatim("It was stopped."));
  }

 private:
  int argc_ = 1;
  char name_[5] = "jobs";
  char* argv_[2] = {name_, nullptr};
  QCoreApplication application_{argc_, argv_};
};

TEST_F(JobsOnTheirOwn, AJobIsCalledByWhatIsKnownOfItByNow) {
  Jobs jobs;
  const int id = jobs.start("Opening a case", workUntilCancelled, {});
  const int other = jobs.start("Counting", workUntilCancelled, {});
  jobs.rename(id, "Opening Knee");
  jobs.rename(other + 1, "Nobody");
  const auto seen = jobs.seen();
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].title.toStdString(), "Opening Knee");
  EXPECT_EQ(seen[1].title.toStdString(), "Counting");
  jobs.cancelAllAndWait();
}

TEST_F(JobsOnTheirOwn, WhatTheLogIsToldNamesNoTitle) {
  HandlerWatch watch(-1.0);  // everything is slow
  Jobs jobs;
  bool isDone = false;
  jobs.start(
      "Opening Ann Smith.mha", [](Progress&) -> Result<void> { return {}; }, [&](const Result<void>&) { isDone = true; });
  ASSERT_TRUE(waitUntil([&] { return isDone; }));
  const auto slow = watch.slow();
  ASSERT_EQ(slow.size(), 1u);
  EXPECT_EQ(slow[0].name.toStdString(), "taking over what was waited for");
}

TEST_F(JobsOnTheirOwn, WorkRunsOnAnotherThreadAndItsDoneOnThisOne) {
  Jobs jobs;
  const auto here = std::this_thread::get_id();
  std::thread::id worked, finished;
  std::vector<int> result;  // handed from thread to thread without a lock, as every job of the window does
  jobs.start(
      "Counting",
      [&](Progress&) -> Result<void> {
        worked = std::this_thread::get_id();
        for (int n = 0; n < 1000; ++n) result.push_back(n);
        return {};
      },
      [&](const Result<void>& outcome) {
        EXPECT_TRUE(outcome);
        finished = std::this_thread::get_id();
      });
  ASSERT_TRUE(waitUntil([&] { return !jobs.isRunning(); }));
  EXPECT_NE(worked, here);
  EXPECT_EQ(finished, here);
  EXPECT_EQ(result.size(), 1000u);
}

TEST_F(JobsOnTheirOwn, StepAndPartAreSeenWhileTheWorkReportsThem) {
  Jobs jobs;
  std::atomic<bool> enough{false};
  jobs.start("Reporting",
             [&](Progress& progress) -> Result<void> {
               for (int n = 0; !enough; ++n)
                 progress.report(verbatim(n % 2 == 0 ? "An even step of the work" : "An odd one"), 0.25 + 0.5 * (n % 2));
               return {};
             },
             {});
  bool even = false, odd = false;
  EXPECT_TRUE(waitUntil([&] {
    const auto seen = jobs.seen();
    EXPECT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen.front().title, QString("Reporting"));
    even = even || seen.front().step == QString("An even step of the work");
    odd = odd || seen.front().step == QString("An odd one");
    return even && odd;
  }));
  enough = true;
  EXPECT_TRUE(waitUntil([&] { return !jobs.isRunning(); }));
}

TEST_F(JobsOnTheirOwn, CancellingReachesTheJobItNamesAndNoOther) {
  Jobs jobs;
  ErrorCode first = ErrorCode::internal;
  const int id = jobs.start("First", workUntilCancelled, [&](const Result<void>& outcome) { first = outcome.error().code; });
  jobs.start("Second", workUntilCancelled, {});
  jobs.cancel(id);
  EXPECT_TRUE(waitUntil([&] { return jobs.seen().size() == 1; }));
  EXPECT_EQ(first, ErrorCode::cancelled);
  ASSERT_EQ(jobs.seen().size(), 1u);
  EXPECT_EQ(jobs.seen().front().title, QString("Second"));
  EXPECT_FALSE(jobs.seen().front().cancelling);
}

TEST_F(JobsOnTheirOwn, CancellingEverythingAlsoStopsWhatADoneStarts) {
  Jobs jobs;
  int done = 0;
  jobs.start("First", workUntilCancelled,
             [&](const Result<void>&) { jobs.start("Next", workUntilCancelled, [&](const Result<void>&) { done += 10; }), ++done; });
  jobs.cancelAllAndWait();
  EXPECT_EQ(done, 11);
  EXPECT_FALSE(jobs.isRunning());
  QCoreApplication::processEvents();
  EXPECT_EQ(done, 11) << "what was queued meanwhile is not delivered twice";
}

TEST_F(JobsOnTheirOwn, DestroyingThemCancelsWaitsAndCallsNothingAnyMore) {
  int done = 0;
  {
    Jobs jobs;
    for (int n = 0; n < 4; ++n) jobs.start("Endless", workUntilCancelled, [&](const Result<void>&) { ++done; });
  }
  QCoreApplication::processEvents();
  EXPECT_EQ(done, 0);
}

TEST_F(JobsOnTheirOwn, AnExceptionOfTheWorkBecomesAnError) {
  Jobs jobs;
  std::vector<Error> errors;
  const auto note = [&](const Result<void>& outcome) { errors.push_back(outcome.error()); };
  jobs.start(
      "Thrown", [](Progress&) -> Result<void> { throw std::runtime_error("the dog ate it"); }, note);
  ASSERT_TRUE(waitUntil([&] { return errors.size() == 1; }));
  jobs.start(
      "No memory", [](Progress&) -> Result<void> { throw std::bad_alloc(); }, note);
  ASSERT_TRUE(waitUntil([&] { return errors.size() == 2; }));
  jobs.start(
      "A number", [](Progress&) -> Result<void> { throw 42; }, note);
  ASSERT_TRUE(waitUntil([&] { return errors.size() == 3; }));
  EXPECT_EQ(errors[2].code, ErrorCode::internal);
  EXPECT_EQ(errors[0].code, ErrorCode::internal);
  EXPECT_NE(errors[0].sentence().find("the dog ate it"), std::string::npos);
  EXPECT_EQ(errors[1].code, ErrorCode::tooLarge);
}

TEST_F(JobsOnTheirOwn, AnExceptionOfTheDoneIsTold) {
  Jobs jobs;
  std::vector<std::string> told;
  QObject::connect(&jobs, &Jobs::problem, &jobs, [&](const Error& error) { told.push_back(error.sentence()); });
  const auto work = [](Progress&) { return Result<void>(); };
  jobs.start("Thrown", work, [](const Result<void>&) { throw std::runtime_error("the dog ate it"); });
  jobs.start("A number", work, [](const Result<void>&) { throw 42; });
  EXPECT_TRUE(waitUntil([&] { return told.size() == 2; }));
  jobs.start("While everything ends", work, [](const Result<void>&) { throw 42; });
  jobs.cancelAllAndWait();
  ASSERT_EQ(told.size(), 3u);
  for (const char* title : {"'Thrown'", "'A number'", "'While everything ends'"})
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [&](const std::string& said) { return said.find(title) != std::string::npos; }))
        << title;
}

TEST_F(JobsOnTheirOwn, AThreadThatCannotBeHadIsAnErrorOfTheJob) {
  // A stack larger than the address space is what a system without room for another thread looks like from here.
  pthread_attr_t usual, absurd;
  ASSERT_EQ(pthread_getattr_default_np(&usual), 0);
  pthread_attr_init(&absurd);
  ASSERT_EQ(pthread_attr_setstacksize(&absurd, std::size_t{1} << 50), 0);
  ASSERT_EQ(pthread_setattr_default_np(&absurd), 0);
  Jobs jobs;
  bool worked = false;
  ErrorCode code{};
  std::string sentence;
  jobs.start(
      "Too many",
      [&](Progress&) -> Result<void> {
        worked = true;
        return {};
      },
      [&](const Result<void>& outcome) {
        ASSERT_FALSE(outcome);
        code = outcome.error().code;
        sentence = outcome.error().sentence();
      });
  pthread_setattr_default_np(&usual);
  EXPECT_TRUE(jobs.isRunning()) << "its outcome comes later, as that of every job";
  EXPECT_TRUE(waitUntil([&] { return !jobs.isRunning(); }));
  EXPECT_FALSE(worked);
  EXPECT_EQ(code, ErrorCode::internal);
  EXPECT_NE(sentence.find("thread"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace ew::ui::jobs_test
