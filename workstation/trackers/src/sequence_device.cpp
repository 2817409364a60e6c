#include "ew/trackers/sequence_device.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "ew/io/sequence.h"

namespace ew {

namespace {

constexpr double kFramePeriod_s = 1.0 / 30;
constexpr double kTryAgain_s = 2.0;

/// Ends reading a file when the device is stopped meanwhile.
class UntilStopped final : public Progress {
 public:
  explicit UntilStopped(const std::atomic<bool>& ends) : ends_(ends) {}
  void report(const Message& /*what*/, double /*fraction*/) override {}
  [[nodiscard]] bool cancelRequested() const override { return ends_; }

 private:
  const std::atomic<bool>& ends_;
};

struct SequenceMoment {
  double time_s = 0.0;  ///< since the first, never falls
  std::vector<ToolReading> readings;
};

TrackingState stateOf(const FrameTransform& transform) {
  if (!checkRigid(transform.matrix)) return TrackingState::invalid;
  if (transform.status == PoseStatus::ok) return TrackingState::live;
  // PLUS writes the identity for a tool that its tracker did not see, and keeps the last matrix of one it read badly.
  return transform.status == PoseStatus::missing || transform.matrix == glm::dmat4(1.0) ? TrackingState::outOfView : TrackingState::invalid;
}

std::vector<SequenceMoment> momentsOf(const Sequence& sequence) {
  std::vector<SequenceMoment> moments;
  double time_s = 0.0, first_s = std::numeric_limits<double>::quiet_NaN();
  for (const SequenceFrame& frame : sequence.frames) {
    if (frame.time_s && !(first_s == first_s)) first_s = *frame.time_s - time_s;
    // A clock that was set back in the middle goes on as if a frame had passed.
    const double wanted_s = frame.time_s ? *frame.time_s - first_s : -1.0;
    if (!moments.empty()) time_s = wanted_s >= time_s ? wanted_s : time_s + kFramePeriod_s;
    SequenceMoment moment{time_s, {}};
    for (const FrameTransform& transform : frame.transforms)
      moment.readings.push_back(
          {.tool = transform.from + "To" + transform.to, .toolToTracker = {transform.matrix}, .state = stateOf(transform)});
    if (!moment.readings.empty()) moments.push_back(std::move(moment));
  }
  if (!moments.empty())
    for (double begins_s = moments.front().time_s; SequenceMoment & moment : moments) moment.time_s -= begins_s;
  return moments;
}

class RecordingAsTracker final : public SequenceDevice {
 public:
  explicit RecordingAsTracker(const SequenceSettings& settings) : settings_(settings) {}
  ~RecordingAsTracker() override { RecordingAsTracker::stop(); }

  void start() override {
    if (playing_.joinable()) return;
    ends_ = false;
    at_s_ = length_s_ = device_s_ = paused_s_ = 0.0;
    looked_s_.reset();
    queue_.begin();
    queue_.setLink(LinkState::connecting, say<"Reading the recording %1.">(settings_.file));
    playing_ = std::thread([this] { run(); });
  }

  void stop() override {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    if (playing_.joinable()) {
      playing_.join();
      queue_.setLink(LinkState::off, {});
    }
  }

  std::vector<ToolReading> take() override { return queue_.take(); }
  DeviceStatus status() const override { return queue_.status(); }
  void onNews(std::function<void()> callback) override { queue_.onNews(std::move(callback)); }

  void pause(bool isPaused) override {
    {
      const std::scoped_lock lock(mutex_);
      isPaused_ = isPaused;
    }
    changed_.notify_all();
  }
  bool isPaused() const override {
    const std::scoped_lock lock(mutex_);
    return isPaused_;
  }
  double at_s() const override {
    const std::scoped_lock lock(mutex_);
    return at_s_;
  }
  double length_s() const override {
    const std::scoped_lock lock(mutex_);
    return length_s_;
  }

