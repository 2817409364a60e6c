#include "ew/scanning/cine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr std::size_t kPerAllocation = 32;  // what the heap and a shared pointer add

/// An image without persistence, colour and strip: its maker remembers nothing before it, and nothing of it.
bool remembersNothing(const Knobs& knobs) { return framesToSettle(knobs) == 0 && knobs.mode == DisplayMode::bMode; }

}  // namespace

std::size_t CineRing::bytesOf(const Settings& settings) {
  std::size_t bytes = sizeof(Settings) + kPerAllocation + settings.probe.id.capacity() + settings.probe.name.capacity() +
                      settings.probe.carriers_hz.capacity() * sizeof(double) + settings.scene.tissues.capacity() * sizeof(TissueAcoustics);
  for (const TissueAcoustics& tissue : settings.scene.tissues) bytes += tissue.name.capacity();
  return bytes;
}

std::size_t CineRing::bytesOf(const FrameMemory& memory) {
  const ImageView<const std::uint8_t> strip = memory.strip.image();
  const auto width = static_cast<std::size_t>(strip.width), height = static_cast<std::size_t>(strip.height);
  return sizeof(FrameMemory) + kPerAllocation + memory.persistence.levels.capacity() * sizeof(std::uint16_t) +
         memory.colour.sums.capacity() * sizeof(float) + (memory.spectrum ? ew::bytesOf(*memory.spectrum) : 0) + (width + 2) * height +
         width * sizeof(float);
}

std::size_t CineRing::bytesOf(const Frame& frame) { return sizeof(Frame) + kPerAllocation + frame.gaps_mm.capacity() * sizeof(float); }

double CineRing::interval_s() const {
  // Memories get two thirds of the room at most; large images are remembered less often.
  const double share = static_cast<double>(memoryBytes_) / (static_cast<double>(limits_.bytes) * 2.0 / 3.0);
  return std::max(limits_.memoryEvery_s, share * limits_.length_s);
}

void CineRing::add(const ScanState& made, glm::ivec2 size_px, const std::function<FrameMemory()>& memory) {
  if (!frames_.empty() && !(made.time_s >= frames_.back().time_s)) return;
  Settings settings{made.probe, made.knobs, made.pan, made.scene, size_px};
  Frame frame;
  frame.isFirst = std::exchange(hasForgotten_, false) || remembersNothing(made.knobs) ||
                  (!frames_.empty() && frames_.back().settings->size_px != size_px);
  // What shows in the first of a ring that was cleared is gone: it is kept for what it leaves to the next one, and not offered.
  const bool isCut = frames_.empty() && !frame.isFirst;
  if (!frames_.empty() && *frames_.back().settings == settings) {
    frame.settings = frames_.back().settings;
  } else {
    bytes_ += bytesOf(settings);
    frame.settings = std::make_shared<const Settings>(std::move(settings));
  }
  frame.pose = made.pose;
  frame.gaps_mm = made.gaps_mm;
  frame.time_s = made.time_s;
  frame.number = made.number;
  frame.body = made.body;
  if (frame.isFirst) {
    remembered_s_ = made.time_s;
  } else if (isCut || made.time_s - remembered_s_ >= interval_s()) {
    frame.memory = std::make_shared<const FrameMemory>(memory());
    memoryBytes_ = bytesOf(*frame.memory);
    bytes_ += memoryBytes_;
    remembered_s_ = made.time_s;
  }
  bytes_ += bytesOf(frame);
  frames_.push_back(std::move(frame));
  if (isCut) offered_ = 1;
  keepWithin();
}

std::size_t CineRing::startOf(std::size_t n) const {
  while (n > 0 && !frames_[n].isFirst && frames_[n - 1].memory == nullptr) --n;
  return n;
}

void CineRing::dropOldest() {
  const Frame& oldest = frames_.front();
  bytes_ -= bytesOf(oldest);
  if (oldest.memory) bytes_ -= bytesOf(*oldest.memory);
  if (oldest.settings.use_count() == 1) bytes_ -= bytesOf(*oldest.settings);
  frames_.pop_front();
  ++dropped_;
  if (offered_ > 0) --offered_;
}

void CineRing::keepWithin() {
  const double from_s = frames_.back().time_s - limits_.length_s;
  /// Those that are not offered, and that nothing offered is formed from.
  const auto dropUnneeded = [this] {
    // The memory behind which a frame begins lies at the frame before it.
    const std::size_t start = startOf(std::min(offered_, frames_.size() - 1));
    const std::size_t unneeded = start > 0 && !frames_[start].isFirst ? start - 1 : start;
    for (std::size_t n = 0; n < unneeded; ++n) dropOldest();
  };
  while (offered_ + 1 < frames_.size() && frames_[offered_].time_s < from_s) ++offered_;
  dropUnneeded();
  while (bytes_ > limits_.bytes && offered_ + 1 < frames_.size()) {
    ++offered_;
    dropUnneeded();
  }
  // Memories larger than the ring were never kept: then the bound goes before the last bit.
  while (bytes_ > limits_.bytes && frames_.size() > 1) dropOldest();
}

void CineRing::beginAnew() { offered_ = frames_.size(); }

void CineRing::clear() {
  dropped_ += frames_.size();
  frames_.clear();
  offered_ = 0;
  bytes_ = 0;
}

ScanState CineRing::stateOf(const Frame& frame) const {
  ScanState state;
  state.probe = frame.settings->probe;
  state.knobs = frame.settings->knobs;
  state.pan = frame.settings->pan;
  state.scene = frame.settings->scene;
  state.pose = frame.pose;
  state.gaps_mm = frame.gaps_mm;
  state.time_s = frame.time_s;
  state.number = frame.number;
  state.body = frame.body;
  return state;
}

