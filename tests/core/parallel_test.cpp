#include "ew/core/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "ew/core/quiet_work.h"

namespace ew::parallel_test {
namespace {

/// Says that the user asked to stop after some reports, and checks that they never move backwards.
class Listener final : public Progress {
 public:
  explicit Listener(int stopAfter = -1) : stopAfter_(stopAfter) {}
  void report(const Message&, double fraction) override {
    if (fraction < last_) monotone = false;
    last_ = fraction;
    ++reports;
  }
  [[nodiscard]] bool cancelRequested() const override { return stopAfter_ >= 0 && reports >= stopAfter_; }

  std::atomic<int> reports{0};
  bool monotone = true;

 private:
  int stopAfter_;
  double last_ = 0.0;
};

TEST(ForEachTask, DoesEveryTaskOnceHoweverManyThreadsThereAre) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> times(100);
    Listener listener;
    EXPECT_TRUE(forEachTask(100, threads, listener, say<"Counting">(), [&](int task) { ++times[static_cast<std::size_t>(task)]; }));
    for (const auto& each : times) EXPECT_EQ(each, 1);
    EXPECT_EQ(listener.reports, 100);
    EXPECT_TRUE(listener.monotone);
  }
}

TEST(ForEachTask, NumbersItsWorkersBelowTheThreadsAskedFor) {
  std::atomic<int> highest{0};
  forEachTask(64, 3, noProgress(), {}, [&](int, int worker, const auto&) {
    int seen = highest;
    while (worker > seen && !highest.compare_exchange_weak(seen, worker)) {
    }
  });
  EXPECT_LT(highest, 3);
}

TEST(ForEachTask, StopsBetweenTasksAndSaysSo) {
  Listener listener(5);
  std::atomic<int> done{0};
  EXPECT_FALSE(forEachTask(1000, 2, listener, say<"Counting">(), [&](int) { ++done; }));
  EXPECT_LT(done, 10);
}

TEST(ForEachTask, ThrowsWhatATaskThrewAfterAllThreadsHaveEnded) {
  for (const int threads : {1, 4}) {
    std::string said;
    try {
      forEachTask(50, threads, noProgress(), {}, [](int task) {
        if (task == 20) throw std::runtime_error("task 20");
      });
    } catch (const std::runtime_error& thrown) {
      said = thrown.what();
    }
    EXPECT_EQ(said, "task 20");
  }
}

TEST(ForEachTask, TasksMayHaveTasksAndLocksOfTheirOwn) {
  std::mutex guard;
  std::atomic<int> inner{0};
  EXPECT_TRUE(forEachTask(16, 4, noProgress(), {}, [&](int) {
    const std::lock_guard lock(guard);  // a thread that waits for its inner tasks must not take up another outer one
    forEachTask(16, 4, noProgress(), {}, [&](int) { ++inner; });
  }));
  EXPECT_EQ(inner, 256);
}

TEST(ForEachTask, NoTwoTasksAtOnceHaveTheSameWorker) {
  std::vector<std::atomic<int>> busy(4);
  std::atomic<bool> collided{false};
  forEachTask(2000, 4, noProgress(), {}, [&](int, int worker, const auto&) {
    auto& mine = busy[static_cast<std::size_t>(worker)];
    if (mine++ != 0) collided = true;
    --mine;
  });
  EXPECT_FALSE(collided);
}

TEST(ForEachTask, HasNothingToDoWithoutTasks) {
  EXPECT_TRUE(forEachTask(0, 4, noProgress(), {}, [](int) { FAIL(); }));
}

int niceness() { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid))); }

TEST(QuietWork, RunsOnThreadsAsLowInPriorityAsItsOwnAlsoWithinItsTasks) {
  std::atomic<int> tasks{0}, loud{0};
  const int own = niceness(), low = std::min(own + 7, 19);
  // Each takes long enough that no thread does all.
  const auto loudly = [&] {
    forEachTask(200, 4, noProgress(), {}, [&](int) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (niceness() != own) ++loud;
    });
  };
  loudly();  // the shared threads begin as low as whoever needs them first
  std::jthread([&] {
    {
      const QuietWork quietly(low);
      forEachTask(200, 4, noProgress(), {}, [&](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (niceness() != low) ++loud;
        forEachTask(4, 2, noProgress(), {}, [&](int) {
          ++tasks;
          if (niceness() != low) ++loud;
        });
      });
    }
    EXPECT_EQ(niceness(), low) << "it stays low";
  }).join();
  EXPECT_EQ(tasks, 800);
  EXPECT_EQ(loud, 0);
  loudly();
  EXPECT_EQ(loud, 0) << "the shared threads are nobody's";
}

TEST(ThreadCount, IsWhatWasAskedOrOnePerProcessor) {
  EXPECT_EQ(threadCount(3), 3);
  EXPECT_EQ(threadCount(100000), 256);
  EXPECT_GE(threadCount(0), 1);
  EXPECT_EQ(threadCount(-1), threadCount(0));
}

}  // namespace
}  // namespace ew::parallel_test