 private:
  /// @return false once it is to end
  bool waitFor(double length_s) {
    std::unique_lock lock(mutex_);
    return !changed_.wait_for(lock, std::chrono::duration<double>(length_s), [this] { return ends_.load(); });
  }

  Result<std::vector<SequenceMoment>> read() {
    UntilStopped progress(ends_);
    const auto sequence = readSequence(settings_.file, progress);
    if (!sequence) return passOn(sequence.error());
    auto moments = momentsOf(*sequence);
    if (moments.empty())
      return failure(ErrorCode::noValidPose, say<"%1 holds no poses of any tool; choose a tracked recording.">(settings_.file));
    return moments;
  }

  void run() {
    std::vector<SequenceMoment> moments;
    while (!ends_) {
      auto read = this->read();
      if (read) {
        moments = std::move(*read);
        break;
      }
      if (ends_) return;
      queue_.setLink(LinkState::connecting, read.error().message);
      if (!waitFor(kTryAgain_s)) return;
    }
    if (ends_) return;
    // A single frame, and several of one moment, have no pace of their own; repeated, they come at the usual one.
    const double last_s = moments.back().time_s;
    const double period_s = moments.size() > 1 && last_s > 0.0 ? last_s / static_cast<double>(moments.size() - 1) : kFramePeriod_s;
    {
      const std::scoped_lock lock(mutex_);
      length_s_ = last_s;
    }
    queue_.setLink(LinkState::connected, say<"Playing %1.">(settings_.file));
    for (double before_s = 0.0; play(moments, before_s); before_s += last_s + std::max(period_s, 1e-3))
      if (!settings_.loops) {
        queue_.setLink(LinkState::ended, say<"The recording %1 is at its end; start it again, or let it repeat itself.">(settings_.file));
        return;
      }
  }

  /// Once through. @return false when it is to end
  bool play(const std::vector<SequenceMoment>& moments, double before_s) {
    for (const SequenceMoment& moment : moments) {
      if (!waitUntil(before_s + moment.time_s)) return false;
      {
        const std::scoped_lock lock(mutex_);
        at_s_ = moment.time_s;
      }
      for (ToolReading reading : moment.readings) {
        reading.device_s = stampOf(before_s + moment.time_s);
        reading.arrival_s = steadyNow_s();
        queue_.add(std::move(reading));
      }
    }
    return true;
  }

  /// A moment of the recording's clock, which goes on through repetitions. @return false when it is to end
  bool waitUntil(double device_s) {
    std::unique_lock lock(mutex_);
    while (!ends_) {
      const double now_s = steadyNow_s();
      const double passed_s = now_s - looked_s_.value_or(now_s);
      (isPaused_ ? paused_s_ : device_s_) += isPaused_ ? passed_s : settings_.speed * passed_s;
      looked_s_ = now_s;
      if (!isPaused_ && device_s_ >= device_s) return true;
      const double left_s = isPaused_ ? 0.1 : std::min((device_s - device_s_) / settings_.speed, 0.1);
      changed_.wait_for(lock, std::chrono::duration<double>(left_s));
    }
    return false;
  }

  /// As a tracker would stamp it that measured at this pace: its clock runs through pauses, as ours does.
  double stampOf(double device_s) const {
    const std::scoped_lock lock(mutex_);
    return device_s / settings_.speed + paused_s_;
  }

  const SequenceSettings settings_;
  ReadingQueue queue_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> ends_ = false;
  bool isPaused_ = false;
  double at_s_ = 0.0, length_s_ = 0.0;
  double device_s_ = 0.0;  ///< the recording's clock now
  double paused_s_ = 0.0;
  std::optional<double> looked_s_;
  std::thread playing_;
};

}  // namespace

std::unique_ptr<SequenceDevice> makeSequenceDevice(const SequenceSettings& settings) {
  return std::make_unique<RecordingAsTracker>(settings);
}

}  // namespace ew