ScanState CineRing::frame(std::size_t n) const {
  EW_EXPECTS(n < frameCount());
  return stateOf(frames_[offered_ + n]);
}

glm::ivec2 CineRing::size_px(std::size_t n) const {
  EW_EXPECTS(n < frameCount());
  return frames_[offered_ + n].settings->size_px;
}

double CineRing::frameTime_s(std::size_t n) const {
  EW_EXPECTS(n < frameCount());
  return frames_[offered_ + n].time_s;
}

std::size_t CineRing::frameAt(double time_s) const {
  EW_EXPECTS(!empty());
  const auto oldest = frames_.begin() + static_cast<std::ptrdiff_t>(offered_);
  const auto after = std::upper_bound(oldest, frames_.end(), time_s, [](double time, const Frame& frame) { return time < frame.time_s; });
  return after == oldest ? 0 : static_cast<std::size_t>(after - oldest) - 1;
}

CineForming::CineForming(ScanSubject subject, int threads) : scanner_(threads) { scanner_.show(std::move(subject)); }

std::size_t CineForming::aim(const CineRing& ring, std::size_t frame, glm::ivec2 size_px, const PostProcessing& by) {
  EW_EXPECTS(frame < ring.frameCount());
  const std::size_t wanted = ring.offered_ + frame;
  const CineRing::Frame& at = ring.frames_[wanted];
  mayRecall_ = at.settings->size_px == size_px && leavesMemory(by, at.settings->knobs);
  std::size_t start = ring.startOf(wanted);
  if (!mayRecall_) {
    // Whatever was remembered has another size, or other levels.
    const std::size_t persisting = framesToSettle(at.settings->knobs);
    const double sweep_s = at.settings->knobs.mode != DisplayMode::bMode ? at.settings->knobs.mSweep_s : 0.0;
    start = wanted;
    while (start > 0 && !ring.frames_[start].isFirst && (wanted - start < persisting || at.time_s - ring.frames_[start].time_s < sweep_s))
      --start;
  }
  const bool isSameKind = size_px == lastSize_px_ && by == lastBy_;
  size_px_ = size_px;
  by_ = by;
  const std::uint64_t wantedNumber = ring.dropped_ + wanted, startNumber = ring.dropped_ + start;
  if (isSameKind && last_ == wantedNumber) return left_ = 0;
  // Going on from the last one is exact as well, and shorter when it lies behind the start.
  const bool goesOn = isSameKind && last_ && *last_ < wantedNumber && *last_ + 1 >= startNumber;
  begins_ = !goesOn;
  next_ = goesOn ? *last_ + 1 : startNumber;
  return left_ = static_cast<std::size_t>(wantedNumber - next_) + 1;
}

void CineForming::makeNext(const CineRing& ring) {
  EW_EXPECTS(left_ > 0 && next_ >= ring.dropped_ && next_ - ring.dropped_ < ring.frames_.size());
  const auto n = static_cast<std::size_t>(next_ - ring.dropped_);
  const CineRing::Frame& frame = ring.frames_[n];
  if (frame.isFirst || begins_) {
    scanner_.forget();
    if (!frame.isFirst && mayRecall_ && n > 0 && ring.frames_[n - 1].memory) {
      scanner_.prepare(processed(ring.stateOf(ring.frames_[n - 1]), by_), size_px_.x, size_px_.y);
      scanner_.recall(*ring.frames_[n - 1].memory);
    }
  }
  begins_ = false;
  image_ = scanner_.make(processed(ring.stateOf(frame), by_), size_px_.x, size_px_.y);
  lastSize_px_ = size_px_;
  lastBy_ = by_;
  last_ = next_++;
  --left_;
}

CineReview::CineReview(const CineRing& ring) : ring_(&ring) {
  EW_EXPECTS(!ring.empty());
  goTo(ring.frameCount() - 1);
}

void CineReview::goTo(std::size_t frame) {
  frame_ = std::min(frame, ring_->frameCount() - 1);
  time_s_ = ring_->frameTime_s(frame_);
}

void CineReview::step(int frames) {
  const auto last = static_cast<std::ptrdiff_t>(ring_->frameCount()) - 1;
  goTo(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(frame_) + frames, 0, last)));
}

void CineReview::markIn() {
  if (in_ == frame_) return in_.reset();
  in_ = frame_;
  if (out_ && *out_ < frame_) out_.reset();
}

void CineReview::markOut() {
  if (out_ == frame_) return out_.reset();
  out_ = frame_;
  if (in_ && *in_ > frame_) in_.reset();
}

void CineReview::advance(double passed_s) {
  const double begin_s = ring_->frameTime_s(in()), end_s = ring_->frameTime_s(out());
  const double runs_s = end_s - begin_s;
  if (!(runs_s > 0.0) || !std::isfinite(passed_s)) return goTo(in());
  const double whole_s = runs_s + runs_s / static_cast<double>(out() - in());
  double at_s = frame_ < in() || frame_ > out() ? 0.0 : time_s_ - begin_s + std::max(0.0, passed_s);
  at_s = std::fmod(at_s, whole_s);
  frame_ = std::clamp(ring_->frameAt(begin_s + at_s), in(), out());
  time_s_ = begin_s + at_s;
}

ScanRecording clipOf(const CineRing& ring, std::size_t first, std::size_t last, std::string caseId, std::string title) {
  EW_EXPECTS(first <= last && last < ring.frameCount());
  ScanRecording clip;
  clip.caseId = std::move(caseId);
  clip.title = std::move(title);
  clip.size_px = ring.size_px(last);
  for (std::size_t n = first; n <= last; ++n) clip.log.addFrame(ring.frame(n));
  return clip;
}

}  // namespace ew
