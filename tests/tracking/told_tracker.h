#pragma once

#include <algorithm>
#include <mutex>
#include <utility>

#include "ew/tracking/tracker_device.h"
#include "hand_paths.h"

namespace ew::test {

/// A tracker that says what a test tells it to, at times of the test's own.
class ToldTracker final : public TrackerDevice {
 public:
  void start() override { link(LinkState::connected); }
  void stop() override { link(LinkState::off); }
  std::vector<ToolReading> take() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(waiting_, {});
  }
  DeviceStatus status() const override {
    const std::scoped_lock lock(mutex_);
    return status_;
  }
  void onNews(std::function<void()> /*callback*/) override {}

  void link(LinkState state, Message sentence = {}) {
    const std::scoped_lock lock(mutex_);
    status_.link = state;
    status_.sentence = std::move(sentence);
  }
  void say(ToolReading reading) {
    const std::scoped_lock lock(mutex_);
    if (std::find(status_.tools.begin(), status_.tools.end(), reading.tool) == status_.tools.end()) status_.tools.push_back(reading.tool);
    waiting_.push_back(std::move(reading));
  }

 private:
  mutable std::mutex mutex_;
  DeviceStatus status_;
  std::vector<ToolReading> waiting_;
};

inline ToolReading readingOf(const std::string& tool, const FacePose& pose, double device_s, double arrival_s,
                             TrackingState state = TrackingState::live) {
  return {.tool = tool, .toolToTracker = {pose.matrix}, .state = state, .device_s = device_s, .arrival_s = arrival_s};
}

}  // namespace ew::test
