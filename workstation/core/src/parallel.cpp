#include "ew/core/parallel.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <vector>

#include "ew/core/quiet_work.h"

#ifndef __SANITIZE_THREAD__
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

namespace ew {

namespace {

// Not a zero at first: mold 1.10.1 lets the protected part of a program begin at zeros of threads (.tbss), which have no page of their own;
// where they lie 16 bytes or less before one, the program does not start ("cannot apply additional memory protection after relocation").
thread_local bool isShared = true;

/// On threads that begin here, with the priority of the one that calls.
void callOnOwnThreads(int calls, int workers, const std::function<void(int)>& call) {
  std::atomic<int> next{0};
  const auto run = [&, shared = isShared](int worker) {
    isShared = shared;
    while (next++ < calls) call(worker);
  };
  std::vector<std::jthread> others;
  for (int worker = 1; worker < workers; ++worker) others.emplace_back(run, worker);
  run(0);
}

}  // namespace

QuietWork::QuietWork(int nice) : wasShared_(isShared) {
  isShared = false;
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  if (nice > ::getpriority(PRIO_PROCESS, thread)) static_cast<void>(::setpriority(PRIO_PROCESS, thread, nice));
}

QuietWork::~QuietWork() { isShared = wasShared_; }

#ifdef __SANITIZE_THREAD__

// oneTBB is built without the sanitizer, which would not see how a thread is handed its task.
void callOnThreads(int calls, int workers, const std::function<void(int)>& call) { callOnOwnThreads(calls, workers, call); }

#else

namespace {

/// Calls one after another, each a task of its own: between two a thread can be called away to work of higher priority.
struct CallChains {
  const std::function<void(int)>& call;
  const int calls;
  std::atomic<int> next{0};
  tbb::task_group group;

  void go(int worker) {
    if (next++ >= calls) return;
    call(worker);
    group.run([this, worker] { go(worker); });
  }
};

}  // namespace

void callOnThreads(int calls, int workers, const std::function<void(int)>& call) {
  workers = std::min({workers, calls, tbb::info::default_concurrency()});  // more would only wait for each other
  if (workers <= 1) {
    for (int n = 0; n < calls; ++n) call(0);
    return;
  }
  if (!isShared) return callOnOwnThreads(calls, workers, call);
  // Isolated: who waits here never takes up a task of whoever called, whose locks it may hold.
  tbb::this_task_arena::isolate([&] {
    CallChains chains{.call = call, .calls = calls, .next = {}, .group = {}};
    for (int worker = 1; worker < workers; ++worker) chains.group.run([&chains, worker] { chains.go(worker); });
    chains.go(0);
    chains.group.wait();
  });
}

#endif

}  // namespace ew
