#include "panel/session/scan_pair.h"

#include "ew/core/progress.h"
#include "ew/widgets/words.h"
#include "panel/session/opening.h"

namespace ew::review {

namespace {

/// Work that somebody no longer waits for ends like one that was stopped.
class NewestOnly final : public Progress {
 public:
  NewestOnly(Progress& whole, std::shared_ptr<const std::atomic<int>> wish, int number)
      : whole_(whole), wish_(std::move(wish)), number_(number) {}
  void report(const Message& what, double fraction) override { whole_.report(what, fraction); }
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested() || *wish_ != number_; }

 private:
  Progress& whole_;
  std::shared_ptr<const std::atomic<int>> wish_;
  int number_;
};

}  // namespace

ScanPair::~ScanPair() { ++*wish_; }

void ScanPair::open(std::array<std::optional<ScanChoice>, 2> choices, std::shared_ptr<const ScanShelf> shelf, const LessonStep* step,
                    std::function<void(Opening&)> whenOpened) {
  const int number = ++*wish_;
  problem_.clear();
  auto made = std::make_shared<Opening>();
  made->choices = std::move(choices);
  made->shelf = std::move(shelf);
  made->contents = contents_;
  made->mannequin = mannequin_;
  made->mannequinFile = mannequinFile_;
  if (step != nullptr) made->step = *step;
  if (!made->choices[kReviewed] && !made->choices[kCompared]) {
    whenOpened(*made);
    return;
  }
  ++opening_;
  Q_EMIT changed();
  host_.jobs().start(
      tr("Opening the scans").toStdString(),
      [made, wish = wish_, number](Progress& progress) {
        NewestOnly newest(progress, wish, number);
        return made->run(newest);
      },
      [this, made, number, whenOpened = std::move(whenOpened), alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        --opening_;
        if (number != *wish_) return;  // a newer choice is on its way
        if (!done) {
          made->opened = {};
          problem_ = done.error().code == ErrorCode::cancelled ? tr("Opening was stopped; choose the step again.") : words(done.error());
        }
        if (made->problem) problem_ = words(*made->problem);
        whenOpened(*made);
      });
}

void ScanPair::take(Opening& made) {
  opened_ = made.opened;
  contents_ = std::move(made.contents);
  if (made.mannequin) {
    mannequin_ = made.mannequin;
    mannequinFile_ = made.mannequinFile;
  }
}

void ScanPair::keepWith(const QString& problem) {
  problem_ = problem;
  Q_EMIT changed();
}

}  // namespace ew::review
