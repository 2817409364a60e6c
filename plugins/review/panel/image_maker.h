#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "ew/scanning/subject.h"
#include "logic/scan_shelf.h"

namespace ew::review {

/// One image of a recording as it was made again.
struct ReplayImage {
  QImage image;              ///< RGB32
  DisplayGeometry geometry;  ///< where the fan lies in it
  std::size_t frame = 0;
  ScanState state;  ///< all that it was made with
};

/// Makes the images of one recording on a thread of its own, so that no window waits. Of several wishes the newest is made; one that is
/// overtaken while it is made is shown as well, so that something is seen however fast wishes come.
class ImageMaker final : public QObject {
  Q_OBJECT

 public:
  explicit ImageMaker(QObject* parent = nullptr);
  ~ImageMaker() override;

  /// What images are made of from now on; null: nothing.
  void show(std::shared_ptr<const ScanExcerpt> scan, std::optional<ScanSubject> subject);
  /// @param frame of the recording's log @param size_px of the image
  void want(std::size_t frame, const QSize& size_px);
  /// Nothing is wanted that was not made.
  [[nodiscard]] bool isIdle() const;

 Q_SIGNALS:
  void made(const std::shared_ptr<const ew::review::ReplayImage>& image);

 private:
  struct Source {
    std::shared_ptr<const ScanExcerpt> scan;
    ScanSubject subject;
  };
  struct Wish {
    std::size_t frame = 0;
    QSize size_px;
    bool operator==(const Wish&) const = default;
  };
  void run();
  void tell(std::uint64_t source, std::shared_ptr<const ReplayImage> image);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const Source> source_;
  std::uint64_t sourceNumber_ = 0;
  std::optional<Wish> wish_, latest_;
  bool isWorking_ = false, ends_ = false;
  std::thread thread_;
};

}  // namespace ew::review

Q_DECLARE_METATYPE(std::shared_ptr<const ew::review::ReplayImage>)
