#include "panel/image_maker.h"

#include <QMetaObject>
#include <utility>

#include "ew/scanning/replay.h"
#include "ew/widgets/qt_image.h"

namespace ew::review {
ImageMaker::ImageMaker(QObject* parent) : QObject(parent), thread_([this] { run(); }) {}

ImageMaker::~ImageMaker() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ImageMaker::show(std::shared_ptr<const ScanExcerpt> scan, std::optional<ScanSubject> subject) {
  const std::lock_guard lock(mutex_);
  ++sourceNumber_;
  wish_.reset();
  latest_.reset();
  source_ = scan && subject ? std::make_shared<const Source>(Source{std::move(scan), std::move(*subject)}) : nullptr;
  changed_.notify_all();  // what images were made of may be a volume that nobody else holds
}

void ImageMaker::want(std::size_t frame, const QSize& size_px) {
  const std::lock_guard lock(mutex_);
  const Wish wish{frame, size_px};
  if (!source_ || size_px.isEmpty() || latest_ == wish) return;
  wish_ = latest_ = wish;
  changed_.notify_all();
}

bool ImageMaker::isIdle() const {
  const std::lock_guard lock(mutex_);
  return !wish_ && !isWorking_;
}

void ImageMaker::run() {
  std::shared_ptr<const Source> at;
  std::unique_ptr<Replay> replay;
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this, &at] { return ends_ || wish_.has_value() || (at && at != source_); });
    if (ends_) return;
    if (at && at != source_) {
      lock.unlock();
      replay.reset();
      at.reset();
      lock.lock();
      continue;
    }
    const Wish wish = *std::exchange(wish_, std::nullopt);
    const std::shared_ptr<const Source> source = source_;
    const std::uint64_t number = sourceNumber_;
    isWorking_ = true;
    lock.unlock();
    auto made = std::make_shared<ReplayImage>();
    if (source) {
      const ScanLog& log = source->scan->recording.log;
      if (!at) replay = std::make_unique<Replay>(log, source->subject);
      at = source;
      made->image = imageOf(replay->make(wish.frame, wish.size_px.width(), wish.size_px.height())).copy();
      made->geometry = replay->scanner().geometry();
      made->frame = wish.frame;
      made->state = log.frame(wish.frame);
    }
    lock.lock();
    isWorking_ = false;
    if (source) tell(number, std::move(made));
  }
}

void ImageMaker::tell(std::uint64_t source, std::shared_ptr<const ReplayImage> image) {
  QMetaObject::invokeMethod(
      this,
      [this, source, image = std::move(image)] {
        {
          const std::lock_guard lock(mutex_);
          if (source != sourceNumber_) return;  // of what is not shown any more
        }
        Q_EMIT made(image);
      },
      Qt::QueuedConnection);
}

}  // namespace ew::review
