#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace ew {

/// Shares the rows of an image between threads that stay ready between frames. Whatever is written by rows does not depend on the number
/// of threads. Running allocates nothing of its own; the threads and their tasks exist after the first run.
class Bands {
 public:
  /// @param threads that work on one image, the caller's among them; 0: one per processor
  explicit Bands(int threads = 1);
  ~Bands();
  Bands(Bands&&) noexcept;
  Bands& operator=(Bands&&) noexcept;

  [[nodiscard]] int threads() const { return threads_; }

  /// Calls work(firstRow, rowCount, slot) until every row of 0 .. rows - 1 was handed out once, and returns when all calls have. Two calls
  /// with the same `slot`, 0 <= slot < threads(), never overlap: scratch memory is kept per slot.
  /// @param rows   >= 0; with one thread there is a single call
  /// @param work   runs nothing on these bands itself; what it throws is thrown on here, once all calls have returned
  template <class Work>
  void run(int rows, Work&& work) {
    using Plain = std::remove_reference_t<Work>;
    runErased(rows, const_cast<void*>(static_cast<const void*>(std::addressof(work))),
              [](void* erased, int firstRow, int rowCount, int slot) { (*static_cast<Plain*>(erased))(firstRow, rowCount, slot); });
  }
  /// Calls work(item, slot) once for each of 0 .. items - 1, one by one, with one thread in this order. Of several threads each begins with
  /// a share of neighbouring items, slot after slot, and goes on with what is left of the others': what lies in the same place of the
  /// items of several calls stays in one processor's caches. Within a share the heaviest come first.
  template <class Work>
  void runEach(int items, Work&& work) {
    using Plain = std::remove_reference_t<Work>;
    runEachErased(items, const_cast<void*>(static_cast<const void*>(std::addressof(work))),
                  [](void* erased, int item, int, int slot) { (*static_cast<Plain*>(erased))(item, slot); });
  }

  /// Calls frame() on this thread, for the time of which the other threads stay ready: what it runs needs nobody to be woken. They take
  /// processors for some 50 microseconds after each run, then they sleep.
  /// @param frame nobody else runs anything on these bands meanwhile; what it throws is thrown on here
  template <class Frame>
  void together(Frame&& frame) {
    using Plain = std::remove_reference_t<Frame>;
    togetherErased(const_cast<void*>(static_cast<const void*>(std::addressof(frame))),
                   [](void* erased, int, int, int) { (*static_cast<Plain*>(erased))(); });
  }

 private:
  struct Arena;
  using Erased = void (*)(void* work, int firstRow, int rowCount, int slot);
  void runErased(int rows, void* work, Erased call);
  void runEachErased(int items, void* work, Erased call);
  void togetherErased(void* frame, Erased call);
  int threads_ = 1;
  std::unique_ptr<Arena> arena_;  ///< none with one thread
};

}  // namespace ew
