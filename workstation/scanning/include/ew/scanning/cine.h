#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/scanning/post_processing.h"
#include "ew/scanning/recording.h"
#include "ew/scanning/scanner.h"

namespace ew {

struct CineLimits {
  double length_s = 30.0;                     ///< of what is offered, up to the newest image
  std::size_t bytes = std::size_t{30} << 20;  ///< of all that is held; where that is less than length_s, less is offered
  double memoryEvery_s = 1.0;                 ///< between two memories of persistence and M-mode; longer where they would fill the ring
};

/// The last seconds of a scan: not the images, but what each was made with. Images that earlier ones show in (persistence, M-mode) could
/// not be formed again from that alone: of those the ring also keeps, about once in a second, what their maker remembered. So every image
/// is formed again to the last bit, from a few before it at most (CineForming).
class CineRing {
 public:
  explicit CineRing(const CineLimits& limits = {}) : limits_(limits) {}

  /// An image was made live. Microseconds, and a copy of what `memory` gives when that is asked. Times do not fall: an image before the
  /// newest one is not kept.
  /// @param memory what its maker remembers after it (Scanner::memory)
  void add(const ScanState& made, glm::ivec2 size_px, const std::function<FrameMemory()>& memory);
  /// The maker forgot: nothing of what was added shows in the image that is added next.
  void forget() { hasForgotten_ = true; }
  /// What was added is offered no longer; it still shows in images after it.
  void beginAnew();
  void clear();

  /// Images that are offered, the oldest first.
  [[nodiscard]] std::size_t frameCount() const { return frames_.size() - offered_; }
  [[nodiscard]] bool empty() const { return frameCount() == 0; }
  /// All that the n-th image was made with.
  [[nodiscard]] ScanState frame(std::size_t n) const;
  [[nodiscard]] glm::ivec2 size_px(std::size_t n) const;
  [[nodiscard]] double frameTime_s(std::size_t n) const;
  /// From the oldest to the newest that is offered.
  [[nodiscard]] double length_s() const { return empty() ? 0.0 : frameTime_s(frameCount() - 1) - frameTime_s(0); }
  /// The image that is seen at a moment: the last one made by then, the oldest one before that. Expects one.
  [[nodiscard]] std::size_t frameAt(double time_s) const;
  /// Of everything that is held, memories included.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  friend class CineForming;
  struct Settings {
    Probe probe;
    Knobs knobs;
    Pan pan;
    Scene scene;
    glm::ivec2 size_px{0};
    bool operator==(const Settings&) const = default;
  };
  struct Frame {
    std::shared_ptr<const Settings> settings;  ///< shared by all that were made with them
    Pose pose;
    std::vector<float> gaps_mm;
    double time_s = 0.0;
    std::uint64_t number = 0;
    BodyState body;
    bool isFirst = false;                       ///< nothing earlier shows in it
    std::shared_ptr<const FrameMemory> memory;  ///< after it; null where none was kept
  };
  [[nodiscard]] ScanState stateOf(const Frame& frame) const;
  [[nodiscard]] static std::size_t bytesOf(const Settings& settings);
  [[nodiscard]] static std::size_t bytesOf(const Frame& frame);
  [[nodiscard]] static std::size_t bytesOf(const FrameMemory& memory);
  /// The latest frame from which the n-th can be formed: a first one, or one behind a memory.
  [[nodiscard]] std::size_t startOf(std::size_t n) const;
  [[nodiscard]] double interval_s() const;
  void dropOldest();
  void keepWithin();

  CineLimits limits_;
  std::deque<Frame> frames_;
  std::size_t offered_ = 0;    ///< index of the oldest that is offered; those before it are kept for what shows in it
  std::uint64_t dropped_ = 0;  ///< since the ring was made: number of frames_[0]
  std::size_t bytes_ = 0;
  std::size_t memoryBytes_ = 0;  ///< of the last memory
  double remembered_s_ = 0.0;    ///< when the last memory was kept, or an image made that needs none
  bool hasForgotten_ = true;
};

/// Forms images of a ring again, in a maker of its own: the live one stays as it is. In the size that an image had the pixels are the same,
/// on every machine and with every number of threads; in another size, or processed otherwise, persistence and M-mode begin as many images
/// before as still show.
class CineForming {
 public:
  /// @param threads as of Scanner
  explicit CineForming(ScanSubject subject, int threads = 1);

  /// What is wanted, and how it is shown. @return how many images are to be made until it is there, with it; 0 when it is the one that was
  /// made last
  std::size_t aim(const CineRing& ring, std::size_t frame, glm::ivec2 size_px, const PostProcessing& by = {});
  [[nodiscard]] std::size_t left() const { return left_; }
  /// Makes the next of them. Expects left() > 0, and the ring as it was when it was aimed at.
  void makeNext(const CineRing& ring);
  /// The image that was made last; its views stay valid until the next one.
  [[nodiscard]] const DisplayImage& image() const { return image_; }
  [[nodiscard]] const Scanner& scanner() const { return scanner_; }

 private:
  Scanner scanner_;
  DisplayImage image_;
  glm::ivec2 size_px_{0};              ///< that is asked for
  PostProcessing by_;                  ///< that is asked for
  glm::ivec2 lastSize_px_{0};          ///< of the one that was made last
  PostProcessing lastBy_;              ///< of the one that was made last
  std::optional<std::uint64_t> last_;  ///< number of the frame that was made last
  std::uint64_t next_ = 0;
  std::size_t left_ = 0;
  bool begins_ = false;     ///< nothing of what was made shows in the next
  bool mayRecall_ = false;  ///< the images asked for leave the memories they left
};

/// Where somebody stands in a ring, and which part of it runs. A value without a clock; the ring outlives it and rests meanwhile.
class CineReview {
 public:
  /// At the newest image; all of the ring runs. Expects an image.
  explicit CineReview(const CineRing& ring);

  [[nodiscard]] std::size_t frame() const { return frame_; }
  void goTo(std::size_t frame);
  void step(int frames);
  /// The part that runs begins, or ends, with this image; the same again takes the mark away. A mark on the wrong side of the other one
  /// takes that one away.
  void markIn();
  void markOut();
  [[nodiscard]] bool isInMarked() const { return in_.has_value(); }
  [[nodiscard]] bool isOutMarked() const { return out_.has_value(); }
  [[nodiscard]] std::size_t in() const { return in_.value_or(0); }
  [[nodiscard]] std::size_t out() const { return out_.value_or(ring_->frameCount() - 1); }
  /// Time goes on by so much and begins again at the end of the part that runs. Its last image is seen as long as its images are on
  /// average.
  void advance(double passed_s);

 private:
  const CineRing* ring_;
  std::size_t frame_ = 0;
  double time_s_ = 0.0;
  std::optional<std::size_t> in_, out_;
};

/// Some of a ring's images as a recording, as if it had begun with the first of them: nothing earlier shows in it.
/// @param first, last expects first <= last < ring.frameCount()
[[nodiscard]] ScanRecording clipOf(const CineRing& ring, std::size_t first, std::size_t last, std::string caseId, std::string title);

}  // namespace ew
