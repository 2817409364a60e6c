#pragma once

#include <QTimer>
#include <utility>

namespace ew {

/// Calls work() once, on the thread of `context`, when the window has done what waits for it and `wait_ms` are over; never if `context` is
/// gone by then.
template <class Context, class Work>
void callLater(int wait_ms, Context* context, Work&& work) {
#ifndef __clang_analyzer__  // it does not know that Qt lets go of the work it keeps
  QTimer::singleShot(wait_ms, Qt::PreciseTimer, context, std::forward<Work>(work));
#endif
}

}  // namespace ew
